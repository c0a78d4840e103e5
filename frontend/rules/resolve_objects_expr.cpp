// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>

#include "frontend/rules/object_resolver.h"
#include "ir/walk.h"

namespace clipc {

ObjectResolver::Value ObjectResolver::Visit(ir::ExprId id) {
  const auto& node = program_.exprs[id].node;
  if (const auto* ref = std::get_if<ir::VarRef>(&node)) return VisitVar(id, ref->var);
  if (std::holds_alternative<ir::FieldRef>(node)) return VisitField(id);
  if (std::holds_alternative<ir::Index>(node)) return VisitIndex(id);
  if (std::holds_alternative<ir::Assign>(node)) return VisitAssign(id);
  if (std::holds_alternative<ir::Comma>(node)) return VisitComma(id);
  if (std::holds_alternative<ir::Construct>(node)) return VisitConstruct(id);
  if (std::holds_alternative<ir::Call>(node)) return VisitCall(id);
  if (std::holds_alternative<ir::ObjectCall>(node)) return VisitObjectCall(id);
  const ir::TypeId type = program_.exprs[id].type;
  if (Holds(type)) {
    if (const auto* choice = std::get_if<ir::Conditional>(&node))
      return VisitChoice(id, choice->when_true, choice->when_false);
    if (IsObject(type)) return {};
  }
  ir::MapOperands(program_, id, [&](ir::ExprId operand) { return Visit(operand).expr; });
  return {id, {}};
}

ObjectResolver::Value ObjectResolver::VisitVar(ir::ExprId id, ir::VarId var) {
  const ir::TypeId type = program_.vars[var].type;
  if (!Holds(type)) return {id, {}};
  Value value{IsObject(type) ? ir::ExprId{} : id, {}};
  if (program_.vars[var].storage == ir::Storage::kResource) {
    value.slots[{}] = {var, {}};
  } else if (const auto global = globals_.find(var); global != globals_.end()) {
    value.slots = global->second;
  } else if (frame_ != nullptr) {
    value.slots = frame_->slots[var];
  }
  return value;
}

ObjectResolver::Value ObjectResolver::VisitField(ir::ExprId id) {
  const auto field = std::get<ir::FieldRef>(program_.exprs[id].node);
  const ir::StructId structure = program_.types[program_.exprs[field.base].type].structure;
  const Value base = Visit(field.base);
  const std::uint32_t number = field_numbers_[structure.index][field.field];
  Value value{number == ~0u ? ir::ExprId{} : id, Inside(base.slots, field.field)};
  program_.exprs[id].node = ir::FieldRef{base.expr, number};
  return value;
}

ObjectResolver::Value ObjectResolver::VisitIndex(ir::ExprId id) {
  const auto node = std::get<ir::Index>(program_.exprs[id].node);
  const ir::Type array = program_.types[program_.exprs[node.base].type];
  const Value base = Visit(node.base);
  const ir::ExprId index = Visit(node.index).expr;
  const bool is_object = IsObject(program_.exprs[id].type);
  program_.exprs[id].node = ir::Index{base.expr, index};
  Value value{is_object ? ir::ExprId{} : id, {}};
  if (base.slots.empty()) return value;
  if (const auto* literal = std::get_if<ir::Literal>(&program_.exprs[index].node)) {
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

ObjectResolver::Value ObjectResolver::VisitAssign(ir::ExprId id) {
  const auto node = std::get<ir::Assign>(program_.exprs[id].node);
  const ir::TypeId type = program_.exprs[id].type;
  const Span span = program_.exprs[id].span;
  const auto place = Holds(type) ? PlaceOf(node.target) : std::nullopt;
  const std::string name = place || !Holds(type) ? "" : NameOf(node.target);
  const ir::ExprId target = Visit(node.target).expr;
  Value value = Visit(node.value);
  program_.exprs[id].node = ir::Assign{node.op, target, value.expr};
  if (!Holds(type)) return {id, {}};
  if (!place) {
    ReportChoice(name, type, span);
    return {id, {}};
  }
  Bind(place->first, place->second, value.slots, span);
  Value result{IsObject(type) ? ir::ExprId{} : id, {}};
  for (const auto& [path, object] : frame_->slots[place->first]) {
    if (StartsWith(path, place->second)) {
      result.slots[SlotPath(path.begin() + static_cast<std::ptrdiff_t>(place->second.size()),
                            path.end())] = object;
    }
  }
  return result;
}

ObjectResolver::Value ObjectResolver::VisitComma(ir::ExprId id) {
  const auto node = std::get<ir::Comma>(program_.exprs[id].node);
  const ir::ExprId first = Visit(node.first).expr;
  Value second = Visit(node.second);
  if (!first) return second;
  if (!second.expr) {
    Before(first, program_.exprs[id].span);
    return second;
  }
  program_.exprs[id].node = ir::Comma{first, second.expr};
  return {id, std::move(second.slots)};
}

ObjectResolver::Value ObjectResolver::VisitConstruct(ir::ExprId id) {
  const auto node = std::get<ir::Construct>(program_.exprs[id].node);
  Value value{IsObject(program_.exprs[id].type) ? ir::ExprId{} : id, {}};
  std::vector<ir::ExprId> arguments;
  for (std::uint32_t i = 0; i < node.arguments.size; ++i) {
    const Value part = Visit(program_.expr_lists[node.arguments][i]);
    AddUnder(value.slots, i, part.slots);
    if (part.expr) arguments.push_back(part.expr);
  }
  program_.exprs[id].node = ir::Construct{program_.expr_lists.Add(arguments)};
  return value;
}

ObjectResolver::Value ObjectResolver::VisitChoice(ir::ExprId id, ir::ExprId when_true,
                                                  ir::ExprId when_false) {
  const ir::TypeId type = program_.exprs[id].type;
  const ir::ExprId condition =
      Visit(std::get<ir::Conditional>(program_.exprs[id].node).condition).expr;
  const Value yes = Visit(when_true), no = Visit(when_false);
  if (yes.slots != no.slots) {
    ReportChoice("?:", type, program_.exprs[id].span);
    return {id, {}};
  }
  program_.exprs[id].node = ir::Conditional{condition, yes.expr, no.expr};
  return {IsObject(type) ? ir::ExprId{} : id, yes.slots};
}

ObjectResolver::Value ObjectResolver::VisitCall(ir::ExprId id) {
  const auto call = std::get<ir::Call>(program_.exprs[id].node);
  const Span span = program_.exprs[id].span;
  const ir::Function callee = program_.functions[call.function];
  std::vector<ir::ExprId> kept;
  std::vector<Slots> slots;
  std::vector<std::optional<std::pair<ir::VarId, SlotPath>>> places;
  for (std::uint32_t i = 0; i < call.arguments.size; ++i) {
    const ir::ExprId argument = program_.expr_lists[call.arguments][i];
    const ir::Var& parameter = program_.vars[callee.parameters[i]];
    const bool is_bound = parameter.storage != ir::Storage::kIn && Holds(parameter.type);
    places.push_back(is_bound ? PlaceOf(argument) : std::nullopt);
    Value value = Visit(argument);
    if (value.expr) kept.push_back(value.expr);
    slots.push_back(std::move(value.slots));
  }
  if (!SignatureHolds(callee)) {
    const ir::FunctionId function = InPlace(call.function);
    program_.exprs[id].node = ir::Call{function, program_.expr_lists.Add(kept)};
    return {id, {}};
  }
  const Instance* instance = InstanceFor(call.function, slots, kept, span);
  if (!instance) return {id, {}};
  program_.exprs[id].node = ir::Call{instance->function, program_.expr_lists.Add(kept)};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const ir::Var& parameter = program_.vars[callee.parameters[i]];
    if (parameter.storage == ir::Storage::kIn || !Holds(parameter.type)) continue;
    const bool is_known = std::ranges::all_of(
        instance->outs[i], [](const auto& slot) { return slot.second.IsKnown(); });
    // An inout parameter that comes back unchanged binds nothing.
    if (parameter.storage == ir::Storage::kInOut && instance->outs[i] == instance->ins[i]) continue;
    if (!places[i] || !is_known) {
      ReportChoice(parameter.name, parameter.type, span);
    } else {
      Bind(places[i]->first, places[i]->second, instance->outs[i], span);
    }
  }
  if (!IsObject(callee.return_type)) return {id, instance->result};
  program_.exprs[id].type = program_.types.Void();
  if (!IsReturnOnly(instance->function)) Before(id, span);
  return {{}, instance->result};
}

ObjectResolver::Value ObjectResolver::VisitObjectCall(ir::ExprId id) {
  const auto call = std::get<ir::ObjectCall>(program_.exprs[id].node);
  for (std::uint32_t i = 0; i < call.arguments.size; ++i) {
    const ir::ExprId argument = program_.expr_lists[call.arguments][i];
    const ir::TypeId type = program_.exprs[argument].type;
    const std::string name = NameOf(argument);
    const Span span = program_.exprs[argument].span;
    const Value value = Visit(argument);
    ir::ExprId made = value.expr;
    if (IsObject(type)) {
      const auto object = value.slots.find({});
      if (object == value.slots.end()) {
        ReportChoice(name, type, span);
        continue;
      }
      made = Make(object->second, span);
    }
    program_.expr_lists[call.arguments][i] = made;
  }
  return {id, {}};
}

ir::ExprId ObjectResolver::Make(const ObjectPath& object, Span span) {
  ir::Builder at(program_, span);
  ir::ExprId path = at.Ref(object.resource);
  for (const ObjectIndex& index : object.indices) {
    path = index.expr  ? at.At(path, index.expr)
           : index.var ? at.At(path, at.Ref(index.var))
                       : at.At(path, index.literal);
  }
  return path;
}

}  // namespace clipc
