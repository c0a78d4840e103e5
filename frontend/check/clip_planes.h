// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "base/diagnostics.h"
#include "frontend/parse/ast.h"
#include "ir/program.h"

// The rules of [clipplanes(...)]: design/clipplanes.md's two tables, each row with its own message.
namespace clipc {

// Whether an attribute's name is, or was meant to be, `clipplanes` (case does not matter).
enum class ClipPlaneSpelling { kNo, kExact, kMisspelt };
ClipPlaneSpelling SpellsClipPlanes(std::string_view attribute_name);

// Checks the clip plane attributes of the entry point and fills program.clip_planes. `prototypes`
// are the attributes of earlier prototypes of the function. Requires program.outputs (BuildMain
// ran) and laid out cbuffers. `check` turns an operand into IR (reporting its errors); it returns
// none after an error.
struct ClipPlaneContext {
  const ast::File& file;
  std::span<const ast::Attr> attributes;
  std::vector<std::span<const ast::Attr>> prototypes;
  std::function<ir::ExprId(ast::ExprId)> check;
  std::function<std::string(ast::ExprId)> text;  // the operand as written
  bool whole_registers_only =
      false;  // for Direct3D 9's SetClipPlane: level_9_x profiles, or the level9 lowering
};
void CheckClipPlanes(ir::Program& program, const ClipPlaneContext& context,
                     Diagnostics& diagnostics);

// For every function that is not the entry point: X3588 for a clip plane attribute there, an error
// for a misspelt one.
void CheckUnusedClipPlanes(const ast::File& file, const ast::FunctionDecl& function,
                           Diagnostics& diagnostics);

}  // namespace clipc
