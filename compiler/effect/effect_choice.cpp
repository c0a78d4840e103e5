// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/effect/effect_choice.h"

#include <algorithm>
#include <map>
#include <ranges>

namespace clipc {
namespace {

// The place of a stage's value in the list; none: the stage has no value.
std::optional<std::size_t> PlaceOf(const StageIndex& stage, const EffectChoice& choice) {
  if (stage.text.empty()) return std::nullopt;
  const auto found = std::ranges::find(choice.values, stage.text, &EffectChoice::Value::text);
  return static_cast<std::size_t>(found - choice.values.begin());
}

EffectChoice ValuesOf(std::span<const StageIndex> stages) {
  EffectChoice choice;
  for (const StageIndex& stage : stages) {
    const std::optional<std::size_t> place = PlaceOf(stage, choice);
    if (!place) continue;
    if (*place == choice.values.size()) choice.values.push_back({stage.text, 0});
    std::size_t& count = choice.values[*place].count;
    count =
        std::max(count, stage.tables.empty() ? stage.elements.size() : stage.tables.back()->size());
  }
  return choice;
}

}  // namespace

std::optional<std::size_t> ElementOf(const StageIndex& stage, std::size_t value) {
  for (const std::vector<std::int64_t>* table : stage.tables | std::views::reverse) {
    if (value >= table->size() || (*table)[value] < 0) return std::nullopt;
    value = static_cast<std::size_t>((*table)[value]);
  }
  return value < stage.elements.size() ? std::optional(value) : std::nullopt;
}

std::optional<ChosenPrograms> ChoosePrograms(std::span<const StageIndex> stages, std::size_t most) {
  ChosenPrograms chosen;
  EffectChoice& choice = chosen.choice;
  choice = ValuesOf(stages);
  std::size_t count = 1;
  for (const EffectChoice::Value& value : choice.values) {
    if (value.count == 0 || value.count > most / count) return std::nullopt;
    count *= value.count;
  }
  std::map<std::vector<std::size_t>, std::size_t> known;
  std::vector<std::size_t> values(choice.values.size());
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t rest = i;
    for (std::size_t k = values.size(); k-- > 0; rest /= choice.values[k].count)
      values[k] = rest % choice.values[k].count;
    std::vector<std::size_t> elements;
    bool is_inside = true, has_shader = false;
    for (std::size_t k = 0; k < stages.size(); ++k) {
      const std::optional<std::size_t> place = PlaceOf(stages[k], choice);
      const auto element = place ? ElementOf(stages[k], values[*place]) : std::optional<size_t>(0);
      if (!element && !chosen.outside)
        chosen.outside = {k, choice.values[*place].text, values[*place]};
      is_inside = is_inside && element;
      if (!is_inside) break;
      has_shader = has_shader || stages[k].elements[*element];
      elements.push_back(*element);
    }
    std::optional<std::size_t>& program = choice.programs.emplace_back();
    if (!is_inside || !has_shader) continue;
    const auto [at, is_new] = known.try_emplace(elements, chosen.programs.size());
    if (is_new) chosen.programs.push_back(std::move(elements));
    program = at->second;
  }
  if (choice.values.empty()) choice.programs.clear();
  return chosen;
}

}  // namespace clipc
