// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "study/method.h"
#include "study/setup.h"

namespace clipc::study {

// The displacement by float32 arithmetic of the places where a plane cuts triangles' edges, in
// pixels of 1920x1080.
struct EdgeErrors {
  std::string method;
  bool applies = false;  // the method can be used here
  long edges = 0;
  double median = 0, p99 = 0, largest = 0;  // along the surface as it is drawn
  double p99_in_image = 0;                  // with the displacement of the surface's own vertices
  long not_finite = 0;                      // edges with a distance that is NaN or infinite
};

// The displacements of edges, beside each other, in pixels.
struct Displacements {
  std::vector<double> along_surface, in_image;
};

// Cuts `count` random edges that cross the plane inside the image. The true sign and place follow
// in Wide from the float vertices, the double matrices and the double world-space plane. The
// displacement of a method that keeps or drops a whole edge is the distance from the cut to the end
// that it chose. Vertices are rounded to float in object space first, so that no method pays for
// that. Equal arguments give equal results.
std::vector<EdgeErrors> MeasureEdges(const Config& config, const std::vector<Method>& methods,
                                     long count, std::uint64_t seed);

// The views of a draw that are measured together: their planes, cameras and offsets differ by a
// hundredth at most, as while the camera moves. All vertices of a view share the rounding of its
// matrices and its constant, so that a single view may be lucky; together the views show the error
// of the draw.
inline constexpr int kViews = 20;

// The displacements of `count` edges in each view; none where the method does not apply.
Displacements DisplacementsOverViews(const Config& config, const Method& method, long count,
                                     std::uint64_t seed);

// As MeasureEdges, over `count` edges in each view.
std::vector<EdgeErrors> MeasureViews(const Config& config, const std::vector<Method>& methods,
                                     long count, std::uint64_t seed);

// Measures over planes of random directions, `ratio` near distances from the eye, each with a
// camera and an object of its own; 60 degrees.
EdgeErrors MeasureDirections(double ratio, bool reversed, const Method& method, int planes,
                             long count, std::uint64_t seed);

}  // namespace clipc::study
