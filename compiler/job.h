// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "base/diagnostics.h"
#include "compiler/known_texts.h"
#include "compiler/plan.h"
#include "compiler/request.h"
#include "frontend/lex/source.h"

namespace clipc {

// A plan that runs: what every step of it asks.
struct Job {
  const CompileRequest& request;
  const Plan& plan;
  Source& source;
  Diagnostics& diagnostics;
  Watch* watch;
  ValidTexts& valid;
  KnownText* known = nullptr;  // the text, if it was read before

  bool IsDump(DumpStage stage) const { return request.debug.dump == stage; }
  bool IsStopped() const { return watch && watch->stopped(); }
};

}  // namespace clipc
