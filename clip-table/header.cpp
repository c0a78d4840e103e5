// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <cctype>

#include "clip-table/json.h"
#include "clip-table/read.h"
#include "clip-table/write.h"

namespace clipc::clip_table {
namespace {

// The text of static_table.h between `clang-format off` and `on`.
constexpr std::string_view kTypes =
    R"(#ifndef CLIPC_STATIC_CLIP_TABLE
#define CLIPC_STATIC_CLIP_TABLE 1
namespace clipc {
struct StaticClipPlane {
  unsigned index;            // of the operand
  const char* text;          // the operand as written
  bool in_register;          // false: the plane is composed of several constants; the rest is empty
  const char* cbuffer;       // as written
  unsigned cbuffer_element;  // which buffer of an array of ConstantBuffers
  unsigned register_number;  // n of b<n>
  unsigned register_space;
  unsigned float4_register;  // m of cb<n>[m]
  unsigned byte_offset;      // in the buffer
  const char* glsl_block;    // empty: a plain uniform
  const char* glsl_member;   // empty: the shader does not read it
};
struct StaticClipTable {
  const char* entry;
  const char* profile;
  const char* lowering;        // "clip-distance", "level9", "none", "near-plane" or "discard"
  const char* position_space;  // "direct3d-clip", "xyw1" or "object"
  unsigned enable_mask;
  unsigned plane_count;
  StaticClipPlane planes[6];
};
}  // namespace clipc
#elif CLIPC_STATIC_CLIP_TABLE != 1
#error "clip tables of two versions of clipc in one program: write them again with one clipc"
#endif
)";

bool IsIdentifier(std::string_view name) {
  const auto is_word = [](unsigned char c) { return c < 0x80 && (std::isalnum(c) || c == '_'); };
  return !name.empty() && std::all_of(name.begin(), name.end(), is_word) &&
         !std::isdigit(static_cast<unsigned char>(name.front()));
}

// A C string literal. Octal escapes have at most three digits, so nothing that follows can join
// them; `?` is escaped because two of them may start a trigraph.
std::string Quoted(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\' || c == '?') {
      quoted += {'\\', c};
    } else if (byte < 0x20 || byte >= 0x7f) {
      for (const int shift : {6, 3, 0}) {
        if (shift == 6) quoted += '\\';
        quoted += static_cast<char>('0' + (byte >> shift & 7));
      }
    } else {
      quoted += c;
    }
  }
  return quoted + '"';
}

std::string Literal(const std::string& text) { return Quoted(text); }
std::string Literal(std::uint32_t number) { return std::to_string(number) + "u"; }

std::string Initializer(const Plane& plane) {
  const Constant constant = plane.constant.value_or(Constant{});
  std::string text = "{" + Literal(plane.index) + ", " + Literal(plane.text) +
                     (plane.constant ? ", true" : ", false");
  ForEachMember(constant, [&](const char*, const auto& value) { text += ", " + Literal(value); });
  return text + "}";
}

std::string HeaderText(const ClipTable& table, std::string_view json, std::string_view name) {
  std::string text = "// Written by clipc; changes are lost when it is written again.\n";
  text += "#pragma once\n\n#ifdef __cplusplus\n";
  text += kTypes;
  text += "\ninline constexpr clipc::StaticClipTable " + std::string(name) + " = {\n";
  const auto count = static_cast<std::uint32_t>(table.planes.size());
  text += "    " + Quoted(table.entry) + ", " + Quoted(table.profile) + ",\n";
  text += "    " + Quoted(NameOf(table.lowering)) + ", " + Quoted(TableNameOf(table.plane_space)) +
          ",\n";
  text += "    " + Literal(table.enable_mask) + ", " + Literal(count) + ",\n";
  text += "    {\n";
  for (const Plane& plane : table.planes) text += "        " + Initializer(plane) + ",\n";
  text += "    }};\n#else  // for clipc_table_read\n";
  text += "static const char " + std::string(name) + "[] =\n    " + Quoted(json) + ";\n";
  return text + "#endif\n";
}

}  // namespace

Result<std::string> WriteHeader(const ClipTable& table, std::string_view name) {
  if (!IsIdentifier(name)) {
    return Problem{"`" + std::string(name) + "` cannot name a C++ variable"};
  }
  if (std::string problem = ProblemOf(table); !problem.empty()) {
    return Problem{std::move(problem)};
  }
  // The table is converted to JSON and back, so that the header has the same, valid UTF-8 as JSON.
  const std::string json = JsonText(table, true);
  const Result<ClipTable> same = ReadJson(json);
  return HeaderText(*same, json, name);
}

std::string HeaderNameOf(std::string_view path) {
  std::string_view file = path.substr(path.find_last_of("/\\") + 1);
  file = file.substr(0, file.find('.'));
  std::string name;
  for (const char c : file) {
    const auto byte = static_cast<unsigned char>(c);
    name += byte < 0x80 && std::isalnum(byte) ? c : '_';
  }
  if (name.empty() || std::isdigit(static_cast<unsigned char>(name.front()))) name.insert(0, "_");
  // Names with a leading or a double underscore are the C++ implementation's.
  while (name.starts_with('_')) name.replace(0, 1, "table_");
  for (std::size_t at; (at = name.find("__")) != name.npos;) name.erase(at, 1);
  return name + (name.ends_with('_') ? "clip_table" : "_clip_table");
}

Result<ClipTable> FromStatic(const StaticClipTable& from) {
  const std::optional<Lowering> lowering = ParseLowering(from.lowering);
  const std::optional<PlaneSpace> space = ParseTableSpace(from.position_space);
  if (!lowering || !space)
    return Problem{"a lowering or a plane space that this clipc does not know"};
  if (from.plane_count > kMaxClipPlanes)
    return Problem{std::to_string(from.plane_count) + " planes"};
  ClipTable table{from.entry, from.profile, *lowering, *space, from.enable_mask, {}};
  for (unsigned i = 0; i < from.plane_count; ++i) {
    const StaticClipPlane& plane = from.planes[i];
    Plane& to = table.planes.emplace_back(Plane{plane.index, plane.text, std::nullopt});
    if (!plane.in_register) continue;
    to.constant = Constant{plane.cbuffer,        plane.cbuffer_element, plane.register_number,
                           plane.register_space, plane.float4_register, plane.byte_offset,
                           plane.glsl_block,     plane.glsl_member};
  }
  if (std::string problem = ProblemOf(table); !problem.empty()) return Problem{std::move(problem)};
  return table;
}

Result<std::string> Write(const ClipTable& table, Format format, std::string_view path) {
  switch (format) {
    case Format::kJson: return WriteJson(table);
    case Format::kBinary: return WriteBinary(table);
    case Format::kHeader: return WriteHeader(table, HeaderNameOf(path));
  }
  return Problem{"no such format"};
}

Result<ClipTable> Read(std::string_view bytes) {
  if (bytes.starts_with("DXBC") || bytes.starts_with(std::string_view("\x35\x28\0\0", 4))) {
    return ReadBinary(bytes);
  }
  return ReadJson(bytes);
}

}  // namespace clipc::clip_table
