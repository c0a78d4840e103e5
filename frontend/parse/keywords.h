// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <concepts>
#include <cstdint>
#include <string_view>

#include "frontend/parse/ast_decl.h"

// The words of HLSL's grammar. Real shaders use many of them as names, so few are reserved: the
// others are names wherever the parser finds that a name fits better.
namespace clipc {

enum class Word : std::uint8_t {
  kNone,  // an ordinary name
  // statements
  kIf,
  kElse,
  kFor,
  kWhile,
  kDo,
  kSwitch,
  kCase,
  kDefault,
  kReturn,
  kBreak,
  kContinue,
  kDiscard,
  // declarations
  kStruct,
  kClass,
  kInterface,
  kTypedef,
  kUsing,
  kNamespace,
  kEnum,
  kTemplate,
  kTypename,
  kCbuffer,
  kTbuffer,
  kOperator,
  kStaticAssert,
  // expressions
  kTrue,
  kFalse,
  kSizeof,
  kQualifier,    // `const`, `static`, `in`, ...
  kUnsigned,     // `unsigned int`
  kNumericType,  // `void`, `float4x4`, `min16uint2`, ...
  // names, unless the context says otherwise
  kContextualQualifier,  // `sample`, `point`, `precise`, ...: a qualifier when a type follows
  kObjectType,           // `Texture2D`, `sampler`, `vector`, `string`, ...
  kRegister,
  kPackOffset,
  kLayout,     // layout(...), Vulkan's attributes in the dialect of some compilers
  kTechnique,  // technique, technique10, technique11, fxgroup
  kCompile,    // compile, compile_fragment
  kCompileShader,
  kSamplerState,  // sampler_state, stateblock_state
  kAsm,
};

struct WordInfo {
  Word word = Word::kNone;
  // True for VertexShader, PixelShader and the like, whose initialiser is effects-framework text.
  bool is_shader_type = false;
  // The bits of a qualifier; 0 if clipc gives it no meaning.
  ast::Qualifiers qualifier = 0;
};

// Returns the grammar's view of a word, Word::kNone for an ordinary name. The words of the effects
// framework and the object types of Direct3D 9 match in any case, as in fxc.
WordInfo ClassifyWord(std::string_view text);

// A set of words.
class Words {
 public:
  template <std::same_as<Word>... Each>
  constexpr Words(Each... words) : bits_((0 | ... | (std::uint64_t{1} << int(words)))) {}
  constexpr bool Has(Word word) const { return (bits_ >> int(word) & 1) != 0; }
  friend constexpr Words operator|(Words a, Words b) {
    a.bits_ |= b.bits_;
    return a;
  }

 private:
  std::uint64_t bits_;
};

// Words that define a type, or name one that is defined elsewhere.
inline constexpr Words kTagWords(Word::kStruct, Word::kClass, Word::kInterface, Word::kEnum);
// Words that can only start a type.
inline constexpr Words kTypeWords =
    kTagWords | Words(Word::kQualifier, Word::kUnsigned, Word::kTypename);
// Words that are the name of a type, unless a declaration gives them another meaning.
inline constexpr Words kTypeNameWords(Word::kNumericType, Word::kObjectType, Word::kUnsigned);
inline constexpr Words kBufferWords(Word::kCbuffer, Word::kTbuffer);
// Words that start a declaration outside of functions only.
inline constexpr Words kOutsideWords = kBufferWords | Words(Word::kNamespace, Word::kTemplate);

inline constexpr Words kStatementWords(Word::kIf, Word::kElse, Word::kFor, Word::kWhile, Word::kDo,
                                       Word::kSwitch, Word::kCase, Word::kDefault, Word::kReturn,
                                       Word::kBreak, Word::kContinue, Word::kDiscard);
// Words that are names unless the context says otherwise, and ordinary names.
inline constexpr Words kNameWords(Word::kNone, Word::kContextualQualifier, Word::kObjectType,
                                  Word::kRegister, Word::kPackOffset, Word::kLayout,
                                  Word::kTechnique, Word::kCompile, Word::kCompileShader,
                                  Word::kSamplerState, Word::kAsm);

// Whether the word starts a statement or belongs to one.
constexpr bool IsStatementWord(Word word) { return kStatementWords.Has(word); }

// Whether the word can never be the name of anything.
constexpr bool IsReserved(Word word) { return !kNameWords.Has(word); }

}  // namespace clipc
