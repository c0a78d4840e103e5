// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/resolve/compare_samplers.h"

#include <algorithm>
#include <vector>

#include "ir/access.h"
#include "ir/builder.h"

namespace clipc::resolve {
namespace {

class Comparer {
 public:
  Comparer(Program& program, std::span<const std::string> names, Diagnostics& diagnostics)
      : program_(program),
        names_(names),
        diagnostics_(diagnostics),
        compares_(program.vars.size(), false) {}

  void Run() {
    for (const std::string& name : names_) Mark(name);
    if (diagnostics_.has_errors()) return;
    // The calls that are added need no second look.
    const std::size_t count = program_.exprs.size();
    for (const ExprId id : program_.exprs.ids()) {
      if (id.index >= count) break;
      const auto* call = As<ObjectCall>(program_, id);
      if (call &&
          KindOf(OperandOf(program_, *call, OperandKind::kObject)) == ObjectKind::kSampler2D)
        Read(id, *call);
    }
    for (const Resource& resource : program_.resources) {
      Var& var = program_.vars[resource.var];
      if (compares_[resource.var.index]) var.type = Compared(var.type);
    }
  }

 private:
  ObjectKind KindOf(ExprId object) const {
    return program_.types[program_.types.Innermost(program_.exprs[object].type)].object;
  }
  TypeId Compared(TypeId type) {
    return program_.types.WithKind(type, ObjectKind::kSampler2DShadow);
  }

  // Marks the samplers of this name; reports those that cannot compare.
  void Mark(const std::string& name) {
    bool is_known = false;
    for (const Resource& resource : program_.resources) {
      const Var& var = program_.vars[resource.var];
      if (var.name != name) continue;
      is_known = true;
      const ObjectKind kind = program_.types[program_.types.Innermost(var.type)].object;
      if (kind == ObjectKind::kSampler2D)
        compares_[resource.var.index] = true;
      else if (IsSampler(kind) && !IsCombinedSampler(kind))
        diagnostics_.Report(var.span, diag::ShadowSamplerMethod, name);
      else
        diagnostics_.Report(var.span, diag::ShadowSamplerKind, name,
                            program_.types.Name(program_.types.Object(kind)));
    }
    if (!is_known) diagnostics_.Report({}, diag::ShadowSamplerUnknown, name);
  }

  // Settles a read of a sampler2D: one that compares has one component, for all four, and another
  // one has no third coordinate.
  void Read(ExprId id, const ObjectCall& call) {
    const ExprId object = OperandOf(program_, call, OperandKind::kObject);
    const bool has_level =
        Takes(call.op, OperandKind::kLevel) || Takes(call.op, OperandKind::kBias);
    const VarId var = RootOf(program_, object);
    if (!var || !compares_[var.index]) {
      if (has_level) DropThird(OperandsOf(call, OperandKind::kCoordinate));
      return;
    }
    if (!has_level && call.op != ObjectOp::kD3d9SampleProjected) {
      diagnostics_.Report(program_.exprs[id].span, diag::ShadowSamplerPlace,
                          program_.vars[var].name, program_.vars[var].name);
      return;
    }
    TypePath(object);
    const TypeId four = program_.exprs[id].type;
    Expr whole = program_.exprs[id];
    whole.type = program_.types.Make(Scalar::kFloat);
    const ExprId lone = program_.exprs.Add(whole);
    program_.exprs[id].node = Splat{lone};
    program_.exprs[id].type = four;
  }

  // Takes the third component from the coordinate of a call.
  void DropThird(List<ExprId> coordinate) {
    const ExprId place = program_.expr_lists[coordinate][0];
    Expr& expr = program_.exprs[place];
    if (auto* run = std::get_if<Swizzle>(&expr.node)) {
      run->count = 2, run->components[2] = 0;
      expr.type = program_.types.Vector(Scalar::kFloat, 2);
      return;
    }
    const ExprId flat = Builder(program_, expr.span).SwizzledRun(place, 0, 2);
    program_.expr_lists[coordinate][0] = flat;
  }

  // Gives the expressions of a path to a sampler, an index of an array of them, their types.
  void TypePath(ExprId path) {
    program_.exprs[path].type = Compared(program_.exprs[path].type);
    if (const auto* index = As<Index>(program_, path)) TypePath(index->base);
  }

  Program& program_;
  std::span<const std::string> names_;
  Diagnostics& diagnostics_;
  std::vector<bool> compares_;  // by variable
};

}  // namespace

void CompareSamplers(Program& program, std::span<const std::string> names,
                     Diagnostics& diagnostics) {
  if (!names.empty()) Comparer(program, names, diagnostics).Run();
}

}  // namespace clipc::resolve
