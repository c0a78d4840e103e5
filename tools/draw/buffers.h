// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "backend-glsl/write.h"
#include "ir/evaluate.h"
#include "ir/program.h"
#include "tools/draw/inputs.h"
#include "tools/draw/random_values.h"

// Buffers with random elements: Buffer<T>, StructuredBuffer<T> and ByteAddressBuffer; and images.
namespace clipc::draw {

// The bytes that the application uploads. A Buffer<T> has four words for each element.
using Buffer = Bytes;
// The buffers of a shader by VarId: the elements of an array of buffers, or the only one.
using Buffers = std::map<std::uint32_t, std::vector<Buffer>>;

// The value of an element after an atomic operation on its old value.
std::uint32_t Combined(const ir::ObjectRequest& request, ir::Scalar kind, std::uint32_t old);

// Makes the buffers and images that `program` declares.
Buffers MakeBuffers(const ir::Program& program, RandomValues& values);

// Answers a request for one of `buffers`, which a store or an atomic operation changes. Outside of
// the buffer and at bytes that do not start a word, the result is `undefined` and a store is lost.
void UseBuffer(const ir::Program& program, Buffers& buffers, const ir::ObjectRequest& request,
               double undefined, std::span<std::uint64_t> result);

// Adds the buffers to `inputs`, under the names that the written shader gives them.
void GiveBuffers(const ir::Program& program, const GlslInfo& info, const Buffers& buffers,
                 Inputs& inputs);

}  // namespace clipc::draw
