// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Inputs and outputs that are parts of one variable: columns of a matrix, elements of an array,
// members of a block or of a struct, as the stage at the other end declares them; and inputs that
// are read at each vertex of the primitive.
#include <algorithm>
#include <string>

#include "backend-spirv/writer.h"

namespace clipc::spirv {

using namespace ir;

namespace {

bool IsPart(const IoVar& io) { return io.reader && !io.reader->IsWhole(); }

// The path to element `reader.element` of the matrices and arrays.
std::vector<std::uint32_t> ElementOf(const Reader& reader) {
  std::vector<std::uint32_t> path;
  std::uint32_t element = reader.element;
  const auto lead = [&](std::uint32_t count) {
    path.insert(path.begin(), element % count);
    element /= count;
  };
  if (reader.columns > 1) lead(reader.columns);
  for (auto i = reader.dimensions.rbegin(); i != reader.dimensions.rend(); ++i) lead(*i);
  return path;
}

}  // namespace

// The matrix of such columns, or arrays of them.
Ref Writer::WholeType(Ref column, std::uint32_t columns,
                      std::span<const std::uint32_t> dimensions) {
  Ref type = columns > 1 ? module_.Type(spv::Op::OpTypeMatrix, {column, columns}) : column;
  for (auto i = dimensions.rbegin(); i != dimensions.rend(); ++i)
    type = module_.Type(spv::Op::OpTypeArray, {type, types_.Uint(*i)});
  return type;
}

// Declares what an input or an output is, or is a part of. Inputs that are read at each vertex are
// arrays of three.
void Writer::DeclareShared(const IoVar& io, const Interface::Variable& place,
                           spv::StorageClass storage) {
  const bool is_input = storage == spv::StorageClass::Input;
  const bool is_per_vertex = is_input && per_vertex_.contains(io.var.index);
  std::vector<Ref>& indices = part_indices_[io.var.index];
  if (is_per_vertex) indices.push_back(types_.Int(0));
  std::uint32_t location = *place.location;
  Ref type = types_.Of((*this)[io.var].type);
  std::string_view name = place.name;
  if (IsPart(io)) {
    for (const std::uint32_t index : ElementOf(*io.reader))
      indices.push_back(types_.Int(static_cast<std::int32_t>(index)));
    location -= io.reader->element;
    type = WholeType(type, io.reader->columns, io.reader->dimensions);
    name = name.substr(0, name.find('['));
  }
  storages_[io.var.index] = storage;
  Ref alone = 0;
  Ref& variable = IsPart(io) ? wholes_[{storage, location}] : alone;
  if (variable == 0) {
    if (is_per_vertex) type = module_.Type(spv::Op::OpTypeArray, {type, types_.Uint(3)});
    variable = module_.Variable(types_.Pointer(storage, type), storage);
    module_.Name(variable, name);
    module_.Decorate(variable, spv::Decoration::Location, {location});
    if (io.blend_index > 0) module_.Decorate(variable, spv::Decoration::Index, {io.blend_index});
    if (is_per_vertex) {
      RequireBarycentrics();
      module_.Decorate(variable, spv::Decoration::PerVertexKHR);
    } else if (is_input == IsPixelShader()) {
      const Scalar scalar = program_.types[(*this)[io.var].type].scalar;
      for (const spv::Decoration decoration :
           InterpolationOf({scalar, io.interpolation, io.centroid, io.sample}))
        module_.Decorate(variable, decoration);
    }
    shared_.push_back(variable);
  }
  pointers_[io.var.index] = variable;
}

void Writer::RequireBarycentrics() {
  module_.Require(spv::Capability::FragmentBarycentricKHR);
  module_.Require("SPV_KHR_fragment_shader_barycentric");
}

std::vector<spv::Decoration> Writer::InterpolationOf(const Interpolated& io) {
  std::vector<spv::Decoration> decorations;
  const bool is_flat = BaseOf(io.scalar) != Scalar::kFloat;
  if (is_flat || io.interpolation == Interpolation::kNoInterpolation)
    decorations.push_back(spv::Decoration::Flat);
  else if (io.interpolation == Interpolation::kNoPerspective)
    decorations.push_back(spv::Decoration::NoPerspective);
  if (io.centroid) decorations.push_back(spv::Decoration::Centroid);
  if (io.sample) {
    module_.Require(spv::Capability::SampleRateShading);
    decorations.push_back(spv::Decoration::Sample);
  }
  return decorations;
}

// Declares the block or the struct that the output is a member of.
void Writer::DeclareMember(const IoVar& output) {
  const Reader& reader = *output.reader;
  Ref& variable = group_variables_[*reader.group];
  if (variable == 0) variable = DeclareGroup(program_.output_groups[*reader.group]);
  std::vector<Ref>& indices = part_indices_[output.var.index];
  indices.push_back(types_.Int(static_cast<std::int32_t>(reader.member)));
  for (const std::uint32_t index : ElementOf(reader))
    indices.push_back(types_.Int(static_cast<std::int32_t>(index)));
  pointers_[output.var.index] = variable;
  storages_[output.var.index] = spv::StorageClass::Output;
}

Ref Writer::DeclareGroup(const OutputGroup& group) {
  constexpr auto kStorage = spv::StorageClass::Output;
  Words members;
  for (const OutputGroup::GroupMember& member : group.members) {
    const Ref column = types_.Of(ShapeOf(member.scalar, 1, member.components));
    members.push_back(WholeType(column, member.columns, member.dimensions));
  }
  const Ref type = module_.OwnType(spv::Op::OpTypeStruct, members);
  module_.Name(type, group.type);
  const Ref variable = module_.Variable(types_.Pointer(kStorage, type), kStorage);
  module_.Name(variable, group.instance);
  if (group.is_block) module_.Decorate(type, spv::Decoration::Block);
  if (group.location) module_.Decorate(variable, spv::Decoration::Location, {*group.location});
  // A struct has the qualifiers of its first member, and is flat where one of them must be.
  Interpolated whole{Scalar::kFloat, group.members.front().interpolation,
                     group.members.front().centroid, group.members.front().sample};
  std::uint32_t number = 0;
  for (const OutputGroup::GroupMember& member : group.members) {
    module_.NameMember(type, number, member.name);
    if (member.scalar != Scalar::kFloat) whole.scalar = member.scalar;
    if (group.is_block) {
      if (member.location)
        module_.DecorateMember(type, number, spv::Decoration::Location, {*member.location});
      for (const spv::Decoration decoration :
           InterpolationOf({member.scalar, member.interpolation, member.centroid, member.sample}))
        module_.DecorateMember(type, number, decoration);
    }
    ++number;
  }
  if (!group.is_block) {
    for (const spv::Decoration decoration : InterpolationOf(whole))
      module_.Decorate(variable, decoration);
  }
  shared_.push_back(variable);
  return variable;
}

}  // namespace clipc::spirv
