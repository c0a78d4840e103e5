// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/signature/locations.h"

namespace clipc::signature {

std::uint32_t Locations::Next(std::optional<std::uint32_t> given, const Type& type,
                              std::string_view name, Span span) {
  if (count_ == 0) are_given_ = given.has_value();
  if (given.has_value() != are_given_) {
    diagnostics_.Report(span, diag::LocationPartial, name,
                        given ? "has a location" : "has no location", which_);
  }
  ++count_;
  if (!given) return count_ - 1;
  if (*given + LocationCount(type) > kLocations)
    diagnostics_.Report(span, diag::LocationTooHigh, *given, name, kLocations - 1);
  for (std::uint32_t i = *given; i < *given + LocationCount(type); ++i) {
    const auto [other, is_free] = given_.emplace(i, name);
    if (!is_free) diagnostics_.Report(span, diag::LocationTwice, i, name, other->second);
  }
  return *given;
}

}  // namespace clipc::signature
