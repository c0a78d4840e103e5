// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "legalize/read_members.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "ir/access.h"
#include "ir/builder.h"
#include "ir/packing.h"
#include "ir/walk.h"
#include "legalize/value_reader.h"

namespace clipc::legalize {

using namespace ir;

namespace {

// The reads that become calls.
struct Reads {
  std::vector<ExprId> elements;  // of packed arrays
  std::vector<ExprId> members;   // whole ones
  std::vector<ExprId> blocks;    // values of a ConstantBuffer<T>, or of a row of an array of these
  std::vector<ExprId> arrays;    // of such values
  bool empty() const {
    return elements.empty() && members.empty() && blocks.empty() && arrays.empty();
  }
};

// A finder of reads.
class ReadFinder {
 public:
  ReadFinder(const Program& program, const Needs& needs, const MemberReads& wanted)
      : program_(program), needs_(needs), kinds_(program.vars.size()) {
    for (const PackedMember& member : wanted.packed) kinds_[member.var.index] = Kind::kPacked;
    for (const VarId var : wanted.blocks) kinds_[var.index] = Kind::kBlock;
  }

  Reads Run() {
    Reads found;
    std::vector<ExprId> values;
    std::set<ExprId> wholes;  // of which an element or a field is read
    ForEachLiveExpr(program_, [&](ExprId expr) {
      const auto* index = As<Index>(program_, expr);
      const auto* field = As<FieldRef>(program_, expr);
      if (index || field) wholes.insert(index ? index->base : field->base);
      const auto* array = index ? As<VarRef>(program_, index->base) : nullptr;
      if (array && kinds_[array->var.index] == Kind::kPacked && IsArray(index->base))
        found.elements.push_back(expr);
      else if (const auto* ref = As<VarRef>(program_, expr); ref || index)
        values.push_back(expr);
    });
    for (const ExprId expr : values) {
      const VarId root = RootOf(program_, expr);
      const bool is_whole = root && !wholes.contains(expr);
      const bool is_var = root && As<VarRef>(program_, expr);
      if (is_var && kinds_[root.index] == Kind::kPacked && (is_whole || !IsArray(expr)))
        found.members.push_back(expr);
      else if (is_var && is_whole && IsArrayWithFields(expr, root))
        found.members.push_back(expr);
      else if (is_whole && kinds_[root.index] == Kind::kBlock && IsElement(expr))
        AddBlock(expr, found);
    }
    return found;
  }

 private:
  enum class Kind : std::uint8_t { kOther, kPacked, kBlock };

  void AddBlock(ExprId expr, Reads& found) const {
    const TypeId type = TypeIdOf(program_, expr);
    if (program_.types[program_.types.Innermost(type)].kind != TypeKind::kStruct) return;
    const bool is_all = program_.types[type].kind == TypeKind::kArray && As<VarRef>(program_, expr);
    (is_all ? found.arrays : found.blocks).push_back(expr);
  }

  bool IsArray(ExprId expr) const { return TypeOf(program_, expr).kind == TypeKind::kArray; }
  bool IsArrayWithFields(ExprId expr, VarId var) const {
    return needs_.array_fields && IsArray(expr) && program_.vars[var].storage == Storage::kUniform;
  }
  // Whether the path is of a variable and indices only.
  bool IsElement(ExprId path) const {
    while (const auto* index = As<Index>(program_, path)) path = index->base;
    return As<VarRef>(program_, path) != nullptr;
  }

  const Program& program_;
  const Needs& needs_;
  std::vector<Kind> kinds_;  // by VarId
};

class MemberReading {
 public:
  MemberReading(Program& program, const Needs& needs)
      : program_(program), types_(program.types), needs_(needs) {}

  std::vector<FunctionId> Run(const MemberReads& wanted) {
    const Reads reads = ReadFinder(program_, needs_, wanted).Run();
    readers_.resize(program_.vars.size());
    for (const PackedMember& member : wanted.packed) readers_[member.var.index] = ReaderOf(member);
    for (const ExprId expr : reads.elements) {
      const Index index = *As<Index>(program_, expr);
      const VarId var = As<VarRef>(program_, index.base)->var;
      Become(expr, readers_[var.index], {IntOf(index.index)});
    }
    for (const ExprId expr : reads.members) {
      const VarId var = As<VarRef>(program_, expr)->var;
      Become(expr, IsArray(var) ? WholeOf(var) : readers_[var.index], {});
    }
    for (const ExprId expr : reads.blocks) BecomeValue(expr);
    for (const ExprId expr : reads.arrays) Become(expr, AllOf(As<VarRef>(program_, expr)->var), {});
    return std::move(readers_);
  }

 private:
  bool IsArray(VarId var) const { return types_[program_.vars[var].type].kind == TypeKind::kArray; }

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

  ExprId IntOf(ExprId index) {
    Builder b(program_, program_.exprs[index].span);
    const auto* number = As<Literal>(program_, index);
    return number ? b.Int(static_cast<std::int32_t>(number->bits))
                  : b.ConvertTo(Scalar::kInt, index);
  }

  void Become(ExprId expr, FunctionId function, std::vector<ExprId> arguments) {
    program_.exprs[expr].node =
        Call{function, program_.expr_lists.Add(std::span<const ExprId>(arguments))};
  }

  // The value of a ConstantBuffer<T>, or of an array of these, that a path with known indices
  // leads to: of its fields.
  ExprId ValueAt(Builder& b, ExprId path, TypeId type) {
    const Type of = types_[type];
    if (of.kind != TypeKind::kArray)
      return FieldsOf(b, type, [&] { return Clone(program_, path); });
    std::vector<ExprId> elements;
    for (std::uint32_t i = 0; i < of.count; ++i) {
      const ExprId element = b.At(Clone(program_, path), b.Int(static_cast<std::int32_t>(i)));
      elements.push_back(ValueAt(b, element, of.element));
    }
    return b.ConstructOf(type, elements);
  }

  // Makes the value of a ConstantBuffer<T>, or of a row of an array of these, which a path leads
  // to, one of its fields. A function evaluates the indices once.
  void BecomeValue(ExprId expr) {
    const TypeId type = program_.exprs[expr].type;
    const VarId block = RootOf(program_, expr);
    std::vector<ExprId> indices;  // outermost first
    for (ExprId part = expr; const auto* index = As<Index>(program_, part); part = index->base)
      indices.insert(indices.begin(), index->index);
    if (!indices.empty() && HasLiteralIndices(program_, expr)) {
      Builder b(program_, program_.exprs[expr].span);
      const ExprId value = ValueAt(b, Clone(program_, expr), type);
      program_.exprs[expr].node = program_.exprs[value].node;
      return;
    }
    std::vector<Parameter> parameters;
    std::vector<bool> marks;  // the indices that differ between invocations, which are uints
    for (ExprId& index : indices) {
      const auto* mark = As<IntrinsicCall>(program_, index);
      marks.push_back(mark && mark->op == CommonIntrinsic::kNonUniform);
      index = marks.back() ? std::as_const(program_).expr_lists[mark->arguments][0] : IntOf(index);
      parameters.push_back(
          {std::string_view("ijklmnop").substr(parameters.size(), 1), program_.exprs[index].type});
    }
    FunctionId& function = values_[{block, marks}];
    if (!function) function = ValueOf(block, type, parameters, marks);
    Become(expr, function, indices);
  }

  // A function that returns the value of the block that the parameters lead to.
  FunctionId ValueOf(VarId block, TypeId type, std::span<const Parameter> parameters,
                     const std::vector<bool>& marks) {
    const bool is_marked = std::ranges::find(marks, true) != marks.end();
    const std::string name = program_.vars[block].name + (is_marked ? "_any_value" : "_value");
    return Add(name, parameters, type, [&](HelperBody& body) {
      ExprId path = body.b.Ref(block);
      for (std::size_t i = 0; i < marks.size(); ++i) {
        ExprId index = body[i];
        if (marks[i])
          index = body.b.IntrinsicOf(CommonIntrinsic::kNonUniform, body.b.TypeOf(index), {index});
        path = body.b.At(path, index);
      }
      body.Return(ValueAt(body.b, path, type));
    });
  }

  // A T of the fields of a block, to which whole() makes a path.
  ExprId FieldsOf(Builder& b, TypeId type, const std::function<ExprId()>& whole) {
    std::vector<ExprId> fields;
    for (std::uint32_t i = 0; i < types_.StructOf(type).fields.size(); ++i)
      fields.push_back(b.Field(whole(), i));
    return b.ConstructOf(type, fields);
  }

  // The function that returns all of an array of ConstantBuffer<T>.
  FunctionId AllOf(VarId blocks) {
    FunctionId& function = wholes_[blocks];
    if (function) return function;
    const Var var = program_.vars[blocks];
    return function = Add(var.name + "_all", {}, var.type, [&](HelperBody& body) {
             body.Return(ValueAt(body.b, body.b.Ref(blocks), var.type));
           });
  }

  // The function that returns the whole of a member that is an array.
  FunctionId WholeOf(VarId array) {
    FunctionId& function = wholes_[array];
    if (function) return function;
    const Var var = program_.vars[array];
    function = Add(var.name + "_all", {}, var.type, [&](HelperBody& body) {
      const FunctionId reader = readers_[array.index];
      ReturnArray(body, var.type, needs_, [&](ExprId index) {
        return reader ? body.b.CallOf(reader, {&index, 1}) : body.b.At(body.b.Ref(array), index);
      });
    });
    return function;
  }

  Program& program_;
  TypeTable& types_;
  const Needs& needs_;
  std::vector<FunctionId> readers_;  // by VarId
  std::map<VarId, FunctionId> wholes_;
  // Those that return a block as a T, also by which indices are marked.
  std::map<std::pair<VarId, std::vector<bool>>, FunctionId> values_;
  std::map<VarId, std::optional<ValueReader>> memories_;  // by the variable of the rows
};

}  // namespace

std::vector<FunctionId> ReadMembers(Program& program, const Needs& needs,
                                    const MemberReads& reads) {
  return MemberReading(program, needs).Run(reads);
}

bool HasReads(const Program& program, const Needs& needs, const MemberReads& reads) {
  const bool may_have = needs.array_fields || !reads.packed.empty() || !reads.blocks.empty();
  return may_have && !ReadFinder(program, needs, reads).Run().empty();
}

}  // namespace clipc::legalize
