// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/batch/manifest.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/path.h"
#include "compiler/command/options.h"
#include "compiler/command/place_outputs.h"
#include "compiler/compile/suggest.h"
#include "frontend/lex/source_text.h"

namespace clipc {
namespace {

using Json = nlohmann::ordered_json;
using Texts = std::vector<std::string>;

// Thrown at the first mistake of a manifest, with what it is.
struct Mistake {
  std::string what;
};

[[noreturn]] void Refuse(std::string_view where, std::string_view what) {
  throw Mistake{fmt::format("{}: {}", where, what)};
}

// The members of an object, each of which must be known.
void CheckMembers(const Json& object, const std::string& where,
                  std::span<const std::string_view> known) {
  if (!object.is_object()) Refuse(where, "is not an object");
  for (const auto& [name, value] : object.items()) {
    if (std::ranges::find(known, name) == known.end())
      Refuse(where, fmt::format("`{}` is not a member of it{}", name, Suggest(name, known)));
  }
}

// A text or a list of texts; empty where there is no such member.
Texts TextsIn(const Json& object, const char* name, const std::string& where) {
  const auto found = object.find(name);
  if (found == object.end()) return {};
  const std::string here = fmt::format("{}.{}", where, name);
  if (found->is_string()) return {found->get<std::string>()};
  if (!found->is_array()) Refuse(here, "is not a text, nor a list of texts");
  Texts texts;
  for (const Json& element : *found) {
    if (!element.is_string()) Refuse(here, "has an element that is not a text");
    texts.push_back(element.get<std::string>());
  }
  return texts;
}

// Texts of which one is chosen for each shader.
Texts ChoicesIn(const Json& object, const char* name, const std::string& where) {
  Texts choices = TextsIn(object, name, where);
  if (choices.empty() && object.contains(name))
    Refuse(fmt::format("{}.{}", where, name), "is a list of nothing to choose from");
  return choices;
}

std::optional<std::string> MacroValue(const Json& value, const std::string& where) {
  if (value.is_null()) return std::nullopt;
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "1" : "0";
  if (value.is_number()) return value.dump();
  Refuse(where, "a macro's value is a text, a number, true, false or null, or a list of these");
}

std::vector<MacroAxis> AxesIn(const Json& shader, const std::string& where) {
  std::vector<MacroAxis> axes;
  const auto defines = shader.find("defines");
  if (defines == shader.end()) return axes;
  if (!defines->is_object()) Refuse(where + ".defines", "is not an object");
  for (const auto& [name, value] : defines->items()) {
    const std::string here = fmt::format("{}.defines.{}", where, name);
    MacroAxis& axis = axes.emplace_back(MacroAxis{name, {}});
    if (name.empty() || name.find_first_of("=\r\n") != std::string::npos)
      Refuse(here, "is not the name of a macro");
    if (value.is_array()) {
      for (const Json& element : value) axis.values.push_back(MacroValue(element, here));
    } else {
      axis.values.push_back(MacroValue(value, here));
    }
    if (axis.values.empty()) Refuse(here, "has no value");
  }
  return axes;
}

// The value of --variants, as words of the command line.
Texts VariantsIn(const Json& shader, const std::string& where) {
  const auto found = shader.find("variants");
  if (found == shader.end() || *found == false) return {};
  if (*found == true) return {"--variants"};
  if (!found->is_number_unsigned()) Refuse(where + ".variants", "is not true, nor a number");
  return {fmt::format("--variants={}", found->get<unsigned>())};
}

// A member whose value, or each of a list of values by turns, an option gets.
struct OptionMember {
  const char *member, *option;
  const char* output = "";  // the option that names the file of the shader that this adds
};
constexpr OptionMember kOptionMembers[] = {
    {"entry", "-E"},
    {"profile", "-T"},
    {"target", "--target"},
    {"hullEntry", "--hull-entry", "--hull-output=.tesc"},
    {"domainEntry", "--domain-entry", "--domain-output=.tese"},
    {"geometryEntry", "--geometry-entry", "--geometry-output=.geom"},
    {"pixelShader", "--pixel-shader", "--pixel-output=.frag"},
    {"pixelEntry", "--pixel-entry", "--pixel-output=.frag"}};

class ManifestReader {
 public:
  explicit ManifestReader(std::span<const char* const> arguments)
      : arguments_(arguments.begin(), arguments.end()),
        whole_(ParseCommandLine(arguments).command) {}

  std::vector<ShaderGroup> Read(const Json& manifest) {
    constexpr std::string_view kMembers[] = {"version", "options", "shaders"};
    CheckMembers(manifest, "the manifest", kMembers);
    if (manifest.value("version", Json()) != 1) Refuse("version", "is not 1");
    for (const std::string& option : TextsIn(manifest, "options", "the manifest"))
      arguments_.push_back(option);
    const auto shaders = manifest.find("shaders");
    if (shaders == manifest.end() || !shaders->is_array() || shaders->empty())
      Refuse("shaders", "is not a list of shaders");
    for (std::size_t i = 0; i < shaders->size(); ++i)
      ReadShader((*shaders)[i], fmt::format("shaders[{}]", i));
    return std::move(groups_);
  }

 private:
  void ReadShader(const Json& shader, const std::string& where) {
    std::vector<std::string_view> members = {"source", "name", "defines", "options", "variants"};
    for (const OptionMember& option : kOptionMembers) members.push_back(option.member);
    CheckMembers(shader, where, members);
    const Texts sources = ChoicesIn(shader, "source", where);
    if (sources.empty()) Refuse(where, "has no `source`");
    const Texts names = ChoicesIn(shader, "name", where);
    if (names.size() > 1 || (names.size() == 1 && sources.size() > 1))
      Refuse(where + ".name", "is not one text for one source");
    if (!names.empty() && (names[0].empty() || HasSlash(names[0])))
      Refuse(where + ".name", "is not the name of a file");
    Texts words;
    // The options may name the file of another shader otherwise.
    for (const OptionMember& option : kOptionMembers) {
      if (*option.output != '\0' && shader.contains(option.member))
        words.emplace_back(option.output);
    }
    for (std::string& word : TextsIn(shader, "options", where)) words.push_back(std::move(word));
    for (std::string& word : VariantsIn(shader, where)) words.push_back(std::move(word));
    for (const std::string& source : sources) {
      if (source.empty() || source == "-" || EndsWithSlash(source))
        Refuse(where + ".source", "is not the name of a file");
      ShaderGroup group;
      group.source = source;
      group.name = !names.empty() ? names[0] : WithoutExtension(source.substr(NameBegin(source)));
      group.axes = AxesIn(shader, where);
      Choose(shader, where, words, std::move(group), 0);
    }
  }

  // Chooses the values of kOptionMembers by turns. A name says which where there are several.
  void Choose(const Json& shader, const std::string& where, const Texts& words, ShaderGroup group,
              std::size_t at) {
    if (at == std::size(kOptionMembers)) return Add(where, words, std::move(group));
    const auto& [member, option, output] = kOptionMembers[at];
    const Texts values = ChoicesIn(shader, member, where);
    if (values.empty()) return Choose(shader, where, words, std::move(group), at + 1);
    for (const std::string& value : values) {
      Texts more = words;
      more.insert(more.end(), {option, value});
      ShaderGroup chosen = group;
      if (values.size() > 1) chosen.name += '.' + AsFileName(value);
      Choose(shader, where, more, std::move(chosen), at + 1);
    }
  }

  void Add(const std::string& where, const Texts& words, ShaderGroup group) {
    if (groups_.size() == kMaxPermutations) Refuse("shaders", "has too many shaders");
    Texts all = arguments_;
    all.insert(all.end(), words.begin(), words.end());
    std::vector<const char*> pointers;
    for (const std::string& word : all) pointers.push_back(word.c_str());
    ParsedCommandLine parsed = ParseCommandLine(pointers);
    if (!parsed.result) Refuse(where, parsed.result.problem());
    if (!IsOfOneShader(parsed.command))
      Refuse(where, "an option is about the whole run; it stands on the command line");
    if (!parsed.command.inputs.empty())
      Refuse(where, fmt::format("`{}` is not an option; the manifest names the shaders",
                                parsed.command.inputs[0]));
    group.command = std::move(parsed.command);
    std::vector<std::string>& defines = group.command.request.defines;
    std::vector<MacroAxis> first = TakeAxes(defines);
    // What the shader's own `defines` say holds, `null` too.
    std::erase_if(defines, [&](const std::string& define) {
      const std::string_view macro = std::string_view(define).substr(0, define.find('='));
      return std::ranges::find(group.axes, macro, &MacroAxis::macro) != group.axes.end();
    });
    group.axes.insert(group.axes.begin(), first.begin(), first.end());
    groups_.push_back(std::move(group));
  }

  // Whether what holds for the whole run is as on the command line.
  bool IsOfOneShader(const CommandLine& command) const {
    const auto run = [](const CommandLine& c) {
      return std::tie(c.action, c.output, c.batch, c.index, c.shard, c.shards, c.jobs, c.keep_going,
                      c.watch, c.format, c.messages, c.write_dependencies, c.dependency_file,
                      c.dependency_target);
    };
    return run(command) == run(whole_);
  }

  Texts arguments_;
  CommandLine whole_;
  std::vector<ShaderGroup> groups_;
};

}  // namespace

Result<std::vector<ShaderGroup>> ReadManifest(const std::string& path,
                                              std::span<const char* const> arguments) {
  const Result<std::string> text = ReadText(path);
  if (!text) return Problem{fmt::format("cannot read the manifest `{}`: {}", path, text.problem())};
  return ParseManifest(path, *text, arguments);
}

Result<std::vector<ShaderGroup>> ParseManifest(const std::string& path, const std::string& text,
                                               std::span<const char* const> arguments) {
  try {
    return ManifestReader(arguments).Read(Json::parse(text));
  } catch (const Json::parse_error& problem) {
    // "[json.exception.parse_error.101] parse error at line 3, column 5: ..."
    std::string_view what = problem.what();
    if (const std::size_t end = what.find("] "); end != std::string_view::npos)
      what.remove_prefix(end + 2);
    return Problem{fmt::format("the manifest `{}` is not JSON: {}", path, what)};
  } catch (const Json::exception& problem) {
    return Problem{fmt::format("the manifest `{}`: {}", path, problem.what())};
  } catch (const Mistake& mistake) {
    return Problem{fmt::format("the manifest `{}`: {}", path, mistake.what)};
  }
}

}  // namespace clipc
