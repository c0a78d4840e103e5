// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <bit>

#include "ir/access.h"
#include "ir/print.h"
#include "ir/verifier.h"

namespace clipc::ir {
namespace {

bool IsScalar(const Type& type) { return type.kind == TypeKind::kScalar; }
bool IsBoolScalar(const Type& type) { return IsScalar(type) && type.scalar == Scalar::kBool; }
bool IsIndexType(const Type& type) { return IsScalar(type) && IsInteger(type.scalar); }

// What an arithmetic, bit, shift, comparison or logical operator takes.
bool Takes(BinaryOp op, Scalar kind) {
  switch (op) {
    case BinaryOp::kMul:
    case BinaryOp::kDiv:
    case BinaryOp::kMod:
    case BinaryOp::kAdd:
    case BinaryOp::kSub: return kind != Scalar::kBool;
    case BinaryOp::kShiftLeft:
    case BinaryOp::kShiftRight: return IsInteger(kind);
    case BinaryOp::kBitAnd:
    case BinaryOp::kBitXor:
    case BinaryOp::kBitOr: return !IsFloat(kind);
    case BinaryOp::kLogicalAnd:
    case BinaryOp::kLogicalOr:
    case BinaryOp::kShortCircuitAnd:
    case BinaryOp::kShortCircuitOr: return kind == Scalar::kBool;
    default: return true;
  }
}

bool MayBeWritten(Storage storage) {
  switch (storage) {
    case Storage::kLocal:
    case Storage::kIn:
    case Storage::kOut:
    case Storage::kInOut:
    case Storage::kStatic:
    case Storage::kOutput: return true;
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

bool ExprVerifier::Require(bool holds, ExprId expr, std::string_view rule) {
  if (!holds && !failed()) {
    Fail("`" + PrintExpr(program_, expr) + "` of type " + program_.types.Name(IdOf(expr)) + ": " +
         std::string(rule));
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
    // Not printed: the tree may contain itself.
    return Fail("expression " + std::to_string(expr.index) + " has two parents");
  }
  has_parent_[expr.index] = true;
  const TypeId type = program_.exprs[expr].type;
  if (!type || program_.types[type].kind == TypeKind::kError) {
    return Fail("expression " + std::to_string(expr.index) + " has no type");
  }
  ForEachOperand(program_, expr, [&](ExprId operand) { CheckTree(operand); });
  if (!failed()) CheckNode(expr);
  if (!legalized || failed()) return;
  const std::string_view broken = RuleBrokenBy(program_, expr);
  Require(broken.empty(), expr, broken);
}

void ExprVerifier::CheckNode(ExprId expr) {
  const auto is = [&](bool holds, std::string_view rule) { Require(holds, expr, rule); };
  const Type& type = TypeOf(expr);
  std::visit(
      Overloaded{
          [&](const Literal& n) {
            is(IsScalar(type), "a literal is a scalar");
            if (type.scalar == Scalar::kBool) is(n.bits <= 1, "a bool literal is 0 or 1");
          },
          [&](const Zero&) {
            is(type.kind != TypeKind::kVoid && type.kind != TypeKind::kObject,
               "there is no such zero");
          },
          [&](const VarRef& n) { CheckVarRef(expr, n); },
          [&](const FieldRef& n) { CheckField(expr, n); },
          [&](const Index& n) { CheckIndex(expr, n); },
          [&](const Swizzle& n) { CheckSwizzle(expr, n); },
          [&](const MatrixSwizzle& n) { CheckMatrixSwizzle(expr, n); },
          [&](const Unary& n) { CheckUnary(expr, n); },
          [&](const Binary& n) { CheckBinary(expr, n); },
          [&](const Assign& n) { CheckAssign(expr, n); },
          [&](const Conditional& n) {
            CheckChoice(expr, n.condition, n.when_true, n.when_false, false);
          },
          [&](const Select& n) { CheckChoice(expr, n.condition, n.when_true, n.when_false, true); },
          [&](const Convert& n) {
            is(HasShapeOf(expr, n.operand), "a conversion keeps the shape");
          },
          [&](const Splat& n) {
            is(type.kind == TypeKind::kVector || type.kind == TypeKind::kMatrix,
               "a splat gives a vector or matrix");
            is(IsScalar(TypeOf(n.operand)) && TypeOf(n.operand).scalar == type.scalar,
               "a splat takes a scalar of the same kind");
          },
          [&](const Construct& n) { CheckConstruct(expr, n); },
          [&](const MatrixTruncate& n) {
            const Type& from = TypeOf(n.operand);
            is(from.kind == TypeKind::kMatrix && type.kind == TypeKind::kMatrix &&
                   from.scalar == type.scalar && from.rows >= type.rows &&
                   from.columns >= type.columns,
               "a truncation gives a part of a matrix of the same kind");
          },
          [&](const Call& n) { CheckCall(expr, n); },
          [&](const IntrinsicCall& n) { CheckIntrinsicCall(expr, n); },
          [&](const ObjectCall& n) { CheckObjectCall(expr, n); },
          [&](const Comma& n) {
            is(IdOf(expr) == IdOf(n.second), "a comma has the type of its second operand");
          },
      },
      program_.exprs[expr].node);
}

void ExprVerifier::CheckVarRef(ExprId expr, const VarRef& node) {
  if (node.var.index >= program_.vars.size())
    return Fail("a reference to no variable of this program");
  const Var& var = program_.vars[node.var];
  if (!Require(var.type == IdOf(expr), expr, "a reference has the variable's type")) return;
  if (scope[node.var.index] == Scope::kVisible) return;
  Require(false, expr,
          scope[node.var.index] == Scope::kGone ? "the variable is out of scope here"
                                                : "the variable is not declared here");
}

void ExprVerifier::CheckField(ExprId expr, const FieldRef& node) {
  const Type& base = TypeOf(node.base);
  if (!Require(base.kind == TypeKind::kStruct, expr, "a field is of a struct")) return;
  const auto& fields = program_.types[base.structure].fields;
  if (!Require(node.field < fields.size(), expr, "the struct has no such field")) return;
  Require(fields[node.field].type == IdOf(expr), expr, "a field reference has the field's type");
}

void ExprVerifier::CheckIndex(ExprId expr, const Index& node) {
  const Type& base = TypeOf(node.base);
  const Type& type = TypeOf(expr);
  Require(IsIndexType(TypeOf(node.index)), expr, "an index is an int or uint scalar");
  switch (base.kind) {
    case TypeKind::kArray:
      Require(base.element == IdOf(expr), expr, "an element has the array's element type");
      break;
    case TypeKind::kVector:
      Require(IsScalar(type) && type.scalar == base.scalar, expr,
              "a component is a scalar of the vector's kind");
      break;
    case TypeKind::kMatrix:
      Require(type.kind == TypeKind::kVector && type.scalar == base.scalar &&
                  type.columns == base.columns,
              expr, "a row is a vector of the matrix's columns");
      break;
    default: Require(false, expr, "only arrays, vectors and matrices are indexed");
  }
}

void ExprVerifier::RequireComponents(ExprId expr, const Type& base, std::uint8_t count) {
  const Type& type = TypeOf(expr);
  const bool has_shape =
      count == 1 ? IsScalar(type) : type.kind == TypeKind::kVector && type.columns == count;
  Require(type.scalar == base.scalar && has_shape, expr,
          "one component is a scalar, more are a vector, of the same kind");
}

void ExprVerifier::CheckSwizzle(ExprId expr, const Swizzle& node) {
  const Type& base = TypeOf(node.base);
  if (!Require(base.kind == TypeKind::kVector, expr, "a swizzle is of a vector")) return;
  if (!Require(node.count >= 1 && node.count <= 4, expr, "a swizzle has one to four components"))
    return;
  for (int i = 0; i < node.count; ++i) {
    Require(node.components[i] < base.columns, expr, "the vector has no such component");
  }
  RequireComponents(expr, base, node.count);
}

void ExprVerifier::CheckMatrixSwizzle(ExprId expr, const MatrixSwizzle& node) {
  const Type& base = TypeOf(node.base);
  if (!Require(base.kind == TypeKind::kMatrix, expr, "a matrix swizzle is of a matrix")) return;
  if (!Require(node.count >= 1 && node.count <= 4, expr, "a swizzle has one to four components"))
    return;
  for (int i = 0; i < node.count; ++i) {
    Require(node.rows[i] < base.rows && node.columns[i] < base.columns, expr,
            "the matrix has no such component");
  }
  RequireComponents(expr, base, node.count);
}

void ExprVerifier::CheckUnary(ExprId expr, const Unary& node) {
  const Type& type = TypeOf(node.operand);
  Require(IdOf(expr) == IdOf(node.operand) && type.IsNumeric(), expr,
          "the value has the operand's numeric type");
  switch (node.op) {
    case UnaryOp::kNot: Require(type.scalar == Scalar::kBool, expr, "`!` takes bool"); break;
    case UnaryOp::kComplement: Require(IsInteger(type.scalar), expr, "`~` takes integers"); break;
    case UnaryOp::kNegate: Require(type.scalar != Scalar::kBool, expr, "`-` takes numbers"); break;
    default:
      Require(type.scalar != Scalar::kBool, expr, "`++` and `--` take numbers");
      Require(IsTarget(node.operand), expr, "`++` and `--` take an assignment target");
  }
}

void ExprVerifier::CheckBinary(ExprId expr, const Binary& node) {
  const Type& left = TypeOf(node.left);
  const Type& type = TypeOf(expr);
  const bool is_shift = node.op == BinaryOp::kShiftLeft || node.op == BinaryOp::kShiftRight;
  Require(is_shift ? HasShapeOf(node.left, node.right)
                   : IdOf(node.left) == IdOf(node.right) && left.IsNumeric(),
          expr, "the operands have the same numeric type (of a shift: the same shape)");
  Require(Takes(node.op, left.scalar), expr, "the operator does not take this kind");
  if (is_shift) Require(IsInteger(TypeOf(node.right).scalar), expr, "a shift count is an integer");
  if (GivesBool(node.op)) {
    Require(SameShape(type, left) && type.scalar == Scalar::kBool, expr,
            "the value is bool of the operands' shape");
  } else {
    Require(IdOf(expr) == IdOf(node.left), expr, "the value has the left operand's type");
  }
  if (IsShortCircuit(node.op))
    Require(IsScalar(left), expr, "short-circuit operators take scalars");
}

void ExprVerifier::CheckAssign(ExprId expr, const Assign& node) {
  Require(IdOf(expr) == IdOf(node.target), expr, "an assignment has the target's type");
  Require(IsTarget(node.target), expr, "the left side is not an assignment target");
  const bool is_shift = node.op == BinaryOp::kShiftLeft || node.op == BinaryOp::kShiftRight;
  Require(is_shift ? HasShapeOf(node.target, node.value) : IdOf(node.target) == IdOf(node.value),
          expr, "both sides have the same type (of a shift: the same shape)");
  if (!node.op) return;
  Require(TypeOf(node.target).IsNumeric() && !GivesBool(*node.op) &&
              Takes(*node.op, TypeOf(node.target).scalar),
          expr, "the operator does not take this kind");
}

void ExprVerifier::CheckChoice(ExprId expr, ExprId condition, ExprId when_true, ExprId when_false,
                               bool component_wise) {
  Require(IdOf(when_true) == IdOf(expr) && IdOf(when_false) == IdOf(expr), expr,
          "both sides have the value's type");
  if (!component_wise) {
    Require(IsBoolScalar(TypeOf(condition)), expr, "the condition is a bool scalar");
    return;
  }
  Require(TypeOf(condition).scalar == Scalar::kBool && HasShapeOf(condition, expr) &&
              !IsScalar(TypeOf(expr)),
          expr, "the condition is a bool vector or matrix of the value's shape");
}

void ExprVerifier::CheckConstruct(ExprId expr, const Construct& node) {
  const Type& type = TypeOf(expr);
  const std::vector<TypeId> arguments = TypesOf(node.arguments);
  if (type.kind == TypeKind::kArray) {
    Require(arguments.size() == type.count &&
                std::ranges::all_of(arguments, [&](TypeId t) { return t == type.element; }),
            expr, "an array is made of its elements");
    return;
  }
  if (type.kind == TypeKind::kStruct) {
    const auto& fields = program_.types[type.structure].fields;
    Require(std::ranges::equal(arguments, fields, {}, {}, &Field::type), expr,
            "a struct is made of its fields");
    return;
  }
  if (!Require(type.kind == TypeKind::kVector || type.kind == TypeKind::kMatrix, expr,
               "only vectors, matrices, structs and arrays are constructed")) {
    return;
  }
  std::uint32_t components = 0;
  bool all_rows = true;
  bool all_scalars = true;
  for (TypeId argument : arguments) {
    const Type& part = program_.types[argument];
    const bool is_vector = part.kind == TypeKind::kVector;
    Require((IsScalar(part) || is_vector) && part.scalar == type.scalar, expr,
            "it is made of scalars and vectors of the same kind");
    all_rows = all_rows && is_vector && part.columns == type.columns;
    all_scalars = all_scalars && IsScalar(part);
    components += part.Components();
  }
  Require(components == type.Components(), expr, "the components do not add up");
  if (type.kind == TypeKind::kMatrix) {
    Require(all_rows || all_scalars, expr,
            "a matrix is made of its rows, or of scalars in row order");
  }
}

void ExprVerifier::CheckCall(ExprId expr, const Call& node) {
  if (node.function.index >= program_.functions.size())
    return Fail("a call of no function of this program");
  calls.push_back(node.function);
  const Function& function = program_.functions[node.function];
  Require(function.return_type == IdOf(expr), expr, "a call has the function's return type");
  if (!Require(node.arguments.size == function.parameters.size(), expr,
               "wrong number of arguments"))
    return;
  for (std::uint32_t i = 0; i < node.arguments.size; ++i) {
    const ExprId argument = program_.expr_lists[node.arguments][i];
    const Var& parameter = program_.vars[function.parameters[i]];
    Require(IdOf(argument) == parameter.type, expr, "an argument has exactly the parameter's type");
    if (parameter.storage != Storage::kIn) {
      Require(IsTarget(argument), expr,
              "the argument of an out or inout parameter is an assignment target");
    }
  }
}

void ExprVerifier::CheckIntrinsicCall(ExprId expr, const IntrinsicCall& node) {
  const auto problem = CheckIntrinsic(program_.types, node.op, IdOf(expr), TypesOf(node.arguments));
  if (problem) Require(false, expr, *problem);
  for (std::uint32_t i = 0; i < node.arguments.size; ++i) {
    if (!WritesArgument(node.op, i)) continue;
    Require(IsTarget(program_.expr_lists[node.arguments][i]), expr,
            "an out argument is an assignment target");
  }
}

void ExprVerifier::CheckObjectCall(ExprId expr, const ObjectCall& node) {
  if (!Require(!node.arguments.empty(), expr, "an object call needs its object")) return;
  const auto arguments = program_.expr_lists[node.arguments];
  const auto is_object = [&](std::size_t i) {
    return i < arguments.size() && TypeOf(arguments[i]).kind == TypeKind::kObject;
  };
  Require(is_object(0), expr, "the first argument is an object");
  const bool has_sampler = TakesSampler(node.op);
  if (has_sampler) Require(is_object(1), expr, "the second argument is a sampler");
  for (std::size_t i = has_sampler ? 2 : 1; i < arguments.size(); ++i) {
    const bool is_stored = node.op == ObjectOp::kStore && i == 2;
    Require(is_stored || TypeOf(arguments[i]).IsNumeric(), expr,
            "coordinates, levels and offsets are numeric");
  }
  for (std::size_t i = 0; i < (has_sampler ? 2u : 1u) && i < arguments.size(); ++i) {
    ExprId path = arguments[i];
    while (const auto* index = As<Index>(program_, path)) path = index->base;
    Require(As<VarRef>(program_, path), expr,
            "an object is a variable, or an element of an array of them");
  }
}

// A path of fields and indices to a variable that may be written, with at most one last swizzle.
bool ExprVerifier::IsTarget(ExprId expr) const {
  if (const auto* swizzle = As<Swizzle>(program_, expr)) {
    unsigned seen = 0;
    for (int i = 0; i < swizzle->count; ++i) seen |= 1u << swizzle->components[i];
    if (std::popcount(seen) != swizzle->count) return false;
    expr = swizzle->base;
  }
  while (As<FieldRef>(program_, expr) || As<Index>(program_, expr)) expr = WholeOf(program_, expr);
  const auto* root = As<VarRef>(program_, expr);
  return root && MayBeWritten(program_.vars[root->var].storage);
}

}  // namespace clipc::ir
