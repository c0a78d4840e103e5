// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/parse/tree_builder.h"

#include <algorithm>

namespace clipc::ast {

void TreeBuilder::ReportNesting() {
  const int limit = nesting_ > kMaxNesting ? kMaxNesting : kMaxStatementDepth;
  Error(Here(), diag::NestedTooDeeply, limit);
  Abort();
}

TreeBuilder::TreeBuilder(Tokens&& tokens, Diagnostics& diagnostics)
    : Lookahead(std::move(tokens), diagnostics) {
  heights_.reserve(tokens_.size() / 2);  // seldom too small
  type_heights_.reserve(64);
  exprs_.stack.reserve(16), stmts_.stack.reserve(16), decls_.stack.reserve(16);
  name_lists_.stack.reserve(8);
}

std::uint32_t TreeBuilder::HeightOf(List<ExprId> list) const {
  std::uint32_t height = 0;
  for (ExprId id : file_.expr_lists[list]) height = std::max(height, HeightOf(id));
  return height;
}

bool TreeBuilder::CheckHeight(std::uint32_t height, Span span) {
  if (height <= kMaxHeight) return true;
  Error(span, diag::ExpressionTooLong, static_cast<int>(kMaxHeight));
  Abort();
  return false;
}

TypeId TreeBuilder::AddType(Type type, std::uint32_t height_of_definition) {
  std::uint32_t height =
      1 + std::max({HeightOf(type.arguments), HeightOf(type.outer), height_of_definition});
  if (!CheckHeight(height, type.span)) {
    type = {};
    height = 1;
  }
  type_heights_.push_back(height);
  return file_.types.Add(type);
}

}  // namespace clipc::ast
