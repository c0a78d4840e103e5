// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/expr.h"

#include <algorithm>
#include <span>
#include <utility>

#include "backend-glsl/literal.h"
#include "backend-glsl/writer/construct.h"
#include "backend-glsl/writer/interface.h"
#include "backend-glsl/writer/intrinsic_call.h"
#include "backend-glsl/writer/object_call.h"
#include "backend-glsl/writer/operand.h"
#include "backend-glsl/writer/stmt.h"
#include "backend-glsl/writer/types.h"
#include "backend-glsl/writer/uniform.h"
#include "base/overloaded.h"
#include "ir/scalar.h"

namespace clipc::glsl {

using namespace ir;

namespace {

Binding Write(Code& code, const Text& text) {
  code.Put(text.text);
  return text.binding;
}

constexpr std::uint8_t kFourComponents[] = {0, 1, 2, 3};

// Writes components of a pixel's position, which are numbered from 0. GLSL has 1 / w where Direct3D
// has w, and some targets count y from the lower edge.
Binding WritePixelPosition(Code& code, const std::string& name,
                           std::span<const std::uint8_t> components) {
  const std::string& height = code.names.framebuffer_height;
  const std::string y = height.empty() ? name + ".y" : Concat(height, " - ", name, ".y");
  const std::string w = Concat("1.0 / ", name, ".w");
  const auto has = [&](std::uint8_t component) {
    return std::ranges::find(components, component) != components.end();
  };
  const bool changes_y = !height.empty() && has(1);
  if (components.size() == 1 && (changes_y || has(3))) {
    code.Put(changes_y ? y : w);
    return changes_y ? Binding::kSum : Binding::kProduct;
  }
  const bool is_first =
      std::ranges::equal(components, std::span(kFourComponents).first(components.size()));
  if (changes_y && is_first && components.size() < 4) {
    code.Put(components.size() == 2 ? "vec2(" : "vec3(", name, ".x, ", y,
             components.size() == 2 ? "" : Concat(", ", name, ".z"), ")");
    return Binding::kPostfix;
  }
  if (changes_y)
    code.Put("vec4(", name, ".x, ", y, ", ", name, ".z, ", w, ")");
  else
    code.Put(has(3) ? Concat("vec4(", name, ".xyz, ", w, ")") : name);
  if (is_first && components.size() == 4) return Binding::kPostfix;
  code.Put(".");
  for (const std::uint8_t each : components) code.Put(std::string_view("xyzw").substr(each, 1));
  return Binding::kPostfix;
}

Binding WriteVar(Code& code, VarId id) {
  if (code[id].storage == Storage::kUniform) return WriteUniform(code, id);
  if (IsPixelPosition(code, id)) {
    return WritePixelPosition(code, code.NameOf(id), kFourComponents);
  }
  code.Put(code.NameOf(id));
  return Binding::kPostfix;
}

Binding WriteField(Code& code, const FieldRef& node) {
  WriteAt(code, node.base, Binding::kPostfix);
  code.Put(".", code.FieldsOf(code.TypeOf(node.base).structure)[node.field]);
  return Binding::kPostfix;
}

Binding WriteElement(Code& code, const Expr& expr, const Index& node) {
  const Type& type = code.TypeOf(node.base);
  if (type.kind == TypeKind::kArray) {
    const auto* ref = code.As<VarRef>(node.base);
    if (ref && code[ref->var].storage == Storage::kUniform) {
      return WriteUniformElement(code, ref->var, node.index);
    }
  }
  if (legalize::IsOnlyElement(code.program, node)) return WriteExpr(code, node.base);
  WriteAt(code, node.base, Binding::kPostfix);
  // Mesa 22.3 reads the wrong component for t[1] after `ivec2 t = a.yw`, but not for t.y. An
  // element of a matrix is m[1][2].
  const auto* literal = code.As<Literal>(node.index);
  const auto* row = code.As<Index>(node.base);
  const bool is_element =
      row && code.TypeOf(row->base).IsNumeric() && code.ShapeAt(row->base).HasRows();
  if (literal && !is_element && type.IsNumeric() && ShapeOf(type, code.needs).IsVector()) {
    const char component[] = {'.', "xyzw"[UintOf(literal->bits) % 4], '\0'};
    code.Put(component);
    return Binding::kPostfix;
  }
  const bool has_fields = HasFields(code, type);
  code.Put(has_fields ? ".e" : "[");
  WriteIndex(code, node.index);
  if (!has_fields) code.Put("]");
  if (!has_fields && type.kind == TypeKind::kArray && IsWrapped(code, expr.type)) code.Put(".e");
  return Binding::kPostfix;
}

// Writes (v * mat4x3(m)).xyz as v * mat3(m), without the columns or rows that make what the swizzle
// drops. Returns false, and writes nothing, for other expressions.
bool WriteNarrowProduct(Code& code, const Swizzle& node) {
  const auto* call = code.As<IntrinsicCall>(node.base);
  if (!call || call->op != CommonIntrinsic::kMul || node.count < 2) return false;
  for (std::uint8_t i = 0; i < node.count; ++i) {
    if (node.components[i] != i) return false;
  }
  const auto sides = code[call->arguments];
  const bool is_left = code.As<MatrixTruncate>(sides[0]) != nullptr;
  const ExprId matrix = sides[is_left ? 0 : 1], vector = sides[is_left ? 1 : 0];
  const auto* truncate = code.As<MatrixTruncate>(matrix);
  if (!truncate || !code.ShapeAt(vector).IsVector()) return false;
  if (code.ShapeAt(matrix).kind != Shape::kMatrix) return false;
  Type narrow = code.TypeOf(matrix);
  (is_left ? narrow.rows : narrow.columns) = node.count;
  if (is_left) {
    WriteAt(code, vector, Binding::kProduct);
    code.Put(" * ");
    WriteTruncated(code, narrow, truncate->operand);
  } else {
    WriteTruncated(code, narrow, truncate->operand);
    code.Put(" * ");
    WriteAt(code, vector, Tighter(Binding::kProduct));
  }
  return true;
}

Binding WriteSwizzle(Code& code, const Swizzle& node) {
  const auto* ref = code.As<VarRef>(node.base);
  if (ref && IsPixelPosition(code, ref->var))
    return WritePixelPosition(code, code.NameOf(ref->var),
                              std::span(node.components).first(node.count));
  if (WriteNarrowProduct(code, node)) return Binding::kProduct;
  const Shape shape = code.ShapeAt(node.base);
  if (shape.IsScalar()) {
    if (node.count == 1) return WriteExpr(code, node.base);
    code.Put(TypeName(code, ShapeOf(shape.scalar, 1, node.count)), "(");
    WriteArguments(code, {&node.base, 1});
    code.Put(")");
    return Binding::kPostfix;
  }
  WriteAt(code, node.base, Binding::kPostfix);
  char components[] = ".xyzw";
  for (int i = 0; i < node.count; ++i) components[i + 1] = "xyzw"[node.components[i]];
  code.Put(std::string_view(components, std::size_t{node.count} + 1));
  return Binding::kPostfix;
}

Text MatrixSwizzleText(Code& code, const Expr& expr, const MatrixSwizzle& node) {
  const Shape shape = code.ShapeAt(node.base);
  std::string base = ExprText(code, node.base).At(Binding::kPostfix);
  if (shape.IsScalar() && node.count == 1) return {std::move(base)};
  const bool has_rows = shape.HasRows();
  const bool is_one_row = std::all_of(node.rows.begin(), node.rows.begin() + node.count,
                                      [&](std::uint8_t row) { return row == node.rows[0]; });
  if (!shape.IsScalar() && (!has_rows || (is_one_row && node.count > 1))) {
    if (has_rows) base = RowOf(code, shape, base, node.rows[0]);
    base += '.';
    const auto& components = code.TypeOf(node.base).columns == 1 ? node.rows : node.columns;
    for (int i = 0; i < node.count; ++i) base += "xyzw"[components[i]];
    return {std::move(base)};
  }
  const auto element = [&](int i) {
    return has_rows ? Concat(RowOf(code, shape, base, node.rows[i]), "[",
                             std::to_string(node.columns[i]), "]")
                    : base;
  };
  if (node.count == 1) return {element(0)};
  return Called(TypeName(code, ShapeOf(code[expr.type], code.needs)),
                {ListOf(int{node.count}, element)});
}

Binding WriteUnary(Code& code, const Unary& node) {
  switch (node.op) {
    case UnaryOp::kPreIncrement:
      code.Put("++");
      WriteAt(code, node.operand, Binding::kUnary);
      return Binding::kUnary;
    case UnaryOp::kPreDecrement:
      code.Put("--");
      WriteAt(code, node.operand, Binding::kUnary);
      return Binding::kMinus;
    case UnaryOp::kPostIncrement:
    case UnaryOp::kPostDecrement:
      WriteAt(code, node.operand, Binding::kPostfix);
      code.Put(node.op == UnaryOp::kPostIncrement ? "++" : "--");
      return Binding::kPostfix;
    default: return WriteOperator(code, node.op, node.operand);
  }
}

// The value of a compound assignment may be a scalar beside a vector.
Binding WriteAssign(Code& code, const Assign& node) {
  WriteAt(code, node.target, Binding::kUnary);
  code.Put(" ", node.op ? SpellingOf(*node.op) : "", "= ");
  if (node.op)
    WriteOperandAt(code, node.value, Binding::kAssignment);
  else
    WriteAt(code, node.value, Binding::kAssignment);
  return Binding::kAssignment;
}

Binding WriteConditional(Code& code, const Conditional& node) {
  WriteAt(code, node.condition, Tighter(Binding::kConditional));
  code.Put(" ? ");
  WriteAt(code, node.when_true, Binding::kAssignment);
  code.Put(" : ");
  WriteAt(code, node.when_false, Binding::kConditional);
  return Binding::kConditional;
}

Binding WriteConvert(Code& code, const Expr& expr, const Convert& node) {
  const Scalar kind = code[expr.type].scalar;
  if (const auto* literal = code.As<Literal>(node.operand)) {
    const Scalar from = code.TypeOf(node.operand).scalar;
    return Write(code, LiteralText(ConvertBits(literal->bits, from, kind), kind, code.target));
  }
  // sign() gives an int in HLSL and a float in GLSL, and mostly its value is wanted as a float.
  const auto* call = code.As<IntrinsicCall>(node.operand);
  if (call && call->op == CommonIntrinsic::kSign) {
    const auto arguments = code[call->arguments];
    const Shape shape = code.ShapeAt(arguments[0]);
    if (shape.scalar == BaseOf(kind) && shape.IsFloating() && !shape.HasRows())
      return WriteCall(code, "sign", arguments);
  }
  // GLSL's functions that count bits give an int.
  if (call && BaseOf(kind) == Scalar::kInt) {
    if (const std::string_view function = BitNumberFunction(call->op); !function.empty())
      return WriteCall(code, function, code[call->arguments]);
  }
  return WriteConverted(code, kind, node.operand);
}

// The definition of a helper function comes after those that its arguments need.
Binding WriteUserCall(Code& code, const Call& node) {
  const std::size_t begin = code.out->size();
  const bool is_helper = code[node.function].is_helper;
  if (!is_helper) code.Put(code.names.functions[node.function.index]);
  code.Put("(");
  WriteArguments(code, code[node.arguments]);
  code.Put(")");
  if (is_helper) code.PutBefore(begin, HelperFunction(code, node.function));
  return Binding::kPostfix;
}

}  // namespace

Binding WriteExpr(Code& code, ExprId id) {
  const Expr& expr = code[id];
  code.RequireType(code[expr.type]);
  return Visit(
      Overloaded{
          [&](const Literal& node) {
            return Write(code, node.is_mask
                                   ? MaskText(UintOf(node.bits))
                                   : LiteralText(node.bits, code[expr.type].scalar, code.target));
          },
          [&](const Zero&) { return Write(code, {ZeroText(code, expr.type)}); },
          [&](const VarRef& node) { return WriteVar(code, node.var); },
          [&](const FieldRef& node) { return WriteField(code, node); },
          [&](const Index& node) { return WriteElement(code, expr, node); },
          [&](const Swizzle& node) { return WriteSwizzle(code, node); },
          [&](const MatrixSwizzle& node) {
            return Write(code, MatrixSwizzleText(code, expr, node));
          },
          [&](const Unary& node) { return WriteUnary(code, node); },
          [&](const Binary& node) { return WriteOperator(code, node.op, node.left, node.right); },
          [&](const Assign& node) { return WriteAssign(code, node); },
          [&](const Conditional& node) { return WriteConditional(code, node); },
          [&](const Select& node) {
            const ExprId mixed[] = {node.when_false, node.when_true, node.condition};
            return WriteCall(code, "mix", mixed);
          },
          [&](const Convert& node) { return WriteConvert(code, expr, node); },
          [&](const Splat& node) { return WriteSplat(code, code.ShapeAt(id), node.operand); },
          [&](const Construct& node) {
            return WriteConstruct(code, expr.type, code[node.arguments]);
          },
          [&](const MatrixTruncate& node) {
            return WriteTruncated(code, code[expr.type], node.operand);
          },
          [&](const Call& node) { return WriteUserCall(code, node); },
          [&](const IntrinsicCall& node) { return WriteIntrinsic(code, expr.type, node); },
          [&](const ObjectCall& node) { return Write(code, ObjectText(code, expr.type, node)); },
          [&](const Comma& node) {
            WriteExpr(code, node.first);
            code.Put(", ");
            WriteAt(code, node.second, Binding::kAssignment);
            return Binding::kComma;
          },
      },
      expr.node);
}

void WriteAt(Code& code, ExprId id, Binding least) {
  const std::size_t begin = code.out->size();
  if (WriteExpr(code, id) < least) code.EncloseFrom(begin);
}

void WriteArguments(Code& code, std::span<const ExprId> arguments) {
  std::string_view separator;
  for (const ExprId argument : arguments) {
    code.Put(std::exchange(separator, ", "));
    WriteAt(code, argument, Binding::kAssignment);
  }
}

Text ExprText(Code& code, ExprId id) {
  Text text;
  text.text = code.Apart([&] { text.binding = WriteExpr(code, id); });
  return text;
}

std::string Argument(Code& code, ExprId id) {
  return code.Apart([&] { WriteAt(code, id, Binding::kAssignment); });
}

void WriteIndex(Code& code, ExprId index) {
  const auto* literal = code.As<Literal>(index);
  if (literal)
    code.Put(std::to_string(UintOf(literal->bits)));
  else
    WriteExpr(code, index);
}

std::string IndexValue(Code& code, ExprId index) {
  return code.Apart([&] { WriteIndex(code, index); });
}

std::string IndexPath(Code& code, ExprId element) {
  const auto* index = code.As<Index>(element);
  if (!index) return "";
  std::string path = IndexPath(code, index->base);
  Append(path, "[", IndexValue(code, index->index), "]");
  return path;
}

}  // namespace clipc::glsl
