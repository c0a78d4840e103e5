// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "backend-glsl/block_layout.h"
#include "ir/program.h"

namespace clipc::glsl {

// The facts that the host must know about the written shader: the names, places and layouts that
// were chosen.
struct GlslInfo {
  struct Variable {
    std::string name;  // of the whole path: "gl_Position", "in_POSITION0"
    std::optional<std::uint32_t>
        location;  // as written in the shader; none: linked or bound by name
    // The value differs from Direct3D's unless the host draws with base vertex (base instance) 0:
    // none is subtracted.
    bool needs_base_vertex_zero = false, needs_base_instance_zero = false;
    // The input is an integer in HLSL and a float attribute here: GLSL 1.20 and GLSL ES 1.00 have
    // no other attributes.
    bool integer_as_float = false;
    // The shader reads the input, and so declares it. An input that is not read keeps its location,
    // so that the same vertex layout fits.
    bool is_used = true;
    friend bool operator==(const Variable&, const Variable&) = default;
  };
  struct UniformMember {
    ir::VarId var;
    int field = -1;  // of a ConstantBuffer<T> with an instance name: the field of T
    // The name by which the host asks for the member: "world"; "Camera.view" of a block `Camera`
    // with an instance name; for kRows the accessor. Of a member that is read by hand: what has
    // its first byte, "Frame.light_x" or the array of rows "Frame.light_rows".
    std::string name;
    bool is_uniform = false;  // it is a uniform variable of its own
    // The argument `transpose` of glUniformMatrix for such a variable, when the host hands it the
    // bytes of the HLSL buffer.
    bool transpose = false;
    std::string function = {};                     // kStd140: the one that reads a member by hand
    std::optional<std::uint32_t> rows_begin = {};  // the first byte of the rows, if `name` is rows

    // The name of what has the buffer's byte `offset`, which is in the member.
    std::string NameAt(std::uint32_t offset) const {
      return rows_begin ? name + "[" + std::to_string((offset - *rows_begin) / kRow) + "]" : name;
    }
    friend bool operator==(const UniformMember&, const UniformMember&) = default;
  };
  // The place where the host binds a block or an object; without a binding, the host finds it by
  // name.
  struct Binding {
    std::optional<std::uint32_t> set, binding;
    std::uint32_t count = 1;  // of an array: so many bindings of OpenGL from `binding` on
    friend bool operator==(const Binding&, const Binding&) = default;
  };
  struct UniformBlock : Binding {
    ir::CbufferId cbuffer;
    BlockForm form = BlockForm::kStd140;
    std::string name;               // of the block; empty where there is none
    std::string instance;           // empty: members are global names
    std::string rows;               // kRows: the array of rows
    bool is_push_constant = false;  // a push constant of Vulkan: no buffer is bound
    bool is_shared = false;         // the other stage of a pair has the block too
    std::vector<UniformMember> members;
    friend bool operator==(const UniformBlock&, const UniformBlock&) = default;
  };
  // A texture, a sampler, a texture with a sampler, or a buffer.
  struct Object : Binding {
    ir::VarId texture, sampler;  // of the HLSL shader; either may be none
    std::string name;
    ir::ObjectKind kind =
        ir::ObjectKind::kOther;  // of the texture; of the sampler if there is none
    friend bool operator==(const Object&, const Object&) = default;
  };

  std::vector<Variable> inputs, outputs;  // beside program.inputs and program.outputs, one for one
  std::vector<UniformBlock> blocks;       // reached ones, in order of declaration
  std::vector<Object> objects;
  std::uint32_t clip_distance_mask = 0;  // bit i: gl_ClipDistance[i] is written
  std::uint32_t cull_distance_mask = 0;
  // The uniform of a float that the host sets to the height of the framebuffer in pixels; empty:
  // the shader has none.
  std::string framebuffer_height;

  // The block of a cbuffer; null if the shader does not reach the cbuffer.
  const UniformBlock* BlockOf(ir::CbufferId cbuffer) const {
    const auto found = std::ranges::find(blocks, cbuffer, &UniformBlock::cbuffer);
    return found == blocks.end() ? nullptr : &*found;
  }
  friend bool operator==(const GlslInfo&, const GlslInfo&) = default;
};

}  // namespace clipc::glsl
