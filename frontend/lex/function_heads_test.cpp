// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/lex/function_heads.h"

#include <string>

#include <gtest/gtest.h>

#include "frontend/lex/source.h"

namespace clipc {
namespace {

TEST(EndOfBody, FindsTheMatchingBrace) {
  const auto end = [](std::string_view text) { return EndOfBody(text, 1); };
  EXPECT_EQ(end("{}"), 1u);
  EXPECT_EQ(end("{ a = (b[1]) / c; { } }"), 22u);
  EXPECT_EQ(end("{ /* } */ // }\n }"), 16u);
  EXPECT_EQ(end("{ a % b; }"), 9u);
}

TEST(EndOfBody, LeavesToThePreprocessorWhatItAloneCanRead) {
  for (const char* text : {"{", "{ {", "{\n#if 1\n}", "{ \"}\" }", "{ '}' }", "{ // \\\n } \n }",
                           "{ f( }", "{ a[0; }", "{ <% }", "{ a %> b }", "{ /* }", "{ a \\\n }"})
    EXPECT_FALSE(EndOfBody(text, 1)) << text;
}

// The words and punctuators that are left of a text from which `entry` is reached.
std::string Left(std::string text, std::string_view entry) {
  FrontendContext context;
  SourceInput input;
  input.path = "test.hlsl";
  input.text = std::move(text);
  Source source(context, std::move(input));
  Diagnostics diagnostics;
  const Tokens tokens = Lex(source, diagnostics, entry);
  std::string left;
  for (const Token& token : tokens.list) {
    if (token.kind == TokenKind::kIdentifier) {
      left += std::string(tokens.names[token.name()]) + " ";
    } else {
      left += SpellingOf(token.kind);
    }
  }
  return left;
}

TEST(LazyBodies, AreReadWhereTheirFunctionIsReached) {
  EXPECT_EQ(Left("void a() { b; } void c() { d; } void e() { c(); }", "e"),
            Left("void a() { } void c() { d; } void e() { c(); }", ""));
  EXPECT_EQ(Left("void a() { b(); } void b() { c; } void c() { d; }", "a"),
            Left("void a() { b(); } void b() { c; } void c() { d; }", ""));
}

TEST(LazyBodies, DeclarationsAreNoUses) {
  EXPECT_EQ(Left("void a(); void a() { b; } void e() { }", "e"),
            Left("void a(); void a() { } void e() { }", ""));
  EXPECT_EQ(
      Left("technique T { pass P { VertexShader = compile vs_3_0 a(); } } void a() { b; }", "e"),
      Left("technique T { pass P { VertexShader = compile vs_3_0 a(); } } void a() { }", ""));
}

TEST(LazyBodies, UsesOutsideOfBodiesReach) {
  for (const char* text :
       {"void a() { b; } static int i = a();", "void a() { b; } struct S { void m() { a(); } };",
        "void a() { b; } void e(int i = a()) { }", "[f(\"a\")] void e() { } void a() { b; }",
        "void a() { b; } cbuffer C : register(b0) { int a; }"})
    EXPECT_EQ(Left(text, "e"), Left(text, "")) << text;
}

TEST(LazyBodies, MacrosAreThoseOfThePlace) {
  for (const char* text :
       {"#define A b\nvoid a() { A; }\n#undef A\n#define A c\nvoid e() { a(); A; }",
        "void a() { A; }\n#define A c\nvoid e() { a(); A; }",
        "#define BEGIN {\nvoid a() { BEGIN } }\nvoid c() { d; } void e() { a(); c(); }"})
    EXPECT_EQ(Left(text, "e"), Left(text, "")) << text;
}

}  // namespace
}  // namespace clipc
