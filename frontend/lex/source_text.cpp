// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/lex/source_text.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace clipc {
namespace {

std::string Reason(int error) {
  std::string reason = std::strerror(error);
  if (!reason.empty()) reason[0] = static_cast<char>(reason[0] | 0x20);
  return reason;
}

std::string ReadAll(int file, std::string& text) {
  struct stat status{};
  if (fstat(file, &status) != 0) return Reason(errno);
  if (S_ISDIR(status.st_mode)) return Reason(EISDIR);
  constexpr std::size_t kStep = 64 << 10;
  text.reserve(S_ISREG(status.st_mode) ? std::min<std::size_t>(status.st_size, kMaxSourceBytes) + 1
                                       : kStep);
  std::size_t size = 0;
  for (;;) {
    // One byte more than the file has, so that its end is seen without growing.
    text.resize(std::max(text.capacity(), size + 1));
    const ssize_t got = read(file, text.data() + size, text.size() - size);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return Reason(errno);
    if (got == 0) break;
    size += static_cast<std::size_t>(got);
    if (size > kMaxSourceBytes) return fmt::format("longer than {} MiB", kMaxSourceBytes >> 20);
    if (size == text.size()) text.reserve(2 * size);
  }
  text.resize(size);
  return {};
}

// DXC's predefined macros, as it documents them. fxc, which the older shader models belong to, has
// none.
void DefineTarget(const SourceInput& input, std::string& out) {
  out += fmt::format(
      "#define __hlsl_dx_compiler 1\n"
      "#define __HLSL_VERSION 2018\n"
      "#define __SHADER_TARGET_STAGE 1\n"
      "#define __SHADER_TARGET_MAJOR {}\n"
      "#define __SHADER_TARGET_MINOR {}\n"
      "#define __SHADER_STAGE_PIXEL 0\n"
      "#define __SHADER_STAGE_VERTEX 1\n"
      "#define __SHADER_STAGE_GEOMETRY 2\n"
      "#define __SHADER_STAGE_HULL 3\n"
      "#define __SHADER_STAGE_DOMAIN 4\n"
      "#define __SHADER_STAGE_COMPUTE 5\n"
      "#define __SHADER_STAGE_LIBRARY 6\n"
      "#define __SHADER_STAGE_MESH 13\n"
      "#define __SHADER_STAGE_AMPLIFICATION 14\n",
      input.shader_model_major, input.shader_model_minor);
}

}  // namespace

std::string ReadText(const std::string& path, std::string& text) {
  if (path == "-") return ReadAll(STDIN_FILENO, text);
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return Reason(errno);
  std::string problem = ReadAll(file, text);
  close(file);
  return problem;
}

std::string Predefines(const SourceInput& input) {
  std::string out = "#define __CLIPC__ 1\n";
  if (input.shader_model_major >= 6) DefineTarget(input, out);
  if (input.defines.empty()) return out;
  out += "# 1 \"<command line>\" 1\n";
  for (const std::string& define : input.defines) {
    const std::string line = define.substr(0, define.find_first_of("\r\n"));
    const std::size_t equals = line.find('=');
    out += equals == std::string::npos
               ? fmt::format("#define {} 1\n", line)
               : fmt::format("#define {} {}\n", line.substr(0, equals), line.substr(equals + 1));
  }
  return out + "# 1 \"<built-in>\" 2\n";
}

}  // namespace clipc
