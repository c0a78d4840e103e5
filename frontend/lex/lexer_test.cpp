// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
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

}  // namespace
}  // namespace clipc
