// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "frontend/lex/source.h"

namespace clipc {
namespace {

struct Lexed {
  explicit Lexed(std::string text, FrontendContext& context)
      : source(context, Input(std::move(text))) {
    tokens = Lex(source, diagnostics);
  }
  static SourceInput Input(std::string text) {
    SourceInput input;
    input.path = "test.hlsl";
    input.text = std::move(text);
    return input;
  }
  Place PlaceOf(std::size_t token) const { return source.Resolve(tokens.list[token].span()); }

  Source source;
  Diagnostics diagnostics;
  Tokens tokens;
};

TEST(Lex, EndsInOneEnd) {
  FrontendContext context;
  for (const char* text : {"", "a", "a\n", "#if 0\n", "\"open", "/* open", "#define"}) {
    const Lexed lexed(text, context);
    ASSERT_FALSE(lexed.tokens.list.empty());
    EXPECT_EQ(lexed.tokens.list.back().kind, TokenKind::kEnd) << text;
  }
}

TEST(Lex, EqualNamesAreOneName) {
  FrontendContext context;
  const Lexed lexed("a b a /**/ b", context);
  const auto& list = lexed.tokens.list;
  ASSERT_EQ(list.size(), 5u);
  EXPECT_EQ(list[0].name(), list[2].name());
  EXPECT_EQ(list[1].name(), list[3].name());
  EXPECT_NE(list[0].name(), list[1].name());
  EXPECT_EQ(lexed.tokens.names[list[1].name()], "b");
}

TEST(Lex, ContextServesManySources) {
  FrontendContext context;
  for (int i = 0; i < 3; ++i) {
    const Lexed lexed("#define A " + std::to_string(i) + "\nA\n", context);
    EXPECT_EQ(lexed.tokens.list[0].value, static_cast<std::uint64_t>(i));
    EXPECT_TRUE(lexed.diagnostics.all().empty());
    EXPECT_TRUE(lexed.source.Dependencies().empty());
  }
}

TEST(Lex, PlacesOfMacrosAreWhereTheUserWroteThem) {
  FrontendContext context;
  const Lexed lexed("#define TWICE(x) x + x\n  TWICE(abc);\n", context);
  const Place first = lexed.PlaceOf(0);
  EXPECT_EQ(first.file, "test.hlsl");
  EXPECT_EQ(first.line, 2u);
  EXPECT_EQ(first.column, 9u);
  EXPECT_EQ(first.end_column, 12u);
  const Place plus = lexed.PlaceOf(1);  // of the macro's own text: its use
  EXPECT_EQ(plus.line, 2u);
  EXPECT_EQ(plus.column, 3u);
}

TEST(Lex, SpansOfSeveralTokens) {
  FrontendContext context;
  const Lexed lexed("abc +\n  de;", context);
  const auto& list = lexed.tokens.list;
  const Place place = lexed.source.Resolve(Cover(list[0].span(), list[2].span()));
  EXPECT_EQ(place.line, 1u);
  EXPECT_EQ(place.column, 1u);
  EXPECT_EQ(place.end_line, 2u);
  EXPECT_EQ(place.end_column, 5u);
  EXPECT_TRUE(lexed.source.Resolve({}).file.empty());
}

TEST(RenderText, UnderlinesTheSpan) {
  FrontendContext context;
  Lexed lexed("float4 plane_value;\n", context);
  lexed.diagnostics.Report(lexed.tokens.list[1].span(), diag::ErrorDirective, "bad plane")
      .Note({}, diag::PlainNote, "nowhere in particular")
      .Fix(lexed.tokens.list[0].span(), "float3");
  EXPECT_EQ(lexed.source.RenderText(lexed.diagnostics, false),
            "test.hlsl:1:8: error: bad plane [error-directive]\n"
            "    1 | float4 plane_value;\n"
            "      | ~~~~~~ ^~~~~~~~~~~\n"
            "      | float3\n"
            "clipc: note: nowhere in particular\n");
  EXPECT_NE(lexed.source.RenderText(lexed.diagnostics, true).find("\x1b["), std::string::npos);
}

// What Lex makes of a text, for comparison, without the end.
std::string Describe(const std::string& text, FrontendContext& context) {
  const Lexed lexed(text, context);
  std::string all;
  for (std::size_t i = 0; i + 1 < lexed.tokens.list.size(); ++i) {
    const Token& token = lexed.tokens.list[i];
    const bool is_name =
        token.kind == TokenKind::kIdentifier || token.kind == TokenKind::kStringLiteral;
    const Place place = lexed.PlaceOf(i);
    all += fmt::format("{} {} {} {}:{} {}\n", static_cast<int>(token.kind),
                       static_cast<int>(token.literal), token.after_space, place.line, place.column,
                       is_name ? lexed.tokens.names[token.name()] : std::to_string(token.value));
  }
  for (const Diagnostic& diagnostic : lexed.diagnostics.all())
    all += fmt::format("{} {}\n", diagnostic.span.begin, diagnostic.message);
  return all;
}

// Clang reads a text of a few bytes, which lies wholly before the end of the file; with white space
// after it, most of it is read as plain text.
TEST(Lex, PlainTextIsReadAsClangReadsIt) {
  FrontendContext context;
  const std::string space(100, ' ');
  const auto expect_same = [&](const std::string& text) {
    ASSERT_LE(text.size(), 32u) << text;
    EXPECT_EQ(Describe(text, context), Describe(text + space, context)) << text;
  };
  const std::string_view letters = "aLu_0.1eEpx+-*/%=<>!&|^~?:;,()[]{}#\\\"' \t\n\r\f$@`\x80";
  for (const char a : letters) {
    for (const char b : letters) {
      for (const char c : std::string_view("a0=/<>:.\\\n#\""))
        expect_same(std::string("a ") + a + b + c + " a");
    }
  }
  for (const char* text : {"1e+2 1E-2f .5 5. 0x1e+2 0x1p+2",
                           "1.xxx 1.0.xxx 1.5.r 1..x 1X.x",
                           "1.#INF -1.#IND 1.#QNAN",
                           "a// b\\\nc\nd",
                           "a// b\\ \nc\nd",
                           "a// b\rc\nd",
                           "a// b\r\nc",
                           "a/* b */c/**/d/*/ */e",
                           "a/* /* */b",
                           "a/* *\\\n/b",
                           "a /*\n*/ #define b c\nb",
                           "/**/ #define b c\nb b",
                           "a//\nb",
                           "a %: b <: c :> <% %> %:%: ...",
                           "a->b a::b a<<=b a>>=b a<=>b",
                           "a---b a+++b a&&&b a|||b",
                           "#define m 1\nm n m",
                           "#define m\nm n m",
                           "#define m(x) x\nm m(2) m",
                           "m\n#define m 1\nm m",
                           "#define m 1\n#undef m\nm",
                           "__LINE__ a __LINE__",
                           "__COUNTER__ a __COUNTER__",
                           "u8\"a\" L'a'",
                           "abcdefgh abcdefg abcdefghi"})
    expect_same(text);
}

// Words are told apart by their first sixteen letters, their length and the rest.
TEST(Lex, LongWordsAreTheirOwn) {
  FrontendContext context;
  std::string text, word = "abcdefghijklmnop";
  for (const char* end : {"", "q", "r", "qr", "qs", "q", "", "qs"}) text += word + end + " ";
  const Lexed lexed(text + std::string(100, ' '), context);
  std::string names;
  for (const Token& token : lexed.tokens.list) {
    if (token.kind == TokenKind::kIdentifier)
      names += std::string(lexed.tokens.names[token.name()]) + " ";
  }
  EXPECT_EQ(names, text);
}

}  // namespace
}  // namespace clipc
