// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>

#include <fmt/format.h>

#include "ir/access.h"
#include "ir/print.h"
#include "ir/verifier.h"

namespace clipc::ir {
namespace {

bool IsScalar(const Type& type) { return type.kind == TypeKind::kScalar; }
bool IsBoolScalar(const Type& type) { return IsScalar(type) && type.scalar == Scalar::kBool; }
bool IsIndexType(const Type& type) { return IsScalar(type) && IsInteger(type.scalar); }

// Whether the operator takes operands of that component kind.
bool Takes(BinaryOp op, Scalar kind) {
  using enum OperatorKind;
  switch (TraitsOf(op).kind) {
    case kArithmetic: return kind != Scalar::kBool;
    case kShift: return IsInteger(kind);
    case kComparison: return true;
    case kBitwise: return !IsFloat(kind);
    default: return kind == Scalar::kBool;  // && and ||
  }
}

bool MayBeWritten(Storage storage) {
  using enum Storage;
  switch (storage) {
    case kLocal:
    case kIn:
    case kOut:
    case kInOut:
    case kStatic:
    case kShared:
    case kOutput: return true;
    default: return false;
  }
}

}  // namespace

ExprVerifier::ExprVerifier(const Program& program)
    : scope(program.vars.size(), Scope::kNotYet),
      program_(program),
      has_parent_(program.exprs.size(), false) {}

void ExprVerifier::Fail(std::string what) {
  if (!problem_) problem_ = where.empty() ? std::move(what) : where + ": " + what;
}

bool ExprVerifier::Require(bool holds, std::string_view rule) {
  if (!holds && !failed()) {
    Fail(fmt::format("`{}` of type {}: {}", PrintExpr(program_, expr_),
                     program_.types.Name(IdOf(expr_)), rule));
  }
  return holds;
}

bool ExprVerifier::HasShapeOf(ExprId a, ExprId b) const { return SameShape(TypeOf(a), TypeOf(b)); }

std::vector<TypeId> ExprVerifier::TypesOf(List<ExprId> list) const {
  std::vector<TypeId> types;
  for (ExprId expr : program_.expr_lists[list]) types.push_back(IdOf(expr));
  return types;
}

void ExprVerifier::CheckTree(ExprId expr) {
  if (failed()) return;
  if (expr.index >= program_.exprs.size())
    return Fail("an operand is missing or not of this program");
  if (has_parent_[expr.index]) {
    // The expression is not printed, because the tree may contain itself.
    return Fail(fmt::format("expression {} has two parents", expr.index));
  }
  has_parent_[expr.index] = true;
  const TypeId type = program_.exprs[expr].type;
  if (!type || program_.types[type].kind == TypeKind::kError) {
    return Fail(fmt::format("expression {} has no type", expr.index));
  }
  ForEachOperand(program_, expr, [&](ExprId operand) { CheckTree(operand); });
  if (failed()) return;
  expr_ = expr;
  std::visit([&](const auto& node) { Check(node); }, program_.exprs[expr].node);
  if (!legalized || failed()) return;
  const std::string_view broken = RuleBrokenBy(program_, expr);
  Require(broken.empty(), broken);
}

void ExprVerifier::Check(const Literal& node) {
  Require(IsScalar(Checked()), "a literal is a scalar");
  if (Checked().scalar == Scalar::kBool) Require(node.bits <= 1, "a bool literal is 0 or 1");
}

void ExprVerifier::Check(const Zero&) {
  Require(Checked().kind != TypeKind::kVoid && Checked().kind != TypeKind::kObject,
          "there is no such zero");
}

void ExprVerifier::Check(const VarRef& node) {
  if (node.var.index >= program_.vars.size()) return Fail("the variable is not of this program");
  const Var& var = program_.vars[node.var];
  if (!Require(var.type == IdOf(expr_), "a reference has the variable's type")) return;
  output_arrays += IsOutputArray(program_, node.var) ? 1 : 0;
  if (scope[node.var.index] == Scope::kVisible) return;
  Require(false, scope[node.var.index] == Scope::kGone ? "the variable is out of scope here"
                                                       : "the variable is not declared here");
}

void ExprVerifier::Check(const FieldRef& node) {
  const Type& base = TypeOf(node.base);
  if (!Require(base.kind == TypeKind::kStruct, "a field is of a struct")) return;
  const auto& fields = program_.types[base.structure].fields;
  if (!Require(node.field < fields.size(), "the struct has no such field")) return;
  Require(fields[node.field].type == IdOf(expr_), "a field reference has the field's type");
}

void ExprVerifier::Check(const Index& node) {
  const Type& base = TypeOf(node.base);
  const Type& type = Checked();
  Require(IsIndexType(TypeOf(node.index)), "an index is an int or uint scalar");
  switch (base.kind) {
    case TypeKind::kArray:
      Require(base.element == IdOf(expr_), "an element has the array's element type");
      break;
    case TypeKind::kVector:
      Require(IsScalar(type) && type.scalar == base.scalar,
              "a component is a scalar of the vector's kind");
      break;
    case TypeKind::kMatrix:
      Require(type.kind == TypeKind::kVector && type.scalar == base.scalar &&
                  type.columns == base.columns,
              "a row is a vector of the matrix's columns");
      break;
    default: Require(false, "only arrays, vectors and matrices are indexed");
  }
}

void ExprVerifier::RequireComponents(const Type& base, std::uint8_t count) {
  const Type& type = Checked();
  const bool has_shape =
      count == 1 ? IsScalar(type) : type.kind == TypeKind::kVector && type.columns == count;
  Require(type.scalar == base.scalar && has_shape,
          "one component is a scalar, more are a vector, of the same kind");
}

void ExprVerifier::Check(const Swizzle& node) {
  const Type& base = TypeOf(node.base);
  if (!Require(base.kind == TypeKind::kVector, "a swizzle is of a vector")) return;
  if (!Require(node.count >= 1 && node.count <= 4, "a swizzle has one to four components")) return;
  for (int i = 0; i < node.count; ++i) {
    Require(node.components[i] < base.columns, "the vector has no such component");
  }
  RequireComponents(base, node.count);
}

void ExprVerifier::Check(const MatrixSwizzle& node) {
  const Type& base = TypeOf(node.base);
  if (!Require(base.kind == TypeKind::kMatrix, "a matrix swizzle is of a matrix")) return;
  if (!Require(node.count >= 1 && node.count <= 4, "a swizzle has one to four components")) return;
  for (int i = 0; i < node.count; ++i) {
    Require(node.rows[i] < base.rows && node.columns[i] < base.columns,
            "the matrix has no such component");
  }
  RequireComponents(base, node.count);
}

void ExprVerifier::Check(const Unary& node) {
  const Type& type = TypeOf(node.operand);
  Require(IdOf(expr_) == IdOf(node.operand) && type.IsNumeric(),
          "the value has the operand's numeric type");
  switch (node.op) {
    case UnaryOp::kNot: Require(type.scalar == Scalar::kBool, "`!` takes bool"); break;
    case UnaryOp::kComplement: Require(IsInteger(type.scalar), "`~` takes integers"); break;
    case UnaryOp::kNegate: Require(type.scalar != Scalar::kBool, "`-` takes numbers"); break;
    default:
      Require(type.scalar != Scalar::kBool, "`++` and `--` take numbers");
      Require(IsTarget(node.operand), "`++` and `--` take an assignment target");
  }
}

void ExprVerifier::Check(const Binary& node) {
  const Type& left = TypeOf(node.left);
  const Type& type = Checked();
  const bool is_shift = IsShift(node.op);
  Require(is_shift ? HasShapeOf(node.left, node.right)
                   : IdOf(node.left) == IdOf(node.right) && left.IsNumeric(),
          "the operands have the same numeric type (of a shift: the same shape)");
  Require(Takes(node.op, left.scalar), "the operator does not take this kind");
  if (is_shift) Require(IsInteger(TypeOf(node.right).scalar), "a shift count is an integer");
  if (GivesBool(node.op)) {
    Require(SameShape(type, left) && type.scalar == Scalar::kBool,
            "the value is bool of the operands' shape");
  } else {
    Require(IdOf(expr_) == IdOf(node.left), "the value has the left operand's type");
  }
  if (IsShortCircuit(node.op)) Require(IsScalar(left), "short-circuit operators take scalars");
}

void ExprVerifier::Check(const Assign& node) {
  Require(IdOf(expr_) == IdOf(node.target), "an assignment has the target's type");
  Require(IsTarget(node.target), "the left side is not an assignment target");
  const bool is_shift = node.op && IsShift(*node.op);
  Require(is_shift ? HasShapeOf(node.target, node.value) : IdOf(node.target) == IdOf(node.value),
          "both sides have the same type (of a shift: the same shape)");
  if (!node.op) return;
  Require(TypeOf(node.target).IsNumeric() && !GivesBool(*node.op) &&
              Takes(*node.op, TypeOf(node.target).scalar),
          "the operator does not take this kind");
}

void ExprVerifier::Check(const Conditional& node) {
  RequireSides(node.when_true, node.when_false);
  Require(IsBoolScalar(TypeOf(node.condition)), "the condition is a bool scalar");
}

void ExprVerifier::Check(const Select& node) {
  RequireSides(node.when_true, node.when_false);
  Require(TypeOf(node.condition).scalar == Scalar::kBool && HasShapeOf(node.condition, expr_) &&
              !IsScalar(Checked()),
          "the condition is a bool vector or matrix of the value's shape");
}

void ExprVerifier::RequireSides(ExprId when_true, ExprId when_false) {
  Require(IdOf(when_true) == IdOf(expr_) && IdOf(when_false) == IdOf(expr_),
          "both sides have the value's type");
}

void ExprVerifier::Check(const Convert& node) {
  Require(HasShapeOf(expr_, node.operand), "a conversion keeps the shape");
}

void ExprVerifier::Check(const Splat& node) {
  const Type& from = TypeOf(node.operand);
  Require(Checked().kind == TypeKind::kVector || Checked().kind == TypeKind::kMatrix,
          "a splat gives a vector or matrix");
  Require(IsScalar(from) && from.scalar == Checked().scalar,
          "a splat takes a scalar of the same kind");
}

void ExprVerifier::Check(const MatrixTruncate& node) {
  const Type& from = TypeOf(node.operand);
  const Type& type = Checked();
  Require(from.kind == TypeKind::kMatrix && type.kind == TypeKind::kMatrix &&
              from.scalar == type.scalar && from.rows >= type.rows && from.columns >= type.columns,
          "a truncation gives a part of a matrix of the same kind");
}

void ExprVerifier::Check(const Comma& node) {
  Require(IdOf(expr_) == IdOf(node.second), "a comma has the type of its second operand");
}

void ExprVerifier::Check(const Construct& node) {
  using enum TypeKind;
  const Type& type = Checked();
  const std::vector<TypeId> arguments = TypesOf(node.arguments);
  if (type.kind == kArray) {
    Require(arguments.size() == type.count &&
                std::ranges::all_of(arguments, [&](TypeId t) { return t == type.element; }),
            "an array is made of its elements");
    return;
  }
  if (type.kind == kStruct) {
    const auto& fields = program_.types[type.structure].fields;
    Require(std::ranges::equal(arguments, fields, {}, {}, &Field::type),
            "a struct is made of its fields");
    return;
  }
  if (!Require(type.kind == kVector || type.kind == kMatrix,
               "only vectors, matrices, structs and arrays are constructed")) {
    return;
  }
  std::uint32_t components = 0;
  bool all_rows = true;
  bool all_scalars = true;
  for (TypeId argument : arguments) {
    const Type& part = program_.types[argument];
    const bool is_vector = part.kind == kVector;
    Require((IsScalar(part) || is_vector) && part.scalar == type.scalar,
            "it is made of scalars and vectors of the same kind");
    all_rows = all_rows && is_vector && part.columns == type.columns;
    all_scalars = all_scalars && IsScalar(part);
    components += part.Components();
  }
  Require(components == type.Components(), "the components do not add up");
  if (type.kind == kMatrix) {
    const bool is_column = type.columns == 1 && arguments.size() == 1;
    Require(all_rows || all_scalars || is_column,
            "a matrix is made of its rows, its only column, or scalars in row order");
  }
}

void ExprVerifier::Check(const Call& node) {
  if (node.function.index >= program_.functions.size())
    return Fail("the called function is not of this program");
  calls.push_back(node.function);
  const Function& function = program_.functions[node.function];
  Require(function.return_type == IdOf(expr_), "a call has the function's return type");
  if (!Require(node.arguments.size == function.parameters.size(), "wrong number of arguments"))
    return;
  for (std::uint32_t i = 0; i < node.arguments.size; ++i) {
    const ExprId argument = program_.expr_lists[node.arguments][i];
    const Var& parameter = program_.vars[function.parameters[i]];
    Require(IdOf(argument) == parameter.type, "an argument has exactly the parameter's type");
    if (parameter.storage != Storage::kIn) {
      Require(IsTarget(argument),
              "the argument of an out or inout parameter is an assignment target");
    }
  }
}

void ExprVerifier::Check(const IntrinsicCall& node) {
  if (node.op == CommonIntrinsic::kNonUniform)
    Require(program_.calls_nonuniform, "the program says that it calls NonUniformResourceIndex");
  const auto problem =
      CheckIntrinsic(program_.types, node.op, IdOf(expr_), TypesOf(node.arguments));
  if (problem) Require(false, *problem);
  // What a control point wrote is read in no other way.
  const auto* array = node.op == CommonIntrinsic::kOutputOfPoint
                          ? As<VarRef>(program_, program_.expr_lists[node.arguments][0])
                          : nullptr;
  if (array && IsOutputArray(program_, array->var)) --output_arrays;
  for (std::uint32_t i = 0; i < node.arguments.size; ++i) {
    if (!WritesArgument(node.op, i)) continue;
    Require(IsTarget(program_.expr_lists[node.arguments][i]),
            "an out argument is an assignment target");
  }
}

// Whether the expression is a path of fields and indices to a variable that may be written, with at
// most one last swizzle.
bool ExprVerifier::IsTarget(ExprId expr) const {
  if (RepeatsComponents(program_, expr)) return false;
  if (As<Swizzle>(program_, expr)) expr = WholeOf(program_, expr);
  while (As<FieldRef>(program_, expr) || As<Index>(program_, expr)) expr = WholeOf(program_, expr);
  const auto* root = As<VarRef>(program_, expr);
  return root && MayBeWritten(program_.vars[root->var].storage);
}

}  // namespace clipc::ir
