// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "affine_inverse.h"
#include "clip_plane.h"
#include "matrix.h"
#include "projection_shape.h"
#include "status.h"

/// A plane on its way through several spaces: nothing is rounded to double in between, so that what
/// two matrices cancel is not lost. Not part of the public interface.
namespace clipc::runtime {

using Step = Result<Bounded>;

/// The plane as the application gives it. Errors: kNotFinite.
Step Begin(const Plane& plane) noexcept;

/// Errors: kNotFinite, kLooksTransposed. `name` is for messages.
Status CheckAffine(const Matrix& matrix, const char* name) noexcept;

/// The plane after an affine `matrix`, whose inverse must exist; `name` is for messages. Errors:
/// kNotFinite, kLooksTransposed, kSingular.
Step Through(const Step& before, const Matrix& matrix, const char* name) noexcept;
/// The plane after the camera's view and projection, as Through and ThroughProjection make it.
Step ThroughCamera(const Step& before, const PreparedCamera& camera) noexcept;
/// The plane in the space before `matrix`, which needs no inverse: `matrix` times the plane.
/// Errors: kNotFinite, kLooksTransposed.
Step Before(const Step& after, const Matrix& matrix, const char* name) noexcept;

/// The plane after the projection, as ClipPlaneFromView says.
Step ThroughProjection(const Step& before, const Matrix& projection) noexcept;
/// ThroughProjection by the closed form, for a projection whose shape holds.
Bounded ThroughShape(const Bounded& before, const ProjectionShape& shape) noexcept;
/// The constant of plane space `xyw1` for a plane of view space, as Xyw1PlaneFromView says.
Step ToXyw1(const Step& view_plane, const Matrix& projection) noexcept;

/// The plane, rounded. Errors: those of the steps, kIllConditioned, kNotRepresentable.
Result<PlaneConstant> Finish(const Step& step) noexcept;

/// The plane in double.
Plane Rounded(const Bounded& bounded) noexcept;

}  // namespace clipc::runtime
