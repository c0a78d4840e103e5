// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "backend-glsl/style.h"
#include "backend-glsl/target.h"
#include "ir/packing.h"
#include "ir/program.h"

// The layout in GLSL of a constant buffer, whose offsets Direct3D's rules fixed. Offsets are never
// changed: a buffer that std140 would lay out otherwise is written with explicit offsets or with
// padding; members that std140 cannot place are left out if the shader does not read them, else
// read by hand. Sources: HLSL packing as in ir/packing.h; std140 in section 7.6.2.2 of the OpenGL
// 4.6 specification.
//
// A block that std140 can lay out keeps the members that the shader does not read, since the next
// stage may declare the block too. Only one of more than 16 KB, which is all that OpenGL promises,
// ends after the last member that is read, if that brings it within 16 KB.
namespace clipc::glsl {

inline constexpr std::uint32_t kRow = 16;  // bytes of a register of a cbuffer, and of std140's vec4

enum class BlockForm : std::uint8_t {
  kStd140,  // members as written; some with an explicit offset or padding before them, or by hand
  kRows,    // one array of rows of 16 bytes, and accessors. Where the target has no blocks, members
            // that are not of floats are uniform variables beside it
  kUniforms,  // the target has no blocks: uniform variables that the host sets by name
};

// The form of what a block declares at one place.
enum class PartForm : std::uint8_t {
  kWhole,  // a member of HLSL
  kWords,  // each component of a vector, which a function puts together
  kRows,   // an array of rows of 16 bytes, out of which functions read one member or several
};

// A member of a buffer or, if a ConstantBuffer<T> is written with an instance name, a field of T.
struct BlockMember {
  ir::VarId var;   // the member; of a ConstantBuffer<T> the whole
  int field = -1;  // of a ConstantBuffer<T>: the field of T
  ir::TypeId type;
  bool row_major = false;        // as in HLSL
  std::uint32_t offset = 0;      // bytes
  bool explicit_offset = false;  // layout(offset = ..)
  std::uint32_t padding = 0;     // bytes of padding members before it
  ir::MatrixLayout matrices = ir::MatrixLayout::kNone;
  PartForm form = PartForm::kWhole;
  // kRows: their number, and whether they are `vec4`, since all is floats that they hold; else
  // `uvec4`. `var` is the first of the members in them, and `offset` that of the rows.
  std::uint32_t rows = 0;
  bool float_rows = true;
  // kRows: the variable in the program that they are; kWords: the first component, which the
  // others follow (packed_blocks.h).
  ir::VarId memory = {};
};
// Calls visit(first byte, rows) for each of the paddings before a member, which are so many rows or
// one float: floats up to a row, rows, and floats again. std140 moves none of them.
template <typename OnPadding>
void ForEachPadding(const BlockMember& member, OnPadding&& visit) {
  for (std::uint32_t begin = member.offset - member.padding; begin < member.offset;) {
    const std::uint32_t rows = begin % kRow == 0 ? (member.offset - begin) / kRow : 0;
    visit(begin, rows);
    begin += rows > 0 ? rows * kRow : 4;
  }
}
// A member of a buffer that is read by hand.
struct ByHand {
  ir::VarId var;
  std::uint32_t offset = 0;  // bytes
  std::size_t part = 0;      // in BlockLayout::members
};

struct BlockLayout {
  BlockForm form = BlockForm::kStd140;
  // The layout of the whole block, if the block is plain or another stage declares it so, and its
  // members agree; otherwise kNone, and each member has its own.
  ir::MatrixLayout matrices = ir::MatrixLayout::kNone;
  bool has_instance = false;  // kStd140: members are read as `instance.member`
  bool has_uints = false;     // bools and their vectors are uints, as SPIR-V has them in blocks
  bool float_rows = true;     // kRows: `vec4`, since every member is of floats; else `uvec4`
  bool fields_as_members = false;    // `buffer.field`: a ConstantBuffer<T> with an instance name
  std::vector<BlockMember> members;  // in order of offset (kUniforms: of declaration)
  std::vector<ByHand> by_hand;       // kStd140: in order of offset
  ir::VarId memory = {};  // kRows: the variable that the rows are; of an array of buffers, these

  bool IsByHand(ir::VarId var) const {
    return std::ranges::find(by_hand, var, &ByHand::var) != by_hand.end();
  }
};

// `is_read` says by VarId which members the shader reads.
BlockLayout LayOutBlock(const ir::Program& program, const ir::Cbuffer& cbuffer,
                        const Target& target, BlockStyle style, const std::vector<bool>& is_read);

// Whether a type has floats only, which are all that rows hold where the target has no blocks.
bool OnlyFloats(const ir::TypeTable& types, ir::TypeId type);

}  // namespace clipc::glsl
