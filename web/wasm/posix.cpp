// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The functions of include/posix.h, which is included first everywhere.
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

constexpr int kMaxLinks = 40;  // as Linux

// Appends `path` to `resolved`, an absolute path without links, with the links of `path` resolved.
// Returns false on an error, with the reason in errno.
bool Resolve(std::string path, std::string& resolved) {
  int links = 0;
  while (!path.empty()) {
    if (path[0] == '/') {
      path.erase(0, 1);
      continue;
    }
    const std::string name = path.substr(0, path.find('/'));
    path.erase(0, name.size());
    if (name == ".") continue;
    if (name == "..") {
      resolved.resize(resolved.empty() ? 0 : resolved.rfind('/'));
      continue;
    }
    const std::string full = resolved + "/" + name;
    struct stat status{};
    if (lstat(full.c_str(), &status) != 0) return false;
    if (!S_ISLNK(status.st_mode)) {
      resolved = full;
      continue;
    }
    char target[PATH_MAX];
    const ssize_t size = readlink(full.c_str(), target, sizeof target);
    if (size < 0) return false;
    if (++links > kMaxLinks) {
      errno = ELOOP;
      return false;
    }
    path = std::string(target, static_cast<std::size_t>(size)) + path;
    if (target[0] == '/') resolved.clear();
  }
  return true;
}

int Refuse() {
  errno = ENOSYS;
  return -1;
}

}  // namespace

// wasi-libc's <dirent.h> declares this function without saying that it is C's.
int __wasilibc_dttoif(int type) {  // NOLINT(bugprone-reserved-identifier): the library's name
  switch (type) {
    case DT_DIR: return S_IFDIR;
    case DT_REG: return S_IFREG;
    case DT_LNK: return S_IFLNK;
    case DT_CHR: return S_IFCHR;
    case DT_BLK: return S_IFBLK;
    default: return 0;
  }
}

extern "C" {

char* realpath(const char* path, char* resolved) {
  std::string result;
  if (path[0] != '/') {
    char folder[PATH_MAX];
    if (!getcwd(folder, sizeof folder)) return nullptr;
    result = std::strcmp(folder, "/") == 0 ? "" : folder;
  }
  if (!*path) errno = ENOENT;
  if (!*path || !Resolve(path, result)) return nullptr;
  if (result.empty()) result = "/";
  if (result.size() >= PATH_MAX) {
    errno = ENAMETOOLONG;
    return nullptr;
  }
  return resolved ? std::strcpy(resolved, result.c_str()) : strdup(result.c_str());
}

int chmod(const char*, mode_t) { return 0; }
int fchmod(int, mode_t) { return 0; }
int fchmodat(int, const char*, mode_t, int) { return 0; }
mode_t umask(mode_t) { return 0; }
int posix_madvise(void*, size_t, int) { return 0; }
int dup(int) { return Refuse(); }
int chown(const char*, uid_t, gid_t) { return Refuse(); }
int fchown(int, uid_t, gid_t) { return Refuse(); }

}  // extern "C"
