// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>

#include "backend-glsl/writer.h"

namespace clipc::glsl {

using namespace ir;

namespace {

// Semantics compare without case, and stages meet by name: one spelling for all.
std::string UpperCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  return text;
}

}  // namespace

// The names that the host sees come first and so keep their spelling; locals are named when they
// are declared.
void Writer::NameEverything() {
  var_names_.resize(program_.vars.size());
  function_names_.resize(program_.functions.size());
  struct_names_.resize(program_.types.structs().size());
  field_names_.resize(program_.types.structs().size());
  block_names_.resize(program_.cbuffers.size());
  rows_names_.resize(program_.cbuffers.size());
  NameInterface();
  NameUniforms();
  NameStructs();
  for (VarId global : reached_.globals) {
    var_names_[global.index] = namer_.Global(program_.vars[global].name);
  }
  NameFunctions();
}

void Writer::NameInterface() {
  const auto name = [&](const IoVar& io, const char* prefix) {
    if (io.builtin != Builtin::kNone) return;
    var_names_[io.var.index] =
        namer_.Global(prefix + UpperCase(io.semantic) + std::to_string(io.index));
  };
  for (const IoVar& input : program_.inputs) name(input, "in_");
  for (const IoVar& output : program_.outputs) name(output, "vs_");
}

void Writer::NameUniforms() {
  for (CbufferId id : program_.cbuffers.ids()) {
    if (!reached_.Has(id)) continue;
    for (const CbufferMember& member : program_.cbuffers[id].members) {
      const bool is_uniform_variable = layouts_[id.index].form == BlockForm::kUniforms;
      if (is_uniform_variable && !reached_.Has(member.var)) continue;
      var_names_[member.var.index] = namer_.Global(program_.vars[member.var].name);
    }
  }
  for (CbufferId id : program_.cbuffers.ids()) {
    const Cbuffer& cbuffer = program_.cbuffers[id];
    const BlockLayout& layout = layouts_[id.index];
    if (!reached_.Has(id) || layout.form == BlockForm::kUniforms) continue;
    // A ConstantBuffer<T> is called as its variable, which has the name already.
    const bool is_constant_buffer = cbuffer.kind == CbufferKind::kConstantBuffer;
    block_names_[id.index] =
        namer_.Global(cbuffer.name + (is_constant_buffer ? "_block" : ""), "block");
    if (layout.form == BlockForm::kRows)
      rows_names_[id.index] = namer_.Global(cbuffer.name + "_rows");
  }
  for (const Resource& resource : program_.resources) {
    if (reached_.Has(resource.var)) {
      var_names_[resource.var.index] = namer_.Global(program_.vars[resource.var].name);
    }
  }
}

void Writer::NameStructs() {
  for (StructId id : program_.types.structs().ids()) {
    const Struct& structure = program_.types[id];
    struct_names_[id.index] = namer_.Global(structure.name, "Unnamed");
    std::vector<std::string>& names = field_names_[id.index];
    bool is_changed = false;
    for (const Field& field : structure.fields) {
      is_changed |= names.emplace_back(LegalFieldName(field.name)) != field.name;
    }
    if (!is_changed) continue;  // so they differ, as they do in HLSL
    std::set<std::string> taken;
    for (std::size_t i = 0; i < names.size(); ++i) {
      for (int suffix = 2; !taken.insert(names[i]).second; ++suffix) {
        names[i] = LegalFieldName(structure.fields[i].name + "_" + std::to_string(suffix));
      }
    }
  }
}

std::string Writer::OverloadKey(const Function& function) {
  std::string key = function.name + "(";
  for (VarId parameter : function.parameters) key += TypeName(program_.vars[parameter].type) + ",";
  return key;
}

// Overloads share a name as long as GLSL can tell them apart: half and float are the same there.
void Writer::NameFunctions() {
  std::unordered_map<std::string_view, int> counts;
  for (FunctionId id : reached_.functions) ++counts[program_.functions[id].name];
  std::unordered_map<std::string_view, std::string> shared;
  std::set<std::string> taken;
  for (FunctionId id : reached_.functions) {
    const Function& function = program_.functions[id];
    if (id == program_.main) {
      function_names_[id.index] = "main";
      continue;
    }
    std::string wanted = function.name;
    if (wanted == "main") wanted = "shader_main";
    const bool is_overloaded = counts[function.name] > 1;
    const bool is_new_signature = is_overloaded && taken.insert(OverloadKey(function)).second;
    if (auto found = shared.find(function.name); found != shared.end() && is_new_signature) {
      function_names_[id.index] = found->second;
    } else {
      function_names_[id.index] = namer_.Global(wanted, "function");
      shared.try_emplace(function.name, function_names_[id.index]);
    }
  }
}

}  // namespace clipc::glsl
