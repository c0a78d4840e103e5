// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/uniform.h"

#include <vector>

#include <fmt/format.h>

#include "backend-glsl/writer/expr.h"
#include "backend-glsl/writer/helper.h"
#include "backend-glsl/writer/types.h"

namespace clipc::glsl {

using namespace ir;

namespace {

// The ConstantBuffer<T> that is written with an instance name and that `expr` is, or is an element
// of; none for other expressions.
VarId InstanceOf(const Code& code, ExprId expr) {
  if (code.TypeOf(expr).kind != TypeKind::kStruct) return {};
  for (; const auto* index = code.As<Index>(expr); expr = index->base) {
    if (code.TypeOf(index->base).kind != TypeKind::kArray) return {};
  }
  const auto* ref = code.As<VarRef>(expr);
  const bool is_uniform = ref && code[ref->var].storage == Storage::kUniform;
  return is_uniform && code.LayoutOf(ref->var).fields_as_members ? ref->var : VarId{};
}

// Writes the path of a member: "frame.world", or "world" of a block without an instance name.
void WritePath(Code& code, VarId member) {
  const std::string& instance = code.names.instances[code[member].cbuffer.index];
  if (!instance.empty()) code.Put(instance, ".");
  code.Put(code.NameOf(member));
}

// The name of the function that returns the whole of an array that no variable holds.
std::string WholeArray(Code& code, VarId member) {
  const std::string name = code.Apart([&] { WritePath(code, member); });
  const TypeId type = code[member].type;
  return Helper(code, name + "_all", "", [&](const std::string& function) {
    const auto element = [&](const std::string& index) {
      return ElementText(code, code[type].element, {Concat(name, "[", index, "]")});
    };
    const std::string type_name = TypeName(code, type);
    return fmt::format("{} {}() {{\n{}}}\n", type_name, function, FilledArray(code, type, element));
  });
}

}  // namespace

Binding WriteUniform(Code& code, VarId member) {
  const Type& type = code.TypeOf(member);
  const bool is_array = type.kind == TypeKind::kArray;
  if (code.IsWrittenAsUint(member)) {
    code.Put(TypeName(code, code[member].type), "(");
    WritePath(code, member);
    code.Put(")");
  } else if (is_array && HasFields(code, type)) {
    code.Put(WholeArray(code, member), "()");
  } else {
    WritePath(code, member);
  }
  return Binding::kPostfix;
}

Binding WriteUniformElement(Code& code, VarId member, ExprId index) {
  WritePath(code, member);
  code.Put("[");
  WriteIndex(code, index);
  code.Put(IsWrapped(code, code.TypeOf(member).element) ? "].e" : "]");
  return Binding::kPostfix;
}

bool IsInstance(const Code& code, ExprId expr) { return bool(InstanceOf(code, expr)); }

std::string InstancePath(Code& code, ExprId expr) {
  return code.NameOf(InstanceOf(code, expr)) + IndexPath(code, expr);
}

Text InstanceValue(Code& code, ExprId expr) {
  const TypeId type = code[expr].type;
  const std::string type_name = TypeName(code, type);
  const auto value = [&](const std::string& block) {
    const auto field = [&](const std::string& name) { return Concat(block, ".", name); };
    return Called(type_name, {ListOf(code.names.fields[code[type].structure.index], field)});
  };
  std::vector<ExprId> indices;  // outermost first
  for (ExprId part = expr; const auto* index = code.As<Index>(part); part = index->base) {
    indices.insert(indices.begin(), index->index);
  }
  if (!indices.empty() && HasLiteralIndices(code.program, expr)) {
    return value(InstancePath(code, expr));
  }

  const std::string& name = code.NameOf(InstanceOf(code, expr));
  std::string parameters, arguments, block = name;
  bool is_marked = false;  // an index differs from vertex to vertex
  for (ExprId& index : indices) {
    const auto* mark = code.target.IsVulkan() ? code.As<IntrinsicCall>(index) : nullptr;
    const bool is_this = mark && mark->op == Intrinsic::kNonUniform;
    if (is_this) index = code[mark->arguments][0];
    is_marked = is_marked || is_this;
    const char letter = static_cast<char>('i' + (&index - indices.data()));
    const std::string parameter = Fresh(code, {&letter, 1});
    const char* separator = parameters.empty() ? "" : ", ";
    Append(parameters, separator, "int ", parameter);
    Append(arguments, separator, IntIndex(code, index));
    Append(block, is_this ? "[nonuniformEXT(" : "[", parameter, is_this ? ")]" : "]");
  }
  if (is_marked) code.Require("GL_EXT_nonuniform_qualifier");
  const std::string helper = Helper(
      code, name + (is_marked ? "_any_value" : "_value"), "", [&](const std::string& function) {
        return fmt::format("{} {}({}) {{\n    return {};\n}}\n", type_name, function, parameters,
                           value(block).text);
      });
  return Called(helper, {arguments});
}

}  // namespace clipc::glsl
