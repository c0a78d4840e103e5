// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/parse/keywords.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "base/spelling.h"
#include "base/word_index.h"

namespace clipc {
namespace {

struct Entry {
  std::string_view text;
  WordInfo info;
  bool is_exact = false;  // for words in kFolded: found in this spelling only
};

constexpr bool kAnyCase = false, kExact = true;  // in base/builtin_types.def

constexpr Entry Plain(std::string_view text, Word word) { return {text, {word}}; }
constexpr Entry MayQualify(std::string_view text) { return {text, {Word::kContextualQualifier}}; }
constexpr Entry Object(std::string_view text, bool is_exact = true) {
  return {text, {Word::kObjectType}, is_exact};
}

constexpr auto kWords = [] {
  using enum Word;
  return std::to_array<Entry>({
      Plain("if", kIf),
      Plain("else", kElse),
      Plain("for", kFor),
      Plain("while", kWhile),
      Plain("do", kDo),
      Plain("switch", kSwitch),
      Plain("case", kCase),
      Plain("default", kDefault),
      Plain("return", kReturn),
      Plain("break", kBreak),
      Plain("continue", kContinue),
      Plain("discard", kDiscard),
      Plain("struct", kStruct),
      Plain("class", kClass),
      Plain("interface", kInterface),
      Plain("typedef", kTypedef),
      Plain("using", kUsing),
      Plain("namespace", kNamespace),
      Plain("enum", kEnum),
      Plain("template", kTemplate),
      Plain("typename", kTypename),
      Plain("cbuffer", kCbuffer),
      Plain("tbuffer", kTbuffer),
      Plain("operator", kOperator),
      Plain("_Static_assert", kStaticAssert),
      Plain("static_assert", kStaticAssert),
      Plain("true", kTrue),
      Plain("false", kFalse),
      Plain("sizeof", kSizeof),
      Plain("unsigned", kUnsigned),
      Plain("void", kNumericType),
      Plain("DWORD", kNumericType),
#define QUALIFIER(bit, spelling, word) {spelling, {word, false, ast::bit}},
#include "frontend/parse/qualifier_bits.def"
      {"inout", {kQualifier, false, ast::kIn | ast::kOut}},
      // Qualifiers to which clipc gives no meaning.
      MayQualify("reordercoherent"),
      MayQualify("center"),
      MayQualify("noinline"),
      MayQualify("varying"),  // Cg
      MayQualify("single"),   // of a cbuffer, in effects
      // Mesh shaders.
      MayQualify("vertices"),
      MayQualify("indices"),
      MayQualify("primitives"),
      MayQualify("payload"),
      Object("vector"),
      Object("matrix"),
      Object("ConstantBuffer"),
      Object("TextureBuffer"),
      Object("string"),
      Plain("register", kRegister),
      Plain("layout", kLayout),
      Plain("packoffset", kPackOffset),
      Plain("CompileShader", kCompileShader),
  });
}();

// The words that are found without regard to case.
constexpr auto kFolded = [] {
  using enum Word;
  return std::to_array<Entry>({
      Plain("technique", kTechnique),
      Plain("technique10", kTechnique),
      Plain("technique11", kTechnique),
      Plain("fxgroup", kTechnique),
      Plain("compile", kCompile),
      Plain("compile_fragment", kCompile),
      Plain("sampler_state", kSamplerState),
      Plain("stateblock_state", kSamplerState),
      Plain("asm", kAsm),
      Plain("asm_fragment", kAsm),
#define OBJECT(Enumerator, Spelling, Case, ...) Object(Spelling, Case),
#define OBJECT_ALIAS(Enumerator, Spelling, Case) Object(Spelling, Case),
#define UNUSABLE(Spelling, Case) Object(Spelling, Case),
#define UNUSABLE_SHADER(Spelling) {Spelling, {kObjectType, true}},
#define PATCH(Spelling) Object(Spelling),
#include "base/builtin_types.def"
  });
}();

// Numeric types, alone or with a size: `float`, `float3`, `float3x4`.
constexpr auto kScalars = std::to_array<std::string_view>({
    "dword",
#define SCALAR(Enumerator, Spelling) Spelling,
#define SCALAR_ALIAS(Enumerator, Spelling) Spelling,
#include "base/builtin_types.def"
});

constexpr std::size_t kLongestFolded = 40;
// The texts of kFolded in lower case, each at a multiple of kLongestFolded.
constexpr auto kLowerCase = [] {
  std::array<char, kFolded.size() * kLongestFolded> letters{};
  for (std::size_t i = 0; i < kFolded.size(); ++i) {
    std::size_t at = i * kLongestFolded;
    for (const char c : kFolded[i].text) letters[at++] = ToLower(c);
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
  if (!kFoldedIndex.MayHave(text) || text.size() > kLongestFolded) return {};
  std::array<char, kLongestFolded> lower;
  std::ranges::transform(text, lower.begin(), [](char c) { return ToLower(c); });
  const std::size_t i = kFoldedIndex.Find({lower.data(), text.size()});
  if (i == kFoldedIndex.kNone || (kFolded[i].is_exact && kFolded[i].text != text)) return {};
  return kFolded[i].info;
}

}  // namespace clipc
