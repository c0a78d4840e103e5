// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/parse/parser.h"

// The effects framework: techniques, passes, state blocks and annotations. None of it means
// anything to a vertex shader, so it is skipped with its brackets matched, as fxc does under a
// shader profile; only the names of vertex shaders are remembered.
namespace clipc::ast {

// technique10 Name <annotation> {...}, fxgroup Name {...}
void Parser::ParseTechnique() {
  Next();
  if (At(TokenKind::kIdentifier)) Next();
  if (At(TokenKind::kLess)) SkipAnnotation();
  if (!At(TokenKind::kLeftBrace)) {
    Unexpected("`{`");
    return;
  }
  SkipEffectBlock();
}

// <string UIName = "x"; float UIMin = 0;>, at its `<`.
void Parser::SkipAnnotation() {
  const std::size_t open = pos_;
  int angles = 0;
  while (!AtEnd() && !panic_) {
    switch (Peek().kind) {
      case TokenKind::kLess:
        ++angles;
        Next();
        break;
      case TokenKind::kGreater:
      case TokenKind::kGreaterGreater:
      case TokenKind::kGreaterEqual:
      case TokenKind::kGreaterGreaterEqual:
        SplitGreater();
        if (--angles == 0) return;
        break;
      case TokenKind::kLeftBrace:
      case TokenKind::kLeftParen:
      case TokenKind::kLeftBracket: SkipBalanced(); break;
      case TokenKind::kRightBrace: ExpectClose(TokenKind::kGreater, open); break;
      default: Next(); break;
    }
  }
  ExpectClose(TokenKind::kGreater, open);
}

// `{`, `= sampler_state {`, or `= {` before an assignment to a state.
bool Parser::AtStateBlock() const {
  if (At(TokenKind::kLeftBrace)) return true;
  if (!At(TokenKind::kEqual)) return false;
  if (WordAt(1) == Word::kSamplerState) return Peek(2).kind == TokenKind::kLeftBrace;
  std::size_t i = 1;
  while (Peek(i).kind == TokenKind::kLeftBrace && i < 3) ++i;
  if (i == 1 || Peek(i).kind != TokenKind::kIdentifier) return false;
  if (Peek(i + 1).kind == TokenKind::kEqual) return true;
  return Peek(i + 1).kind == TokenKind::kLeftBracket &&
         Peek(i + 2).kind == TokenKind::kIntLiteral &&
         Peek(i + 3).kind == TokenKind::kRightBracket && Peek(i + 4).kind == TokenKind::kEqual;
}

// {...}, at its `{`.
void Parser::SkipEffectBlock() {
  const std::size_t open = pos_;
  int braces = 0;
  while (!AtEnd()) {
    NoteCompile();
    const TokenKind kind = Next().kind;
    if (kind == TokenKind::kLeftBrace) ++braces;
    if (kind == TokenKind::kRightBrace && --braces == 0) return;
  }
  ExpectClose(TokenKind::kRightBrace, open);
}

// compile vs_2_0 f(), CompileShader(vs_4_0, f()), asm {...}: up to the `;` or `,` behind it.
void Parser::SkipEffectValue() {
  int depth = 0;
  while (!AtEnd()) {
    NoteCompile();
    switch (Peek().kind) {
      case TokenKind::kSemicolon:
      case TokenKind::kComma:
        if (depth == 0) return;
        break;
      case TokenKind::kLeftParen:
      case TokenKind::kLeftBrace:
      case TokenKind::kLeftBracket: ++depth; break;
      case TokenKind::kRightParen:
      case TokenKind::kRightBrace:
      case TokenKind::kRightBracket:
        if (--depth < 0) return;
        break;
      default: break;
    }
    Next();
  }
}

// At `compile vs_2_0 f` or `CompileShader(vs_4_0, f`: remembers f. Consumes nothing.
void Parser::NoteCompile() {
  std::size_t profile = 0;
  std::size_t function = 0;
  if (AtWord(Word::kCompile)) {
    profile = 1;
    function = 2;
  } else if (AtWord(Word::kCompileShader) && Peek(1).kind == TokenKind::kLeftParen) {
    profile = 2;
    function = 4;
  } else {
    return;
  }
  if (Peek(profile).kind != TokenKind::kIdentifier || Peek(function).kind != TokenKind::kIdentifier)
    return;
  const std::string_view text = Text(Peek(profile).name());
  if (!text.starts_with("vs_") && !text.starts_with("VS_")) return;
  while (Peek(function + 1).kind == TokenKind::kColonColon && AtName(function + 2)) function += 2;
  const Name name = Peek(function).name();
  if (technique_names_.size() <= name.index) technique_names_.resize(file_.names.size());
  if (technique_names_[name.index]) return;
  technique_names_[name.index] = true;
  file_.technique_vertex_shaders.push_back(name);
}

}  // namespace clipc::ast
