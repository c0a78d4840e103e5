// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "study/method.h"

#include "runtime/near_plane.h"
#include "runtime/plane_space.h"

namespace clipc::study {
namespace {

// dot(v * matrix, plane)
Distance AfterTransform(const Matrix& matrix, const Vec4<float>& plane) {
  return [m = ConvertTo<float>(matrix), plane](const Vec4<float>& v) {
    return static_cast<double>(Dot(Transform(v, m), plane));
  };
}

constexpr auto kWhole = [](const Vec4<float>& p) { return p; };
constexpr auto kXyw1Position = [](const Vec4<float>& p) {
  return Vec4<float>{{p[0], p[1], p[3], 1}};
};

// What the name of a method adds for an order.
std::string SuffixOf(runtime::MatrixOrder order) {
  constexpr const char* kSuffixes[] = {"",       "-steps",   "-worldview",
                                       "-three", "-product", "-product-vp"};
  return kSuffixes[static_cast<int>(order)];
}

// A method with the runtime's constant for that space, from the world-space plane. The operand of
// the dot product is picked from the position.
template <typename Pick>
Method BySpace(const std::string& name, PlaneSpace space, Pick pick, runtime::MatrixOrder order) {
  return {name + SuffixOf(order),
          [=](const Setup& setup) -> std::optional<Distance> {
            const runtime::DrawMatrices draw = {setup.world, setup.view, setup.projection};
            const auto constant =
                PlaneConstantFor(space, setup.world_plane, runtime::KnownIn::kWorld, draw);
            if (!constant.ok()) return std::nullopt;
            const Vec4<float> plane = VectorOf(constant.value.plane.constant);
            if (space == PlaneSpace::kObject)
              return [plane](const Vec4<float>& v) { return static_cast<double>(Dot(v, plane)); };
            return [position = PositionBy(order, setup), plane, pick](const Vec4<float>& v) {
              return static_cast<double>(Dot(pick(position(v)), plane));
            };
          },
          false, order};
}

}  // namespace

Position PositionBy(runtime::MatrixOrder order, const Setup& setup) {
  using enum runtime::MatrixOrder;
  const Mat4<float> world = ConvertTo<float>(setup.world), view = ConvertTo<float>(setup.view),
                    projection = ConvertTo<float>(setup.projection);
  std::vector<Mat4<float>> chain;
  switch (order) {
    case kWorldFirst:
      chain = {world, ConvertTo<float>(Multiply(setup.view, setup.projection))};
      break;
    case kWorldViewFirst: chain = {ConvertTo<float>(setup.world_view), projection}; break;
    case kThreeMatrices: chain = {world, view, projection}; break;
    case kFloatWorldView: chain = {Multiply(Multiply(world, view), projection)}; break;
    case kFloatViewProjection: chain = {Multiply(world, Multiply(view, projection))}; break;
    default: chain = {ConvertTo<float>(setup.world_view_projection)};
  }
  return [chain](Vec4<float> v) {
    for (const Mat4<float>& matrix : chain) v = Transform(v, matrix);
    return v;
  };
}

Method ClipSpaceBy(runtime::MatrixOrder order) {
  return BySpace("clip", PlaneSpace::kClip, kWhole, order);
}
Method Xyw1SpaceBy(runtime::MatrixOrder order) {
  return BySpace("xyw1", PlaneSpace::kXyw1, kXyw1Position, order);
}
Method InOrder(Method method, runtime::MatrixOrder order) {
  method.name += SuffixOf(order), method.order = order;
  return method;
}
Method ClipSpace() { return ClipSpaceBy(runtime::MatrixOrder::kOneMatrix); }
Method Xyw1Space() { return Xyw1SpaceBy(runtime::MatrixOrder::kOneMatrix); }
Method ObjectSpace() {
  return BySpace("object", PlaneSpace::kObject, kWhole, runtime::MatrixOrder::kOneMatrix);
}

Method WorldSpace() {
  return {"world", [](const Setup& setup) -> std::optional<Distance> {
            return AfterTransform(setup.world, ConvertTo<float>(setup.world_plane));
          }};
}

Method ViewSpace() {
  return {"view", [](const Setup& setup) -> std::optional<Distance> {
            return AfterTransform(setup.world_view, ConvertTo<float>(setup.view_plane));
          }};
}

Method DocumentFormula() {
  return {"document-f32", [](const Setup& setup) -> std::optional<Distance> {
            const Mat4<float> p = ConvertTo<float>(setup.projection);
            const Vec4<float> c = ConvertTo<float>(setup.view_plane);
            const float b = p.m[3][2];
            const Vec4<float> plane = {
                {c[0] / p.m[0][0], c[1] / p.m[1][1], c[3] / b, c[2] - c[3] * p.m[2][2] / b}};
            return AfterTransform(setup.world_view_projection, plane);
          }};
}

Method FloatInverse() {
  return {"inverse-f32", [](const Setup& setup) -> std::optional<Distance> {
            const auto view_projection =
                Multiply(ConvertTo<float>(setup.view), ConvertTo<float>(setup.projection));
            const auto plane =
                PlaneThrough(InverseOf(view_projection), ConvertTo<float>(setup.world_plane));
            return AfterTransform(setup.world_view_projection, plane);
          }};
}

Method NearPlane() {
  return {"near-plane", [](const Setup& setup) -> std::optional<Distance> {
            const runtime::DepthRange range = setup.config.camera.Range();
            const auto sheared = ShearNearPlane(setup.view_plane, setup.projection, range,
                                                runtime::NearPlaneScale::kKeepFar);
            if (!sheared.ok()) return std::nullopt;
            Matrix to_clip = setup.world_view_projection;
            SetDepthColumn(to_clip, setup.object_plane, sheared.value.scale, range);
            return
                [m = ConvertTo<float>(to_clip), reversed = range.reversed](const Vec4<float>& v) {
                  const Vec4<float> p = Transform(v, m);
                  return static_cast<double>(reversed ? p[3] - p[2] : p[2]);
                };
          }};
}

Mat4<float> FloatNearPlane(const Setup& setup, const Plane& world_plane) {
  const Mat4<float> view = ConvertTo<float>(setup.view),
                    projection = ConvertTo<float>(setup.projection);
  const auto plane =
      PlaneThrough(InverseOf(Multiply(view, projection)), ConvertTo<float>(world_plane));
  Mat4<float> shear = ConvertTo<float>(Matrix{});
  for (int i = 0; i < 4; ++i) shear.m[i][2] = plane[i];
  return Multiply(Multiply(ConvertTo<float>(setup.world), view), Multiply(projection, shear));
}

Method NearPlaneFloat() {
  return {"near-plane-f32", [](const Setup& setup) -> std::optional<Distance> {
            if (setup.config.camera.reversed)
              return std::nullopt;  // this form is for z = 0 at the near plane
            return [to_clip = FloatNearPlane(setup, setup.world_plane)](const Vec4<float>& v) {
              return static_cast<double>(Transform(v, to_clip)[2]);
            };
          }};
}

Method CpuDouble() {
  return {"cpu",
          [](const Setup& setup) -> std::optional<Distance> {
            const Vec4<double> plane = ConvertTo<double>(setup.object_plane);
            return [plane](const Vec4<float>& v) { return Dot(ConvertTo<double>(v), plane); };
          },
          true};
}

std::vector<Method> AllMethods() {
  using enum runtime::MatrixOrder;
  return {ClipSpace(),
          ClipSpaceBy(kWorldFirst),
          ClipSpaceBy(kFloatWorldView),
          Xyw1Space(),
          Xyw1SpaceBy(kWorldFirst),
          Xyw1SpaceBy(kFloatWorldView),
          ObjectSpace(),
          InOrder(ObjectSpace(), kWorldFirst),
          WorldSpace(),
          InOrder(WorldSpace(), kWorldFirst),
          ViewSpace(),
          DocumentFormula(),
          FloatInverse(),
          NearPlane(),
          InOrder(NearPlane(), kWorldFirst),
          NearPlaneFloat(),
          CpuDouble(),
          InOrder(CpuDouble(), kWorldFirst)};
}

}  // namespace clipc::study
