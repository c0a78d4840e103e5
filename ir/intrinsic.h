// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

// The functions that HLSL has built in and the IR keeps as calls: one row of ir/intrinsics.def
// each, where the columns are explained.
namespace clipc::ir {

enum class Intrinsic : std::uint8_t;  // ir/intrinsic_list.h has the enumerators

// The functions that sources without the enumerators name.
struct CommonIntrinsic {
  static const Intrinsic kAll, kAny, kAsDouble, kAsFloat, kAsUint, kAttributeAtVertex,
      kCheckAccessFullyMapped, kClamp, kClip, kDot, kEmitVertex, kEndPoints, kEndPrimitive, kFloor,
      kInputOfVertex, kIsFirstPoint, kIsNan, kMad, kMax, kMin, kMul, kNonUniform, kOutputOfPoint,
      kPow, kSaturate, kSign, kSmoothstep, kTranspose, kWaveReadLaneFirst, kWholePower;
};

// One argument, or the result, of a signature.
struct IntrinsicSlot {
  char shape = 0;  // 0: void
  char kind = 0;
  bool is_out = false;
};
struct IntrinsicSignature {
  static constexpr std::size_t kMaxArguments = 3;
  IntrinsicSlot result;
  std::array<IntrinsicSlot, kMaxArguments> arguments = {};
  std::uint8_t count = 0;   // the number of `arguments`
  bool writes = false;      // a call writes an argument
  bool is_special = false;  // the letters say nothing: the types follow rules of their own
};

enum class IntrinsicCategory : std::uint8_t {
  kComponents,    // component i of the result depends on component i of each argument
  kBits,          // as kComponents, but on the bit patterns of the components
  kVectors,       // the components of an argument are combined
  kWriting,       // an argument is written
  kNeighbours,    // component i of the result is a difference of components i between pixels
  kWave,          // the operand's values in other lanes of the wave count, too
  kQuad,          // as kWave, of the four pixels of a quad only
  kInterpolants,  // the first argument, an input, at another place of the pixel
  kMemory,        // without arguments or value: the order of stores for other invocations
  kAtomic,        // the first argument is changed in one step
  kVertices,      // the vertices or control points that the stage reads or makes
};

// The requirements that an intrinsic makes of a GLSL target.
enum class TargetGate : std::uint8_t { kNone, kBitCasts };

struct IntrinsicInfo {
  const char* name;            // HLSL's spelling
  const char* signature_text;  // as ir/intrinsics.def writes it
  IntrinsicSignature signature;
  IntrinsicCategory category;
  std::uint8_t first_model;  // the first shader model that has it, without the minor version
  TargetGate gate;
};
const IntrinsicInfo& InfoOf(Intrinsic op);

inline const char* NameOf(Intrinsic op) { return InfoOf(op).name; }
inline IntrinsicCategory CategoryOf(Intrinsic op) { return InfoOf(op).category; }
// Whether a call writes argument number `argument`, which is an lvalue then: modf(x, whole),
// sincos(x, sine, cosine), asuint(double, low, high).
bool WritesArgument(Intrinsic op, std::size_t argument);
// Whether a call writes any of its arguments.
inline bool WritesArguments(Intrinsic op) { return InfoOf(op).signature.writes; }
// What a call of a function of IntrinsicCategory::kMemory orders, and whether it waits.
struct BarrierInfo {
  bool orders_objects = false;  // stores in buffers and textures
  bool orders_shared = false;   // stores in memory that a group shares
  bool waits = false;           // for all threads of the group
};
BarrierInfo BarrierOf(Intrinsic op);
// Whether a call waits for the other threads of the group.
inline bool WaitsForGroup(Intrinsic op) {
  return CategoryOf(op) == IntrinsicCategory::kMemory && BarrierOf(op).waits;
}
// Whether a call is short for an expression of other functions and operators, which replaces it
// before Form::kLegalized, as may a helper function that returns the expression.
bool IsComposed(Intrinsic op);

}  // namespace clipc::ir
