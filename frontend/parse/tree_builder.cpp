// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/parse/tree_builder.h"

#include <algorithm>

namespace clipc::ast {
namespace {

// The limit on the levels of brackets, blocks and prefix operators together, which bounds the stack
// that the parser's recursion takes.
constexpr int kMaxNesting = 256;
// The limit on the nodes of statements and declarations on one path.
constexpr int kMaxStatementDepth = kMaxDepth / 2;
// The limit on the nodes of expressions and types on one path.
constexpr std::uint32_t kMaxHeight = kMaxDepth / 2 - 20;

}  // namespace

TreeBuilder::Nesting::Nesting(TreeBuilder& builder, int weight)
    : builder_(builder), weight_(weight) {
  ++builder_.nesting_;
  builder_.depth_ += weight_;
  builder_.deepest_ = std::max(builder_.deepest_, builder_.depth_);
  ok_ = builder_.nesting_ <= kMaxNesting && builder_.depth_ <= kMaxStatementDepth;
  if (ok_) return;
  const int limit = builder_.nesting_ > kMaxNesting ? kMaxNesting : kMaxStatementDepth;
  builder_.Error(builder_.Here(), diag::NestedTooDeeply, limit);
  builder_.Abort();
}

TreeBuilder::Nesting::~Nesting() {
  --builder_.nesting_;
  builder_.depth_ -= weight_;
}

TreeBuilder::TreeBuilder(Tokens&& tokens, Diagnostics& diagnostics)
    : Lookahead(std::move(tokens), diagnostics) {
  heights_.reserve(tokens_.size() / 2);  // seldom too small
  type_heights_.reserve(64);
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

bool TreeBuilder::AddHeight(std::uint32_t height, Span span) {
  const bool fits = CheckHeight(height, span);
  if (!fits) height = 1;
  tallest_ = std::max(tallest_, height);
  heights_.push_back(static_cast<std::uint16_t>(height));
  return fits;
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
