// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/images.h"

#include <algorithm>
#include <cstring>

#include "ir/scalar.h"
#include "tools/draw/textures.h"

namespace clipc::draw {
namespace {

using namespace ir;

constexpr std::size_t kTexelWords = 4;

// The size along the axes, and then of an array the number of its elements. The tests have up to
// 256 vertices or pixels, each with a texel of its own.
struct Extent {
  std::array<std::uint32_t, 3> size{1, 1, 1};
  std::size_t count = 1;  // of the numbers in `size` that a place has

  std::size_t Texels() const { return std::size_t{size[0]} * size[1] * size[2]; }
};

Extent ExtentOf(const ObjectInfo& form) {
  Extent extent;
  if (form.axes < 2) {
    extent.size[0] = 256;
  } else {
    extent = {{16, 17, form.axes > 2 ? 5u : 1u}, form.axes};
  }
  if (form.is_array) extent.size[extent.count++] = 5;
  return extent;
}

std::uint32_t& WordAt(Buffer& texels, std::size_t word) {
  return reinterpret_cast<std::uint32_t*>(texels.data())[word];
}

}  // namespace

Buffer MakeImage(const Program& program, VarId image, RandomValues& values) {
  const Extent extent = ExtentOf(InfoOf(ObjectTypeOf(program, image).object));
  Buffer texels(4 * kTexelWords * extent.Texels());
  for (std::size_t i = 0; i < kTexelWords * extent.Texels(); ++i)
    WordAt(texels, i) = static_cast<std::uint32_t>(values.Next(ElementKind(program, image)));
  return texels;
}

void UseImage(const Program& program, Buffer& texels, const ObjectRequest& request,
              double undefined, std::span<std::uint64_t> result) {
  const Extent extent = ExtentOf(InfoOf(ObjectTypeOf(program, request.object).object));
  if (request.op == ObjectOp::kTextureSize || request.op == ObjectOp::kBufferSize) {
    std::copy_n(extent.size.begin(), result.size(), result.begin());
    return;
  }
  const Scalar kind = ElementKind(program, request.object);
  std::size_t texel = 0, stride = 1;
  bool is_inside = !texels.empty();
  for (std::size_t i = 0; i < extent.count; ++i) {
    const std::uint32_t at = UintOf(request.Of(OperandKind::kPlace)[i]);  // a negative one is large
    is_inside = is_inside && at < extent.size[i];
    texel += at * stride;
    stride *= extent.size[i];
  }
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = is_inside ? WordAt(texels, kTexelWords * texel + i)
                          : UndefinedBits(request, undefined, kind, i);
  if (!is_inside) return;
  if (IsAtomic(request.op)) {
    std::uint32_t& word = WordAt(texels, kTexelWords * texel);
    word = Combined(request, kind, word);
  } else if (request.op == ObjectOp::kStore) {
    const auto values = request.Of(OperandKind::kValue);
    for (std::size_t i = 0; i < values.size(); ++i)
      WordAt(texels, kTexelWords * texel + i) = UintOf(values[i]);
  }
}

Inputs::Texture UploadedImage(const Program& program, const Resource& resource,
                              const Buffer& texels) {
  const Type& type = ObjectTypeOf(program, resource.var);
  const ObjectInfo& form = InfoOf(type.object);
  if (!resource.format.empty() && resource.format.find("32") == std::string::npos)
    throw DrawError("an image of the format " + resource.format + ", which no test draws with");
  const std::uint32_t components = type.element ? program.types[type.element].Components() : 4;
  Inputs::Texture upload;
  upload.is_image = true;
  upload.components = components == 3 ? 4 : static_cast<int>(components);
  upload.kind = KindOfTexels(ElementKind(program, resource.var));
  upload.target = form.axes == 0 ? GL_TEXTURE_BUFFER : TargetOf(form);
  const Words words = WordsOf(texels);
  Inputs::Texture::Level& level = upload.levels.emplace_back();
  level.size = ExtentOf(form).size;
  for (std::size_t i = 0; i < words.size(); ++i)
    if (i % kTexelWords < static_cast<std::size_t>(upload.components))
      level.words.push_back(words[i]);
  return upload;
}

}  // namespace clipc::draw
