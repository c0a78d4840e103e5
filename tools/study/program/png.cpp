// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/study/program/png.h"

#include <png.h>

#include "tools/draw/gl.h"

namespace clipc::study {

void WritePng(const std::string& path, int width, int height,
              const std::vector<std::uint8_t>& rgba) {
  std::vector<std::uint8_t> rgb;
  for (std::size_t i = 0; i < rgba.size(); i += 4) {
    for (int c = 0; c < 3; ++c) rgb.push_back(rgba[i + 3] == 0 ? 255 : rgba[i + c]);
  }
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width), image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_RGB;
  if (!png_image_write_to_file(&image, path.c_str(), 0, rgb.data(), -3 * width, nullptr)) {
    throw draw::DrawError("cannot write `" + path + "`: " + image.message);
  }
}

}  // namespace clipc::study
