// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/reserved_words.h"

#include <array>

#include "base/word_index.h"

namespace clipc::glsl {
namespace {

// The words of section 3.6 of the GLSL 1.20 to 4.60 and GLSL ES 3.00 to 3.20 specifications and of
// KHR_vulkan_glsl, layout qualifiers that older versions reserve, and the types of the
// explicit-arithmetic-types extensions.
constexpr std::string_view kKeywords = R"(
VULKAN active asm atomic_uint attribute bool break buffer bvec2 bvec3 bvec4 case cast centroid
class coherent column_major common const continue default defined demote disable discard dmat2
dmat2x2 dmat2x3 dmat2x4 dmat3 dmat3x2 dmat3x3 dmat3x4 dmat4 dmat4x2 dmat4x3 dmat4x4 do double
dvec2 dvec3 dvec4 else enable enum extern external f16mat2 f16mat2x2 f16mat2x3 f16mat2x4 f16mat3
f16mat3x2 f16mat3x3 f16mat3x4 f16mat4 f16mat4x2 f16mat4x3 f16mat4x4 f16vec2 f16vec3 f16vec4
f32mat2 f32mat2x2 f32mat2x3 f32mat2x4 f32mat3 f32mat3x2 f32mat3x3 f32mat3x4 f32mat4 f32mat4x2
f32mat4x3 f32mat4x4 f32vec2 f32vec3 f32vec4 f64mat2 f64mat2x2 f64mat2x3 f64mat2x4 f64mat3
f64mat3x2 f64mat3x3 f64mat3x4 f64mat4 f64mat4x2 f64mat4x3 f64mat4x4 f64vec2 f64vec3 f64vec4
false filter fixed flat float float16_t float32_t float64_t for fvec2 fvec3 fvec4 goto half
highp hvec2 hvec3 hvec4 i16vec2 i16vec3 i16vec4 i32vec2 i32vec3 i32vec4 i64vec2 i64vec3 i64vec4
i8vec2 i8vec3 i8vec4 if iimage1D iimage1DArray iimage2D iimage2DArray iimage2DMS iimage2DMSArray
iimage2DRect iimage3D iimageBuffer iimageCube iimageCubeArray image1D image1DArray image2D
image2DArray image2DMS image2DMSArray image2DRect image3D imageBuffer imageCube imageCubeArray
in inline inout input int int16_t int32_t int64_t int8_t interface invariant isampler1D
isampler1DArray isampler2D isampler2DArray isampler2DMS isampler2DMSArray isampler2DRect
isampler3D isamplerBuffer isamplerCube isamplerCubeArray isubpassInput isubpassInputMS
itexture1D itexture1DArray itexture2D itexture2DArray itexture2DMS itexture2DMSArray
itexture2DRect itexture3D itextureBuffer itextureCube itextureCubeArray ivec2 ivec3 ivec4 layout
long lowp main mat2 mat2x2 mat2x3 mat2x4 mat3 mat3x2 mat3x3 mat3x4 mat4 mat4x2 mat4x3 mat4x4
mediump namespace noinline nonuniformEXT noperspective out output packed partition patch precise
precision public readonly require resource restrict return row_major sample sampler sampler1D
sampler1DArray sampler1DArrayShadow sampler1DShadow sampler2D sampler2DArray
sampler2DArrayShadow sampler2DMS sampler2DMSArray sampler2DRect sampler2DRectShadow
sampler2DShadow sampler3D sampler3DRect samplerBuffer samplerCube samplerCubeArray
samplerCubeArrayShadow samplerCubeShadow samplerExternalOES samplerShadow shared short sizeof
smooth static std140 std430 struct subpassInput subpassInputMS subroutine superp switch template
texture1D texture1DArray texture2D texture2DArray texture2DMS texture2DMSArray texture2DRect
texture3D textureBuffer textureCube textureCubeArray this true typedef u16vec2 u16vec3 u16vec4
u32vec2 u32vec3 u32vec4 u64vec2 u64vec3 u64vec4 u8vec2 u8vec3 u8vec4 uimage1D uimage1DArray
uimage2D uimage2DArray uimage2DMS uimage2DMSArray uimage2DRect uimage3D uimageBuffer uimageCube
uimageCubeArray uint uint16_t uint32_t uint64_t uint8_t uniform union unsigned usampler1D
usampler1DArray usampler2D usampler2DArray usampler2DMS usampler2DMSArray usampler2DRect
usampler3D usamplerBuffer usamplerCube usamplerCubeArray using usubpassInput usubpassInputMS
utexture1D utexture1DArray utexture2D utexture2DArray utexture2DMS utexture2DMSArray
utexture2DRect utexture3D utextureBuffer utextureCube utextureCubeArray uvec2 uvec3 uvec4
varying vec2 vec3 vec4 void volatile warn while writeonly
)";

// The functions of chapter 8 of the same specifications, with those that were removed again.
constexpr std::string_view kFunctions = R"(
EmitStreamVertex EmitVertex EndPrimitive EndStreamPrimitive abs acos acosh all allInvocations
allInvocationsEqual any anyInvocation asin asinh atan atanh atomicAdd atomicAnd atomicCompSwap
atomicCounter atomicCounterAdd atomicCounterAnd atomicCounterCompSwap atomicCounterDecrement
atomicCounterExchange atomicCounterIncrement atomicCounterMax atomicCounterMin atomicCounterOr
atomicCounterSubtract atomicCounterXor atomicExchange atomicMax atomicMin atomicOr atomicXor
barrier bitCount bitfieldExtract bitfieldInsert bitfieldReverse ceil clamp cos cosh cross dFdx
dFdxCoarse dFdxFine dFdy dFdyCoarse dFdyFine degrees determinant distance dot doubleBitsToInt64
doubleBitsToUint64 equal exp exp2 faceforward findLSB findMSB floatBitsToInt floatBitsToUint
floor fma fract frexp ftransform fwidth fwidthCoarse fwidthFine greaterThan greaterThanEqual
groupMemoryBarrier imageAtomicAdd imageAtomicAnd imageAtomicCompSwap imageAtomicExchange
imageAtomicMax imageAtomicMin imageAtomicOr imageAtomicXor imageLoad imageSamples imageSize
imageStore imulExtended int64BitsToDouble intBitsToFloat interpolateAtCentroid
interpolateAtOffset interpolateAtSample inverse inversesqrt isinf isnan ldexp length lessThan
lessThanEqual log log2 matrixCompMult max memoryBarrier memoryBarrierAtomicCounter
memoryBarrierBuffer memoryBarrierImage memoryBarrierShared min mix mod modf noise1 noise2 noise3
noise4 normalize not notEqual outerProduct packDouble2x32 packHalf2x16 packInt2x32 packSnorm2x16
packSnorm4x8 packUint2x32 packUnorm2x16 packUnorm4x8 pow radians reflect refract round roundEven
shadow1D shadow1DLod shadow1DProj shadow1DProjLod shadow2D shadow2DLod shadow2DProj
shadow2DProjLod shadow2DRect shadow2DRectProj sign sin sinh smoothstep sqrt step subpassLoad tan
tanh texelFetch texelFetchOffset texture texture1DLod texture1DProj texture1DProjLod
texture2DLod texture2DProj texture2DProjLod texture2DRectProj texture3DLod texture3DProj
texture3DProjLod textureCubeLod textureGather textureGatherOffset textureGatherOffsets
textureGrad textureGradOffset textureLod textureLodOffset textureOffset textureProj
textureProjGrad textureProjGradOffset textureProjLod textureProjLodOffset textureProjOffset
textureQueryLOD textureQueryLevels textureQueryLod textureSamples textureSize transpose trunc
uaddCarry uint64BitsToDouble uintBitsToFloat umulExtended unpackDouble2x32 unpackHalf2x16
unpackInt2x32 unpackSnorm2x16 unpackSnorm4x8 unpackUint2x32 unpackUnorm2x16 unpackUnorm4x8
usubBorrow
)";

// The functions of extensions that glslang declares in every shader, as its option
// --dump-builtin-symbols lists them.
constexpr std::string_view kExtensionFunctions = R"(
absoluteDifference addInvocationsAMD addInvocationsExclusiveScanAMD
addInvocationsExclusiveScanNonUniformAMD addInvocationsInclusiveScanAMD
addInvocationsInclusiveScanNonUniformAMD addInvocationsNonUniformAMD addSaturate allInvocationsARB
allInvocationsEqualARB anyInvocationARB atomicCounterAddARB atomicCounterAndARB
atomicCounterCompSwapARB atomicCounterExchangeARB atomicCounterMaxARB atomicCounterMinARB
atomicCounterOrARB atomicCounterSubtractARB atomicCounterXorARB atomicLoad atomicStore average
averageRounded ballotARB beginInvocationInterlockARB clock2x32ARB clockARB clockRealtime2x32EXT
clockRealtimeEXT controlBarrier countLeadingZeros countTrailingZeros cubeFaceCoordAMD
cubeFaceIndexAMD debugPrintfEXT endInvocationInterlockARB float16BitsToInt16 float16BitsToUint16
fragmentFetchAMD fragmentMaskFetchAMD halfBitsToInt16 halfBitsToUint16 halhBitsToInt16
helperInvocationEXT imageAtomicLoad imageAtomicStore imageLoadLodAMD imageStoreLodAMD
int16BitsToFloat16 int16BitsToHalf interpolateAtVertexAMD max3 maxInvocationsAMD
maxInvocationsExclusiveScanAMD maxInvocationsExclusiveScanNonUniformAMD
maxInvocationsInclusiveScanAMD maxInvocationsInclusiveScanNonUniformAMD maxInvocationsNonUniformAMD
mbcntAMD mid3 min3 minInvocationsAMD minInvocationsExclusiveScanAMD
minInvocationsExclusiveScanNonUniformAMD minInvocationsInclusiveScanAMD
minInvocationsInclusiveScanNonUniformAMD minInvocationsNonUniformAMD multiply32x16 pack16 pack32
pack64 packFloat2x16 packInt2x16 packInt4x16 packUint2x16 packUint4x16
rayQueryConfirmIntersectionEXT rayQueryGenerateIntersectionEXT
rayQueryGetIntersectionBarycentricsEXT rayQueryGetIntersectionCandidateAABBOpaqueEXT
rayQueryGetIntersectionFrontFaceEXT rayQueryGetIntersectionGeometryIndexEXT
rayQueryGetIntersectionInstanceCustomIndexEXT rayQueryGetIntersectionInstanceIdEXT
rayQueryGetIntersectionInstanceShaderBindingTableRecordOffsetEXT
rayQueryGetIntersectionObjectRayDirectionEXT rayQueryGetIntersectionObjectRayOriginEXT
rayQueryGetIntersectionObjectToWorldEXT rayQueryGetIntersectionPrimitiveIndexEXT
rayQueryGetIntersectionTEXT rayQueryGetIntersectionTypeEXT rayQueryGetIntersectionWorldToObjectEXT
rayQueryGetRayFlagsEXT rayQueryGetRayTMinEXT rayQueryGetWorldRayDirectionEXT
rayQueryGetWorldRayOriginEXT rayQueryInitializeEXT rayQueryProceedEXT rayQueryTerminateEXT
readFirstInvocationARB readInvocationARB shadow1DGradARB shadow1DProjGradARB shadow2DEXT
shadow2DGradARB shadow2DProjEXT shadow2DProjGradARB shadow2DRectGradARB shadow2DRectProjGradARB
sparseImageLoadARB sparseImageLoadLodAMD sparseTexelFetchARB sparseTexelFetchOffsetARB
sparseTexelGradFetchARB sparseTexelGradFetchOffsetARB sparseTexelsResidentARB sparseTextureARB
sparseTextureClampARB sparseTextureGatherARB sparseTextureGatherLodAMD
sparseTextureGatherLodOffsetAMD sparseTextureGatherLodOffsetsAMD sparseTextureGatherOffsetARB
sparseTextureGatherOffsetsARB sparseTextureGradARB sparseTextureGradClampARB
sparseTextureGradOffsetARB sparseTextureGradOffsetClampARB sparseTextureLodARB
sparseTextureLodOffsetARB sparseTextureOffsetARB sparseTextureOffsetClampARB subgroupAdd subgroupAll
subgroupAllEqual subgroupAnd subgroupAny subgroupBallot subgroupBallotBitCount
subgroupBallotBitExtract subgroupBallotExclusiveBitCount subgroupBallotFindLSB subgroupBallotFindMSB
subgroupBallotInclusiveBitCount subgroupBarrier subgroupBroadcast subgroupBroadcastFirst
subgroupClusteredAdd subgroupClusteredAnd subgroupClusteredMax subgroupClusteredMin
subgroupClusteredMul subgroupClusteredOr subgroupClusteredXor subgroupElect subgroupExclusiveAdd
subgroupExclusiveAnd subgroupExclusiveMax subgroupExclusiveMin subgroupExclusiveMul
subgroupExclusiveOr subgroupExclusiveXor subgroupInclusiveAdd subgroupInclusiveAnd
subgroupInclusiveMax subgroupInclusiveMin subgroupInclusiveMul subgroupInclusiveOr
subgroupInclusiveXor subgroupInverseBallot subgroupMax subgroupMemoryBarrier
subgroupMemoryBarrierBuffer subgroupMemoryBarrierImage subgroupMin subgroupMul subgroupOr
subgroupPartitionNV subgroupPartitionedAddNV subgroupPartitionedAndNV
subgroupPartitionedExclusiveAddNV subgroupPartitionedExclusiveAndNV
subgroupPartitionedExclusiveMaxNV subgroupPartitionedExclusiveMinNV
subgroupPartitionedExclusiveMulNV subgroupPartitionedExclusiveOrNV subgroupPartitionedExclusiveXorNV
subgroupPartitionedInclusiveAddNV subgroupPartitionedInclusiveAndNV
subgroupPartitionedInclusiveMaxNV subgroupPartitionedInclusiveMinNV
subgroupPartitionedInclusiveMulNV subgroupPartitionedInclusiveOrNV subgroupPartitionedInclusiveXorNV
subgroupPartitionedMaxNV subgroupPartitionedMinNV subgroupPartitionedMulNV subgroupPartitionedOrNV
subgroupPartitionedXorNV subgroupQuadBroadcast subgroupQuadSwapDiagonal subgroupQuadSwapHorizontal
subgroupQuadSwapVertical subgroupShuffle subgroupShuffleDown subgroupShuffleUp subgroupShuffleXor
subgroupXor subtractSaturate swizzleInvocationsAMD swizzleInvocationsMaskedAMD texelGradFetch
texelGradFetchOffset texelProjFetch texelProjFetchOffset texelProjGradFetch texture1DGradARB
texture1DProjGradARB texture2DGradARB texture2DGradEXT texture2DLodEXT texture2DProjGradARB
texture2DProjGradEXT texture2DProjLodEXT texture2DRectGradARB texture2DRectProjGradARB
texture3DGradARB texture3DProjGradARB textureClampARB textureCubeGradARB textureCubeGradEXT
textureCubeLodEXT textureFootprintClampNV textureFootprintGradClampNV textureFootprintGradNV
textureFootprintLodNV textureFootprintNV textureGatherLodAMD textureGatherLodOffsetAMD
textureGatherLodOffsetsAMD textureGradClampARB textureGradOffsetClampARB textureOffsetClampARB
timeAMD uint16BitsToFloat16 uint16BitsToHalf unpack16 unpack32 unpack8 unpackFloat2x16 unpackInt2x16
unpackInt4x16 unpackUint2x16 unpackUint4x16 writeInvocationAMD
)";

// The identifiers of section 4.4, "Layout Qualifiers", of the same specifications, of
// GLSL_OVR_multiview and of KHR_vulkan_glsl.
constexpr std::string_view kLayoutWords = R"(
align binding ccw component constant_id cw depth_any depth_greater depth_less depth_unchanged
early_fragment_tests equal_spacing fractional_even_spacing fractional_odd_spacing index
input_attachment_index invocations isolines line_strip lines lines_adjacency local_size_x
local_size_x_id local_size_y local_size_y_id local_size_z local_size_z_id location max_vertices
num_views offset origin_upper_left pixel_center_integer point_mode points push_constant quads
r11f_g11f_b10f r16 r16_snorm r16f r16i r16ui r32f r32i r32ui r64i r64ui r8 r8_snorm r8i r8ui
rg16 rg16_snorm rg16f rg16i rg16ui rg32f rg32i rg32ui rg8 rg8_snorm rg8i rg8ui rgb10_a2
rgb10_a2ui rgba16 rgba16_snorm rgba16f rgba16i rgba16ui rgba32f rgba32i rgba32ui rgba8
rgba8_snorm rgba8i rgba8ui scalar set std140 std430 stream triangle_strip triangles
triangles_adjacency vertices xfb_buffer xfb_offset xfb_stride
)";

// The words of `text`, which blanks and line ends separate.
template <std::size_t N>
constexpr std::array<std::string_view, N> Split(std::string_view text) {
  std::array<std::string_view, N> words;
  for (std::size_t i = 0; i < N; ++i) {
    text.remove_prefix(text.find_first_not_of(" \n"));
    words[i] = text.substr(0, text.find_first_of(" \n"));
    text.remove_prefix(words[i].size());
  }
  return words;
}

constexpr std::size_t Count(std::string_view text) {
  std::size_t count = 0;
  for (std::size_t i = 1; i < text.size(); ++i) {
    count += text[i - 1] > ' ' && text[i] <= ' ' ? 1 : 0;
  }
  return count;
}

constexpr WordIndex kKeywordIndex(Split<Count(kKeywords)>(kKeywords));
constexpr WordIndex kFunctionIndex(Split<Count(kFunctions)>(kFunctions));
constexpr WordIndex kExtensionIndex(Split<Count(kExtensionFunctions)>(kExtensionFunctions));
constexpr WordIndex kLayoutIndex(Split<Count(kLayoutWords)>(kLayoutWords));

}  // namespace

bool IsKeyword(std::string_view word) { return kKeywordIndex.Has(word); }

bool IsBuiltinFunction(std::string_view word) { return kFunctionIndex.Has(word); }

bool IsExtensionFunction(std::string_view word) { return kExtensionIndex.Has(word); }

bool IsLayoutWord(std::string_view word) { return kLayoutIndex.Has(word); }

}  // namespace clipc::glsl
