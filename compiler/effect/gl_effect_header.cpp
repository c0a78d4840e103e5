// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/effect/gl_effect_header.h"

#include <algorithm>
#include <bit>
#include <cctype>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "base/spelling.h"

namespace clipc {
namespace {

std::string Quoted(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    // `??` may begin a trigraph.
    const bool is_plain = c >= 0x20 && c < 0x7F && c != '"' && c != '\\' && c != '?';
    quoted += is_plain ? std::string(1, c) : fmt::format("\\{:03o}", static_cast<unsigned char>(c));
  }
  return quoted + '"';
}

// A shader as string literals, one for each line.
std::string Literals(std::string_view glsl) {
  if (glsl.empty()) return "0";
  std::string text;
  while (!glsl.empty()) {
    const std::string_view line = glsl.substr(0, glsl.find('\n'));
    text += fmt::format("\n        {}", Quoted(std::string(line) + '\n'));
    glsl.remove_prefix(std::min(line.size() + 1, glsl.size()));
  }
  return text;
}

std::string FloatText(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_not_of("-0123456789") == std::string::npos) text += ".0";
  return text + 'f';
}

std::string RangeText(const GlRange& range) {
  return fmt::format("{}, {}", range.first, range.count);
}

std::string RowOf(const GlEffect::Technique& row) {
  return fmt::format("{}, {}, {}", Quoted(row.name), RangeText(row.passes),
                     RangeText(row.annotations));
}
std::string RowOf(const GlEffect::Pass& row) {
  return fmt::format("{}, {}, {}, {}", Quoted(row.name), row.program, RangeText(row.states),
                     RangeText(row.annotations));
}
std::string RowOf(const GlState& row) {
  return fmt::format("CLIPC_GL_{}, 0x{:X}u", NameOf(row.kind), row.value);
}
// "front.compareOp" is CLIPC_VK_FRONT_COMPARE_OP, and "colorWriteMask[0]" is
// CLIPC_VK_COLOR_WRITE_MASK_0.
std::string RowOf(const VulkanState& row) {
  std::string name;
  for (const char c : row.member) {
    if (std::isupper(static_cast<unsigned char>(c)) != 0) name += '_';
    if (c != ']') name += c == '.' || c == '[' ? '_' : c;
  }
  const auto* const number = std::get_if<float>(&row.value);
  return fmt::format(
      "CLIPC_VK_{}, 0x{:X}u", ToUpper(name),
      number ? std::bit_cast<std::uint32_t>(*number) : std::get<std::uint32_t>(row.value));
}
std::string RowOf(const GlEffect::Program& row) {
  const auto& shaders = row.code->shaders;
  return fmt::format("{}, {}, {}, {}, {}, {}", Literals(shaders.front().text),
                     Literals(shaders.size() > 1 ? shaders[1].text : ""), RangeText(row.uses),
                     RangeText(row.samplers), RangeText(row.planes),
                     row.code->facts.planes ? row.code->facts.planes->clip_distance_mask : 0);
}
std::string RowOf(const GlEffect::Use& row) {
  return fmt::format("{}, {}", Quoted(row.name), row.block);
}
std::string RowOf(const GlEffect::Sampler& row) {
  return fmt::format("{}, {}, {}", Quoted(row.name), row.texture, row.sampling);
}
std::string RowOf(const GlEffect::Plane& row) {
  return fmt::format("{}, {}", row.index, Quoted(row.text));
}
std::string RowOf(const GlEffect::Texture& row) {
  return fmt::format("{}, 0x{:X}u, {}", Quoted(row.name), row.target, RangeText(row.annotations));
}
std::string RowOf(const GlSampling& row) {
  return fmt::format(
      "0x{:X}u, 0x{:X}u, 0x{:X}u, 0x{:X}u, 0x{:X}u, 0x{:X}u, {}, {}, {}, {}, "
      "{{{}, {}, {}, {}}}",
      row.min_filter, row.mag_filter, row.wrap[0], row.wrap[1], row.wrap[2], row.compare_func,
      FloatText(row.max_anisotropy), FloatText(row.min_lod), FloatText(row.max_lod),
      FloatText(row.lod_bias), FloatText(row.border[0]), FloatText(row.border[1]),
      FloatText(row.border[2]), FloatText(row.border[3]));
}
std::string RowOf(const GlEffect::Place& row) {
  return fmt::format("{}, {}, {}", row.block, row.offset, row.row_major ? 1 : 0);
}

std::string RowOf(const ast::Annotation& row) {
  return fmt::format("{}, {}, {}", Quoted(row.type), Quoted(row.name), Quoted(row.value));
}

class HeaderPrinter {
 public:
  explicit HeaderPrinter(std::string_view name) : name_(name) {}

  std::string Print(const GlEffect& effect) && {
    const std::string guard = "CLIPC_EFFECT_" + ToUpper(name_);
    Add("/* Made by clipc --effect. */\n#ifndef {0}\n#define {0} 1\n\n"
        "#include <clipc/effect-runtime/effect.h>\n\n",
        guard);
    for (std::size_t i = 0; i < effect.parameters.size(); ++i)
      AddValue(i, effect.parameters[i].value);
    AddList("technique", effect.techniques);
    AddList("pass", effect.passes);
    AddList("state", effect.states);
    AddList("program", effect.programs);
    AddList("use", effect.uses);
    AddList("sampler", effect.samplers);
    AddList("plane", effect.planes);
    AddList("texture", effect.textures);
    AddList("sampling", effect.samplings);
    AddParameters(effect.parameters);
    AddBlockSizes(effect.block_sizes);
    const std::string lists = std::exchange(lists_, {});
    AddList("annotation", effect.annotations);
    const std::string annotations = std::exchange(lists_, {});
    AddVulkanStates(effect);
    Add("static const clipc_gl_effect_table {} = {{\n    {}\n    {}, {}, {}, {}, {}, "
        "{},\n    {} {},\n    {} {}}};\n\n#endif\n",
        name_, lists, effect.techniques.size(), effect.programs.size(), effect.textures.size(),
        effect.samplings.size(), effect.parameters.size(), effect.block_sizes.size(), annotations,
        effect.annotations.size(), lists_, effect.vulkan_states.empty() ? 0 : effect.passes.size());
    return std::move(text_);
  }

 private:
  template <typename... Args>
  void Add(fmt::format_string<const Args&...> format, const Args&... args) {
    fmt::format_to(std::back_inserter(text_), format, args...);
  }

  // Adds an array to the list of the table's members.
  void Name(bool is_there, std::string_view array) {
    if (!lists_.empty()) lists_ += ' ';
    lists_ += is_there ? fmt::format("{}_{},", name_, array) : "0,";
  }

  template <typename Row>
  static std::vector<std::string> RowsOf(const std::vector<Row>& rows) {
    std::vector<std::string> texts;
    for (const Row& row : rows) texts.push_back(RowOf(row));
    return texts;
  }
  template <typename Row>
  void AddList(std::string_view kind, const std::vector<Row>& rows) {
    AddRows(fmt::format("clipc_gl_effect_{}", kind), kind, RowsOf(rows));
  }

  void AddRows(std::string_view type, std::string_view kind, const std::vector<std::string>& rows) {
    const std::string plural = fmt::format("{}{}", kind, kind.ends_with('s') ? "es" : "s");
    Name(!rows.empty(), plural);
    if (rows.empty()) return;
    Add("static const {} {}_{}[] = {{\n", type, name_, plural);
    for (std::size_t i = 0; i < rows.size(); ++i)
      Add("    {{{}}}{}", rows[i], i + 1 < rows.size() ? ",\n" : "};\n");
  }

  // The states for Vulkan, and the range of each pass.
  void AddVulkanStates(const GlEffect& effect) {
    AddRows("clipc_vk_effect_state", "vulkan_state", RowsOf(effect.vulkan_states));
    std::vector<std::string> ranges;
    for (const GlEffect::Pass& pass : effect.passes) ranges.push_back(RangeText(pass.vulkan));
    if (effect.vulkan_states.empty()) ranges.clear();
    AddRows("clipc_vk_effect_pass", "vulkan_pass", ranges);
  }

  void AddValue(std::size_t number, const std::vector<std::uint32_t>& words) {
    if (words.empty()) return;
    Add("static const uint32_t {}_value_{}[] = {{", name_, number);
    for (std::size_t i = 0; i < words.size(); ++i)
      Add("0x{:08X}u{}", words[i], i + 1 < words.size() ? ", " : "};\n");
  }

  void AddParameters(const std::vector<GlEffect::Parameter>& parameters) {
    std::vector<std::string> rows;
    std::vector<GlEffect::Place> places;
    for (const GlEffect::Parameter& parameter : parameters) {
      const std::string value =
          parameter.value.empty() ? "0" : fmt::format("{}_value_{}", name_, rows.size());
      rows.push_back(fmt::format("{}, {}, {}, {}, {}, {}, {}, {}, {}, {}", Quoted(parameter.name),
                                 Quoted(parameter.semantic), parameter.rows, parameter.columns,
                                 parameter.elements, places.size(), parameter.places.size(), value,
                                 parameter.value.size(), RangeText(parameter.annotations)));
      places.insert(places.end(), parameter.places.begin(), parameter.places.end());
    }
    AddRows("clipc_gl_effect_parameter", "parameter", rows);
    AddList("place", places);
  }

  void AddBlockSizes(const std::vector<std::uint32_t>& sizes) {
    Name(!sizes.empty(), "block_sizes");
    if (sizes.empty()) return;
    Add("static const uint32_t {}_block_sizes[] = {{", name_);
    for (std::size_t i = 0; i < sizes.size(); ++i)
      Add("{}{}", sizes[i], i + 1 < sizes.size() ? ", " : "};\n");
  }

  const std::string name_;
  std::string text_;
  std::string lists_;  // the arrays that the table names, each with a comma after it
};

}  // namespace

std::string GlEffectHeader(const GlEffect& effect, std::string_view name) {
  return HeaderPrinter(name).Print(effect);
}

std::string GlEffectName(std::string_view file) {
  std::string name(file.substr(0, file.rfind('.')));
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  if (!name.empty() && std::isdigit(static_cast<unsigned char>(name[0])) != 0) name = '_' + name;
  return name + "_effect";
}

}  // namespace clipc
