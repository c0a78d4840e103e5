// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <string_view>

// Paths as text. On Windows a backslash is a slash too, and a path may begin with a drive, "C:".
namespace clipc {

#ifdef _WIN32
inline constexpr bool kHasDrives = true;
inline constexpr std::string_view kSlashes = "/\\";
#else
inline constexpr bool kHasDrives = false;
inline constexpr std::string_view kSlashes = "/";
#endif

constexpr bool HasSlash(std::string_view path) {
  return path.find_first_of(kSlashes) != std::string_view::npos;
}

constexpr bool EndsWithSlash(std::string_view path) {
  return !path.empty() && HasSlash(path.substr(path.size() - 1));
}

constexpr bool HasDrive(std::string_view path) {
  return kHasDrives && path.size() > 1 && path[1] == ':';
}

constexpr bool IsAbsolute(std::string_view path) {
  return HasDrive(path) || (!path.empty() && HasSlash(path.substr(0, 1)));
}

// The index at which the file's name begins: after the last slash, or after the drive.
constexpr std::size_t NameBegin(std::string_view path) {
  const std::size_t after_slash = path.find_last_of(kSlashes) + 1;  // npos + 1 is 0
  return after_slash == 0 && HasDrive(path) ? 2 : after_slash;
}

}  // namespace clipc
