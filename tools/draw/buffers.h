// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <vector>

#include "backend-glsl/writer.h"
#include "ir/evaluate.h"
#include "ir/program.h"
#include "tools/draw/program.h"
#include "tools/draw/random_values.h"

// Buffers with random elements: Buffer<T>, StructuredBuffer<T> and ByteAddressBuffer. Their layout
// is written from HLSL's rules and not from what the GLSL writer makes of them.
namespace clipc::draw {

// As the application uploads it. A Buffer<T> has four words for each element.
using Buffer = std::vector<std::uint8_t>;
using Buffers =
    std::map<std::uint32_t, std::vector<Buffer>>;  // by VarId; of an array of buffers the elements

// Throws DrawError when the shader writes to one or reads an image.
Buffers MakeBuffers(const ir::Program& program, RandomValues& values);

// Answers a request for one of `buffers`. Outside of it, and at bytes that are no whole word, is
// `undefined`.
void ReadBuffer(const ir::Program& program, const Buffers& buffers,
                const ir::ObjectRequest& request, double undefined,
                std::span<std::uint64_t> result);

void GiveBuffers(const ir::Program& program, const glsl::GlslInfo& info, const Buffers& buffers,
                 Inputs& inputs);

// How an element of a StructuredBuffer lies: components one after another at multiples of their own
// size; a struct begins at, and takes, multiples of its largest component; the registers of a
// matrix (rows if row_major, else columns) and the elements of an array follow each other without
// gaps. Calls visit(kind, byte) in the order of the value.
struct StructuredPlace {
  std::uint32_t size = 0, alignment = 1;
};
StructuredPlace StructuredPlaceOf(const ir::TypeTable& types, ir::TypeId type);
void ForEachStructured(const ir::TypeTable& types, ir::TypeId type, bool row_major,
                       std::uint32_t offset,
                       const std::function<void(ir::Scalar kind, std::uint32_t byte)>& visit);

}  // namespace clipc::draw
