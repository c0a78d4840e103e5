// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The functions that HLSL has built in.
#include <algorithm>
#include <optional>
#include <utility>

#include <spirv/unified1/GLSL.std.450.h>

#include "backend-spirv/writer.h"
#include "ir/intrinsic_list.h"
#include "ir/scalar.h"

namespace clipc::spirv {

using namespace ir;

namespace {

std::optional<ExtendedFunction> FunctionOf(ir::Intrinsic op) {
  using enum ir::Intrinsic;
  switch (op) {
    case kAbs: return {{GLSLstd450FAbs, GLSLstd450SAbs}};
    case kAcos: return {{GLSLstd450Acos}};
    case kAsin: return {{GLSLstd450Asin}};
    case kAtan: return {{GLSLstd450Atan}};
    case kAtan2: return {{GLSLstd450Atan2}};
    case kCeil: return {{GLSLstd450Ceil}};
    case kCos: return {{GLSLstd450Cos}};
    case kCosh: return {{GLSLstd450Cosh}};
    case kCross: return {{GLSLstd450Cross}};
    case kDegrees: return {{GLSLstd450Degrees}};
    case kDistance: return {{GLSLstd450Distance}};
    case kExp: return {{GLSLstd450Exp}};
    case kExp2: return {{GLSLstd450Exp2}};
    case kFaceforward: return {{GLSLstd450FaceForward}};
    case kFloor: return {{GLSLstd450Floor}};
    case kFma: return {{GLSLstd450Fma}};
    case kFrac: return {{GLSLstd450Fract}};
    case kLength: return {{GLSLstd450Length}};
    case kLerp: return {{GLSLstd450FMix}};
    case kLog: return {{GLSLstd450Log}};
    case kLog2: return {{GLSLstd450Log2}};
    case kNormalize: return {{GLSLstd450Normalize}};
    case kPow: return {{GLSLstd450Pow}};
    case kRadians: return {{GLSLstd450Radians}};
    case kReflect: return {{GLSLstd450Reflect}};
    case kRefract: return {{GLSLstd450Refract}};
    case kRound: return {{GLSLstd450RoundEven}};
    case kRsqrt: return {{GLSLstd450InverseSqrt}};
    case kSign: return {{GLSLstd450FSign, GLSLstd450SSign}};
    case kSin: return {{GLSLstd450Sin}};
    case kSinh: return {{GLSLstd450Sinh}};
    case kSqrt: return {{GLSLstd450Sqrt}};
    case kTan: return {{GLSLstd450Tan}};
    case kTanh: return {{GLSLstd450Tanh}};
    case kTrunc: return {{GLSLstd450Trunc}};
    default: return std::nullopt;
  }
}

// One of the functions for floats, signed and unsigned integers.
struct NumberFunctions {
  std::uint32_t of_float, of_int, of_uint;
};
std::uint32_t FunctionFor(const Shape& shape, const NumberFunctions& functions) {
  if (shape.IsFloating()) return functions.of_float;
  return IsUnsigned(shape.scalar) ? functions.of_uint : functions.of_int;
}

bool IsSigned(Scalar scalar) { return scalar == Scalar::kInt || scalar == Scalar::kInt64; }

}  // namespace

Ref Writer::Extended(std::uint32_t function, Ref type, std::initializer_list<Ref> arguments) {
  Words operands{module_.ExtendedSet(), function};
  operands.insert(operands.end(), arguments);
  const Ref result = Emit(spv::Op::OpExtInst, type, operands);
  if (is_precise_) module_.Decorate(result, spv::Decoration::NoContraction);
  return result;
}

// min, max and clamp give the operand that is a number: min and max of the Direct3D 11.3 functional
// specification, and the native results of vkd3d's test_shader_instructions (ps_min_max).
Ref Writer::Minimum(const Shape& shape, Ref a, Ref b) {
  return Extended(FunctionFor(shape, {GLSLstd450NMin, GLSLstd450SMin, GLSLstd450UMin}),
                  types_.Of(shape), {a, b});
}

Ref Writer::Maximum(const Shape& shape, Ref a, Ref b) {
  return Extended(FunctionFor(shape, {GLSLstd450NMax, GLSLstd450SMax, GLSLstd450UMax}),
                  types_.Of(shape), {a, b});
}

Ref Writer::Clamped(const Shape& shape, Ref value, Ref low, Ref high) {
  return Extended(FunctionFor(shape, {GLSLstd450NClamp, GLSLstd450SClamp, GLSLstd450UClamp}),
                  types_.Of(shape), {value, low, high});
}

// saturate() of NaN is 0: ftos of the Direct3D 11.3 functional specification.
Ref Writer::Saturated(const Shape& shape, Ref value) {
  return Clamped(shape, value, types_.Splat(shape, 0),
                 types_.Splat(shape, Types::OneOf(shape.scalar)));
}

// mul(left, right). SPIR-V's matrices are the transposes of HLSL's, so the factors are swapped:
// mul(v, M) is M * v.
Ref Writer::Product(ExprId left, ExprId right, const Shape& result) {
  const Shape of_a = ShapeAt(left), of_b = ShapeAt(right);
  // What SPIR-V has first is loaded first: in the other order, drivers need more registers.
  Ref b{};
  const bool is_swapped = !of_b.IsScalar() && IsPure(program_, right);
  if (is_swapped) b = Value(right);
  const Ref a = Value(left);
  if (!is_swapped) b = Value(right);
  const Ref type = types_.Of(result);
  if (of_a.IsScalar() || of_b.IsScalar()) {
    const Ref wide_a = of_a.IsScalar() ? Splat(result, a) : a;
    const Ref wide_b = of_b.IsScalar() ? Splat(result, b) : b;
    return Combine(BinaryOp::kMul, result, wide_a, wide_b);
  }
  if (!of_a.IsFloating()) return Lack("a product of integers");
  if (of_a.IsVector() && of_b.IsVector()) {
    // A vector is a row on the left and a column on the right.
    const Type& of = TypeAt(left);
    if (of.kind == TypeKind::kMatrix && of.columns == 1)
      return Compute(spv::Op::OpOuterProduct, type, {b, a});
    return Compute(spv::Op::OpDot, type, {a, b});
  }
  if (of_a.IsVector()) return Compute(spv::Op::OpMatrixTimesVector, type, {b, a});
  if (of_b.IsVector()) return Compute(spv::Op::OpVectorTimesMatrix, type, {b, a});
  return Compute(spv::Op::OpMatrixTimesMatrix, type, {b, a});
}

Ref Writer::Derivative(ir::Intrinsic op, const Shape& shape, Ref value) {
  using enum ir::Intrinsic;
  const Ref type = types_.Of(shape);
  const auto exact = [&](spv::Op instruction) {
    module_.Require(spv::Capability::DerivativeControl);
    return Emit(instruction, type, {value});
  };
  // OpenGL's window has y upwards, Direct3D's downwards.
  const auto by_y = [&](Ref derivative) {
    return options_.has_upper_left_origin ? derivative
                                          : Emit(spv::Op::OpFNegate, type, {derivative});
  };
  switch (op) {
    case kDdx: return Emit(spv::Op::OpDPdx, type, {value});
    case kDdy: return by_y(Emit(spv::Op::OpDPdy, type, {value}));
    case kDdxCoarse: return exact(spv::Op::OpDPdxCoarse);
    case kDdyCoarse: return by_y(exact(spv::Op::OpDPdyCoarse));
    case kDdxFine: return exact(spv::Op::OpDPdxFine);
    case kDdyFine: return by_y(exact(spv::Op::OpDPdyFine));
    default: return Emit(spv::Op::OpFwidth, type, {value});
  }
}

// What the invocation stores before comes before what it stores after, for other invocations; if
// the barrier waits, those of the group come to it too.
Ref Writer::OrderMemory(ir::Intrinsic op) {
  using enum spv::MemorySemanticsMask;
  const BarrierInfo barrier = BarrierOf(op);
  std::uint32_t semantics = NumberOf(AcquireRelease);
  if (barrier.orders_objects) semantics |= NumberOf(UniformMemory) | NumberOf(ImageMemory);
  if (barrier.orders_shared) semantics |= NumberOf(WorkgroupMemory);
  const Ref group = types_.Uint(NumberOf(spv::Scope::Workgroup));
  const Ref scope = barrier.orders_objects ? types_.Uint(NumberOf(spv::Scope::Device)) : group;
  if (barrier.waits)
    Do(spv::Op::OpControlBarrier, {group, scope, types_.Uint(semantics)});
  else
    Do(spv::Op::OpMemoryBarrier, {scope, types_.Uint(semantics)});
  return 0;
}

// modf(x, whole): the fraction; the pass LowerFunctions replaced the others that write arguments.
Ref Writer::Writing(const IntrinsicCall& node) {
  const auto arguments = (*this)[node.arguments];
  const Shape shape = ShapeAt(arguments[0]);
  if (node.op != ir::Intrinsic::kModf || !shape.IsFloating())
    return Lack("a function that writes an argument");
  const Ref type = types_.Of(shape);
  const Ref value = Value(arguments[0]);
  const Place whole = PlaceOf(arguments[1]);
  const Ref both = module_.Type(spv::Op::OpTypeStruct, {type, type});
  const Ref parts = Extended(GLSLstd450ModfStruct, both, {value});
  Store(whole, Part(type, parts, 1));
  return Part(type, parts, 0);
}

// asuint(x, low, high) of a double.
Ref Writer::WordsOf(const IntrinsicCall& node) {
  const auto arguments = (*this)[node.arguments];
  const Ref value = Value(arguments[0]);
  const Ref uint = types_.Of(Scalar::kUint);
  const Ref words = Emit(spv::Op::OpBitcast, types_.Vector(uint, 2), {value});
  for (const std::uint32_t i : {0u, 1u}) Store(PlaceOf(arguments[i + 1]), Part(uint, words, i));
  return 0;
}

// Writes a function of the extended set.
Ref Writer::FromSet(const ExtendedFunction& function, bool is_sign, const Evaluated& of) {
  const std::uint32_t number = of.shape.IsFloating() ? function.of_float : function.of_int;
  if (number == 0 || IsUnsigned(of.shape.scalar)) return Lack("a function of integers");
  const Shape made = is_sign ? of.shape : of.result;
  const Ref type = types_.Of(made);
  Ref value = 0;
  if (of.count == 1) value = Extended(number, type, {of.values[0]});
  if (of.count == 2) value = Extended(number, type, {of.values[0], of.values[1]});
  if (of.count == 3) value = Extended(number, type, {of.values[0], of.values[1], of.values[2]});
  return Converted(value, made, of.result.scalar);
}

// Writes a function of bits.
Ref Writer::OfBits(ir::Intrinsic op, const Evaluated& of) {
  using enum ir::Intrinsic;
  switch (op) {
    case kAsFloat:
    case kAsInt:
    case kAsUint:
      return of.shape.scalar == of.result.scalar
                 ? of.values[0]
                 : Emit(spv::Op::OpBitcast, of.type, {of.values[0]});
    case kAsDouble: {
      const Ref words =
          Compose(types_.Of(ShapeOf(Scalar::kUint, 1, 2)), std::span(of.values).first(2));
      return Emit(spv::Op::OpBitcast, of.type, {words});
    }
    case kCheckAccessFullyMapped:
      module_.Require(spv::Capability::SparseResidency);
      return Emit(spv::Op::OpImageSparseTexelsResident, of.type, {of.values[0]});
    case kCountBits: {
      const Ref count = Emit(spv::Op::OpBitCount, types_.Of(of.shape), {of.values[0]});
      return Converted(count, of.shape, of.result.scalar);
    }
    case kReverseBits: return Emit(spv::Op::OpBitReverse, of.type, {of.values[0]});
    case kFirstBitHigh: {
      const std::uint32_t function =
          IsSigned(of.shape.scalar) ? GLSLstd450FindSMsb : GLSLstd450FindUMsb;
      return Converted(Extended(function, types_.Of(of.shape), {of.values[0]}), of.shape,
                       of.result.scalar);
    }
    case kFirstBitLow:
      return Converted(Extended(GLSLstd450FindILsb, types_.Of(of.shape), {of.values[0]}), of.shape,
                       of.result.scalar);
    case kF16ToF32: {
      if (!of.shape.IsScalar()) return Lack("f16tof32 of a vector");
      const Ref two = types_.Of(ShapeOf(Scalar::kFloat, 1, 2));
      return Part(of.type, Extended(GLSLstd450UnpackHalf2x16, two, {of.values[0]}), 0);
    }
    case kF32ToF16: {
      if (!of.shape.IsScalar()) return Lack("f32tof16 of a vector");
      const Ref parts[] = {of.values[0], types_.Float(0)};
      const Ref two = Compose(types_.Of(ShapeOf(Scalar::kFloat, 1, 2)), parts);
      return Extended(GLSLstd450PackHalf2x16, of.type, {two});
    }
    default: return Lack("a function of another kind");
  }
}

// Writes a function of numbers that the extended set lacks.
Ref Writer::OfNumbers(ir::Intrinsic op, const Evaluated& of) {
  using enum ir::Intrinsic;
  const auto truth = [&](spv::Op all) {
    const Ref bools = Converted(of.values[0], of.shape, Scalar::kBool);
    return of.shape.IsScalar() ? bools : Emit(all, types_.Of(Scalar::kBool), {bools});
  };
  switch (op) {
    case kMin: return Minimum(of.shape, of.values[0], of.values[1]);
    case kMax: return Maximum(of.shape, of.values[0], of.values[1]);
    case kClamp: return Clamped(of.shape, of.values[0], of.values[1], of.values[2]);
    case kAll: return of.shape.HasRows() ? Lack("all() of a matrix") : truth(spv::Op::OpAll);
    case kAny: return of.shape.HasRows() ? Lack("any() of a matrix") : truth(spv::Op::OpAny);
    case kDot:
      if (of.shape.IsScalar()) return Combine(BinaryOp::kMul, of.shape, of.values[0], of.values[1]);
      if (!of.shape.IsFloating()) return Lack("a dot product of integers");
      return Compute(spv::Op::OpDot, of.type, {of.values[0], of.values[1]});
    case kTranspose:
      if (!of.shape.HasRows()) return of.values[0];
      if (of.shape.kind != Shape::kMatrix) return Lack("a transpose of integers");
      return Emit(spv::Op::OpTranspose, of.type, {of.values[0]});
    case kDeterminant:
      return of.shape.HasRows() ? Extended(GLSLstd450Determinant, of.type, {of.values[0]})
                                : of.values[0];
    case kStep: {  // 0 for NaN: HLSL's is (x >= edge) ? 1 : 0, and GLSL's x < edge ? 0 : 1
      const Ref is_reached = Combine(BinaryOp::kGreaterEqual, of.shape, of.values[1], of.values[0]);
      return Converted(is_reached, of.shape.With(Scalar::kBool), of.result.scalar);
    }
    case kSmoothstep: {
      const Ref range = Combine(BinaryOp::kSub, of.shape, of.values[1], of.values[0]);
      const Ref from = Combine(BinaryOp::kSub, of.shape, of.values[2], of.values[0]);
      const Ref t = Saturated(of.shape, Combine(BinaryOp::kDiv, of.shape, from, range));
      const Ref two = types_.Splat(of.shape, BitsOf(-2.0f)),
                three = types_.Splat(of.shape, BitsOf(3.0f));
      const Ref line =
          Combine(BinaryOp::kAdd, of.shape, Combine(BinaryOp::kMul, of.shape, t, two), three);
      return Combine(BinaryOp::kMul, of.shape, Combine(BinaryOp::kMul, of.shape, t, t), line);
    }
    case kNonUniform:
      if (options_.is_opengl) return of.values[0];
      return Marked(Emit(spv::Op::OpCopyObject, of.type, {of.values[0]}), true);
    case kIsNan: return Emit(spv::Op::OpIsNan, of.type, {of.values[0]});
    case kIsInf: return Emit(spv::Op::OpIsInf, of.type, {of.values[0]});
    default: return OfBits(op, of);
  }
}

Ref Writer::Intrinsic(TypeId id, const IntrinsicCall& node) {
  using enum ir::Intrinsic;
  const auto arguments = (*this)[node.arguments];
  const Shape result = program_.types[id].IsNumeric() ? ShapeOf(program_.types[id]) : Shape{};
  if (node.op == kMul) return Product(arguments[0], arguments[1], result);
  switch (CategoryOf(node.op)) {
    case IntrinsicCategory::kWave:
    case IntrinsicCategory::kQuad: return Wave(id, node);
    case IntrinsicCategory::kInterpolants: return Interpolant(node);
    case IntrinsicCategory::kMemory: return OrderMemory(node.op);
    case IntrinsicCategory::kAtomic: return Atomic(node);
    case IntrinsicCategory::kVertices: return Vertices(node);
    case IntrinsicCategory::kWriting: return Writing(node);
    default: break;
  }
  if (node.op == kAsUint && arguments.size() > 1) return WordsOf(node);
  const Shape shape = ShapeAt(arguments[0]);
  const Ref type = types_.Of(id);
  Evaluated of{shape, result, type, {}, arguments.size()};
  for (std::size_t i = 0; i < arguments.size() && i < of.values.size(); ++i)
    of.values[i] = Value(arguments[i]);
  if (CategoryOf(node.op) == IntrinsicCategory::kNeighbours)
    return Derivative(node.op, shape, of.values[0]);
  if (const auto function = FunctionOf(node.op)) return FromSet(*function, node.op == kSign, of);
  return OfNumbers(node.op, of);
}

}  // namespace clipc::spirv
