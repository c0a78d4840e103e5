// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <memory>
#include <string>

#include "compiler/compile/request.h"
#include "compiler/compile/result.h"
#include "frontend/lex/source.h"

// clipc as a library: the HLSL shaders of a program in, GLSL and what the host must know out.
namespace clipc {

// A compiler of many programs that keeps the data that they share. Use one per thread. Compile
// throws nothing, whatever the request is; the same request gives the same result, byte for byte.
class Compiler {
 public:
  Compiler();
  ~Compiler();
  Compiler(const Compiler&) = delete;
  Compiler& operator=(const Compiler&) = delete;

  CompileResult Compile(const ProgramRequest& request);

 private:
  FrontendContext& ContextFor(const ProgramRequest& request);

  struct Memory;  // known_texts.h

  FrontendContext context_;
  std::unique_ptr<FrontendContext> sandboxed_;  // for requests with `sandbox_`
  std::string sandbox_;
  std::unique_ptr<Memory> memory_;  // refers to the contexts
};

// Compiles one program. May be called on several threads at once.
CompileResult Compile(const ProgramRequest& request);

}  // namespace clipc
