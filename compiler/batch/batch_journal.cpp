// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/batch/batch_journal.h"

#include <cstddef>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/system.h"
#include "frontend/lex/source_text.h"

namespace clipc {
namespace {

using Json = nlohmann::ordered_json;

// The size and the time of a file, by which a build tells that it has changed; empty: there is no
// such file.
std::string SizeAndTimeOf(const std::string& path) {
  const auto status = system::StatusOf(path);
  return status ? fmt::format("{} {}", status->size, status->modified) : std::string();
}

}  // namespace

BatchJournal::BatchJournal(std::string path, std::string identity)
    : path_(std::move(path)), identity_(std::move(identity)) {}

BatchJournal::~BatchJournal() {
  if (file_ >= 0) system::Close(file_);
}

std::map<std::string, BatchJournal::Done> BatchJournal::Read() const {
  std::map<std::string, Done> all;
  const Result<std::string> read = ReadText(path_);
  if (!read || !read->starts_with(identity_ + '\n')) return all;
  const std::string& text = *read;
  std::map<std::string, bool> same;
  const auto is_same = [&](const std::string& path, const std::string& stamp) {
    return same.try_emplace(path, !stamp.empty() && SizeAndTimeOf(path) == stamp).first->second;
  };
  std::size_t begin = identity_.size() + 1;
  for (std::size_t end; (end = text.find('\n', begin)) != text.npos; begin = end + 1) {
    const Json json = Json::parse(text.begin() + begin, text.begin() + end, nullptr, false);
    if (!json.is_object()) break;
    try {
      Done done;
      bool is_valid = true;
      for (const auto& [path, stamp] : json.at("read").items()) {
        is_valid &= is_same(path, stamp.get<std::string>());
        done.dependencies.push_back(path);
      }
      for (const auto& [kind, name] : json.at("files").items())
        done.files.emplace_back(kind, name.get<std::string>());
      if (is_valid) all.insert_or_assign(json.at("name").get<std::string>(), std::move(done));
    } catch (const Json::exception&) {
      break;  // not a line of ours
    }
  }
  return all;
}

Result<> BatchJournal::Write(const std::string& line) {
  std::size_t done = 0;
  while (file_ >= 0 && done < line.size()) {
    const std::ptrdiff_t count = system::Write(file_, line.data() + done, line.size() - done);
    if (count <= 0) break;
    done += static_cast<std::size_t>(count);
  }
  if (done < line.size()) return Problem{fmt::format("cannot write `{}`", path_)};
  return {};
}

Result<> BatchJournal::Begin() {
  system::Remove(path_);
  file_ = system::OpenNew(path_, 0666);
  return Write(identity_ + '\n');
}

Result<> BatchJournal::Add(const std::string& name, const Done& done) {
  Json json = {{"name", name}, {"files", Json::object()}, {"read", Json::object()}};
  for (const auto& [kind, file] : done.files) json["files"][kind] = file;
  for (const std::string& path : done.dependencies) {
    const auto [stamp, is_new] = stamps_.try_emplace(path);
    if (is_new) stamp->second = SizeAndTimeOf(path);
    json["read"][path] = stamp->second;
  }
  return Write(json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n');
}

void BatchJournal::Remove() {
  if (file_ >= 0) system::Close(std::exchange(file_, -1));
  system::Remove(path_);
}

}  // namespace clipc
