// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <cstddef>
#include <vector>

#include "backend-glsl/legalize/legalize.h"
#include "ir/access.h"
#include "ir/walk.h"

namespace clipc::glsl {

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
      if (IsLost(id)) PutBefore(id, {TakeIndex(id)});
    }
  }

 private:
  // v.wyx[i] of a uniform  =>  v[ivec3(3, 1, 0)[i]], since Mesa 22.3's OpenGL reads v[i].
  void LowerSwizzled(ExprId expr) {
    const Index node = *As<Index>(program_, expr);
    const auto* swizzle = As<Swizzle>(program_, node.base);
    if (!swizzle || swizzle->count < 2 || legalizer_.target.IsVulkan() ||
        As<Literal>(program_, node.index))
      return;
    const VarId root = RootOf(program_, swizzle->base);
    if (!root || program_.vars[root].storage != Storage::kUniform) return;
    IndexWholeVector(program_, expr);
  }

  // Whether the expression indexes the only row, or the only component, for which GLSL has no [],
  // by an index that changes something.
  bool IsLost(ExprId expr) {
    const auto* node = As<Index>(program_, expr);
    return node && IsOnlyElement(program_, *node) && !legalizer_.MayBeSkipped(node->index);
  }

  // Whether the expression indexes the only element of an array by a computed index. Mesa 22.3's
  // OpenGL writes all components where `a[i].y = 1` writes one.
  bool IsOfOne(ExprId expr) {
    const auto* node = As<Index>(program_, expr);
    if (!node || legalizer_.target.IsVulkan() || As<Literal>(program_, node->index)) return false;
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
        if (!legalizer_.MayBeSkipped(index)) indices.push_back(index);
      }
      std::reverse(indices.begin() + static_cast<std::ptrdiff_t>(begin), indices.end());
    }
    PutBefore(expr, indices);
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

}  // namespace clipc::glsl
