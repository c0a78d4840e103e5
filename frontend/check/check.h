// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>

#include "base/diagnostics.h"
#include "frontend/parse/ast.h"
#include "ir/profile.h"
#include "ir/program.h"

namespace clipc {

// How matrices lie in memory where neither a qualifier nor #pragma pack_matrix says so: -Zpc (the
// default), -Zpr.
enum class MatrixPacking : std::uint8_t { kColumnMajor, kRowMajor };

struct CheckOptions {
  ir::Profile profile;
  std::string entry = "main";  // may be qualified: "NS::main"
  MatrixPacking packing = MatrixPacking::kColumnMajor;
  bool whole_register_planes =
      false;  // clip planes go to SetClipPlane (the level9 lowering): X4594 on anything less
};

// Resolves names, types and overloads of everything the entry point reaches and returns what it
// means, in Form::kTyped. Every error about the shader is reported here (the parser's aside); the
// program is only meaningful when `diagnostics` has no errors afterwards. Bodies of functions that
// the entry point does not reach are not looked at, so pixel shaders and other stages may stand in
// the same file.
ir::Program Check(const ast::File& file, const CheckOptions& options, Diagnostics& diagnostics);

}  // namespace clipc
