// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string_view>

// The stages of the pipeline whose shaders clipc reads, and what differs between them.
namespace clipc {

enum class Stage : std::uint8_t { kVertex, kPixel, kCompute, kGeometry, kHull, kDomain };

struct StageInfo {
  std::string_view prefix;        // of the names of its profiles: "vs"
  int number = 0;                 // DXC's __SHADER_TARGET_STAGE
  std::string_view name;          // in messages: "vertex"
  std::string_view extension;     // of the names of files with its GLSL: ".vert"
  std::string_view runs;          // what it runs for, in messages: "vertices"
  int place = 0;                  // among the stages of a program that draws, the first is 1
  bool has_stage_before = false;  // its inputs are the outputs of another stage
  bool has_stage_after = false;   // its outputs are the inputs of another stage
  // The stage runs in quads of neighbours: derivatives exist, and levels of detail follow from
  // them.
  bool has_neighbours = false;
  // The stage draws pixels: its inputs are interpolated, and it may discard.
  bool draws_pixels = false;
  // The stage runs in groups of threads, which share memory and wait for each other. It is a
  // program by itself: no data comes from other stages or goes to them.
  bool runs_in_groups = false;
  // The stage reads the vertices of a primitive, or the control points of a patch, as an array.
  bool reads_vertices = false;
  // The stage runs for a primitive, and emits vertices of others.
  bool emits_vertices = false;
  // The stage runs for the control points of a patch, which it writes, and once for all that the
  // patch has beside them, its constants.
  bool makes_patches = false;
  // The stage runs for the points that the tessellator makes in a patch, whose constants it reads.
  bool reads_patches = false;
  // The stage may order what it stores for other invocations.
  bool orders_memory = false;
};

// One row for each enumerator.
inline constexpr StageInfo kStages[] = {
    {.prefix = "vs",
     .number = 1,
     .name = "vertex",
     .extension = ".vert",
     .runs = "vertices",
     .place = 1,
     .has_stage_after = true},
    {.prefix = "ps",
     .number = 0,
     .name = "pixel",
     .extension = ".frag",
     .runs = "pixels",
     .place = 5,
     .has_stage_before = true,
     .has_neighbours = true,
     .draws_pixels = true,
     .orders_memory = true},
    {.prefix = "cs",
     .number = 5,
     .name = "compute",
     .extension = ".comp",
     .runs = "threads",
     .runs_in_groups = true,
     .orders_memory = true},
    {.prefix = "gs",
     .number = 2,
     .name = "geometry",
     .extension = ".geom",
     .runs = "primitives",
     .place = 4,
     .has_stage_before = true,
     .has_stage_after = true,
     .reads_vertices = true,
     .emits_vertices = true},
    {.prefix = "hs",
     .number = 3,
     .name = "hull",
     .extension = ".tesc",
     .runs = "control points",
     .place = 2,
     .has_stage_before = true,
     .has_stage_after = true,
     .reads_vertices = true,
     .makes_patches = true},
    {.prefix = "ds",
     .number = 4,
     .name = "domain",
     .extension = ".tese",
     .runs = "points of a patch",
     .place = 3,
     .has_stage_before = true,
     .has_stage_after = true,
     .reads_vertices = true,
     .reads_patches = true},
};
inline constexpr std::size_t kStageCount = std::size(kStages);

constexpr const StageInfo& InfoOf(Stage stage) { return kStages[static_cast<std::size_t>(stage)]; }

// The stage whose profiles begin with `prefix`; none for a stage that clipc does not read, "ms".
constexpr std::optional<Stage> StageOf(std::string_view prefix) {
  for (const StageInfo& info : kStages) {
    if (info.prefix == prefix) return static_cast<Stage>(&info - kStages);
  }
  return std::nullopt;
}

// The stage whose GLSL has the extension, without its dot: "vert".
constexpr std::optional<Stage> StageOfExtension(std::string_view extension) {
  for (const StageInfo& info : kStages) {
    if (info.extension.substr(1) == extension) return static_cast<Stage>(&info - kStages);
  }
  return std::nullopt;
}

}  // namespace clipc
