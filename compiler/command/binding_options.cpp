// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/command/binding_options.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>
#include <span>
#include <vector>

#include "backend-glsl/descriptors.h"

namespace clipc {
namespace {

using glsl::BindingRule;

constexpr std::uint32_t kMost = 1u << 20;

bool Read(std::string_view text, std::uint32_t& to) { return ReadNumber(text, to) && to < kMost; }

// dxc and glslang: without options, binding n of set m is register n of space m, of any kind.
constexpr BindingRule kDxc[] = {
    {'b', {}, {}, 0, {}}, {'s', {}, {}, 0, {}}, {'t', {}, {}, 0, {}}, {'u', {}, {}, 0, {}}};
// VulkanBindingOffsets of nvrhi.h, which ShaderMake and Slang's users of nvrhi give their compiler.
constexpr BindingRule kNvrhi[] = {
    {'t', {}, {}, 0, {}}, {'s', {}, {}, 128, {}}, {'b', {}, {}, 256, {}}, {'u', {}, {}, 384, {}}};
// SDL_CreateGPUShader: of a vertex shader, sampled textures, then storage textures, then storage
// buffers are in set 0, and uniform buffers in set 1; of a fragment shader they are in the sets 2
// and 3. SDL_CreateGPUComputePipeline: what is only read is in set 0, what is written in set 1, and
// uniform buffers are in set 2. A sampler has the number of its texture: the two are one combined
// image sampler.
constexpr BindingRule kSdl[] = {
    {'t', {}, {}, 0, 0, Stage::kVertex},  {'s', {}, {}, 0, 0, Stage::kVertex},
    {'b', {}, {}, 0, 1, Stage::kVertex},  {'t', {}, {}, 0, 2, Stage::kPixel},
    {'s', {}, {}, 0, 2, Stage::kPixel},   {'b', {}, {}, 0, 3, Stage::kPixel},
    {'t', {}, {}, 0, 0, Stage::kCompute}, {'s', {}, {}, 0, 0, Stage::kCompute},
    {'u', {}, {}, 0, 1, Stage::kCompute}, {'b', {}, {}, 0, 2, Stage::kCompute}};
constexpr Stage kSdlStages[] = {Stage::kVertex, Stage::kPixel, Stage::kCompute};

struct Preset {
  std::string_view name;
  std::span<const BindingRule> rules;
  // The host has combined image samplers, and sets for each of these stages; empty: for all alike.
  std::span<const Stage> stages = {};
};
constexpr Preset kPresets[] = {{"dxc", kDxc}, {"nvrhi", kNvrhi}, {"sdl", kSdl, kSdlStages}};

// The stage that the first of glslang's words may name.
struct StageWord {
  std::optional<Stage> stage;
  bool is_other = false;  // the stage is none of clipc's
};

// Removes the name of a stage from the front of the words.
StageWord TakeStage(std::vector<std::string_view>& words) {
  constexpr std::string_view kOther[] = {"tesc", "tese"};
  const std::string_view word = words.empty() ? "" : words[0];
  StageWord taken;
  if (!word.empty()) taken.stage = StageOfExtension(word);
  taken.is_other = std::ranges::find(kOther, word) != std::end(kOther);
  if (taken.stage || taken.is_other) words.erase(words.begin());
  return taken;
}

}  // namespace

std::vector<std::string_view> WordsIn(std::string_view text) {
  std::vector<std::string_view> words;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    words.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return words;
}

bool ReadNumber(std::string_view text, std::uint32_t& to) {
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), to);
  return problem == std::errc() && end == text.data() + text.size();
}

bool AddShift(char letter, glsl::BindingRules& rules, std::string_view value) {
  const std::vector<std::string_view> words = WordsIn(value);
  BindingRule rule{.letter = letter};
  if (words.size() != 2 || !Read(words[0], rule.binding)) return false;
  if (words[1] != "all" && !Read(words[1], rule.space.emplace())) return false;
  rules.rules.push_back(rule);
  return true;
}

bool AddKindShift(char letter, glsl::BindingRules& rules, std::string_view value) {
  std::vector<std::string_view> words = WordsIn(value);
  const StageWord stage = TakeStage(words);
  if (words.size() != 1 && (words.empty() || words.size() % 2 != 0)) return false;
  for (std::size_t i = 0; i < words.size(); i += 2) {
    BindingRule rule{.letter = letter, .stage = stage.stage};
    if (!Read(words[i], rule.binding)) return false;
    if (words.size() > 1 && !Read(words[i + 1], rule.space.emplace())) return false;
    if (!stage.is_other) rules.rules.push_back(rule);
  }
  return true;
}

bool AddRegister(glsl::BindingRules& rules, std::string_view value) {
  const std::vector<std::string_view> words = WordsIn(value);
  if (words.size() != 4 || words[0].empty() || !IsRegisterLetter(words[0][0])) return false;
  BindingRule rule{.letter = words[0][0]};
  const bool is_read = Read(words[0].substr(1), rule.number.emplace()) &&
                       Read(words[1], rule.space.emplace()) && Read(words[2], rule.binding) &&
                       Read(words[3], rule.set.emplace());
  if (is_read) rules.rules.push_back(rule);
  return is_read;
}

bool AddRegisters(glsl::BindingRules& rules, std::string_view value) {
  std::vector<std::string_view> words = WordsIn(value);
  const StageWord stage = TakeStage(words);
  if (words.size() == 1) {
    std::uint32_t set = 0;
    if (!Read(words[0], set)) return false;
    for (std::size_t of = 0; of < kStageCount; ++of) {
      if (!stage.is_other && stage.stage.value_or(static_cast<Stage>(of)) == static_cast<Stage>(of))
        rules.plain_sets[of] = set;
    }
    return true;
  }
  if (words.empty() || words.size() % 3 != 0) return false;
  for (std::size_t i = 0; i < words.size(); i += 3) {
    if (words[i].empty() || !IsRegisterLetter(words[i][0])) return false;
    BindingRule rule{.letter = words[i][0], .stage = stage.stage};
    if (!Read(words[i].substr(1), rule.number.emplace()) ||
        !Read(words[i + 1], rule.set.emplace()) || !Read(words[i + 2], rule.binding))
      return false;
    if (!stage.is_other) rules.rules.push_back(rule);
  }
  return true;
}

void JoinSamplers(glsl::BindingRules& rules) {
  std::vector<BindingRule> of_samplers = {{.letter = 's', .binding = glsl::kVulkanShiftT}};
  for (BindingRule rule : rules.rules) {
    if (rule.letter != 't') continue;
    rule.letter = 's';
    of_samplers.push_back(rule);
  }
  std::erase_if(rules.rules, [](const BindingRule& rule) { return rule.letter == 's'; });
  rules.rules.insert(rules.rules.end(), of_samplers.begin(), of_samplers.end());
  rules.combines_samplers = true;
}

bool SetGlobals(glsl::BindingRules& rules, std::string_view value) {
  const std::vector<std::string_view> words = WordsIn(value);
  ir::Descriptor& at = rules.globals.emplace();
  return words.size() == 2 && Read(words[0], at.binding) && Read(words[1], at.set);
}

bool SetUnplaced(glsl::BindingRules& rules, std::string_view value) {
  return Read(value, rules.unplaced_set.emplace());
}

bool SetLaterBase(glsl::BindingRules& rules, std::string_view value) {
  return Read(value, rules.later_base.emplace());
}

bool AddPreset(glsl::BindingRules& rules, std::string_view value) {
  const auto* found = std::ranges::find(kPresets, value, &Preset::name);
  if (found == std::end(kPresets)) return false;
  rules.rules.insert(rules.rules.end(), found->rules.begin(), found->rules.end());
  rules.combines_samplers = rules.sets_by_stage = !found->stages.empty();
  rules.stages.assign(found->stages.begin(), found->stages.end());
  rules.host = found->name;
  return true;
}

}  // namespace clipc
