// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The interface of a pixel shader in HLSL, as clipc's own front end understood it.
#include <utility>
#include <vector>

#include "ir/access.h"
#include "link/members.h"
#include "link/names.h"
#include "link/read.h"

namespace clipc::link {

using namespace ir;

namespace {

Input InputOf(const Program& program, const IoVar& io, std::uint32_t mask, std::string where) {
  return {.name = GlslNameOf(io.path),
          .semantic = io.semantic,
          .index = io.index,
          .location = io.location,
          .is_placed = io.is_placed,
          .type = GlslTypeOf(program.types, program.vars[io.var].type).value_or(GlslType{}),
          .interpolation = io.interpolation,
          .centroid = io.centroid,
          .sample = io.sample,
          .is_read = mask != 0,
          .is_of_patch = io.is_of_patch,
          .components_read = mask,
          .where = std::move(where)};
}

}  // namespace

Interface ReadInputs(const Program& program, const std::function<std::string(Span)>& place) {
  Interface interface;
  interface.stage = program.stage;
  const std::vector<std::uint32_t> masks = ComponentsRead(program);
  for (const IoVar& io : program.inputs) {
    const std::uint32_t mask = masks[io.var.index];
    // The lowering adds the distances to clip planes to the vertex shader itself.
    if (io.builtin == Builtin::kNone && mask != 0 && io.semantic != kClipPlaneDistance)
      interface.inputs.push_back(InputOf(program, io, mask, place(program.vars[io.var].span)));
  }
  return interface;
}

// Names are those that glslang and SPIRV-Cross give: of the parameter and its member, and of the
// constant buffer.
Interface ReadProgram(const Program& program, const std::function<std::string(Span)>& place) {
  Interface interface;
  const std::vector<std::uint32_t> masks = ComponentsRead(program);
  const std::string* path = nullptr;  // the path of the input before
  for (const IoVar& io : program.inputs) {
    if (io.builtin != Builtin::kNone) continue;
    const Var& var = program.vars[io.var];
    const std::uint32_t mask = masks[io.var.index];
    // The input is the next row of one matrix.
    if (path && *path == io.path) {
      Input& whole = interface.inputs.back();
      ++whole.type.columns;
      whole.is_read = whole.is_read || mask != 0;
      continue;
    }
    path = &io.path;
    interface.inputs.push_back(InputOf(program, io, mask, place(var.span)));
  }
  std::vector<bool> is_used(program.cbuffers.size());
  for (const VarId id : program.vars.ids()) {
    if (masks[id.index] != 0 && program.vars[id].cbuffer)
      is_used[program.vars[id].cbuffer.index] = true;
  }
  for (const CbufferId id : program.cbuffers.ids()) {
    const Cbuffer& cbuffer = program.cbuffers[id];
    // Push constants belong to one stage, and are not a block in GLSL for OpenGL.
    if (!is_used[id.index] || cbuffer.is_push_constant) continue;
    std::vector<UniformMember> members = MembersOf(program, cbuffer);
    for (UniformMember& member : members) {
      if (member.type && member.type->scalar == Scalar::kBool) member.type->scalar = Scalar::kUint;
    }
    const bool is_globals = cbuffer.kind == CbufferKind::kGlobals;
    interface.blocks.push_back({.name = is_globals ? "_Global" : GlslNameOf(cbuffer.name),
                                .has_instance = true,
                                .instance = {},
                                .members = std::move(members),
                                .set = cbuffer.reg.space,
                                .binding = cbuffer.reg.number,
                                .where = place(cbuffer.span)});
  }
  return interface;
}

}  // namespace clipc::link
