// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string_view>

#include "frontend/parse/ast.h"

// What HLSL's grammar knows about a word. Few words are reserved in real shaders: everything from
// kContextualQualifier on is a name wherever a name fits better, and only the parser knows where
// that is.
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
  kLayout,     // layout(...): Vulkan's, in the dialect of some compilers
  kTechnique,  // technique, technique10, technique11, fxgroup
  kCompile,    // compile, compile_fragment
  kCompileShader,
  kSamplerState,  // sampler_state, stateblock_state
  kAsm,
};

struct WordInfo {
  Word word = Word::kNone;
  bool is_shader_type = false;  // VertexShader and friends: initialised by effects-framework text
  ast::Qualifiers qualifier =
      0;  // of (contextual) qualifiers; 0 for those that mean nothing to a vertex shader
};

// Words of the effects framework and legacy object types match in any case, as fxc has it.
WordInfo ClassifyWord(std::string_view text);

// True for words that start a statement or belong to one.
constexpr bool IsStatementWord(Word word) { return word >= Word::kIf && word <= Word::kDiscard; }

// True for words that cannot be the name of anything.
constexpr bool IsReserved(Word word) {
  return word != Word::kNone && word < Word::kContextualQualifier;
}

}  // namespace clipc
