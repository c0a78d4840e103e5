// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/lay_blocks.h"

#include <unordered_set>

#include <fmt/format.h>

#include "backend-glsl/text.h"
#include "backend-glsl/writer/bindings.h"
#include "backend-glsl/writer/types.h"

namespace clipc::glsl {

using namespace ir;

namespace {

class BlockLayer {
 public:
  BlockLayer(WriterContext& context, CbufferId id, GlslInfo::UniformBlock& info)
      : context_(context), cbuffer_(context[id]), layout_(context.layouts[id.index]), info_(info) {
    info_.cbuffer = id;
    info_.is_shared = context.IsShared(id);
    info_.form = layout_.form;
  }

  void Lay(Bindings& bindings) {
    if (layout_.form == BlockForm::kUniforms) return PlainUniforms();
    info_.name = context_.names.blocks[info_.cbuffer.index];
    const bool is_rows = layout_.form == BlockForm::kRows;
    if (is_rows && !context_.Has(Feature::kUniformBlocks)) return RowUniform();
    info_.is_push_constant = cbuffer_.is_push_constant && context_.target.IsVulkan();
    if (cbuffer_.declared && !info_.is_push_constant) {
      Bind(context_, info_, *cbuffer_.declared);
    } else if (!info_.is_push_constant) {
      info_.count = cbuffer_.count;
      Bind(context_, info_, cbuffer_.reg, bindings, context_.LaidBlock(info_.cbuffer));
    }
    is_rows ? Rows() : Members();
  }

 private:
  void PlainUniforms() {
    for (const BlockMember& member : layout_.members) {
      if (context_.reached.Has(member.var)) PlainUniform(member.var);
    }
  }

  // Rows of HLSL are columns of GLSL, so a matrix that is row-major in HLSL needs no transposing.
  void PlainUniform(VarId member) {
    const std::string& name = context_.NameOf(member);
    info_.members.push_back({member, -1, name, true, !context_[member].row_major});
  }

  void Members() {
    info_.members.reserve(layout_.members.size());
    for (const BlockMember& member : layout_.members) {
      NamePadding(member);
      if (member.form == PartForm::kRows)
        PartInRows(member);
      else if (member.form == PartForm::kWords)
        PartInWords(member);
      else
        info_.members.push_back({member.var, member.field, HostName(context_.NameOf(member))});
    }
    if (!layout_.has_instance) return;
    info_.instance = layout_.fields_as_members ? context_.NameOf(layout_.members.front().var)
                                               : context_.names.instances[info_.cbuffer.index];
  }

  // A name that nothing else in the block has, for what is not a member in HLSL.
  std::string PartName(std::string name) {
    if (!layout_.has_instance) return context_.namer.Global(name);
    if (part_names_.empty()) {
      for (const BlockMember& member : layout_.members) {
        if (member.form == PartForm::kWhole) part_names_.insert(context_.NameOf(member));
      }
    }
    name = LegalFieldName(name);
    while (!part_names_.insert(name).second) name = LegalFieldName(name + "_2");
    return name;
  }

  void NamePadding(const BlockMember& member) {
    ForEachPadding(member, [&](std::uint32_t begin, std::uint32_t) {
      context_.names.paddings[info_.cbuffer.index].push_back(
          PartName(fmt::format("padding_{}", begin)));
    });
  }

  std::string HostName(const std::string& name) const {
    return layout_.has_instance ? Concat(info_.name, ".", name) : name;
  }

  void PartInRows(const BlockMember& part) {
    const std::string name = PartName(context_[part.var].name + "_rows");
    context_.names.vars[part.memory.index] = name;
    for (const ByHand& member : layout_.by_hand) {
      if (&layout_.members[member.part] != &part) continue;
      info_.members.push_back(
          {member.var, -1, HostName(name), false, false, context_.NameOf(member.var), part.offset});
    }
  }

  void PartInWords(const BlockMember& part) {
    for (std::uint32_t i = 0; i < context_[part.type].columns; ++i) {
      context_.names.vars[part.memory.index + i] =
          PartName(Concat(context_[part.var].name, "_", std::string_view("xyzw").substr(i, 1)));
    }
    info_.members.push_back({part.var, -1, HostName(context_.NameOf(part.memory)), false, false,
                             context_.NameOf(part.var)});
  }

  void Rows() {
    info_.rows = context_.names.rows[info_.cbuffer.index];
    std::string& memory = context_.names.vars[layout_.memory.index];
    memory = info_.rows;
    const Type& rows = context_[context_.types.Innermost(context_[layout_.memory].type)];
    if (rows.kind == TypeKind::kStruct) {  // of an array of buffers
      info_.instance = context_.namer.Global(cbuffer_.name + "_buffers");
      memory = info_.instance;
      context_.FieldsOf(rows.structure)[0] = info_.rows;
    }
    for (const CbufferMember& member : cbuffer_.members)
      info_.members.push_back({member.var, -1, context_.NameOf(member.var)});
  }

  void RowUniform() {
    info_.rows = context_.names.rows[info_.cbuffer.index];
    info_.name.clear();
    context_.names.vars[layout_.memory.index] = info_.rows;
    for (const CbufferMember& member : cbuffer_.members) {
      if (!context_.reached.Has(member.var)) continue;
      if (context_.IsByHand(member.var))
        info_.members.push_back({member.var, -1, context_.NameOf(member.var)});
      else
        PlainUniform(member.var);
    }
    if (RowsRead(context_, cbuffer_) == 0) info_.rows.clear();
  }

  WriterContext& context_;
  const Cbuffer& cbuffer_;
  const BlockLayout& layout_;
  GlslInfo::UniformBlock& info_;
  std::unordered_set<std::string> part_names_;  // those in the block; filled for the first part
};

}  // namespace

std::vector<GlslInfo::UniformBlock> LayBlocks(WriterContext& context) {
  std::vector<GlslInfo::UniformBlock> blocks;
  blocks.reserve(context.program.cbuffers.size());
  Bindings bindings;
  for (const OtherStage& other : context.others) {
    if (!other.laid) continue;
    for (const GlslInfo::UniformBlock& block : other.laid->blocks) bindings.Take(block);
  }
  for (const CbufferId id : context.program.cbuffers.ids()) {
    if (context.reached.Has(id)) bindings.Reserve(context[id].reg, context[id].count);
  }
  for (const CbufferId id : context.program.cbuffers.ids()) {
    if (context.reached.Has(id)) BlockLayer(context, id, blocks.emplace_back()).Lay(bindings);
  }
  return blocks;
}

}  // namespace clipc::glsl
