// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "clip-table/clip_table.h"
#include "compiler/compile/stages.h"

namespace clipc {

// The clip table: what the host must know to clip with the shader that was written with `info`. It
// says where the constant of each plane lies, and its name in the GLSL.
clip_table::ClipTable MakeClipTable(const Lowered& lowered, const glsl::GlslInfo& info);

}  // namespace clipc
