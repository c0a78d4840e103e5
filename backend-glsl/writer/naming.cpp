// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/naming.h"

#include <map>
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

void NameInputs(Context& context) {
  for (const IoVar& input : context.program.inputs) {
    if (input.builtin != Builtin::kNone) continue;
    context.var_names[input.var.index] =
        context.namer.Global(Concat("in_", ToUpper(input.semantic), std::to_string(input.index)));
  }
}

// The indices of a part of an output: "[1][2]" of column 2 of element 1.
std::string ElementOf(const Reader& reader) {
  std::string text;
  std::uint32_t element = reader.element;
  const auto lead = [&](std::uint32_t count) {
    text.insert(0, Concat("[", std::to_string(element % count), "]"));
    element /= count;
  };
  if (reader.columns > 1) lead(reader.columns);
  for (auto i = reader.dimensions.rbegin(); i != reader.dimensions.rend(); ++i) lead(*i);
  return text;
}

// Gives the blocks and structs of outputs the names that they have in the next stage.
void NameGroups(Context& context) {
  for (const OutputGroup& group : context.program.output_groups) {
    context.namer.Global(group.type);
    context.group_instances.push_back(
        group.instance.empty() ? "" : context.namer.Global(group.instance));
    if (!group.instance.empty()) continue;
    for (const OutputGroup::Member& member : group.members) context.namer.Global(member.name);
  }
}

// The name "v.uv[1]" of an output that is a member of a group.
std::string MemberName(const Context& context, const Reader& reader) {
  const std::string& instance = context.group_instances[*reader.group];
  const OutputGroup& group = context.program.output_groups[*reader.group];
  return Concat(instance, instance.empty() ? "" : ".", group.members[reader.member].name,
                ElementOf(reader));
}

// The name that the style gives an output.
std::string StyledName(const Context& context, const IoVar& output) {
  const std::string index = std::to_string(output.index), semantic = ToUpper(output.semantic);
  const std::string written = output.semantic + (output.has_index || output.index > 0 ? index : "");
  const std::string_view name = output.name.empty() ? written : output.name;
  return FillPattern(
      context.options.names.output,
      {{"semantic", semantic}, {"index", index}, {"written", written}, {"name", name}});
}

// Names the outputs that match the next stage, or the others.
void NameOutputs(Context& context, bool are_matched) {
  std::map<std::uint32_t, std::string> names;  // by location, for arrays and matrices the first
  for (const IoVar& output : context.program.outputs) {
    const auto& reader = output.reader;
    if (output.builtin != Builtin::kNone || reader.has_value() != are_matched) continue;
    if (reader && reader->group) {
      context.var_names[output.var.index] = MemberName(context, *reader);
      continue;
    }
    std::string& name = names[output.location - (reader ? reader->element : 0)];
    if (name.empty()) {
      const bool has_name = reader && !reader->name.empty();
      name = context.namer.Global(has_name ? reader->name : StyledName(context, output));
    }
    context.var_names[output.var.index] = reader ? name + ElementOf(*reader) : name;
  }
}

// The names of the members of a struct or a block: they need only differ from each other.
std::vector<std::string> FieldNames(std::vector<std::string_view> wanted) {
  std::vector<std::string> names;
  names.reserve(wanted.size());
  bool is_changed = false;
  for (const std::string_view name : wanted) {
    is_changed |= names.emplace_back(LegalFieldName(name)) != name;
  }
  if (!is_changed) {
    // A field of a struct in HLSL may have the name of a field of the struct's base.
    std::ranges::sort(wanted);
    if (std::ranges::adjacent_find(wanted) == wanted.end()) return names;
  }
  std::set<std::string> taken;
  for (std::string& name : names) {
    const std::string stem = name;
    for (int suffix = 2; !taken.insert(name).second; ++suffix) {
      name = LegalFieldName(Concat(stem, "_", std::to_string(suffix)));
    }
  }
  return names;
}

void NameMembers(Context& context, CbufferId id) {
  const Cbuffer& cbuffer = context[id];
  const BlockLayout& layout = context.layouts[id.index];
  if (layout.fields_as_members) return;
  std::vector<std::string_view> names;
  const auto& declared = cbuffer.declared;
  const bool is_named = declared && !declared->is_loose;
  for (std::size_t i = 0; is_named && i < declared->members.size(); ++i) {
    std::string& name = context.var_names[cbuffer.members[i].var.index];
    name = declared->members[i].name;
    if (!layout.has_instance) name = context.namer.Global(name);
  }
  if (is_named) return;
  for (const CbufferMember& member : cbuffer.members) {
    const bool is_declared = layout.form != BlockForm::kUniforms || context.reached.Has(member.var);
    if (layout.has_instance) {
      names.push_back(context[member.var].name);
    } else if (is_declared) {
      NameGlobal(context, member.var);
    }
  }
  if (!layout.has_instance) return;
  std::vector<std::string> fields = FieldNames(std::move(names));
  for (std::size_t i = 0; i < fields.size(); ++i) {
    context.var_names[cbuffer.members[i].var.index] = std::move(fields[i]);
  }
}

void NameBlock(Context& context, CbufferId id) {
  const Cbuffer& cbuffer = context[id];
  const BlockLayout& layout = context.layouts[id.index];
  const NameStyle& style = context.options.names;
  std::string& name = context.block_names[id.index];
  if (cbuffer.declared && !cbuffer.declared->name.empty()) {
    name = cbuffer.declared->name;
    context.namer.Global(name);
    return;
  }
  if (cbuffer.kind == CbufferKind::kConstantBuffer) {
    const TypeId type = context.types.Innermost(context[cbuffer.members[0].var].type);
    name = FillPattern(style.constant_buffer,
                       {{"name", cbuffer.name}, {"type", context.types.StructOf(type).name}});
  } else if (cbuffer.kind == CbufferKind::kGlobals) {
    name = style.globals;
  } else {
    name = FillPattern(style.block, {{"name", cbuffer.name}});
  }
  name = context.namer.Global(name, "block");
  if (layout.form == BlockForm::kRows) {
    const bool is_block = context.Has(Feature::kUniformBlocks);
    context.rows_names[id.index] = is_block ? context.namer.Global(cbuffer.name + "_rows") : name;
  }
}

void NameUniforms(Context& context) {
  std::vector<CbufferId> blocks;
  for (const CbufferId id : context.program.cbuffers.ids()) {
    if (!context.reached.Has(id)) continue;
    NameMembers(context, id);
    if (context.layouts[id.index].form != BlockForm::kUniforms) blocks.push_back(id);
  }
  for (const CbufferId id : blocks) NameBlock(context, id);
  for (const Resource& resource : context.program.resources) {
    if (context.reached.Has(resource.var)) NameGlobal(context, resource.var);
  }
  // The host does not see the names of instances. A ConstantBuffer<T> has the name of its variable.
  for (const CbufferId id : blocks) {
    const BlockLayout& layout = context.layouts[id.index];
    if (layout.fields_as_members) NameGlobal(context, context[id].members[0].var);
    if (!layout.has_instance || layout.fields_as_members) continue;
    const auto& declared = context[id].declared;
    context.instance_names[id.index] = context.namer.Global(
        declared ? declared->instance : InstanceName(LegalName(context[id].name, "block")));
  }
}

void NameStruct(Context& context, StructId id) {
  const Struct& structure = context.types[id];
  context.struct_names[id.index] = context.namer.Global(structure.name, "Unnamed");
  std::vector<std::string_view> names;
  names.reserve(structure.fields.size());
  for (const Field& field : structure.fields) names.push_back(field.name);
  context.field_names[id.index] = FieldNames(std::move(names));
}

// Names the functions. Overloads share a name as long as GLSL can tell them apart: half and float
// are the same there.
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
  context.instance_names.resize(program.cbuffers.size());
  NameGroups(context);
  NameOutputs(context, true);  // first, since the next stage may know them by name only
  NameInputs(context);
  NameOutputs(context, false);
  NameUniforms(context);
  for (const StructId id : context.types.structs().ids()) NameStruct(context, id);
  for (const VarId global : context.reached.globals) NameGlobal(context, global);
  NameFunctions(context);
}

}  // namespace clipc::glsl
