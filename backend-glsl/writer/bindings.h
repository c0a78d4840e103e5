// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <initializer_list>
#include <set>
#include <string>
#include <string_view>

#include "backend-glsl/writer/context.h"

// Where blocks and objects are bound.
namespace clipc::glsl {

// layout(a, b) and a space, of those that are not empty; nothing when all are.
std::string LayoutText(std::initializer_list<std::string_view> qualifiers);

// "b2": where Direct3D finds it.
std::string RegisterText(const ir::Register& reg);

// The bindings of one kind in OpenGL.
struct Bindings {
  std::uint32_t end = UINT32_MAX;  // one more than the highest
  std::set<std::uint32_t> taken = {};
  std::set<std::uint32_t> reserved = {};  // for those that have a [[vk::binding]]
  void Reserve(const ir::Register& reg, std::uint32_t count);
};

// Decides where `count` blocks or objects of this register are bound: for Vulkan at the set and
// binding that are written or else follow from the register; for OpenGL at the written binding or
// else the register's number or, where that is taken or too high, at the first free one. Returns
// the qualifiers that say so, none where the target cannot say it or none is free.
std::string Bind(const Context& context, GlslInfo::Place& place, const ir::Register& reg,
                 Bindings& taken, std::uint32_t count);

// Binds a block where another stage declares it; returns the qualifiers that say so.
std::string Bind(const Context& context, GlslInfo::Place& place,
                 const ir::BlockDeclaration& declared);

}  // namespace clipc::glsl
