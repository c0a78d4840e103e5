// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <cstdio>
#include <cstring>

#include <clipc/runtime/table.h>

#include "water.clip.h"
#include "water.shader.h"

int main() {
  const auto table = clipc::runtime::ReadTable(water_clip_table);
  if (!table.ok() || std::strstr(water_vert, "gl_ClipDistance[0]") == nullptr) return 1;
  std::printf("plane at byte %u\n", table.value.planes[0].byte_offset);
  return 0;
}
