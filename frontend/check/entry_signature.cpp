// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/entry_signature.h"

#include <limits>

#include "frontend/check/assign.h"
#include "frontend/check/function.h"
#include "frontend/check/global.h"
#include "frontend/check/type.h"
#include "frontend/check/vulkan.h"

namespace clipc::check {
namespace {

// Adds the variable of a `uniform` parameter of the entry point, a member of $Params or a resource.
VarId AddUniformParameter(Context& context, const ast::VarDecl& var, const Parameter& parameter) {
  const SymbolId symbol = context.names.Declare(SymbolKind::kVariable, context.names.global(), {},
                                                parameter.decl, var.name_span);
  context[symbol].resolution = Resolution::kDone;
  if (HoldsObjects(context, parameter.type)) {
    ResolveObject(context, symbol, var, parameter.type);
    return VarId{context[symbol].value};
  }
  const VarId added = AddVar(context, var.name, parameter.type, Storage::kUniform, var.name_span);
  context[added].row_major = IsRowMajor(context, QualifiersOf(context, var));
  MarkConst(context, added);
  context[symbol].value = added.index;
  if (!context.globals.params_buffer) {
    context.globals.params_buffer =
        context.globals.buffers.Add({.kind = CbufferKind::kParams,
                                     .scope = context.names.global(),
                                     .order = std::numeric_limits<std::uint32_t>::max(),
                                     .resolution = Resolution::kDone});
  }
  context[context.globals.params_buffer].members.push_back(symbol);
  return added;
}

}  // namespace

EntrySignature SignatureOf(Context& context, FunctionInfoId entry) {
  const FunctionInfo& info = context[entry];
  const ast::FunctionDecl& decl = DeclOf(context, info);
  EntrySignature signature;
  for (const Parameter& parameter :
       std::vector<Parameter>(context[info.parameters].begin(), context[info.parameters].end())) {
    const auto& var = context.Get<ast::VarDecl>(parameter.decl);
    EntryParameter entry_parameter;
    entry_parameter.semantic = context[var.semantic.name];
    entry_parameter.semantic_span = var.semantic.span;
    ReadInterpolation(var.qualifiers, entry_parameter);
    ReadVulkan(context, var.attributes, entry_parameter);
    entry_parameter.precise = (var.qualifiers & ast::kPrecise) != 0;
    entry_parameter.row_major = IsRowMajor(context, QualifiersOf(context, var));
    if (var.qualifiers & ast::kUniform) {
      entry_parameter.is_uniform = true;
      entry_parameter.uniform_var = AddUniformParameter(context, var, parameter);
    }
    signature.parameters.push_back(std::move(entry_parameter));
  }
  signature.result.semantic = context[decl.return_semantic.name];
  signature.result.semantic_span = decl.return_semantic.span;
  ReadInterpolation(decl.qualifiers, signature.result);
  ReadVulkan(context, decl.attributes, signature.result);
  signature.result.precise = (decl.qualifiers & ast::kPrecise) != 0;
  signature.result.row_major = IsRowMajor(context, decl.qualifiers);
  signature.stages_match_by_row = context.options.stages_match_by_row;
  return signature;
}

}  // namespace clipc::check
