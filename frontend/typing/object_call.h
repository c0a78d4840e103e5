// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/typing/intrinsic_call.h"

// Declarations that the files that implement CheckMethodCall and CheckObjectIndex share.
namespace clipc::typing {

// The numbers of components of the operands of a texture's operations; 0 if there is no such
// operation.
struct TextureTraits {
  int coordinates = 0;  // the place of a sample, with the element of an array
  int texel = 0;        // the place of a load, as in a sample, without level and sample number
  int size = 0;         // the size from GetDimensions, with the number of elements of an array
  int offset = 0;
  int gradient = 0;
  bool is_multisampled = false;
  bool can_gather = false;
};
// The traits of a kind of texture; zeros for an object that is not a texture.
TextureTraits TraitsOf(ObjectKind kind);
// The type that a read of the object gives: its element type, float4 if none was written.
TypeId ElementOf(TypeTable& types, const Type& object);

// The offsets in texels that a method accepts. From 5.0 on those of a Gather have six bits:
// Direct3D 11's gather4_po.
struct OffsetRange {
  int least = -8, most = 7;
  bool Has(int texel) const { return least <= texel && texel <= most; }
};
inline OffsetRange OffsetsOf(bool is_gather, const Profile& profile) {
  return is_gather && profile.IsAtLeast(5, 0) ? OffsetRange{-32, 31} : OffsetRange{};
}

// The location of a texel moved by an offset, which does not choose the layer of an array.
ExprId Moved(Builder builder, Program& program, ExprId location, ExprId offset);

// counter_call.cpp: checks Append, Consume, IncrementCounter or DecrementCounter of a structured
// buffer.
ExprId CheckCounter(const IntrinsicCheck& call, ExprId object);
// objects_size.cpp
ExprId CheckGetDimensions(const IntrinsicCheck& call, ExprId object);

}  // namespace clipc::typing
