// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/naming.h"

#include <set>
#include <string_view>

#include "backend-glsl/text.h"
#include "backend-glsl/writer/types.h"
#include "base/spelling.h"

namespace clipc::glsl {

using namespace ir;

namespace {

void NameGlobal(Context& context, VarId var) {
  context.var_names[var.index] = context.namer.Global(context[var].name);
}

// Semantics compare without case, and stages meet by name: one spelling for all.
void NameInterface(Context& context, const std::vector<IoVar>& variables, const char* prefix) {
  for (const IoVar& io : variables) {
    if (io.builtin != Builtin::kNone) continue;
    context.var_names[io.var.index] =
        context.namer.Global(prefix + ToUpper(io.semantic) + std::to_string(io.index));
  }
}

void NameUniforms(Context& context) {
  const Program& program = context.program;
  for (const CbufferId id : program.cbuffers.ids()) {
    if (!context.reached.Has(id)) continue;
    const bool are_uniforms = context.layouts[id.index].form == BlockForm::kUniforms;
    for (const CbufferMember& member : context[id].members) {
      if (!are_uniforms || context.reached.Has(member.var)) NameGlobal(context, member.var);
    }
  }
  for (const CbufferId id : program.cbuffers.ids()) {
    const Cbuffer& cbuffer = context[id];
    const BlockForm form = context.layouts[id.index].form;
    if (!context.reached.Has(id) || form == BlockForm::kUniforms) continue;
    // A ConstantBuffer<T> is called as its variable, which has the name already.
    const bool is_constant_buffer = cbuffer.kind == CbufferKind::kConstantBuffer;
    context.block_names[id.index] =
        context.namer.Global(cbuffer.name + (is_constant_buffer ? "_block" : ""), "block");
    if (form == BlockForm::kRows)
      context.rows_names[id.index] = context.namer.Global(cbuffer.name + "_rows");
  }
  for (const Resource& resource : program.resources) {
    if (context.reached.Has(resource.var)) NameGlobal(context, resource.var);
  }
}

void NameStruct(Context& context, StructId id) {
  const Struct& structure = context.types[id];
  context.struct_names[id.index] = context.namer.Global(structure.name, "Unnamed");
  std::vector<std::string>& names = context.field_names[id.index];
  bool is_changed = false;
  for (const Field& field : structure.fields) {
    is_changed |= names.emplace_back(LegalFieldName(field.name)) != field.name;
  }
  if (!is_changed) return;  // so they differ, as they do in HLSL
  std::set<std::string> taken;
  for (std::size_t i = 0; i < names.size(); ++i) {
    for (int suffix = 2; !taken.insert(names[i]).second; ++suffix) {
      names[i] = LegalFieldName(Concat(structure.fields[i].name, "_", std::to_string(suffix)));
    }
  }
}

// Overloads share a name as long as GLSL can tell them apart: half and float are the same there.
void NameFunctions(Context& context) {
  std::unordered_map<std::string_view, int> counts;
  for (const FunctionId id : context.reached.functions) ++counts[context[id].name];
  std::unordered_map<std::string_view, std::string> shared;
  std::set<std::string> taken;
  for (const FunctionId id : context.reached.functions) {
    const Function& function = context[id];
    std::string& name = context.function_names[id.index];
    if (id == context.program.main) {
      name = "main";
      continue;
    }
    const bool is_overloaded = counts[function.name] > 1;
    const bool is_new_signature =
        is_overloaded && taken.insert(function.name + "(" + ParameterTypes(context, id)).second;
    if (const auto found = shared.find(function.name); found != shared.end() && is_new_signature) {
      name = found->second;
    } else {
      const bool is_main = function.name == "main";
      name = context.namer.Global(is_main ? "shader_main" : function.name, "function");
      shared.try_emplace(function.name, name);
    }
  }
}

}  // namespace

void NameEverything(Context& context) {
  const Program& program = context.program;
  context.var_names.resize(program.vars.size());
  context.function_names.resize(program.functions.size());
  context.struct_names.resize(context.types.structs().size());
  context.field_names.resize(context.types.structs().size());
  context.block_names.resize(program.cbuffers.size());
  context.rows_names.resize(program.cbuffers.size());
  NameInterface(context, program.inputs, "in_");
  NameInterface(context, program.outputs, "vs_");
  NameUniforms(context);
  for (const StructId id : context.types.structs().ids()) NameStruct(context, id);
  for (const VarId global : context.reached.globals) NameGlobal(context, global);
  NameFunctions(context);
}

}  // namespace clipc::glsl
