// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/uniform.h"

#include "backend-glsl/writer/expr.h"
#include "backend-glsl/writer/types.h"

namespace clipc::glsl {

using namespace ir;

namespace {

// Writes the path of a member: "frame.world", or "world" of a block without an instance name.
void WritePath(Code& code, VarId member) {
  const std::string& instance = code.names.instances[code[member].cbuffer.index];
  if (!instance.empty()) code.Put(instance, ".");
  code.Put(code.NameOf(member));
}

}  // namespace

Binding WriteUniform(Code& code, VarId member) {
  const bool is_uint = code.IsWrittenAsUint(member);
  if (is_uint) code.Put(TypeName(code, code[member].type), "(");
  WritePath(code, member);
  if (is_uint) code.Put(")");
  return Binding::kPostfix;
}

Binding WriteUniformElement(Code& code, VarId member, ExprId index) {
  WritePath(code, member);
  code.Put("[");
  WriteIndex(code, index);
  code.Put(IsWrapped(code, code.TypeOf(member).element) ? "].e" : "]");
  return Binding::kPostfix;
}

}  // namespace clipc::glsl
