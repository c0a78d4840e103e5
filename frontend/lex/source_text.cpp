// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/lex/source_text.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>

#include <fmt/format.h>

#include "base/spelling.h"
#include "base/system.h"

namespace clipc {
namespace {

Result<std::string> ReadAll(int file) {
  std::string text;
  const auto status = system::StatusOf(file);
  if (!status) return Problem{ReasonOf(errno)};
  if (status->kind == system::FileKind::kFolder) return Problem{ReasonOf(EISDIR)};
  constexpr std::size_t kStep = 64 << 10;
  text.reserve(status->kind == system::FileKind::kRegular
                   ? std::min<std::uint64_t>(status->size, kMaxSourceBytes) + 1
                   : kStep);
  std::size_t size = 0;
  for (;;) {
    // One byte more than the file has, so that its end is seen without growing.
    text.resize(std::max(text.capacity(), size + 1));
    const std::ptrdiff_t got = system::Read(file, text.data() + size, text.size() - size);
    if (got < 0) return Problem{ReasonOf(errno)};
    if (got == 0) break;
    size += static_cast<std::size_t>(got);
    if (size > kMaxSourceBytes)
      return Problem{fmt::format("longer than {} MiB", kMaxSourceBytes >> 20)};
    if (size == text.size()) text.reserve(2 * size);
  }
  text.resize(size);
  return text;
}

void AppendUtf8(std::uint32_t code, std::string& text) {
  if (code < 0x80) {
    text += static_cast<char>(code);
    return;
  }
  const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
  constexpr std::uint32_t kFirst[] = {0, 0xc0, 0xe0, 0xf0};
  text += static_cast<char>(kFirst[more] | code >> 6 * more);
  for (int i = more - 1; i >= 0; --i) text += static_cast<char>(0x80 | (code >> 6 * i & 0x3f));
}

// Returns as UTF-8 the UTF-16 `bytes` after the byte order mark; a surrogate without its other half
// becomes U+FFFD.
std::string FromUtf16(std::string_view bytes, bool is_big_endian) {
  const auto unit = [&](std::size_t i) -> std::uint32_t {
    const auto first = static_cast<unsigned char>(bytes[i]);
    const auto second = static_cast<unsigned char>(bytes[i + 1]);
    return is_big_endian ? first << 8 | second : second << 8 | first;
  };
  std::string text;
  for (std::size_t i = 2; i + 1 < bytes.size(); i += 2) {
    std::uint32_t code = unit(i);
    if (code >= 0xd800 && code < 0xe000) {
      const std::uint32_t low = code < 0xdc00 && i + 3 < bytes.size() ? unit(i + 2) : 0;
      const bool is_pair = low >= 0xdc00 && low < 0xe000;
      code = is_pair ? 0x10000 + ((code - 0xd800) << 10) + (low - 0xdc00) : 0xfffd;
      if (is_pair) i += 2;
    }
    AppendUtf8(code, text);
  }
  return text;
}

// Adds DXC's predefined macros, as it documents them, to `out`. fxc, which the older shader models
// belong to, has none.
void DefineTarget(const SourceInput& input, std::string& out) {
  out += fmt::format(
      "#define __hlsl_dx_compiler 1\n"
      "#define __HLSL_VERSION {}\n"
      "#define __SHADER_TARGET_STAGE {}\n"
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
      static_cast<int>(input.language), InfoOf(input.stage).number, input.shader_model_major,
      input.shader_model_minor);
  if (input.spirv_minor) {
    out += fmt::format(
        "#define __spirv__ 1\n"
        "#define __SPIRV_MAJOR_VERSION__ 1\n"
        "#define __SPIRV_MINOR_VERSION__ {}\n",
        *input.spirv_minor);
  }
}

}  // namespace

bool IsUtf16(std::string_view text) {
  return text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff");
}

void ConvertUtf16(std::string& text) {
  if (IsUtf16(text)) text = FromUtf16(text, text.front() == '\xfe');
}

Result<std::string> ReadText(const std::string& path) {
  const bool is_stdin = path == "-";
  const int file = is_stdin ? system::kStandardInput : system::OpenToRead(path);
  if (file < 0) return Problem{ReasonOf(errno)};
  Result<std::string> text = ReadAll(file);
  if (!is_stdin) system::Close(file);
  if (text) ConvertUtf16(*text);
  return text;
}

std::string Predefines(const SourceInput& input) {
  std::string out = "#define __CLIPC__ 1\n";
  if (input.shader_model_major >= 6) DefineTarget(input, out);
  const bool has_preamble = !input.preamble.empty();
  if (input.defines.empty() && !has_preamble && input.forced_includes.empty()) return out;
  out += "# 1 \"<command line>\" 1\n";
  for (const std::string& define : input.defines) {
    const std::string line = define.substr(0, define.find_first_of("\r\n"));
    const std::size_t equals = line.find('=');
    out += equals == std::string::npos
               ? fmt::format("#define {} 1\n", line)
               : fmt::format("#define {} {}\n", line.substr(0, equals), line.substr(equals + 1));
  }
  // A backslash at the end of the preamble continues into the empty line.
  if (has_preamble)
    out += fmt::format("# 1 \"<preamble>\" 1\n{}\n\n# 1 \"<command line>\" 2\n", input.preamble);
  for (const std::string& file : input.forced_includes) {
    const std::string name = file.substr(0, file.find_first_of("\"\r\n"));
    out += fmt::format("#include \"{}\"\n", name);
  }
  return out + "# 1 \"<built-in>\" 2\n";
}

}  // namespace clipc
