// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "../clip-table/static_table.h"
#include "../clip-table/vocabulary.h"
#include "status.h"

/// The clip table of a shader as an application reads it: the constants that hold its clip planes,
/// and the mask to enable. Reading a table allocates, so it is for the time when a shader is
/// loaded, not for each draw. A Table is a value: reading two tables on two threads, or one Table
/// from many threads, needs no lock.
namespace clipc::runtime {

/// The words of the clip table: how a shader was lowered, and the space in which PlaneConstantFor
/// makes the constants of its planes.
using clipc::kMaxClipPlanes;
using clipc::Lowering;
using clipc::NameOf;
using clipc::PlaneSpace;

/// The place of one plane among the application's constants: 16 bytes, four floats, in the table's
/// plane space.
struct TablePlane {
  std::string text;  ///< the operand of [clipplanes] as written; empty in the binary form
  /// False: the plane is composed of several constants, and the members below are empty. Always
  /// true under kLevel9.
  bool in_register = true;
  std::string cbuffer;                ///< the buffer's name in the HLSL
  std::uint32_t register_number = 0;  ///< n of b<n>
  std::uint32_t register_space = 0;
  std::uint32_t byte_offset = 0;  ///< of the four floats in that buffer
  std::string glsl_block;         ///< the uniform block in the GLSL; empty for a plain uniform
  std::string glsl_member;        ///< the member or uniform; empty if the shader does not read it
};

struct Table {
  std::string entry;
  std::string profile;
  Lowering lowering = Lowering::kLevel9;
  PlaneSpace plane_space = PlaneSpace::kClip;
  std::uint32_t enable_mask = 0;   ///< (1 << planes.size()) - 1, or 0 if the device clips nothing
  std::vector<TablePlane> planes;  ///< at most kMaxClipPlanes; planes[i] is clip plane i
};

/// Reads the JSON or the binary block that `clipc --table` writes, recognised by the first bytes.
/// Also reads a DXBC container, a shader that fxc compiled, whose SHDR or SHEX chunk contains such
/// a block. Errors: kDamagedTable with the mistake and its place; kInvalidArgument; kOutOfMemory.
Result<Table> ReadTable(const void* bytes, std::size_t size) noexcept;

/// The table of a generated header that the application was compiled with.
Result<Table> ReadTable(const StaticClipTable& table) noexcept;

}  // namespace clipc::runtime
