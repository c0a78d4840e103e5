// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <vector>

#include "backend-glsl/write.h"
#include "ir/evaluate.h"
#include "ir/program.h"
#include "tools/draw/inputs.h"
#include "tools/draw/random_values.h"

// Buffers with random elements: Buffer<T>, StructuredBuffer<T> and ByteAddressBuffer. Their layout
// follows HLSL's rules and shares nothing with the GLSL writer.
namespace clipc::draw {

// The bytes that the application uploads. A Buffer<T> has four words for each element.
using Buffer = std::vector<std::uint8_t>;
// By VarId; the elements of an array of buffers, or the only one.
using Buffers = std::map<std::uint32_t, std::vector<Buffer>>;

// Makes the buffers that `program` declares. Throws DrawError when the shader writes to one or
// reads an image.
Buffers MakeBuffers(const ir::Program& program, RandomValues& values);

// Answers a request for one of `buffers`. The result is `undefined` outside of the buffer and at
// bytes that do not start a word.
void ReadBuffer(const ir::Program& program, const Buffers& buffers,
                const ir::ObjectRequest& request, double undefined,
                std::span<std::uint64_t> result);

// Adds the buffers to `inputs`, under the names that the written shader gives them.
void GiveBuffers(const ir::Program& program, const glsl::GlslInfo& info, const Buffers& buffers,
                 Inputs& inputs);

// The layout of an element of a StructuredBuffer: components follow each other at multiples of
// their own size; a struct begins at a multiple of its largest component's size, and its size is
// one; the registers of a matrix (rows if row_major, else columns) and the elements of an array
// follow each other without gaps.
struct StructuredSize {
  std::uint32_t size = 0, alignment = 1;
};
StructuredSize StructuredSizeOf(const ir::TypeTable& types, ir::TypeId type);
// Calls visit(kind, byte) for every component of a value that starts at `offset`, in the order of
// the value.
void ForEachStructured(const ir::TypeTable& types, ir::TypeId type, bool row_major,
                       std::uint32_t offset,
                       const std::function<void(ir::Scalar kind, std::uint32_t byte)>& visit);

}  // namespace clipc::draw
