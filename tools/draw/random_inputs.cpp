// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/random_inputs.h"

#include <cstring>

#include "tools/draw/memory.h"

namespace clipc::draw {
namespace {

using namespace ir;

IoBits ValueOf(const Program& program, const IoVar& input, RandomValues& values) {
  const Type& type = program.types[program.vars[input.var].type];
  const bool is_array = type.kind == TypeKind::kArray;
  const Scalar kind = is_array ? program.types[type.element].scalar : type.scalar;
  IoBits bits{};
  for (std::uint32_t i = 0; i < (is_array ? type.count : type.Components()); ++i)
    bits[i] = values.Next(BaseOf(kind));
  return bits;
}

// Sets the values that the draw call gives. Direct3D counts vertices and instances from 0 wherever
// the draw call starts.
void SetBuiltins(const Program& program, const RandomOptions& options, int run,
                 std::vector<IoBits>& inputs) {
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const Builtin builtin = program.inputs[i].builtin;
    if (builtin == Builtin::kNone) continue;
    inputs[i] = {};
    const auto set = [&](Builtin which, int value) {
      if (builtin == which) inputs[i][0] = static_cast<std::uint64_t>(value);
    };
    set(Builtin::kVertexId, run % options.vertices);
    set(Builtin::kInstanceId, run / options.vertices);
    set(Builtin::kVertexIndex, options.first_vertex + run % options.vertices);
    set(Builtin::kInstanceIndex, options.base_instance + run / options.vertices);
    set(Builtin::kBaseVertex, options.first_vertex);
    set(Builtin::kBaseInstance, options.base_instance);
  }
}

// Makes the attributes of all vertices, instance after instance.
void MakeVertices(const Program& program, const RandomOptions& options, RandomValues& values,
                  RandomInputs& inputs) {
  for (int vertex = 0; vertex < options.vertices; ++vertex) {
    std::vector<IoBits>& attributes = inputs.vertices.emplace_back();
    for (const IoVar& input : program.inputs) attributes.push_back(ValueOf(program, input, values));
  }
  // The vertices of a primitive or of a patch have no values of the draw call.
  if (clipc::InfoOf(program.stage).reads_vertices) return;
  for (int run = 0; run < options.vertices * options.instances; ++run) {
    if (run >= options.vertices) inputs.vertices.push_back(inputs.vertices[run % options.vertices]);
    SetBuiltins(program, options, run, inputs.vertices[run]);
  }
}

}  // namespace

RandomInputs MakeRandomInputs(const Program& program, const RandomOptions& options) {
  RandomValues values(options);
  RandomInputs inputs;
  for (const CbufferId id : program.cbuffers.ids()) {
    const Cbuffer& cbuffer = program.cbuffers[id];
    Bytes& bytes = inputs.cbuffers.emplace_back(std::size_t{cbuffer.size} * cbuffer.count);
    for (const CbufferMember& member : cbuffer.members) {
      const Var& var = program.vars[member.var];
      const bool is_constant_buffer = cbuffer.kind == CbufferKind::kConstantBuffer;
      const TypeId type = is_constant_buffer ? program.types.Innermost(var.type) : var.type;
      for (std::uint32_t i = 0; i < cbuffer.count; ++i) {
        ForEachComponent(program.types, type, var.row_major, member.offset + i * cbuffer.size,
                         [&](Scalar kind, std::uint32_t byte) {
                           const std::uint32_t word = values.Next(kind);
                           std::memcpy(&bytes.at(byte), &word, 4);
                         });
      }
    }
  }
  if (clipc::InfoOf(program.stage).draws_pixels) {
    inputs.surface = MakeSurface(program, options, values);
    inputs.vertices = inputs.surface.pixels;
  } else {
    MakeVertices(program, options, values, inputs);
  }
  inputs.textures = MakeTextures(program, options, values);
  inputs.buffers = MakeBuffers(program, values);
  return inputs;
}

void RandomInputs::UseObject(const Program& program, Buffers& own, const ObjectRequest& request,
                             double undefined, std::span<std::uint64_t> result) const {
  if (textures.contains(request.object.index))
    return ReadTexture(program, textures, request, undefined, result);
  if (own.contains(request.object.index))
    return UseBuffer(program, own, request, undefined, result);
  // The element is after the end of an array of objects.
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = UndefinedBits(request, undefined, Scalar::kFloat, i);
}

}  // namespace clipc::draw
