// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// What the page's first module has in place of glslang, which is a third of the whole module and
// which --validate and pixel shaders in GLSL need. A compile that needs it is made again by the
// whole module, which the page loads then.
#include "compiler/compile/list_spirv.h"
#include "compiler/compile/validate.h"
#include "link/read.h"

namespace {

bool is_missed = false;

std::vector<std::string> Missing() {
  is_missed = true;
  return {"this module has no glslang"};
}

}  // namespace

// Whether a compile since the last call needed glslang.
extern "C" __attribute__((export_name("clipc_module_missed_glslang"))) int
clipc_module_missed_glslang() {
  const bool was_missed = is_missed;
  is_missed = false;
  return was_missed ? 1 : 0;
}

namespace clipc {

std::vector<std::string> Validate(const std::string&, const glsl::Target&, Stage) {
  return Missing();
}

std::string_view UnknownToValidator(std::string_view, const glsl::Target&) { return {}; }

std::string ListSpirv(const std::vector<std::uint32_t>&) { return {}; }

std::string ValidatorName() { return "no glslang"; }

namespace link {

ReadResult ReadGlsl(std::string_view, const std::string&, Dialect) {
  return {.problems = Missing()};
}

}  // namespace link
}  // namespace clipc
