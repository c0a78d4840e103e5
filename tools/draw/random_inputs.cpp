// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/random_inputs.h"

#include <cstring>

#include "ir/scalar.h"
#include "tools/draw/memory.h"

namespace clipc::draw {
namespace {

ir::IoBits ValueOf(const ir::Program& program, const ir::IoVar& input, RandomValues& values) {
  const ir::Type& type = program.types[program.vars[input.var].type];
  ir::IoBits bits{};
  for (std::uint32_t i = 0; i < type.Components(); ++i)
    bits[i] = values.Next(ir::BaseOf(type.scalar));
  return bits;
}

// Sets the values that the draw call gives. Direct3D counts vertices and instances from 0 wherever
// the draw call starts.
void SetBuiltins(const ir::Program& program, const RandomOptions& options, int run,
                 std::vector<ir::IoBits>& inputs) {
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const ir::Builtin builtin = program.inputs[i].builtin;
    if (builtin == ir::Builtin::kNone) continue;
    inputs[i] = {};
    const auto set = [&](ir::Builtin which, int value) {
      if (builtin == which) inputs[i][0] = static_cast<std::uint64_t>(value);
    };
    set(ir::Builtin::kVertexId, run % options.vertices);
    set(ir::Builtin::kInstanceId, run / options.vertices);
    set(ir::Builtin::kVertexIndex, options.first_vertex + run % options.vertices);
    set(ir::Builtin::kInstanceIndex, options.base_instance + run / options.vertices);
    set(ir::Builtin::kBaseVertex, options.first_vertex);
    set(ir::Builtin::kBaseInstance, options.base_instance);
  }
}

}  // namespace

RandomInputs MakeRandomInputs(const ir::Program& program, const RandomOptions& options) {
  RandomValues values(options);
  RandomInputs inputs;
  for (const ir::CbufferId id : program.cbuffers.ids()) {
    const ir::Cbuffer& cbuffer = program.cbuffers[id];
    std::vector<std::uint8_t>& bytes =
        inputs.cbuffers.emplace_back(std::size_t{cbuffer.size} * cbuffer.count);
    for (const ir::CbufferMember& member : cbuffer.members) {
      const ir::Var& var = program.vars[member.var];
      const bool is_array_of_buffers = cbuffer.count > 1;
      const ir::TypeId type = is_array_of_buffers ? program.types[var.type].element : var.type;
      for (std::uint32_t i = 0; i < cbuffer.count; ++i) {
        ForEachComponent(program.types, type, var.row_major, member.offset + i * cbuffer.size,
                         [&](ir::Scalar kind, std::uint32_t byte) {
                           const auto word = static_cast<std::uint32_t>(values.Next(kind));
                           std::memcpy(&bytes.at(byte), &word, 4);
                         });
      }
    }
  }
  for (int vertex = 0; vertex < options.vertices; ++vertex) {
    std::vector<ir::IoBits>& attributes = inputs.vertices.emplace_back();
    for (const ir::IoVar& input : program.inputs)
      attributes.push_back(ValueOf(program, input, values));
  }
  for (int run = 0; run < options.vertices * options.instances; ++run) {
    if (run >= options.vertices) inputs.vertices.push_back(inputs.vertices[run % options.vertices]);
    SetBuiltins(program, options, run, inputs.vertices[run]);
  }
  inputs.textures = MakeTextures(program, options, values);
  inputs.buffers = MakeBuffers(program, values);
  return inputs;
}

void RandomInputs::ReadObject(const ir::Program& program, const ir::ObjectRequest& request,
                              double undefined, std::span<std::uint64_t> result) const {
  if (textures.contains(request.object.index))
    return ReadTexture(program, textures, request, undefined, result);
  if (buffers.contains(request.object.index))
    return ReadBuffer(program, buffers, request, undefined, result);
  // After the end of an array of objects.
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = UndefinedBits(request, undefined, ir::Scalar::kFloat, i);
}

}  // namespace clipc::draw
