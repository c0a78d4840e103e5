// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "base/invariant.h"
#include "ir/access.h"
#include "ir/walk.h"
#include "legalize/formula.h"
#include "legalize/legalize.h"

namespace clipc::legalize {

using namespace ir;

namespace {

constexpr std::uint32_t kWord = 4;  // bytes

ObjectKind KindOfWords(ObjectKind kind) {
  switch (kind) {
    case ObjectKind::kByteAddressBuffer: return ObjectKind::kStructuredBuffer;
    case ObjectKind::kRWByteAddressBuffer: return ObjectKind::kRWStructuredBuffer;
    case ObjectKind::kOrderedByteAddressBuffer: return ObjectKind::kOrderedStructuredBuffer;
    default: break;
  }
  CLIPC_CHECK(!"a byte address buffer");
  return kind;
}

class ByteBufferLowering {
 public:
  explicit ByteBufferLowering(Legalizer& legalizer)
      : legalizer_(legalizer), program_(legalizer.program), types_(program_.types) {}

  void Run() {
    for (Resource& resource : program_.resources) BecomeWords(resource);
    if (buffers_.empty()) return;
    std::vector<ExprId> paths, calls;
    ForEachLiveExpr(program_, [&](ExprId expr) {
      const VarId root = RootOf(program_, expr);
      if (root && buffers_.contains(root)) paths.push_back(expr);
      if (As<ObjectCall>(program_, expr)) calls.push_back(expr);
    });
    for (const ExprId path : paths) Retype(path);
    for (const ExprId expr : calls) {
      const ObjectCall call = *As<ObjectCall>(program_, expr);
      const VarId buffer = RootOf(program_, OperandOf(program_, call, OperandKind::kObject));
      if (buffer && buffers_.contains(buffer)) Lower(expr, call, buffer);
    }
  }

 private:
  void BecomeWords(Resource& resource) {
    Var& var = program_.vars[resource.var];
    const ObjectKind kind = types_[types_.Innermost(var.type)].object;
    if (!IsByteAddress(kind)) return;
    std::vector<std::uint32_t> counts;
    for (TypeId type = var.type; types_[type].kind == TypeKind::kArray; type = types_[type].element)
      counts.push_back(types_[type].count);
    TypeId words = types_.Object(KindOfWords(kind), types_.Make(Scalar::kUint));
    for (auto count = counts.rbegin(); count != counts.rend(); ++count)
      words = types_.Array(words, *count);
    resource.declared_type = program_.vars[resource.var].type;
    program_.vars[resource.var].type = words;
    buffers_.insert(resource.var);
  }

  // Gives a path to a buffer the type that it has now.
  void Retype(ExprId path) {
    if (const auto* index = As<Index>(program_, path)) {
      Retype(index->base);
      program_.exprs[path].type = types_[program_.exprs[index->base].type].element;
    } else if (const auto* ref = As<VarRef>(program_, path)) {
      program_.exprs[path].type = program_.vars[ref->var].type;
    }
  }

  void Lower(ExprId expr, const ObjectCall& call, VarId buffer) {
    Builder b = legalizer_.At(expr);
    if (call.op == ObjectOp::kByteLoad || call.op == ObjectOp::kStore)
      return BecomeAccess(expr, call, buffer);
    if (call.op == ObjectOp::kBufferSize) {
      const ExprId words = b.Add(program_.exprs[expr].type, call);
      const ExprId bytes = b.LiteralOf(legalizer_.TypeOf(expr).scalar, kWord);
      return legalizer_.Become(expr, b.BinaryOf(BinaryOp::kMul, words, bytes));
    }
    // An atomic operation has the address of a word.
    const std::uint32_t place = OperandsOf(call, OperandKind::kPlace).begin;
    const List<ExprId> list{place, 1};
    const ExprId address = std::as_const(program_).expr_lists[list][0];
    program_.expr_lists[list][0] = b.BinaryOf(BinaryOp::kDiv, address, b.Uint(kWord));
  }

  // Makes the load or the store a call of a function of the buffer.
  void BecomeAccess(ExprId expr, const ObjectCall& call, VarId buffer) {
    CLIPC_CHECK(!call.has_texel);
    const bool is_load = call.op == ObjectOp::kByteLoad;
    const ExprId object = OperandOf(program_, call, OperandKind::kObject);
    const ExprId value = is_load ? expr : OperandOf(program_, call, OperandKind::kValue);
    const TypeId type = program_.exprs[value].type;
    std::vector<ExprId> arguments;
    std::vector<Parameter> parameters;
    bool is_marked = false;  // the place in an array of buffers differs between invocations
    if (const auto* element = As<Index>(program_, object)) {
      ExprId which = element->index;
      const auto* mark = As<IntrinsicCall>(program_, which);
      is_marked = mark && mark->op == Intrinsic::kNonUniform;
      if (is_marked) which = std::as_const(program_).expr_lists[mark->arguments][0];
      // A marked index is a uint.
      const auto* number = As<Literal>(program_, which);
      Builder b = legalizer_.At(expr);
      if (!is_marked)
        which = number ? b.Int(static_cast<std::int32_t>(number->bits))
                       : b.ConvertTo(Scalar::kInt, which);
      arguments.push_back(which);
      parameters.push_back({"which", program_.exprs[which].type});
    }
    arguments.push_back(OperandOf(program_, call, OperandKind::kPlace));
    parameters.push_back({"address", types_.Make(Scalar::kUint)});
    if (!is_load) {
      arguments.push_back(value);
      parameters.push_back({"value", type});
    }
    FunctionId& function = functions_[{buffer, type, is_load, is_marked}];
    if (!function) {
      const std::string count = std::to_string(types_[type].Components());
      const std::string name = program_.vars[buffer].name + (is_marked ? "_any" : "") +
                               (is_load ? "_load" : "_store") + (count == "1" ? "" : count);
      const auto define = [&](HelperBody& body) {
        const std::size_t first = arguments.size() - (is_load ? 1 : 2);
        Formula f(body);
        const Access access{f, buffer, first > 0, is_marked, f[first]};
        is_load ? access.Load(type) : access.Store(f[first + 1], types_[type]);
      };
      function = legalizer_.AddHelper(name, parameters, is_load ? type : types_.Void(), define);
      program_.functions[function].is_accessor = true;
    }
    program_.exprs[expr].node =
        Call{function, program_.expr_lists.Add(std::span<const ExprId>(arguments))};
  }

  // The body of a function that loads or stores words.
  struct Access {
    Formula& f;
    VarId buffer;
    bool is_element, is_marked;
    Local address;

    ExprId Object() const {
      HelperBody& body = *address.body;
      const ExprId whole = body.b.Ref(buffer);
      if (!is_element) return whole;
      ExprId which = body.b.Ref(body.parameters[0]);
      if (is_marked)
        which = body.b.IntrinsicOf(Intrinsic::kNonUniform, body.b.TypeOf(which), {which});
      return body.b.At(whole, which);
    }
    void Load(TypeId type) const {
      HelperBody& body = *address.body;
      const Local i = f.Let("i", address / kWord);
      std::vector<ExprId> words;
      for (std::uint32_t k = 0; k < body.program.types[type].Components(); ++k) {
        const Term place = k == 0 ? Term(i) : i + k;
        words.push_back(body.b.ObjectCallOf(
            ObjectOp::kStructuredLoad, body.program.types.Make(Scalar::kUint),
            {{OperandKind::kObject, Object()}, {OperandKind::kPlace, place.expr}}));
      }
      body.Return(words.size() == 1 ? words[0] : body.b.ConstructOf(type, words));
    }
    void Store(const Local& value, const Type& type) const {
      HelperBody& body = *address.body;
      const std::uint32_t count = type.Components();
      for (std::uint32_t k = 0; k < count; ++k) {
        const Term first = address / kWord;
        const Term place = k == 0 ? first : first + k;
        const Term word = count == 1 ? Term(value) : value[std::string_view("xyzw").substr(k, 1)];
        body.Do(body.b.ObjectCallOf(ObjectOp::kStore, body.program.types.Void(),
                                    {{OperandKind::kObject, Object()},
                                     {OperandKind::kPlace, place.expr},
                                     {OperandKind::kValue, word.expr}}));
      }
    }
  };

  Legalizer& legalizer_;
  Program& program_;
  TypeTable& types_;
  std::set<VarId> buffers_;
  // By buffer, type of the value, whether it is loaded, and whether the index is marked.
  std::map<std::tuple<VarId, TypeId, bool, bool>, FunctionId> functions_;
};

}  // namespace

void LowerByteBuffers(Legalizer& legalizer) {
  ByteBufferLowering(legalizer).Run();
  legalizer.program.form = Form::kAddressed;
}

}  // namespace clipc::legalize
