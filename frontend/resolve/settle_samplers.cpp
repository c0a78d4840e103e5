// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/resolve/settle_samplers.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "frontend/resolve/drop_dead_reads.h"
#include "ir/access.h"
#include "ir/walk.h"

namespace clipc::resolve {
namespace {

constexpr std::uint32_t kAnyElement = ~0u;

class Settler {
 public:
  Settler(Program& program, Diagnostics& diagnostics)
      : program_(program), diagnostics_(diagnostics) {}

  // Reads the uses of samplers, in the calls that are marked by ExprId; in all if `live` is empty.
  void Read(const std::vector<bool>& live) {
    program_.exprs.ForEach([&](ExprId id, const Expr& expr) {
      const auto* call = std::get_if<ObjectCall>(&expr.node);
      if (!call || (!live.empty() && !live[id.index])) return;
      for (const OperandKind kind : {OperandKind::kObject, OperandKind::kSampler}) {
        if (const ExprId path = OperandOf(program_, *call, kind)) Note(path, id);
      }
    });
    for (const VarId var : order_) FindConflict(var);
  }

  bool HasConflicts() const { return !conflicts_.empty(); }
  void ReportConflicts() const {
    for (const Conflict& each : conflicts_) {
      diagnostics_.Report(each.span, diag::SamplerKinds, program_.vars[each.var].name,
                          program_.types.Name(program_.types.Object(each.one)),
                          program_.types.Name(program_.types.Object(each.other)));
    }
  }

  void Settle() {
    // The resources that are added come in the order of their first uses.
    std::vector<Resource> added;
    for (const VarId var : order_) Settle(var, added);
    const bool is_old = program_.profile.IsDirect3D9();
    program_.resources.insert(is_old ? program_.resources.end() : program_.resources.begin(),
                              added.begin(), added.end());
  }

 private:
  // A sampler that is read as two kinds.
  struct Conflict {
    Span span;
    VarId var;
    ObjectKind one, other;
  };
  // What a sampler is used for.
  struct Uses {
    bool is_plain = false;
    std::map<ObjectKind, std::vector<ExprId>> reads;  // the paths of Direct3D 9's functions
    std::map<std::uint32_t, ObjectKind> elements;     // of an array; 0 is a sampler alone
  };

  ObjectKind KindOf(TypeId type) const {
    return program_.types[program_.types.Innermost(type)].object;
  }

  void Note(ExprId path, ExprId call) {
    const TypeId type = program_.exprs[path].type;
    const VarId root =
        program_.types[type].kind == TypeKind::kObject ? RootOf(program_, path) : VarId{};
    if (!root || program_.vars[root].storage != Storage::kResource ||
        KindOf(program_.vars[root].type) != ObjectKind::kSampler)
      return;
    const auto [found, is_new] = uses_.try_emplace(root);
    if (is_new) order_.push_back(root);
    const ObjectKind kind = KindOf(type);
    if (!IsCombinedSampler(kind)) {
      found->second.is_plain = true;
      return;
    }
    found->second.reads[kind].push_back(path);
    const auto [element, is_first] = found->second.elements.try_emplace(ElementOf(path), kind);
    if (!is_first && element->second != kind)
      conflicts_.push_back({program_.exprs[call].span, root, element->second, kind});
  }

  std::uint32_t ElementOf(ExprId path) const {
    const auto* index = As<Index>(program_, path);
    const auto* literal = index ? As<Literal>(program_, index->index) : nullptr;
    return !index ? 0 : literal ? static_cast<std::uint32_t>(literal->bits) : kAnyElement;
  }

  static bool IsFlat(ObjectKind kind) {
    return kind == ObjectKind::kSampler1D || kind == ObjectKind::kSampler2D;
  }

  // Elements of an array with an index that is not known have the kind of the others.
  void FindConflict(VarId var) {
    const Uses& uses = uses_.at(var);
    for (const auto& [element, kind] : uses.elements) {
      const ObjectKind first = uses.elements.begin()->second;
      const bool may_differ = program_.profile.IsDirect3D9() || (IsFlat(kind) && IsFlat(first));
      if (kind == first || (may_differ && !uses.elements.contains(kAnyElement))) continue;
      conflicts_.push_back({program_.exprs[uses.reads.at(kind).front()].span, var, first, kind});
      return;
    }
  }

  void Settle(VarId var, std::vector<Resource>& added) {
    const Uses& uses = uses_.at(var);
    if (uses.reads.empty()) return;
    bool keeps_variable = !uses.is_plain;
    for (const auto& [kind, paths] : uses.reads) {
      if (std::exchange(keeps_variable, false)) {
        Retype(var, kind);
        continue;
      }
      const Resource& resource = *std::ranges::find(program_.resources, var, &Resource::var);
      Resource copy = resource;
      copy.reg = {.letter = 't', .number = 0, .space = resource.reg.space};
      copy.var = program_.vars.Add(Var(program_.vars[var]));
      Retype(copy.var, kind);
      for (const ExprId path : paths) Rename(path, copy.var);
      added.push_back(copy);
    }
    for (const auto& [kind, paths] : uses.reads) {
      for (const ExprId path : paths) TypeRoot(path);
    }
  }

  void Retype(VarId var, ObjectKind kind) {
    program_.vars[var].type = program_.types.WithKind(program_.vars[var].type, kind);
  }

  ExprId RootExpr(ExprId path) const {
    while (const auto* index = As<Index>(program_, path)) path = index->base;
    return path;
  }
  void Rename(ExprId path, VarId var) { program_.exprs[RootExpr(path)].node = VarRef{var}; }
  // Gives the expressions of the path the types that follow from the variable's.
  void TypeRoot(ExprId path) {
    std::vector<ExprId> steps{path};
    while (const auto* index = As<Index>(program_, steps.back())) steps.push_back(index->base);
    TypeId type = program_.vars[RootOf(program_, path)].type;
    for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
      program_.exprs[*step].type = type;
      type = program_.types[type].element;
    }
  }

  Program& program_;
  Diagnostics& diagnostics_;
  std::map<VarId, Uses> uses_;
  std::vector<VarId> order_;
  std::vector<Conflict> conflicts_;
};

}  // namespace

void SettleSamplers(Program& program, Diagnostics& diagnostics) {
  if (!program.calls_objects) return;
  Settler written(program, diagnostics);
  written.Read({});
  if (!written.HasConflicts()) return written.Settle();
  DropDeadReads(program);
  std::vector<bool> live(program.exprs.size());
  ForEachLiveExpr(program, [&](ExprId expr) { live[expr.index] = true; });
  Settler left(program, diagnostics);
  left.Read(live);
  if (left.HasConflicts()) return left.ReportConflicts();
  left.Settle();
}

}  // namespace clipc::resolve
