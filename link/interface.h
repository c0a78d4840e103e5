// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/stage.h"
#include "ir/interface.h"
#include "ir/packing.h"
#include "ir/type.h"

// The other half of a program: the inputs that a pixel shader takes from a vertex shader, and the
// constant buffers that it shares with it. The readers in this folder make it of SPIR-V, GLSL and
// HLSL, and match.h compares it with the vertex shader.
namespace clipc::link {

// The most vectors of an input: a larger array has no place between two stages.
inline constexpr std::uint32_t kMaxElements = 256;

// A numeric type, or an array of one, in GLSL's words: HLSL's float3x4 has three columns of four
// components.
struct GlslType {
  ir::Scalar scalar = ir::Scalar::kFloat;  // one of BaseOf's
  std::uint8_t components = 1;             // of a vector, or of a matrix's column
  std::uint8_t columns = 1;                // of a matrix; else 1
  std::vector<std::uint32_t> dimensions;   // of an array, outermost first

  // The number of vectors in the type, at most kMaxElements + 1: each takes one location, and is
  // one output of an HLSL vertex shader.
  std::uint32_t Elements() const;
  friend bool operator==(const GlslType&, const GlslType&) = default;
};
// The type in GLSL's spelling: "mat3x4[2]".
std::string NameOf(const GlslType& type);
// GLSL's type of a numeric type, or of arrays of one; std::nullopt for any other type.
std::optional<GlslType> GlslTypeOf(const ir::TypeTable& types, ir::TypeId type);

// A block of inputs, `in Varyings { vec2 uv; } v`, or an input that is a struct.
struct Group {
  bool is_block = true;                   // else a struct
  std::string type;                       // the name of the block or the struct
  std::string instance;                   // empty: a block's members are global names
  std::optional<std::uint32_t> location;  // none if it is not given for the whole
  std::string where;
};

struct Input {
  // The name in GLSL, also when GLSL is still to be made of the shader; a member's name is without
  // its group's. Empty: unknown.
  std::string name;
  std::string semantic;  // without its index; empty: unknown
  std::uint32_t index = 0;
  std::optional<std::uint32_t> location;
  bool is_placed = false;  // of HLSL: [[vk::location]] gives the location
  GlslType type;
  ir::Interpolation interpolation = ir::Interpolation::kDefault;
  bool centroid = false;
  bool sample = false;
  bool is_read = false;
  bool is_of_patch = false;             // one for all control points
  std::uint32_t components_read = 0xF;  // bit i: component i of some element is read, if any is
  std::string where;                    // for messages: "water.frag:12"
  // The number of its group in Interface::groups. The inputs of a group are its members, all of
  // them and in order.
  std::optional<std::size_t> group = {};
  bool has_own_location = true;  // a member has a location itself, not only its group
  friend bool operator==(const Input&, const Input&) = default;
};

struct UniformMember {
  std::string name;
  std::optional<GlslType> type;       // none: a struct or an array of structs
  std::vector<UniformMember> fields;  // of that struct
  std::vector<std::uint32_t> struct_dimensions;
  std::optional<std::uint32_t> offset;  // bytes, where it is known
  ir::MatrixLayout matrices = ir::MatrixLayout::kNone;
  ir::Precision precision = ir::Precision::kHigh;
};

struct UniformBlock {
  std::string name;
  // Members are reached through the name of an instance, which GLSL lets differ between stages;
  // both stages must have one, or neither.
  bool has_instance = false;
  std::string instance;        // empty: unknown
  bool rows_on_block = false;  // `row_major` is a qualifier of the block, and not of its members
  std::vector<UniformMember> members;
  std::optional<std::uint32_t> set, binding;
  std::string where;
};

struct Interface {
  std::vector<Input> inputs;  // those that are not built in, in order of declaration
  std::vector<Group> groups;
  std::vector<UniformBlock> blocks;
  std::vector<UniformMember> uniforms;  // outside blocks
  Stage stage = Stage::kPixel;          // of the shader that reads
};

}  // namespace clipc::link
