// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/batch/batch_index.h"

#include <map>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/path.h"
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

}  // namespace

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
    if (entry.errors) json["errors"] = ErrorsOf(*entry.errors);
    index.Add(json);
  }
  return std::move(index).Finish();
}

Result<std::string> MergeIndexes(const std::vector<std::string>& paths) {
  std::map<unsigned, Json> by_part;
  unsigned parts = 0;
  for (const std::string& path : paths) {
    const Result<std::string> text = ReadText(path);
    if (!text) return Problem{fmt::format("cannot read `{}`: {}", path, text.problem())};
    Json json = Json::parse(*text, nullptr, false);
    const bool is_part = json.is_object() && json.value("version", 0) == 1 &&
                         json.contains("part") && json["part"].is_number_unsigned() &&
                         json.contains("parts") && json["parts"].is_number_unsigned() &&
                         json.contains("shaders") && json["shaders"].is_array();
    if (!is_part) {
      return Problem{
          fmt::format("`{}` is not the index of a part, which `--shard=1/4` writes", path)};
    }
    const unsigned part = json["part"], of = json["parts"];
    if (parts != 0 && of != parts) {
      return Problem{fmt::format("`{}` is of {} parts, and `{}` of {}", path, of, paths[0], parts)};
    }
    parts = of;
    if (path.substr(0, NameBegin(path)) != paths[0].substr(0, NameBegin(paths[0]))) {
      return Problem{
          fmt::format("`{}` and `{}` lie in two folders; an index names files beside it, so "
                      "copy all outputs into one folder first",
                      paths[0], path)};
    }
    if (!by_part.emplace(part, std::move(json["shaders"])).second)
      return Problem{fmt::format("part {} of {} is given twice", part, parts)};
  }
  for (unsigned part = 1; part <= parts; ++part) {
    if (!by_part.contains(part))
      return Problem{fmt::format("the index of part {} of {} is missing", part, parts)};
  }
  // The parts take the permutations in turn.
  IndexText index({});
  for (std::size_t row = 0; row < by_part[1].size(); ++row) {
    for (unsigned part = 1; part <= parts && row < by_part[part].size(); ++part)
      index.Add(by_part[part][row]);
  }
  return std::move(index).Finish();
}

}  // namespace clipc
