// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/make_facts.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>

#include "ir/access.h"
#include "ir/call_order.h"
#include "ir/packing.h"
#include "ir/shared_memory.h"

namespace clipc {
namespace {

using glsl::GlslInfo;
using ir::IoVar;
using ir::IoVars;
using ir::Program;

constexpr Named<ir::CbufferKind> kCbufferKinds[] = {
    {ir::CbufferKind::kCbuffer, "cbuffer"},
    {ir::CbufferKind::kTbuffer, "tbuffer"},
    {ir::CbufferKind::kGlobals, "globals"},
    {ir::CbufferKind::kParams, "params"},
    {ir::CbufferKind::kConstantBuffer, "ConstantBuffer"}};
constexpr Named<glsl::BlockForm> kBlockForms[] = {{glsl::BlockForm::kStd140, "std140"},
                                                  {glsl::BlockForm::kRows, "rows"},
                                                  {glsl::BlockForm::kUniforms, "uniforms"}};

RegisterFact FactOf(const ir::Register& reg) {
  return {std::string(1, reg.letter) + std::to_string(reg.number), reg.number, reg.space,
          reg.is_explicit};
}

// The places of constants in a block, by the variable and in the block's order.
using PlacedMember = std::pair<ir::VarId, const GlslInfo::UniformMember*>;

// What is said of one stage.
TessellationFact FactOf(const ir::Tessellation& patch, const StageInfo& stage) {
  TessellationFact fact;
  if (patch.domain) fact.domain = ir::InfoOf(*patch.domain).name;
  if (patch.partitioning)
    fact.partitioning = ir::kPartitionings[static_cast<std::size_t>(*patch.partitioning)];
  if (patch.topology)
    fact.topology = ir::kOutputTopologies[static_cast<std::size_t>(*patch.topology)];
  fact.input_points = stage.makes_patches ? patch.input_points : patch.output_points;
  if (stage.makes_patches) fact.output_points = patch.output_points;
  fact.max_factor = patch.max_factor;
  return fact;
}

EmissionFact FactOf(const ir::Emission& emission) {
  const ir::PrimitiveInfo& output = ir::InfoOf(emission.output);
  const bool is_strip = output.vertices > 1;
  return {.input = std::string(ir::InfoOf(emission.input).name),
          .output = std::string(output.name) + (is_strip ? "_strip" : ""),
          .input_vertices = ir::InfoOf(emission.input).vertices,
          .max_vertices = emission.max_vertices,
          .instances = emission.instances,
          .streams = static_cast<std::uint32_t>(emission.streams.size())};
}

// What the tessellator gives each point is of no patch as a whole.
bool IsConstantOfPatch(const IoVar& io) {
  using enum ir::Builtin;
  constexpr ir::Builtin kOfPatches[] = {kNone, kTessFactor, kInsideFactor, kTessFactorInput,
                                        kInsideFactorInput};
  return io.is_of_patch && std::ranges::find(kOfPatches, io.builtin) != std::end(kOfPatches);
}

class Describer {
 public:
  explicit Describer(const DescribedStage& stage)
      : lowered_(stage.lowered), program_(stage.lowered.program), info_(stage.info) {}

  StageFacts Describe(const clip_table::ClipTable& table) {
    const StageInfo& traits = InfoOf(program_.stage);
    StageFacts facts{.entry = table.entry,
                     .profile = table.profile,
                     .stage = std::string(traits.name),
                     .draws_pixels = traits.draws_pixels,
                     .is_named = program_.stage != Stage::kVertex,
                     .inputs = Signature(program_.inputs, info_.inputs),
                     .outputs = Signature(program_.outputs, info_.outputs)};
    for (const ir::CbufferId id : program_.cbuffers.ids()) {
      for (const ir::CbufferMember& member : program_.cbuffers[id].members)
        AddStructs(program_.vars[member.var].type, facts.structs);
    }
    facts.buffers.reserve(program_.cbuffers.size());
    for (const ir::CbufferId id : program_.cbuffers.ids())
      facts.buffers.push_back(Buffer(program_.cbuffers[id], info_.BlockOf(id)));
    facts.resources = Resources();
    if (traits.draws_pixels) facts.host = Host();
    if (traits.runs_in_groups) {
      facts.group = {program_.group_size, ir::SharedBytes(program_)};
      AddAccess(facts.resources);
    }
    if (traits.makes_patches || traits.reads_patches)
      facts.tessellation = FactOf(program_.tessellation, traits);
    if (traits.emits_vertices) facts.emission = FactOf(program_.emission);
    facts.tests_early = program_.tests_early;
    return facts;
  }

 private:
  std::string TypeName(ir::VarId var) const { return TypeName(program_.vars[var].type); }
  // The name of a type, in which a struct has the name that `structs` has.
  std::string TypeName(ir::TypeId id) const {
    const ir::TypeTable& types = program_.types;
    std::string text = types.Name(id);
    const ir::Type* type = &types[types.Innermost(id)];
    const bool is_object = type->kind == ir::TypeKind::kObject && type->element;
    if (is_object) type = &types[type->element];
    const auto named = structs_.find(type->structure);
    if (named != structs_.end() && !named->second.name.empty())
      text.replace(is_object ? text.find('<') + 1 : 0, types[type->structure].name.size(),
                   named->second.name);
    return text;
  }

  VariableFact Variable(const IoVar& io, const GlslInfo::Variable& written) const {
    const bool is_builtin = io.builtin != ir::Builtin::kNone;
    VariableFact fact{.semantic = io.semantic,
                      .index = io.index,
                      .type = TypeName(io.var),
                      .name = written.name,
                      .location = written.location,
                      .blend_index = io.blend_index,
                      .needs_base_vertex_zero = written.needs_base_vertex_zero,
                      .needs_base_instance_zero = written.needs_base_instance_zero,
                      .integer_as_float = written.integer_as_float,
                      .is_builtin = is_builtin,
                      .is_of_patch = IsConstantOfPatch(io),
                      .interpolation = io.interpolation,
                      .centroid = io.centroid,
                      .sample = io.sample,
                      .is_used = written.is_used};
    if (program_.vars[io.var].storage == ir::Storage::kOutput && !is_builtin &&
        !InfoOf(program_.stage).has_stage_after)
      fact.render_target = io.location;
    if (program_.emission.streams.size() > 1 &&
        program_.vars[io.var].storage == ir::Storage::kOutput)
      fact.stream = ir::StreamOf(program_, io.var);
    if (io.reader && io.reader->is_known) {
      const ir::Reader& reader = *io.reader;
      auto& input = fact.reader.emplace();
      input.stage = InfoOf(reader.stage).name;
      input.name = reader.name.empty() ? io.semantic + std::to_string(io.index) : reader.name;
      if (!reader.IsWhole()) input.element = reader.element;
    }
    return fact;
  }

  std::vector<VariableFact> Signature(const IoVars& signature,
                                      const std::vector<GlslInfo::Variable>& written) const {
    std::vector<VariableFact> facts;
    facts.reserve(signature.size());
    for (std::size_t i = 0; i < signature.size(); ++i)
      facts.push_back(Variable(signature[i], written[i]));
    return facts;
  }

  ShapeFact Shape(ir::TypeId type, bool row_major) const {
    const ir::TypeTable& types = program_.types;
    ShapeFact shape;
    for (; types[type].kind == ir::TypeKind::kArray; type = types[type].element) {
      shape.dimensions.push_back({types[type].count, ir::ArrayStride(types, type, row_major),
                                  ir::PackedExtent(types, type, row_major).size});
    }
    const ir::Type& element = types[type];
    shape.size = ir::PackedExtent(types, type, row_major).size;
    shape.kind = element.kind;
    shape.scalar = element.scalar;
    shape.rows = element.rows;
    shape.columns = element.columns;
    if (element.kind == ir::TypeKind::kStruct)
      shape.structure = structs_.at(element.structure).number;
    return shape;
  }

  FieldFact Field(ir::TypeId type, std::uint32_t index) const {
    const ir::TypeTable& types = program_.types;
    type = types.Innermost(type);
    const ir::Field& field = types.StructOf(type).fields[index];
    FieldFact fact{.name = field.name,
                   .type = TypeName(field.type),
                   .shape = Shape(field.type, field.row_major),
                   .offset = ir::FieldOffset(types, types[type].structure, index),
                   .row_major = field.row_major};
    fact.size = fact.shape.SizeAfter(0);
    return fact;
  }

  void AddMember(const ir::CbufferMember& member, const GlslInfo::UniformBlock* block,
                 std::span<const PlacedMember> places, std::vector<MemberFact>& facts) const {
    const ir::Var& var = program_.vars[member.var];
    MemberFact& fact = facts.emplace_back();
    fact.name = var.name;
    fact.type = TypeName(var.type);
    fact.shape = Shape(var.type, var.row_major);
    fact.offset = member.offset;
    fact.size = member.size;
    fact.row_major = var.row_major;
    if (!member.initial.empty())
      fact.initial = ir::Packed(program_.types, var.type, var.row_major, member.initial);
    for (const auto& [_, named] : places) {
      // A ConstantBuffer's fields are members of the GLSL block.
      FieldFact& entry =
          named->field < 0
              ? fact
              : fact.fields.emplace_back(Field(var.type, static_cast<std::uint32_t>(named->field)));
      entry.place = {.glsl = named->NameAt(member.offset),
                     .function = named->function,
                     .is_row = block->form == glsl::BlockForm::kRows,
                     .is_uniform = named->is_uniform,
                     .transpose = named->transpose};
    }
  }

  BufferFact Buffer(const ir::Cbuffer& cbuffer, const GlslInfo::UniformBlock* block) const {
    BufferFact fact{.name = cbuffer.name,
                    .kind = NameIn<kCbufferKinds>(cbuffer.kind),
                    .reg = FactOf(cbuffer.reg),
                    .size = cbuffer.size,
                    .count = cbuffer.count};
    std::vector<PlacedMember> places;
    if (block) {
      fact.block = {.layout = NameIn<kBlockForms>(block->form),
                    .name = block->name,
                    .instance = block->instance,
                    .rows = block->rows,
                    .set = block->set,
                    .binding = block->binding,
                    .is_push_constant = block->is_push_constant,
                    .is_shared = cbuffer.declared || block->is_shared};
      places.reserve(block->members.size());
      for (const GlslInfo::UniformMember& named : block->members)
        places.emplace_back(named.var, &named);
      std::ranges::sort(places);
    }
    fact.members.reserve(cbuffer.members.size());
    for (const ir::CbufferMember& member : cbuffer.members)
      AddMember(member, block,
                std::ranges::equal_range(places, member.var, {}, &PlacedMember::first),
                fact.members);
    return fact;
  }

  // Adds the structs that the type has in it, inner before outer, each once.
  void AddStructs(ir::TypeId type, std::vector<StructFact>& to) {
    const ir::TypeTable& types = program_.types;
    type = types.Innermost(type);
    const ir::StructId id = types[type].structure;
    if (types[type].kind != ir::TypeKind::kStruct || structs_.contains(id)) return;
    StructFact fact{.size = ir::PackedExtent(types, type, false).size};
    const auto count = static_cast<std::uint32_t>(types.StructOf(type).fields.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      AddStructs(types.StructOf(type).fields[i].type, to);
      fact.fields.push_back(Field(type, i));
    }
    // Instances of a template and structs of several namespaces have one name.
    fact.name = types[id].name;
    for (int number = 2; !fact.name.empty() && !taken_.insert(fact.name).second; ++number)
      fact.name = types[id].name + "_" + std::to_string(number);
    structs_.emplace(id, NamedStruct{to.size(), fact.name});
    to.push_back(std::move(fact));
  }

  std::vector<std::uint32_t> DimensionsOf(const ir::Type& type) const {
    std::vector<std::uint32_t> dimensions;
    for (const ir::Type* of = &type; of->kind == ir::TypeKind::kArray && of->count > 0;
         of = &program_.types[of->element])
      dimensions.push_back(of->count);
    return dimensions;
  }

  ResourceFact::Part Part(ir::VarId var, const ir::Resource* resource) const {
    const ir::Type& type = program_.types[program_.vars[var].type];
    ResourceFact::Part part{.name = program_.vars[var].name,
                            .type = resource && resource->declared_type
                                        ? TypeName(resource->declared_type)
                                        : TypeName(var),
                            .is_unbounded = type.kind == ir::TypeKind::kArray && type.count == 0,
                            .dimensions = DimensionsOf(type)};
    if (!resource) return part;
    if (resource->element_of) part.element_of = program_.vars[resource->element_of].name;
    part.element = resource->element;
    part.reg = FactOf(resource->reg);
    if (resource->counter_of) part.counter_of = program_.vars[resource->counter_of].name;
    return part;
  }

  std::vector<ResourceFact> Resources() const {
    std::unordered_map<std::uint32_t, const ir::Resource*> resources;
    for (const ir::Resource& resource : program_.resources)
      resources[resource.var.index] = &resource;
    const auto part = [&](ir::VarId var) -> std::optional<ResourceFact::Part> {
      if (!var) return std::nullopt;
      const auto found = resources.find(var.index);
      return Part(var, found == resources.end() ? nullptr : found->second);
    };
    std::vector<ResourceFact> facts;
    facts.reserve(info_.objects.size());
    for (const GlslInfo::Object& object : info_.objects) {
      facts.push_back({object.name, object.kind, object.set, object.binding, part(object.texture),
                       part(object.sampler)});
    }
    return facts;
  }

  // Says what the shader does with the objects that it may write.
  void AddAccess(std::vector<ResourceFact>& facts) const {
    const auto uses = ir::UsesOfObjects(program_, ir::CalleesFirst(program_));
    for (std::size_t i = 0; i < facts.size(); ++i) {
      const ir::VarId var = info_.objects[i].texture;
      if (!var || !ir::IsWritable(facts[i].kind)) continue;
      const auto [reads, writes] = uses[var.index];
      facts[i].access = !writes ? "read" : reads ? "read-write" : "write";
    }
  }

  // Whether an input that the shader reads passes the test.
  bool ReadsInput(auto&& test) const {
    for (std::size_t i = 0; i < program_.inputs.size(); ++i) {
      if (info_.inputs[i].is_used && test(program_.inputs[i])) return true;
    }
    return false;
  }

  HostFact Host() const {
    const glsl::Target& target = lowered_.target;
    HostFact fact{.framebuffer_height = info_.framebuffer_height};
    if (ReadsInput([](const IoVar& input) { return input.builtin == ir::Builtin::kFrontFacing; })) {
      const bool is_turned = target.flips_y && !target.IsVulkan();
      fact.front_face = is_turned ? "counterclockwise" : "clockwise";
    }
    const bool is_flat = ReadsInput([&](const IoVar& input) {
      return input.builtin == ir::Builtin::kNone &&
             (input.interpolation == ir::Interpolation::kNoInterpolation ||
              ir::IsInteger(program_.types[program_.vars[input.var].type].scalar));
    });
    fact.first_vertex_provokes = is_flat && !target.IsVulkan();
    return fact;
  }

  const Lowered& lowered_;
  const Program& program_;
  const GlslInfo& info_;
  struct NamedStruct {
    std::size_t number;  // in the facts
    std::string name;    // there
  };
  std::map<ir::StructId, NamedStruct> structs_;
  std::set<std::string> taken_;  // names of structs
};

PlaneFacts Planes(const DescribedStage& stage, const PositionMatrices& position) {
  const clip_table::ClipTable& table = stage.table;
  return {.lowering = table.lowering,
          .space = table.plane_space,
          .position_matrices = position.count,
          .position_product = position.product,
          .planes = table.planes,
          .enable_mask = table.enable_mask,
          .clip_distance_mask = stage.info.clip_distance_mask,
          .cull_distance_mask = stage.info.cull_distance_mask};
}

}  // namespace

Facts MakeFacts(std::span<const DescribedStage> stages, const PositionMatrices& position) {
  Facts facts{.target = std::string(stages.front().lowered.target.name())};
  facts.stages.reserve(stages.size());
  for (const DescribedStage& stage : stages) {
    facts.stages.push_back(Describer(stage).Describe(stage.table));
    if (InfoOf(stage.lowered.program.stage).has_stage_after) facts.planes = Planes(stage, position);
  }
  return facts;
}

}  // namespace clipc
