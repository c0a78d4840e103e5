// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "backend-glsl/target.h"

// The options that say where a Vulkan shader's buffers and objects are bound. Their values are
// words apart by one blank; a function returns false for a value that its option does not accept.
namespace clipc {

// The words of an option's value, which one blank separates.
std::vector<std::string_view> WordsIn(std::string_view text);

// Whether the text is a whole number and nothing else. If so, sets `to` to the number.
bool ReadNumber(std::string_view text, std::uint32_t& to);

// Reads the value of -fvk-b-shift: "2 0" or "2 all".
bool AddShift(char letter, glsl::BindingRules& rules, std::string_view value);
template <char kLetter>
bool AddShift(glsl::BindingRules& rules, std::string_view value) {
  return AddShift(kLetter, rules, value);
}
// Whether registers of buffers and objects begin with the letter.
constexpr bool IsRegisterLetter(char letter) {
  return std::string_view("bstu").find(letter) != std::string_view::npos;
}
// Reads the value of glslang's --shift-ubo-binding: "2", or with sets "2 0 5 1"; either after the
// stage that it is for, "vert 2".
bool AddKindShift(char letter, glsl::BindingRules& rules, std::string_view value);
template <char kLetter>
bool AddKindShift(glsl::BindingRules& rules, std::string_view value) {
  return AddKindShift(kLetter, rules, value);
}
// Reads the value of -fvk-bind-register: "b3 0 7 1", the register, its space, the binding and the
// set.
bool AddRegister(glsl::BindingRules& rules, std::string_view value);
// Reads the value of glslang's --resource-set-binding: registers, each with its set and its
// binding, "t0 1 2 s0 1 3"; after the stage that it is for, if any.
bool AddRegisters(glsl::BindingRules& rules, std::string_view value);
// Gives each sampler the place of the texture of the same number, where the host has one combined
// image sampler for the two.
void JoinSamplers(glsl::BindingRules& rules);
// Reads the value of -fvk-bind-globals: "7 1", the binding and the set.
bool SetGlobals(glsl::BindingRules& rules, std::string_view value);
// Reads the value of -auto-binding-space: "2", the set of objects without a register.
bool SetUnplaced(glsl::BindingRules& rules, std::string_view value);
// Reads the value of --pixel-bindings: what is added to the bindings of a shader that is compiled
// alone and has a stage before it.
bool SetLaterBase(glsl::BindingRules& rules, std::string_view value);
// Reads the value of --bindings: the name of a compiler or an engine.
bool AddPreset(glsl::BindingRules& rules, std::string_view value);

}  // namespace clipc
