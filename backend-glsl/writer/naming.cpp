// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/naming.h"

#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "backend-glsl/requirements.h"
#include "backend-glsl/text.h"
#include "backend-glsl/writer/interface.h"
#include "backend-glsl/writer/outputs.h"
#include "backend-glsl/writer/types.h"
#include "base/spelling.h"

namespace clipc::glsl {

using namespace ir;

namespace {

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

// The giver of names, which takes them from the context's namer.
class Naming {
 public:
  explicit Naming(WriterContext& context) : context_(context), namer_(context.namer) {
    const Program& program = context.program;
    names_.vars.resize(program.vars.size());
    is_given_.resize(program.vars.size());
    names_.attributes.resize(program.inputs.size());
    names_.structs.resize(context.types.structs().size());
    names_.blocks.resize(program.cbuffers.size());
    names_.rows.resize(program.cbuffers.size());
    names_.paddings.resize(program.cbuffers.size());
    names_.instances.resize(program.cbuffers.size());
  }

  Names Run() {
    OtherNames();
    Groups();
    OutputsOf(true);  // first, since the next stage may know them by name only
    Inputs();
    OutputsOf(false);
    Uniforms();
    for (const StructId id : context_.types.structs().ids()) OfStruct(id);
    for (const VarId global : context_.reached.globals) Global(global);
    return std::move(names_);
  }

 private:
  // Keeps the names of blocks, uniform variables and objects that the stages laid out before have:
  // in a program one name is one variable. What stages share has the same name in all of them.
  void OtherNames() {
    std::set<std::string> kept;
    const auto keep = [&](const std::string& name) {
      if (!name.empty() && kept.insert(name).second) namer_.Global(name);
    };
    for (const OtherStage& other : context_.others) {
      if (!other.laid) continue;
      for (const GlslInfo::UniformBlock& block : other.laid->blocks) {
        keep(block.name);
        keep(block.rows);
        for (const GlslInfo::UniformMember& member : block.members) {
          if (IsGlobal(block, member)) keep(member.name);
        }
      }
      for (const GlslInfo::Object& object : other.laid->objects) keep(object.name);
      for (const CbufferId id : context_.program.cbuffers.ids()) GiveMembers(id, other);
    }
    for (const Resource& resource : context_.program.resources) {
      if (const auto* texture = context_.LaidObject(resource.var, {}))
        Give(resource.var, texture->name);
      else if (const auto* sampler = context_.LaidObject({}, resource.var))
        Give(resource.var, sampler->name);
    }
  }

  // Gives the members of a block that another stage shares the names that they have there.
  void GiveMembers(CbufferId id, const OtherStage& other) {
    const CbufferId theirs = other.cbuffers[id.index];
    const GlslInfo::UniformBlock* block = theirs ? other.laid->BlockOf(theirs) : nullptr;
    if (!block) return;
    for (const CbufferMember& member : context_[id].members) {
      for (const GlslInfo::UniformMember& laid : block->members) {
        if (laid.var == other.vars[member.var.index] && IsGlobal(*block, laid))
          Give(member.var, laid.name);
      }
    }
  }

  // Whether the name of the member is one of the whole program.
  static bool IsGlobal(const GlslInfo::UniformBlock& block, const GlslInfo::UniformMember& member) {
    return member.name.find('.') == std::string::npos && member.function.empty() &&
           (block.form != BlockForm::kRows || member.is_uniform);
  }

  // Gives the variable the name that it has in another stage.
  void Give(VarId var, const std::string& name) {
    names_.vars[var.index] = name;
    is_given_[var.index] = true;
  }

  void Global(VarId var) {
    if (!is_given_[var.index]) names_.vars[var.index] = namer_.Global(context_[var].name);
  }

  void Inputs() {
    const bool has_stage_before = InfoOf(context_.program.stage).has_stage_before;
    for (std::size_t i = 0; i < context_.program.inputs.size(); ++i) {
      const IoVar& input = context_.program.inputs[i];
      if (input.builtin == Builtin::kNone) {
        // The outputs of the stage before have the same names.
        names_.attributes[i] =
            !has_stage_before
                ? namer_.Global(Concat("in_", ToUpper(input.semantic), std::to_string(input.index)))
            : input.reader ? ReadName(input)
                           : namer_.Global(StyledName(input));
      }
      if (NeedsFramebufferHeight(context_.program, context_.target, input))
        names_.framebuffer_height = namer_.Global(kFramebufferHeight);
      names_.vars[input.var.index] = InputText(context_, input, names_.attributes[i]);
    }
  }

  // Gives the blocks and structs of outputs the names that they have in the next stage.
  void Groups() {
    for (const OutputGroup& group : context_.program.output_groups) {
      namer_.Global(group.type);
      names_.groups.push_back(group.instance.empty() ? "" : namer_.Global(group.instance));
      if (!group.instance.empty()) continue;
      for (const OutputGroup::GroupMember& member : group.members) namer_.Global(member.name);
    }
  }

  // The name "v.uv[1]" of an output that is a member of a group.
  std::string MemberName(const Reader& reader) const {
    const std::string& instance = names_.groups[*reader.group];
    const OutputGroup& group = context_.program.output_groups[*reader.group];
    return Concat(instance, instance.empty() ? "" : ".", group.members[reader.member].name,
                  ElementOf(reader));
  }

  // The name of an output of the stage, or of an input, which a hull shader writes for a domain
  // shader and a vertex shader for others.
  std::string StyledName(const IoVar& io) const {
    const bool is_output = context_[io.var].storage == Storage::kOutput;
    const clipc::Stage stage = context_.program.stage;
    const StageInfo& writer = InfoOf(is_output                     ? stage
                                     : InfoOf(stage).reads_patches ? clipc::Stage::kHull
                                                                   : clipc::Stage::kVertex);
    return InterfaceName(io, context_.options.names, writer);
  }

  // Names the outputs that the next stage's shader is known to read, or the others.
  void OutputsOf(bool are_read) {
    for (const IoVar& output : context_.program.outputs) {
      if (output.reader.has_value() != are_read) continue;
      std::string& name = names_.vars[output.var.index];
      if (output.builtin != Builtin::kNone)
        name = BuiltinOutput(output.builtin, context_.target);
      else if (!InfoOf(context_.program.stage).has_stage_after)
        name = TargetName(output);
      else
        name = are_read ? ReadName(output) : namer_.Global(StyledName(output));
    }
  }

  // The name of an output to a render target, as HLSLcc has it; without `out`, the components of
  // GLSL's own variable that the output has.
  std::string TargetName(const IoVar& output) {
    const std::string number =
        std::to_string(output.blend_index > 0 ? output.index : output.location);
    if (context_.Has(Feature::kInAndOut)) return namer_.Global(Concat("SV_Target", number));
    const std::uint32_t count = context_.TypeOf(output.var).Components();
    return Concat("gl_FragData[", number, "]",
                  count < 4 ? Concat(".", std::string_view("xyzw").substr(0, count)) : "");
  }

  std::string ReadName(const IoVar& output) {
    const Reader& reader = *output.reader;
    if (reader.group) return MemberName(reader);
    const bool is_output = context_[output.var].storage == Storage::kOutput;
    std::string& name = read_names_[{is_output, output.location - reader.element}];
    if (name.empty()) name = namer_.Global(reader.name.empty() ? StyledName(output) : reader.name);
    return name + ElementOf(reader);
  }

  void Members(CbufferId id) {
    const Cbuffer& cbuffer = context_[id];
    const BlockLayout& layout = context_.layouts[id.index];
    if (layout.fields_as_members) return;
    const auto& declared = cbuffer.declared;
    const bool is_named = declared && !declared->is_loose;
    for (std::size_t i = 0; is_named && i < declared->members.size(); ++i) {
      std::string& name = names_.vars[cbuffer.members[i].var.index];
      name = declared->members[i].name;
      if (!layout.has_instance) name = namer_.Global(name);
    }
    if (is_named) return;
    if (layout.has_instance) return MembersOfInstance(cbuffer, layout);
    for (const CbufferMember& member : cbuffer.members) {
      if (layout.form != BlockForm::kUniforms || context_.reached.Has(member.var))
        Global(member.var);
    }
  }

  void MembersOfInstance(const Cbuffer& cbuffer, const BlockLayout& layout) {
    std::vector<std::string_view> wanted;
    wanted.reserve(cbuffer.members.size());
    for (const CbufferMember& member : cbuffer.members) wanted.push_back(context_[member.var].name);
    std::vector<std::string> fields = FieldNames(std::move(wanted));
    for (std::size_t i = 0; i < fields.size(); ++i)
      names_.vars[cbuffer.members[i].var.index] = std::move(fields[i]);
    // A member that is read by hand is a function, outside the block.
    for (const ByHand& member : layout.by_hand) Global(member.var);
  }

  void Block(CbufferId id) {
    const Cbuffer& cbuffer = context_[id];
    const NameStyle& style = context_.options.names;
    std::string& name = names_.blocks[id.index];
    if (const GlslInfo::UniformBlock* block = context_.LaidBlock(id)) {
      name = block->name;
      names_.rows[id.index] = block->rows;
      return;
    }
    if (cbuffer.declared && !cbuffer.declared->name.empty()) {
      name = cbuffer.declared->name;
      namer_.Global(name);
      return;
    }
    if (cbuffer.kind == CbufferKind::kConstantBuffer) {
      const TypeId type = context_.types.Innermost(context_[cbuffer.members[0].var].type);
      name = FillPattern(style.constant_buffer,
                         {{"name", cbuffer.name}, {"type", context_.types.StructOf(type).name}});
    } else if (cbuffer.kind == CbufferKind::kGlobals) {
      name = style.globals;
    } else {
      name = FillPattern(style.block, {{"name", cbuffer.name}});
    }
    name = namer_.Global(name, "block");
    if (context_.layouts[id.index].form == BlockForm::kRows) {
      const bool is_block = context_.Has(Feature::kUniformBlocks);
      names_.rows[id.index] = is_block ? namer_.Global(cbuffer.name + "_rows") : name;
    }
  }

  void Uniforms() {
    std::vector<CbufferId> blocks;
    for (const CbufferId id : context_.program.cbuffers.ids()) {
      if (!context_.reached.Has(id)) continue;
      Members(id);
      if (context_.layouts[id.index].form != BlockForm::kUniforms) blocks.push_back(id);
    }
    for (const CbufferId id : blocks) Block(id);
    for (const Resource& resource : context_.program.resources) {
      if (context_.reached.Has(resource.var)) Global(resource.var);
    }
    // The host does not see the names of instances. A ConstantBuffer<T> has the name of its
    // variable.
    for (const CbufferId id : blocks) {
      const BlockLayout& layout = context_.layouts[id.index];
      if (layout.fields_as_members) Global(context_[id].members[0].var);
      if (!layout.has_instance || layout.fields_as_members) continue;
      const auto& declared = context_[id].declared;
      names_.instances[id.index] = namer_.Global(
          declared ? declared->instance : InstanceName(LegalName(context_[id].name, "block")));
    }
  }

  void OfStruct(StructId id) {
    const Struct& structure = context_.types[id];
    names_.structs[id.index] = namer_.Global(LegalTypeName(structure.name), "Unnamed");
  }

  const WriterContext& context_;
  Namer& namer_;
  Names names_;
  std::vector<bool> is_given_;  // by VarId: another stage gave the name
  // The names of inputs, and of outputs that the next stage reads, by location; of arrays and
  // matrices by the first.
  std::map<std::pair<bool, std::uint32_t>, std::string> read_names_;
};

}  // namespace

std::vector<std::string>& WriterContext::FieldsOf(StructId id) const {
  fields_.resize(types.structs().size());
  std::vector<std::string>& names = fields_[id.index];
  if (!names.empty()) return names;
  std::vector<std::string_view> wanted;
  for (const Field& field : types[id].fields) wanted.push_back(field.name);
  return names = FieldNames(std::move(wanted));
}

std::string InterfaceName(const IoVar& output, const NameStyle& style, const StageInfo& writer) {
  const std::string index = std::to_string(output.index), semantic = ToUpper(output.semantic);
  const std::string written = output.semantic + (output.has_index || output.index > 0 ? index : "");
  const std::string_view name = output.name.empty() ? written : output.name;
  std::string text =
      FillPattern(style.output,
                  {{"semantic", semantic}, {"index", index}, {"written", written}, {"name", name}});
  if (!writer.has_stage_before) return text;
  if (text.starts_with("vs_")) text.erase(0, 3);
  return Concat(writer.prefix, output.is_of_patch ? "_patch_" : "_", text);
}

Names NameEverything(WriterContext& context) { return Naming(context).Run(); }

// Overloads share a name as long as GLSL can tell them apart: half and float are the same there.
std::vector<std::string> NameFunctions(WriterContext& context) {
  std::vector<std::string> names(context.program.functions.size());
  std::unordered_map<std::string_view, int> counts;
  for (const FunctionId id : context.reached.functions) ++counts[context[id].name];
  std::unordered_map<std::string_view, std::string> shared;
  std::set<std::string> taken;
  for (const FunctionId id : context.reached.functions) {
    const Function& function = context[id];
    std::string& name = names[id.index];
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
  return names;
}

}  // namespace clipc::glsl
