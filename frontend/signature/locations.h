// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "frontend/signature/names.h"

namespace clipc::signature {

// The number of locations that glslang accepts, from 0 on (layoutLocationEnd).
inline constexpr std::uint32_t kLocations = 0xFFF;

// The locations of a shader's inputs, or of its outputs.
class Locations {
 public:
  // `which` names the inputs or outputs in messages: "inputs".
  Locations(std::string_view which, Diagnostics& diagnostics)
      : which_(which), diagnostics_(diagnostics) {}

  // Returns the location of the next input or output: `given`, from its [[vk::location]], otherwise
  // the next number. Reports a location that is given twice. Either all of them have the attribute
  // or none has, as in DXC, which calls anything else "partial explicit stage input location
  // assignment" and refuses it.
  std::uint32_t Next(std::optional<std::uint32_t> given, const Type& type, std::string_view name,
                     Span span);

 private:
  std::string_view which_;
  Diagnostics& diagnostics_;
  std::uint32_t count_ = 0;
  bool are_given_ = false;
  std::map<std::uint32_t, std::string> given_;  // the name of the owner, by location
};

}  // namespace clipc::signature
