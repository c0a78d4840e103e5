// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <initializer_list>
#include <set>
#include <string>
#include <string_view>

#include "backend-glsl/writer/context.h"

// The bindings of blocks and objects.
namespace clipc::glsl {

// The text "layout(a, b) " with the qualifiers that are not empty; empty if all are.
std::string LayoutText(std::initializer_list<std::string_view> qualifiers);

// The name of the register in Direct3D: "b2".
std::string RegisterText(const ir::Register& reg);

// The bindings of one kind in OpenGL.
struct Bindings {
  std::uint32_t end = UINT32_MAX;  // one more than the highest binding
  std::uint32_t base = 0;          // the binding of register 0
  std::set<std::uint32_t> taken = {};
  std::set<std::uint32_t> reserved = {};  // bindings that a [[vk::binding]] asks for
  void Reserve(const ir::Register& reg, std::uint32_t count);
  // Takes the bindings of a block or an object of the other stage of a pair.
  void Take(const GlslInfo::Binding& place);
};

// Decides where `place.count` blocks or objects of this register are bound: for Vulkan at the set
// and binding that are written or else follow from the register; for OpenGL at the written binding
// or else the register's number or, where that is taken or too high, at the first free one; nowhere
// where the target cannot say it or none is free.
// `written` is the place that another stage gave it; null if it is written here first.
void Bind(const WriterContext& context, GlslInfo::Binding& place, const ir::Register& reg,
          Bindings& taken, const GlslInfo::Binding* written = nullptr);

// Binds a block where another stage declares it; nowhere if that stage gives no place.
void Bind(WriterContext& context, GlslInfo::Binding& place, const ir::BlockDeclaration& declared);

// The qualifiers "set = 0, binding = 2" of a place; empty if it has neither.
std::string PlaceText(const GlslInfo::Binding& place);

}  // namespace clipc::glsl
