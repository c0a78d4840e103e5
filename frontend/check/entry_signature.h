// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "frontend/check/clip_planes.h"
#include "frontend/check/context.h"
#include "frontend/signature/build_main.h"
// The signature of the entry point, as its parameters and its result are written.
namespace clipc::check {

// Returns the semantics and modifiers of the entry point. Makes variables of its `uniform`
// parameters.
EntrySignature SignatureOf(Context& context, FunctionInfoId entry);
// The semantic and the modifiers of a parameter, and of a function's result.
EntryParameter Described(Context& context, const ast::VarDecl& var);
EntryParameter DescribedResult(Context& context, const ast::FunctionDecl& decl);
// The number that the attribute has, from `least` to `most`; nullopt after an error, and without
// the attribute.
std::optional<std::uint32_t> NumberIn(Context& context, const AttributeLists& attributes,
                                      std::string_view name, std::int64_t most,
                                      std::int64_t least = 1);
// Sets how a value is interpolated, in an EntryParameter or an ir::Field.
void ReadInterpolation(ast::Qualifiers qualifiers, auto& into) {
  if (qualifiers & ast::kLinear) into.interpolation = Interpolation::kLinear;
  if (qualifiers & ast::kNoPerspective) into.interpolation = Interpolation::kNoPerspective;
  if (qualifiers & ast::kNoInterpolation) into.interpolation = Interpolation::kNoInterpolation;
  into.sample = (qualifiers & ast::kSample) != 0;
  into.centroid = (qualifiers & ast::kCentroid) != 0 && !into.sample;
}

// Reads [numthreads(x, y, z)] of the entry point into program.group_size, and reports what is wrong
// with it: "numthreads" of Microsoft's HLSL reference, and "Compute shaders on downlevel hardware"
// of the Direct3D 11 reference for profiles 4.0 and 4.1. Does nothing in other stages.
void CheckGroupSize(Context& context, FunctionInfoId entry, const AttributeLists& attributes);

// Leaves out the streams after the last one that the shader names, whatever they are: fxc reads one
// only where it is used (vkd3d's geometry-shader-syntax.shader_test, checked against native).
void LeaveOutStreams(Context& context, signature::EntrySignature& signature);
// Reads [maxvertexcount(n)] and [instance(n)] of the entry point into program.emission, and reports
// what is wrong with what it reads and gives: "Geometry-Shader Object", "maxvertexcount" and
// "instance" of Microsoft's HLSL reference; the Direct3D 11.3 functional specification, 13.
// Requires that BuildMain ran. Does nothing in stages that emit no vertices.
void CheckEmission(Context& context, FunctionInfoId entry, const AttributeLists& attributes);

}  // namespace clipc::check
