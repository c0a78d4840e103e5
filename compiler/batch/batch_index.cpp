// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/batch/batch_index.h"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/path.h"
#include "base/sha256.h"
#include "base/system.h"
#include "clip-table/vocabulary.h"
#include "frontend/lex/source_text.h"

namespace clipc {
namespace {

using Json = nlohmann::ordered_json;

constexpr Named<BatchStatus> kStatusNames[] = {{BatchStatus::kNotCompiled, "not-compiled"},
                                               {BatchStatus::kCompiled, "compiled"},
                                               {BatchStatus::kFailed, "failed"}};

Json ErrorsOf(const std::vector<Message>& errors) {
  Json list = Json::array();
  for (const Message& error : errors) {
    Json json = {{"name", error.name}, {"message", error.text}};
    if (!error.place.file.empty()) {
      json["file"] = error.place.file;
      json["line"] = error.place.line;
      json["column"] = error.place.column;
    }
    list.push_back(std::move(json));
  }
  return list;
}

Json DigestsOf(const BatchEntry& entry) {
  Json json = Json::object();
  for (std::size_t i = 0; i < entry.files.size(); ++i)
    json[entry.files[i].first] = entry.digests[i];
  return json;
}

// The text of an index, which has a line for each permutation.
class IndexText {
 public:
  explicit IndexText(ShardOfIndex shard) {
    if (shard.parts != 1)
      text_ += fmt::format("\"part\": {}, \"parts\": {}, ", shard.part, shard.parts);
    text_ += "\"shaders\": [";
  }
  void Add(const Json& shader) {
    text_ += separator_ + shader.dump(-1, ' ', false, Json::error_handler_t::replace);
    separator_ = ",\n";
  }
  std::string Finish() && { return std::move(text_) + "\n]}\n"; }

 private:
  std::string text_ = "{\"version\": 1, ";
  const char* separator_ = "\n";
};

// The index of one part, as it was read.
struct PartIndex {
  unsigned part = 0, parts = 0;
  Json shaders;
};

// A run that ended before its index leaves a journal that is younger than an index of a run before.
bool WasInterrupted(const std::string& path) {
  const auto index = system::StatusOf(path), journal = system::StatusOf(path + kJournalSuffix);
  return index && journal && journal->modified > index->modified;
}

bool IsShader(const Json& shader) {
  if (!shader.is_object() || !shader.contains("files") || !shader.contains("sha256")) return false;
  const Json &files = shader["files"], &digests = shader["sha256"];
  const auto is_text = [](const Json& json) { return json.is_string(); };
  const auto is_name = [](const Json& json) {
    return json.is_string() && !HasSlash(json.get_ref<const std::string&>());
  };
  if (!files.is_object() || !digests.is_object() || files.size() != digests.size()) return false;
  return std::all_of(files.begin(), files.end(), is_name) &&
         std::all_of(digests.begin(), digests.end(), is_text);
}

Result<PartIndex> ReadPart(const std::string& path) {
  const Result<std::string> text = ReadText(path);
  if (!text) return Problem{fmt::format("cannot read `{}`: {}", path, text.problem())};
  Json json = Json::parse(*text, nullptr, false);
  const bool is_part = json.is_object() && json.contains("version") && json["version"] == 1 &&
                       json.contains("part") && json["part"].is_number_unsigned() &&
                       json.contains("parts") && json["parts"].is_number_unsigned() &&
                       json.contains("shaders") && json["shaders"].is_array() &&
                       std::all_of(json["shaders"].begin(), json["shaders"].end(), IsShader);
  if (!is_part) {
    return Problem{
        fmt::format("`{}` is not the index of a part, which `--shard=1/4` writes", path)};
  }
  PartIndex index{json["part"], json["parts"], std::move(json["shaders"])};
  if (WasInterrupted(path)) {
    return Problem{fmt::format(
        "part {} of {} was interrupted: `{}{}` is newer than its index; run it again with --resume",
        index.part, index.parts, path, kJournalSuffix)};
  }
  return index;
}

// Whether the file has these contents.
bool Holds(const std::string& path, const std::string& digest) {
  const Result<std::string> text = ReadText(path);
  return text && Sha256(*text) == digest;
}

// Names, in place of each file of the shader, the first file that has the same contents, as one run
// does. `names` has the files of the shaders before, by their digests and extensions; they lie in
// `folder`. Returns the name of a file that is to be named and has other contents, or none.
std::string ShareFiles(const std::string& folder, Json& shader,
                       std::unordered_map<std::string, std::string>& names) {
  auto next = shader["sha256"].begin();
  for (Json& file : shader["files"]) {
    const std::string name = file, digest = *next++;
    const auto [first, is_new] = names.try_emplace(digest + std::string(ExtensionIn(name)), name);
    if (is_new && !Holds(folder + name, digest)) return name;
    file = first->second;
  }
  shader.erase("sha256");
  return {};
}

}  // namespace

std::string_view ExtensionIn(std::string_view file) {
  return file.substr(std::min(file.rfind('.'), file.size()));
}

void Describe(const ShaderGroup& group, std::size_t number, BatchEntry& entry) {
  const ProgramRequest& request = group.command.request;
  entry.source = group.source;
  entry.entry = request.first().entry;
  entry.profile = request.first().profile;
  entry.target = request.target.name();
  const std::vector<std::size_t> choices = ChoicesOf(group, number);
  for (std::size_t i = 0; i < choices.size(); ++i)
    entry.defines.emplace_back(group.axes[i].macro, group.axes[i].values[choices[i]]);
}

std::string RenderIndex(const std::vector<BatchEntry>& entries, ShardOfIndex shard) {
  IndexText index(shard);
  for (const BatchEntry& entry : entries) {
    Json json = {{"name", entry.name},
                 {"source", entry.source},
                 {"entry", entry.entry},
                 {"profile", entry.profile},
                 {"target", entry.target},
                 {"defines", Json::object()},
                 {"status", NameIn<kStatusNames>(entry.status)},
                 {"files", Json::object()}};
    for (const auto& [macro, value] : entry.defines)
      json["defines"][macro] = value ? Json(*value) : Json();
    for (const auto& [kind, file] : entry.files) json["files"][kind] = file;
    if (shard.parts != 1) json["sha256"] = DigestsOf(entry);
    if (entry.errors) json["errors"] = ErrorsOf(*entry.errors);
    index.Add(json);
  }
  return std::move(index).Finish();
}

Result<std::string> MergeIndexes(const std::vector<std::string>& paths) {
  std::map<unsigned, Json> by_part;
  unsigned parts = 0;
  for (const std::string& path : paths) {
    Result<PartIndex> index = ReadPart(path);
    if (!index) return Problem{index.problem()};
    if (parts != 0 && index->parts != parts) {
      return Problem{
          fmt::format("`{}` is of {} parts, and `{}` of {}", path, index->parts, paths[0], parts)};
    }
    parts = index->parts;
    if (path.substr(0, NameBegin(path)) != paths[0].substr(0, NameBegin(paths[0]))) {
      return Problem{
          fmt::format("`{}` and `{}` lie in two folders; an index names files beside it, so "
                      "copy all outputs into one folder first",
                      paths[0], path)};
    }
    if (!by_part.emplace(index->part, std::move(index->shaders)).second)
      return Problem{fmt::format("part {} of {} is given twice", index->part, parts)};
  }
  for (unsigned part = 1; part <= parts; ++part) {
    if (!by_part.contains(part))
      return Problem{fmt::format("the index of part {} of {} is missing", part, parts)};
  }
  const std::string folder = paths[0].substr(0, NameBegin(paths[0]));
  // The parts take the permutations in turn.
  IndexText text({});
  std::unordered_map<std::string, std::string> names;
  for (std::size_t row = 0; row < by_part[1].size(); ++row) {
    for (unsigned part = 1; part <= parts && row < by_part[part].size(); ++part) {
      const std::string other = ShareFiles(folder, by_part[part][row], names);
      if (!other.empty()) {
        return Problem{fmt::format(
            "`{}{}` is not what part {} of {} wrote; copy its outputs again, or run it again",
            folder, other, part, parts)};
      }
      text.Add(by_part[part][row]);
    }
  }
  return std::move(text).Finish();
}

std::vector<std::string> RuleTargets(const CommandLine& command, std::span<const OutputPiece> ends,
                                     const std::vector<BatchEntry>& entries) {
  if (!command.dependency_target.empty()) return {command.dependency_target};
  const std::string& first = ends.front().path;
  if (!command.effect) return {first};
  std::vector<std::string> targets;
  for (const OutputPiece& file : ends) targets.push_back(file.path);
  std::set<std::string> written;
  for (const BatchEntry& entry : entries) {
    for (const auto& [kind, name] : entry.files) {
      if (written.insert(name).second) targets.push_back(first.substr(0, NameBegin(first)) + name);
    }
  }
  return targets;
}

}  // namespace clipc
