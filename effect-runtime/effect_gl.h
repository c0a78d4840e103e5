// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>

#include "../runtime/gl/functions.h"
#include "effect.h"

// The OpenGL functions that effects need, and the states of a pass. Private to effect.cpp and
// effect_states.cpp.
namespace clipc::runtime::gl {

// X(type of the result, name, arguments): functions of OpenGL 3.3 and OpenGL ES 3.0.
#define CLIPC_GL_EFFECT_FUNCTIONS(X)                                               \
  X(unsigned, CreateShader, (unsigned))                                            \
  X(void, ShaderSource, (unsigned, int, const char* const*, const int*))           \
  X(void, CompileShader, (unsigned))                                               \
  X(void, GetShaderiv, (unsigned, unsigned, int*))                                 \
  X(void, GetShaderInfoLog, (unsigned, int, int*, char*))                          \
  X(void, DeleteShader, (unsigned))                                                \
  X(unsigned, CreateProgram, ())                                                   \
  X(void, AttachShader, (unsigned, unsigned))                                      \
  X(void, LinkProgram, (unsigned))                                                 \
  X(void, GetProgramiv, (unsigned, unsigned, int*))                                \
  X(void, GetProgramInfoLog, (unsigned, int, int*, char*))                         \
  X(void, DeleteProgram, (unsigned))                                               \
  X(void, UseProgram, (unsigned))                                                  \
  X(int, GetUniformLocation, (unsigned, const char*))                              \
  X(void, Uniform1i, (int, int))                                                   \
  X(unsigned, GetUniformBlockIndex, (unsigned, const char*))                       \
  X(void, UniformBlockBinding, (unsigned, unsigned, unsigned))                     \
  X(void, GenBuffers, (int, unsigned*))                                            \
  X(void, DeleteBuffers, (int, const unsigned*))                                   \
  X(void, BindBuffer, (unsigned, unsigned))                                        \
  X(void, BufferData, (unsigned, std::ptrdiff_t, const void*, unsigned))           \
  X(void, BindBufferBase, (unsigned, unsigned, unsigned))                          \
  X(void, GenSamplers, (int, unsigned*))                                           \
  X(void, DeleteSamplers, (int, const unsigned*))                                  \
  X(void, SamplerParameteri, (unsigned, unsigned, int))                            \
  X(void, SamplerParameterf, (unsigned, unsigned, float))                          \
  X(void, SamplerParameterfv, (unsigned, unsigned, const float*))                  \
  X(void, BindSampler, (unsigned, unsigned))                                       \
  X(void, ActiveTexture, (unsigned))                                               \
  X(void, BindTexture, (unsigned, unsigned))                                       \
  X(void, DepthMask, (unsigned char))                                              \
  X(void, DepthFunc, (unsigned))                                                   \
  X(void, CullFace, (unsigned))                                                    \
  X(void, FrontFace, (unsigned))                                                   \
  X(void, PolygonOffset, (float, float))                                           \
  X(void, BlendFuncSeparate, (unsigned, unsigned, unsigned, unsigned))             \
  X(void, BlendEquationSeparate, (unsigned, unsigned))                             \
  X(void, BlendColor, (float, float, float, float))                                \
  X(void, ColorMask, (unsigned char, unsigned char, unsigned char, unsigned char)) \
  X(void, StencilFuncSeparate, (unsigned, unsigned, int, unsigned))                \
  X(void, StencilOpSeparate, (unsigned, unsigned, unsigned, unsigned))             \
  X(void, StencilMask, (unsigned))

// Functions that OpenGL ES 3.0 lacks: null there, and what they would set is Direct3D's default.
#define CLIPC_GL_EFFECT_EXTRAS(X)            \
  X(void, PolygonMode, (unsigned, unsigned)) \
  X(void, SampleMaski, (unsigned, unsigned)) \
  X(void, ColorMaski, (unsigned, unsigned char, unsigned char, unsigned char, unsigned char))

// NOLINTBEGIN(readability-identifier-naming): named as OpenGL names them.
struct EffectFunctions {
  Functions basic;
#define CLIPC_GL_DECLARE(result, name, arguments) result(CLIPC_GL_API* name) arguments = nullptr;
  CLIPC_GL_EFFECT_FUNCTIONS(CLIPC_GL_DECLARE)
  CLIPC_GL_EFFECT_EXTRAS(CLIPC_GL_DECLARE)
#undef CLIPC_GL_DECLARE
  bool is_es = false;
};

// NOLINTEND(readability-identifier-naming)

// Errors: those of LoadFunctions, and kDeviceFailed with the name of a function that is missing.
Result<EffectFunctions> LoadEffectFunctions(Loader loader) noexcept;

// Makes the states of OpenGL those of the pass, over Direct3D's defaults. Returns the mask of clip
// planes that its states ask for.
std::uint32_t ApplyStates(const EffectFunctions& gl, const clipc_gl_effect_state* states,
                          std::uint32_t count) noexcept;

}  // namespace clipc::runtime::gl
