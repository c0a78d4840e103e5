// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "ir/walk.h"
#include "legalize/es100/elements.h"

namespace clipc::legalize {

using namespace ir;

namespace {

class ElementWrites {
 public:
  ElementWrites(Legalizer& legalizer, const Elements& elements)
      : legalizer_(legalizer), elements_(elements), program_(legalizer.program) {}

  void LowerCalls(FunctionId function) {
    std::vector<ExprId> calls;
    ForEachExpr(program_, program_.functions[function].body, [&](ExprId expr) {
      if (As<Call>(program_, expr)) calls.push_back(expr);
    });
    declares_.clear();
    for (const ExprId call : calls) LowerCall(call);
    if (declares_.empty()) return;
    const auto body = BodyOf(program_, function);
    declares_.insert(declares_.end(), body.begin(), body.end());
    program_.functions[function].body = Builder(program_).BlockOf(declares_);
  }

  // a[i].x = v  =>  set_element_x(i, v, a) with { if (i == 0) return a[0].x = v; ... }
  void LowerWrite(ExprId expr) {
    while (LowerOneWrite(expr)) {
    }
  }

 private:
  // ---- calls of the shader's functions

  // f(a[i])  =>  index = i, value = a[index], result = f(value), a[index] = value, result
  void LowerCall(ExprId expr) {
    const Call node = *As<Call>(program_, expr);
    const auto listed = std::as_const(program_).expr_lists[node.arguments];
    std::vector<ExprId> arguments(listed.begin(), listed.end()), before, after;
    Builder b = legalizer_.At(expr);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      if (!WritesOperand(program_, expr, i) || PathOf(arguments[i]).parts.empty()) continue;
      std::vector<VarId> indices;
      TakeIndices(b, arguments[i], indices, before);
      const VarId value = NewLocal(b, "value", b.TypeOf(arguments[i]));
      const VarId parameter = program_.functions[node.function].parameters[i];
      if (program_.vars[parameter].storage == Storage::kInOut)
        before.push_back(b.AssignTo(b.Ref(value), Again(b, arguments[i], indices)));
      after.push_back(b.AssignTo(Again(b, arguments[i], indices), b.Ref(value)));
      arguments[i] = b.Ref(value);
    }
    if (after.empty()) return;
    const TypeId type = program_.exprs[expr].type;
    ExprId call = b.Add(
        type, Call{node.function, program_.expr_lists.Add(std::span<const ExprId>(arguments))});
    if (program_.types[type].kind != TypeKind::kVoid) {
      const VarId result = NewLocal(b, "result", type);
      call = b.AssignTo(b.Ref(result), call);
      after.push_back(b.Ref(result));
    }
    before.push_back(call);
    before.insert(before.end(), after.begin(), after.end());
    ExprId chain = before[0];
    for (std::size_t i = 1; i < before.size(); ++i) chain = b.CommaOf(chain, before[i]);
    program_.exprs[expr].type = program_.exprs[chain].type;
    legalizer_.Become(expr, chain);
  }

  VarId NewLocal(Builder b, const char* name, TypeId type) {
    const VarId var = b.Local(name, type);
    declares_.push_back(b.Stmt(Declare{var, {}}));
    return var;
  }

  // Puts the indices of a path that are not constant into variables, the one next to the root
  // first.
  void TakeIndices(Builder b, ExprId part, std::vector<VarId>& indices,
                   std::vector<ExprId>& before) {
    if (!part) return;
    TakeIndices(b, WholeOf(program_, part), indices, before);
    const auto* index = As<Index>(program_, part);
    if (!index || As<Literal>(program_, index->index)) return;
    const ExprId value = index->index;
    indices.push_back(NewLocal(b, "index", b.TypeOf(value)));
    before.push_back(b.AssignTo(b.Ref(indices.back()), value));
  }

  // A copy of the path with these indices.
  ExprId Again(Builder b, ExprId path, const std::vector<VarId>& indices) {
    std::vector<ExprId> parts;
    for (ExprId part = path; part; part = WholeOf(program_, part)) parts.push_back(part);
    ExprId whole = b.Add(b.TypeOf(parts.back()), program_.exprs[parts.back()].node);
    std::size_t next = 0;
    for (std::size_t i = parts.size() - 1; i-- > 0;) {
      whole = PartAgain(b, parts[i], whole, [&] { return b.Ref(indices[next++]); });
    }
    return whole;
  }

  // A copy of the part, of another whole; `next` makes the next index that is not constant.
  ExprId PartAgain(Builder b, ExprId part, ExprId whole, const std::function<ExprId()>& next) {
    const TypeId type = program_.exprs[part].type;
    Legalizer::Node node = program_.exprs[part].node;
    if (auto* index = std::get_if<Index>(&node)) {
      const auto* literal = As<Literal>(program_, index->index);
      index->index = literal ? b.Add(b.TypeOf(index->index), Literal(*literal)) : next();
      index->base = whole;
    } else if (auto* field = std::get_if<FieldRef>(&node)) {
      field->base = whole;
    } else if (auto* swizzle = std::get_if<Swizzle>(&node)) {
      swizzle->base = whole;
    }
    return b.Add(type, node);
  }

  // ---- HLSL's own operators and functions that write

  // The path to a target: each node in it is a part of the one before it.
  struct Path {
    std::vector<ExprId> parts;  // from the first index that is not constant on
    ExprId base;                // the whole that this index is applied to
  };
  Path PathOf(ExprId target) const {
    Path path;
    std::vector<ExprId> parts;
    for (ExprId part = target; part; part = WholeOf(program_, part)) parts.push_back(part);
    while (!parts.empty() && elements_.CountOf(parts.back()) == 0) parts.pop_back();
    if (parts.empty()) return path;
    path.parts.assign(parts.rbegin(), parts.rend());
    path.base = As<Index>(program_, path.parts[0])->base;
    return path;
  }

  bool LowerOneWrite(ExprId expr) {
    const std::vector<ExprId> operands = OperandsOf(program_, expr);
    for (std::size_t i = 0; i < operands.size(); ++i) {
      if (!WritesOperand(program_, expr, i)) continue;
      const Path path = PathOf(operands[i]);
      if (path.parts.empty()) continue;
      BecomeWrite(expr, operands, i, path);
      return true;
    }
    return false;
  }

  void BecomeWrite(ExprId expr, const std::vector<ExprId>& operands, std::size_t written,
                   const Path& path) {
    parameters_.clear();
    names_.clear();
    arguments_.clear();
    std::string name = NameOf(expr);
    std::vector<std::size_t> indices;  // parameters, of the parts that are an Index
    const std::uint32_t count = elements_.CountOf(path.parts[0]);
    for (std::size_t i = 0; i < operands.size(); ++i) {
      if (i != written) {
        AddParameter("x", operands[i],
                     WritesOperand(program_, expr, i) ? Storage::kInOut : Storage::kIn);
        continue;
      }
      for (const ExprId part : path.parts) {
        name += SuffixOf(part);
        const auto* index = As<Index>(program_, part);
        if (!index || As<Literal>(program_, index->index)) continue;
        indices.push_back(arguments_.size());
        AddParameter("i", index->index, Storage::kIn);
      }
    }
    // The base is the last argument: it is copied after the others are evaluated.
    const std::size_t base = AddParameter("a", path.base, Storage::kInOut);
    const Legalizer::Node node = program_.exprs[expr].node;
    const TypeId type = program_.exprs[expr].type;
    const bool has_value = program_.types[type].kind != TypeKind::kVoid;
    legalizer_.BecomeCall(expr, name, parameters_, arguments_, [&](HelperBody& body) {
      for (std::uint32_t k = 0; k < count; ++k) {
        const ExprId target = Rebuilt(body, path, indices, base, k);
        // A copy of the node that writes, of the helper's parameters and the target.
        const ExprId copy = body.b.CopyOf(type, node);
        std::size_t operand = 0, parameter = 0;
        MapOperands(program_, copy, [&](ExprId) {
          if (operand++ != written) return body[parameter++];
          parameter += indices.size();
          return target;
        });
        std::vector<StmtId> found = {has_value ? body.b.Stmt(Return{copy}) : body.b.Eval(copy)};
        if (k + 1 == count) {
          body.Add(found[0]);
          continue;
        }
        if (!has_value) found.push_back(body.b.Stmt(Return{}));
        body.Add(
            body.b.Stmt(If{IsElement(program_, body, indices[0], k), body.b.BlockOf(found), {}}));
      }
    });
  }

  std::size_t AddParameter(const char* name, ExprId argument, Storage storage) {
    const auto same =
        std::ranges::count(names_, name[0], [](const auto& other) { return other[0]; });
    names_.push_back(same == 0 ? name : name + std::to_string(same + 1));
    parameters_.push_back({names_.back(), program_.exprs[argument].type, storage});
    arguments_.push_back(argument);
    return arguments_.size() - 1;
  }

  // A copy of the path, from element `k` of the parameter `base` on.
  ExprId Rebuilt(HelperBody& body, const Path& path, const std::vector<std::size_t>& indices,
                 std::size_t base, std::uint32_t k) {
    ExprId whole = body.b.At(body[base], k);
    std::size_t next = 1;
    for (std::size_t i = 1; i < path.parts.size(); ++i) {
      whole = PartAgain(body.b, path.parts[i], whole, [&] { return body[indices[next++]]; });
    }
    return whole;
  }

  // The beginning of a helper function's name. It tells helper functions of the same parameters
  // apart.
  std::string NameOf(ExprId expr) const {
    return Visit(Overloaded{
                     [](const Assign& node) {
                       return node.op ? "assign_" + std::string(legalize::NameOf(*node.op)) : "set";
                     },
                     [](const Unary& node) {
                       switch (node.op) {
                         case UnaryOp::kPreIncrement: return std::string("pre_increment");
                         case UnaryOp::kPreDecrement: return std::string("pre_decrement");
                         case UnaryOp::kPostIncrement: return std::string("post_increment");
                         default: return std::string("post_decrement");
                       }
                     },
                     [&](const Call& node) { return program_.functions[node.function].name; },
                     [](const IntrinsicCall& node) { return std::string(ir::NameOf(node.op)); },
                     [](const auto&) { return std::string("write"); },
                 },
                 program_.exprs[expr].node);
  }
  std::string SuffixOf(ExprId part) const {
    if (const auto* index = As<Index>(program_, part)) {
      const auto* literal = As<Literal>(program_, index->index);
      return literal ? "_" + std::to_string(literal->bits) : "_element";
    }
    if (const auto* field = As<FieldRef>(program_, part))
      return "_field" + std::to_string(field->field);
    std::string suffix = "_";
    const auto* swizzle = As<Swizzle>(program_, part);
    for (int i = 0; swizzle && i < swizzle->count; ++i) suffix += "xyzw"[swizzle->components[i]];
    return suffix;
  }

  Legalizer& legalizer_;
  const Elements& elements_;
  Program& program_;
  std::vector<StmtId> declares_;  // new declarations of the function whose calls are lowered
  // The parts of the helper function that is being made.
  std::vector<Parameter> parameters_;
  std::deque<std::string> names_;  // a deque, since parameters_ refers to the texts
  std::vector<ExprId> arguments_;
};

}  // namespace

void LowerElementCalls(Legalizer& legalizer, const Elements& elements) {
  ElementWrites writes(legalizer, elements);
  const std::size_t functions = legalizer.program.functions.size();
  for (std::uint32_t i = 0; i < functions; ++i) writes.LowerCalls(FunctionId{i});
}

void LowerElementWrite(Legalizer& legalizer, const Elements& elements, ExprId expr) {
  if (IsOfWritingKind(legalizer.program.exprs[expr]))
    ElementWrites(legalizer, elements).LowerWrite(expr);
}

}  // namespace clipc::legalize
