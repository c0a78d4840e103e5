// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/images.h"

#include <algorithm>

#include <fmt/format.h>

#include "ir/access.h"
#include "ir/walk.h"

namespace clipc::glsl {

using namespace ir;

namespace {

// The formats of OpenGL ES 3.10 and 3.20; those that may be read and written come first.
constexpr std::string_view kReadWrite[] = {"r32f", "r32i", "r32ui"};
constexpr std::string_view kOneWay[] = {"rgba32f", "rgba16f", "rgba8",    "rgba8_snorm", "rgba32i",
                                        "rgba16i", "rgba8i",  "rgba32ui", "rgba16ui",    "rgba8ui"};

bool IsIn(std::span<const std::string_view> formats, std::string_view format) {
  return std::ranges::find(formats, format) != formats.end();
}

}  // namespace

std::string ImageFormat(const Program& program, const Resource& resource) {
  if (!resource.format.empty()) return resource.format;
  const Type& object = program.types[program.types.Innermost(program.vars[resource.var].type)];
  std::uint32_t count = 4;
  Scalar kind = Scalar::kFloat;
  if (object.element) {
    const Type& element = program.types[object.element];
    count = element.Components() == 3 ? 4 : element.Components();
    kind = BaseOf(element.scalar);
  }
  return fmt::format("{}32{}", std::string_view("rgba").substr(0, count),
                     kind == Scalar::kUint  ? "ui"
                     : kind == Scalar::kInt ? "i"
                                            : "f");
}

std::vector<ObjectUse> UsesOfImages(const Program& program, const Reached& reached,
                                    const Target& target) {
  const bool has_images = std::ranges::any_of(program.resources, [&](const Resource& resource) {
    const TypeId object = program.types.Innermost(program.vars[resource.var].type);
    return IsImage(program.types[object].object);
  });
  if (!has_images || target.Has(Feature::kImageFormats)) return {};
  return UsesOfObjects(program, reached.functions);
}

std::string_view ImageAccess(const Program& program, std::span<const ObjectUse> uses,
                             const Target& target, const Resource& resource) {
  if (target.Has(Feature::kImageFormats) || IsIn(kReadWrite, ImageFormat(program, resource)))
    return "";
  return uses[resource.var.index].writes ? "writeonly " : "readonly ";
}

std::string ImageProblem(const Program& program, std::span<const ObjectUse> uses,
                         const Target& target, const Resource& resource) {
  if (target.Has(Feature::kImageFormats)) return "";
  const std::string format = ImageFormat(program, resource);
  if (IsIn(kReadWrite, format)) return "";
  if (!IsIn(kOneWay, format)) return fmt::format("has the format `{}`", format);
  const ObjectUse use = uses[resource.var.index];
  if (!use.reads || !use.writes) return "";
  return fmt::format("is read and written with the format `{}`, not one component of 32 bits",
                     format);
}

}  // namespace clipc::glsl
