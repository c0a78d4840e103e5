// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <string_view>

#include "clip_table.h"

namespace clipc::clip_table {

/// The table for people and build tools, in the form of docs/clip-table.schema.json. Ends in a
/// newline. Bytes of a text that are not UTF-8 become U+FFFD.
Result<std::string> WriteJson(const ClipTable& table);

/// Direct3D's own record: the shader model 4 token stream's custom-data block of class
/// D3D11_SB_CUSTOMDATA_SHADER_CLIP_PLANE_CONSTANT_MAPPINGS_FOR_DX9
/// (d3d12TokenizedProgramFormat.hpp, "Shader Clip Plane Constant Mappings for DX9 hardware").
/// Little-endian:
///
///   DWORD 0x35 | 5 << 11
///   DWORD 3 + 2n, the block's length in DWORDs
///   DWORD n, the number of planes
///   n times:
///     WORD constant buffer
///     WORD first float4 register
///     WORD number of registers, 1
///     WORD reserved, 0
///
/// The block holds Direct3DPart(table) and no more. It is an error if a plane is not one whole
/// register, lies in a register space other than 0, or does not fit a WORD.
Result<std::string> WriteBinary(const ClipTable& table);

/// The part of a table that the binary form keeps: the planes' registers. Names are empty, and the
/// lowering is kLevel9, which the record is for.
ClipTable Direct3DPart(const ClipTable& table);

/// The text of a self-contained C++17 header that defines
/// `inline constexpr clipc::StaticClipTable <name>`, and of C99 that defines the JSON,
/// `static const char <name>[]`. It needs no library. Several such headers may be in one program if
/// the names differ. `name` must be an identifier.
Result<std::string> WriteHeader(const ClipTable& table, std::string_view name);

/// The name for WriteHeader that the path of the header gives: "water.clip.h" =>
/// "water_clip_table".
std::string HeaderNameOf(std::string_view path);

/// Calls WriteJson, WriteBinary, or WriteHeader with a name from `path`.
Result<std::string> Write(const ClipTable& table, Format format, std::string_view path);

}  // namespace clipc::clip_table
