// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Calls in shaders of which clipc looks only for the inputs and constants that are read: a call
// that it does not translate becomes its arguments and a zero of its type.
#include <vector>

#include "frontend/typing/intrinsic_call.h"

namespace clipc::typing {
namespace {

TypeId TypeOf(const IntrinsicCheck& call, StandIn type) {
  using enum StandIn;
  TypeTable& types = call.program.types;
  switch (type) {
    case kFirst: return call.arguments.empty() ? types.Error() : call.ArgumentTypeId(0);
    case kVoid: return types.Make(Scalar::kInt);
    case kBool: return types.Make(Scalar::kBool);
    case kUint: return types.Make(Scalar::kUint);
    case kUint4: return types.Vector(Scalar::kUint, 4);
    case kFloat: return types.Make(Scalar::kFloat);
    case kFloat2: return types.Vector(Scalar::kFloat, 2);
    case kFloat4: return types.Vector(Scalar::kFloat, 4);
  }
  return types.Error();
}

}  // namespace

ExprId StandInFor(const IntrinsicCheck& call, const Staged& staged) {
  if (!call.program.is_interface_only || !staged.trait || !(call.ThisStage().*staged.trait))
    return {};
  std::vector<ExprId> values;
  for (const ExprId argument : call.arguments) {
    if (call.TypeOf(argument).IsNumeric()) values.push_back(argument);
  }
  return After(call, values, call.Make().ZeroOf(TypeOf(call, staged.type)));
}

}  // namespace clipc::typing
