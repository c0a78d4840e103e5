// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/context.h"

#include <cstddef>
#include <utility>

namespace clipc::check {

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
  program.form = Form::kTyped;
  program.is_interface_only = options.is_interface_only;
  program.keeps_third_coordinate = !options.shadow_samplers.empty();
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

bool IsOrHoldsObject(const Context& context, TypeId id) {
  const Type& type = context[context.types.Innermost(id)];
  return type.kind == TypeKind::kObject || type.kind == TypeKind::kString ||
         (type.kind == TypeKind::kStruct &&
          context.structs.infos[type.structure.index].holds_objects);
}

void RecursionGuard::Report(Span where) {
  if (context_.depth > kMaxCheckDepth) context_.Report(where, diag::CheckTooDeep, kMaxCheckDepth);
  const bool is_large = context_.program.exprs.size() > kMaxCheckedExpressions;
  if (is_large && !std::exchange(context_.is_too_large, true))
    context_.Report(where, diag::CheckTooLarge, kMaxCheckedExpressions);
}

}  // namespace clipc::check
