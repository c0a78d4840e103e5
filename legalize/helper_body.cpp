// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "legalize/helper_body.h"

#include <string>

namespace clipc::legalize {

HelperBody::HelperBody(ir::Program& program, std::span<const Parameter> wanted)
    : program(program), b(program) {
  for (const Parameter& parameter : wanted) {
    const ir::VarId var = b.Local(std::string(parameter.name), parameter.type);
    program.vars[var].storage = parameter.storage;
    parameters.push_back(var);
  }
}

}  // namespace clipc::legalize
