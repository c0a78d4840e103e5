// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "backend-glsl/glsl_info.h"
#include "backend-glsl/target.h"
#include "backend-glsl/write_options.h"
#include "ir/program.h"

namespace clipc::glsl {

struct WrittenGlsl {
  std::string glsl;  // the whole shader
  GlslInfo info;
};
// Writes a program of one stage; program_layout.h has the others. Requires Form::kAddressed, and
// that CheckTarget reported no error. The result depends on nothing but the arguments.
WrittenGlsl WriteGlsl(const ir::Program& program, const Target& target,
                      const WriteOptions& options = {});

}  // namespace clipc::glsl
