// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>

#include "frontend/rules/intrinsic_call.h"

// What the files behind CheckMethodCall and CheckObjectIndex share.
namespace clipc {

// How many components the operations of a texture take. A zero means that there is no such
// operation.
struct TextureTraits {
  std::uint8_t coordinates = 0;  // of a sample, array element included; 0: cannot be sampled
  std::uint8_t texel = 0;        // of a load, array element included, without level or sample
  std::uint8_t size = 0;         // what GetDimensions tells, without levels or samples
  std::uint8_t offset = 0;
  std::uint8_t gradient = 0;
  bool is_multisampled = false;
  bool can_gather = false;
};
bool IsTexture(ir::ObjectKind kind);
TextureTraits TraitsOf(ir::ObjectKind kind);
// What a read of the object gives: its element type, float4 when none was written.
ir::TypeId ElementOf(ir::TypeTable& types, const ir::Type& object);

ir::ExprId MakeObjectCall(ir::Builder builder, ir::Program& program, ir::TypeId type,
                          ir::ObjectOp op, std::span<const ir::ExprId> arguments);

// objects_size.cpp
ir::ExprId CheckGetDimensions(const IntrinsicCheck& call, ir::ExprId object);

}  // namespace clipc
