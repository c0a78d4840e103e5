// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/known_texts.h"

#include <utility>

#include <fmt/format.h>

#include "frontend/parse/parse.h"

namespace clipc {
namespace {

// Some hundred bytes each are kept of a token and of an expression. The last two texts are kept
// whatever the size of both is: an effect has one of vertex and one of pixel shaders.
constexpr std::size_t kMostTokens = 200'000, kMostExprs = 200'000;
constexpr std::size_t kAlwaysKept = 2, kMostTokensOfOne = 2'000'000;
constexpr std::size_t kMostBytes = std::size_t{4} << 20;

std::string KeyOf(const Plan& plan, const SourceInput& input) {
  return fmt::format("{} {} {} {}", static_cast<int>(input.stage), input.shader_model_major,
                     input.shader_model_minor, plan.check.entry_call);
}

std::string KeyOf(const std::string& glsl, const glsl::Target& target, Stage stage) {
  return fmt::format("{}\n{}\n{}", target.name(), static_cast<int>(stage), glsl);
}

}  // namespace

std::shared_ptr<KnownShader> KnownText::Check(const CheckOptions& options,
                                              Diagnostics& diagnostics) {
  std::string key = options.profile.name + '\n' + options.entry;
  for (const std::string& entry : options.planes_entries) key += '\n' + entry;
  if (const auto known = checked_.find(key); known != checked_.end()) {
    diagnostics = known->second->messages;
    return known->second;
  }
  auto shader =
      std::make_shared<KnownShader>(clipc::Check(file, options, diagnostics), diagnostics);
  exprs_ += shader->program.exprs.size();
  if (!diagnostics.has_errors() && exprs_ <= kMostExprs) checked_.emplace(std::move(key), shader);
  return shader;
}

std::shared_ptr<KnownText> KnownTexts::Get(FrontendContext& context, const ProgramRequest& request,
                                           const Plan& plan, const SourceInput& input) {
  const bool wants_tokens = request.debug.changes_result() || request.outputs.preprocess;
  // The files that a caller's function gives are not those of `context`.
  const bool is_shared = request.language.effect != 0 && !request.includes.read && !wants_tokens;
  if (!is_shared || !plan.check.profile.stage) return nullptr;
  if (effect_ != request.language.effect) *this = {};
  effect_ = request.language.effect;
  std::string key = KeyOf(plan, input);
  if (const auto known = texts_.find(key); known != texts_.end()) return known->second.text;
  auto text = std::make_shared<KnownText>(context, input, request.warnings);
  Tokens tokens = Lex(text->source, text->messages);
  if (text->messages.has_errors()) return nullptr;
  const std::size_t count = tokens.list.size();
  text->file = Parse(std::move(tokens), text->messages, FunctionBodies::kParse,
                     {.entry_call = plan.check.entry_call});
  if (text->messages.has_errors()) return nullptr;
  Keep(std::move(key), {text, count});
  return text;
}

// Keeps the text in the place of the oldest.
void KnownTexts::Keep(std::string key, Kept text) {
  if (text.tokens > kMostTokensOfOne) return;
  tokens_ += text.tokens;
  by_age_.push_back(texts_.emplace(std::move(key), std::move(text)).first);
  while (tokens_ > kMostTokens && by_age_.size() > kAlwaysKept) {
    tokens_ -= by_age_.front()->second.tokens;
    texts_.erase(by_age_.front());
    by_age_.pop_front();
  }
}

bool ValidTexts::Has(const std::string& glsl, const glsl::Target& target, Stage stage) const {
  return texts_.contains(KeyOf(glsl, target, stage));
}

void ValidTexts::Add(const std::string& glsl, const glsl::Target& target, Stage stage) {
  if (bytes_ + glsl.size() > kMostBytes) {
    texts_.clear();
    bytes_ = 0;
  }
  if (glsl.size() > kMostBytes) return;
  bytes_ += glsl.size();
  texts_.insert(KeyOf(glsl, target, stage));
}

}  // namespace clipc
