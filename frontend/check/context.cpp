// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/context.h"

#include <cstddef>
#include <utility>

namespace clipc::check {
namespace {

// The limit on the levels of expressions, statements and declarations inside each other. The
// checker's frames are small enough for a stack of 8 MiB, with sanitizers too.
constexpr int kMaxCheckDepth = 2500;

// The limit on the expressions of a program. A cast of a struct is an expression for each of its
// leaves, so a short text may make many.
constexpr std::size_t kMaxCheckedExpressions = std::size_t{1} << 22;

}  // namespace

Context::Context(const ast::File& file, const CheckOptions& options, Diagnostics& diagnostics)
    : file(file),
      options(options),
      diagnostics(diagnostics),
      types(program.types),
      names(file.names.size(), view),
      functions(file.names),
      numeric_types(file.names.size()) {
  program.profile = options.profile;
  // After the error about another stage's profile, the rules of a vertex shader find more errors.
  program.stage = options.profile.stage.value_or(Stage::kVertex);
  program.is_interface_only = options.is_interface_only;
  view.scope = names.global();
  globals.buffer = globals.buffers.Add({.kind = CbufferKind::kGlobals, .scope = view.scope});
}

TemporaryMaker::Temporary Context::Make(ExprId value) {
  Builder at = At(program.exprs[value].span);
  const VarId var = at.Local("temporary", TypeIdOf(value));
  if (view.body) {
    view.body->temporaries.push_back(var);
  } else {
    program.vars[var].storage = Storage::kStatic;
    globals.reached.push_back({view.order, var});
  }
  return {var, at.AssignTo(at.Ref(var), value)};
}

RecursionGuard::RecursionGuard(Context& context, Span where, int weight)
    : context_(context), weight_(weight) {
  context.depth += weight;
  const bool is_deep = context.depth > kMaxCheckDepth;
  const bool is_large = context.program.exprs.size() > kMaxCheckedExpressions;
  ok_ = !is_deep && !is_large;
  if (is_deep) context.Report(where, diag::CheckTooDeep, kMaxCheckDepth);
  if (is_large && !std::exchange(context.is_too_large, true))
    context.Report(where, diag::CheckTooLarge, kMaxCheckedExpressions);
}

}  // namespace clipc::check
