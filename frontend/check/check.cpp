// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/check.h"

#include "frontend/check/checker.h"
#include "frontend/rules/check_level9.h"
#include "frontend/rules/registers.h"
#include "frontend/rules/resolve_objects.h"
#include "ir/packing.h"

namespace clipc {

Checker::Checker(const ast::File& file, const CheckOptions& options, Diagnostics& diagnostics)
    : file_(file), options_(options), diagnostics_(diagnostics) {
  program_.profile = options.profile;
  local_by_name_.resize(file.names.size());
  numeric_types_.resize(file.names.size());
  constexpr std::string_view kOperator = "operator";
  for (std::uint32_t i = 0; i < file.names.size(); ++i) {
    const std::string_view text = file.names[Name{i}];
    if (text.starts_with(kOperator) && text != kOperator)
      operator_names_.emplace(text.substr(kOperator.size()), Name{i});
  }
  global_scope_ = AddScope(ScopeKind::kNamespace, {}, {});
  context_.scope = global_scope_;
  Buffer globals;
  globals.kind = ir::CbufferKind::kGlobals;
  globals.scope = global_scope_;
  globals_buffer_ = buffers_.Add(std::move(globals));
}

ir::Program Checker::Run() {
  DeclareAll(file_.top_level, global_scope_);
  const FunctionInfoId entry = FindEntry();
  if (!entry || Info(entry).is_broken) return std::move(program_);
  program_.entry = Reach(entry);
  const EntrySignature signature = SignatureOf(entry);
  ReachClipPlanes(entry);
  CheckBodies();
  CheckRecursion();
  FinishBuffers();
  for (ir::CbufferId id : program_.cbuffers.ids())
    ir::LayOut(program_.types, program_.vars, program_.cbuffers[id]);
  BuildMain(program_, signature, diagnostics_);
  CheckPlanes(entry);
  FinishGlobals();
  if (!diagnostics_.has_errors()) ResolveObjects(program_, diagnostics_);
  AssignRegisters(program_, diagnostics_);
  if (!diagnostics_.has_errors()) CheckLevel9(program_, diagnostics_);
  return std::move(program_);
}

ir::Program Check(const ast::File& file, const CheckOptions& options, Diagnostics& diagnostics) {
  return Checker(file, options, diagnostics).Run();
}

}  // namespace clipc
