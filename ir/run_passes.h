// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "ir/program.h"

// The way in which passes run: one after the other, with a check and a callback after each.
namespace clipc::ir {

struct PassOptions {
  std::string stop_after;  // the name of the last pass that runs; empty: all run
  // Verify before the first pass and after each; builds with assertions always do.
  bool verify = false;
  // Called when a pass is done, with its name: --dump-after prints the program here. Returns
  // whether the next pass runs.
  std::function<bool(std::string_view pass, const Program&)> after_pass;
};

// A pass that works on a Context, in which the program is.
template <typename Context>
struct Pass {
  std::string_view name;
  void (*run)(Context&);
  Form ensures;
};

// Ends a pass: checks that the program has the form `ensures`, and calls options.after_pass.
// Returns whether the next pass runs.
bool FinishPass(const Program& program, std::string_view pass, Form ensures,
                const PassOptions& options);
// Verifies the program where `options` or the build ask for it, from Form::kResolved on: the
// verifier has no rules for objects before. A broken invariant ends clipc with a message and the
// program.
void VerifyAfter(std::string_view step, const Program& program, Form form,
                 const PassOptions& options);

// Returns whether all passes ran.
template <typename Context>
bool RunPasses(const Program& program, std::span<const Pass<Context>> passes, Context& context,
               const PassOptions& options) {
  for (const Pass<Context>& pass : passes) {
    pass.run(context);
    if (!FinishPass(program, pass.name, pass.ensures, options)) return false;
  }
  return true;
}

}  // namespace clipc::ir
