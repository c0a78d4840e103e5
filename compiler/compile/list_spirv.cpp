// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/list_spirv.h"

#if CLIPC_HAS_LISTING
#include <fmt/format.h>
#include <spirv-tools/libspirv.h>
#endif

namespace clipc {

std::string ListSpirv([[maybe_unused]] const std::vector<std::uint32_t>& words) {
#if CLIPC_HAS_LISTING
  const spv_context context = spvContextCreate(SPV_ENV_UNIVERSAL_1_6);
  spv_text text = nullptr;
  spv_diagnostic problem = nullptr;
  spvBinaryToText(context, words.data(), words.size(),
                  SPV_BINARY_TO_TEXT_OPTION_INDENT | SPV_BINARY_TO_TEXT_OPTION_FRIENDLY_NAMES,
                  &text, &problem);
  std::string listing;
  if (text) listing.assign(text->str, text->length);
  if (problem) listing += fmt::format("; {}\n", problem->error);
  spvDiagnosticDestroy(problem);
  spvTextDestroy(text);
  spvContextDestroy(context);
  return listing;
#else
  return {};
#endif
}

}  // namespace clipc
