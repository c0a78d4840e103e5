// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/run_passes.h"

#include <cstdio>
#include <cstdlib>
#include <optional>

#include "base/invariant.h"
#include "ir/print.h"
#include "ir/verify.h"

namespace clipc::ir {
namespace {

#ifdef NDEBUG
constexpr bool kHasAssertions = false;
#else
constexpr bool kHasAssertions = true;
#endif

}  // namespace

void VerifyAfter(std::string_view step, const Program& program, Form form,
                 const PassOptions& options) {
  if ((!kHasAssertions && !options.verify) || form == Form::kTyped) return;
  const std::optional<std::string> problem = Verify(program, form);
  if (!problem) return;
  std::fprintf(stderr, "clipc invariant broken after %.*s: %s\n%s\n", static_cast<int>(step.size()),
               step.data(), problem->c_str(), Print(program).c_str());
  std::abort();
}

bool FinishPass(const Program& program, std::string_view pass, Form ensures,
                const PassOptions& options) {
  CLIPC_CHECK(program.form == ensures);
  VerifyAfter(pass, program, ensures, options);
  const bool goes_on = !options.after_pass || options.after_pass(pass, program);
  return goes_on && options.stop_after != pass;
}

}  // namespace clipc::ir
