// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace clipc::study {

// Four bytes for each pixel, the bottom row first, as OpenGL reads them; drawn over white. Throws
// DrawError.
void WritePng(const std::string& path, int width, int height,
              const std::vector<std::uint8_t>& rgba);

}  // namespace clipc::study
