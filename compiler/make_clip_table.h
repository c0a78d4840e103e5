// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "backend-glsl/writer.h"
#include "clip-table/clip_table.h"
#include "ir/program.h"

namespace clipc {

// What the host must know to clip with `program`: where each plane's constant lies, and its name in
// the GLSL.
clip_table::ClipTable MakeClipTable(const ir::Program& program, Lowering lowering, PlaneSpace space,
                                    const glsl::GlslInfo& info);

}  // namespace clipc
