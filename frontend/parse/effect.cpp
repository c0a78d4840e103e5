// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <span>
#include <utility>

#include "base/spelling.h"
#include "frontend/parse/parser.h"

// The effects framework: techniques, passes, state blocks and annotations. They have no meaning for
// a shader, so they are skipped with their brackets matched, as fxc does under a shader profile.
// The names of shaders are kept, and what EffectParts asks for.
namespace clipc::ast {

Parser::Parser(Tokens&& tokens, Diagnostics& diagnostics, FunctionBodies bodies,
               const EffectParts& effect)
    : TreeBuilder(std::move(tokens), diagnostics), bodies_(bodies), effect_(effect) {
  if (effect_.keep) file_.effect.emplace();
}

// technique10 Name <annotation> {...}, fxgroup Name {...}
void Parser::ParseTechnique() {
  const std::size_t start = pos_;
  Next();
  Accept(kIdentifier);
  if (At(kLess)) SkipAnnotation();
  if (!At(kLeftBrace)) return Unexpected("`{`");
  SkipEffectBlock();
  if (file_.effect) file_.effect->techniques.push_back({start, pos_});
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

// `{}` or `{name = `, which is a state block after any variable and no list of values.
bool Parser::AtStates() const {
  return At(kLeftBrace) && (At(kRightBrace, 1) || (At(kIdentifier, 1) && At(kEqual, 2)));
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

// Keeps the name f if the text goes on with `compile vs_2_0 f` or `CompileShader(vs_4_0, f`; the
// call of the entry may be without such a word, as in OBS Studio's effects. Takes no token.
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
    if (!effect_.entry_call.empty() && At(kIdentifier) && At(kLeftParen, 1)) ParseEntryCall(0);
    return;
  }
  if (!effect_.entry_call.empty()) ParseEntryCall(function);
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

// Parses the arguments of the call whose function's name is at `function`, if it is the one that is
// asked for. Takes no token.
void Parser::ParseEntryCall(std::size_t function) {
  const std::size_t open = pos_ + LastOfQualifiedName(function) + 1;
  if (has_entry_call_ || open >= tokens_.size() || tokens_[open].kind != kLeftParen) return;
  const std::size_t most = std::min(tokens_.size(), open + kMaxCallTokens);
  std::size_t end = open;
  for (int depth = 0; end < most; ++end) {
    depth += BracketStep(tokens_[end].kind);
    if (depth == 0) break;
  }
  if (end == most) return;
  const std::size_t start = pos_ + function;
  if (TextOf(std::span(tokens_).subspan(start, end + 1 - start), names_) != effect_.entry_call)
    return;
  has_entry_call_ = true;
  const std::size_t before = std::exchange(pos_, open);
  file_.entry_arguments = ParseArguments();
  pos_ = before;
  EndPanic();
}

}  // namespace clipc::ast
