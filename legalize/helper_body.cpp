// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "legalize/helper_body.h"

#include <string>
#include <utility>

namespace clipc::legalize {

HelperBody::HelperBody(ir::Program& program, std::span<const Parameter> wanted)
    : program(program), b(program) {
  for (const Parameter& parameter : wanted) {
    const ir::VarId var = b.Local(std::string(parameter.name), parameter.type);
    program.vars[var].storage = parameter.storage;
    parameters.push_back(var);
  }
}

ir::FunctionId AddHelper(ir::Program& program, std::string_view name,
                         std::span<const Parameter> parameters, ir::TypeId result,
                         const Define& define) {
  HelperBody body(program, parameters);
  define(body);
  return program.functions.Add({.name = std::string(name),
                                .return_type = result,
                                .parameters = std::move(body.parameters),
                                .body = body.b.BlockOf(body.statements),
                                .span = {},
                                .is_helper = true,
                                .remark = body.remark});
}

}  // namespace clipc::legalize
