// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/check_options.h"

#include <utility>

namespace clipc {

CheckOptions CheckOptions::For(ir::Profile profile, LanguageVersion language) {
  CheckOptions options;
  const bool has_versions = profile.IsAtLeast(6, 0);
  options.language = language;
  options.has_templates = !has_versions || language >= LanguageVersion::k2021;
  options.has_enums = !has_versions || language >= LanguageVersion::k2017;
  options.casts_structs = has_versions && language >= LanguageVersion::k2021;
  options.scopes_loops = has_versions && language >= LanguageVersion::k2021;
  options.short_circuits = has_versions && language >= LanguageVersion::k2021;
  options.stores_any_type = has_versions && language >= LanguageVersion::k2018;
  options.profile = std::move(profile);
  return options;
}

}  // namespace clipc
