// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Functions and statements: structured control flow, section 2.11 of the SPIR-V specification.
#include <algorithm>
#include <utility>

#include "backend-spirv/writer.h"
#include "base/overloaded.h"

namespace clipc::spirv {

using namespace ir;

namespace {

std::uint32_t SelectionOf(Hint hint) {
  if (hint == Hint::kFlatten) return NumberOf(spv::SelectionControlMask::Flatten);
  if (hint == Hint::kBranch) return NumberOf(spv::SelectionControlMask::DontFlatten);
  return 0;
}

std::uint32_t LoopControlOf(Hint hint) {
  if (hint == Hint::kUnroll) return NumberOf(spv::LoopControlMask::Unroll);
  if (hint == Hint::kLoop) return NumberOf(spv::LoopControlMask::DontUnroll);
  return 0;
}

}  // namespace

Ref Writer::FunctionRef(FunctionId id) {
  Ref& ref = function_refs_[id.index];
  if (ref == 0) {
    ref = module_.NewRef();
    module_.Name(ref, id == program_.main ? "main" : program_.functions[id].name);
  }
  return ref;
}

void Writer::WriteFunction(FunctionId id) {
  const Function& function = program_.functions[id];
  const Ref result = types_.Of(function.return_type);
  code_.clear();
  locals_.clear();
  in_main_ = id == program_.main;
  Words type{result}, parameters;
  for (const VarId parameter : function.parameters) {
    const Var& var = (*this)[parameter];
    Ref value_type = types_.Of(var.type);
    const bool is_out = var.storage == Storage::kOut || var.storage == Storage::kInOut;
    if (is_out) value_type = types_.Pointer(spv::StorageClass::Function, value_type);
    type.push_back(value_type);
    const Ref ref = module_.NewRef();
    module_.Name(ref, var.name);
    Relax(ref, var.type);
    Put(parameters, spv::Op::OpFunctionParameter, {value_type, ref});
    (is_out ? pointers_ : values_)[parameter.index] = ref;
  }
  const Ref type_of = module_.Type(spv::Op::OpTypeFunction, type);
  Words& out = module_.functions;
  lines_.StartFunction(function, FunctionRef(id), code_);
  Put(out, spv::Op::OpFunction,
      {result, FunctionRef(id), NumberOf(spv::FunctionControlMask::MaskNone), type_of});
  out.insert(out.end(), parameters.begin(), parameters.end());
  const Ref first = module_.NewRef();
  Put(out, spv::Op::OpLabel, {first});
  block_ = first;
  is_open_ = true;
  for (const VarId parameter : function.parameters) {
    const Ref value = std::exchange(values_[parameter.index], 0);
    if (value == 0) continue;
    if (!in_memory_[parameter.index]) {
      values_[parameter.index] = value;
      continue;
    }
    const Place place = NewLocal((*this)[parameter].type, (*this)[parameter].name);
    pointers_[parameter.index] = place.base;
    Store(place, value);
  }
  if (in_main_) StartMain();
  const bool is_ordered = in_main_ && has_order_;
  if (is_ordered) Do(spv::Op::OpBeginInvocationInterlockEXT, {});
  WriteStatements(BodyOf(program_, id));
  if (is_ordered && is_open_) Do(spv::Op::OpEndInvocationInterlockEXT, {});
  if (is_open_) {
    if (program_.types[function.return_type].kind == TypeKind::kVoid)
      Do(spv::Op::OpReturn, {});
    else
      Do(spv::Op::OpUnreachable, {});
  }
  out.insert(out.end(), locals_.begin(), locals_.end());
  out.insert(out.end(), code_.begin(), code_.end());
  Put(out, spv::Op::OpFunctionEnd, {});
}

// What comes after the end of a block is never reached.
void Writer::WriteStatements(std::span<const StmtId> list) {
  for (const StmtId id : list) {
    if (!is_open_) return;
    WriteStatement(id);
  }
}

void Writer::WriteStatement(StmtId id) {
  const Stmt& stmt = program_.stmts[id];
  if (lines_.has_any()) lines_.Want(stmt.span);
  Visit(
      Overloaded{
          [&](const Block& node) { WriteStatements(program_.stmt_lists[node.body]); },
          [&](const Declare& node) { WriteDeclare(node); },
          [&](const Evaluate& node) { Value(node.expr); },
          [&](const If& node) { WriteIf(node, stmt.hint); },
          [&](const For& node) {
            WriteStatements(program_.stmt_lists[node.init]);
            WriteLoop(node.condition, node.step, node.body, true, stmt.hint);
          },
          [&](const While& node) { WriteLoop(node.condition, {}, node.body, true, stmt.hint); },
          [&](const DoWhile& node) { WriteLoop(node.condition, {}, node.body, false, stmt.hint); },
          [&](const Switch& node) { WriteSwitch(node, stmt.hint); },
          [&](const Return& node) { WriteReturn(node); },
          [&](const Break&) { Branch(loops_.back().merge); },
          [&](const Continue&) { Branch(loops_.back().next); },
          [&](const Discard&) { WriteDiscard(); },
      },
      stmt.node);
}

void Writer::WriteDeclare(const Declare& node) {
  const Var& var = (*this)[node.var];
  const ExprId init = node.init ? node.init : var.init;
  const bool was_precise =
      std::exchange(is_precise_, is_precise_ || is_precise_var_[node.var.index]);
  if (!in_memory_[node.var.index]) {
    values_[node.var.index] = Value(init);
  } else {
    const Place place = NewLocal(var.type, var.name);
    pointers_[node.var.index] = place.base;
    values_[node.var.index] = 0;
    if (init) Store(place, Value(init));
  }
  is_precise_ = was_precise;
}

void Writer::WriteIf(const If& node, Hint hint) {
  const Ref condition = Value(node.condition);
  const Ref then = module_.NewRef(), merge = module_.NewRef();
  const Ref otherwise = node.otherwise ? module_.NewRef() : merge;
  Do(spv::Op::OpSelectionMerge, {merge, SelectionOf(hint)});
  Branch(condition, then, otherwise);
  Label(then);
  WriteStatement(node.then);
  bool is_reached = is_open_ || !node.otherwise;
  Branch(merge);
  if (node.otherwise) {
    Label(otherwise);
    WriteStatement(node.otherwise);
    is_reached = is_reached || is_open_;
    Branch(merge);
  }
  Label(merge);
  if (is_reached) return;
  Do(spv::Op::OpUnreachable, {});
  is_open_ = false;
}

void Writer::WriteLoop(ExprId condition, ExprId step, StmtId body, bool asks_first, Hint hint) {
  const Ref header = module_.NewRef(), start = module_.NewRef(), next = module_.NewRef(),
            merge = module_.NewRef();
  Branch(header);
  Label(header);
  Do(spv::Op::OpLoopMerge, {merge, next, LoopControlOf(hint)});
  Branch(start);
  Label(start);
  if (asks_first && condition) {
    const Ref goes_on = Value(condition), inner = module_.NewRef();
    Branch(goes_on, inner, merge);
    Label(inner);
  }
  loops_.push_back({merge, next});
  WriteStatement(body);
  loops_.pop_back();
  Branch(next);
  Label(next);
  if (step) Value(step);
  if (asks_first) {
    Branch(header);
  } else {
    const Ref goes_on = Value(condition);
    Branch(goes_on, header, merge);
  }
  Label(merge);
}

void Writer::WriteSwitch(const Switch& node, Hint hint) {
  const Ref value = Value(node.value), merge = module_.NewRef();
  const auto cases = program_.switch_cases[node.cases];
  Words labels;
  Ref otherwise = merge;
  std::vector<Ref> arms;
  for (const SwitchCase& arm : cases) {
    arms.push_back(module_.NewRef());
    if (arm.is_default) otherwise = arms.back();
    for (const ExprId label : (*this)[arm.labels]) {
      const auto* literal = As<Literal>(label);
      if (!literal) {
        Lack("a label that is not a literal");
        return;
      }
      labels.push_back(static_cast<std::uint32_t>(literal->bits));
      labels.push_back(arms.back());
    }
  }
  Do(spv::Op::OpSelectionMerge, {merge, SelectionOf(hint)});
  Words operands{value, otherwise};
  operands.insert(operands.end(), labels.begin(), labels.end());
  Put(code_, spv::Op::OpSwitch, operands);
  is_open_ = false;
  const Ref next = loops_.empty() ? 0 : loops_.back().next;
  loops_.push_back({merge, next});
  for (std::size_t i = 0; i < cases.size(); ++i) {
    Label(arms[i]);
    WriteStatements(program_.stmt_lists[cases[i].body]);
    Branch(i + 1 < cases.size() ? arms[i + 1] : merge);
  }
  loops_.pop_back();
  Label(merge);
}

void Writer::WriteReturn(const Return& node) {
  if (node.value) {
    const Ref value = Value(node.value);
    Do(spv::Op::OpReturnValue, {value});
  } else {
    Do(spv::Op::OpReturn, {});
  }
  is_open_ = false;
}

void Writer::WriteDiscard() {
  Do(module_.minor_version() >= 6 ? spv::Op::OpTerminateInvocation : spv::Op::OpKill, {});
  is_open_ = false;
}

}  // namespace clipc::spirv
