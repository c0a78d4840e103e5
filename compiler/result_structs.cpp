// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/result_structs.h"

#include <cstdint>
#include <string_view>

#include <nlohmann/json.hpp>

namespace clipc {
namespace {

using Json = nlohmann::ordered_json;

void Add(const Message& message, std::vector<clipc_diagnostic>& to) {
  const clipc_severity severity = message.severity == Severity::kError     ? CLIPC_ERROR
                                  : message.severity == Severity::kWarning ? CLIPC_WARNING
                                                                           : CLIPC_NOTE;
  const Place& place = message.place;
  to.push_back({severity, message.name.c_str(), message.code.c_str(), message.text.c_str(),
                place.file.c_str(), place.line, place.column, place.end_line, place.end_column});
  for (const Message& note : message.notes) Add(note, to);
}

// The member of an object; null if there is none.
const Json& At(const Json& json, std::string_view key) {
  static const Json kNone;
  const auto found = json.find(key);
  return found == json.end() ? kNone : *found;
}

template <class Number>
Number NumberAt(const Json& json, std::string_view key, Number otherwise) {
  const Json& value = At(json, key);
  return value.is_number() ? value.get<Number>() : otherwise;
}

bool FlagAt(const Json& json, std::string_view key, bool otherwise = false) {
  const Json& value = At(json, key);
  return value.is_boolean() ? value.get<bool>() : otherwise;
}

}  // namespace

std::vector<clipc_diagnostic> ToDiagnostics(const std::vector<Message>& messages) {
  std::vector<clipc_diagnostic> diagnostics;
  for (const Message& message : messages) Add(message, diagnostics);
  return diagnostics;
}

class ReflectionStructs::Reader {
 public:
  explicit Reader(ReflectionStructs& to) : to_(to) {}

  const clipc_reflection* Shader(const Json& json) {
    clipc_reflection& shader = to_.shaders_.emplace_back();
    shader.entry = Text(json, "entry");
    shader.profile = Text(json, "profile");
    const auto variable = [&](const Json& each) { return Variable(each); };
    List(At(json, "inputs"), to_.variable_lists_, variable, shader.inputs, shader.input_count);
    List(At(json, "outputs"), to_.variable_lists_, variable, shader.outputs, shader.output_count);
    List(
        At(json, "cbuffers"), to_.buffer_lists_, [&](const Json& each) { return Buffer(each); },
        shader.buffers, shader.buffer_count);
    List(
        At(json, "resources"), to_.resource_lists_,
        [&](const Json& each) { return Resource(each); }, shader.resources, shader.resource_count);
    if (const Json& pixel = At(json, "pixelShader"); pixel.is_object())
      shader.pixel_shader = Shader(pixel);
    return &shader;
  }

 private:
  const char* Text(const Json& json, std::string_view key) {
    const Json& value = At(json, key);
    if (!value.is_string()) return "";
    return to_.texts_.emplace_back(value.get<std::string>()).c_str();
  }

  template <class Lists, class Read, class First>
  static void List(const Json& json, Lists& lists, Read read, First& first, std::size_t& count) {
    auto& list = lists.emplace_back();
    for (const Json& each : json) list.push_back(read(each));
    first = list.data();
    count = list.size();
  }

  const clipc_variable* Variable(const Json& json) {
    return &to_.variables_.emplace_back(clipc_variable{
        Text(json, "semantic"), NumberAt(json, "index", std::uint32_t{0}), Text(json, "type"),
        Text(json, "name"), NumberAt(json, "location", std::int32_t{-1}), FlagAt(json, "builtin"),
        FlagAt(json, "used", true)});
  }

  const clipc_member* Member(const Json& json) {
    return &to_.members_.emplace_back(clipc_member{
        Text(json, "name"), Text(json, "type"), NumberAt(json, "offset", std::uint32_t{0}),
        NumberAt(json, "size", std::uint32_t{0}), Text(json, "glsl")});
  }

  const clipc_buffer* Buffer(const Json& json) {
    const Json& glsl = At(json, "glsl");
    clipc_buffer& buffer = to_.buffers_.emplace_back(clipc_buffer{
        Text(json, "name"), Text(json, "register"), NumberAt(json, "space", std::uint32_t{0}),
        NumberAt(json, "size", std::uint32_t{0}), FlagAt(json, "used"), Text(glsl, "block"),
        NumberAt(glsl, "set", std::int32_t{-1}), NumberAt(glsl, "binding", std::int32_t{-1}),
        nullptr, 0});
    List(
        At(json, "members"), to_.member_lists_, [&](const Json& each) { return Member(each); },
        buffer.members, buffer.member_count);
    return &buffer;
  }

  const clipc_resource* Resource(const Json& json) {
    const Json &texture = At(json, "texture"), &sampler = At(json, "sampler");
    return &to_.resources_.emplace_back(
        clipc_resource{Text(json, "glsl"), NumberAt(json, "set", std::int32_t{-1}),
                       NumberAt(json, "binding", std::int32_t{-1}), Text(texture, "name"),
                       Text(texture, "type"), Text(texture, "register"), Text(sampler, "name"),
                       Text(sampler, "type"), Text(sampler, "register")});
  }

  ReflectionStructs& to_;
};

ReflectionStructs::ReflectionStructs(const std::string& json) {
  Reader(*this).Shader(Json::parse(json));
}

}  // namespace clipc
