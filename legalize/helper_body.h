// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "ir/builder.h"
#include "ir/program.h"

namespace clipc::legalize {

// A parameter of a helper function.
struct Parameter {
  std::string_view name;
  ir::TypeId type;
  ir::Storage storage = ir::Storage::kIn;
};

// The body of a helper function that is being defined.
class HelperBody {
 public:
  HelperBody(ir::Program& program, std::span<const Parameter> parameters);

  ir::Program& program;
  ir::Builder b;
  // A new reference to parameter `i`.
  ir::ExprId operator[](std::size_t i) { return b.Ref(parameters[i]); }
  void Add(ir::StmtId stmt) { statements.push_back(stmt); }
  void Do(ir::ExprId expr) { Add(b.Eval(expr)); }
  void Return(ir::ExprId value) { Add(b.Stmt(ir::Return{value})); }

  std::vector<ir::VarId> parameters;
  std::vector<ir::StmtId> statements;
  std::string_view remark;  // Function::remark
};

// Adds a helper function to the program; `define` writes its body.
using Define = std::function<void(HelperBody&)>;
ir::FunctionId AddHelper(ir::Program& program, std::string_view name,
                         std::span<const Parameter> parameters, ir::TypeId result,
                         const Define& define);

}  // namespace clipc::legalize
