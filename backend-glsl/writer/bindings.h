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

// The bindings of one kind that are taken.
using Bindings = std::set<std::uint32_t>;

// Decides where `count` blocks or objects of this register are bound: for Vulkan at the register's
// set and binding, else at the register's number or, where that is taken, at the first free one.
// Returns the qualifiers that say so, none where the target cannot say it.
std::string Bind(const Context& context, GlslInfo::Place& place, const ir::Register& reg,
                 Bindings& taken, std::uint32_t count);

// Binds a block where another stage declares it; returns the qualifiers that say so.
std::string Bind(const Context& context, GlslInfo::Place& place,
                 const ir::BlockDeclaration& declared);

}  // namespace clipc::glsl
