// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <string_view>

#include "clip-table/clip_table.h"

namespace clipc::clip_table {

// The table for people and build tools, as docs/clip-table.schema.json says. Ends in a newline.
// Text that is no UTF-8 has its wrong bytes replaced by U+FFFD.
Result<std::string> WriteJson(const ClipTable& table);

// Direct3D's own record: the shader model 4 token stream's custom-data block of class
// D3D11_SB_CUSTOMDATA_SHADER_CLIP_PLANE_CONSTANT_MAPPINGS_FOR_DX9 (d3d12TokenizedProgramFormat.hpp,
// "Shader Clip Plane Constant Mappings for DX9 hardware"). Little-endian:
//
//   DWORD 0x35 | 5 << 11      DWORD 3 + 2n, the block's length in DWORDs      DWORD n, the number of planes
//   n times: WORD constant buffer   WORD first float4 register   WORD number of registers, 1   WORD reserved, 0
//
// It holds Direct3DPart(table) and no more. An error when a plane is not one whole register, lies
// in a register space other than 0, or does not fit a WORD.
Result<std::string> WriteBinary(const ClipTable& table);

// What the binary form keeps of a table: the planes' registers. Names are empty and the lowering is
// kLevel9, which the record is for.
ClipTable Direct3DPart(const ClipTable& table);

// C++17, self-contained: `inline constexpr clipc::StaticClipTable <name>` for clipc::runtime, or
// for no library at all. Several such headers may meet in one program when the names differ. `name`
// must be an identifier.
Result<std::string> WriteHeader(const ClipTable& table, std::string_view name);

// "water.clip.h" => "water_clip_table": a name for WriteHeader from the path of the file it goes
// to.
std::string HeaderNameOf(std::string_view path);

// WriteJson, WriteBinary or WriteHeader (named after the path).
Result<std::string> Write(const ClipTable& table, Format format, std::string_view path);

}  // namespace clipc::clip_table
