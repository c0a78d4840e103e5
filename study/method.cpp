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

// The positions of a vertex: the vertex times one matrix, times two in turn, times one that was
// multiplied in float, and as it is.
constexpr auto kOnce = [](const Setup& setup) {
  return [m = ConvertTo<float>(setup.world_view_projection)](const Vec4<float>& v) {
    return Transform(v, m);
  };
};
constexpr auto kInSteps = [](const Setup& setup) {
  return [world = ConvertTo<float>(setup.world),
          rest = ConvertTo<float>(Multiply(setup.view, setup.projection))](const Vec4<float>& v) {
    return Transform(Transform(v, world), rest);
  };
};
constexpr auto kByFloatProduct = [](const Setup& setup) {
  const auto product =
      Multiply(Multiply(ConvertTo<float>(setup.world), ConvertTo<float>(setup.view)),
               ConvertTo<float>(setup.projection));
  return [product](const Vec4<float>& v) { return Transform(v, product); };
};
constexpr auto kAsItIs = [](const Setup&) { return kWhole; };

// A method with the runtime's constant for that space, from the world-space plane.
template <typename Pick, typename Positions>
Method BySpace(const char* name, PlaneSpace space, Pick pick, Positions positions) {
  return {name, [=](const Setup& setup) -> std::optional<Distance> {
            const runtime::DrawMatrices draw = {setup.world, setup.view, setup.projection};
            const auto constant =
                PlaneConstantFor(space, setup.world_plane, runtime::KnownIn::kWorld, draw);
            if (!constant.ok()) return std::nullopt;
            return [position = positions(setup), plane = VectorOf(constant.value.plane.constant),
                    pick](const Vec4<float>& v) {
              return static_cast<double>(Dot(pick(position(v)), plane));
            };
          }};
}

}  // namespace

Method ClipSpace() { return BySpace("clip", PlaneSpace::kClip, kWhole, kOnce); }
Method ClipSpaceInSteps() { return BySpace("clip-steps", PlaneSpace::kClip, kWhole, kInSteps); }
Method Xyw1Space() { return BySpace("xyw1", PlaneSpace::kXyw1, kXyw1Position, kOnce); }
Method Xyw1SpaceInSteps() {
  return BySpace("xyw1-steps", PlaneSpace::kXyw1, kXyw1Position, kInSteps);
}
Method ClipSpaceOfFloatProduct() {
  return BySpace("clip-product", PlaneSpace::kClip, kWhole, kByFloatProduct);
}
Method Xyw1SpaceOfFloatProduct() {
  return BySpace("xyw1-product", PlaneSpace::kXyw1, kXyw1Position, kByFloatProduct);
}
Method ObjectSpace() { return BySpace("object", PlaneSpace::kObject, kWhole, kAsItIs); }

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
  return {ClipSpace(),       ClipSpaceInSteps(), ClipSpaceOfFloatProduct(),
          Xyw1Space(),       Xyw1SpaceInSteps(), Xyw1SpaceOfFloatProduct(),
          ObjectSpace(),     WorldSpace(),       ViewSpace(),
          DocumentFormula(), FloatInverse(),     NearPlane(),
          NearPlaneFloat(),  CpuDouble()};
}

}  // namespace clipc::study
