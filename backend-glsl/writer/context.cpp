// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/context.h"

#include <utility>

#include "backend-glsl/needs.h"

namespace clipc::glsl {

Context::Context(const ir::Program& program, const Target& target, const WriteOptions& options,
                 GlslInfo& info, Reached reached)
    : program(program),
      types(program.types),
      target(target),
      options(options),
      info(info),
      reached(std::move(reached)),
      layouts(program.cbuffers.size()),
      used_structs(types.structs().size()) {
  for (std::string* part : {&sections.structs, &sections.blocks, &sections.inputs,
                            &sections.outputs, &sections.functions})
    part->reserve(1024);
  for (const ir::CbufferId id : program.cbuffers.ids()) {
    if (this->reached.Has(id))
      layouts[id.index] = LayOutBlock(program, (*this)[id], target, options.blocks);
  }
}

void Context::RequireType(const ir::Type& type) {
  if (!type.IsNumeric()) return;
  if (const Need* need = NeedOf(BaseOf(type.scalar))) Require(need->feature);
}

}  // namespace clipc::glsl
