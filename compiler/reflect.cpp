// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/reflect.h"

#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "ir/packing.h"

namespace clipc {
namespace {

using clip_table::ClipTable;
using glsl::GlslInfo;
using ir::IoVar;
using ir::Program;
using Json = nlohmann::ordered_json;

Json ToJson(const ir::Register& reg) {
  return {{"register", std::string(1, reg.letter) + std::to_string(reg.number)},
          {"space", reg.space},
          {"explicit", reg.is_explicit}};
}

constexpr Named<ir::Interpolation> kInterpolations[] = {
    {ir::Interpolation::kDefault, ""},
    {ir::Interpolation::kLinear, "linear"},
    {ir::Interpolation::kNoInterpolation, "nointerpolation"},
    {ir::Interpolation::kNoPerspective, "noperspective"}};
constexpr Named<ir::CbufferKind> kCbufferKinds[] = {
    {ir::CbufferKind::kCbuffer, "cbuffer"},
    {ir::CbufferKind::kTbuffer, "tbuffer"},
    {ir::CbufferKind::kGlobals, "globals"},
    {ir::CbufferKind::kParams, "params"},
    {ir::CbufferKind::kConstantBuffer, "ConstantBuffer"}};
constexpr Named<glsl::BlockForm> kBlockForms[] = {{glsl::BlockForm::kStd140, "std140"},
                                                  {glsl::BlockForm::kRows, "rows"},
                                                  {glsl::BlockForm::kUniforms, "uniforms"}};

Json InputOrOutput(const Program& program, const IoVar& io, const GlslInfo::Variable& written) {
  Json json = {{"semantic", io.semantic},
               {"index", io.index},
               {"type", program.types.Name(program.vars[io.var].type)},
               {"name", written.name}};
  if (written.location) json["location"] = *written.location;
  const bool is_target = program.vars[io.var].storage == ir::Storage::kOutput &&
                         io.builtin == ir::Builtin::kNone && !InfoOf(program.stage).has_stage_after;
  if (is_target) json["renderTarget"] = io.location;
  if (io.blend_index > 0) json["blendIndex"] = io.blend_index;
  if (written.needs_base_vertex_zero) json["needsBaseVertexZero"] = true;
  if (written.needs_base_instance_zero) json["needsBaseInstanceZero"] = true;
  if (written.integer_as_float) json["integerAsFloat"] = true;
  json["builtin"] = io.builtin != ir::Builtin::kNone;
  if (io.interpolation != ir::Interpolation::kDefault)
    json["interpolation"] = NameIn<kInterpolations>(io.interpolation);
  if (io.centroid) json["centroid"] = true;
  if (io.sample) json["sample"] = true;
  if (io.reader && io.reader->is_known) {
    const ir::Reader& reader = *io.reader;
    Json& input = json["pixelInput"];
    input["name"] = reader.name.empty() ? io.semantic + std::to_string(io.index) : reader.name;
    if (!reader.IsWhole()) input["element"] = reader.element;
  }
  return json;
}

// Every input or output of the signature; an input says whether the shader reads it.
Json Signature(const Program& program, const std::vector<IoVar>& signature,
               const std::vector<GlslInfo::Variable>& written, bool is_input) {
  Json json = Json::array();
  for (std::size_t i = 0; i < signature.size(); ++i) {
    json.push_back(InputOrOutput(program, signature[i], written[i]));
    if (is_input) json.back()["used"] = written[i].is_used;
  }
  return json;
}

Json Field(const Program& program, ir::TypeId type, int index) {
  const ir::TypeTable& types = program.types;
  type = types.Innermost(type);
  const auto number = static_cast<std::uint32_t>(index);
  const ir::Field& field = types.StructOf(type).fields[number];
  Json json = {{"name", field.name},
               {"type", types.Name(field.type)},
               {"offset", ir::FieldOffset(types, types[type].structure, number)},
               {"size", ir::PackedExtent(types, field.type, field.row_major).size}};
  if (field.row_major) json["rowMajor"] = true;
  return json;
}

// The bytes in hexadecimal digits.
std::string InitialBytes(const Program& program, const ir::CbufferMember& member) {
  const ir::Var& var = program.vars[member.var];
  std::string text;
  for (const std::uint8_t byte : ir::Packed(program.types, var.type, var.row_major, member.initial))
    text += fmt::format("{:02X}", byte);
  return text;
}

Json Member(const Program& program, const ir::CbufferMember& member,
            const GlslInfo::UniformBlock* block) {
  const ir::Var& var = program.vars[member.var];
  Json json = {{"name", var.name},
               {"type", program.types.Name(var.type)},
               {"offset", member.offset},
               {"size", member.size}};
  const ir::TypeId innermost = program.types.Innermost(var.type);
  // The matrices in a struct are as its fields say.
  if (var.row_major && program.types[innermost].kind != ir::TypeKind::kStruct)
    json["rowMajor"] = true;
  if (!member.initial.empty()) json["default"] = InitialBytes(program, member);
  if (!block) return json;
  for (const GlslInfo::UniformMember& named : block->members) {
    if (named.var != member.var) continue;
    // A ConstantBuffer's fields are members of the GLSL block.
    Json& entry =
        named.field < 0 ? json : json["fields"].emplace_back(Field(program, var.type, named.field));
    entry["glsl"] = named.NameAt(member.offset);
    if (!named.function.empty()) entry["function"] = named.function;
    if (named.is_uniform && block->form == glsl::BlockForm::kRows) entry["uniform"] = true;
    if (named.is_uniform) entry["transpose"] = named.transpose;
  }
  return json;
}

// The structs that the type has in it, inner before outer, each once.
void AddStructs(const Program& program, ir::TypeId type, std::set<ir::StructId>& known, Json& to) {
  const ir::TypeTable& types = program.types;
  type = types.Innermost(type);
  if (types[type].kind != ir::TypeKind::kStruct || !known.insert(types[type].structure).second)
    return;
  Json json = {{"name", types.Name(type)},
               {"size", ir::PackedExtent(types, type, false).size},
               {"fields", Json::array()}};
  const std::size_t fields = types.StructOf(type).fields.size();
  for (std::size_t i = 0; i < fields; ++i) {
    AddStructs(program, types.StructOf(type).fields[i].type, known, to);
    json["fields"].push_back(Field(program, type, static_cast<int>(i)));
  }
  to.push_back(std::move(json));
}

Json Structs(const Program& program) {
  Json list = Json::array();
  std::set<ir::StructId> known;
  for (const ir::CbufferId id : program.cbuffers.ids()) {
    for (const ir::CbufferMember& member : program.cbuffers[id].members)
      AddStructs(program, program.vars[member.var].type, known, list);
  }
  return list;
}

void AddBinding(const std::optional<std::uint32_t>& set,
                const std::optional<std::uint32_t>& binding, Json& to) {
  if (set) to["set"] = *set;
  if (binding) to["binding"] = *binding;
}

Json CbufferJson(const Program& program, ir::CbufferId id, const GlslInfo& info) {
  const ir::Cbuffer& cbuffer = program.cbuffers[id];
  const GlslInfo::UniformBlock* block = info.BlockOf(id);
  Json json = {{"name", cbuffer.name}, {"kind", NameIn<kCbufferKinds>(cbuffer.kind)}};
  json.update(ToJson(cbuffer.reg));
  json["size"] = cbuffer.size;
  if (cbuffer.count == 0)
    json["unbounded"] = true;
  else if (cbuffer.count != 1)
    json["count"] = cbuffer.count;
  json["used"] = block != nullptr;
  if (block) {
    Json& glsl = json["glsl"];
    glsl["layout"] = NameIn<kBlockForms>(block->form);
    if (!block->name.empty()) glsl["block"] = block->name;
    if (!block->instance.empty()) glsl["instance"] = block->instance;
    if (!block->rows.empty()) glsl["rows"] = block->rows;
    AddBinding(block->set, block->binding, glsl);
    if (block->is_push_constant) glsl["pushConstant"] = true;
    const bool is_pixel = InfoOf(program.stage).draws_pixels;
    if (cbuffer.declared || block->is_shared)
      glsl[is_pixel ? "sharedWithVertexShader" : "sharedWithPixelShader"] = true;
  }
  json["members"] = Json::array();
  for (const ir::CbufferMember& member : cbuffer.members)
    json["members"].push_back(Member(program, member, block));
  return json;
}

Json Objects(const Program& program, const GlslInfo& info) {
  Json list = Json::array();
  for (const GlslInfo::Object& object : info.objects) {
    Json json = {{"glsl", object.name}};
    AddBinding(object.set, object.binding, json);
    for (const auto& [key, var] :
         {std::pair{"texture", object.texture}, std::pair{"sampler", object.sampler}}) {
      if (!var) continue;
      json[key] = {{"name", program.vars[var].name},
                   {"type", program.types.Name(program.vars[var].type)}};
      const ir::Type& type = program.types[program.vars[var].type];
      if (type.kind == ir::TypeKind::kArray && type.count == 0) json[key]["unbounded"] = true;
      for (const ir::Resource& resource : program.resources) {
        if (resource.var != var) continue;
        json[key].update(ToJson(resource.reg));
        if (resource.counter_of) json[key]["counterOf"] = program.vars[resource.counter_of].name;
      }
    }
    list.push_back(std::move(json));
  }
  return list;
}

Json Planes(const ClipTable& table) {
  Json list = Json::array();
  for (const clip_table::Plane& plane : table.planes) {
    Json json = {{"index", plane.index}, {"text", plane.text}};
    if (plane.constant) {
      const clip_table::Constant& constant = *plane.constant;
      json["cbuffer"] = constant.cbuffer;
      json["register"] = "b" + std::to_string(constant.register_number);
      json["space"] = constant.register_space;
      json["offset"] = constant.byte_offset;
      if (!constant.glsl_block.empty()) json["glslBlock"] = constant.glsl_block;
      if (!constant.glsl_member.empty()) json["glsl"] = constant.glsl_member;
    }
    list.push_back(std::move(json));
  }
  return list;
}

// Whether an input that the shader reads passes the test.
bool ReadsInput(const Program& program, const GlslInfo& info, auto&& test) {
  for (std::size_t i = 0; i < program.inputs.size(); ++i) {
    if (info.inputs[i].is_used && test(program.inputs[i])) return true;
  }
  return false;
}

// What the host sets so that a stage that draws pixels gets Direct3D's values.
Json Host(const Lowered& lowered, const GlslInfo& info) {
  const Program& program = lowered.program;
  const glsl::Target& target = lowered.target;
  Json json = Json::object();
  if (!info.framebuffer_height.empty()) json["framebufferHeight"] = info.framebuffer_height;
  if (ReadsInput(program, info,
                 [](const IoVar& input) { return input.builtin == ir::Builtin::kFrontFacing; })) {
    const bool is_turned = target.flips_y && !target.IsVulkan();
    json["frontFace"] = is_turned ? "counterclockwise" : "clockwise";
  }
  const bool is_flat = ReadsInput(program, info, [&](const IoVar& input) {
    return input.builtin == ir::Builtin::kNone &&
           (input.interpolation == ir::Interpolation::kNoInterpolation ||
            ir::IsInteger(program.types[program.vars[input.var].type].scalar));
  });
  if (is_flat && !target.IsVulkan()) json["provokingVertex"] = "first";
  return json;
}

// What is said of each stage.
Json StageJson(const ReflectedStage& stage) {
  const Program& program = stage.lowered.program;
  const GlslInfo& info = stage.info;
  const StageInfo& traits = InfoOf(program.stage);
  Json json = {{"version", 1},
               {"entry", stage.table.entry},
               {"profile", stage.table.profile},
               {"target", stage.lowered.target.name()}};
  if (traits.draws_pixels) json["stage"] = traits.name;
  json["inputs"] = Signature(program, program.inputs, info.inputs, true);
  json["outputs"] = Signature(program, program.outputs, info.outputs, false);
  json["cbuffers"] = Json::array();
  for (ir::CbufferId id : program.cbuffers.ids())
    json["cbuffers"].push_back(CbufferJson(program, id, info));
  json["structs"] = Structs(program);
  json["resources"] = Objects(program, info);
  if (traits.draws_pixels) json["host"] = Host(stage.lowered, info);
  if (program.tests_early) json["earlyTests"] = true;
  return json;
}

// The part about clip planes and the position, of a stage with a stage after it.
void AddPlanes(const ReflectedStage& stage, const PositionMatrices& position, Json& json) {
  const ClipTable& table = stage.table;
  json["lowering"] = NameOf(table.lowering);
  json["positionSpace"] = clip_table::TableNameOf(table.plane_space);
  json["positionMatrices"] = position.count ? Json(*position.count) : Json(nullptr);
  json["positionProduct"] = position.product ? Json(*position.product) : Json(nullptr);
  json["clipPlanes"] = Planes(table);
  json["enableMask"] = table.enable_mask;
  json["clipDistanceMask"] = stage.info.clip_distance_mask;
  json["cullDistanceMask"] = stage.info.cull_distance_mask;
}

}  // namespace

void AddInitialValues(const Program& program, std::map<std::string, std::string>& to) {
  for (const ir::CbufferId id : program.cbuffers.ids()) {
    for (const ir::CbufferMember& member : program.cbuffers[id].members) {
      if (!member.initial.empty())
        to.emplace(program.vars[member.var].name, InitialBytes(program, member));
    }
  }
}

std::string Reflect(const ReflectedStage& stage, const PositionMatrices& position,
                    const ReflectedStage* pixel) {
  Json json = StageJson(stage);
  if (InfoOf(stage.lowered.program.stage).has_stage_after) AddPlanes(stage, position, json);
  if (pixel) {
    Json& half = json["pixelShader"] = StageJson(*pixel);
    half.erase("version");
    half.erase("target");
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace clipc
