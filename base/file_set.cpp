// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "base/file_set.h"

#include <filesystem>

#include "base/system.h"

namespace clipc {

// The path without `.` and `..`: t.json for ./t.json. Most paths have none.
std::string FileSet::Normal(const std::string& path) {
  const auto has = [&](const char* part) { return path.find(part) != path.npos; };
  if (!path.starts_with('.') && !has("/.") && !has("//") && !has("\\")) return path;
  return std::filesystem::path(path).lexically_normal().generic_string();
}

void FileSet::Add(const std::string& path) {
  paths_.insert(Normal(path));
  if (const auto status = system::StatusOf(path)) files_.insert(status->identity);
}

bool FileSet::Has(const std::string& path) const {
  if (paths_.contains(Normal(path))) return true;
  if (files_.empty()) return false;
  const auto status = system::StatusOf(path);
  return status && files_.contains(status->identity);
}

bool IsDirectory(const std::string& path) {
  const auto status = system::StatusOf(path);
  return status && status->kind == system::FileKind::kFolder;
}

}  // namespace clipc
