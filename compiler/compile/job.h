// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "base/diagnostics.h"
#include "compiler/compile/known_texts.h"
#include "compiler/compile/plan.h"
#include "compiler/compile/request.h"
#include "frontend/lex/source.h"

namespace clipc {

// What the compiles of one Compiler share.
struct Shared {
  FrontendContext& context;
  KnownTexts& texts;
  ValidTexts& valid;
};

// One shader of a program and all that its way needs: what every step asks. A program is a list of
// jobs, in the order of ProgramRequest::shaders.
class Job {
 public:
  // Makes the plan of shader `number` of the request. `watch` may be null.
  Job(const Shared& shared, const ProgramRequest& request, std::size_t number, Watch* watch);

  Source& source() { return known_ ? known_->source : *source_; }
  // The meaning of a text that was read before; null if it was not.
  KnownText* known() { return known_.get(); }

  // The place of a span for messages: "water.hlsl:12:3", or the file where the span has no place.
  std::string PlaceOf(Span span);

  bool IsDump(DumpStage stage) const { return request.debug.dump == stage; }
  bool IsStopped() const { return watch && watch->stopped(); }

  const ProgramRequest& request;
  const std::string& path;  // of the file, the label in messages
  Diagnostics diagnostics;
  Plan plan;
  std::shared_ptr<KnownShader> shader;  // of a known text, once that is checked
  Watch* const watch;
  ValidTexts& valid;

 private:
  // Of the files that the caller's function gives, which Clang would find in another shader's
  // context, without their texts.
  std::unique_ptr<FrontendContext> own_context_;
  std::shared_ptr<KnownText> known_;
  std::unique_ptr<Source> source_;  // of a text that is not known
};

}  // namespace clipc
