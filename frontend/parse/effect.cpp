// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "base/spelling.h"
#include "frontend/parse/parser.h"

// The effects framework: techniques, passes, state blocks and annotations. They have no meaning for
// a shader, so they are skipped with their brackets matched, as fxc does under a shader profile;
// only the names of shaders are kept.
namespace clipc::ast {

// technique10 Name <annotation> {...}, fxgroup Name {...}
void Parser::ParseTechnique() {
  Next();
  Accept(kIdentifier);
  if (At(kLess)) SkipAnnotation();
  if (!At(kLeftBrace)) return Unexpected("`{`");
  SkipEffectBlock();
}

// <string UIName = "x"; float UIMin = 0;>
void Parser::SkipAnnotation() {
  const std::size_t open = pos_;
  for (int angles = 0; !AtEnd() && !panic_;) {
    if (AcceptGreater()) {
      if (--angles == 0) return;
    } else if (BracketStep(Peek().kind) > 0) {
      SkipBalanced();
    } else if (At(kRightBrace)) {
      ExpectClose(kGreater, open);
    } else if (Next().kind == kLess) {
      ++angles;
    }
  }
  ExpectClose(kGreater, open);
}

// `{`, `= sampler_state {`, or `= {` before an assignment to a state.
bool Parser::AtStateBlock() const {
  if (At(kLeftBrace)) return true;
  if (!At(kEqual)) return false;
  if (WordAt(1) == Word::kSamplerState) return At(kLeftBrace, 2);
  std::size_t i = 1;
  while (At(kLeftBrace, i) && i < 3) ++i;
  if (i == 1 || !At(kIdentifier, i)) return false;
  if (At(kEqual, i + 1)) return true;
  return At(kLeftBracket, i + 1) && At(kIntLiteral, i + 2) && At(kRightBracket, i + 3) &&
         At(kEqual, i + 4);
}

// {...}
void Parser::SkipEffectBlock() {
  const std::size_t open = pos_;
  int braces = 0;
  while (!AtEnd()) {
    NoteCompile();
    const TokenKind kind = Next().kind;
    if (kind == kLeftBrace) ++braces;
    if (kind == kRightBrace && --braces == 0) return;
  }
  ExpectClose(kRightBrace, open);
}

// compile vs_2_0 f(), CompileShader(vs_4_0, f()), asm {...}: up to the `;` or `,` after it.
void Parser::SkipEffectValue() {
  for (int depth = 0; !AtEnd(); Next()) {
    NoteCompile();
    if (depth == 0 && (At(kSemicolon) || At(kComma))) return;
    depth += BracketStep(Peek().kind);
    if (depth < 0) return;
  }
}

// Keeps the name f if the text goes on with `compile vs_2_0 f` or `CompileShader(vs_4_0, f`. Takes
// no token.
void Parser::NoteCompile() {
  std::size_t profile = 0;  // positions from the current token
  std::size_t function = 0;
  if (AtWord(Word::kCompile)) {
    profile = 1;
    function = 2;
  } else if (AtWord(Word::kCompileShader) && At(kLeftParen, 1)) {
    profile = 2;
    function = 4;
  } else {
    return;
  }
  const std::string_view text = TextAt(profile);
  const std::optional<Stage> stage = StageOf(ToLower(text.substr(0, text.find('_'))));
  if (!stage || !At(kIdentifier, function)) return;
  const Name name = Peek(LastOfQualifiedName(function)).name();
  if (technique_stages_.size() <= name.index) technique_stages_.resize(names_.size());
  const auto bit = static_cast<std::uint8_t>(1 << static_cast<int>(*stage));
  if (technique_stages_[name.index] & bit) return;
  technique_stages_[name.index] |= bit;
  file_.technique_shaders.push_back({name, *stage});
}

}  // namespace clipc::ast
