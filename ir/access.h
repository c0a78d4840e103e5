// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ir/program.h"
#include "ir/walk.h"

// Questions about nodes and functions, with one answer to each: the operands that a node reads and
// writes, the variable that a path starts at, and the statements of a function.
namespace clipc::ir {

// ---- nodes

// The node as a `Node`; null for a node of another kind and for an id that is none.
template <typename Node>
const Node* As(const Program& program, ExprId expr) {
  return expr ? std::get_if<Node>(&program.exprs[expr].node) : nullptr;
}
template <typename Node>
const Node* As(const Program& program, StmtId stmt) {
  return stmt ? std::get_if<Node>(&program.stmts[stmt].node) : nullptr;
}

inline TypeId TypeIdOf(const Program& program, ExprId expr) { return program.exprs[expr].type; }
inline const Type& TypeOf(const Program& program, ExprId expr) {
  return program.types[program.exprs[expr].type];
}

// The assignment of a statement `target = value;`; null for every other statement, `target +=
// value;` included.
const Assign* AsAssignment(const Program& program, StmtId stmt);

// The direct operands, in the order of evaluation.
std::vector<ExprId> OperandsOf(const Program& program, ExprId expr);

// ---- paths

// The expression that `expr` takes a field, an element or components of; none for an expression of
// another kind.
ExprId WholeOf(const Program& program, ExprId expr);
// The variable that a path of fields, indices and swizzles starts at; none for an expression that
// is not such a path.
VarId RootOf(const Program& program, ExprId path);

// Whether the expression is a swizzle that names a component twice, which nothing can be assigned
// to.
bool RepeatsComponents(const Program& program, ExprId expr);

// The components of each variable that any function reads, a bit for each, by VarId; all for a
// variable that is read otherwise than by a swizzle.
std::vector<std::uint32_t> ComponentsRead(const Program& program);

// Whether every index in the path is a literal, so that naming the place reads no other variable.
bool HasLiteralIndices(const Program& program, ExprId path);

// ---- calls of objects

// The operands of that kind in a call of an object, a part of its list: one, none, or the steps or
// offsets.
inline List<ExprId> OperandsOf(const ObjectCall& call, OperandKind kind) {
  const std::uint32_t size = call.arguments.size;
  if (kind == OperandKind::kClamp) return {call.arguments.begin + size, call.has_clamp};
  if (kind == OperandKind::kTexel)
    return {call.arguments.begin + size + call.has_clamp, call.has_texel};
  const OperandRun run = RunOf(call.op, kind, size);
  return {call.arguments.begin + run.first, run.count};
}
// The operand of that kind, or the first of several; none where the call has none.
inline ExprId OperandOf(const Program& program, const ObjectCall& call, OperandKind kind) {
  const List<ExprId> list = OperandsOf(call, kind);
  return list.empty() ? ExprId{} : program.expr_lists[list][0];
}

// Calls visit(OperandKind, ExprId) for each operand of a call of an object, in their order.
template <typename OnOperand>
void ForEachNamedOperand(const Program& program, const ObjectCall& call, OnOperand&& visit) {
  const auto all = [&](OperandKind kind) {
    const List<ExprId> list = OperandsOf(call, kind);
    for (std::uint32_t i = 0; i < list.size; ++i) visit(kind, program.expr_lists[list][i]);
  };
  for (const OperandSlot& slot : InfoOf(call.op).Slots()) all(slot.kind);
  all(OperandKind::kClamp);
  all(OperandKind::kTexel);
}

// What functions do with the contents of an object.
struct ObjectUse {
  bool reads = false, writes = false;
};
// By VarId.
std::vector<ObjectUse> UsesOfObjects(const Program& program, std::span<const FunctionId> functions);

// ---- effects

// Whether nodes of this kind may write an operand: WritesOperand need not be asked of others.
inline bool IsOfWritingKind(const Expr& expr) {
  return Visit(Overloaded{
                   [](const OneOf<Assign, Unary, Call, IntrinsicCall> auto&) { return true; },
                   [](const auto&) { return false; },
               },
               expr.node);
}
// Whether the node of `expr` writes its operand number `operand`, counted from 0 in the order of
// evaluation: assignments, increments, and the out and inout arguments of calls.
bool WritesOperand(const Program& program, ExprId expr, std::size_t operand);

// Calls on_target(ExprId) for each target that the node of `expr` writes. The operands' own writes
// are not among them.
template <typename OnTarget>
void ForEachWrite(const Program& program, ExprId expr, OnTarget&& on_target) {
  const auto of_call = [&](List<ExprId> arguments) {
    for (std::uint32_t i = 0; i < arguments.size; ++i) {
      if (WritesOperand(program, expr, i)) on_target(program.expr_lists[arguments][i]);
    }
  };
  Visit(Overloaded{
            [&](const Assign& node) { on_target(node.target); },
            [&](const Unary& node) {
              if (ChangesOperand(node.op)) on_target(node.operand);
            },
            [&](const Call& node) { of_call(node.arguments); },
            [&](const IntrinsicCall& node) {
              if (WritesArguments(node.op)) of_call(node.arguments);
            },
            [&](const ObjectCall& node) {
              if (node.has_texel) on_target(OperandOf(program, node, OperandKind::kTexel));
            },
            [](const auto&) {},
        },
        program.exprs[expr].node);
}

// Whether the expression changes nothing, so that it may be evaluated twice or not at all: it has
// no assignment, increment, store or out argument in it, and no call of a function but helpers.
bool IsPure(const Program& program, ExprId expr);

// Whether the node itself asks the neighbouring pixels, for a derivative or a level of detail: it
// means something only where they run it too.
bool AsksNeighbours(const Program& program, ExprId expr);

// Whether the node itself asks other invocations: neighbours or lanes of the wave.
bool AsksOthers(const Program& program, ExprId expr);

// Whether the expression may be evaluated in some invocations only: it is pure, and asks no
// others.
bool MayBeSkipped(const Program& program, ExprId expr);

// The answers to MayBeSkipped that look into functions too: a call may be skipped when its function
// changes nothing but its own parameters and local variables, and asks no neighbours. The answers
// for functions are kept, so the program must not change while this lives. Asking for callees
// before their callers keeps the recursion flat.
class Effects {
 public:
  explicit Effects(const Program& program)
      : program_(program), functions_(program.functions.size()) {}

  bool MayBeSkipped(ExprId expr);
  bool MayBeSkipped(FunctionId function);

 private:
  enum class Answer : std::uint8_t { kUnknown, kYes, kNo };

  const Program& program_;
  std::vector<Answer> functions_;  // by FunctionId
};

// The variables that the statements may change, wholly or in part: a mark for each VarId.
std::vector<bool> AssignedIn(const Program& program, std::span<const StmtId> stmts);

// ---- functions

// The statements directly in the body of a function, or of `main`. Adding statements to the program
// ends the span.
std::span<const StmtId> BodyOf(const Program& program, FunctionId function);
inline std::span<const StmtId> MainBody(const Program& program) {
  return BodyOf(program, program.main);
}
// The function that writes the outputs: `main`, or in a stage that emits vertices that of the
// stream whose vertices are drawn.
FunctionId OutputFunction(const Program& program);
// The vertices or control points that the stage reads; 0 in a stage that reads none.
std::uint32_t VerticesRead(const Program& program);
// The function that writes this output, which may be one of another stream.
FunctionId OutputFunction(const Program& program, VarId output);
// The number of the stream that the output is of.
std::uint32_t StreamOf(const Program& program, VarId output);
// The statements of the functions that write outputs; their last ones may emit the vertex.
inline std::span<const StmtId> OutputBody(const Program& program) {
  return BodyOf(program, OutputFunction(program));
}
// Whether the statement emits the vertex that the outputs have.
bool EmitsVertex(const Program& program, StmtId stmt);
// The most scalars of a vertex that is emitted to one stream, and those that a shader may emit.
std::int64_t ScalarsOfVertex(const Program& program);
inline constexpr std::int64_t kMostScalarsEmitted = 1024;
// Adds statements to the end of OutputFunction, before the vertex is emitted.
void AppendToOutputs(Program& program, std::span<const StmtId> stmts);
// The call of the function that a statement consists of: `T result = function(...);`,
// `output = function(...);` or `function(...);`; none for every other statement.
ExprId CallIn(const Program& program, StmtId stmt, FunctionId function);
// The same of the entry function, in `main`.
inline ExprId EntryCall(const Program& program, StmtId stmt) {
  return CallIn(program, stmt, program.entry);
}
// The block of `main` that writes the constants of the patch, in a stage that makes patches.
StmtId PatchBlock(const Program& program);
// Replaces the statements of `main`. `body` may be a span of the old ones.
void SetMainBody(Program& program, std::span<const StmtId> body);
// Replaces the statements of a function. `body` may be a span of the old ones.
void SetBody(Program& program, FunctionId function, std::span<const StmtId> body);
// Appends statements to the end of `function`'s body.
void AppendToBody(Program& program, FunctionId function, std::span<const StmtId> stmts);

}  // namespace clipc::ir
