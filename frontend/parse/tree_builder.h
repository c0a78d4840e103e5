// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "base/kept_blocks.h"
#include "base/not_copied.h"
#include "frontend/parse/ast.h"
#include "frontend/parse/ast_walk.h"
#include "frontend/parse/lookahead.h"

namespace clipc::ast {

// The maker of the nodes of a File, which keeps the promise of kMaxDepth: half of it is for the
// statements and declarations on a path, which Nesting counts while they are parsed, the other half
// for the expressions and types below them, whose height is known when they are made. Text that
// would break the promise is an error, and the rest of it is not read.
class TreeBuilder : protected Lookahead {
 protected:
  // One level of recursion of the parser. `weight` is the number of tree nodes that it can put on a
  // path.
  class Nesting : NotCopied {
   public:
    explicit Nesting(TreeBuilder& builder, int weight = 1) : builder_(builder), weight_(weight) {
      ++builder_.nesting_;
      builder_.depth_ += weight_;
      builder_.deepest_ = std::max(builder_.deepest_, builder_.depth_);
      ok_ = builder_.nesting_ <= kMaxNesting && builder_.depth_ <= kMaxStatementDepth;
      if (!ok_) builder_.ReportNesting();
    }
    ~Nesting() {
      --builder_.nesting_;
      builder_.depth_ -= weight_;
    }
    // Whether no limit was passed; one that was passed has been reported.
    bool ok() const { return ok_; }

   private:
    TreeBuilder& builder_;
    int weight_;
    bool ok_;
  };

  // The lists of one kind in a File, and the stack on which those under construction lie.
  template <typename T>
  struct Lists {
    Pool<T>& pool;
    KeptVector<T> stack = {};
  };

  // The children of one node while they are gathered. Only the last Collector made and not finished
  // of those with the same Lists may be added to.
  template <typename T>
  class Collector : NotCopied {
   public:
    explicit Collector(Lists<T>& lists) : lists_(lists), mark_(std::ssize(lists.stack)) {}
    ~Collector() {
      if (!finished_) Drop();
    }
    void Add(T value) { lists_.stack.push_back(std::move(value)); }
    T last() const { return lists_.stack.back(); }
    void RemoveLast() { lists_.stack.pop_back(); }
    std::span<const T> values() const {
      return std::span<const T>(lists_.stack).subspan(static_cast<std::size_t>(mark_));
    }
    // Moves the gathered values into the File.
    List<T> Finish() {
      finished_ = true;  // a Collector made earlier may now add
      if (values().empty()) return {};
      const List<T> list = lists_.pool.Add(values());
      Drop();
      return list;
    }

   private:
    void Drop() { lists_.stack.erase(lists_.stack.begin() + mark_, lists_.stack.end()); }

    Lists<T>& lists_;
    std::ptrdiff_t mark_;
    bool finished_ = false;
  };

  TreeBuilder(Tokens&& tokens, Diagnostics& diagnostics);

  // Adds a node to the File. `start` is the position of its first token; its last one is the last
  // token taken.
  template <typename Node>
  ExprId AddExpr(std::size_t start, const Node& node) {
    std::uint32_t height = 0;
    ForEachChild(node, [&](auto child) { height = std::max(height, HeightOf(child)); });
    const Span span = SpanFrom(start);
    return AddHeight(1 + height, span) ? file_.exprs.Make(span, node)
                                       : file_.exprs.Make(span, ErrorExpr{});
  }
  ExprId ErrorExprHere() { return AddExpr(pos_, ErrorExpr{}); }
  template <typename Node>
  StmtId AddStmt(std::size_t start, const Node& node) {
    return file_.stmts.Make(SpanFrom(start), List<Attr>{}, node);
  }
  template <typename Node>
  DeclId AddDecl(std::size_t start, const Node& node) {
    return file_.decls.Make(SpanFrom(start), node);
  }
  // Adds a type to the File. `height_of_definition` is the number of nodes on the longest path of a
  // struct defined in place.
  TypeId AddType(Type type, std::uint32_t height_of_definition = 0);
  // Calls `define`, which parses a definition, and returns the number of nodes on the longest path
  // of that definition.
  template <typename Define>
  std::uint32_t HeightOfDefinition(Define define) {
    const int outer_deepest = std::exchange(deepest_, depth_);
    const std::uint32_t outer_tallest = std::exchange(tallest_, 0);
    define();
    const std::uint32_t height = static_cast<std::uint32_t>(deepest_ - depth_) + tallest_;
    deepest_ = std::max(deepest_, outer_deepest);
    tallest_ = std::max(tallest_, outer_tallest);
    return height;
  }

  File file_;
  Lists<ExprId> exprs_{file_.expr_lists};
  Lists<StmtId> stmts_{file_.stmt_lists};
  Lists<DeclId> decls_{file_.decl_lists};
  Lists<TypeId> types_{file_.type_lists};
  Lists<Name> name_lists_{file_.name_lists};
  Lists<Attr> attrs_{file_.attrs};
  Lists<RegisterBinding> registers_{file_.registers};
  Lists<Enumerator> enumerators_{file_.enumerators};
  Lists<TemplateParameter> template_parameters_{file_.template_parameters};
  int depth_ = 0;  // the weights of the Nestings that are open

 private:
  // The limit on the levels of brackets, blocks and prefix operators together, which bounds the
  // stack that the parser's recursion takes.
  static constexpr int kMaxNesting = 256;
  // The limit on the nodes of statements and declarations on one path.
  static constexpr int kMaxStatementDepth = kMaxDepth / 2;
  // The limit on the nodes of expressions and types on one path.
  static constexpr std::uint32_t kMaxHeight = kMaxDepth / 2 - 20;

  // Reports the limit that the Nestings have passed, and ends the parse.
  void ReportNesting();
  // Notes the height of the next expression. Returns false if no node may be so high: then the next
  // expression must be an ErrorExpr.
  bool AddHeight(std::uint32_t height, Span span) {
    const bool fits = height <= kMaxHeight || CheckHeight(height, span);
    if (!fits) height = 1;
    tallest_ = std::max(tallest_, height);
    heights_.push_back(static_cast<std::uint16_t>(height));
    return fits;
  }
  // Returns true if a node of the height `height` may be made; otherwise reports, and ends the
  // parse.
  bool CheckHeight(std::uint32_t height, Span span);
  // The number of nodes on the longest path from a child.
  std::uint32_t HeightOf(ExprId id) const { return id ? heights_[id.index] : 0; }
  std::uint32_t HeightOf(TypeId id) const { return id ? type_heights_[id.index] : 0; }
  std::uint32_t HeightOf(List<ExprId> list) const;

  int nesting_ = 0;
  int deepest_ = 0;                         // the largest depth_ of the definition being parsed
  std::uint32_t tallest_ = 0;               // the largest of heights_ in that definition
  KeptVector<std::uint16_t> heights_;       // by Expr: the number of nodes on its longest path
  KeptVector<std::uint32_t> type_heights_;  // by Type: the number of nodes on its longest path
};

}  // namespace clipc::ast
