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

// What is interpolated between two stages, or a member of it.
struct Interpolated {
  Scalar scalar = Scalar::kFloat;
  Interpolation interpolation = Interpolation::kDefault;
  bool centroid = false, sample = false;
};

// The matrix of such columns, or arrays of them.
Ref WholeType(Module& module, Types& types, Ref column, std::uint32_t columns,
              std::span<const std::uint32_t> dimensions) {
  Ref type = columns > 1 ? module.Type(spv::Op::OpTypeMatrix, {column, columns}) : column;
  for (auto i = dimensions.rbegin(); i != dimensions.rend(); ++i)
    type = module.Type(spv::Op::OpTypeArray, {type, types.Uint(*i)});
  return type;
}

std::vector<spv::Decoration> InterpolationOf(Module& module, const Interpolated& io) {
  std::vector<spv::Decoration> decorations;
  const bool is_flat = BaseOf(io.scalar) != Scalar::kFloat;
  if (is_flat || io.interpolation == Interpolation::kNoInterpolation)
    decorations.push_back(spv::Decoration::Flat);
  else if (io.interpolation == Interpolation::kNoPerspective)
    decorations.push_back(spv::Decoration::NoPerspective);
  if (io.centroid) decorations.push_back(spv::Decoration::Centroid);
  if (io.sample) {
    module.Require(spv::Capability::SampleRateShading);
    decorations.push_back(spv::Decoration::Sample);
  }
  return decorations;
}

}  // namespace

// OpenGL's extension is that of NVIDIA, with the same numbers.
void Writer::RequireBarycentrics() {
  module_.Require(spv::Capability::FragmentBarycentricKHR);
  module_.Require(options_.is_opengl ? "SPV_NV_fragment_shader_barycentric"
                                     : "SPV_KHR_fragment_shader_barycentric");
}

// The vertices of a primitive; a pixel shader's is a triangle.
std::uint32_t Writer::VerticesOfInputs() const {
  // Arrays of control points are as long as the longest patch, whatever the draw call has.
  if (!InfoOf(program_.stage).emits_vertices && !IsPixelShader()) return kMostControlPoints;
  return IsPixelShader() ? 3 : VerticesRead(program_);
}

// Whether each control point that a shader makes has its own value of the output.
bool Writer::IsOfPoint(const IoVar& output) const {
  return InfoOf(program_.stage).makes_patches && !output.is_of_patch;
}

Ref Writer::OfPoints(Ref type) {
  return module_.Type(spv::Op::OpTypeArray,
                      {type, types_.Uint(program_.tessellation.output_points)});
}

// Declares what an input or an output is, or is a part of. Inputs that are read at each vertex are
// arrays of them.
void Writer::DeclareShared(const IoVar& io, const Interface::Variable& place,
                           spv::StorageClass storage) {
  const bool is_input = storage == spv::StorageClass::Input;
  const bool is_per_vertex = is_input && per_vertex_.contains(io.var.index);
  const bool is_of_point = !is_input && IsOfPoint(io);
  std::vector<Ref>& indices = part_indices_[io.var.index];
  if (is_per_vertex || is_of_point) indices.push_back(types_.Int(0));
  std::uint32_t location = *place.location;
  Ref type = types_.Of((*this)[io.var].type);
  std::string_view name = place.name;
  if (IsPart(io)) {
    for (const std::uint32_t index : ElementOf(*io.reader))
      indices.push_back(types_.Int(static_cast<std::int32_t>(index)));
    location -= io.reader->element;
    type = WholeType(module_, types_, type, io.reader->columns, io.reader->dimensions);
    name = name.substr(0, name.find('['));
  }
  storages_[io.var.index] = storage;
  Ref alone = 0;
  Ref& variable = IsPart(io) ? wholes_[{storage, location}] : alone;
  if (variable == 0) {
    if (is_per_vertex)
      type = module_.Type(spv::Op::OpTypeArray, {type, types_.Uint(VerticesOfInputs())});
    if (is_of_point) type = OfPoints(type);
    variable = module_.Variable(types_.Pointer(storage, type), storage);
    module_.Name(variable, name);
    module_.Decorate(variable, spv::Decoration::Location, {location});
    if (options_.relaxed_precision && io.has_min_precision)
      module_.Decorate(variable, spv::Decoration::RelaxedPrecision);
    if (!is_input && program_.emission.streams.size() > 1)
      module_.Decorate(variable, spv::Decoration::Stream, {StreamOf(program_, io.var)});
    if (io.blend_index > 0) module_.Decorate(variable, spv::Decoration::Index, {io.blend_index});
    if (is_per_vertex && IsPixelShader()) {
      RequireBarycentrics();
      module_.Decorate(variable, spv::Decoration::PerVertexKHR);
    } else if (io.is_of_patch) {
      module_.Decorate(variable, spv::Decoration::Patch);
    } else if (is_input == IsPixelShader()) {
      const Scalar scalar = program_.types[(*this)[io.var].type].scalar;
      for (const spv::Decoration decoration :
           InterpolationOf(module_, {scalar, io.interpolation, io.centroid, io.sample}))
        module_.Decorate(variable, decoration);
    }
    shared_.push_back(variable);
  }
  NameSemantic(variable, io);
  pointers_[io.var.index] = variable;
}

// For reflection: the semantic of an input or output as it is written.
void Writer::NameSemantic(Ref variable, const IoVar& io) {
  if (!options_.has_reflection || !described_.insert(variable).second) return;
  // SPIR-V 1.4 has the semantics of users and strings in decorations.
  if (module_.minor_version() < 4) {
    module_.Require("SPV_GOOGLE_decorate_string");
    module_.Require("SPV_GOOGLE_hlsl_functionality1");
  }
  module_.DecorateText(variable, spv::Decoration::HlslSemanticGOOGLE,
                       io.has_index ? io.semantic + std::to_string(io.index) : io.semantic);
}

// For reflection: the type of an object or a buffer.
void Writer::NameType(Ref variable, std::string_view name) {
  if (!options_.has_reflection || name.empty()) return;
  if (module_.minor_version() < 4) module_.Require("SPV_GOOGLE_decorate_string");
  module_.Require("SPV_GOOGLE_user_type");
  module_.DecorateText(variable, spv::Decoration::UserTypeGOOGLE, name);
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
    members.push_back(WholeType(module_, types_, column, member.columns, member.dimensions));
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
      for (const spv::Decoration decoration : InterpolationOf(
               module_, {member.scalar, member.interpolation, member.centroid, member.sample}))
        module_.DecorateMember(type, number, decoration);
    }
    ++number;
  }
  if (!group.is_block) {
    for (const spv::Decoration decoration : InterpolationOf(module_, whole))
      module_.Decorate(variable, decoration);
  }
  shared_.push_back(variable);
  return variable;
}

}  // namespace clipc::spirv
