// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/access.h"

#include <algorithm>
#include <map>

namespace clipc::ir {
namespace {

// Whether the node writes an object, orders such writes or emits a vertex. An object is not an
// lvalue, so ForEachWrite does not visit it.
bool IsStore(const Program& program, ExprId expr) {
  const auto* call = As<ObjectCall>(program, expr);
  const auto* intrinsic = As<IntrinsicCall>(program, expr);
  return (call && WritesObject(call->op)) ||
         (intrinsic && (CategoryOf(intrinsic->op) == IntrinsicCategory::kMemory ||
                        intrinsic->op == CommonIntrinsic::kEmitVertex ||
                        intrinsic->op == CommonIntrinsic::kEndPrimitive ||
                        intrinsic->op == CommonIntrinsic::kEndPoints));
}

// Whether the node itself writes something, without its operands and, for a call, without the body
// of the function.
bool Writes(const Program& program, ExprId expr) {
  bool writes = IsStore(program, expr);
  ForEachWrite(program, expr, [&](ExprId) { writes = true; });
  return writes;
}

}  // namespace

const Assign* AsAssignment(const Program& program, StmtId stmt) {
  const auto* evaluate = As<Evaluate>(program, stmt);
  const auto* assign = evaluate ? As<Assign>(program, evaluate->expr) : nullptr;
  return assign && !assign->op ? assign : nullptr;
}

std::vector<ExprId> OperandsOf(const Program& program, ExprId expr) {
  std::vector<ExprId> operands;
  ForEachOperand(program, expr, [&](ExprId operand) { operands.push_back(operand); });
  return operands;
}

ExprId WholeOf(const Program& program, ExprId expr) {
  return Visit(
      Overloaded{
          [](const OneOf<FieldRef, Index, Swizzle, MatrixSwizzle> auto& node) { return node.base; },
          [](const auto&) { return ExprId{}; },
      },
      program.exprs[expr].node);
}

bool RepeatsComponents(const Program& program, ExprId expr) {
  const auto* vector = As<Swizzle>(program, expr);
  const auto* matrix = As<MatrixSwizzle>(program, expr);
  const int count = vector ? vector->count : matrix ? matrix->count : 0;
  std::uint32_t seen = 0;
  for (int i = 0; i < count; ++i) {
    const std::uint32_t bit =
        1u << (vector ? vector->components[i] : 4 * matrix->rows[i] + matrix->columns[i]);
    if (seen & bit) return true;
    seen |= bit;
  }
  return false;
}

VarId RootOf(const Program& program, ExprId path) {
  while (const ExprId whole = WholeOf(program, path)) path = whole;
  const auto* ref = As<VarRef>(program, path);
  return ref ? ref->var : VarId{};
}

std::vector<std::uint32_t> ComponentsRead(const Program& program) {
  std::vector<std::uint32_t> masks(program.vars.size());
  for (const FunctionId function : program.functions.ids()) {
    ExprId swizzled;  // by the swizzle that was visited last
    ForEachExpr(program, program.functions[function].body, [&](ExprId id) {
      if (const auto* swizzle = As<Swizzle>(program, id)) {
        const auto* base = As<VarRef>(program, swizzle->base);
        if (!base) return;
        swizzled = swizzle->base;
        const Type& type = program.types[program.exprs[id].type];
        for (std::uint32_t i = 0; i < type.Components(); ++i)
          masks[base->var.index] |= 1u << swizzle->components[i];
      }
      const auto* ref = As<VarRef>(program, id);
      if (ref && id != swizzled) masks[ref->var.index] = 0xF;
    });
  }
  return masks;
}

bool HasLiteralIndices(const Program& program, ExprId path) {
  for (; path; path = WholeOf(program, path)) {
    const auto* index = As<Index>(program, path);
    if (index && !As<Literal>(program, index->index)) return false;
  }
  return true;
}

std::vector<ObjectUse> UsesOfObjects(const Program& program,
                                     std::span<const FunctionId> functions) {
  std::vector<ObjectUse> uses(program.vars.size());
  for (const FunctionId function : functions) {
    ForEachExpr(program, program.functions[function].body, [&](ExprId expr) {
      const auto* call = As<ObjectCall>(program, expr);
      const VarId object =
          call ? RootOf(program, OperandOf(program, *call, OperandKind::kObject)) : VarId{};
      if (!object) return;
      uses[object.index].reads |= ReadsObject(call->op);
      uses[object.index].writes |= WritesObject(call->op);
    });
  }
  return uses;
}

bool WritesOperand(const Program& program, ExprId expr, std::size_t operand) {
  return Visit(Overloaded{
                   [&](const Assign&) { return operand == 0; },
                   [&](const Unary& node) { return ChangesOperand(node.op); },
                   [&](const Call& node) {
                     const VarId parameter = program.functions[node.function].parameters[operand];
                     return program.vars[parameter].storage != Storage::kIn;
                   },
                   [&](const IntrinsicCall& node) { return WritesArgument(node.op, operand); },
                   [&](const ObjectCall& node) {
                     return node.has_texel && operand + 1 == node.Operands().size;
                   },
                   [](const auto&) { return false; },
               },
               program.exprs[expr].node);
}

bool IsPure(const Program& program, ExprId expr) {
  return !AnyExpr(program, expr, [&](ExprId part) {
    if (Writes(program, part)) return true;
    const auto* call = As<Call>(program, part);
    if (!call) return false;
    const Function& function = program.functions[call->function];
    const bool stores =
        function.is_accessor && program.types[function.return_type].kind == TypeKind::kVoid;
    return !function.is_helper || stores;
  });
}

bool AsksNeighbours(const Program& program, ExprId expr) {
  const auto* object = As<ObjectCall>(program, expr);
  const auto* call = As<IntrinsicCall>(program, expr);
  return (object && AsksNeighbours(object->op)) ||
         (call && (CategoryOf(call->op) == IntrinsicCategory::kNeighbours ||
                   CategoryOf(call->op) == IntrinsicCategory::kQuad));
}

bool AsksOthers(const Program& program, ExprId expr) {
  const auto* call = As<IntrinsicCall>(program, expr);
  return AsksNeighbours(program, expr) ||
         (call && CategoryOf(call->op) == IntrinsicCategory::kWave);
}

bool MayBeSkipped(const Program& program, ExprId expr) {
  return IsPure(program, expr) &&
         !AnyExpr(program, expr, [&](ExprId part) { return AsksOthers(program, part); });
}

bool Effects::MayBeSkipped(ExprId expr) {
  return !AnyExpr(program_, expr, [&](ExprId part) {
    const auto* call = As<Call>(program_, part);
    return Writes(program_, part) || AsksOthers(program_, part) ||
           (call && !MayBeSkipped(call->function));
  });
}

bool Effects::MayBeSkipped(FunctionId function) {
  Answer& answer = functions_[function.index];
  if (answer != Answer::kUnknown) return answer == Answer::kYes;
  bool must_run = false;
  ForEachStmt(program_, program_.functions[function].body,
              [&](StmtId id) { must_run |= As<Discard>(program_, id) != nullptr; });
  must_run |= AnyExpr(program_, program_.functions[function].body, [&](ExprId part) {
    bool reaches_out = IsStore(program_, part) || AsksOthers(program_, part);
    ForEachWrite(program_, part, [&](ExprId target) {
      const VarId root = RootOf(program_, target);
      const Storage storage = root ? program_.vars[root].storage : Storage::kOut;
      reaches_out |= storage != Storage::kLocal && storage != Storage::kIn;
    });
    const auto* call = As<Call>(program_, part);
    return reaches_out || (call && !MayBeSkipped(call->function));
  });
  answer = must_run ? Answer::kNo : Answer::kYes;
  return !must_run;
}

std::vector<bool> AssignedIn(const Program& program, std::span<const StmtId> stmts) {
  std::vector<bool> assigned(program.vars.size());
  const auto on_target = [&](ExprId target) {
    if (const VarId root = RootOf(program, target)) assigned[root.index] = true;
  };
  for (const StmtId stmt : stmts) {
    ForEachExpr(program, stmt, [&](ExprId part) { ForEachWrite(program, part, on_target); });
  }
  return assigned;
}

std::span<const StmtId> BodyOf(const Program& program, FunctionId function) {
  return program
      .stmt_lists[std::get<Block>(program.stmts[program.functions[function].body].node).body];
}

ExprId CallIn(const Program& program, StmtId stmt, FunctionId function) {
  const auto* declare = As<Declare>(program, stmt);
  const auto* evaluate = As<Evaluate>(program, stmt);
  const Assign* assign = AsAssignment(program, stmt);
  const ExprId value = declare    ? declare->init
                       : assign   ? assign->value
                       : evaluate ? evaluate->expr
                                  : ExprId{};
  const auto* call = As<Call>(program, value);
  return call && call->function == function ? value : ExprId{};
}

StmtId PatchBlock(const Program& program) {
  if (!clipc::InfoOf(program.stage).makes_patches) return {};
  for (const StmtId stmt : MainBody(program)) {
    const auto* branch = As<If>(program, stmt);
    const auto* asks = branch ? As<IntrinsicCall>(program, branch->condition) : nullptr;
    if (asks && asks->op == CommonIntrinsic::kIsFirstPoint) return branch->then;
  }
  return {};
}

FunctionId OutputFunction(const Program& program) {
  const auto& streams = program.emission.streams;
  return streams.empty() ? program.main : streams.front().emit;
}

std::uint32_t VerticesRead(const Program& program) {
  const StageInfo& stage = clipc::InfoOf(program.stage);
  if (stage.emits_vertices) return InfoOf(program.emission.input).vertices;
  return stage.makes_patches ? program.tessellation.input_points
                             : program.tessellation.output_points;
}

std::uint32_t StreamOf(const Program& program, VarId output) {
  const auto& streams = program.emission.streams;
  for (std::uint32_t i = 1; i < streams.size(); ++i) {
    const StmtId body[] = {program.functions[streams[i].emit].body};
    if (AssignedIn(program, body)[output.index]) return i;
  }
  return 0;
}

FunctionId OutputFunction(const Program& program, VarId output) {
  const std::uint32_t stream = StreamOf(program, output);
  return stream == 0 ? OutputFunction(program) : program.emission.streams[stream].emit;
}

std::int64_t ScalarsOfVertex(const Program& program) {
  std::map<FunctionId, std::int64_t> scalars;
  std::int64_t most = 0;
  for (const IoVar& output : program.outputs) {
    const Type& type = program.types[program.vars[output.var].type];
    std::int64_t& of_stream = scalars[OutputFunction(program, output.var)];
    of_stream += type.kind == TypeKind::kArray ? type.count : type.Components();
    most = std::max(most, of_stream);
  }
  return most;
}

bool EmitsVertex(const Program& program, StmtId stmt) {
  const auto* evaluate = As<Evaluate>(program, stmt);
  const auto* call = evaluate ? As<IntrinsicCall>(program, evaluate->expr) : nullptr;
  return call && call->op == CommonIntrinsic::kEmitVertex;
}

void AppendToOutputs(Program& program, std::span<const StmtId> stmts) {
  const FunctionId function = OutputFunction(program);
  const std::span<const StmtId> old = BodyOf(program, function);
  std::vector<StmtId> body(old.begin(), old.end());
  const bool emits = !body.empty() && EmitsVertex(program, body.back());
  body.insert(body.end() - (emits ? 1 : 0), stmts.begin(), stmts.end());
  SetBody(program, function, body);
}

void SetBody(Program& program, FunctionId function, std::span<const StmtId> body) {
  std::get<Block>(program.stmts[program.functions[function].body].node).body =
      program.stmt_lists.Add(body);
}

void SetMainBody(Program& program, std::span<const StmtId> body) {
  SetBody(program, program.main, body);
}

void AppendToBody(Program& program, FunctionId function, std::span<const StmtId> stmts) {
  const std::span<const StmtId> old = BodyOf(program, function);
  std::vector<StmtId> body(old.begin(), old.end());
  body.insert(body.end(), stmts.begin(), stmts.end());
  SetBody(program, function, body);
}

}  // namespace clipc::ir
