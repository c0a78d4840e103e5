// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/facts_json.h"

#include <string_view>
#include <utility>

#include "compiler/compile/json_writer.h"

namespace clipc {
namespace {

constexpr Named<ir::Interpolation> kInterpolations[] = {
    {ir::Interpolation::kDefault, ""},
    {ir::Interpolation::kLinear, "linear"},
    {ir::Interpolation::kNoInterpolation, "nointerpolation"},
    {ir::Interpolation::kNoPerspective, "noperspective"}};

class FactsPrinter {
 public:
  std::string Print(const Facts& facts) && {
    json_.Object([&] { Document(facts); });
    return std::move(json_).Finish();
  }

 private:
  // A key is in the document only where there is something to say.
  void Flag(bool is_true, JsonKey key) {
    if (is_true) json_.Member(key, true);
  }
  void Text(std::string_view text, JsonKey key) {
    if (!text.empty()) json_.Member(key, text);
  }
  void Number(const std::optional<std::uint32_t>& number, JsonKey key) {
    if (number) json_.Member(key, *number);
  }

  void Document(const Facts& facts) {
    const StageFacts& shader = facts.stages.front();
    stages_ = facts.stages.size();
    json_.Member("version", 1);
    json_.Member("entry", shader.entry);
    json_.Member("profile", shader.profile);
    json_.Member("target", facts.target);
    Stage(shader);
    if (facts.planes) Planes(*facts.planes);
    for (const StageFacts& next : std::span(facts.stages).subspan(1)) {
      json_.Object(JsonKey(next.stage + "Shader"), [&] {
        json_.Member("entry", next.entry);
        json_.Member("profile", next.profile);
        Stage(next);
      });
    }
  }

  void Stage(const StageFacts& facts) {
    if (facts.is_named) json_.Member("stage", facts.stage);
    json_.ListOf("inputs", facts.inputs, [&](const VariableFact& fact) {
      Variable(fact);
      json_.Member("used", fact.is_used);
    });
    json_.ListOf("outputs", facts.outputs, [&](const VariableFact& fact) { Variable(fact); });
    json_.ListOf("cbuffers", facts.buffers,
                 [&](const BufferFact& fact) { Buffer(fact, facts.draws_pixels); });
    json_.ListOf("structs", facts.structs, [&](const StructFact& fact) {
      json_.Member("name", fact.name.empty() ? "<unnamed struct>" : fact.name);
      json_.Member("size", fact.size);
      json_.ListOf("fields", fact.fields,
                   [&](const FieldFact& field) { Field(field, field.row_major); });
    });
    json_.ListOf("resources", facts.resources, [&](const ResourceFact& fact) { Resource(fact); });
    if (facts.draws_pixels) json_.Object("host", [&] { Host(facts.host); });
    if (facts.group) json_.Object("group", [&] { Group(*facts.group); });
    if (facts.tessellation)
      json_.Object("tessellation", [&] { Tessellation(*facts.tessellation); });
    if (facts.emission) json_.Object("emission", [&] { Emission(*facts.emission); });
    Flag(facts.tests_early, "earlyTests");
  }

  void Tessellation(const TessellationFact& fact) {
    json_.Member("domain", fact.domain);
    json_.Member("partitioning", fact.partitioning);
    json_.Member("topology", fact.topology);
    json_.Member("inputPoints", fact.input_points);
    if (fact.output_points > 0) json_.Member("outputPoints", fact.output_points);
    if (fact.max_factor) json_.Member("maxFactor", *fact.max_factor);
  }

  void Emission(const EmissionFact& fact) {
    json_.Member("input", fact.input);
    json_.Member("inputVertices", fact.input_vertices);
    json_.Member("output", fact.output);
    json_.Member("maxVertices", fact.max_vertices);
    json_.Member("instances", fact.instances);
    json_.Member("streams", fact.streams);
  }

  void Group(const GroupFact& fact) {
    const auto [x, y, z] = fact.size;
    json_.Member("x", x), json_.Member("y", y), json_.Member("z", z);
    json_.Member("sharedBytes", fact.shared_bytes);
  }

  void Variable(const VariableFact& fact) {
    json_.Member("semantic", fact.semantic);
    json_.Member("index", fact.index);
    json_.Member("type", fact.type);
    json_.Member("name", fact.name);
    Number(fact.location, "location");
    Number(fact.render_target, "renderTarget");
    if (fact.blend_index > 0) json_.Member("blendIndex", fact.blend_index);
    Flag(fact.needs_base_vertex_zero, "needsBaseVertexZero");
    Flag(fact.needs_base_instance_zero, "needsBaseInstanceZero");
    Flag(fact.integer_as_float, "integerAsFloat");
    json_.Member("builtin", fact.is_builtin);
    Flag(fact.is_of_patch, "patch");
    Text(NameIn<kInterpolations>(fact.interpolation), "interpolation");
    Flag(fact.centroid, "centroid");
    Flag(fact.sample, "sample");
    Number(fact.stream, "stream");
    if (!fact.reader) return;
    json_.Object(JsonKey(fact.reader->stage + "Input"), [&] {
      json_.Member("name", fact.reader->name);
      Number(fact.reader->element, "element");
    });
  }

  void Register(const RegisterFact& reg) {
    json_.Member("register", reg.name);
    json_.Member("space", reg.space);
    json_.Member("explicit", reg.is_explicit);
  }

  void Buffer(const BufferFact& fact, bool is_pixel) {
    json_.Member("name", fact.name);
    json_.Member("kind", fact.kind);
    Register(fact.reg);
    json_.Member("size", fact.size);
    Flag(fact.count == 0, "unbounded");
    if (fact.count > 1) json_.Member("count", fact.count);
    json_.Member("used", fact.block.has_value());
    if (fact.block) json_.Object("glsl", [&] { Block(*fact.block, is_pixel); });
    json_.ListOf("members", fact.members, [&](const MemberFact& member) { Member(member); });
  }

  void Block(const BufferFact::Block& block, bool is_pixel) {
    json_.Member("layout", block.layout);
    Text(block.name, "block");
    Text(block.instance, "instance");
    Text(block.rows, "rows");
    Number(block.set, "set");
    Number(block.binding, "binding");
    Flag(block.is_push_constant, "pushConstant");
    // In a program of more than two, it does not say which ones.
    Flag(block.is_shared, stages_ > 2 ? JsonKey("shared")
                          : is_pixel  ? JsonKey("sharedWithVertexShader")
                                      : JsonKey("sharedWithPixelShader"));
  }

  void Field(const FieldFact& fact, bool is_row_major) {
    json_.Member("name", fact.name);
    json_.Member("type", fact.type);
    json_.Member("offset", fact.offset);
    json_.Member("size", fact.size);
    Flag(is_row_major, "rowMajor");
  }

  void Member(const MemberFact& fact) {
    Field(fact, fact.IsRowMajor());
    Text(HexadecimalDigits(fact.initial), "default");
    Place(fact.place);
    if (fact.fields.empty()) return;
    json_.ListOf("fields", fact.fields, [&](const FieldFact& field) {
      Field(field, field.row_major);
      Place(field.place);
    });
  }

  void Place(const std::optional<GlslPlace>& place) {
    if (!place) return;
    json_.Member("glsl", place->glsl);
    Text(place->function, "function");
    Flag(place->is_uniform && place->is_row, "uniform");
    if (place->is_uniform) json_.Member("transpose", place->transpose);
  }

  void Resource(const ResourceFact& fact) {
    json_.Member("glsl", fact.glsl);
    Number(fact.set, "set");
    Number(fact.binding, "binding");
    Text(fact.access, "access");
    if (fact.texture) json_.Object("texture", [&] { Part(*fact.texture); });
    if (fact.sampler) json_.Object("sampler", [&] { Part(*fact.sampler); });
  }

  void Part(const ResourceFact::Part& part) {
    json_.Member("name", part.name);
    json_.Member("type", part.type);
    Flag(part.is_unbounded, "unbounded");
    if (part.reg) Register(*part.reg);
    Text(part.counter_of, "counterOf");
  }

  void Host(const HostFact& fact) {
    Text(fact.framebuffer_height, "framebufferHeight");
    Text(fact.front_face, "frontFace");
    if (fact.first_vertex_provokes) json_.Member("provokingVertex", "first");
  }

  void Planes(const PlaneFacts& facts) {
    const auto or_null = [&](JsonKey key, const auto& value) {
      if (value) {
        json_.Member(key, *value);
      } else {
        json_.Null(key);
      }
    };
    json_.Member("lowering", NameOf(facts.lowering));
    json_.Member("positionSpace", clip_table::TableNameOf(facts.space));
    or_null("positionMatrices", facts.position_matrices);
    or_null("positionProduct", facts.position_product);
    json_.ListOf("clipPlanes", facts.planes, [&](const clip_table::Plane& plane) { Plane(plane); });
    json_.Member("enableMask", facts.enable_mask);
    json_.Member("clipDistanceMask", facts.clip_distance_mask);
    json_.Member("cullDistanceMask", facts.cull_distance_mask);
  }

  void Plane(const clip_table::Plane& plane) {
    json_.Member("index", plane.index);
    json_.Member("text", plane.text);
    if (!plane.constant) return;
    const clip_table::Constant& constant = *plane.constant;
    json_.Member("cbuffer", constant.cbuffer);
    json_.Member("register", "b" + std::to_string(constant.register_number));
    json_.Member("space", constant.register_space);
    json_.Member("offset", constant.byte_offset);
    Text(constant.glsl_block, "glslBlock");
    Text(constant.glsl_member, "glsl");
  }

  JsonWriter json_;
  std::size_t stages_ = 1;  // of the program
};

}  // namespace

std::string HexadecimalDigits(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string text;
  for (const std::uint8_t byte : bytes) {
    text += kDigits[byte >> 4];
    text += kDigits[byte & 15];
  }
  return text;
}

std::string FactsJson(const Facts& facts) { return FactsPrinter().Print(facts); }

}  // namespace clipc
