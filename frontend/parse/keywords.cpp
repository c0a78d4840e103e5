// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/parse/keywords.h"

#include <array>
#include <cstdint>
#include <string>

#include "base/word_index.h"

namespace clipc {
namespace {

struct Entry {
  std::string_view text;
  WordInfo info;
};

constexpr Entry Plain(std::string_view text, Word word) { return {text, {word}}; }
constexpr Entry MayQualify(std::string_view text) { return {text, {Word::kContextualQualifier}}; }
constexpr Entry Object(std::string_view text) { return {text, {Word::kObjectType}}; }
constexpr Entry ShaderType(std::string_view text) { return {text, {Word::kObjectType, true}}; }

constexpr auto kExact = std::to_array<Entry>({
    Plain("if", Word::kIf),
    Plain("else", Word::kElse),
    Plain("for", Word::kFor),
    Plain("while", Word::kWhile),
    Plain("do", Word::kDo),
    Plain("switch", Word::kSwitch),
    Plain("case", Word::kCase),
    Plain("default", Word::kDefault),
    Plain("return", Word::kReturn),
    Plain("break", Word::kBreak),
    Plain("continue", Word::kContinue),
    Plain("discard", Word::kDiscard),
    Plain("struct", Word::kStruct),
    Plain("class", Word::kClass),
    Plain("interface", Word::kInterface),
    Plain("typedef", Word::kTypedef),
    Plain("using", Word::kUsing),
    Plain("namespace", Word::kNamespace),
    Plain("enum", Word::kEnum),
    Plain("template", Word::kTemplate),
    Plain("typename", Word::kTypename),
    Plain("cbuffer", Word::kCbuffer),
    Plain("tbuffer", Word::kTbuffer),
    Plain("operator", Word::kOperator),
    Plain("_Static_assert", Word::kStaticAssert),
    Plain("static_assert", Word::kStaticAssert),
    Plain("true", Word::kTrue),
    Plain("false", Word::kFalse),
    Plain("sizeof", Word::kSizeof),
    Plain("unsigned", Word::kUnsigned),
    Plain("void", Word::kNumericType),
    Plain("DWORD", Word::kNumericType),
#define QUALIFIER(bit, spelling, word) {spelling, {Word::word, false, ast::bit}},
#include "frontend/parse/qualifiers.def"
    {"inout", {Word::kQualifier, false, ast::kIn | ast::kOut}},
    // Qualifiers without a meaning for a vertex shader.
    MayQualify("reordercoherent"),
    MayQualify("center"),
    MayQualify("noinline"),
    MayQualify("varying"),  // Cg
    // Geometry and mesh shaders.
    MayQualify("point"),
    MayQualify("line"),
    MayQualify("triangle"),
    MayQualify("lineadj"),
    MayQualify("triangleadj"),
    MayQualify("vertices"),
    MayQualify("indices"),
    MayQualify("primitives"),
    MayQualify("payload"),
    Object("vector"),
    Object("matrix"),
    Object("RWTexture1D"),
    Object("RWTexture1DArray"),
    Object("RWTexture2D"),
    Object("RWTexture2DArray"),
    Object("RWTexture2DMS"),
    Object("RWTexture2DMSArray"),
    Object("RWTexture3D"),
    Object("RasterizerOrderedBuffer"),
    Object("RasterizerOrderedByteAddressBuffer"),
    Object("RasterizerOrderedStructuredBuffer"),
    Object("RasterizerOrderedTexture1D"),
    Object("RasterizerOrderedTexture1DArray"),
    Object("RasterizerOrderedTexture2D"),
    Object("RasterizerOrderedTexture2DArray"),
    Object("RasterizerOrderedTexture3D"),
    Object("FeedbackTexture2D"),
    Object("FeedbackTexture2DArray"),
    Object("Buffer"),
    Object("RWBuffer"),
    Object("StructuredBuffer"),
    Object("RWStructuredBuffer"),
    Object("AppendStructuredBuffer"),
    Object("ConsumeStructuredBuffer"),
    Object("ByteAddressBuffer"),
    Object("RWByteAddressBuffer"),
    Object("ConstantBuffer"),
    Object("TextureBuffer"),
    Object("PointStream"),
    Object("LineStream"),
    Object("TriangleStream"),
    Object("InputPatch"),
    Object("OutputPatch"),
    Object("RayQuery"),
    Object("RaytracingAccelerationStructure"),
    Object("SubpassInput"),
    Object("SubpassInputMS"),
    Object("string"),
    Plain("register", Word::kRegister),
    Plain("layout", Word::kLayout),
    Plain("packoffset", Word::kPackOffset),
    Plain("CompileShader", Word::kCompileShader),
});

// In lower case.
constexpr auto kAnyCase = std::to_array<Entry>({
    Plain("technique", Word::kTechnique),
    Plain("technique10", Word::kTechnique),
    Plain("technique11", Word::kTechnique),
    Plain("fxgroup", Word::kTechnique),
    Plain("compile", Word::kCompile),
    Plain("compile_fragment", Word::kCompile),
    Plain("sampler_state", Word::kSamplerState),
    Plain("stateblock_state", Word::kSamplerState),
    Plain("asm", Word::kAsm),
    Plain("asm_fragment", Word::kAsm),
    Object("texture"),
    Object("texture1d"),
    Object("texture1darray"),
    Object("texture2d"),
    Object("texture2darray"),
    Object("texture2dms"),
    Object("texture2dmsarray"),
    Object("texture3d"),
    Object("texturecube"),
    Object("texturecubearray"),
    Object("sampler"),
    Object("sampler1d"),
    Object("sampler2d"),
    Object("sampler3d"),
    Object("samplercube"),
    Object("samplerstate"),
    Object("samplercomparisonstate"),
    Object("blendstate"),
    Object("depthstencilstate"),
    Object("rasterizerstate"),
    Object("rendertargetview"),
    Object("depthstencilview"),
    Object("stateblock"),
    ShaderType("vertexshader"),
    ShaderType("pixelshader"),
    ShaderType("geometryshader"),
    ShaderType("hullshader"),
    ShaderType("domainshader"),
    ShaderType("computeshader"),
    ShaderType("vertexfragment"),
    ShaderType("pixelfragment"),
});

// Numeric types, alone or with a size: `float`, `float3`, `float3x4`.
constexpr auto kScalars = std::to_array<std::string_view>({
    "bool",
    "int",
    "uint",
    "dword",
    "half",
    "float",
    "double",
    "min16float",
    "min10float",
    "min16int",
    "min12int",
    "min16uint",
    "int16_t",
    "uint16_t",
    "int32_t",
    "uint32_t",
    "int64_t",
    "uint64_t",
    "float16_t",
    "float32_t",
    "float64_t",
    "int8_t4_packed",
    "uint8_t4_packed",
});

template <std::size_t N>
constexpr auto IndexOf(const std::array<Entry, N>& entries) {
  std::array<std::string_view, N> words;
  for (std::size_t i = 0; i < N; ++i) words[i] = entries[i].text;
  return WordIndex(words);
}
constexpr auto kExactIndex = IndexOf(kExact);
constexpr auto kAnyCaseIndex = IndexOf(kAnyCase);
constexpr WordIndex kScalarIndex(kScalars);

// By first letter: which lengths the words of any case have.
constexpr auto kAnyCaseLengths = [] {
  std::array<std::uint32_t, 32> lengths{};
  for (const Entry& entry : kAnyCase) lengths[entry.text[0] & 31] |= 1u << entry.text.size();
  return lengths;
}();

constexpr bool MayBeAnyCase(std::string_view text) {
  return !text.empty() && text.size() < 32 &&
         (kAnyCaseLengths[text[0] & 31] >> text.size() & 1) != 0;
}

constexpr bool EndsInSize(std::string_view text) {
  return !text.empty() && text.back() >= '1' && text.back() <= '4';
}

bool IsNumericType(std::string_view text) {
  if (EndsInSize(text)) {
    text.remove_suffix(1);
    if (text.ends_with('x') && EndsInSize(text.substr(0, text.size() - 1))) text.remove_suffix(2);
  }
  return kScalarIndex.Has(text);
}

}  // namespace

WordInfo ClassifyWord(std::string_view text) {
  if (const std::size_t i = kExactIndex.Find(text); i != kExactIndex.kNone) return kExact[i].info;
  if (IsNumericType(text)) return {Word::kNumericType};
  if (!MayBeAnyCase(text)) return {};
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  if (const std::size_t i = kAnyCaseIndex.Find(lower); i != kAnyCaseIndex.kNone)
    return kAnyCase[i].info;
  return {};
}

}  // namespace clipc
