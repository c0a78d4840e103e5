// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <string>

namespace clipc::random {

enum class Feature : std::uint8_t {
#define FEATURE(Enumerator, ...) k##Enumerator,
#include "tools/random/features.def"
  kCount
};

// The features that generated programs may have; at first those that are on by default.
class Features {
 public:
  Features();
  bool Has(Feature feature) const { return set_[static_cast<std::size_t>(feature)]; }
  void Set(Feature feature, bool on) { set_[static_cast<std::size_t>(feature)] = on; }
  // Sets the features of a list, "matrices,loops". Throws DrawError for a name that is not a
  // feature's.
  void Set(const std::string& names, bool on);
  // A line for each feature: its name, whether it is on by default, and its description.
  static std::string List();

 private:
  std::bitset<static_cast<std::size_t>(Feature::kCount)> set_;
};

}  // namespace clipc::random
