// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/vulkan/opengl_text.h"

#include <algorithm>

#include <spirv_cross/spirv_glsl.hpp>

namespace clipc::draw {
namespace {

using namespace ir;

// Whether there is a struct with a matrix in the type: SPIRV-Cross gives all matrices of a struct
// the order of one of them.
bool HasMatrixInStruct(const TypeTable& types, TypeId id) {
  const TypeId inner = types.Innermost(id);
  if (types[inner].kind != TypeKind::kStruct) return false;
  return std::ranges::any_of(types.StructOf(inner).fields, [&](const Field& field) {
    return types[types.Innermost(field.type)].kind == TypeKind::kMatrix ||
           HasMatrixInStruct(types, field.type);
  });
}

// Whether SPIRV-Cross's GLSL is what the module means: it has the entry point's name for another
// function, loses the names of arrays of blocks, and knows no places of 64 bits.
bool IsForSpirvCross(const Program& program) {
  for (const CbufferId id : program.cbuffers.ids()) {
    const Cbuffer& cbuffer = program.cbuffers[id];
    if (cbuffer.count != 1) return false;
    for (const CbufferMember& member : cbuffer.members)
      if (HasMatrixInStruct(program.types, program.vars[member.var].type)) return false;
  }
  for (const FunctionId id : program.functions.ids())
    if (id != program.main && program.functions[id].name == "main") return false;
  for (const ExprId id : program.exprs.ids()) {
    const Type& type = program.types[program.exprs[id].type];
    if (type.IsNumeric() && IsWide(type.scalar)) return false;
  }
  return true;
}

// The text with Direct3D's origin of pixels, which SPIRV-Cross leaves out.
std::string WithOrigin(std::string text, const Shader& shader) {
  const bool reads = std::ranges::any_of(shader.lowered.inputs, [](const IoVar& input) {
    return input.builtin == Builtin::kPixelPosition;
  });
  if (reads && !shader.flips_y)
    text.insert(text.find('\n') + 1, "layout(origin_upper_left) in vec4 gl_FragCoord;\n");
  return text;
}

}  // namespace

std::string GlslOfSpirv(const Shader& shader) {
  constexpr int kVersion = 450;
  if (!shader.glsl.starts_with("#version " + std::to_string(kVersion))) return "";
  if (shader.spirv.empty() || !IsForSpirvCross(shader.lowered)) return "";
  try {
    spirv_cross::CompilerGLSL compiler(shader.spirv);
    spirv_cross::CompilerGLSL::Options options;
    options.version = kVersion;
    compiler.set_common_options(options);
    return WithOrigin(compiler.compile(), shader);
  } catch (const spirv_cross::CompilerError&) {
    return "";  // GLSL has no block with members at such places
  }
}

}  // namespace clipc::draw
