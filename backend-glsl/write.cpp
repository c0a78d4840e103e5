// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/write.h"

#include <utility>

#include "backend-glsl/writer/stage_writer.h"

namespace clipc::glsl {

WrittenGlsl WriteGlsl(const ir::Program& program, const Target& target,
                      const WriteOptions& options) {
  StageWriter writer(program, target, options);
  return {writer.Finish({}), std::move(writer.info())};
}

}  // namespace clipc::glsl
