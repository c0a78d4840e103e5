// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <cstddef>
#include <vector>

#include "ir/access.h"
#include "ir/walk.h"
#include "legalize/legalize.h"

namespace clipc::legalize {

using namespace ir;

namespace {

class IndexLowering {
 public:
  explicit IndexLowering(Legalizer& legalizer)
      : legalizer_(legalizer), program_(legalizer.program) {}

  void Run() {
    bool is_any = false;
    legalizer_.ForEach([&](ExprId id) {
      if (As<Index>(program_, id) == nullptr) return;
      is_any = true;
      LowerSwizzled(id);
    });
    if (!is_any) return;
    std::vector<ExprId> writes, indices;
    ForEachLiveExpr(program_, [&](ExprId id) {
      if (IsOfWritingKind(program_.exprs[id])) writes.push_back(id);
      if (IsLost(id)) indices.push_back(id);
    });
    // Targets are lowered first: GLSL does not assign to a comma expression.
    for (const ExprId id : writes) LowerTargets(id);
    for (const ExprId id : indices) {
      if (!IsLost(id)) continue;
      const ExprId index = TakeIndex(id);
      if (!legalizer_.MayBeSkipped(index) && !PutAfterRest(id, index)) PutBefore(id, {index});
    }
  }

 private:
  // v.wyx[i] of a uniform  =>  v[ivec3(3, 1, 0)[i]], since Mesa 22.3's OpenGL reads v[i].
  void LowerSwizzled(ExprId expr) {
    const Index node = *As<Index>(program_, expr);
    const auto* swizzle = As<Swizzle>(program_, node.base);
    if (!swizzle || swizzle->count < 2 || !legalizer_.needs.simple_indices ||
        As<Literal>(program_, node.index))
      return;
    const VarId root = RootOf(program_, swizzle->base);
    if (!root || program_.vars[root].storage != Storage::kUniform) return;
    IndexWholeVector(program_, expr);
  }

  // Whether the expression indexes the only row, or the only component, for which GLSL has no [],
  // by an index that assigns or calls.
  bool IsLost(ExprId expr) {
    const auto* node = As<Index>(program_, expr);
    return node && IsOnlyElement(program_, *node) && !IsPure(program_, node->index);
  }

  // Whether the expression indexes the only element of an array by a computed index. Mesa 22.3's
  // OpenGL writes all components where `a[i].y = 1` writes one.
  bool IsOfOne(ExprId expr) {
    const auto* node = As<Index>(program_, expr);
    if (!node || !legalizer_.needs.simple_indices || As<Literal>(program_, node->index))
      return false;
    const Type& type = TypeOf(program_, node->base);
    return type.kind == TypeKind::kArray && type.count == 1;
  }

  ExprId TakeIndex(ExprId expr) {
    const Index node = *As<Index>(program_, expr);
    program_.exprs[expr].node = Index{node.base, legalizer_.At(expr).Int(0)};
    return node.index;
  }

  void LowerTargets(ExprId expr) {
    std::vector<ExprId> targets;
    ForEachWrite(program_, expr, [&](ExprId target) { targets.push_back(target); });
    std::vector<ExprId> indices;
    for (const ExprId target : targets) {
      const std::size_t begin = indices.size();
      for (ExprId part = target; part; part = WholeOf(program_, part)) {
        if (!IsLost(part) && !IsOfOne(part)) continue;
        const ExprId index = TakeIndex(part);
        if (!legalizer_.MayBeSkipped(index) && !PutAfterRest(part, index)) indices.push_back(index);
      }
      std::reverse(indices.begin() + static_cast<std::ptrdiff_t>(begin), indices.end());
    }
    PutBefore(expr, indices);
  }

  // The last expression that changes something among those that the path evaluates before its own
  // index: an index, or the value that the path is a part of.
  ExprId LastBefore(ExprId path) {
    for (ExprId part = WholeOf(program_, path);; part = WholeOf(program_, part)) {
      const bool is_root = !WholeOf(program_, part);
      const auto* node = As<Index>(program_, part);
      if (is_root) return legalizer_.MayBeSkipped(part) ? ExprId{} : part;
      if (node && !legalizer_.MayBeSkipped(node->index)) return node->index;
    }
  }

  // Evaluates `index`, which `path` no longer has, in its place: rows[f()][g()], of one component
  // each, becomes rows[first(f(), g())]. False where nothing of the path has to be evaluated first.
  bool PutAfterRest(ExprId path, ExprId index) {
    const ExprId last = LastBefore(path);
    if (!last) return false;
    const ExprId value =
        legalizer_.At(last).Add(TypeIdOf(program_, last), program_.exprs[last].node);
    const ExprId arguments[] = {value, index};
    legalizer_.BecomeCall(last, "first", arguments, [](HelperBody& body) { body.Return(body[0]); });
    return true;
  }

  void PutBefore(ExprId expr, const std::vector<ExprId>& values) {
    Builder b = legalizer_.At(expr);
    const TypeId type = program_.exprs[expr].type;
    for (auto value = values.rbegin(); value != values.rend(); ++value) {
      const ExprId rest = b.Add(type, program_.exprs[expr].node);
      program_.exprs[expr].node = Comma{*value, rest};
    }
  }

  Legalizer& legalizer_;
  Program& program_;
};

}  // namespace

void LowerIndices(Legalizer& legalizer) { IndexLowering(legalizer).Run(); }

}  // namespace clipc::legalize
