// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string_view>
#include <vector>

#include "compiler/command/command_line.h"
#include "frontend/parse/effect.h"

// The effects of frameworks that are not Direct3D's: docs/effects.md.
namespace clipc {

// The dialect that the text of an effect shows without a doubt: OBS Studio's names of shaders in a
// pass, or a shader of profile 4.0 or later in a `technique`, which Direct3D has in `technique10`
// and MonoGame in `technique`.
EffectDialect DialectOf(const ast::Effect& effect);

// The names that only the dialect has of the states that give a pass its shaders.
std::vector<std::string_view> ShaderNames(EffectDialect dialect);

// Adds what every effect of the dialect is read with: macros for OBS Studio's words, fxc's
// backwards compatibility for MonoGame; and OBS Studio's form of GLSL where no target is named.
void UseDialect(EffectDialect dialect, CommandLine& command);

// Makes an effect that was read with OBS Studio's macros one of Direct3D: its shaders, and the
// values of its samplers.
void ReadObs(ast::Effect& effect);

}  // namespace clipc
