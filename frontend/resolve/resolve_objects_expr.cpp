// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>

#include "frontend/resolve/object_resolver.h"
#include "frontend/typing/conversion.h"
#include "ir/access.h"
#include "ir/walk.h"

namespace clipc::resolve {

ObjectResolver::Value ObjectResolver::Visit(ExprId id) {
  const Expr expr = program_.exprs[id];
  return clipc::Visit([&](const auto& node) { return VisitNode(id, node); }, expr.node);
}

ObjectResolver::Value ObjectResolver::VisitOther(ExprId id) {
  if (IsRemoved(program_.exprs[id].type)) return {};
  MapOperands(program_, id, [&](ExprId operand) { return Visit(operand).expr; });
  return {id, {}};
}

ObjectResolver::Value ObjectResolver::VisitNode(ExprId id, const VarRef& ref) {
  const VarId var = ref.var;
  const TypeId type = program_.vars[var].type;
  if (!Holds(type)) return {id, {}};
  Value value{IsRemoved(type) ? ExprId{} : id, {}};
  if (program_.vars[var].storage == Storage::kResource) {
    value.slots[{}] = {var, {}};
  } else if (const auto global = globals_.find(var); global != globals_.end()) {
    value.slots = global->second;
  } else if (frame_ != nullptr) {
    value.slots = frame_->slots[var];
  }
  return value;
}

ObjectResolver::Value ObjectResolver::VisitNode(ExprId id, const FieldRef& field) {
  const StructId structure = ir::TypeOf(program_, field.base).structure;
  const Value base = Visit(field.base);
  const std::uint32_t number = field_numbers_[structure.index][field.field];
  Value value{number == ~0u ? ExprId{} : id, Inside(base.slots, field.field)};
  program_.exprs[id].node = FieldRef{base.expr, number};
  return value;
}

ObjectResolver::Value ObjectResolver::VisitNode(ExprId id, const Index& node) {
  const Type array = ir::TypeOf(program_, node.base);
  const Value base = Visit(node.base);
  const ExprId index = Visit(node.index).expr;
  const bool is_removed = IsRemoved(program_.exprs[id].type);
  program_.exprs[id].node = Index{base.expr, index};
  Value value{is_removed ? ExprId{} : id, {}};
  if (base.slots.empty()) return value;
  const auto* ref = As<VarRef>(program_, index);
  const bool is_named = ref && program_.vars[ref->var].storage == Storage::kConstant;
  const ExprId number = is_named ? program_.vars[ref->var].init : index;
  if (const auto* literal = number ? As<Literal>(program_, number) : nullptr) {
    value.slots = Inside(base.slots, static_cast<std::uint32_t>(literal->bits));
    return value;
  }
  if (const auto whole = base.slots.find({}); whole != base.slots.end()) {
    ObjectPath element = whole->second;
    element.indices.push_back({0, {}, index});
    value.slots[{}] = std::move(element);
    return value;
  }
  value.slots = InsideAny(base.slots, array.count);
  return value;
}

ObjectResolver::Value ObjectResolver::VisitNode(ExprId id, const Assign& node) {
  const TypeId type = program_.exprs[id].type;
  const Span span = program_.exprs[id].span;
  const auto place = Holds(type) ? PlaceOf(node.target) : std::nullopt;
  const std::string name = place || !Holds(type) ? "" : NameOf(node.target);
  const ExprId target = Visit(node.target).expr;
  Value value = Visit(node.value);
  program_.exprs[id].node = Assign{node.op, target, value.expr};
  if (!Holds(type)) return {id, {}};
  if (!place) {
    ReportChoice(name, type, span);
    return {id, {}};
  }
  Bind(place->first, place->second, value.slots, span);
  Value result{IsRemoved(type) ? ExprId{} : id, {}};
  const bool is_static = program_.vars[place->first].storage == Storage::kStatic;
  for (const auto& [path, object] :
       is_static ? globals_[place->first] : frame_->slots[place->first]) {
    if (StartsWith(path, place->second)) {
      result.slots[SlotPath(path.begin() + static_cast<std::ptrdiff_t>(place->second.size()),
                            path.end())] = object;
    }
  }
  return result;
}

ObjectResolver::Value ObjectResolver::VisitNode(ExprId id, const Comma& node) {
  const ExprId first = Visit(node.first).expr;
  Value second = Visit(node.second);
  if (!first || IsObject(program_.exprs[first].type)) return second;
  if (!second.expr) {
    Before(first, program_.exprs[id].span);
    return second;
  }
  program_.exprs[id].node = Comma{first, second.expr};
  return {id, std::move(second.slots)};
}

ObjectResolver::Value ObjectResolver::VisitNode(ExprId id, const Construct& node) {
  Value value{IsRemoved(program_.exprs[id].type) ? ExprId{} : id, {}};
  std::vector<ExprId> arguments;
  for (std::uint32_t i = 0; i < node.arguments.size; ++i) {
    const Value part = Visit(program_.expr_lists[node.arguments][i]);
    AddUnder(value.slots, i, part.slots);
    if (part.expr) arguments.push_back(part.expr);
  }
  program_.exprs[id].node = Construct{program_.expr_lists.Add(arguments)};
  return value;
}

ObjectResolver::Value ObjectResolver::VisitNode(ExprId id, const Conditional& node) {
  const TypeId type = program_.exprs[id].type;
  if (!Holds(type)) return VisitOther(id);
  const ExprId condition = Visit(node.condition).expr;
  const Value yes = Visit(node.when_true), no = Visit(node.when_false);
  if (yes.slots != no.slots) {
    ReportChoice("?:", type, program_.exprs[id].span);
    return {id, {}};
  }
  program_.exprs[id].node = Conditional{condition, yes.expr, no.expr};
  return {IsRemoved(type) ? ExprId{} : id, yes.slots};
}

ObjectResolver::Value ObjectResolver::VisitNode(ExprId id, const Call& call) {
  const Span span = program_.exprs[id].span;
  const Function callee = program_.functions[call.function];
  std::vector<ExprId> kept;
  std::vector<Slots> slots;
  std::vector<std::optional<std::pair<VarId, SlotPath>>> places;
  for (std::uint32_t i = 0; i < call.arguments.size; ++i) {
    const ExprId argument = program_.expr_lists[call.arguments][i];
    const Var& parameter = program_.vars[callee.parameters[i]];
    const bool is_bound = parameter.storage != Storage::kIn && Holds(parameter.type);
    places.push_back(is_bound ? PlaceOf(argument) : std::nullopt);
    Value value = Visit(argument);
    if (value.expr) kept.push_back(value.expr);
    slots.push_back(std::move(value.slots));
  }
  if (!SignatureHolds(callee)) {
    const FunctionId function = InPlace(call.function);
    program_.exprs[id].node = Call{function, program_.expr_lists.Add(kept)};
    return {id, {}};
  }
  const Instance* instance = InstanceFor(call.function, slots, kept, span);
  if (!instance) return {id, {}};
  const Value result = ResultOf(id, *instance, kept);
  program_.exprs[id].node = Call{instance->function, program_.expr_lists.Add(kept)};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Var& parameter = program_.vars[callee.parameters[i]];
    if (parameter.storage == Storage::kIn || !Holds(parameter.type)) continue;
    const bool is_known = std::ranges::all_of(
        instance->outs[i], [](const auto& slot) { return slot.second.IsKnown(); });
    // An inout parameter that comes back unchanged binds nothing.
    if (parameter.storage == Storage::kInOut && instance->outs[i] == instance->ins[i]) continue;
    if (!places[i] || !is_known) {
      ReportChoice(parameter.name, parameter.type, span);
    } else {
      Bind(places[i]->first, places[i]->second, instance->outs[i], span);
    }
  }
  if (IsRemoved(callee.return_type)) {
    program_.exprs[id].type = program_.types.Void();
    if (!IsReturnOnly(instance->function)) Before(id, span);
  } else if (result.expr != id) {
    Builder at(program_, span);
    const ExprId call_itself = at.Add(program_.exprs[id].type, program_.exprs[id].node);
    Before(at.AssignTo(Clone(program_, result.expr), call_itself), span);
  }
  return result;
}

// What a call gives: the indices of its objects, which the function returns in parameters, are in
// variables after it. So the call runs first then, and its value is a variable, too.
ObjectResolver::Value ObjectResolver::ResultOf(ExprId call, const Instance& instance,
                                               std::vector<ExprId>& arguments) {
  const TypeId type = program_.exprs[call].type;
  Builder at(program_, program_.exprs[call].span);
  Value result{IsRemoved(type) ? ExprId{} : call, instance.result};
  const auto local = [&](const std::string& name, TypeId of) {
    const VarId var = at.Local(name, of);
    frame_->declarations.push_back(at.Stmt(Declare{var, {}}));
    return var;
  };
  if (!instance.returned.empty() && !frame_) {
    ReportChoice(functions_[instance.function].name, type, program_.exprs[call].span);
    return result;
  }
  for (const VarId returned : instance.returned) {
    const VarId index = local(program_.vars[returned].name, program_.vars[returned].type);
    arguments.push_back(at.Ref(index));
    for (auto& [_, object] : result.slots) {
      for (ObjectIndex& part : object.indices)
        if (part.var == returned) part.var = index;
    }
  }
  if (!instance.returned.empty() && result.expr)
    result.expr = at.Ref(local(functions_[instance.function].name + "_result", type));
  return result;
}

ObjectResolver::Value ObjectResolver::VisitNode(ExprId id, const ObjectCall& call) {
  if (const ExprId clamp = OperandOf(program_, call, OperandKind::kClamp)) {
    const ExprId visited = Visit(clamp).expr;
    program_.expr_lists[OperandsOf(call, OperandKind::kClamp)][0] = visited;
  }
  for (std::uint32_t i = 0; i < call.arguments.size; ++i) {
    const ExprId argument = program_.expr_lists[call.arguments][i];
    const TypeId type = program_.exprs[argument].type;
    const std::string name = NameOf(argument);
    const Span span = program_.exprs[argument].span;
    const Value value = Visit(argument);
    ExprId made = value.expr;
    if (IsObject(type)) {
      const auto object = value.slots.find({});
      if (object == value.slots.end()) {
        ReportChoice(name, type, span);
        continue;
      }
      made = Make(object->second, span);
      // The `sampler` that reached a parameter or field is of the kind that the call reads there.
      const ObjectKind kind = program_.types[type].object;
      if (IsCombinedSampler(kind)) SetSamplerKind(program_, made, kind);
    }
    program_.expr_lists[call.arguments][i] = made;
  }
  return {id, {}};
}

ExprId ObjectResolver::Make(const ObjectPath& object, Span span) {
  Builder at(program_, span);
  ExprId path = at.Ref(object.resource);
  for (const ObjectIndex& index : object.indices) {
    path = index.expr  ? at.At(path, index.expr)
           : index.var ? at.At(path, at.Ref(index.var))
                       : at.At(path, index.literal);
  }
  return path;
}

}  // namespace clipc::resolve
