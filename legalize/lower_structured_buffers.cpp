// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "ir/access.h"
#include "ir/scalar.h"
#include "ir/std_layout.h"
#include "legalize/legalize.h"
#include "legalize/value_reader.h"
#include "legalize/word_buffers.h"

namespace clipc::legalize {

using namespace ir;

namespace {

// The number of the word that the steps of a store lead to in an element: what literals say of it,
// and what the other steps add, if there are any.
struct WordAlong {
  std::uint32_t known = 0;
  ExprId rest = {};
};

// The word that holds a component.
ExprId WordOf(Builder& b, ExprId component, TypeId word, Scalar kind) {
  if (BaseOf(kind) != Scalar::kFloat) return b.ConvertTo(Scalar::kUint, component);
  return b.IntrinsicOf(CommonIntrinsic::kAsUint, word, {b.ConvertTo(Scalar::kFloat, component)});
}

// The stores of the components of a value, in their order, into words that follow each other.
class PartStores {
 public:
  PartStores(HelperBody& body, const AccessorCall& access, const WordPlace& first)
      : body_(body), access_(access), first_(first) {}

  // Stores the part that part() makes anew each time.
  void Store(TypeId id, const std::function<ExprId()>& part) {
    const Type type = body_.program.types[id];
    if (type.kind == TypeKind::kStruct) {
      const std::vector<Field> fields = body_.program.types.StructOf(id).fields;
      for (std::uint32_t i = 0; i < fields.size(); ++i)
        Store(fields[i].type, [&] { return body_.b.Field(part(), i); });
    } else if (type.kind == TypeKind::kArray) {
      for (std::uint32_t i = 0; i < type.count; ++i)
        Store(type.element, [&] { return body_.b.At(part(), i); });
    } else if (type.kind == TypeKind::kVector) {
      for (int i = 0; i < type.columns; ++i) Word(type.scalar, body_.b.Swizzled(part(), {i}));
    } else {
      Word(type.scalar, part());
    }
  }

 private:
  void Word(Scalar kind, ExprId component) {
    const ExprId number = NumberAt(body_, first_, first_.offset + next_++);
    const TypeId word = body_.program.types.Make(Scalar::kUint);
    access_.Store(body_, number, WordOf(body_.b, component, word, kind));
  }

  HelperBody& body_;
  const AccessorCall& access_;
  const WordPlace& first_;  // its offset is in words
  std::uint32_t next_ = 0;
};

class StructuredBufferLowering {
 public:
  explicit StructuredBufferLowering(Legalizer& legalizer)
      : legalizer_(legalizer),
        program_(legalizer.program),
        types_(program_.types),
        exchanged_(BuffersOfExchangedFloats(program_)) {}

  bool Chooses(const Resource& resource) const {
    const Var& buffer = program_.vars[resource.var];
    const Type& type = types_[types_.Innermost(buffer.type)];
    return IsStructured(type.object) &&
           (!Std430(types_, type.element, buffer.row_major) || exchanged_.contains(resource.var));
  }

  void Lower(ExprId expr, const ObjectCall& call, VarId buffer) {
    switch (call.op) {
      case ObjectOp::kStructuredLoad: return Load(expr, call, buffer);
      case ObjectOp::kStore: return Store(expr, call, buffer);
      default: return IsAtomic(call.op) ? Change(expr, call, buffer) : Size(expr, call, buffer);
    }
  }

 private:
  TypeId ElementOf(VarId buffer) const {
    for (const Resource& resource : program_.resources) {
      if (resource.var == buffer) return types_[types_.Innermost(resource.declared_type)].element;
    }
    return {};
  }
  std::uint32_t WordsOf(VarId buffer) const {
    return Structured(types_, ElementOf(buffer)).size / kWordBytes;
  }
  std::uint32_t ComponentsOf(TypeId type) const {
    return static_cast<std::uint32_t>(KindsOf(types_, type).size());
  }

  bool IsAlone(ExprId expr) {
    if (!alone_) alone_ = ExpressionsAlone(program_);
    return alone_->contains(expr);
  }

  // Makes an atomic operation on a part of an element one on a word, in place.
  void Change(ExprId expr, const ObjectCall& call, VarId buffer) {
    Builder b = legalizer_.At(expr);
    const WordAlong part = WordTo(b, ElementOf(buffer), OperandsOf(call, OperandKind::kStep));
    const auto scaled = [&](ExprId place) {
      const std::uint32_t words = WordsOf(buffer);
      const ExprId index = b.ConvertTo(Scalar::kUint, place);
      return words == 1 ? index : b.BinaryOf(BinaryOp::kMul, index, b.Uint(words));
    };
    ExprId place = scaled(OperandOf(program_, call, OperandKind::kPlace));
    const auto add = [&](ExprId more) { place = b.BinaryOf(BinaryOp::kAdd, place, more); };
    if (part.rest) add(b.ConvertTo(Scalar::kUint, part.rest));
    if (part.known > 0) add(b.Uint(part.known));
    const TypeId word = types_.Make(Scalar::kUint);
    std::vector<NamedOperand> operands = {
        {OperandKind::kObject, OperandOf(program_, call, OperandKind::kObject)},
        {OperandKind::kPlace, place}};
    for (const OperandKind kind : {OperandKind::kComparand, OperandKind::kValue}) {
      const ExprId value = OperandOf(program_, call, kind);
      if (value)
        operands.push_back({kind, WordOf(b, value, word, legalizer_.TypeOf(value).scalar)});
    }
    const TypeId type = program_.exprs[expr].type;
    const bool is_signed = types_[type].scalar == Scalar::kInt;
    const ExprId old = b.ObjectCallOf(call.op, word, operands);
    if (IsAlone(expr)) {
      program_.exprs[expr].type = word;
      return legalizer_.Become(expr, old);
    }
    legalizer_.Become(expr, BaseOf(types_[type].scalar) == Scalar::kFloat
                                ? b.IntrinsicOf(CommonIntrinsic::kAsFloat, type, {old})
                            : is_signed ? b.ConvertTo(Scalar::kInt, old)
                                        : old);
  }

  void Size(ExprId expr, const ObjectCall& call, VarId buffer) {
    const std::uint32_t words = WordsOf(buffer);
    if (words <= 1) return;
    Builder b = legalizer_.At(expr);
    const ExprId all = b.Add(program_.exprs[expr].type, call);
    const ExprId each = b.LiteralOf(legalizer_.TypeOf(expr).scalar, words);
    legalizer_.Become(expr, b.BinaryOf(BinaryOp::kDiv, all, each));
  }

  void Load(ExprId expr, const ObjectCall& call, VarId buffer) {
    AccessorCall access(legalizer_, expr, call);
    const std::vector<Parameter> outer = access.parameters();
    access.PassInt("i", OperandOf(program_, call, OperandKind::kPlace));
    const TypeId element = ElementOf(buffer);
    access.Become(loads_[{buffer, access.is_marked()}], access.Name() + "_at", element,
                  [&](HelperBody& body) {
                    WordMemory memory{.name = access.Name(), .parameters = outer};
                    memory.at = [&](HelperBody& in, ExprId number) {
                      return access.Load(in, number);
                    };
                    ValueReader reader(program_, legalizer_.needs, std::move(memory));
                    const WordPlace place{{{WordsOf(buffer), body.parameters.back()}}, 0};
                    body.Return(reader.Read(body, element, program_.vars[buffer].row_major, place));
                  });
  }

  WordAlong WordTo(Builder b, TypeId id, List<ExprId> steps) {
    WordAlong word;
    for (std::uint32_t i = 0; i < steps.size; ++i) {
      const ExprId step = std::as_const(program_).expr_lists[steps][i];
      const Type type = types_[id];
      const auto* number = As<Literal>(program_, step);
      if (type.kind == TypeKind::kStruct) {
        const std::vector<Field>& fields = types_.StructOf(id).fields;
        const std::uint32_t field = UintOf(number->bits);
        for (std::uint32_t k = 0; k < field; ++k) word.known += ComponentsOf(fields[k].type);
        id = fields[field].type;
        continue;
      }
      const std::uint32_t each = type.kind == TypeKind::kArray ? ComponentsOf(type.element) : 1;
      if (number)
        word.known += each * UintOf(number->bits);
      else
        AddStep(b, each, step, word.rest);
      id = type.element;
    }
    return word;
  }
  static void AddStep(Builder b, std::uint32_t each, ExprId step, ExprId& sum) {
    const ExprId index = b.ConvertTo(Scalar::kInt, step);
    const ExprId words =
        each == 1 ? index
                  : b.BinaryOf(BinaryOp::kMul, b.Int(static_cast<std::int32_t>(each)), index);
    sum = sum ? b.BinaryOf(BinaryOp::kAdd, sum, words) : words;
  }

  // Stores an element, or a part of one, word by word.
  void Store(ExprId expr, const ObjectCall& call, VarId buffer) {
    const ExprId value = OperandOf(program_, call, OperandKind::kValue);
    const TypeId stored = program_.exprs[value].type;
    const List<ExprId> steps = OperandsOf(call, OperandKind::kStep);
    Builder b = legalizer_.At(expr);
    const WordAlong part = WordTo(b, ElementOf(buffer), steps);
    const bool moves = static_cast<bool>(part.rest);
    AccessorCall access(legalizer_, expr, call);
    access.PassInt("i", OperandOf(program_, call, OperandKind::kPlace));
    if (moves) {
      const ExprId known = b.Int(static_cast<std::int32_t>(part.known));
      access.Pass("word",
                  part.known > 0 ? b.BinaryOf(BinaryOp::kAdd, part.rest, known) : part.rest);
    }
    access.Pass("value", value);
    const std::string which = moves ? "_part" : steps.empty() ? "" : std::to_string(part.known);
    const std::string name = access.Name() + "_store" + which + "_at";
    access.Become(stores_[{buffer, which, stored, access.is_marked()}], name, types_.Void(),
                  [&](HelperBody& body) {
                    const std::size_t last = body.parameters.size() - 1;
                    WordPlace first{{{WordsOf(buffer), body.parameters[last - (moves ? 2 : 1)]}},
                                    moves ? 0 : part.known};
                    if (moves) first.steps.push_back({1, body.parameters[last - 1]});
                    PartStores(body, access, first).Store(stored, [&] { return body[last]; });
                  });
  }

  Legalizer& legalizer_;
  Program& program_;
  TypeTable& types_;
  const std::set<VarId> exchanged_;
  std::optional<std::set<ExprId>> alone_;  // none: nothing has asked for it
  // By buffer, and whether the index in an array of them is marked; stores also by the part's name
  // and the type of the value.
  std::map<std::tuple<VarId, bool>, FunctionId> loads_;
  std::map<std::tuple<VarId, std::string, TypeId, bool>, FunctionId> stores_;
};

}  // namespace

void LowerStructuredBuffers(Legalizer& legalizer) {
  StructuredBufferLowering lowering(legalizer);
  MakeWordBuffers(
      legalizer, [&](const Resource& buffer) { return lowering.Chooses(buffer); },
      [&](ExprId expr, const ObjectCall& call, VarId buffer) {
        lowering.Lower(expr, call, buffer);
      });
}

}  // namespace clipc::legalize
