// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <vector>

#include "base/arena.h"
#include "base/name.h"
#include "base/stage.h"
#include "frontend/parse/ast_decl.h"
#include "frontend/parse/ast_expr.h"
#include "frontend/parse/ast_stmt.h"
#include "frontend/parse/effect_text.h"

// The syntax tree of a source: one node for each construct as it was written, names unresolved,
// nothing converted.
namespace clipc::ast {

// The largest number of nodes on a path from a root: a walk of a tree may recurse.
inline constexpr int kMaxDepth = 1000;

// A parsed translation unit. Techniques, passes and state blocks are not kept but on request.
struct File {
  Names names;
  Arena<Expr> exprs;
  Arena<Stmt> stmts;
  Arena<Decl> decls;
  Arena<Type> types;
  Pool<ExprId> expr_lists;
  Pool<StmtId> stmt_lists;
  Pool<DeclId> decl_lists;
  Pool<TypeId> type_lists;
  Pool<Name> name_lists;
  Pool<Attr> attrs;
  Pool<RegisterBinding> registers;
  Pool<Enumerator> enumerators;
  Pool<TemplateParameter> template_parameters;
  std::vector<DeclId> top_level;
  // A function that a technique compiles.
  struct TechniqueShader {
    Name function;
    Stage stage;
  };
  // Each once: hints for a message about an entry function that does not exist.
  std::vector<TechniqueShader> technique_shaders;
  std::optional<EffectText> effect;  // on request: EffectParts::keep
  List<ExprId> entry_arguments;      // of EffectParts::entry_call, if the file has it
  bool has_enums = false;
  bool has_later_stage = false;  // a hull, domain or geometry shader
};

}  // namespace clipc::ast
