// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <unordered_set>

#include "base/diagnostics.h"
#include "base/stage.h"
#include "compiler/compile/known_shader.h"
#include "compiler/compile/plan.h"
#include "compiler/compile/request.h"
#include "frontend/check/check.h"
#include "frontend/lex/source.h"
#include "frontend/parse/ast.h"
#include "ir/program.h"

// What a Compiler remembers between compiles, so that the passes of an effect, which share shaders,
// cost what their different shaders cost. It is bounded, and changes no result.
namespace clipc {

// A text of an effect that was lexed and parsed without errors.
struct KnownText {
  KnownText(FrontendContext& context, const SourceInput& input, const WarningOptions& warnings)
      : source(context, input), messages(warnings) {}

  // Returns what clipc::Check does. `options` differ from those of another call in the profile,
  // the entry and whose planes it has alone, and `diagnostics` has the `messages`.
  std::shared_ptr<KnownShader> Check(const CheckOptions& options, Diagnostics& diagnostics);

  Source source;
  Diagnostics messages;  // of lexing and parsing
  ast::File file;

 private:
  // By profile, entry and planes_entries.
  std::map<std::string, std::shared_ptr<KnownShader>> checked_;
  std::size_t exprs_ = 0;  // of all programs
};

// The texts of the last effect, by the profile and the call that they were read for.
class KnownTexts {
 public:
  // Reads the text of a shader, or finds it. Returns null where it is none of an effect or has
  // errors: it is read as every other then.
  std::shared_ptr<KnownText> Get(FrontendContext& context, const ProgramRequest& request,
                                 const Plan& plan, const SourceInput& input);

 private:
  struct Kept {
    std::shared_ptr<KnownText> text;
    std::size_t tokens = 0;
  };
  void Keep(std::string key, Kept text);

  std::uint64_t effect_ = 0;  // LanguageOptions::effect
  std::map<std::string, Kept> texts_;
  std::deque<std::map<std::string, Kept>::iterator> by_age_;  // the oldest first
  std::size_t tokens_ = 0;                                    // of all texts
};

// GLSL that glslang has found valid.
class ValidTexts {
 public:
  bool Has(const std::string& glsl, const glsl::Target& target, Stage stage) const;
  void Add(const std::string& glsl, const glsl::Target& target, Stage stage);

 private:
  std::unordered_set<std::string> texts_;
  std::size_t bytes_ = 0;
};

}  // namespace clipc
