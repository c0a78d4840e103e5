// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/intrinsic_call.h"

#include <utility>

#include "backend-glsl/intrinsics.h"
#include "backend-glsl/writer/expr.h"
#include "backend-glsl/writer/helper.h"
#include "backend-glsl/writer/interface.h"
#include "backend-glsl/writer/operand.h"
#include "backend-glsl/writer/outputs.h"
#include "backend-glsl/writer/types.h"
#include "backend-glsl/writer/wave_call.h"
#include "base/invariant.h"
#include "ir/intrinsic_list.h"

namespace clipc::glsl {

using namespace ir;

namespace {

Binding WriteCast(Code& code, Scalar to, ExprId operand) {
  const Scalar from = code.ShapeAt(operand).scalar;
  if (from == to) return WriteExpr(code, operand);
  if (from != Scalar::kFloat && to != Scalar::kFloat) return WriteConverted(code, to, operand);
  code.Require(Feature::kBitCasts);
  const char* function = to == Scalar::kInt     ? "floatBitsToInt"
                         : to == Scalar::kUint  ? "floatBitsToUint"
                         : from == Scalar::kInt ? "intBitsToFloat"
                                                : "uintBitsToFloat";
  return WriteCall(code, function, {&operand, 1});
}

// Writes all() or any() of the operand.
Binding WriteReduction(Code& code, std::string_view function, ExprId operand) {
  const Shape shape = code.ShapeAt(operand);
  if (shape.IsScalar()) return WriteConverted(code, Scalar::kBool, operand);
  if (shape.scalar == Scalar::kBool) return WriteCall(code, function, {&operand, 1});
  code.Put(function, "(notEqual(");
  WriteAt(code, operand, Binding::kAssignment);
  code.Put(", ", ZeroText(code, shape), "))");
  return Binding::kPostfix;
}

// Writes mul(left, right). GLSL's matrices are the transposes of HLSL's, so the factors are
// swapped: mul(v, M) is M * v.
Binding WriteProduct(Code& code, ExprId left, ExprId right, const Shape& result) {
  const Shape a = code.ShapeAt(left), b = code.ShapeAt(right);
  if (a.IsScalar() || b.IsScalar()) {
    // In a product of a scalar with anything, or of float1x1 with a row, the scalar multiplies all
    // components.
    const bool is_splat = a.IsScalar() && !result.IsScalar() && IsOneScalar(code.program, right);
    const std::size_t begin = code.out->size();
    const Binding binding = is_splat ? WriteSplat(code, result, left)
                            : b.IsScalar() && IsOneScalar(code.program, left) && !a.IsScalar()
                                ? WriteExpr(code, left)
                                : WriteOperand(code, left);
    if (binding < Binding::kProduct) code.EncloseFrom(begin);
    code.Put(" * ");
    WriteOperandAt(code, right, Tighter(Binding::kProduct));
    return Binding::kProduct;
  }
  if (a.IsVector() && b.IsVector()) {
    // A vector is a row on the left and a column on the right.
    const Type& type = code.TypeOf(left);
    const bool left_is_column = type.kind == TypeKind::kMatrix && type.columns == 1;
    if (left_is_column) std::swap(left, right);
    const ExprId sides[] = {left, right};
    return WriteCall(code, left_is_column ? "outerProduct" : "dot", sides);
  }
  WriteAt(code, right, Binding::kProduct);
  code.Put(" * ");
  WriteAt(code, left, Tighter(Binding::kProduct));
  return Binding::kProduct;
}

// Writes asuint(x, low, high) of a double, by a helper function.
Binding WriteWordsOf(Code& code, std::span<const ExprId> arguments) {
  const std::size_t begin = code.out->size();
  const Binding binding = WriteCall(code, "", arguments);
  code.PutBefore(begin, Helper(code, "asuint64", "", [](const std::string& function) {
                   return Concat("void ", function, "(double x, out uint low, out uint high) {\n",
                                 "    uvec2 words = unpackDouble2x32(x);\n",
                                 "    low = words.x;\n    high = words.y;\n}\n");
                 }));
  return binding;
}

// Writes a derivative. Direct3D's window has y downwards.
Binding WriteDerivative(Code& code, Intrinsic op, ExprId operand) {
  code.Require(Feature::kDerivatives);
  const bool has_fine = code.Has(Feature::kFineDerivatives);
  const auto call = [&](std::string_view function, std::string_view which) {
    if (has_fine && !which.empty()) code.Require(Feature::kFineDerivatives);
    return WriteCall(code, Concat(function, has_fine ? which : ""), {&operand, 1});
  };
  const auto by_y = [&](std::string_view which) {
    if (code.target.HasUpperLeftOrigin()) return call("dFdy", which);
    code.Put("-");
    call("dFdy", which);
    return Binding::kMinus;
  };
  switch (op) {
    case Intrinsic::kDdx: return call("dFdx", "");
    case Intrinsic::kDdxCoarse: return call("dFdx", "Coarse");
    case Intrinsic::kDdxFine: return call("dFdx", "Fine");
    case Intrinsic::kDdy: return by_y("");
    case Intrinsic::kDdyCoarse: return by_y("Coarse");
    case Intrinsic::kDdyFine: return by_y("Fine");
    default: return call("fwidth", "");
  }
}

// Writes the components that a swizzle takes, if there is one.
Binding Components(Code& code, const Swizzle* swizzle) {
  if (!swizzle) return Binding::kPostfix;
  code.Put(".");
  for (int i = 0; i < swizzle->count; ++i)
    code.Put(std::string_view("xyzw").substr(swizzle->components[i], 1));
  return Binding::kPostfix;
}

// Writes an input's value at another place of the pixel, or at a vertex. GLSL before 4.60 takes no
// components of an input there. The offset of a snapped place is in sixteenths of a pixel, with y
// downwards.
Binding WriteInterpolant(Code& code, Intrinsic op, std::span<const ExprId> arguments) {
  const auto* swizzle = code.As<Swizzle>(arguments[0]);
  if (op == Intrinsic::kAttributeAtVertex) {
    const ExprId input = swizzle ? swizzle->base : arguments[0];
    code.Put(AtVertex(code, code.As<VarRef>(input)->var,
                      ExprText(code, arguments[1]).At(Binding::kAssignment)));
    return Components(code, swizzle);
  }
  code.Require(Feature::kInterpolants);
  code.Put(op == Intrinsic::kEvaluateAtSample  ? "interpolateAtSample("
           : op == Intrinsic::kEvaluateSnapped ? "interpolateAtOffset("
                                               : "interpolateAtCentroid(");
  WriteAt(code, swizzle ? swizzle->base : arguments[0], Binding::kAssignment);
  if (op == Intrinsic::kEvaluateAtSample) {
    code.Put(", int(");
    WriteAt(code, arguments[1], Binding::kAssignment);
    code.Put(")");
  } else if (op == Intrinsic::kEvaluateSnapped) {
    code.Put(", vec2(");
    WriteAt(code, arguments[1], Binding::kAssignment);
    code.Put(code.target.HasUpperLeftOrigin() ? ") * 0.0625" : ") * vec2(0.0625, -0.0625)");
  }
  code.Put(")");
  return Components(code, swizzle);
}

// Writes a barrier. Where it waits too and is not a statement by itself, it is a helper function.
Binding WriteBarrier(Code& code, Intrinsic op) {
  const std::string_view order = MemoryBarrierOf(op);
  if (!WaitsForGroup(op)) {
    code.Put(order, "()");
    return Binding::kPostfix;
  }
  code.Put(Helper(code, "wait_for_group", std::string(order),
                  [&](const std::string& function) {
                    return Concat("void ", function, "() {\n    ", order,
                                  "();\n    barrier();\n}\n");
                  }),
           "()");
  return Binding::kPostfix;
}

// Writes an input at a vertex of the primitive or of the patch, or what makes such.
Binding WriteVertexCall(Code& code, Intrinsic op, std::span<const ExprId> arguments) {
  const bool emits = op == Intrinsic::kEmitVertex;
  if (op == Intrinsic::kIsFirstPoint) return code.Put("gl_InvocationID == 0"), Binding::kEquality;
  if (op == Intrinsic::kEndPoints)
    code.Put("barrier()");
  else if (op == Intrinsic::kOutputOfPoint)
    code.Put(AtPoint(code, code.As<VarRef>(arguments[0])->var, IndexValue(code, arguments[1])));
  else if (op == Intrinsic::kInputOfVertex)
    code.Put(AtVertex(code, code.As<VarRef>(arguments[0])->var, IndexValue(code, arguments[1])));
  else if (code.program.emission.streams.size() > 1)
    code.Put(emits ? "EmitStreamVertex(" : "EndStreamPrimitive(", IndexValue(code, arguments[0]),
             ")");
  else
    code.Put(emits ? "EmitVertex()" : "EndPrimitive()");
  return Binding::kPostfix;
}

std::string_view AtomicFunction(Intrinsic op) {
  switch (op) {
    case Intrinsic::kInterlockedAdd: return "atomicAdd";
    case Intrinsic::kInterlockedAnd: return "atomicAnd";
    case Intrinsic::kInterlockedOr: return "atomicOr";
    case Intrinsic::kInterlockedXor: return "atomicXor";
    case Intrinsic::kInterlockedMin: return "atomicMin";
    case Intrinsic::kInterlockedMax: return "atomicMax";
    case Intrinsic::kInterlockedExchange: return "atomicExchange";
    default: return "atomicCompSwap";
  }
}

}  // namespace

std::string_view MemoryBarrierOf(Intrinsic op) {
  return BarrierOf(op).orders_objects ? "memoryBarrier" : "memoryBarrierShared";
}

std::string_view BitNumberFunction(Intrinsic op) {
  switch (op) {
    case Intrinsic::kCountBits: return "bitCount";
    case Intrinsic::kFirstBitHigh: return "findMSB";
    case Intrinsic::kFirstBitLow: return "findLSB";
    default: return {};
  }
}

namespace {

// Writes a call of a function of bit patterns.
Binding WriteBits(Code& code, Intrinsic op, std::span<const ExprId> arguments) {
  const ExprId x = arguments[0];
  switch (op) {
    case Intrinsic::kAsFloat: return WriteCast(code, Scalar::kFloat, x);
    case Intrinsic::kAsInt: return WriteCast(code, Scalar::kInt, x);
    case Intrinsic::kAsUint:
      return arguments.size() == 1 ? WriteCast(code, Scalar::kUint, x)
                                   : WriteWordsOf(code, arguments);
    case Intrinsic::kAsDouble:
      code.Put("packDouble2x32(");
      WriteCall(code, "uvec2", arguments);
      code.Put(")");
      return Binding::kPostfix;
    case Intrinsic::kF16ToF32:
      WriteCall(code, "unpackHalf2x16", arguments);
      code.Put(".x");
      return Binding::kPostfix;
    default:  // F32ToF16
      code.Put("packHalf2x16(vec2(");
      WriteAt(code, x, Binding::kAssignment);
      code.Put(", 0.0))");
      return Binding::kPostfix;
  }
}

// Writes a call of a function of numbers.
Binding WriteFunction(Code& code, TypeId type, const IntrinsicCall& node) {
  const auto arguments = code[node.arguments];
  const ExprId x = arguments[0];
  const Shape shape = code.ShapeAt(x);
  const auto call = [&](std::string_view function) { return WriteCall(code, function, arguments); };
  // Some functions give a uint in HLSL, an int in GLSL, or the other way round.
  const auto converted = [&](std::string_view function) {
    code.Put(TypeName(code, ShapeOf(code[type], code.needs)), "(");
    call(function);
    code.Put(")");
    return Binding::kPostfix;
  };
  if (const BuiltinFunction* builtin = BuiltinOf(node.op, shape, code.target)) {
    const bool is_sign = node.op == Intrinsic::kSign && BaseOf(code[type].scalar) != shape.scalar;
    if (is_sign) return converted(builtin->glsl);
    return WriteCall(code, builtin->glsl, arguments, shape.IsVector() ? builtin->scalars : 0);
  }
  switch (node.op) {
    case Intrinsic::kMul:
      return WriteProduct(code, x, arguments[1], ShapeOf(code[type], code.needs));
    case Intrinsic::kAll:
    case Intrinsic::kAny: return WriteReduction(code, NameOf(node.op), x);
    case Intrinsic::kTranspose: return shape.HasRows() ? call("transpose") : WriteExpr(code, x);
    case Intrinsic::kDot:
      return shape.IsScalar() ? WriteOperator(code, BinaryOp::kMul, x, arguments[1]) : call("dot");
    case Intrinsic::kDeterminant: return shape.HasRows() ? call("determinant") : WriteExpr(code, x);
    // LowerFunctions keeps it where the edges are in order.
    case Intrinsic::kSmoothstep:
      return WriteCall(code, "smoothstep", arguments, shape.IsVector() ? 0b011 : 0);
    case Intrinsic::kNonUniform:
      if (!code.target.IsVulkan()) return WriteExpr(code, x);
      code.Require("GL_EXT_nonuniform_qualifier");
      return call("nonuniformEXT");
    case Intrinsic::kCheckAccessFullyMapped:
      code.Require(Feature::kTextureStatus);
      code.Put("sparseTexelsResidentARB(int(");
      WriteAt(code, x, Binding::kAssignment);
      code.Put("))");
      return Binding::kPostfix;
    case Intrinsic::kReverseBits: return call("bitfieldReverse");
    default: break;
  }
  const std::string_view counting = BitNumberFunction(node.op);
  CLIPC_CHECK(!counting.empty());
  return converted(counting);
}

}  // namespace

Binding WriteIntrinsic(Code& code, TypeId type, const IntrinsicCall& node) {
  const auto arguments = code[node.arguments];
  switch (CategoryOf(node.op)) {
    case IntrinsicCategory::kBits: return WriteBits(code, node.op, arguments);
    case IntrinsicCategory::kMemory: return WriteBarrier(code, node.op);
    case IntrinsicCategory::kVertices: return WriteVertexCall(code, node.op, arguments);
    case IntrinsicCategory::kAtomic: return WriteCall(code, AtomicFunction(node.op), arguments);
    case IntrinsicCategory::kNeighbours: return WriteDerivative(code, node.op, arguments[0]);
    case IntrinsicCategory::kWave:
    case IntrinsicCategory::kQuad: return WriteWave(code, node);
    case IntrinsicCategory::kInterpolants: return WriteInterpolant(code, node.op, arguments);
    default: return WriteFunction(code, type, node);
  }
}

}  // namespace clipc::glsl
