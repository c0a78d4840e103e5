// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// What the page asks for on top of module.cpp and runtime/clipc_runtime.h: the displacement of a
// cut at any reach, and SPIR-V as text.
#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <glslang/SPIRV/disassemble.h>

#include "compiler/clipc.h"
#include "runtime/clip_plane.h"
#include "runtime/matrix.h"
#include "runtime/plane_space.h"

#define CLIPC_EXPORT(name) __attribute__((export_name(#name)))

using namespace clipc::runtime;

extern "C" {

// PredictEdgeError for surfaces of any direction, in pixels; negative if there is no prediction.
CLIPC_EXPORT(clipc_module_edge_error)
double clipc_module_edge_error(int space, const float* view_plane, const float* projection,
                               double rows, double reach) {
  float elements[16];
  std::copy_n(projection, 16, elements);
  double c[4];
  std::copy_n(view_plane, 4, c);
  const Result<double> error =
      PredictEdgeError(static_cast<PlaneSpace>(space), {c[0], c[1], c[2], c[3]},
                       RowVectorMatrix(elements), rows, kAnySurface, reach);
  return error.ok() ? error.value : -1;
}

// `words`: a module that clipc made. The text lives until the next call.
CLIPC_EXPORT(clipc_module_disassemble)
const clipc_bytes* clipc_module_disassemble(const unsigned* words, std::size_t count) {
  static std::string text;
  static clipc_bytes bytes;
  std::ostringstream out;
  spv::Disassemble(out, std::vector<unsigned>(words, words + count));
  text = std::move(out).str();
  bytes = {text.data(), text.size()};
  return &bytes;
}

}  // extern "C"
