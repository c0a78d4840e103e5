// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/rules/intrinsic_call.h"

// The files that implement CheckMethodCall and CheckObjectIndex share these.
namespace clipc::rules {

// How many components the operands of a texture's operations have; 0: there is no such operation.
struct TextureTraits {
  int coordinates = 0;  // of a sample, with the element of an array of textures
  int texel = 0;        // of a load, with the element of an array, without level and sample
  int size = 0;         // that GetDimensions gives, with the elements of an array
  int offset = 0;
  int gradient = 0;
  bool is_multisampled = false;
  bool can_gather = false;
};
// Zeros for an object that is not a texture.
TextureTraits TraitsOf(ObjectKind kind);
// What a read of the object gives: its element type, float4 when none was written.
TypeId ElementOf(TypeTable& types, const Type& object);

ExprId MakeObjectCall(Builder builder, Program& program, TypeId type, ObjectOp op,
                      std::span<const ExprId> arguments);

// objects_size.cpp
ExprId CheckGetDimensions(const IntrinsicCheck& call, ExprId object);

}  // namespace clipc::rules
