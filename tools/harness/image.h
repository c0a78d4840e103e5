// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace clipc::harness {

// An image of four bytes for each pixel, red, green, blue and alpha; the top row first.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

// The image at half its width and height, each pixel the mean of four: an image that was drawn
// too large gets smooth edges.
Image Half(const Image& image);

// Writes red, green and blue. Throws DrawError when the file cannot be written.
void WritePng(const std::string& path, const Image& image);

}  // namespace clipc::harness
