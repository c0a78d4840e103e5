// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "backend-glsl/write.h"
#include "ir/evaluate.h"
#include "ir/program.h"
#include "tools/draw/inputs.h"

// The layout of values in constant buffers and structured buffers, by HLSL's rules; it shares
// nothing with the GLSL writer.
namespace clipc::draw {

// The packing rules of a constant buffer, kConstants, and of a StructuredBuffer's element,
// kStructured, where components follow each other at multiples of their own size; a struct begins
// at a multiple of its largest component's size, and its size is one; the registers of a matrix
// (rows if row_major, else columns) and the elements of an array follow each other without gaps.
enum class Packing { kConstants, kStructured };

struct StructuredSize {
  std::uint32_t size = 0, alignment = 1;
};
StructuredSize StructuredSizeOf(const ir::TypeTable& types, ir::TypeId type);

// Calls visit(kind, byte) for every component of a value of `type` that starts at `offset`, in the
// order of the value: elements, fields, and of a matrix row after row. Throws DrawError for 64-bit
// constants.
void ForEachComponent(const ir::TypeTable& types, ir::TypeId type, bool row_major,
                      std::uint32_t offset,
                      const std::function<void(ir::Scalar kind, std::uint32_t byte)>& visit,
                      Packing packing = Packing::kConstants);

// What OpenGL calls the block, or each block of an array: "parts_block[1][0]".
std::vector<std::string> BlockNames(const ir::Program& program,
                                    const GlslInfo::UniformBlock& block);

// Adds the cbuffers, whose bytes are given by CbufferId, to `inputs` as the blocks and uniforms of
// the written shader. The value of a plain uniform is found by its name: `light.color`,
// `planes[1]`. `inputs` refers to the other arguments from then on.
void GiveConstants(const ir::Program& program, const GlslInfo& info,
                   const std::vector<Bytes>& cbuffers, Inputs& inputs);

}  // namespace clipc::draw
