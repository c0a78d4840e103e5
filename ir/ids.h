// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "base/id.h"

// The ids by which the parts of a Program name each other.
namespace clipc::ir {

struct Expr;
struct Stmt;
struct Var;
struct Function;
struct Cbuffer;
struct SwitchCase;
using ExprId = Id<Expr>;
using StmtId = Id<Stmt>;
using VarId = Id<Var>;
using FunctionId = Id<Function>;
using CbufferId = Id<Cbuffer>;

}  // namespace clipc::ir
