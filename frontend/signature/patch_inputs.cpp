// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/signature/patch_inputs.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/spelling.h"

namespace clipc::signature {

bool IsOfTessellator(Builtin builtin) {
  return builtin == Builtin::kDomainLocation || builtin == Builtin::kTessFactorInput ||
         builtin == Builtin::kInsideFactorInput;
}

ExprId PatchInputs::Read(const Carrier& leaf, Builtin builtin, Diagnostics& diagnostics) {
  const Type type = program_.types[leaf.type];
  const auto& domain = program_.tessellation.domain;
  const bool is_float = BaseOf(type.scalar) == Scalar::kFloat;
  if (!domain) return {};  // an error was reported
  if (builtin == Builtin::kDomainLocation) {
    // DXC takes two of three coordinates (its CodeGenSPIRV/semantic.inside-tess-factor.ds tests).
    // The third of a domain that has two is 0.
    const std::uint32_t count = type.Components();
    if (!is_float || count > 3)
      return semantics_.Refuse(leaf, fmt::format("a `float{}`", InfoOf(*domain).coordinates)),
             ExprId{};
    ExprId value = builder_.Ref(Input(leaf, builtin, TypeOf(program_.types, builtin)));
    if (count < 3) value = builder_.SwizzledRun(value, 0, count);
    return Fit(program_, builder_, value, leaf.type);
  }
  // "The tessellation factors must be declared as an array; they cannot be packed into a single
  // vector": "SV_TessFactor" of Microsoft's HLSL reference.
  if (!is_float || type.kind != TypeKind::kScalar)
    return semantics_.Refuse(leaf, "a `float` or an array of them"), ExprId{};
  const bool is_inside = builtin == Builtin::kInsideFactorInput;
  const std::uint32_t count = is_inside ? InfoOf(*domain).inside_factors : InfoOf(*domain).factors;
  const std::uint32_t index = leaf.cursor.semantic.index;
  if (index >= count) {
    diagnostics.Report(leaf.span, diag::FactorNumber, leaf.cursor.semantic.name, index,
                       InfoOf(*domain).name, WithCount(count, "element"));
    return builder_.ZeroOf(leaf.type);
  }
  const TypeId array = program_.types.Array(program_.types.Make(Scalar::kFloat), count);
  return Fit(program_, builder_, builder_.At(builder_.Ref(Input(leaf, builtin, array)), index),
             leaf.type);
}

VarId PatchInputs::Input(const Carrier& leaf, Builtin builtin, TypeId type) {
  const auto known = std::ranges::find(program_.inputs, builtin, &IoVar::builtin);
  return known != program_.inputs.end() ? known->var : vars_.AddInput(leaf, type, builtin);
}

}  // namespace clipc::signature
