// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Values.
#include <algorithm>
#include <utility>

#include "backend-spirv/writer.h"
#include "base/overloaded.h"
#include "ir/evaluate.h"
#include "ir/scalar.h"

namespace clipc::spirv {

using namespace ir;

Ref Writer::Value(ExprId id) {
  const Expr& expr = (*this)[id];
  Ref value = 0;
  if (lines_.has_any()) {
    // What is around the expression goes on in its own line.
    const SourcePlace around = lines_.wanted();
    lines_.Want(expr.span);
    value = ValueOf(id, expr);
    lines_.Restore(around);
  } else {
    value = ValueOf(id, expr);
  }
  if (options_.relaxed_precision) RelaxResult(value, expr.type);
  return value;
}

Ref Writer::ValueOf(ExprId id, const Expr& expr) {
  const Ref type = program_.types[expr.type].kind == TypeKind::kObject ? 0 : types_.Of(expr.type);
  return Visit(
      Overloaded{
          [&](const Literal& node) {
            return types_.Component(program_.types[expr.type].scalar, node.bits);
          },
          [&](const Zero&) { return types_.Zero(expr.type); },
          [&](const VarRef&) { return ReadPath(id); },
          [&](const FieldRef& node) {
            return HasPlace(id) ? ReadPath(id) : Part(type, Value(node.base), node.field);
          },
          [&](const Index& node) { return HasPlace(id) ? ReadPath(id) : Element(id, node); },
          [&](const Swizzle& node) {
            if (HasPlace(id)) return ReadPath(id);
            const Ref base = Value(node.base);
            return Components(base, ShapeAt(node.base),
                              std::span(node.components).first(node.count));
          },
          [&](const MatrixSwizzle& node) { return MatrixComponents(id, node); },
          [&](const Unary& node) { return Operate(node.op, node.operand); },
          [&](const Binary& node) { return Operate(node.op, node.left, node.right); },
          [&](const Assign& node) { return Assigned(node); },
          [&](const Conditional& node) {
            return Chosen(expr.type, node.condition, node.when_true, node.when_false);
          },
          [&](const Select& node) {
            const Ref condition = Value(node.condition), a = Value(node.when_true),
                      b = Value(node.when_false);
            return Emit(spv::Op::OpSelect, type, {condition, a, b});
          },
          [&](const Convert& node) {
            return Converted(Value(node.operand), ShapeAt(node.operand),
                             program_.types[expr.type].scalar);
          },
          [&](const clipc::ir::Splat& node) {
            return Splat(ShapeOf(program_.types[expr.type]), Value(node.operand));
          },
          [&](const clipc::ir::Construct& node) {
            return Construct(expr.type, (*this)[node.arguments]);
          },
          [&](const MatrixTruncate& node) {
            return Truncated(program_.types[expr.type], node.operand);
          },
          [&](const Call& node) { return Called(node); },
          [&](const IntrinsicCall& node) { return Intrinsic(expr.type, node); },
          [&](const clipc::ir::ObjectCall& node) { return ObjectCall(expr.type, node); },
          [&](const Comma& node) {
            Value(node.first);
            return Value(node.second);
          },
      },
      expr.node);
}

// Reads a path that begins at a variable.
Ref Writer::ReadPath(ExprId id) {
  const auto* ref = As<VarRef>(id);
  if (ref && values_[ref->var.index] != 0) return values_[ref->var.index];
  if (ref && builtin_inputs_.contains(ref->var.index) && !HasPlace(id))
    return ReadBuiltin(builtin_inputs_.at(ref->var.index));
  return Load(PlaceOf(id));
}

// An element of a value that has no place.
Ref Writer::Element(ExprId id, const Index& node) {
  const Ref base = Value(node.base);
  if (IsOnlyElement(node)) return base;
  const Ref type = types_.Of((*this)[id].type);
  if (const auto* literal = As<Literal>(node.index)) return Part(type, base, UintOf(literal->bits));
  const Ref index = Value(node.index);
  const Type& of = TypeAt(node.base);
  if (of.IsNumeric() && !ShapeOf(of).HasRows())
    return Emit(spv::Op::OpVectorExtractDynamic, type, {base, index});
  Place place = NewLocal((*this)[node.base].type);
  Store(place, base);
  place.indices.push_back(index);
  place.type = (*this)[id].type;
  return Load(place);
}

Ref Writer::Components(Ref value, const Shape& shape, std::span<const std::uint8_t> components) {
  const auto count = static_cast<std::uint32_t>(components.size());
  const Ref type = types_.Of(ShapeOf(shape.scalar, 1, count));
  if (shape.IsScalar()) {
    if (count == 1) return value;
    return Compose(type, std::vector<Ref>(count, value));
  }
  if (count == 1) return Part(type, value, components[0]);
  bool is_whole = count == shape.size;
  Words operands{value, value};
  for (std::uint32_t i = 0; i < count; ++i) {
    operands.push_back(components[i]);
    is_whole = is_whole && components[i] == i;
  }
  return is_whole ? value : Emit(spv::Op::OpVectorShuffle, type, operands);
}

Ref Writer::MatrixComponents(ExprId id, const MatrixSwizzle& node) {
  const Ref matrix = Value(node.base);
  const Type& type = TypeAt(node.base);
  const Shape shape = ShapeOf(type);
  const Ref component = types_.Of(shape.Component());
  std::vector<Ref> parts;
  for (std::size_t i = 0; i < node.count; ++i) {
    const std::uint32_t row = node.rows[i], column = node.columns[i];
    if (shape.HasRows())
      parts.push_back(Emit(spv::Op::OpCompositeExtract, component, {matrix, row, column}));
    else
      parts.push_back(shape.IsScalar() ? matrix
                                       : Part(component, matrix, type.columns == 1 ? row : column));
  }
  return parts.size() == 1 ? parts[0] : Compose(types_.Of((*this)[id].type), parts);
}

Ref Writer::Construct(TypeId id, std::span<const ExprId> arguments) {
  const Type& type = program_.types[id];
  std::vector<Ref> parts;
  for (const ExprId argument : arguments) parts.push_back(Value(argument));
  if (!type.IsNumeric()) return Compose(types_.Of(id), parts);
  const Shape shape = ShapeOf(type), first = ShapeAt(arguments[0]);
  if (arguments.size() == 1 && first == shape) return parts[0];
  if (!shape.HasRows() || !first.IsScalar()) return Compose(types_.Of(shape), parts);
  std::vector<Ref> rows;
  for (std::size_t i = 0; i < parts.size(); i += shape.size)
    rows.push_back(Compose(types_.Of(shape.Row()), std::span(parts).subspan(i, shape.size)));
  return Compose(types_.Of(shape), rows);
}

// The upper left part of a matrix. The result may be its first row, or its first column.
Ref Writer::Truncated(const Type& type, ExprId operand) {
  const Ref matrix = Value(operand);
  const Shape from = ShapeAt(operand), to = ShapeOf(type);
  if (from == to) return matrix;
  constexpr std::uint8_t kFirst[] = {0, 1, 2, 3};
  const auto leading = [&](Ref row, const Shape& of, std::uint32_t count) {
    return Components(row, of, std::span(kFirst).first(count));
  };
  if (!from.HasRows()) return leading(matrix, from, to.size);
  const auto row = [&](std::uint32_t i) { return Part(types_.Of(from.Row()), matrix, i); };
  std::vector<Ref> parts;
  if (to.HasRows()) {
    for (std::uint32_t i = 0; i < to.rows; ++i)
      parts.push_back(leading(row(i), from.Row(), to.size));
    return Compose(types_.Of(to), parts);
  }
  if (type.rows == 1) return leading(row(0), from.Row(), to.size);
  const Ref component = types_.Of(from.Component());
  for (std::uint32_t i = 0; i < to.size; ++i)
    parts.push_back(Emit(spv::Op::OpCompositeExtract, component, {matrix, i, 0}));
  return Compose(types_.Of(to), parts);
}

Ref Writer::Assigned(const Assign& node) {
  const VarId root = RootOf(program_, node.target);
  const bool is_precise = root && is_precise_var_[root.index];
  const bool was_precise = std::exchange(is_precise_, is_precise_ || is_precise);
  const Place place = PlaceOf(node.target);
  Ref value = 0;
  if (node.op) {
    const Ref old = Load(place), right = Value(node.value);
    value = Combine(*node.op, ShapeAt(node.target), old, right);
  } else {
    value = Value(node.value);
  }
  is_precise_ = was_precise;
  Store(place, value);
  return value;
}

// Out and inout arguments are copied, before the call and after it.
Ref Writer::Called(const Call& node) {
  const Function& function = program_.functions[node.function];
  const auto arguments = (*this)[node.arguments];
  Words operands{FunctionRef(node.function)};
  struct Copy {
    Place from, to;
  };
  std::vector<Copy> copies;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const Var& parameter = (*this)[function.parameters[i]];
    if (parameter.storage != Storage::kOut && parameter.storage != Storage::kInOut) {
      operands.push_back(Value(arguments[i]));
      continue;
    }
    Copy copy{NewLocal(parameter.type), PlaceOf(arguments[i])};
    if (parameter.storage == Storage::kInOut) Store(copy.from, Load(copy.to));
    operands.push_back(copy.from.base);
    copies.push_back(std::move(copy));
  }
  const Ref result = Emit(spv::Op::OpFunctionCall, types_.Of(function.return_type), operands);
  Relax(result, function.return_type);
  for (const Copy& copy : copies) Store(copy.to, Load(copy.from));
  judged_ = result;
  return result;
}

// Whether the expression costs nothing, and changes nothing: both sides of a choice may be it.
bool Writer::IsTrivial(ExprId id) const {
  if (As<Literal>(id) || As<Zero>(id)) return true;
  const auto* ref = As<VarRef>(id);
  if (ref) return TypeAt(id).IsScalarOrVector();
  const auto* splat = As<clipc::ir::Splat>(id);
  if (splat) return IsTrivial(splat->operand);
  const auto* swizzle = As<Swizzle>(id);
  if (swizzle) return IsTrivial(swizzle->base);
  const auto* binary = As<Binary>(id);
  return binary && IsComparison(binary->op) && IsTrivial(binary->left) && IsTrivial(binary->right);
}

Ref Writer::Chosen(TypeId type, ExprId condition, ExprId when_true, ExprId when_false) {
  const Type& of = program_.types[type];
  Ref chosen = Value(condition);
  if (of.IsScalarOrVector() && IsTrivial(when_true) && IsTrivial(when_false)) {
    const Ref a = Value(when_true), b = Value(when_false);
    const Shape shape = ShapeOf(of);
    if (shape.IsVector() && module_.minor_version() < 4)
      chosen = Splat(shape.With(Scalar::kBool), chosen);
    return Emit(spv::Op::OpSelect, types_.Of(type), {chosen, a, b});
  }
  const Ref then = module_.NewRef(), otherwise = module_.NewRef(), merge = module_.NewRef();
  Do(spv::Op::OpSelectionMerge, {merge, 0});
  Branch(chosen, then, otherwise);
  const bool is_void = of.kind == TypeKind::kVoid;
  Label(then);
  const Ref a = Value(when_true), after_a = block_;
  Branch(merge);
  Label(otherwise);
  const Ref b = Value(when_false), after_b = block_;
  Branch(merge);
  Label(merge);
  return is_void ? 0 : Emit(spv::Op::OpPhi, types_.Of(type), {a, after_a, b, after_b});
}

}  // namespace clipc::spirv
