// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>

#include "tools/random/expr.h"

namespace clipc::random {
namespace {

bool HasKind(const Structs& structs, const Type& type, Kind kind) {
  if (type.structure < 0) return type.kind == kind;
  return std::ranges::any_of(structs[type.structure].fields, [&](const Field& field) {
    return HasKind(structs, field.type, kind);
  });
}

// Walks into arrays and structs until a numeric value of the kind is there.
std::string Descend(Context& context, std::string text, Type& type, Kind kind, int depth) {
  while (!type.IsNumeric()) {
    if (type.IsArray()) {
      text += "[" + MakeIndex(context, type.sizes[0], depth).text + "]";
      type = type.Element();
      continue;
    }
    std::vector<const Field*> fields;
    for (const Field& field : context.structs[type.structure].fields) {
      if (HasKind(context.structs, field.type, kind)) fields.push_back(&field);
    }
    const Field* field = context.OneOf(fields);
    text += "." + field->name;
    type = field->type;
  }
  return text;
}

// Chooses `count` different numbers from 0 to `from` - 1.
std::vector<int> Components(Context& context, int from, int count) {
  std::vector<int> all, chosen;
  for (int i = 0; i < from; ++i) all.push_back(i);
  for (int i = 0; i < count; ++i) {
    const std::uint32_t index = context.Below(all.size());
    chosen.push_back(all[index]);
    all.erase(all.begin() + index);
  }
  return chosen;
}

// The weight of an index among the parts of a vector or matrix.
std::uint32_t Often(const Context& context, int depth) {
  return context.indices == Indices::kWriting && depth > 0 ? 4 : 1;
}

void TakeComponents(Context& context, Place& place, int depth) {
  if (place.shape.columns == 1) return;
  switch (context.Pick({3, 2, Often(context, depth)})) {
    case 0: return;
    case 1: {
      const int count = context.Between(1, place.shape.columns);
      const char* letters = context.Chance(20) ? "rgba" : "xyzw";
      place.text += ".";
      for (const int i : Components(context, place.shape.columns, count)) place.text += letters[i];
      place.shape = {0, count};
      return;
    }
    default:
      place.text += "[" + MakeIndex(context, place.shape.columns, depth).text + "]";
      place.shape = kScalar;
  }
}

void TakePart(Context& context, Place& place, int depth) {
  if (!place.shape.IsMatrix()) return TakeComponents(context, place, depth);
  switch (context.Pick({3, 3 * Often(context, depth), 2})) {
    case 0: return;
    case 1:
      place.text += "[" + MakeIndex(context, place.shape.rows, depth).text + "]";
      place.shape = {0, place.shape.columns};
      return TakeComponents(context, place, depth);
    default: {
      const int most = std::min(place.shape.Components(), 4);
      const int count = context.Between(1, most);
      const bool from_one = context.Chance(40);
      place.text += ".";
      for (const int i : Components(context, place.shape.Components(), count)) {
        const int row = i / place.shape.columns, column = i % place.shape.columns;
        place.text += from_one ? "_" + std::to_string(row + 1) + std::to_string(column + 1)
                               : "_m" + std::to_string(row) + std::to_string(column);
      }
      place.shape = {0, count};
    }
  }
}

// The parts of a variable that have a type, as text; indices are constants.
void Collect(Context& context, const std::string& text, const Type& type, const Type& wanted,
             std::vector<std::string>& found) {
  if (type == wanted) found.push_back(text);
  if (type.IsArray()) {
    const int element = context.Between(0, type.sizes[0] - 1);
    Collect(context, text + "[" + std::to_string(element) + "]", type.Element(), wanted, found);
  } else if (type.IsStruct()) {
    for (const Field& field : context.structs[type.structure].fields)
      Collect(context, text + "." + field.name, field.type, wanted, found);
  }
}

bool IsGlobal(const Context& context, const Variable* variable) {
  const auto& globals = context.scopes[0];
  return std::ranges::any_of(globals, [&](const Variable& global) { return &global == variable; });
}

}  // namespace

Place MakePlace(Context& context, Kind kind, bool writes, int depth) {
  std::vector<const Variable*> candidates;
  for (const Variable* variable : context.Visible()) {
    if ((!writes || variable->writable) && context.MayUse(*variable, writes) &&
        HasKind(context.structs, variable->type, kind))
      candidates.push_back(variable);
  }
  if (candidates.empty()) return {};
  const Variable* variable = context.OneOf(candidates);
  Type type = variable->type;
  Place place;
  const Range range = RangeOf(*variable, kind);
  context.Use(*variable, writes);
  if (writes && IsGlobal(context, variable)) context.writes_globals = true;
  // The index is made before the name is used: it may declare nothing, so the pointer stays valid.
  place.text = Descend(context, variable->name, type, kind, depth - 1);
  place.kind = type.kind;
  place.shape = type.shape;
  place.range = range;
  place.found = true;
  TakePart(context, place, depth - 1);
  return place;
}

Place MakePlaceOf(Context& context, const Type& type, bool writes) {
  std::vector<std::string> found;
  std::vector<const Variable*> owners;
  for (const Variable* variable : context.Visible()) {
    if (writes && (!variable->writable || variable->holds != Holds::kVariable)) continue;
    if (variable->holds == Holds::kWild || variable->holds == Holds::kCounter) continue;
    if (std::ranges::find(context.taken, variable->name) != context.taken.end()) continue;
    if (!context.MayUse(*variable, writes)) continue;
    Collect(context, variable->name, variable->type, type, found);
    owners.resize(found.size(), variable);
  }
  if (found.empty()) return {};
  const std::uint32_t index = context.Below(found.size());
  context.Use(*owners[index], writes);
  Place place;
  place.text = found[index];
  place.kind = type.kind;
  place.shape = type.shape;
  place.range = VariableRange(type.kind);
  place.found = true;
  if (writes) context.writes_globals = true;
  return place;
}

std::string MakeReadOf(Context& context, const Type& type) {
  const Place place = MakePlaceOf(context, type, false);
  return place.found ? place.text : Zero(context.structs, type);
}

bool MayCompound(const Context& context, const Place& place) {
  return context.Has(Feature::kComputedSwizzles) || place.text.find("._") == std::string::npos;
}

}  // namespace clipc::random
