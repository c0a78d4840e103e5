// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>

#include "frontend/resolve/object_resolver.h"
#include "ir/access.h"

namespace clipc::resolve {

// The variable and the part of it that a path names; nullopt if an index of the path is not known.
std::optional<std::pair<VarId, SlotPath>> ObjectResolver::PlaceOf(ExprId expr) const {
  SlotPath path;
  while (true) {
    if (const auto* ref = As<VarRef>(program_, expr)) {
      const bool is_static = program_.vars[ref->var].storage == Storage::kStatic;
      if (!is_static && !frame_->slots.contains(ref->var)) return std::nullopt;
      std::ranges::reverse(path);
      return std::pair{ref->var, path};
    }
    if (const auto* field = As<FieldRef>(program_, expr)) {
      path.push_back(field->field);
      expr = field->base;
      continue;
    }
    const auto* index = As<Index>(program_, expr);
    const auto* literal = index ? As<Literal>(program_, index->index) : nullptr;
    if (!literal) return std::nullopt;
    path.push_back(static_cast<std::uint32_t>(literal->bits));
    expr = index->base;
  }
}

// Notes that the part of the variable holds these objects from here on. If that is not so on all
// paths, it is an error, unless the part holds these objects already. A static variable holds the
// objects that it gets first, which are globals, in all functions.
void ObjectResolver::Bind(VarId var, const SlotPath& place, Slots slots, Span span) {
  const bool is_static = program_.vars[var].storage == Storage::kStatic;
  Slots& held = is_static ? globals_[var] : frame_->slots[var];
  Slots added;
  for (const auto& [path, object] : slots) {
    if (is_static && !object.IsKnown())
      return ReportChoice(program_.vars[var].name, program_.vars[var].type, span);
  }
  for (auto& [path, object] : slots) {
    SlotPath whole = place;
    whole.insert(whole.end(), path.begin(), path.end());
    Keep(var, whole, object, span);
    added[whole] = std::move(object);
  }
  const bool is_certain = !is_static && frame_->depth == frame_->depths[var];
  for (const auto& [path, object] : added) {
    const auto found = held.find(path);
    if (!is_certain && found != held.end() && found->second != object) {
      return ReportChoice(program_.vars[var].name, program_.vars[var].type, span);
    }
  }
  if (is_certain) {
    std::erase_if(held, [&](const auto& slot) { return StartsWith(slot.first, place); });
  }
  for (auto& [path, object] : added) held[path] = std::move(object);
}

// Stores the indices that are known only at run time in variables beside the object.
void ObjectResolver::Keep(VarId var, const SlotPath& path, ObjectPath& object, Span span) {
  for (std::size_t i = 0; i < object.indices.size(); ++i) {
    ObjectIndex& index = object.indices[i];
    if (index.IsLiteral()) continue;
    const TypeId type = program_.types.Make(TypeOf(index));
    Builder at(program_, span);
    VarId& companion = frame_->companions[{var, path, i}];
    if (!companion) {
      companion = at.Local(program_.vars[var].name + "_index", type);
      frame_->declarations.push_back(at.Stmt(Declare{companion, {}}));
    }
    Store(companion, index, span);
  }
}

// Puts an index that is known only at run time into the variable, which takes its place.
void ObjectResolver::Store(VarId var, ObjectIndex& index, Span span) {
  Builder at(program_, span);
  const ExprId value = index.expr ? index.expr : at.Ref(index.var);
  const Scalar kind = program_.types[program_.vars[var].type].scalar;
  Before(at.AssignTo(at.Ref(var), at.ConvertTo(kind, value)), span);
  index = {0, var, {}};
}

// Makes the expression run before the current statement. A call has the number of a new function,
// which IsPure does not know.
void ObjectResolver::Before(ExprId expr, Span span) {
  const bool calls =
      AnyExpr(program_, expr, [&](ExprId part) { return As<Call>(program_, part) != nullptr; });
  if (!calls && IsPure(program_, expr)) return;
  if (frame_ == nullptr || !frame_->may_emit) {
    diagnostics_.Report(span, diag::Unsupported, "choosing an object in the condition of a loop");
    return;
  }
  frame_->before.push_back(Builder(program_, span).Eval(expr));
}

std::string ObjectResolver::NameOf(ExprId expr) const {
  while (true) {
    if (const auto* ref = As<VarRef>(program_, expr)) return program_.vars[ref->var].name;
    if (const auto* field = As<FieldRef>(program_, expr)) {
      return NameOf(field->base) + "." +
             program_.types.StructOf(program_.exprs[field->base].type).fields[field->field].name;
    }
    const auto* index = As<Index>(program_, expr);
    if (!index) return "this";
    expr = index->base;
  }
}

void ObjectResolver::ReportChoice(const std::string& name, TypeId type, Span span) {
  diagnostics_.Report(span, diag::ObjectNotGlobal, name, program_.types.Name(type));
}

}  // namespace clipc::resolve
