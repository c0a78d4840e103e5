// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/parse/keywords.h"

#include <array>
#include <cstdint>
#include <string>

#include "base/spelling.h"
#include "base/word_index.h"

namespace clipc {
namespace {

struct Entry {
  std::string_view text;
  WordInfo info;
  bool is_exact = false;  // of words in kFolded: they are found in this spelling only
};

constexpr bool kAnyCase = false, kExact = true;  // in base/builtin_types.def

constexpr Entry Plain(std::string_view text, Word word) { return {text, {word}}; }
constexpr Entry MayQualify(std::string_view text) { return {text, {Word::kContextualQualifier}}; }
constexpr Entry Object(std::string_view text, bool is_exact = true) {
  return {text, {Word::kObjectType}, is_exact};
}

constexpr auto kWords = std::to_array<Entry>({
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
    Object("ConstantBuffer"),
    Object("TextureBuffer"),
    Object("string"),
    Plain("register", Word::kRegister),
    Plain("layout", Word::kLayout),
    Plain("packoffset", Word::kPackOffset),
    Plain("CompileShader", Word::kCompileShader),
});

// Found without regard to case.
constexpr auto kFolded = std::to_array<Entry>({
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
#define OBJECT(Enumerator, Spelling, Case, ...) Object(Spelling, Case),
#define OBJECT_ALIAS(Enumerator, Spelling, Case) Object(Spelling, Case),
#define UNUSABLE(Spelling, Case) Object(Spelling, Case),
#define UNUSABLE_SHADER(Spelling) {Spelling, {Word::kObjectType, true}},
#include "base/builtin_types.def"
});

// Numeric types, alone or with a size: `float`, `float3`, `float3x4`.
constexpr auto kScalars = std::to_array<std::string_view>({
    "dword",
#define SCALAR(Enumerator, Spelling) Spelling,
#define SCALAR_ALIAS(Enumerator, Spelling) Spelling,
#include "base/builtin_types.def"
});

constexpr std::size_t kLongestFolded = 40;
// The texts of kFolded in lower case, one after a multiple of kLongestFolded each.
constexpr auto kLowerCase = [] {
  std::array<char, kFolded.size() * kLongestFolded> letters{};
  for (std::size_t i = 0; i < kFolded.size(); ++i) {
    std::size_t at = i * kLongestFolded;
    for (const char c : kFolded[i].text)
      letters[at++] = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return letters;
}();

constexpr WordIndex kWordIndex = [] {
  std::array<std::string_view, kWords.size()> words;
  for (std::size_t i = 0; i < words.size(); ++i) words[i] = kWords[i].text;
  return WordIndex(words);
}();
constexpr WordIndex kFoldedIndex = [] {
  std::array<std::string_view, kFolded.size()> words;
  for (std::size_t i = 0; i < words.size(); ++i)
    words[i] = {&kLowerCase[i * kLongestFolded], kFolded[i].text.size()};
  return WordIndex(words);
}();
constexpr WordIndex kScalarIndex(kScalars);

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
  if (const std::size_t i = kWordIndex.Find(text); i != kWordIndex.kNone) return kWords[i].info;
  if (IsNumericType(text)) return {Word::kNumericType};
  const std::size_t i = kFoldedIndex.Find(ToLower(text));
  if (i == kFoldedIndex.kNone || (kFolded[i].is_exact && kFolded[i].text != text)) return {};
  return kFolded[i].info;
}

}  // namespace clipc
