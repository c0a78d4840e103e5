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

struct Use {
  bool reads = false, writes = false;
};

Use UseOf(const Program& program, const Reached& reached, VarId image) {
  Use use;
  for (const FunctionId function : reached.functions) {
    ForEachExpr(program, program.functions[function].body, [&](ExprId expr) {
      const auto* call = As<ObjectCall>(program, expr);
      if (!call || RootOf(program, program.expr_lists[call->arguments][0]) != image) return;
      use.reads |= call->op == ObjectOp::kImageLoad || IsAtomic(call->op);
      use.writes |= WritesObject(call->op);
    });
  }
  return use;
}

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

std::string_view ImageAccess(const Program& program, const Reached& reached, const Target& target,
                             const Resource& resource) {
  if (target.Has(Feature::kImageFormats) || IsIn(kReadWrite, ImageFormat(program, resource)))
    return "";
  return UseOf(program, reached, resource.var).writes ? "writeonly " : "readonly ";
}

std::string ImageProblem(const Program& program, const Reached& reached, const Target& target,
                         const Resource& resource) {
  if (target.Has(Feature::kImageFormats)) return "";
  const std::string format = ImageFormat(program, resource);
  if (IsIn(kReadWrite, format)) return "";
  if (!IsIn(kOneWay, format)) return fmt::format("has the format `{}`", format);
  const Use use = UseOf(program, reached, resource.var);
  if (!use.reads || !use.writes) return "";
  return fmt::format("is read and written with the format `{}`, not one component of 32 bits",
                     format);
}

}  // namespace clipc::glsl
