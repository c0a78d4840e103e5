// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/batch_index.h"

#include <nlohmann/json.hpp>

#include "clip-table/vocabulary.h"

namespace clipc {
namespace {

using Json = nlohmann::ordered_json;

constexpr Named<BatchStatus> kStatusNames[] = {{BatchStatus::kNotCompiled, "not-compiled"},
                                               {BatchStatus::kCompiled, "compiled"},
                                               {BatchStatus::kFailed, "failed"}};

}  // namespace

void Describe(const ShaderGroup& group, std::size_t number, BatchEntry& entry) {
  const CompileRequest& request = group.command.request;
  entry.source = group.source;
  entry.entry = request.language.entry;
  entry.profile = request.language.profile;
  entry.target = request.target.name();
  const std::vector<std::size_t> choices = ChoicesOf(group, number);
  for (std::size_t i = 0; i < choices.size(); ++i)
    entry.defines.emplace_back(group.axes[i].macro, group.axes[i].values[choices[i]]);
}

std::string RenderIndex(const std::vector<BatchEntry>& entries) {
  // The index has a line for each setting.
  std::string text = "{\"version\": 1, \"shaders\": [";
  const char* separator = "\n";
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
    text += separator + json.dump(-1, ' ', false, Json::error_handler_t::replace);
    separator = ",\n";
  }
  return text + "\n]}\n";
}

}  // namespace clipc
