// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/target.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "base/spelling.h"

namespace clipc::glsl {
namespace {

struct Profile {
  std::string_view name;
  Api api;
  int version;
};
constexpr std::array kProfiles = {
    Profile{"glsl120", Api::kOpenGL, 120},   Profile{"glsl130", Api::kOpenGL, 130},
    Profile{"glsl140", Api::kOpenGL, 140},   Profile{"glsl150", Api::kOpenGL, 150},
    Profile{"glsl330", Api::kOpenGL, 330},   Profile{"glsl400", Api::kOpenGL, 400},
    Profile{"glsl410", Api::kOpenGL, 410},   Profile{"glsl420", Api::kOpenGL, 420},
    Profile{"glsl430", Api::kOpenGL, 430},   Profile{"glsl440", Api::kOpenGL, 440},
    Profile{"glsl450", Api::kOpenGL, 450},   Profile{"glsl460", Api::kOpenGL, 460},
    Profile{"essl100", Api::kOpenGLES, 100}, Profile{"essl300", Api::kOpenGLES, 300},
    Profile{"essl310", Api::kOpenGLES, 310}, Profile{"essl320", Api::kOpenGLES, 320},
    Profile{"webgl1", Api::kWebGL, 100},     Profile{"webgl2", Api::kWebGL, 300},
    Profile{"vulkan", Api::kVulkan, 460},
};

constexpr auto kNames = [] {
  std::array<std::string_view, kProfiles.size()> names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = kProfiles[i].name;
  return names;
}();

constexpr int kNever = 10000;

// The first version that has a feature in its core, the first one that has it through an extension,
// and the last one that has it.
struct Since {
  int core = kNever;
  int extended = kNever;
  std::string_view extension = {};
  int last = kNever;
};
struct FeatureRow {
  Feature feature;
  Since desktop, es;
};

constexpr Since Subgroup(std::string_view extension, int first) {
  return {kNever, first, extension};
}

// Sources: the GLSL specifications 1.20 to 4.60, GLSL ES 1.00 to 3.20, KHR_vulkan_glsl, and the
// extensions named.
constexpr FeatureRow kFeatures[] = {
    // GL_ARB_gl_spirv needs an OpenGL that is older, but a module has all bindings in it.
    {Feature::kSpirv, {420}, {}},
    {Feature::kInAndOut, {130}, {300}},
    {Feature::kInputLocations, {330}, {300}},
    {Feature::kOutputLocations, {410}, {310}},
    {Feature::kOutputBlocks, {150}, {320, 310, "GL_EXT_shader_io_blocks"}},
    {Feature::kBlockLocations,
     {440, 410, "GL_ARB_enhanced_layouts"},
     {320, 310, "GL_EXT_shader_io_blocks"}},
    {Feature::kIntegerVaryings, {130}, {300}},
    {Feature::kDoubleVaryings, {410}, {}},
    {Feature::kNoPerspective, {130}, {}},
    {Feature::kCentroid, {120}, {300}},
    {Feature::kPerSample, {400}, {320, 300, "GL_OES_shader_multisample_interpolation"}},
    {Feature::kUniformBlocks, {140}, {300}},
    {Feature::kBlockInstances, {150}, {300}},
    {Feature::kUniformTransposes, {110}, {300}},
    {Feature::kExplicitOffsets, {440}, {}},
    {Feature::kBindings, {420}, {310}},
    {Feature::kImages, {420}, {310}},
    {Feature::kImageFormats, {420}, {}},
    {Feature::kImageAtomics, {420}, {320, 310, "GL_OES_shader_image_atomic"}},
    {Feature::kStorageBuffers, {430}, {310}},
    {Feature::kMemoryBarriers, {420}, {310}},
    {Feature::kComputeShaders, {430}, {310}},
    {Feature::kGeometryShaders, {150}, {320, 310, "GL_EXT_geometry_shader"}},
    {Feature::kEmitters, {400}, {320, 310, "GL_EXT_geometry_shader"}},
    {Feature::kStreams, {400}, {}},
    {Feature::kTessellation, {400}, {320, 310, "GL_EXT_tessellation_shader"}},
    {Feature::kInterlocks, {kNever, 450, "GL_ARB_fragment_shader_interlock"}, {}},
    {Feature::kDynamicBlockIndex, {400}, {320}},
    {Feature::kClipDistance, {130}, {kNever, 300, "GL_EXT_clip_cull_distance"}},
    {Feature::kCullDistance, {450}, {kNever, 300, "GL_EXT_clip_cull_distance"}},
    {Feature::kClipVertex, {.core = 110, .last = 130}, {}},
    {Feature::kViewportOfVertex,
     {410, 150, "GL_ARB_viewport_array"},
     {kNever, 310, "GL_OES_viewport_array"}},
    {Feature::kVertexId, {130}, {300}},
    {Feature::kInstanceId, {140, 110, "GL_ARB_draw_instanced"}, {300}},
    // The extension is older (OpenGL 3.1), but glslang knows its variables from GLSL 4.50 on only.
    {Feature::kDrawParameters, {460, 450, "GL_ARB_shader_draw_parameters"}, {}},
    {Feature::kBaseVertexDraws, {150}, {320}},
    {Feature::kLayerAndViewport, {kNever, 410, "GL_ARB_shader_viewport_layer_array"}, {}},
    {Feature::kViewIndex, {kNever, 330, "GL_OVR_multiview2"}, {kNever, 300, "GL_OVR_multiview2"}},
    {Feature::kShadingRate,
     {kNever, 450, "GL_EXT_fragment_shading_rate"},
     {kNever, 310, "GL_EXT_fragment_shading_rate"}},
    {Feature::kTargetLocations, {330}, {300}},
    {Feature::kBlendIndices, {330}, {kNever, 300, "GL_EXT_blend_func_extended"}},
    {Feature::kSeveralTargets, {110}, {300, 100, "GL_EXT_draw_buffers"}},
    {Feature::kUpperLeftOrigin, {150, 140, "GL_ARB_fragment_coord_conventions"}, {}},
    {Feature::kSampleVariables, {400}, {320, 300, "GL_OES_sample_variables"}},
    {Feature::kPrimitiveIdInput, {150}, {320, 310, "GL_EXT_geometry_shader"}},
    {Feature::kLayerInput, {430}, {320, 310, "GL_EXT_geometry_shader"}},
    {Feature::kViewportInput, {430}, {}},
    {Feature::kDepthOutput, {110}, {300, 100, "GL_EXT_frag_depth"}},
    // OpenGL ES has GL_EXT_conservative_depth, which glslang 12 does not know.
    {Feature::kConservativeDepth, {420, 130, "GL_ARB_conservative_depth"}, {}},
    {Feature::kStencilOutput, {kNever, 140, "GL_ARB_shader_stencil_export"}, {}},
    {Feature::kEarlyTests, {420}, {310}},
    {Feature::kDerivatives, {110}, {300, 100, "GL_OES_standard_derivatives"}},
    {Feature::kFineDerivatives, {450, 400, "GL_ARB_derivative_control"}, {}},
    {Feature::kExplicitLevels,
     {130, 110, "GL_ARB_shader_texture_lod"},
     {300, 100, "GL_EXT_shader_texture_lod"}},
    {Feature::kLevelQueries, {400}, {}},
    {Feature::kInterpolants, {400}, {320, 300, "GL_OES_shader_multisample_interpolation"}},
    {Feature::kBarycentrics,
     {kNever, 450, "GL_NV_fragment_shader_barycentric"},
     {kNever, 320, "GL_NV_fragment_shader_barycentric"}},
    {Feature::kFullyCovered, {kNever, 450, "GL_NV_conservative_raster_underestimation"}, {}},
    {Feature::kSampleCount, {400}, {320, 300, "GL_OES_sample_variables"}},
    {Feature::kHelperInvocation, {450}, {310}},
    // Vulkan: from 1.1 on.
    {Feature::kSubgroups, Subgroup("GL_KHR_shader_subgroup_basic", 140),
     Subgroup("GL_KHR_shader_subgroup_basic", 310)},
    {Feature::kSubgroupVotes, Subgroup("GL_KHR_shader_subgroup_vote", 140),
     Subgroup("GL_KHR_shader_subgroup_vote", 310)},
    {Feature::kSubgroupBallots, Subgroup("GL_KHR_shader_subgroup_ballot", 140),
     Subgroup("GL_KHR_shader_subgroup_ballot", 310)},
    {Feature::kSubgroupArithmetic, Subgroup("GL_KHR_shader_subgroup_arithmetic", 140),
     Subgroup("GL_KHR_shader_subgroup_arithmetic", 310)},
    {Feature::kSubgroupShuffles, Subgroup("GL_KHR_shader_subgroup_shuffle", 140),
     Subgroup("GL_KHR_shader_subgroup_shuffle", 310)},
    {Feature::kSubgroupQuads, Subgroup("GL_KHR_shader_subgroup_quad", 140),
     Subgroup("GL_KHR_shader_subgroup_quad", 310)},
    {Feature::kSubgroupPartitions, Subgroup("GL_NV_shader_subgroup_partitioned", 140),
     Subgroup("GL_NV_shader_subgroup_partitioned", 310)},
    {Feature::kSubgroupInt64, {kNever, 400, "GL_EXT_shader_subgroup_extended_types_int64"}, {}},
    {Feature::kUnsigned, {130}, {300}},
    {Feature::kSwitch, {130}, {300}},
    {Feature::kFreeLoops, {110}, {300}},
    {Feature::kFreeIndices, {110}, {300}},
    {Feature::kArrayValues, {120}, {300}},
    {Feature::kStructChoices, {110}, {300}},
    {Feature::kArraysOfArrays, {430}, {310}},
    {Feature::kGlobalInitializers, {110}, {}},
    {Feature::kPrecise, {400}, {320, 310, "GL_EXT_gpu_shader5"}},
    {Feature::kDoubles, {400, 150, "GL_ARB_gpu_shader_fp64"}, {}},
    {Feature::kInt64, {kNever, 400, "GL_ARB_gpu_shader_int64"}, {}},
    {Feature::kBitCasts, {330, 150, "GL_ARB_shader_bit_encoding"}, {300}},
    {Feature::kHalfPacking, {420}, {300}},
    {Feature::kBitFunctions, {400}, {310}},
    {Feature::kBoolMix, {130}, {300}},
    {Feature::kIntegerMix, {450}, {310}},
    {Feature::kRounding, {130}, {300}},
    {Feature::kDeterminant, {150}, {300}},
    {Feature::kFullMatrices, {120}, {300}},
    {Feature::kTextureFunctions, {130}, {300}},
    {Feature::kShadowSamplers, {110}, {300}},
    {Feature::kTextureArrays, {130}, {300}},
    {Feature::kTextureStatus, {kNever, 450, "GL_ARB_sparse_texture2"}, {}},
    {Feature::kLevelClamps, {kNever, 450, "GL_ARB_sparse_texture_clamp"}, {}},
    {Feature::kShadowArrayOffsets, {430}, {}},
    {Feature::kTexture1D, {110}, {}},
    {Feature::kTexture3D, {110}, {300}},
    {Feature::kCubeArrays,
     {400, 130, "GL_ARB_texture_cube_map_array"},
     {320, 310, "GL_EXT_texture_cube_map_array"}},
    {Feature::kMultisample, {150}, {310}},
    {Feature::kMultisampleArrays, {150}, {320, 310, "GL_OES_texture_storage_multisample_2d_array"}},
    {Feature::kTextureBuffers, {140}, {320, 310, "GL_EXT_texture_buffer"}},
    {Feature::kGather, {400, 130, "GL_ARB_texture_gather"}, {310}},
    {Feature::kGatherComponents, {400, 150, "GL_ARB_gpu_shader5"}, {310}},
    {Feature::kGatherOffsets, {400, 150, "GL_ARB_gpu_shader5"}, {320, 310, "GL_EXT_gpu_shader5"}},
    {Feature::kTextureLevels, {430}, {}},
    {Feature::kTextureSamples, {450}, {}},
};

// Whether kFeatures has one row for each feature, in the order of the enumerators.
consteval bool HasEveryFeature() {
  std::size_t next = 0;
  for (const FeatureRow& row : kFeatures) {
    if (static_cast<std::size_t>(row.feature) != next++) return false;
  }
  return next == static_cast<std::size_t>(Feature::kCount);
}
static_assert(HasEveryFeature());

// Where an API differs from the version of GLSL that it has, which is 4.60 for Vulkan. Of the
// extensions of ES 3.00, browsers have WEBGL_clip_cull_distance, OVR_multiview2 and
// WEBGL_blend_func_extended.
struct Difference {
  Feature feature;
  Api api;
  Since since;
};
constexpr Difference kDifferences[] = {
    {Feature::kViewIndex, Api::kVulkan, {kNever, 460, "GL_EXT_multiview"}},
    {Feature::kBarycentrics, Api::kVulkan, {kNever, 460, "GL_EXT_fragment_shader_barycentric"}},
    {Feature::kSampleCount, Api::kVulkan, {}},  // it has no such variable
    {Feature::kClipDistance, Api::kWebGL, {kNever, 300, "GL_ANGLE_clip_cull_distance"}},
    {Feature::kCullDistance, Api::kWebGL, {kNever, 300, "GL_ANGLE_clip_cull_distance"}},
    {Feature::kPerSample, Api::kWebGL, {}},
    {Feature::kSampleVariables, Api::kWebGL, {}},
    {Feature::kSampleCount, Api::kWebGL, {}},
    {Feature::kInterpolants, Api::kWebGL, {}},
};
constexpr auto kDiffers = [] {  // by API: whether a row is about it
  std::array<bool, static_cast<std::size_t>(Api::kVulkan) + 1> differs{};
  for (const Difference& difference : kDifferences)
    differs[static_cast<std::size_t>(difference.api)] = true;
  return differs;
}();

}  // namespace

std::optional<Target> Target::Parse(std::string_view name) {
  for (const Profile& profile : kProfiles) {
    if (EqualIgnoringCase(profile.name, name)) {
      Target target(profile.name, profile.api, profile.version);
      target.needs_ = target.FindNeeds();
      return target;
    }
  }
  return std::nullopt;
}

std::span<const std::string_view> Target::Names() { return kNames; }

std::uint32_t Target::BaseOf(Stage stage) const {
  constexpr std::uint32_t kVulkan = 256;   // u0 to u95 of one shader come before
  constexpr std::uint32_t kTextures = 16;  // t0 to t15: a stage has 16 units
  // By stage: the number of stages whose bindings come before.
  constexpr std::uint32_t kBefore[] = {0, 1, 0, 2, 3, 4};
  static_assert(std::size(kBefore) == kStageCount);
  if (!InfoOf(stage).has_stage_before) return 0;
  if (bindings.later_base) return *bindings.later_base;
  const std::uint32_t before = kBefore[static_cast<std::size_t>(stage)];
  if (!IsVulkan()) return before * kTextures;
  // By rules, the host says where all is bound.
  return bindings.rules.empty() ? before * kVulkan : 0;
}

std::string_view Target::NearestWith(Feature feature) const {
  const auto has = [&](const Profile& profile) {
    return Target(profile.name, profile.api, profile.version).Has(feature);
  };
  for (const Profile& profile : kProfiles) {
    if (profile.api == api_ && has(profile)) return profile.name;
  }
  const auto found = std::ranges::find_if(kProfiles, has);
  return found == kProfiles.end() ? "" : found->name;
}

std::string Target::VersionLine() const {
  return "#version " + std::to_string(version_) + (IsEs() && version_ >= 300 ? " es" : "");
}

Support Target::Of(Feature feature) const {
  const FeatureRow& row = kFeatures[static_cast<std::size_t>(feature)];
  const Since* since = IsEs() ? &row.es : &row.desktop;
  if (kDiffers[static_cast<std::size_t>(api_)]) {
    for (const Difference& difference : kDifferences) {
      if (difference.api == api_ && difference.feature == feature) since = &difference.since;
    }
  }
  if (version_ > since->last) return {};
  if (version_ >= since->core) return {true, ""};
  return {version_ >= since->extended, version_ >= since->extended ? since->extension : ""};
}

legalize::Needs Target::FindNeeds() const {
  const auto lacks = [&](Feature feature) { return !Has(feature); };
  return {
      .signed_integers = lacks(Feature::kUnsigned),
      .square_matrices = lacks(Feature::kFullMatrices),
      .constant_loops = lacks(Feature::kFreeLoops),
      .constant_indices = lacks(Feature::kFreeIndices),
      .array_fields = lacks(Feature::kArrayValues),
      .float_choices = lacks(Feature::kBoolMix),
      .integer_choices = lacks(Feature::kIntegerMix),
      .struct_choices = lacks(Feature::kStructChoices),
      // glslang takes an array of vectors for a vector, and SPIR-V before 1.4 has no OpSelect of
      // arrays.
      .array_choices = IsVulkan(),
      .rounding = lacks(Feature::kRounding),
      .bit_functions = lacks(Feature::kBitFunctions),
      // GLSL ES gives a lowp int: of 16 bits, which -1 shows.
      .wide_bit_numbers = IsEs() && Has(Feature::kBitFunctions),
      .half_packing = lacks(Feature::kHalfPacking),
      .determinants = lacks(Feature::kDeterminant),
      .signed_words = true,
      // VUID-StandaloneSpirv-UniformConstant-04655
      .flat_arrays = IsVulkan() || lacks(Feature::kArraysOfArrays),
      // glslang makes the texture with its sampler before the choice, which SPIR-V has in another
      // block, and SPIR-V asks for both in one (OpSampledImage).
      .simple_operands = IsVulkan(),
      .simple_indices = !IsVulkan(),
  };
}

legalize::Needs Target::Needs() const {
  using legalize::ArraySplit;
  legalize::Needs needs = needs_;
  if (!IsVulkan()) needs.split_arrays = ArraySplit::kSamplers;
  if (IsVulkan() && bindings.splits_arrays) needs.split_arrays = ArraySplit::kAll;
  return needs;
}

}  // namespace clipc::glsl
