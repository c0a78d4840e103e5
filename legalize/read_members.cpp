// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "legalize/read_members.h"

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "ir/access.h"
#include "ir/packing.h"
#include "ir/walk.h"
#include "legalize/value_reader.h"

namespace clipc::legalize {

using namespace ir;

namespace {

class MemberReading {
 public:
  MemberReading(Program& program, const Needs& needs)
      : program_(program), types_(program.types), needs_(needs) {}

  std::vector<FunctionId> Run(std::span<const PackedMember> members) {
    readers_.resize(program_.vars.size());
    for (const PackedMember& member : members) readers_[member.var.index] = ReaderOf(member);
    ReplaceReads();
    return std::move(readers_);
  }

 private:
  bool IsArray(VarId var) const { return types_[program_.vars[var].type].kind == TypeKind::kArray; }
  bool IsPacked(VarId var) const { return var.index < readers_.size() && readers_[var.index]; }

  FunctionId Add(const std::string& name, std::span<const Parameter> parameters, TypeId result,
                 const Define& define) {
    const FunctionId function = AddHelper(program_, name, parameters, result, define);
    program_.functions[function].is_accessor = true;
    return function;
  }

  FunctionId ReaderOf(const PackedMember& member) {
    const Var var = program_.vars[member.var];
    const bool is_array = IsArray(member.var);
    const TypeId result = is_array ? types_[var.type].element : var.type;
    std::vector<Parameter> parameters;
    if (is_array) parameters.push_back({"i", types_.Make(Scalar::kInt)});
    return Add(var.name, parameters, result, [&](HelperBody& body) {
      if (member.component) return body.Return(Joined(body, member.component, result));
      WordPlace place{{}, member.offset};
      if (is_array && !member.in_buffers) {
        const std::uint32_t rows = ArrayStride(types_, var.type, var.row_major) / kRowBytes;
        place.steps = {{rows, body.parameters[0]}};
      }
      body.Return(MemoryOf(member).Read(body, result, var.row_major, place));
    });
  }

  // A vector out of its components, of which those of bool are uints.
  ExprId Joined(HelperBody& body, VarId first, TypeId type) {
    std::vector<ExprId> components;
    const Type vector = types_[type];
    for (std::uint32_t i = 0; i < vector.Components(); ++i)
      components.push_back(body.b.Ref(VarId{first.index + i}));
    const Scalar kind = types_[body.b.TypeOf(components[0])].scalar;
    return body.b.ConvertTo(vector.scalar,
                            body.b.ConstructOf(types_.WithScalar(type, kind), components));
  }

  // The members in the same rows share the functions that fill long arrays.
  ValueReader& MemoryOf(const PackedMember& member) {
    std::optional<ValueReader>& reader = memories_[member.rows];
    if (reader) return *reader;
    WordMemory memory{.is_rows = true, .is_float = true};
    if (member.rows) {
      const Var& rows = program_.vars[member.rows];
      memory.name = rows.name;
      TypeId type = rows.type;
      if (member.in_buffers) {
        memory.parameters = {{"i", types_.Make(Scalar::kInt)}};
        type = types_.StructOf(types_.Innermost(type)).fields[0].type;
      }
      memory.is_float = types_[types_.Innermost(type)].scalar == Scalar::kFloat;
      memory.at = [rows = member.rows, in_buffers = member.in_buffers](HelperBody& body,
                                                                       ExprId number) {
        ExprId whole = body.b.Ref(rows);
        if (in_buffers) whole = body.b.Field(body.b.At(whole, body[0]), 0);
        return body.b.At(whole, number);
      };
    }
    return reader.emplace(program_, needs_, std::move(memory));
  }

  void ReplaceReads() {
    std::vector<ExprId> elements, wholes;
    ForEachLiveExpr(program_, [&](ExprId expr) {
      if (const auto* index = As<Index>(program_, expr)) {
        const auto* array = As<VarRef>(program_, index->base);
        if (array && IsPacked(array->var) && IsArray(array->var)) elements.push_back(expr);
      }
      const auto* ref = As<VarRef>(program_, expr);
      if (ref && IsPacked(ref->var)) wholes.push_back(expr);
    });
    std::set<ExprId> arrays;  // of elements
    for (const ExprId expr : elements) {
      const Index index = *As<Index>(program_, expr);
      arrays.insert(index.base);
      Builder b(program_, program_.exprs[expr].span);
      const auto* number = As<Literal>(program_, index.index);
      Become(expr, readers_[As<VarRef>(program_, index.base)->var.index],
             {number ? b.Int(static_cast<std::int32_t>(number->bits))
                     : b.ConvertTo(Scalar::kInt, index.index)});
    }
    for (const ExprId expr : wholes) {
      if (arrays.contains(expr)) continue;
      const VarId var = As<VarRef>(program_, expr)->var;
      Become(expr, IsArray(var) ? WholeOf(var) : readers_[var.index], {});
    }
  }

  void Become(ExprId expr, FunctionId function, std::vector<ExprId> arguments) {
    program_.exprs[expr].node =
        Call{function, program_.expr_lists.Add(std::span<const ExprId>(arguments))};
  }

  // The function that returns the whole of a member that is an array.
  FunctionId WholeOf(VarId array) {
    FunctionId& function = wholes_[array];
    if (function) return function;
    const Var var = program_.vars[array];
    function = Add(var.name + "_all", {}, var.type, [&](HelperBody& body) {
      ReturnArray(body, var.type, needs_,
                  [&](ExprId index) { return body.b.CallOf(readers_[array.index], {&index, 1}); });
    });
    return function;
  }

  Program& program_;
  TypeTable& types_;
  const Needs& needs_;
  std::vector<FunctionId> readers_;  // by VarId
  std::map<VarId, FunctionId> wholes_;
  std::map<VarId, std::optional<ValueReader>> memories_;  // by the variable of the rows
};

}  // namespace

std::vector<FunctionId> ReadMembers(Program& program, const Needs& needs,
                                    std::span<const PackedMember> members) {
  return MemberReading(program, needs).Run(members);
}

}  // namespace clipc::legalize
