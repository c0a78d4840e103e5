// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/packed_stage.h"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "legalize/read_members.h"

namespace clipc::glsl {

using namespace ir;

namespace {

std::vector<BlockLayout> LayOutBlocks(const Program& program, const Reached& reached,
                                      const Target& target, BlockStyle style, OtherStages others) {
  std::vector<BlockLayout> layouts(program.cbuffers.size());
  std::vector<bool> is_read = reached.vars;
  for (const OtherStage& other : others) {
    for (std::size_t i = 0; i < is_read.size(); ++i) is_read[i] = is_read[i] || other.is_read[i];
  }
  for (const CbufferId id : program.cbuffers.ids()) {
    if (reached.Has(id))
      layouts[id.index] = LayOutBlock(program, program.cbuffers[id], target, style, is_read);
  }
  return layouts;
}

// Adds variables for what blocks declare in place of members, and finds the members that functions
// read.
class Packing {
 public:
  Packing(PackedStage& stage, Program& program, const Target& target)
      : stage_(stage), program_(program), types_(program.types), target_(target) {}

  std::vector<legalize::PackedMember> Run() {
    for (const CbufferId id : program_.cbuffers.ids()) {
      BlockLayout& layout = stage_.layouts[id.index];
      if (!stage_.reached.Has(id)) continue;
      if (layout.form == BlockForm::kRows)
        Rows(id, layout);
      else
        Parts(id, layout);
    }
    return std::move(members_);
  }

 private:
  VarId Add(CbufferId cbuffer, std::string name, TypeId type) {
    return program_.vars.Add(
        {.name = std::move(name), .type = type, .storage = Storage::kUniform, .cbuffer = cbuffer});
  }
  TypeId RowsOf(bool are_floats, std::uint32_t count) {
    return types_.Array(types_.Vector(are_floats ? Scalar::kFloat : Scalar::kUint, 4),
                        std::max(count, 1u));
  }

  // A buffer in one array of rows, of which those of an array of buffers are in a struct.
  void Rows(CbufferId id, BlockLayout& layout) {
    const Cbuffer& cbuffer = program_.cbuffers[id];
    const bool has_blocks = target_.Has(Feature::kUniformBlocks);
    const VarId first = cbuffer.members[0].var;
    TypeId type = RowsOf(!has_blocks || layout.float_rows, cbuffer.size / kRow);
    const bool in_buffers = has_blocks && cbuffer.kind == CbufferKind::kConstantBuffer &&
                            types_[program_.vars[first].type].kind == TypeKind::kArray;
    if (in_buffers) {
      Struct rows{.name = cbuffer.name + "_rows_of", .fields = {}, .span = {}};
      rows.fields.emplace_back();
      rows.fields[0].name = cbuffer.name + "_rows";
      rows.fields[0].type = type;
      type = types_.Of(types_.AddStruct(std::move(rows)));
      type = types_.Array(type, types_[program_.vars[first].type].count);
    }
    layout.memory = Add(id, cbuffer.name + "_rows", type);
    for (const CbufferMember& member : cbuffer.members) {
      if (!stage_.reached.Has(member.var)) continue;
      if (has_blocks || OnlyFloats(types_, program_.vars[member.var].type))
        members_.push_back({.var = member.var,
                            .offset = member.offset,
                            .rows = layout.memory,
                            .in_buffers = in_buffers});
    }
  }

  void Parts(CbufferId id, BlockLayout& layout) {
    for (BlockMember& part : layout.members) {
      const std::string name = program_.vars[part.var].name;
      if (part.form == PartForm::kRows)
        part.memory = Add(id, name + "_rows", RowsOf(part.float_rows, part.rows));
      if (part.form == PartForm::kWords) AddComponents(id, name, part);
    }
    for (const ByHand& member : layout.by_hand) {
      const BlockMember& part = layout.members[member.part];
      legalize::PackedMember packed{.var = member.var};
      if (part.form == PartForm::kRows) {
        packed.rows = part.memory;
        packed.offset = member.offset - part.offset;
      } else if (part.var == member.var) {
        packed.component = part.memory;
      }
      if (stage_.reached.Has(member.var)) members_.push_back(packed);
    }
  }

  void AddComponents(CbufferId id, const std::string& name, BlockMember& part) {
    const Type vector = types_[part.type];
    const Scalar kind = BaseOf(vector.scalar);
    const TypeId component = types_.Make(kind == Scalar::kBool ? Scalar::kUint : kind);
    for (std::uint32_t i = 0; i < vector.columns; ++i) {
      const VarId var = Add(id, fmt::format("{}_{}", name, "xyzw"[i]), component);
      if (i == 0) part.memory = var;
    }
  }

  PackedStage& stage_;
  Program& program_;
  TypeTable& types_;
  const Target& target_;
  std::vector<legalize::PackedMember> members_;
};

bool IsPacked(const BlockLayout& layout) {
  return layout.form == BlockForm::kRows || !layout.by_hand.empty() ||
         std::ranges::any_of(layout.members, [](const BlockMember& member) {
           return member.form != PartForm::kWhole;
         });
}

// The variables of each ConstantBuffer<T> whose fields GLSL has as members of a block.
std::vector<VarId> BlocksOf(const Program& program, const std::vector<BlockLayout>& layouts) {
  std::vector<VarId> blocks;
  for (const CbufferId id : program.cbuffers.ids()) {
    if (layouts[id.index].fields_as_members) blocks.push_back(program.cbuffers[id].members[0].var);
  }
  return blocks;
}

// The bytes from the start of its buffer to a member.
std::uint32_t OffsetOf(const Program& program, VarId var) {
  const auto& members = program.cbuffers[program.vars[var].cbuffer].members;
  return std::ranges::find(members, var, &CbufferMember::var)->offset;
}

}  // namespace

PackedStage::PackedStage(const Program& program, const Target& target, BlockStyle style,
                         OtherStages others)
    : given(program),
      reached(Reach(program, target.KeepsBindings())),
      layouts(LayOutBlocks(program, reached, target, style, others)) {
  const legalize::Needs needs = target.Needs();
  legalize::MemberReads reads{{}, BlocksOf(program, layouts)};
  if (std::ranges::none_of(layouts, IsPacked) && !HasReads(program, needs, reads)) {
    readers.resize(program.vars.size());
    return;
  }
  copy.emplace(program);
  reads.packed = Packing(*this, *copy, target).Run();
  readers = ReadMembers(*copy, needs, reads);
  readers.resize(copy->vars.size());
  for (const legalize::PackedMember& member : reads.packed)
    copy->functions[readers[member.var.index]].offset = OffsetOf(program, member.var);
  // A member that is read by hand is reached, though no function names it now.
  const Reached before = std::exchange(reached, Reach(*copy, target.KeepsBindings()));
  for (std::size_t i = 0; i < before.vars.size(); ++i)
    reached.vars[i] = reached.vars[i] || before.vars[i];
  reached.cbuffers = before.cbuffers;
}

}  // namespace clipc::glsl
