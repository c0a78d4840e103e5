// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "passes/read_vertices.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "base/invariant.h"
#include "ir/access.h"
#include "ir/builder.h"

namespace clipc::passes {

using namespace ir;

namespace {

// A part of an array of vertices: the variable, the vertex, and the fields and elements from there
// on.
struct VertexPath {
  VarId array;
  ExprId vertex;
  std::vector<std::uint32_t> steps;
};

std::optional<std::uint32_t> LiteralOf(const Program& program, ExprId id) {
  const auto* literal = As<Literal>(program, id);
  return literal ? std::optional(static_cast<std::uint32_t>(literal->bits)) : std::nullopt;
}

// The path of the expression if it is one of fields and literal elements of an array's element.
std::optional<VertexPath> PathOf(const Program& program, ExprId id) {
  VertexPath path;
  while (true) {
    if (const auto* field = As<FieldRef>(program, id)) {
      path.steps.push_back(field->field);
      id = field->base;
      continue;
    }
    const auto* index = As<Index>(program, id);
    if (!index) return std::nullopt;
    if (const auto* ref = As<VarRef>(program, index->base)) {
      path.array = ref->var;
      path.vertex = index->index;
      std::ranges::reverse(path.steps);
      return path;
    }
    const auto element = LiteralOf(program, index->index);
    if (!element) return std::nullopt;
    path.steps.push_back(*element);
    id = index->base;
  }
}

class Reader {
 public:
  explicit Reader(Program& program) : program_(program) {
    const auto body = MainBody(program);
    body_.assign(body.begin(), body.end());
  }

  void Run() {
    for (const StmtId id : body_) Collect(id);
    const StmtId patch = PatchBlock(program_);
    const List<StmtId> of_patch = patch ? As<Block>(program_, patch)->body : List<StmtId>{};
    for (const StmtId id : program_.stmt_lists[of_patch]) Collect(id);
    if (arrays_.empty()) return;
    ForEachExpr(program_, program_.functions[program_.main].body, [&](ExprId id) { Count(id); });
    // A hull shader often passes a control point on.
    if (clipc::InfoOf(program_.stage).makes_patches) FindElements();
    for (auto& [var, array] : arrays_) {
      // Each name of the array is in a write that is known, or in a read of what it wrote.
      if (array.names == array.writes + array.reads.size()) Replace(array);
    }
    Remove(program_.functions[program_.main].body);
    if (patch) Remove(patch);
  }

 private:
  void Remove(StmtId block) {
    const auto body = program_.stmt_lists[As<Block>(program_, block)->body];
    std::vector<StmtId> left(body.begin(), body.end());
    std::erase_if(left, [&](StmtId id) { return removed_.contains(id); });
    program_.stmts[block].node = Block{program_.stmt_lists.Add(std::span<const StmtId>(left))};
  }

  struct Array {
    std::size_t names = 0, writes = 0;
    // The value of vertex 0, by the steps to the part.
    std::map<std::vector<std::uint32_t>, ExprId> values;
    ExprId element;  // the value of vertex 0 as a whole, where a read needs it
    std::vector<std::pair<ExprId, VertexPath>> reads;
    std::vector<StmtId> stmts;
  };

  // Notes the declaration of an array without a value, and the statements that give its elements
  // the inputs of their vertices.
  void Collect(StmtId id) {
    if (const auto* declare = As<Declare>(program_, id)) {
      const Type& type = program_.types[program_.vars[declare->var].type];
      const bool is_array =
          type.kind == TypeKind::kArray && (type.count == VerticesRead(program_) ||
                                            type.count == program_.tessellation.output_points);
      if (is_array && !declare->init) arrays_[declare->var].stmts.push_back(id);
      return;
    }
    const Assign* assign = AsAssignment(program_, id);
    const auto path = assign ? PathOf(program_, assign->target) : std::nullopt;
    const auto vertex = path ? LiteralOf(program_, path->vertex) : std::nullopt;
    const auto found = path ? arrays_.find(path->array) : arrays_.end();
    if (!vertex || found == arrays_.end() || !IsOfVertex(assign->value, *vertex)) return;
    Array& array = found->second;
    if (*vertex == 0) array.values.try_emplace(path->steps, assign->value);
    ++array.writes;
    array.stmts.push_back(id);
    written_.insert(assign->target);
  }

  static bool ReadsVertex(Intrinsic op) {
    return op == CommonIntrinsic::kInputOfVertex || op == CommonIntrinsic::kOutputOfPoint;
  }

  // Finds the reads of whole elements, of which no part is taken, and makes their values.
  void FindElements() {
    std::set<ExprId> parts;  // what another expression takes a part of
    const StmtId main = program_.functions[program_.main].body;
    ForEachExpr(program_, main, [&](ExprId id) {
      if (const ExprId whole = WholeOf(program_, id)) parts.insert(whole);
    });
    ForEachExpr(program_, main, [&](ExprId id) {
      auto path = parts.contains(id) || written_.contains(id) ? std::nullopt : PathOf(program_, id);
      const auto found = path && path->steps.empty() ? arrays_.find(path->array) : arrays_.end();
      if (found == arrays_.end() || found->second.values.contains({})) return;
      Array& array = found->second;
      if (!array.element) array.element = ElementOf(array, program_.exprs[id].type, {});
      if (array.element && IsPlain(path->vertex)) array.reads.emplace_back(id, std::move(*path));
    });
    for (auto& [var, array] : arrays_)
      if (array.element) array.values.try_emplace({}, array.element);
  }

  // The value of vertex 0, or of the part of it that the steps lead to; none if a part has none.
  ExprId ElementOf(const Array& array, TypeId id, std::vector<std::uint32_t> steps) {
    const auto known = array.values.find(steps);
    if (known != array.values.end()) return Clone(program_, known->second);
    const Type type = program_.types[id];
    if (type.kind != TypeKind::kStruct && type.kind != TypeKind::kArray) return {};
    std::vector<ExprId> values;
    steps.push_back(0);
    for (; steps.back() < program_.types.PartCount(id); ++steps.back()) {
      values.push_back(ElementOf(array, program_.types.PartType(id, steps.back()), steps));
      if (!values.back()) return {};
    }
    return Builder(program_).ConstructOf(id, values);
  }

  // Whether the value is made of inputs of the vertex and of nothing else that varies.
  bool IsOfVertex(ExprId value, std::uint32_t vertex) const {
    bool reads = false;
    const bool other = AnyExpr(program_, value, [&](ExprId id) {
      const auto* call = As<IntrinsicCall>(program_, id);
      if (call && ReadsVertex(call->op)) {
        reads = true;
        return LiteralOf(program_, program_.expr_lists[call->arguments][1]) != vertex;
      }
      const auto* ref = As<VarRef>(program_, id);
      if (ref) {
        const Storage storage = program_.vars[ref->var].storage;
        return storage != Storage::kInput && storage != Storage::kOutput;
      }
      const auto& node = program_.exprs[id].node;
      return !std::holds_alternative<Literal>(node) && !std::holds_alternative<Convert>(node) &&
             !std::holds_alternative<Construct>(node) && !std::holds_alternative<Index>(node) &&
             !std::holds_alternative<Swizzle>(node);
    });
    return reads && !other;
  }

  void Count(ExprId id) {
    if (const auto* ref = As<VarRef>(program_, id)) {
      if (const auto found = arrays_.find(ref->var); found != arrays_.end()) ++found->second.names;
      return;
    }
    auto path = written_.contains(id) ? std::nullopt : PathOf(program_, id);
    const auto found = path ? arrays_.find(path->array) : arrays_.end();
    if (found == arrays_.end() || !found->second.values.contains(path->steps)) return;
    if (IsPlain(path->vertex)) found->second.reads.emplace_back(id, std::move(*path));
  }

  // Whether the number of a vertex may be repeated; another vertex in it would be replaced too.
  bool IsPlain(ExprId vertex) const {
    return IsPure(program_, vertex) && !AnyExpr(program_, vertex, [&](ExprId part) {
             const auto* name = As<VarRef>(program_, part);
             return name && arrays_.contains(name->var);
           });
  }

  void Replace(const Array& array) {
    // What is written to a read would be lost.
    const StmtId main = program_.functions[program_.main].body;
    bool is_written = false;
    std::set<ExprId> reads;
    for (const auto& [id, path] : array.reads) reads.insert(id);
    ForEachExpr(program_, main, [&](ExprId id) {
      ForEachWrite(program_, id, [&](ExprId target) {
        for (ExprId part = target; part; part = WholeOf(program_, part))
          is_written |= reads.contains(part);
      });
    });
    if (is_written) return;
    for (const auto& [id, path] : array.reads) {
      const ExprId value = Clone(program_, array.values.at(path.steps));
      SetVertex(value, path.vertex);
      program_.exprs[id].node = program_.exprs[value].node;
    }
    removed_.insert(array.stmts.begin(), array.stmts.end());
  }

  // Makes the value one of another vertex.
  void SetVertex(ExprId value, ExprId vertex) {
    std::vector<List<ExprId>> calls;
    ForEachExpr(program_, value, [&](ExprId id) {
      const auto* call = As<IntrinsicCall>(program_, id);
      if (call && ReadsVertex(call->op)) calls.push_back(call->arguments);
    });
    for (const List<ExprId> arguments : calls) {
      const ExprId number = Clone(program_, vertex);
      program_.expr_lists[arguments][1] = number;
    }
  }

  Program& program_;
  std::vector<StmtId> body_;  // of main
  std::map<VarId, Array> arrays_;
  std::set<ExprId> written_;  // the targets of the known writes
  std::set<StmtId> removed_;
};

}  // namespace

void ReadVertices(Program& program) {
  CLIPC_CHECK(program.form == Form::kInlined);
  if (clipc::InfoOf(program.stage).reads_vertices) Reader(program).Run();
}

}  // namespace clipc::passes
