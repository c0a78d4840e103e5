// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "backend-glsl/requirements.h"
#include "backend-glsl/target.h"
#include "base/diagnostics.h"
#include "ir/access.h"
#include "ir/program.h"
#include "legalize/split_arrays.h"

namespace clipc::glsl {

// The reporter of what a target lacks. A kind of number that it lacks is reported once.
class TargetReport {
 protected:
  using ExprId = ir::ExprId;
  using VarId = ir::VarId;
  using TypeId = ir::TypeId;

  TargetReport(const ir::Program& program, const Target& target, Diagnostics& diagnostics)
      : program_(program),
        target_(target),
        diagnostics_(diagnostics),
        seen_types_(program.types.size()) {}

  const ir::Type& TypeOf(ExprId expr) const { return program_.types[program_.exprs[expr].type]; }
  const ir::Type& TypeOf(VarId var) const { return program_.types[program_.vars[var].type]; }
  const ir::Type& Innermost(TypeId id) const {
    return program_.types[program_.types.Innermost(id)];
  }
  bool IsArray(TypeId type) const { return program_.types[type].kind == ir::TypeKind::kArray; }
  template <typename Node>
  const Node* As(auto id) const {
    return ir::As<Node>(program_, id);
  }

  // Reports a message, which ends with the target's name.
  void Report(Span span, const auto& kind, const auto&... arguments) {
    diagnostics_.Report(span, kind, arguments..., target_.name());
  }

  // Reports the needed feature if the target lacks it.
  void Check(const Requirement* requirement, Span span, std::string_view name = {}) {
    if (requirement && !target_.Has(requirement->feature)) Lack(*requirement, span, name);
  }
  void Check(Feature feature, const Requirement::Plain& message, Span span) {
    if (!target_.Has(feature)) Lack(feature, span, message);
  }
  void Check(Feature feature, const Requirement::Named& message, Span span, std::string_view name) {
    if (!target_.Has(feature)) Lack(feature, span, message, name);
  }
  void Lack(const Requirement& requirement, Span span, std::string_view name) {
    if (requirement.plain) return Lack(requirement.feature, span, *requirement.plain);
    Lack(requirement.feature, span, *requirement.named,
         requirement.what.empty() ? name : requirement.what);
  }
  // Reports a missing feature, and the nearest target that has it.
  void Lack(Feature feature, Span span, const auto& kind, const auto&... names) {
    Diagnostic& report = diagnostics_.Report(span, kind, names..., target_.name());
    const std::string_view nearest = target_.NearestWith(feature);
    if (!nearest.empty()) report.Note({}, diag::TargetNearest, nearest);
  }

  // Reports the kinds of numbers in the type that the target lacks.
  void Type(TypeId id, Span span);

  const ir::Program& program_;
  const Target& target_;
  Diagnostics& diagnostics_;

 private:
  std::vector<char> seen_types_;  // by TypeId
  bool reported_[2] = {};         // the lack of double; of 64-bit integers
};

// The check of expressions.
class ExpressionCheck : protected TargetReport {
 protected:
  // `has_blocks`: constant buffers become uniform blocks.
  ExpressionCheck(const ir::Program& program, const Target& target, bool has_blocks,
                  Diagnostics& diagnostics)
      : TargetReport(program, target, diagnostics), has_blocks_(has_blocks) {}

  // Whether Expression may report other expressions than those of Reached::asked.
  bool MayReportAll() const;
  void Expression(ExprId id);

  const bool has_blocks_;
  const legalize::ArraySplit split_ = target_.Needs().split_arrays;
  // By VarId: the indices of loops by which a uniform of GLSL ES 1.00 may be indexed.
  std::vector<char> loop_indices_;

 private:
  void SmallIntegers(ExprId id, const ir::Expr& expr);
  void BitOperator(BinaryOp op, const ir::Type& type, Span span);
  void UintOperand(const ir::Type& type, Span span);
  void IntrinsicUse(const ir::IntrinsicCall& call, Span span);
  void Interpolant(const ir::IntrinsicCall& call, Span span);
  void Status(ir::ObjectKind object, Span span);
  void ObjectUse(const ir::ObjectCall& call, Span span);
  void StoreUse(ExprId object, const ir::ObjectCall& call, Span span);
  void ObjectArgument(ExprId object);
  void SplitElement(ExprId element);
  void BufferIndex(const ir::Index& index, Span span);

  const bool has_unsigned_ = target_.Has(Feature::kUnsigned);
  bool uint_reported_ = false;
  bool non_uniform_reported_ = false;
  std::optional<std::set<VarId>> exchanged_;  // BuffersOfExchangedFloats, once asked for
};

}  // namespace clipc::glsl
