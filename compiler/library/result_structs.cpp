// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/library/result_structs.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <ranges>
#include <string>

namespace clipc {
namespace {

void Add(const Message& message, std::vector<clipc_diagnostic>& to) {
  const clipc_severity severity = message.severity == Severity::kError     ? CLIPC_ERROR
                                  : message.severity == Severity::kWarning ? CLIPC_WARNING
                                                                           : CLIPC_NOTE;
  const Place& place = message.place;
  to.push_back({severity, message.name.c_str(), message.code.c_str(), message.text.c_str(),
                place.file.c_str(), place.line, place.column, place.end_line, place.end_column});
  for (const Message& note : message.notes) Add(note, to);
}

std::int32_t NumberOrNone(const std::optional<std::uint32_t>& number) {
  return number ? static_cast<std::int32_t>(*number) : -1;
}

}  // namespace

std::vector<clipc_diagnostic> ToDiagnostics(const std::vector<Message>& messages) {
  std::vector<clipc_diagnostic> diagnostics;
  for (const Message& message : messages) Add(message, diagnostics);
  return diagnostics;
}

class ReflectionStructs::Printer {
 public:
  explicit Printer(ReflectionStructs& to) : to_(to) {}

  clipc_reflection& Shader(const StageFacts& facts) {
    clipc_reflection& shader = to_.shaders_.emplace_back();
    shader.entry = facts.entry.c_str();
    shader.profile = facts.profile.c_str();
    List(facts.inputs, to_.variable_lists_, shader.inputs, shader.input_count);
    List(facts.outputs, to_.variable_lists_, shader.outputs, shader.output_count);
    List(facts.buffers, to_.buffer_lists_, shader.buffers, shader.buffer_count);
    List(facts.resources, to_.resource_lists_, shader.resources, shader.resource_count);
    if (facts.group) {
      std::ranges::copy(facts.group->size, shader.group_size);
      shader.shared_bytes = facts.group->shared_bytes;
    }
    shader.input_primitive = shader.output_primitive = "";
    if (facts.emission) {
      shader.input_primitive = facts.emission->input.c_str();
      shader.output_primitive = facts.emission->output.c_str();
      shader.input_vertices = facts.emission->input_vertices;
      shader.max_vertices = facts.emission->max_vertices;
      shader.instances = facts.emission->instances;
    }
    shader.domain = shader.partitioning = shader.topology = "";
    if (const auto& patch = facts.tessellation) {
      shader.domain = patch->domain.c_str();
      shader.partitioning = patch->partitioning.c_str();
      shader.topology = patch->topology.c_str();
      shader.input_points = patch->input_points;
      shader.output_points = patch->output_points;
      shader.max_factor = patch->max_factor.value_or(0);
    }
    return shader;
  }

 private:
  template <class Facts, class Lists, class First>
  void List(const Facts& facts, Lists& lists, First& first, std::size_t& count) {
    auto& list = lists.emplace_back();
    for (const auto& fact : facts) list.push_back(Struct(fact));
    first = list.data();
    count = list.size();
  }

  const clipc_variable* Struct(const VariableFact& fact) {
    return &to_.variables_.emplace_back(
        clipc_variable{fact.semantic.c_str(), fact.index, fact.type.c_str(), fact.name.c_str(),
                       NumberOrNone(fact.location), fact.is_builtin, fact.is_used,
                       fact.stream.value_or(0), fact.is_of_patch});
  }

  const clipc_member* Struct(const MemberFact& fact) {
    return &to_.members_.emplace_back(clipc_member{fact.name.c_str(), fact.type.c_str(),
                                                   fact.offset, fact.size,
                                                   fact.place ? fact.place->glsl.c_str() : ""});
  }

  const clipc_buffer* Struct(const BufferFact& fact) {
    const bool is_used = fact.block.has_value();
    clipc_buffer& buffer = to_.buffers_.emplace_back(clipc_buffer{
        fact.name.c_str(), fact.reg.name.c_str(), fact.reg.space, fact.size, is_used,
        is_used ? fact.block->name.c_str() : "", is_used ? NumberOrNone(fact.block->set) : -1,
        is_used ? NumberOrNone(fact.block->binding) : -1, nullptr, 0});
    List(fact.members, to_.member_lists_, buffer.members, buffer.member_count);
    return &buffer;
  }

  const clipc_resource* Struct(const ResourceFact& fact) {
    const auto text = [](const auto& part, const std::string& (*of)(const ResourceFact::Part&)) {
      return part ? of(*part).c_str() : "";
    };
    const auto name = [](const ResourceFact::Part& part) -> const std::string& {
      return part.name;
    };
    const auto type = [](const ResourceFact::Part& part) -> const std::string& {
      return part.type;
    };
    const auto reg = [](const ResourceFact::Part& part) -> const std::string& {
      static const std::string kNone;
      return part.reg ? part.reg->name : kNone;
    };
    return &to_.resources_.emplace_back(
        clipc_resource{fact.glsl.c_str(), NumberOrNone(fact.set), NumberOrNone(fact.binding),
                       text(fact.texture, name), text(fact.texture, type), text(fact.texture, reg),
                       text(fact.sampler, name), text(fact.sampler, type), text(fact.sampler, reg),
                       fact.access.c_str()});
  }

  ReflectionStructs& to_;
};

ReflectionStructs::ReflectionStructs(const Facts& facts) {
  Printer printer(*this);
  for (const StageFacts& stage : facts.stages) printer.Shader(stage);
  if (facts.stages.size() > 1 && facts.stages.back().draws_pixels)
    shaders_.front().pixel_shader = &shaders_.back();
}

}  // namespace clipc
