// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/stage.h"
#include "ir/interface.h"
#include "legalize/needs.h"

// The dialects of GLSL that clipc writes, and what each of them can say.
namespace clipc::glsl {

enum class Api : std::uint8_t {
  kOpenGL,
  kOpenGLES,
  kWebGL,  // the GLSL of OpenGL ES with the extensions that browsers have
  kVulkan,
};

// A part of GLSL that some versions lack. The rows of target.cpp say which versions have it.
enum class Feature : std::uint8_t {
  kSpirv,  // the application may give SPIR-V in place of GLSL
  // ---- the interface
  kInAndOut,         // `in` and `out`; else `attribute` and `varying`
  kInputLocations,   // layout(location = 0) of an input
  kOutputLocations,  // layout(location = 0) of an output
  kOutputBlocks,     // `out Block { .. } instance;`
  kBlockLocations,   // layout(location = 0) of an output block and of its members
  kIntegerVaryings,
  kDoubleVaryings,
  kNoPerspective,
  kCentroid,
  kPerSample,  // `sample out`
  // ---- uniforms
  kUniformBlocks,      // else plain uniforms, set by name
  kBlockInstances,     // `uniform Block { .. } instance;`
  kUniformTransposes,  // glUniformMatrix can transpose
  kExplicitOffsets,    // layout(offset = 16)
  kBindings,           // layout(binding = 0)
  kImages,             // images that a shader may write
  kImageFormats,       // images of two components, and reads and writes of one of any format
  kImageAtomics,       // atomic operations on images
  kStorageBuffers,     // `buffer`
  kMemoryBarriers,     // memoryBarrier
  kComputeShaders,     // local_size_x, `shared`, barrier, memoryBarrierShared
  kGeometryShaders,    // EmitVertex
  kEmitters,           // layout(invocations = 2)
  kStreams,            // layout(stream = 1)
  kTessellation,       // layout(vertices = 3) out, gl_TessCoord
  kInterlocks,         // beginInvocationInterlock
  kDynamicBlockIndex,  // indices, not constant, of arrays of blocks and of samplers
  // ---- built-in variables
  kClipDistance,
  kCullDistance,
  kClipVertex,
  kViewportOfVertex,  // gl_ViewportIndex, which a geometry shader writes
  kVertexId,
  kInstanceId,
  kDrawParameters,    // gl_BaseVertex, gl_BaseInstance, gl_DrawID
  kBaseVertexDraws,   // draw calls have a base vertex, and gl_VertexID includes it
  kLayerAndViewport,  // gl_Layer and gl_ViewportIndex
  kViewIndex,
  kShadingRate,
  // ---- of fragment shaders
  kTargetLocations,    // layout(location = 0) of an output to a render target
  kBlendIndices,       // two colors of a render target, for the blender
  kSeveralTargets,     // gl_FragData[1], where outputs have no locations
  kUpperLeftOrigin,    // layout(origin_upper_left) of gl_FragCoord
  kSampleVariables,    // gl_SampleID, gl_SampleMask and gl_SampleMaskIn
  kPrimitiveIdInput,   // gl_PrimitiveID
  kLayerInput,         // gl_Layer
  kViewportInput,      // gl_ViewportIndex
  kDepthOutput,        // gl_FragDepth
  kConservativeDepth,  // layout(depth_greater) of it
  kStencilOutput,      // gl_FragStencilRefARB
  kEarlyTests,         // layout(early_fragment_tests)
  kDerivatives,        // dFdx, dFdy, fwidth
  kFineDerivatives,    // dFdxFine and the like
  kExplicitLevels,     // textureLod and textureGrad in a fragment shader
  kLevelQueries,       // textureQueryLod
  kInterpolants,       // interpolateAtCentroid and the like
  kBarycentrics,       // gl_BaryCoordEXT, gl_BaryCoordNV
  kFullyCovered,       // gl_FragFullyCoveredNV
  kSampleCount,        // gl_NumSamples
  kHelperInvocation,   // gl_HelperInvocation
  // ---- lanes of a subgroup
  kSubgroups,
  kSubgroupVotes,
  kSubgroupBallots,
  kSubgroupArithmetic,
  kSubgroupShuffles,
  kSubgroupQuads,
  kSubgroupPartitions,
  kSubgroupInt64,  // the functions of subgroups for 64-bit integers
  // ---- types and expressions
  kUnsigned,            // uint, % << >> & | ^ ~, and int overloads of functions
  kSwitch,              // `switch`
  kFreeLoops,           // any loop; else constant bounds only: appendix A of GLSL ES 1.00
  kFreeIndices,         // any index; else, if not constant, of uniforms only: the same appendix
  kArrayValues,         // arrays are values: constructors, assignments, results of functions
  kStructChoices,       // `?:` between structs, and so between arrays where these are structs
  kArraysOfArrays,      // else the inner array is wrapped in a struct
  kGlobalInitializers,  // values of global variables that are not constant expressions
  kPrecise,             // `precise`
  kDoubles,
  kInt64,
  kBitCasts,      // floatBitsToUint and the like
  kHalfPacking,   // packHalf2x16
  kBitFunctions,  // bitCount, findMSB, findLSB, bitfieldReverse
  kBoolMix,       // mix(float, float, bool)
  kIntegerMix,    // mix of int, uint and bool
  kRounding,      // roundEven, trunc, modf, isnan, isinf, sinh, cosh, tanh
  kDeterminant,
  kFullMatrices,  // mat4x3, transpose, outerProduct, matrices made of matrices
  // ---- textures
  kTextureFunctions,  // textureLod, texelFetch, textureSize; integer samplers
  kShadowSamplers,    // sampler2DShadow
  kTextureArrays,
  kTextureStatus,       // sparseTextureARB and the like
  kLevelClamps,         // textureClampARB and the like
  kShadowArrayOffsets,  // textureOffset of sampler2DArrayShadow
  kTexture1D,
  kTexture3D,
  kCubeArrays,
  kMultisample,
  kMultisampleArrays,
  kTextureBuffers,
  kGather,            // of the first component
  kGatherComponents,  // of another component, or one that compares
  kGatherOffsets,     // one offset for each of the four texels, or one that is not constant
  kTextureLevels,     // textureQueryLevels
  kTextureSamples,    // textureSamples
  kCount,
};

// The support of a target for a feature: none, in its core (no extension), or through an extension
// that the shader must name.
struct Support {
  bool has = false;
  std::string_view extension = {};
};

// The letters of rules for kinds of GLSL's objects, of any register: RWTexture2D, RWBuffer and the
// like; structured and byte address buffers, RW or not.
inline constexpr char kImages = 'I', kStorageBlocks = 'B';
// The binding in Vulkan of registers of one letter: of all, of those of one space, or of one
// register.
struct BindingRule {
  char letter = 'b';
  std::optional<std::uint32_t> number = {};  // this register only
  std::optional<std::uint32_t> space = {};   // in this space only
  std::uint32_t binding = 0;                 // of register `number`, or without it of register 0
  std::optional<std::uint32_t> set = {};     // none: the register's space
  std::optional<Stage> stage = {};           // in shaders of this stage only
};
struct BindingRules {
  std::vector<BindingRule> rules;  // in place of the usual ones (descriptors.h); a later one wins
  std::optional<ir::Descriptor> globals;       // the place of $Globals
  std::optional<std::uint32_t> unplaced_set;   // the set of objects without a register
  std::uint32_t plain_sets[kStageCount] = {};  // by stage: the set of space 0
  // A texture and a sampler may have one binding, where the host has a combined image sampler.
  bool combines_samplers = false;
  // Each element of an array of objects has a binding of its own: split_arrays.h.
  bool splits_arrays = false;
  bool keeps_unread = false;  // objects and buffers that the shader does not read have bindings too
  bool replaces_tool = false;  // another compiler's options ask for the usual rules, which it lacks
  bool sets_by_stage = false;  // the rules give each stage sets of its own, and nothing is shared
  std::vector<Stage> stages;   // the only ones that the host of the rules has; empty: all
  std::string_view host = {};  // the name of the rules: "sdl"
  std::optional<std::uint32_t> later_base;  // Target::BaseOf(); none: the target's own
};

class Target {
 public:
  // Returns the target called "glsl450", "essl300", "webgl1", "vulkan"; none if no target has the
  // name.
  static std::optional<Target> Parse(std::string_view name);
  static std::span<const std::string_view> Names();

  std::string_view name() const { return name_; }
  Api api() const { return api_; }
  bool IsVulkan() const { return api_ == Api::kVulkan; }
  bool IsEs() const { return api_ == Api::kOpenGLES || api_ == Api::kWebGL; }
  int version() const { return version_; }  // as in the #version line
  // The first target that has the feature, of the same API if any; empty: none has it.
  std::string_view NearestWith(Feature feature) const;
  std::string VersionLine() const;  // "#version 300 es", "#version 100"

  Support Of(Feature feature) const;
  bool Has(Feature feature) const { return Of(feature).has; }
  bool HasInCore(Feature feature) const { return Has(feature) && Of(feature).extension.empty(); }

  // What the target needs of the passes that make a program one that its GLSL can say.
  legalize::Needs Needs() const;

  // The number of textures that every OpenGL 4 and OpenGL ES 3.1 can bind at once, the least that
  // their GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS may be. glslang accepts no binding from 80 on.
  std::uint32_t TextureUnits() const { return IsEs() ? 48 : 80; }

  // What is added to the numbers of registers in a shader of the stage: to all bindings of Vulkan,
  // and to the units of OpenGL's textures. Shaders that are compiled alone then bind others. Of a
  // stage without one before it, 0.
  std::uint32_t BaseOf(Stage stage) const;

  BindingRules bindings;  // the rules of a Vulkan target
  bool KeepsBindings() const { return IsVulkan() && bindings.keeps_unread; }
  bool flips_y = false;  // the image is upside down, as textures are

  // Whether the window's y grows downwards in the image, as in Direct3D.
  bool HasUpperLeftOrigin() const { return IsVulkan() || flips_y; }

 private:
  Target(std::string_view name, Api api, int version) : name_(name), api_(api), version_(version) {}
  legalize::Needs FindNeeds() const;

  std::string_view name_;
  Api api_;
  int version_;
  legalize::Needs needs_ = {};  // but for the arrays that are split
};

}  // namespace clipc::glsl
