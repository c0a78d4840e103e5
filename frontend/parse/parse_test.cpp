// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/parse/parse.h"

#include <algorithm>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/overloaded.h"
#include "frontend/lex/source.h"
#include "frontend/parse/ast_print.h"

namespace clipc {
namespace {

using ::testing::HasSubstr;

Tokens LexText(const std::string& text) {
  FrontendContext context;
  SourceInput input;
  input.path = "test.hlsl";
  input.text = text;
  Source source(context, std::move(input));
  Diagnostics diagnostics;
  return Lex(source, diagnostics);
}

struct Parsed {
  ast::File file;
  Diagnostics diagnostics;
};
Parsed ParseText(const std::string& text) {
  Parsed parsed;
  parsed.file = Parse(LexText(text), parsed.diagnostics);
  return parsed;
}

std::string Repeat(const std::string& text, int count) {
  std::string repeated;
  for (int i = 0; i < count; ++i) repeated += text;
  return repeated;
}

// The number of nodes on the longest path of a tree, which kMaxDepth bounds.
class Depth {
 public:
  explicit Depth(const ast::File& file) : file_(file) {}
  int OfFile() {
    for (ast::DeclId id : file_.top_level) Visit(id, 1);
    return deepest_;
  }

 private:
  void Visit(ast::ExprId id, int depth) {
    if (!Enter(bool(id), depth)) return;
    std::visit(
        Overloaded{
            [&](const ast::NameExpr& e) { VisitAll(file_.expr_lists[e.arguments], depth); },
            [&](const ast::TypeExpr& e) { Visit(e.type, depth + 1); },
            [&](const ast::UnaryExpr& e) { Visit(e.operand, depth + 1); },
            [&](const ast::BinaryExpr& e) {
              Visit(e.left, depth + 1);
              Visit(e.right, depth + 1);
            },
            [&](const ast::CommaExpr& e) {
              Visit(e.left, depth + 1);
              Visit(e.right, depth + 1);
            },
            [&](const ast::AssignExpr& e) {
              Visit(e.left, depth + 1);
              Visit(e.right, depth + 1);
            },
            [&](const ast::ConditionalExpr& e) {
              Visit(e.condition, depth + 1);
              Visit(e.when_true, depth + 1);
              Visit(e.when_false, depth + 1);
            },
            [&](const ast::CallExpr& e) {
              Visit(e.callee, depth + 1);
              VisitAll(file_.expr_lists[e.arguments], depth);
            },
            [&](const ast::CastExpr& e) {
              Visit(e.type, depth + 1);
              VisitAll(file_.expr_lists[e.dimensions], depth);
              Visit(e.operand, depth + 1);
            },
            [&](const ast::IndexExpr& e) {
              Visit(e.base, depth + 1);
              Visit(e.index, depth + 1);
            },
            [&](const ast::MemberExpr& e) {
              Visit(e.base, depth + 1);
              VisitAll(file_.expr_lists[e.arguments], depth);
            },
            [&](const ast::InitListExpr& e) { VisitAll(file_.expr_lists[e.elements], depth); },
            [&](const ast::SizeofExpr& e) { Visit(e.operand, depth + 1); },
            [](const ast::Literal&) {},
            [](const ast::ErrorExpr&) {},
        },
        file_.exprs[id].node);
  }

  void Visit(ast::TypeId id, int depth) {
    if (!Enter(bool(id), depth)) return;
    const ast::Type& type = file_.types[id];
    VisitAll(file_.expr_lists[type.arguments], depth);
    Visit(type.outer, depth + 1);
    Visit(type.struct_definition, depth + 1);
  }

  void Visit(ast::DeclId id, int depth) {
    if (!Enter(bool(id), depth)) return;
    std::visit(
        Overloaded{
            [&](const ast::VarDecl& d) {
              Visit(d.type, depth + 1);
              VisitAll(file_.expr_lists[d.dimensions], depth);
              Visit(d.init, depth + 1);
            },
            [&](const ast::FunctionDecl& d) {
              Visit(d.return_type, depth + 1);
              VisitAll(file_.decl_lists[d.parameters], depth);
              Visit(d.body, depth + 1);
            },
            [&](const ast::StructDecl& d) { VisitAll(file_.decl_lists[d.members], depth); },
            [&](const ast::TypedefDecl& d) { Visit(d.type, depth + 1); },
            [&](const ast::BufferDecl& d) { VisitAll(file_.decl_lists[d.members], depth); },
            [&](const ast::NamespaceDecl& d) { VisitAll(file_.decl_lists[d.members], depth); },
            [](const ast::EnumDecl&) {},
            [](const ast::UsingDecl&) {},
        },
        file_.decls[id].node);
  }

  void Visit(ast::StmtId id, int depth) {
    if (!Enter(bool(id), depth)) return;
    std::visit(Overloaded{
                   [&](const ast::BlockStmt& s) { VisitAll(file_.stmt_lists[s.body], depth); },
                   [&](const ast::DeclStmt& s) { VisitAll(file_.decl_lists[s.decls], depth); },
                   [&](const ast::ExprStmt& s) { Visit(s.expr, depth + 1); },
                   [&](const ast::IfStmt& s) {
                     Visit(s.condition, depth + 1);
                     Visit(s.then, depth + 1);
                     Visit(s.otherwise, depth + 1);
                   },
                   [&](const ast::ForStmt& s) {
                     Visit(s.init, depth + 1);
                     Visit(s.condition, depth + 1);
                     Visit(s.step, depth + 1);
                     Visit(s.body, depth + 1);
                   },
                   [&](const ast::WhileStmt& s) {
                     Visit(s.condition, depth + 1);
                     Visit(s.body, depth + 1);
                   },
                   [&](const ast::DoStmt& s) {
                     Visit(s.body, depth + 1);
                     Visit(s.condition, depth + 1);
                   },
                   [&](const ast::SwitchStmt& s) {
                     Visit(s.value, depth + 1);
                     Visit(s.body, depth + 1);
                   },
                   [&](const ast::CaseStmt& s) { Visit(s.value, depth + 1); },
                   [&](const ast::ReturnStmt& s) { Visit(s.value, depth + 1); },
                   [](const auto&) {},
               },
               file_.stmts[id].node);
  }

  template <typename T>
  void VisitAll(std::span<const Id<T>> ids, int depth) {
    for (Id<T> id : ids) Visit(id, depth + 1);
  }
  bool Enter(bool exists, int depth) {
    if (exists) deepest_ = std::max(deepest_, depth);
    return exists && depth <= ast::kMaxDepth;
  }

  const ast::File& file_;
  int deepest_ = 0;
};

// One shader with a bit of everything.
constexpr const char* kEverything = R"(
namespace a { struct S { float4 p : POSITION; float f(float x) { return x; } }; }
template<typename T> T twice(T x) { return x + x; }
cbuffer C : register(b0) { float4x4 m; float4 planes[6] : packoffset(c4); }
Texture2D<float4> t[4] : register(t0, space1);
sampler s = sampler_state { Filter = LINEAR; };
float4 tint <string name = "x"; float low = 0;> = {1, 1, 1, 1};
typedef vector<float, 4> Four;
enum class E : uint { A, B = 2 };
[clipplanes(planes[0], planes[1])]
float4 main(in a::S input, uniform bool b = true, out float4 c : COLOR0) : SV_Position {
  [unroll(4)] for (int i = 0, j = 1; i < 4 && j; ++i) { c[i] += (float)i * m[i].x; }
  if (b) c = (Four)0; else if (!b) { c = b ? twice<float>(1) : -t[0].Load(0).xyzw; } else discard;
  switch (i) { case 1: case 2: break; default: while (b) do { continue; } while (i < 2); }
  struct { float q; } local = {1};
  return mul(input.p, m) + sizeof(float[2]) + vector<float, 4>(1, 2, 3, 4), 1;
}
technique T { pass P { VertexShader = compile vs_3_0 main(); } }
)";

TEST(Parse, EmptyTokensAreAnEmptyFile) {
  Diagnostics diagnostics;
  EXPECT_TRUE(Parse({}, diagnostics).top_level.empty());
  EXPECT_EQ(diagnostics.all().size(), 0u);
}

TEST(Parse, KeepsWhereThingsStand) {
  const Parsed parsed = ParseText("float a = (b + c) * d;");
  ASSERT_FALSE(parsed.diagnostics.has_errors());
  const auto& var = std::get<ast::VarDecl>(parsed.file.decls[parsed.file.top_level.at(0)].node);
  const auto& product = std::get<ast::BinaryExpr>(parsed.file.exprs[var.init].node);
  const std::uint32_t first = parsed.file.types[var.type].span.begin;
  EXPECT_EQ(var.name_span.begin - first, 6u);
  // The parentheses belong to the expression that they enclose.
  EXPECT_EQ(parsed.file.exprs[product.left].span.begin - first, 10u);
  EXPECT_EQ(parsed.file.exprs[product.left].span.end - first, 16u);
  EXPECT_EQ(product.op_span.begin - first, 18u);
  EXPECT_EQ(parsed.file.exprs[var.init].span.end - first, 20u);
}

TEST(Parse, AttributeSpansHaveTheirBrackets) {
  const Parsed parsed = ParseText("[clipplanes(a)] [[x::y]] float4 f();");
  const auto& function =
      std::get<ast::FunctionDecl>(parsed.file.decls[parsed.file.top_level.at(0)].node);
  const auto attributes = parsed.file.attrs[function.attributes];
  ASSERT_EQ(attributes.size(), 2u);
  EXPECT_EQ(attributes[0].span.end - attributes[0].span.begin, 14u);
  EXPECT_EQ(attributes[0].name_span.begin - attributes[0].span.begin, 1u);
  EXPECT_EQ(attributes[1].span.end - attributes[1].span.begin, 7u);
  EXPECT_EQ(parsed.file.names[attributes[1].name], "x::y");
}

TEST(Parse, NoTokenSequenceMakesTheTreeTooDeep) {
  const std::string statements = Repeat("if(a){", 100) + Repeat("if(a){}else ", 150);
  for (const std::string& text : {
           "void f(){" + statements + "x=" + Repeat("(", 100) + "1" + Repeat("+1", 400) + ";",
           "void f(){" + statements + "x=(struct{float q[1" + Repeat("+1", 400) + "];})1;",
           Repeat("namespace a{", 80) + Repeat("struct q{", 60) + "float x[1" + Repeat("+1", 470) +
               "];",
           Repeat("A<int>::", 20000) + "A<int> x;",
           "void f(){x=" + Repeat("(struct{int a;})", 400) + "1;}",
           "void f(){x=" + Repeat("(struct{int a[(struct{int a[", 400),
           "void f(){" + Repeat("if(a){}else ", 20000),
           Repeat("template<class T> ", 20000),
       }) {
    const Parsed parsed = ParseText(text);
    EXPECT_LE(Depth(parsed.file).OfFile(), ast::kMaxDepth) << text.substr(0, 60);
  }
}

TEST(Parse, LongChainsOfElseIfAreRead) {
  const Parsed parsed = ParseText("void f(){" + Repeat("if(a){}else ", 400) + "{}}");
  EXPECT_FALSE(parsed.diagnostics.has_errors());
  EXPECT_GT(Depth(parsed.file).OfFile(), 400);
}

TEST(Parse, AnyTokensAreAnswered) {
  const Tokens whole = LexText(kEverything);
  Diagnostics none;
  EXPECT_FALSE((Parse(Tokens(whole), none), none.has_errors()));
  std::mt19937 random(1);
  for (int round = 0; round < 3000; ++round) {
    Tokens tokens = whole;
    auto& list = tokens.list;
    for (unsigned change = 0; change <= random() % 4; ++change) {
      const auto a = static_cast<std::ptrdiff_t>(random() % (list.size() - 1));
      const auto b = static_cast<std::ptrdiff_t>(random() % (list.size() - 1));
      switch (random() % 4) {
        case 0: list.erase(list.begin() + a); break;
        case 1: list[a] = list[b]; break;
        case 2: std::swap(list[a], list[b]); break;
        default: list.insert(list.begin() + a, list[b]); break;
      }
    }
    Diagnostics diagnostics;
    const ast::File file = Parse(std::move(tokens), diagnostics);
    EXPECT_LE(Depth(file).OfFile(), ast::kMaxDepth);
    PrintAst(file);
  }
}

TEST(Parse, EveryPrefixIsAnswered) {
  const Tokens whole = LexText(kEverything);
  for (std::size_t size = 0; size < whole.list.size(); ++size) {
    Tokens tokens = whole;
    tokens.list.resize(size);
    tokens.list.push_back(whole.list.back());
    Diagnostics diagnostics;
    Parse(std::move(tokens), diagnostics);
    // Text that is cut off in the middle is one error.
    EXPECT_LE(diagnostics.error_count(), 1) << size;
  }
}

TEST(Parse, StopsAfterTooManyErrors) {
  const Parsed parsed = ParseText("void f() {" + Repeat("a = ;", 1000) + "}");
  EXPECT_EQ(parsed.diagnostics.error_count(), Diagnostics::kMaxErrors);
}

TEST(PrintAst, IsStable) {
  const std::string first = PrintAst(ParseText(kEverything).file);
  EXPECT_EQ(first, PrintAst(ParseText(kEverything).file));
  EXPECT_THAT(first, HasSubstr("technique compiles vs main"));
}

}  // namespace
}  // namespace clipc
