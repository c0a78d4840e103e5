// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/check_layout.h"

#include <algorithm>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "backend-glsl/block_layout.h"
#include "backend-glsl/reach.h"
#include "ir/std_layout.h"

namespace clipc::glsl {

using namespace ir;

namespace {

// The extent of a constant buffer's member in the layout; none if a part of it lies elsewhere than
// in Direct3D.
std::optional<StdExtent> ExtentIn(BufferLayout layout, const Program& program, TypeId type,
                                  const CbufferMember& member) {
  const Var& var = program.vars[member.var];
  if (layout == BufferLayout::kGl) return Std140(program.types, type, var.row_major);
  const StructuredExtent extent = Structured(program.types, type);
  const Extent packed = PackedExtent(program.types, type, var.row_major);
  if (extent.size != packed.size) return std::nullopt;  // Direct3D pads a part of it
  return StdExtent{.size = extent.size, .alignment = extent.alignment};
}

bool LiesAlike(BufferLayout layout, const Program& program, const ir::Cbuffer& cbuffer) {
  // dxc has std430 for these under -fvk-use-gl-layout.
  if (layout == BufferLayout::kGl &&
      (cbuffer.kind == CbufferKind::kTbuffer || cbuffer.is_push_constant))
    return false;
  std::uint64_t end = 0;
  return std::ranges::all_of(cbuffer.members, [&](const CbufferMember& member) {
    const TypeId type = program.vars[member.var].type;
    const bool is_whole = cbuffer.kind == CbufferKind::kConstantBuffer;
    const auto extent =
        ExtentIn(layout, program, is_whole ? program.types.Innermost(type) : type, member);
    if (!extent || RoundUp(end, extent->alignment) != member.offset) return false;
    end = member.offset + std::uint64_t{extent->size};
    return true;
  });
}

}  // namespace

void CheckBufferLayout(const Program& program, BufferLayout layout, Diagnostics& diagnostics) {
  if (layout == BufferLayout::kDirect3D) return;
  const Reached reached = Reach(program);
  const bool is_gl = layout == BufferLayout::kGl;
  const auto report = [&](Span span, const std::string& name) {
    diagnostics.Report(
        span, diag::Unsupported,
        fmt::format("`-fvk-use-{}-layout` with `{}`, which lies otherwise in Direct3D,",
                    is_gl ? "gl" : "scalar", name));
  };
  for (const CbufferId id : program.cbuffers.ids()) {
    const ir::Cbuffer& cbuffer = program.cbuffers[id];
    if (reached.Has(id) && !LiesAlike(layout, program, cbuffer)) report(cbuffer.span, cbuffer.name);
  }
  for (const Resource& resource : program.resources) {
    const Var& var = program.vars[resource.var];
    const Type& type = program.types[program.types.Innermost(var.type)];
    // A structured buffer has no padding in Direct3D either.
    if (is_gl && reached.Has(resource.var) && IsStructured(type.object) &&
        !Std430(program.types, type.element, var.row_major))
      report(var.span, var.name);
  }
}

}  // namespace clipc::glsl
