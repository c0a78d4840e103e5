// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/program/source.h"

#include "compiler/clipc.hpp"
#include "method.text.h"
#include "runtime/near_plane.h"
#include "runtime/plane_space.h"
#include "tools/harness/offscreen.h"

namespace clipc::study {
namespace {

// `discard` is what clipc wrote for the fragment shader: the function `clip_planes` or nothing.
std::string FragmentOf(WayKind kind, int planes, bool coverage, std::string_view discard) {
  const bool is_old = kind == WayKind::kLevel9;
  const std::string in = is_old ? "varying " : "layout(location = 0) in ";
  const std::string out = is_old ? "gl_FragColor" : "color";
  std::string text =
      is_old ? "#version 120\n" : "#version 450\nlayout(location = 0) out vec4 color;\n";
  text += discard;
  std::string body = discard.empty() ? "" : "    clip_planes();\n";
  if (kind == WayKind::kDiscardRecomputed) {
    // The shader stands in for that of three.js: every fragment dots its interpolated world
    // position.
    const std::string count = std::to_string(planes);
    text += "layout(location = 0) in vec3 vs_PLACE0;\nlayout(location = 1) in vec3 vs_NORMAL0;\n";
    text += "layout(std140) uniform Clip { vec4 clip[" + count + "]; };\n";
    body = "    for (int i = 0; i < " + count +
           "; ++i) if (!(dot(vec4(vs_PLACE0, 1.0), clip[i]) >= 0.0)) discard;\n";
  } else if (!coverage) {
    text += in + "vec3 vs_NORMAL0;\n";
  }
  const char* shaded =
      "vec4(vec3(0.6, 0.7, 0.8) * (0.25 + 0.75 * max(0.0, dot(normalize(vs_NORMAL0), vec3(0.37, "
      "0.74, 0.56)))), 1.0)";
  return text + "void main() {\n" + body + "    " + out + " = " +
         (coverage ? "vec4(1.0)" : shaded) + ";\n}\n";
}

}  // namespace

WaySource SourceOf(WayKind kind, int planes, bool coverage) {
  library::Request request;
  request.path = "method.hlsl";
  request.text = method_text;
  const bool is_plain =
      kind == WayKind::kNone || kind == WayKind::kNearPlaneFloat || kind == WayKind::kCpu;
  const auto add = [&](const std::string& option) { request.options.push_back(option); };
  add("-DPLANES=" + std::to_string(is_plain ? 0 : planes));
  if (kind == WayKind::kWorld) add("-DBY_HAND");
  if (kind == WayKind::kDiscardRecomputed) add("-DRECOMPUTED");
  if (kind == WayKind::kLevel9) add("-Tvs_4_0_level_9_1"), add("--target=glsl120");
  const Way& way = WayOf(kind);
  add(std::string("--lower=") + NameOf(way.lowering.value_or(Lowering::kClipDistance)));
  if (way.lowering) add(std::string("--plane-space=") + NameOf(*way.space));
  const library::Result result = library::Compiler().Compile(request);
  if (!result.ok()) throw harness::DrawError(std::string(result.messages()));
  return {std::string(result.glsl()),
          FragmentOf(kind, planes, coverage, result.Get(CLIPC_PART_DISCARD))};
}

std::optional<WayConstants> ConstantsOf(WayKind kind, const Setup& setup,
                                        const std::vector<Plane>& world_planes) {
  WayConstants constants = {
      ConvertTo<float>(setup.world_view_projection), ConvertTo<float>(setup.world), {}};
  const runtime::DrawMatrices draw = {setup.world, setup.view, setup.projection};
  for (const Plane& plane : world_planes) {
    const std::optional<PlaneSpace> space = WayOf(kind).space;
    if (!space) {
      constants.planes.push_back(ConvertTo<float>(plane));
      continue;
    }
    const auto constant = PlaneConstantFor(*space, plane, runtime::KnownIn::kWorld, draw);
    if (!constant.ok()) return std::nullopt;
    constants.planes.push_back(VectorOf(constant.value.plane.constant));
  }
  const runtime::DepthRange range = setup.config.camera.Range();
  if (kind == WayKind::kNearPlane) {
    const auto view = ViewPlaneFromWorld(world_planes.front(), setup.view);
    const auto sheared = ShearNearPlane(view.value.plane, setup.projection, range,
                                        runtime::NearPlaneScale::kKeepFar);
    if (!sheared.ok() || range.reversed)
      return std::nullopt;  // the lowering writes z = d, which is for z = 0 at the near plane
    const auto object = ObjectPlaneFromWorld(world_planes.front(), setup.world);
    const Plane& p = object.value.plane;
    const double a = sheared.value.scale;
    constants.planes.front() = ConvertTo<float>(Plane{p.x * a, p.y * a, p.z * a, p.w * a});
  }
  if (kind == WayKind::kNearPlaneFloat) {
    const auto view_plane = ViewPlaneFromWorld(world_planes.front(), setup.view);
    if (range.reversed || view_plane.value.plane.w >= 0) return std::nullopt;
    constants.world_view_projection = FloatNearPlane(setup, world_planes.front());
  }
  return constants;
}

}  // namespace clipc::study
