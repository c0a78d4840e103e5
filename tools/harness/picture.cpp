// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/harness/picture.h"

#include <png.h>

#include "tools/harness/offscreen.h"

namespace clipc::harness {

Picture Half(const Picture& picture) {
  Picture half{picture.width / 2, picture.height / 2, {}};
  const auto at = [&](int x, int y, int channel) {
    return picture.rgba[4 * (y * picture.width + x) + channel];
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

void WritePng(const std::string& path, const Picture& picture) {
  std::vector<std::uint8_t> rgb;
  for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
    if (i % 4 != 3) rgb.push_back(picture.rgba[i]);
  }
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width);
  image.height = static_cast<png_uint_32>(picture.height);
  image.format = PNG_FORMAT_RGB;
  if (!png_image_write_to_file(&image, path.c_str(), 0, rgb.data(), 0, nullptr))
    throw DrawError("cannot write `" + path + "`: " + image.message);
}

}  // namespace clipc::harness
