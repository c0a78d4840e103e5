// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/span.h"
#include "frontend/parse/ast.h"
#include "frontend/parse/effect_value.h"

// An effect as data: techniques with their passes, and the variables with what only effects have.
// Texts are those of the effect, after preprocessing.
namespace clipc::ast {

struct NamedText {
  std::string name, value;
};
// A state of a pass or of a block of states: ZEnable and "true", BlendEnable[0] and "TRUE". A call
// such as SetBlendState has the text "(Blend, ...)", and its arguments as the value.
struct EffectState {
  std::string name, text;
  std::string word;         // the name without its index
  bool has_index = false;   // it has one in brackets, perhaps not a number
  std::uint32_t index = 0;  // of a name with a number in brackets
  EffectValue value;
  Span span;
  bool is_wrong = false;  // it says what Direct3D does not know, and that has been reported
};
struct Annotation {
  std::string type, name, value;
};

// A shader, as a pass or a shader variable has it.
struct EffectShader {
  enum class Kind : std::uint8_t {
    kNone,      // NULL
    kCompiled,  // compile vs_3_0 Main(true, 4), CompileShader(vs_4_0, Main())
    kVariable,  // a shader variable, vs or A[i]
    kOther      // asm {...} and what is not understood
  };
  Kind kind = Kind::kNone;
  std::string text;               // all of it
  std::string profile, function;  // of kCompiled
  std::string call;               // of kCompiled, with arguments: EffectParts::entry_call
  // Of kCompiled in ConstructGSWithSO(shader, "0:POSITION.xyz"): what is captured of each stream,
  // as it is written; empty: nothing.
  std::vector<std::string> captures;
  std::string variable;  // of kVariable
  // Of kVariable, A[T[i]]: the index without blanks, `i`, or the number that it is; and the arrays
  // that it is looked up in, `T`, the outermost first.
  std::string index;
  std::vector<std::string> tables;
  Span span;
};

struct EffectPass {
  std::string name;
  Span span;
  std::vector<Annotation> annotations;
  EffectShader vertex, hull, domain, geometry, pixel, compute;
  std::vector<EffectState> states;
  std::vector<std::string> not_read;  // statements of no known form
  std::vector<Span> unended;          // the last tokens of statements without a `;` before the next
};

struct EffectTechnique {
  std::string kind;  // "technique", "technique10", "technique11"
  std::string group, name;
  std::vector<Annotation> annotations;
  std::vector<EffectPass> passes;
  std::vector<std::string> not_read;
};

struct EffectParameter {
  std::string name, type, semantic;
  std::vector<Annotation> annotations;
  std::string value;                               // the default value; empty without one
  bool is_block = false;                           // it is a block of states, perhaps an empty one
  std::vector<EffectState> states;                 // of a block of states
  std::vector<std::vector<EffectState>> elements;  // of an array of such blocks
  std::vector<Span> unended;                       // as EffectPass::unended, of these blocks
  std::vector<EffectShader> shaders;  // of a shader variable: one, or the elements of an array
};

// A variable whose value is a list of integers: int T[2] = {0, 1};
struct EffectTable {
  std::string name;
  std::vector<std::int64_t> values;
};

// A variable that has one value always: static const int K = 2;
struct EffectConstant {
  std::string name;
  std::int64_t value = 0;
};

struct Effect {
  std::vector<EffectTechnique> techniques;
  std::vector<EffectParameter> parameters;
  std::vector<EffectTable> tables;
  std::vector<EffectConstant> constants;
};

// Reads the effect in a file that was parsed with EffectParts::keep. It is linear in the number of
// tokens, and every text has a result.
Effect ReadEffect(const File& file);

}  // namespace clipc::ast
