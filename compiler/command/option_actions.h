// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include "clip-table/vocabulary.h"
#include "compiler/command/binding_options.h"
#include "compiler/command/option_table.h"
#include "compiler/compile/suggest.h"

// What options of both tables do with their values: the functions of Option::read.
namespace clipc {

template <typename Owner, typename Value>
Value& MemberOf(Reading& reading, Value Owner::* member) {
  CommandLine& command = reading.command;
  ProgramRequest& request = command.request;
  return std::get<Owner&>(std::tie(reading, reading.spirv, command, request, request.includes,
                                   request.language, request.planes, request.style,
                                   request.style.clip_space, request.link, command.pixel_shader,
                                   request.hlsl, request.outputs, request.warnings, request.limits,
                                   request.debug)).*
         member;
}

// Sets a member: a flag becomes true, a list gets one more value, a text is replaced.
template <auto kMember>
void Set(Reading& reading, const std::string& value) {
  auto& member = MemberOf(reading, kMember);
  if constexpr (std::is_same_v<decltype(member), bool&>) {
    member = true;
  } else if constexpr (requires { member.push_back(value); }) {
    member.push_back(value);
  } else {
    member = value;
  }
}

// Sets a member to what the option stands for.
template <auto kMember, auto kValue>
void SetTo(Reading& reading, const std::string&) {
  MemberOf(reading, kMember) = kValue;
}

// Reads one of the words of a table.
template <auto kMember, const auto& kNames>
void Choose(Reading& reading, const std::string& value) {
  if (const auto choice = EnumeratorOf(value, kNames)) {
    MemberOf(reading, kMember) = *choice;
    return;
  }
  std::vector<std::string_view> names;
  for (const auto& named : kNames) names.emplace_back(named.name);
  reading.Refuse(
      fmt::format("unknown value `{}` of {}{}", value, reading.option, Suggest(value, names)));
}

// The option and its value as the user wrote them, in one argument or in several.
inline std::string AsWritten(const Reading& reading, const std::string& value) {
  const bool is_one = reading.argument.size() > reading.option.size();
  return is_one ? reading.argument : reading.argument + " " + value;
}

// Reads a number from kLeast to kMost.
template <auto kMember, unsigned kLeast, unsigned kMost>
void SetNumber(Reading& reading, const std::string& value) {
  std::uint32_t number = 0;
  if (ReadNumber(value, number) && number >= kLeast && number <= kMost) {
    MemberOf(reading, kMember) = number;
    return;
  }
  reading.Refuse(fmt::format("`{}`: it must be a number from {} to {}", AsWritten(reading, value),
                             kLeast, kMost));
}

template <bool kForVulkan>
void SetSpirv(Reading& reading, const std::string&) {
  reading.writes_spirv = true;
  reading.spirv_for_vulkan = kForVulkan;
}

// dxc's names. `universal1.5` is any environment with SPIR-V 1.5, which is Vulkan 1.2's.
inline constexpr Named<VulkanVersion> kVulkanVersions[] = {
    {VulkanVersion::k1_0, "vulkan1.0"},    {VulkanVersion::k1_1, "vulkan1.1"},
    {VulkanVersion::k1_2, "vulkan1.2"},    {VulkanVersion::k1_3, "vulkan1.3"},
    {VulkanVersion::k1_2, "universal1.5"}, {VulkanVersion::k1_1WithSpirv1_4, "vulkan1.1spirv1.4"}};
inline void SetVulkanVersion(Reading& reading, const std::string& value) {
  reading.vulkan_option = reading.option;
  Choose<&SpirvRequest::vulkan, kVulkanVersions>(reading, value);
}

// Reads a rule for bindings. The advice of the option says what it accepts.
template <bool (*kRead)(glsl::BindingRules&, std::string_view), bool kIsForVulkan = true>
void Bind(Reading& reading, const std::string& value) {
  if (kIsForVulkan) reading.vulkan_option = reading.option;
  if (!kRead(reading.bindings, value))
    reading.Refuse(fmt::format("`{}`: it takes {}", AsWritten(reading, value), reading.advice));
}

// Reads -E. The last one is the entry of GLSL; HLSL may have several.
inline void SetEntry(Reading& reading, const std::string& value) {
  ProgramRequest& request = reading.command.request;
  request.first().entry = value;
  request.hlsl.entries.push_back(value);
}

inline void SetDependencyFile(Reading& reading, const std::string& value) {
  reading.command.write_dependencies = true;
  reading.command.dependency_file = value;
}

}  // namespace clipc
