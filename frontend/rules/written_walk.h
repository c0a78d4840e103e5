// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/kept_blocks.h"
#include "frontend/rules/check_values.h"
#include "frontend/rules/names.h"
#include "frontend/rules/written.h"
#include "frontend/rules/written_paths.h"

// The walk of CheckWritten: check_written.cpp has the statements, written_walk.cpp the expressions.
namespace clipc::rules {

// What a function has written when it returns.
struct WrittenSummary {
  KeptVector<WrittenComponents> result;                  // by slot of the type
  KeptVector<KeptVector<WrittenComponents>> parameters;  // empty for those that are not kOut
};

// What all functions share.
struct WrittenShared {
  const Program& program;
  Diagnostics& diagnostics;
  WrittenSlots slots;
  ValueCheck values;
  WrittenPaths paths;
  KeptVector<WrittenSummary> summaries;  // by FunctionId
  KeptVector<bool> is_reported;          // by VarId
  KeptVector<IoVar*> outputs;            // by VarId
};

// Walks a function in the order in which it runs.
class WrittenWalk {
 public:
  WrittenWalk(WrittenShared& shared, WrittenState& state, FunctionId function)
      : shared_(shared), program_(shared.program), state_(state), function_(function) {}

  void Run();

 private:
  // How control leaves a statement; by break or continue it jumps.
  enum class Flow : std::uint8_t { kNext, kJump, kReturn };
  // A read of what nothing before it in the text has written; the rest of a loop around it may.
  struct Read {
    WrittenPlace place;
    Span span;
  };

  bool IsMain() const { return function_ == program_.main; }
  // Whether `main` calls the function, whose results are outputs.
  bool IsEntry() const { return IsCalledByMain(function_); }
  bool IsCalledByMain(FunctionId function) const {
    return function == program_.entry || function == program_.tessellation.patch_function;
  }

  // ---- statements
  Flow WalkList(List<StmtId> list);
  Flow Walk(StmtId stmt);
  Flow WalkIf(const If& node);
  Flow WalkSwitch(const Switch& node);
  std::uint32_t ArmOf(const Switch& node, std::int64_t value) const;
  Flow WalkLoop(StmtId stmt);
  void WalkDeclare(const Declare& node);
  void WalkReturn(ExprId value);
  void Leave();
  void ReportParameters();
  JoinPoint PointAfter(ExprId condition);

  // ---- expressions
  void Visit(ExprId expr);
  void VisitChoice(ExprId expr);
  bool VisitTarget(ExprId path);
  void VisitAssign(const Assign& node);
  bool IsOfOwnTemporary(const Assign& node) const;
  void VisitCall(ExprId expr, const Call& node);
  void VisitIntrinsic(const IntrinsicCall& node);
  void CheckRead(ExprId path);
  void Report(const Read& read);
  void Track(VarId var);
  void Unwrite(VarId var);
  void WriteTo(ExprId target, std::span<const WrittenComponents> values);
  void Write(const WrittenPlace& place, std::span<const WrittenComponents> values = {});
  // What the parts of a value are that an assignment copies; empty: all are written.
  KeptVector<WrittenComponents> ValueOf(ExprId value);

  // ---- main
  void CheckOutput(const Assign& node);

  WrittenShared& shared_;
  const Program& program_;
  WrittenState& state_;
  FunctionId function_;
  bool has_returned_ = false;
  int loops_ = 0;           // around the place of the walk
  int choices_ = 0;         // the conditions and loops that decide whether control comes there
  KeptVector<Read> reads_;  // in loops that have not ended
  WrittenSummary summary_;
};

}  // namespace clipc::rules
