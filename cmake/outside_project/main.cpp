// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Checks the parts of the shader that reach a program, by header, by the table in a file and by the
// variants, and prints the place of a plane.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

#include <clipc/runtime/level9_binder.h>

#include "colors.shader.h"
#include "counts.shader.h"
#include "cut.shader.h"
#include "level9.clip.h"
#include "level9.shader.h"
#include "pair.shader.h"
#include "pair_of_two.shader.h"
#include "shader.h"
#include "variants.shader.h"
#include "vulkan.shader.h"
#include "vulkan_pairs.shader.h"
#include "vulkan_variants.spv.h"

int main() {
  namespace runtime = clipc::runtime;
  const auto table = runtime::ReadTable(level9_clip_table);
  std::ifstream file(SHADER_FOLDER "/level9.clip.json", std::ios::binary);
  const std::string json{std::istreambuf_iterator<char>(file), {}};
  const auto same = runtime::ReadTable(json.data(), json.size());
  if (!table.ok() || !same.ok() || same.value.planes.size() != table.value.planes.size()) return 1;
  if (std::strstr(level9_vert, "gl_ClipVertex") == nullptr) return 1;
  for (int count = 0; count <= 2; ++count) {
    const std::string last = "gl_ClipDistance[" + std::to_string(count - 1) + "] =";
    const std::string next = "gl_ClipDistance[" + std::to_string(count) + "] =";
    if (count > 0 && std::strstr(variants_vert[count], last.c_str()) == nullptr) return 1;
    if (std::strstr(variants_vert[count], next.c_str()) != nullptr) return 1;
  }
  // The fragment shader has a variant for each number of planes too.
  for (int count = 0; count <= 2; ++count) {
    if ((std::strstr(cut_frag[count], "discard") != nullptr) != (count > 0)) return 1;
  }
  if (!std::ifstream(SHADER_FOLDER "/cut.clip.json") ||
      !std::ifstream(SHADER_FOLDER "/cut.reflect.json"))
    return 1;
  if (vulkan_spv[0] != 0x07230203 || !std::ifstream(SHADER_FOLDER "/vulkan.spv")) return 1;
  for (int count = 0; count <= 2; ++count) {
    const std::uint32_t* const words = vulkan_variants_spv[count];
    if (words[0] != 0x07230203 || vulkan_variants_spv_sizes[count] < 20) return 1;
    if (count > 0 && vulkan_variants_spv_sizes[count] <= vulkan_variants_spv_sizes[count - 1])
      return 1;
    if (!std::ifstream(SHADER_FOLDER "/vulkan_variants." + std::to_string(count) + ".spv"))
      return 1;
  }
  if (vulkan_pairs_spv_pixel[1][0] != 0x07230203 || vulkan_pairs_spv_pixel_sizes[1] < 20 ||
      !std::ifstream(SHADER_FOLDER "/vulkan_pairs.frag.1.spv"))
    return 1;
  if (!std::strstr(pair_vert[1], "void main") || !std::strstr(pair_frag[1], "SV_Target0") ||
      !std::strstr(pair_of_two_frag, "SV_Target0") || pair_of_two_spv_pixel[0] != 0x07230203)
    return 1;
  // The pixel shader alone has a reflection and no clip table.
  if (std::strstr(colors_frag, "SV_Target0") == nullptr ||
      !std::ifstream(SHADER_FOLDER "/colors.reflect.json"))
    return 1;
  if (std::strstr(counts_comp, "local_size_x = 64") == nullptr ||
      !std::ifstream(SHADER_FOLDER "/counts.reflect.json"))
    return 1;
  // SPIR-V's decoration BuiltIn ClipDistance, of the compiler that clipc_add_hlsl_pass() calls.
  const std::uint32_t clip_distance[] = {11, 3};
  if (std::search(std::begin(passed_spv), std::end(passed_spv), std::begin(clip_distance),
                  std::end(clip_distance)) == std::end(passed_spv))
    return 1;
  std::printf("second plane: byte %u of b%u\n", table.value.planes[1].byte_offset,
              table.value.planes[1].register_number);
  return 0;
}
