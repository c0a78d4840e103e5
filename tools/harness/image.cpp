// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/harness/image.h"

#include <png.h>

#include "tools/harness/offscreen.h"

namespace clipc::harness {

Image Half(const Image& image) {
  Image half{image.width / 2, image.height / 2, {}};
  const auto at = [&](int x, int y, int channel) {
    return image.rgba[4 * (y * image.width + x) + channel];
  };
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      for (int c = 0; c < 4; ++c) {
        const int sum = at(2 * x, 2 * y, c) + at(2 * x + 1, 2 * y, c) + at(2 * x, 2 * y + 1, c) +
                        at(2 * x + 1, 2 * y + 1, c);
        half.rgba.push_back(static_cast<std::uint8_t>((sum + 2) / 4));
      }
    }
  }
  return half;
}

void WritePng(const std::string& path, const Image& image) {
  std::vector<std::uint8_t> rgb;
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    if (i % 4 != 3) rgb.push_back(image.rgba[i]);
  }
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGB;
  if (!png_image_write_to_file(&png, path.c_str(), 0, rgb.data(), 0, nullptr))
    throw DrawError("cannot write `" + path + "`: " + png.message);
}

}  // namespace clipc::harness
