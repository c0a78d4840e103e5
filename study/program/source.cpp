// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/program/source.h"

#include "compiler/compile.h"
#include "runtime/near_plane.h"
#include "runtime/plane_space.h"
#include "tools/harness/offscreen.h"

namespace clipc::study {
namespace {

std::string FragmentOf(WayKind kind, int planes, bool coverage) {
  const bool is_old = kind == WayKind::kLevel9;
  const std::string in = is_old ? "varying " : "layout(location = 0) in ";
  const std::string out = is_old ? "gl_FragColor" : "color";
  std::string text =
      is_old ? "#version 120\n" : "#version 450\nlayout(location = 0) out vec4 color;\n";
  std::string body;
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
  CompileRequest request;
  request.path = CLIPC_STUDY_SHADER;
  const bool is_plain =
      kind == WayKind::kNone || kind == WayKind::kNearPlaneFloat || kind == WayKind::kCpu;
  request.defines.push_back("PLANES=" + std::to_string(is_plain ? 0 : planes));
  if (kind == WayKind::kWorld) request.defines.push_back("BY_HAND");
  if (kind == WayKind::kDiscardRecomputed) request.defines.push_back("RECOMPUTED");
  if (kind == WayKind::kLevel9) request.profile = "vs_4_0_level_9_1", request.target = "glsl120";
  const Way& way = WayOf(kind);
  request.lowering = way.lowering.value_or(Lowering::kClipDistance);
  if (way.lowering) request.plane_space = *way.space;
  WaySource source;
  source.fragment = FragmentOf(kind, planes, coverage);
  if (request.lowering == Lowering::kDiscard) request.fragment = source.fragment;
  CompileResult result = Compile(request);
  if (!result.ok()) throw harness::DrawError(result.text);
  source.vertex = std::move(result.shaders.vertex);
  if (request.fragment) source.fragment = std::move(result.shaders.fragment);
  return source;
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
