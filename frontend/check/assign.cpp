// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/assign.h"

#include <algorithm>
#include <utility>

#include "frontend/check/bit_field.h"
#include "frontend/check/cast_target.h"
#include "frontend/check/element.h"
#include "frontend/check/enum_class.h"
#include "frontend/check/expr.h"
#include "frontend/check/init.h"
#include "frontend/check/operator.h"
#include "frontend/check/value.h"

namespace clipc::check {
namespace {

// What an expression reads and writes.
struct Touched {
  std::vector<VarId> reads, writes;
  bool calls = false;  // functions, which may read and write what is outside of them
};

void AddTouched(const Context& context, ExprId expr, Touched& touched) {
  const Program& program = context.program;
  ForEachExpr(program, expr, [&](ExprId part) {
    if (const auto* ref = context.GetIf<VarRef>(part)) touched.reads.push_back(ref->var);
    ForEachWrite(program, part,
                 [&](ExprId target) { touched.writes.push_back(RootOf(program, target)); });
    const auto* object = context.GetIf<ObjectCall>(part);
    if (object && WritesObject(object->op))
      touched.writes.push_back(RootOf(program, OperandOf(program, *object, OperandKind::kObject)));
    touched.calls |= context.Is<Call>(part);
  });
}

// Adds what it takes to find the place that a path names: an object or a variable itself is not
// read for it.
void AddPlace(const Context& context, ExprId path, Touched& touched) {
  const Program& program = context.program;
  for (; WholeOf(program, path); path = WholeOf(program, path)) {
    if (const auto* index = context.GetIf<Index>(path)) AddTouched(context, index->index, touched);
  }
  if (const auto* element = context.GetIf<ObjectCall>(path)) {
    for (const ExprId operand : OperandsOf(program, path)) {
      if (operand == OperandOf(program, *element, OperandKind::kObject))
        AddPlace(context, operand, touched);
      else
        AddTouched(context, operand, touched);
    }
  } else if (!context.Is<VarRef>(path)) {
    AddTouched(context, path, touched);
  }
}

// Whether functions may write one of the variables, which they reach without an argument.
bool HasOuter(const Context& context, const std::vector<VarId>& vars) {
  return std::ranges::any_of(vars, [&](VarId var) {
    if (!var) return true;
    const Storage storage = context[var].storage;
    const Type& type = context[context[var].type];
    return storage == Storage::kStatic || storage == Storage::kShared ||
           (type.kind == TypeKind::kObject && IsWritable(type.object));
  });
}

// Whether an assignment does something else if it finds the place of its target before its value.
bool OrderMatters(const Context& context, ExprId target, ExprId value) {
  const Program& program = context.program;
  if (RootOf(program, target) && HasLiteralIndices(program, target)) return false;
  if (IsPure(program, target) && IsPure(program, value)) return false;
  Touched of_target, of_value;
  AddPlace(context, target, of_target);
  if (of_target.reads.empty() && !of_target.calls) return false;
  AddTouched(context, value, of_value);
  const auto share = [](const std::vector<VarId>& left, const std::vector<VarId>& right) {
    return std::ranges::find_first_of(left, right) != left.end();
  };
  const auto may_change = [&](const Touched& by, const Touched& of) {
    return share(by.writes, of.reads) || share(by.writes, of.writes) ||
           (by.calls && (of.calls || HasOuter(context, of.reads)));
  };
  return may_change(of_target, of_value) || may_change(of_value, of_target);
}

// Evaluates the value before the target and the steps that find its place, as dxc does
// (SpirvEmitter's doBinaryOperator: "we need to evaluate rhs before lhs"), if that matters. The
// steps then begin with it.
ExprId ValueFirst(Context& context, ExprId target, ExprId value, Exprs& steps) {
  const bool is_constant = context.Is<Literal>(value) || context.Is<Zero>(value);
  const bool precedes_steps = !steps.empty() && !is_constant;
  if (!precedes_steps && !OrderMatters(context, target, value)) return value;
  Exprs first;
  value = Hoist(context, value, first);
  steps.insert(steps.begin(), first.begin(), first.end());
  return value;
}

// The assignment target = value, or target op= value.
ExprId AssignValue(Context& context, const ast::AssignExpr& expr, ExprId target, ExprId value,
                   Span span) {
  if (!CheckTarget(context, target)) return context.ErrorExpr(span);
  if (expr.op) return AssignCompound(context, *expr.op, target, value, span);
  const ExprId converted = Implicit(context, value, context.TypeIdOf(target));
  return context.IsError(converted) ? converted : StoreTo(context, target, converted, span);
}

// Whether the expression is a temporary of the statement in progress.
bool IsTemporary(const Context& context, ExprId expr) {
  const auto* ref = context.GetIf<VarRef>(expr);
  return ref && context.view.body &&
         std::ranges::find(context.view.body->temporaries, ref->var) !=
             context.view.body->temporaries.end();
}

// The assignment m._m00_m11 = v  =>  (t = v, m[0][0] = t.x, m[1][1] = t.y, t).
ExprId StoreToMatrixSwizzle(Context& context, ExprId target, ExprId value, Span span) {
  const auto node = context.Get<MatrixSwizzle>(target);
  Builder at = context.At(span);
  Exprs steps;
  const ExprId base = Stabilize(context, node.base, steps);
  const ExprId stored = IsTemporary(context, value) ? value : Hoist(context, value, steps);
  for (int i = 0; i < node.count; ++i) {
    const ExprId row = at.At(Clone(context.program, base), std::uint32_t{node.rows[i]});
    const ExprId component = at.At(row, std::uint32_t{node.columns[i]});
    steps.push_back(at.AssignTo(component, at.Swizzled(Clone(context.program, stored), {i})));
  }
  return WithPrologue(context, steps, stored);
}

// The assignment m._m00_m11[i] = v  =>  (t = m._m00_m11, t[i] = v, m._m00_m11 = t).
ExprId AssignChosen(Context& context, const ast::AssignExpr& expr, ExprId target, ExprId value,
                    Span span) {
  Exprs steps;
  if (!IsPure(context.program, value)) value = Hoist(context, value, steps);
  const ExprId store = ChangeChosen(context, target, steps);
  if (context.IsError(store)) return store;
  const ExprId change = AssignValue(context, expr, target, value, span);
  if (context.IsError(change)) return change;
  steps.push_back(change);
  steps.push_back(store);
  return WithPrologue(context, steps, Clone(context.program, target));
}

// The assignment to an element of an object, or to a part of one. If it is not a store of `value`,
// it changes a copy, which is then stored.
ExprId AssignElement(Context& context, const ast::AssignExpr& expr, const ElementTarget& to,
                     ExprId value, Span span) {
  const auto [element, target, is_used] = to;
  if (!expr.op) {
    value = Implicit(context, value, context.TypeIdOf(target));
    if (context.IsError(value)) return value;
    const ExprId stored = StoreToElement(context, to, value, span);
    if (stored) return stored;
  }
  Exprs steps;
  Exprs stores = ChangeElement(context, element, target, !IsPure(context.program, value), steps);
  const ExprId change = IsChosenComponent(context, target)
                            ? AssignChosen(context, expr, target, value, span)
                            : AssignValue(context, expr, target, value, span);
  if (context.IsError(change)) return change;
  steps.push_back(change);
  if (is_used) stores.push_back(Clone(context.program, target));
  steps.insert(steps.end(), stores.begin(), stores.end() - 1);
  return WithPrologue(context, steps, stores.back());
}

// The assignment to `target`, of whichever kind it is, whose place `steps` find.
ExprId AssignTo(Context& context, const ast::AssignExpr& expr, const ElementTarget& to,
                Exprs& steps, Span span) {
  const auto [none, target, is_used] = to;
  const bool is_list = context.Is<ast::InitListExpr>(expr.right);
  if (is_list && !expr.op && !context.IsError(target)) {
    ExprId value = CheckInit(context, expr.right, context.TypeIdOf(target));
    if (context.IsError(value)) return context.ErrorExpr(span);
    value = ValueFirst(context, target, value, steps);
    if (const ExprId element = ElementIn(context, target))
      return AssignElement(context, expr, {element, target, is_used}, value, span);
    if (IsChosenComponent(context, target)) return AssignChosen(context, expr, target, value, span);
    return CheckTarget(context, target) ? StoreTo(context, target, value, span)
                                        : context.ErrorExpr(span);
  }
  ExprId value = CheckExpr(context, expr.right);
  if (context.IsError(target, value)) return context.ErrorExpr(span);
  const bool fits = expr.op ? CheckNoEnumClass(context, SpellingOf(*expr.op), target, span)
                            : CheckEnumClasses(context, value, target, context[value].span);
  if (!fits) return context.ErrorExpr(span);
  value = ValueFirst(context, target, value, steps);
  if (const ExprId element = ElementIn(context, target))
    return AssignElement(context, expr, {element, target, is_used}, value, span);
  if (IsChosenComponent(context, target)) return AssignChosen(context, expr, target, value, span);
  return AssignValue(context, expr, target, value, span);
}

// The assignment (T)v = value  =>  (t = (T)value, v.a = t.a, ..., t): `operand` is v.
ExprId AssignToCast(Context& context, const ast::AssignExpr& expr, TypeId type, ast::ExprId operand,
                    Span span) {
  Exprs steps;
  ExprId target = TakeSteps(context, CheckExpr(context, operand), steps);
  ExprId value = expr.op || !context.Is<ast::InitListExpr>(expr.right)
                     ? CheckExpr(context, expr.right)
                     : CheckInit(context, expr.right, type);
  if (context.IsError(target, value) || !CheckCastTarget(context, target, expr.left, type))
    return context.ErrorExpr(span);
  value = ValueFirst(context, target, value, steps);
  target = Stabilize(context, target, steps);
  if (expr.op) {
    const ExprId old = ConvertSilently(context, Clone(context.program, target), type);
    value = CombineOperands(context, *expr.op, old, value, {span, span});
  }
  value = context.IsError(value) ? value : Implicit(context, value, type);
  if (context.IsError(value)) return value;
  const ExprId stored = Hoist(context, value, steps);
  StoreComponents(context, target, stored, steps);
  return WithPrologue(context, steps, Clone(context.program, stored));
}

// The assignment ((int4)v).xy = value  =>  v.xy = (float2)(int2)value: `path` is v.xy.
ExprId AssignToUncast(Context& context, const ast::AssignExpr& expr, ExprId path, TypeId type,
                      Span span) {
  ExprId value = CheckInit(context, expr.right, type);
  if (context.IsError(value) || !CheckTarget(context, path)) return context.ErrorExpr(span);
  Exprs steps;
  value = ValueFirst(context, path, value, steps);
  value = ConvertSilently(context, value, context.TypeIdOf(path));
  return WithPrologue(context, steps, StoreTo(context, path, value, span));
}

// The assignment float4(a, b) = value  =>  (t = value, a = t.xy, b = t.zw, t), which fxc takes (its
// listing of the SDK's ParallaxOcclusionMapping): `target` is the vector of a and b. Returns none
// where the parts are not the components of the vector.
ExprId AssignToParts(Context& context, const ast::AssignExpr& expr, ExprId target, Span span) {
  const auto* construct = context.GetIf<Construct>(target);
  const TypeId type_id = context.TypeIdOf(target);
  if (!construct || expr.op || !context[type_id].IsScalarOrVector()) return {};
  const List<ExprId> list = construct->arguments;
  std::uint32_t components = 0;
  for (const ExprId part : context[list]) {
    const Type& type = context.TypeOf(part);
    if (!type.IsScalarOrVector() || !RootOf(context.program, part)) return {};
    components += type.Components();
  }
  if (components != context[type_id].Components()) return {};
  ExprId value = CheckExpr(context, expr.right);
  if (!context.IsError(value)) value = Implicit(context, value, type_id);
  if (context.IsError(value)) return value;
  Exprs steps, parts;
  const ExprId stored = Hoist(context, value, steps);
  for (std::uint32_t i = 0; i < list.size; ++i) {
    parts.push_back(Stabilize(context, context[list][i], steps));
    if (!CheckTarget(context, parts.back())) return context.ErrorExpr(span);
  }
  std::size_t first = 0;
  for (const ExprId part : parts) {
    const auto count = static_cast<std::size_t>(context.TypeOf(part).Components());
    Builder at = context.At(span);
    const ExprId piece = at.SwizzledRun(Clone(context.program, stored), first, count);
    steps.push_back(StoreTo(context, part, piece, span));
    first += count;
  }
  return WithPrologue(context, steps, Clone(context.program, stored));
}

}  // namespace

void MarkConst(Context& context, VarId var) {
  if (context.globals.const_vars.size() <= var.index)
    context.globals.const_vars.resize(var.index + 1);
  context.globals.const_vars[var.index] = true;
}

bool IsConstVar(const Context& context, VarId var) {
  return var.index < context.globals.const_vars.size() && context.globals.const_vars[var.index];
}

bool CheckTarget(Context& context, ExprId target) {
  const Span span = context[target].span;
  const VarId root = RootOf(context.program, target);
  // An input is the value of a call, as of WaveGetLaneIndex(): parameters of an entry are local.
  if (!root || context[root].storage == Storage::kInput) {
    context.Report(span, diag::NotAssignable);
    return false;
  }
  const Var& var = context[root];
  if (var.storage == Storage::kUniform) {
    context.Report(span, diag::UniformAssigned, var.name)
        .Note(var.span, diag::DeclaredHere, var.name);
    return false;
  }
  // `operator[]` of a patch gives a constant (the methods of InputPatch and OutputPatch in DXC).
  if (std::ranges::find(context.globals.patches, root) != context.globals.patches.end()) {
    context.Report(span, diag::PatchAssigned, var.name)
        .Note(var.span, diag::DeclaredHere, var.name);
    return false;
  }
  if (IsConstVar(context, root)) {
    context.Report(span, diag::ConstAssigned, var.name)
        .Note(var.span, diag::DeclaredHere, var.name);
    return false;
  }
  const auto* index = context.GetIf<Index>(target);
  if (RepeatsComponents(context.program, index ? index->base : target)) {
    context.Report(span, diag::SwizzleRepeats);
    return false;
  }
  IndexWholeVector(context.program, target);
  return true;
}

bool IsChosenComponent(const Context& context, ExprId expr) {
  const auto* index = context.GetIf<Index>(expr);
  return index && context.Is<MatrixSwizzle>(index->base);
}

ExprId ChangeChosen(Context& context, ExprId element, Exprs& prologue) {
  if (!CheckTarget(context, element)) return context.ErrorExpr(context[element].span);
  Stabilize(context, element, prologue);
  const auto index = context.Get<Index>(element);
  const ExprId copy = Hoist(context, Clone(context.program, index.base), prologue);
  context[element].node = Index{copy, index.index};
  return StoreTo(context, index.base, Clone(context.program, copy), context[element].span);
}

ExprId Stabilize(Context& context, ExprId path, Exprs& prologue) {
  if (IsPure(context.program, path)) return path;
  auto& node = context[path].node;
  if (auto* index = std::get_if<Index>(&node)) {
    const ExprId base = Stabilize(context, index->base, prologue);
    const ExprId number = IsPure(context.program, index->index)
                              ? index->index
                              : Hoist(context, index->index, prologue);
    context[path].node = Index{base, number};
  } else if (auto* field = std::get_if<FieldRef>(&node)) {
    field->base = Stabilize(context, field->base, prologue);
  } else if (auto* swizzle = std::get_if<Swizzle>(&node)) {
    swizzle->base = Stabilize(context, swizzle->base, prologue);
  } else if (auto* matrix = std::get_if<MatrixSwizzle>(&node)) {
    matrix->base = Stabilize(context, matrix->base, prologue);
  }
  return path;
}

ExprId TakeSteps(const Context& context, ExprId target, Exprs& prologue) {
  ExprId last = target;
  Exprs steps;
  while (const auto* comma = context.GetIf<Comma>(last)) {
    steps.push_back(comma->first);
    last = comma->second;
  }
  if (!context.Is<MatrixSwizzle>(last) || !context.view.body) return target;
  // A swizzle of a value, f()._m00_m11, is a swizzle of a temporary, which nothing is assigned to.
  const std::vector<VarId>& temporaries = context.view.body->temporaries;
  if (std::ranges::find(temporaries, RootOf(context.program, last)) != temporaries.end())
    return target;
  prologue.insert(prologue.end(), steps.begin(), steps.end());
  return last;
}

// (i += 2) *= 3  =>  (i += 2, i *= 3), as in DXC's CodeGenSPIRV/unary-op.prefix-inc.hlsl.
ExprId TakeChanged(Context& context, ExprId target, Exprs& prologue) {
  if (context.Is<VarRef>(target) || !context.program.profile.IsAtLeast(6, 0)) return target;
  const auto* assign = context.GetIf<Assign>(target);
  const auto* unary = context.GetIf<Unary>(target);
  const bool is_step = unary && ChangesOperand(unary->op) && !IsPostfix(unary->op);
  if (!assign && !is_step) return target;
  const ExprId changed = assign ? assign->target : unary->operand;
  if (!IsPure(context.program, changed)) return target;
  prologue.push_back(target);
  return Clone(context.program, changed);
}

ExprId CheckNode(Context& context, const ast::AssignExpr& expr, Span span) {
  const bool is_used = !std::exchange(context.drops_value, false);
  Exprs steps;
  const ExprId left = CheckExpr(context, expr.left);
  if (const ast::ExprId operand = CastOperand(context, left))
    return AssignToCast(context, expr, context.TypeIdOf(left), operand, span);
  if (context.program.profile.IsDirect3D9() && !expr.op && context.Is<Swizzle>(left) &&
      !RootOf(context.program, left)) {
    if (const ExprId path = WithoutCasts(context, left))
      return AssignToUncast(context, expr, path, context.TypeIdOf(left), span);
  }
  if (IsBitField(context, left)) {
    ExprId value = expr.op ? CheckExpr(context, expr.right)
                           : CheckInit(context, expr.right, context.TypeIdOf(left));
    if (context.IsError(value)) return value;
    value = ValueFirst(context, context.bits.at(left.index).word, value, steps);
    return WithPrologue(context, steps, AssignToBits(context, expr.op, left, value, span));
  }
  if (const ExprId stores = AssignToParts(context, expr, left, span)) return stores;
  const ExprId target = TakeChanged(context, TakeSteps(context, left, steps), steps);
  const ExprId result = AssignTo(context, expr, {{}, target, is_used}, steps, span);
  return WithPrologue(context, steps, result);
}

ExprId AssignCompound(Context& context, BinaryOp op, ExprId target, ExprId value, Span span) {
  const TypeId type_id = context.TypeIdOf(target);
  const Type type = context[type_id];
  if (type.IsNumeric() && type.Components() == 1 && context.TypeOf(value).Components() > 1) {
    value =
        Implicit(context, value, context.types.WithScalar(type_id, context.TypeOf(value).scalar));
  }
  const bool is_numeric = type.IsNumeric() && context.TypeOf(value).IsNumeric();
  const auto common = is_numeric ? OperandType(context, op, target, value, span) : std::nullopt;
  if (is_numeric && !common) return context.ErrorExpr(span);
  const bool is_swizzle = context.Is<MatrixSwizzle>(target);
  if (common && !is_swizzle) {
    const bool is_shift = IsShift(op);
    const TypeId same_shape = context.types.WithScalar(*common, type.scalar);
    const bool same_kind = BaseOf(context[*common].scalar) == BaseOf(type.scalar);
    if (same_shape == type_id && type.scalar != Scalar::kBool && (same_kind || is_shift)) {
      const Scalar kind = is_shift && context.TypeOf(value).scalar != Scalar::kBool
                              ? context.TypeOf(value).scalar
                              : type.scalar;
      value = Implicit(context, value, context.types.WithScalar(type_id, kind));
      return context.IsError(value) ? value : context.At(span).AssignTo(target, value, op);
    }
  }
  Exprs prologue;
  target = Stabilize(context, target, prologue);
  const bool is_bool = type.IsNumeric() && type.scalar == Scalar::kBool;
  if (is_bool && op == BinaryOp::kBitAnd) op = BinaryOp::kLogicalAnd;
  if (is_bool && op == BinaryOp::kBitOr) op = BinaryOp::kLogicalOr;
  const ExprId result =
      CombineOperands(context, op, Clone(context.program, target), value, {span, span});
  if (context.IsError(result)) return result;
  const ExprId converted = Implicit(context, result, type_id);
  return context.IsError(converted)
             ? converted
             : WithPrologue(context, prologue, StoreTo(context, target, converted, span));
}

ExprId StoreTo(Context& context, ExprId target, ExprId value, Span span) {
  if (context.Is<MatrixSwizzle>(target)) {
    return StoreToMatrixSwizzle(context, target, value, span);
  }
  return context.At(span).AssignTo(target, value);
}

}  // namespace clipc::check
