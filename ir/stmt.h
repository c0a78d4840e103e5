// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <variant>

#include "base/arena.h"
#include "base/span.h"
#include "ir/ids.h"

// Statements. An id that may be none says so.
namespace clipc::ir {

struct Block {
  List<StmtId> body;
};
// Brings a local variable into scope. Without init its value is undefined; the evaluator takes
// EvalOptions::undefined.
struct Declare {
  VarId var;
  ExprId init;  // of exactly the variable's type, or none
};
struct Evaluate {
  ExprId expr;
};
struct If {
  ExprId condition;
  StmtId then;
  StmtId otherwise;  // or none
};
struct For {
  List<StmtId> init;  // Declares of one type, or one Evaluate
  ExprId condition;   // a bool scalar; none: the loop never ends by itself
  ExprId step;        // or none
  StmtId body;
};
struct While {
  ExprId condition;
  StmtId body;
};
struct DoWhile {
  StmtId body;
  ExprId condition;
};
// One arm: its labels and the statements up to the next label. Control falls into the next arm.
struct SwitchCase {
  List<ExprId> labels;  // Literals of the value's type
  bool is_default = false;
  List<StmtId> body;
};
struct Switch {
  ExprId value;  // an int or uint scalar
  List<SwitchCase> cases;
};
struct Return {
  ExprId value;  // or none
};
struct Break {};
struct Continue {};
// Ends the pixel: nothing is drawn, and no unordered access view changes after it. Its invocation
// may go on, so that its neighbours have derivatives.
struct Discard {};

// The wish of the shader for the optimiser at a loop, an `if` or a `switch`. No value depends on
// it.
enum class Hint : std::uint8_t {
  kNone,
  kUnroll,
  kLoop,  // keep the loop
  kBranch,
  kFlatten,  // evaluate both sides
};

struct Stmt {
  Span span;
  std::variant<Block, Declare, Evaluate, If, For, While, DoWhile, Switch, Return, Break, Continue,
               Discard>
      node;
  Hint hint = Hint::kNone;
};

}  // namespace clipc::ir
