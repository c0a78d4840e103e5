// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/block_layout.h"

#include <cstdint>
#include <map>
#include <random>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "backend-glsl/test_glsl.h"
#include "legalize/test_shader.h"

namespace clipc::glsl {
namespace {

using ir::Scalar;
using ir::TypeId;
using legalize::TestShader;

class BlockLayoutTest : public testing::Test {
 protected:
  TypeId F(int n) { return shader_.Vector(Scalar::kFloat, n); }
  TypeId M(int rows, int columns, Scalar kind = Scalar::kFloat) {
    return shader_.program.types.Matrix(kind, rows, columns);
  }
  TypeId A(TypeId element, std::uint32_t count) {
    return shader_.program.types.Array(element, count);
  }
  TypeId S(const std::vector<TestShader::NewMember>& fields) {
    ir::Struct structure;
    structure.name = "S";
    for (const auto& field : fields) {
      ir::Field added;
      added.name = field.name;
      added.type = field.type;
      added.row_major = field.row_major;
      structure.fields.push_back(added);
    }
    return shader_.program.types.Of(shader_.program.types.AddStruct(structure));
  }
  BlockLayout Layout(const std::vector<TestShader::NewMember>& members,
                     std::string_view target = "glsl450",
                     ir::CbufferKind kind = ir::CbufferKind::kCbuffer,
                     std::string_view unread = "") {
    const auto id = shader_.AddCbuffer("Buffer", members, kind);
    std::vector<bool> is_read(shader_.program.vars.size(), true);
    for (const ir::CbufferMember& member : shader_.program.cbuffers[id].members) {
      const std::string& name = shader_.program.vars[member.var].name;
      if (unread.find(name) != unread.npos) is_read[member.var.index] = false;
    }
    return LayOutBlock(shader_.program, shader_.program.cbuffers[id], *Target::Parse(target),
                       BlockStyle::kPlain, is_read);
  }
  // What the block declares, "a b.words c.rows2", where the members whose names are letters of
  // `unread` are not read.
  std::string Parts(const std::vector<TestShader::NewMember>& members, std::string_view unread = "",
                    std::string_view target = "glsl450") {
    const BlockLayout layout = Layout(members, target, ir::CbufferKind::kCbuffer, unread);
    if (layout.form != BlockForm::kStd140)
      return layout.form == BlockForm::kRows ? "rows" : "uniforms";
    std::string text;
    for (const BlockMember& member : layout.members) {
      if (!text.empty()) text += " ";
      text += shader_.program.vars[member.var].name;
      if (member.form == PartForm::kWords) text += ".words";
      if (member.form == PartForm::kRows) text += ".rows" + std::to_string(member.rows);
    }
    return text;
  }
  // Whether std140 can place every member.
  bool Fits(const std::vector<TestShader::NewMember>& members) {
    return Layout(members).by_hand.empty();
  }

  TestShader shader_;
};

TEST_F(BlockLayoutTest, Std140WhereItIsTheSame) {
  EXPECT_TRUE(Fits({{"a", F(4)}, {"b", F(4)}}));
  EXPECT_TRUE(Fits({{"a", F(3)}, {"b", F(1)}}));
  EXPECT_TRUE(Fits({{"a", F(2)}, {"b", F(2)}}));
  EXPECT_TRUE(Fits({{"a", M(4, 4)}, {"b", F(1)}}));
  EXPECT_TRUE(Fits({{"a", A(F(4), 3)}, {"b", F(3)}}));
  EXPECT_FALSE(
      Fits({{"a", shader_.Vector(Scalar::kBool, 1)}, {"b", shader_.Vector(Scalar::kUint, 3)}}))
      << "uint3 b lies at 4";
  EXPECT_TRUE(Fits({{"a", F(3)}, {"b", shader_.Vector(Scalar::kBool, 1)}}));
}

TEST_F(BlockLayoutTest, NotWhereStd140WouldMoveAMember) {
  EXPECT_FALSE(Fits({{"a", F(1)}, {"b", F(3)}}));
  EXPECT_FALSE(Fits({{"a", F(1)}, {"b", F(2)}}));
  EXPECT_FALSE(Fits({{"a", A(F(1), 2)}, {"b", F(1)}})) << "a scalar in an array's last row";
  EXPECT_FALSE(Fits({{"a", M(3, 3)}, {"b", F(1)}})) << "a scalar in a matrix's last row";
  EXPECT_TRUE(Fits({{"a", M(4, 3)}, {"b", F(1)}})) << "three whole rows";
  EXPECT_FALSE(Fits({{"a", M(4, 3), true}, {"b", F(1)}}));
  EXPECT_FALSE(Fits({{"s", S({{"x", F(1)}})}, {"b", F(1)}})) << "a scalar in a struct's last row";
  EXPECT_TRUE(Fits({{"s", S({{"x", F(1)}})}, {"b", F(4)}}));
  EXPECT_FALSE(Fits({{"s", S({{"x", F(1)}, {"y", F(3)}})}})) << "inside a struct";
  EXPECT_TRUE(Fits({{"s", A(S({{"x", F(3)}, {"y", F(1)}}), 2)}}));
}

TEST_F(BlockLayoutTest, MatricesOfOneRowOrColumn) {
  EXPECT_TRUE(Fits({{"a", M(1, 4), true}, {"b", F(4)}})) << "one register";
  EXPECT_FALSE(Fits({{"a", M(1, 4)}, {"b", F(4)}})) << "four registers of one component";
  EXPECT_TRUE(Fits({{"a", M(4, 1)}, {"b", F(4)}}));
  EXPECT_FALSE(Fits({{"a", M(4, 1), true}, {"b", F(4)}}));
  EXPECT_TRUE(Fits({{"a", M(1, 1)}, {"b", F(1)}}));
}

TEST_F(BlockLayoutTest, MatricesOfIntegers) {
  EXPECT_TRUE(Fits({{"a", M(4, 4, Scalar::kInt), true}})) << "an array of rows";
  EXPECT_FALSE(Fits({{"a", M(4, 4, Scalar::kInt)}}));
  EXPECT_TRUE(Fits({{"a", M(2, 3, Scalar::kBool), true}}));
}

TEST_F(BlockLayoutTest, MatrixLayoutIsTheBlocksWhenAllAgree) {
  EXPECT_EQ(Layout({{"a", M(4, 4)}, {"b", M(3, 4)}, {"c", F(4)}}).matrices,
            ir::MatrixLayout::kRowMajor);
  EXPECT_EQ(Layout({{"a", M(4, 4), true}}).matrices, ir::MatrixLayout::kColumnMajor);
  const BlockLayout mixed = Layout({{"a", M(4, 4), true}, {"b", M(4, 4)}});
  EXPECT_EQ(mixed.form, BlockForm::kStd140);
  EXPECT_EQ(mixed.matrices, ir::MatrixLayout::kNone);
  EXPECT_EQ(mixed.members[0].matrices, ir::MatrixLayout::kColumnMajor);
  EXPECT_EQ(mixed.members[1].matrices, ir::MatrixLayout::kRowMajor);
  EXPECT_FALSE(Fits({{"s", S({{"a", M(4, 4), true}, {"b", M(4, 4)}})}}))
      << "a struct cannot mix them";
}

TEST_F(BlockLayoutTest, GapsAreOffsetsOrPadding) {
  const std::vector<TestShader::NewMember> members = {{"b", F(1), false, 72},
                                                      {"a", F(4), false, 16}};
  const BlockLayout offsets = Layout(members, "glsl440");
  EXPECT_EQ(offsets.form, BlockForm::kStd140);
  EXPECT_EQ(offsets.members[0].offset, 16u) << "in order of offset";
  EXPECT_TRUE(offsets.members[0].explicit_offset);
  EXPECT_TRUE(offsets.members[1].explicit_offset);
  const BlockLayout padded = Layout(members, "glsl430");
  EXPECT_EQ(padded.form, BlockForm::kStd140);
  EXPECT_EQ(padded.members[0].padding, 16u);
  EXPECT_EQ(padded.members[1].padding, 40u);
  EXPECT_FALSE(Fits({{"a", F(4), false, 4}})) << "a vec4 cannot start there";
}

TEST_F(BlockLayoutTest, WhatIsReadByHand) {
  EXPECT_EQ(Parts({{"a", F(1)}, {"b", F(3)}, {"c", F(4)}}), "a b.words c");
  EXPECT_EQ(Parts({{"a", F(1)}, {"b", F(3)}, {"c", F(4)}}, "b"), "a c") << "b is not read";
  EXPECT_EQ(Parts({{"a", F(1)}, {"b", F(3)}, {"c", F(4)}}, "a"), "a b.words c") << "a fits";
  EXPECT_EQ(Parts({{"a", A(F(1), 3)}, {"b", F(1)}, {"c", F(4)}}), "a.rows3 c");
  EXPECT_EQ(Parts({{"a", A(F(1), 3)}, {"b", F(1)}, {"c", F(4)}}, "b"), "a c");
  EXPECT_EQ(Parts({{"a", A(F(1), 3)}, {"b", F(1)}, {"c", F(4)}}, "a"), "b c")
      << "what is read has the room";
  EXPECT_EQ(Parts({{"a", A(F(1), 3)}, {"b", F(1)}, {"c", F(4)}}, "ab"), "a c");
  EXPECT_EQ(Parts({{"a", M(3, 3)}, {"b", F(1)}, {"c", M(3, 3)}, {"d", F(1)}}), "a.rows3 c.rows3");
  EXPECT_EQ(Parts({{"a", M(1, 4)}, {"b", F(1)}}, "a"), "b");
  EXPECT_EQ(Parts({{"a", F(4)}, {"b", M(1, 4)}, {"c", F(1)}}), "a b.rows4");
  EXPECT_EQ(Parts({{"a", shader_.Vector(Scalar::kDouble, 1), false, 4}, {"b", F(4)}}), "a.rows1 b");
  EXPECT_EQ(Parts({{"a", F(4), false, 0}, {"b", F(1), false, 12}, {"c", F(4), false, 16}}),
            "a.rows1 c")
      << "members that share bytes";
}

TEST_F(BlockLayoutTest, LargeBlocksEndWithWhatIsRead) {
  const std::vector<TestShader::NewMember> large = {
      {"a", F(4)}, {"b", A(F(4), 1000)}, {"c", A(F(4), 23)}, {"d", F(4)}};
  EXPECT_EQ(Parts(large), "a b c d");
  EXPECT_EQ(Parts(large, "d"), "a b c") << "16 KB";
  EXPECT_EQ(Parts(large, "bcd"), "a");
  EXPECT_EQ(Parts(large, "bc"), "a b c d") << "more than 16 KB anyhow";
  EXPECT_EQ(Parts({{"a", F(4)}, {"b", A(F(4), 1000)}}, "b"), "a b")
      << "a small block is the same in every stage";
}

TEST_F(BlockLayoutTest, OldTargetsHaveUniformVariables) {
  EXPECT_EQ(Parts({{"a", F(1)}, {"b", F(3)}}, "", "glsl120"), "uniforms");
  EXPECT_EQ(Parts({{"a", F(1)}}, "", "glsl130"), "uniforms");
  EXPECT_EQ(Parts({{"a", F(1)}}, "", "essl300"), "a");
  const ir::TypeId uint3 = shader_.Vector(Scalar::kUint, 3);
  EXPECT_EQ(Parts({{"a", F(1)}, {"b", uint3}}, "", "glsl140"), "a b.words");
  EXPECT_EQ(Parts({{"a", A(F(1), 2)}, {"b", uint3}}, "", "glsl140"), "uniforms")
      << "no uintBitsToFloat to read rows with";
  EXPECT_EQ(Parts({{"a", A(F(1), 2)}, {"b", uint3}}, "", "glsl150"), "a.rows2");
}

TEST_F(BlockLayoutTest, ConstantBuffersAreBlocksWithAName) {
  const TypeId t = S({{"plane", F(4)}, {"m", M(4, 4)}});
  const BlockLayout layout = Layout({{"cb", t}}, "glsl450", ir::CbufferKind::kConstantBuffer);
  EXPECT_TRUE(layout.fields_as_members);
  ASSERT_EQ(layout.members.size(), 2u);
  EXPECT_EQ(layout.members[1].offset, 16u);
  EXPECT_FALSE(Layout({{"cb", t}}, "glsl140", ir::CbufferKind::kConstantBuffer).fields_as_members);
}

// ---- members' offsets in the written block, by glslang's own reflection, against those of HLSL

struct Leaf {
  std::string path;  // "Buffer7.s.m"
  std::uint32_t offset;
};

class RandomCbuffers {
 public:
  explicit RandomCbuffers(unsigned seed) : random_(seed) {}

  TypeId Type(TestShader& shader, int depth) {
    ir::TypeTable& types = shader.program.types;
    static constexpr Scalar kKinds[] = {Scalar::kFloat, Scalar::kFloat, Scalar::kFloat,
                                        Scalar::kInt,   Scalar::kUint,  Scalar::kBool,
                                        Scalar::kDouble};
    const Scalar kind = kKinds[Below(std::size(kKinds))];
    switch (Below(depth > 0 ? 10 : 7)) {
      case 0:
      case 1:
      case 2:
      case 3: return shader.Vector(kind, 1 + Below(4));
      case 4:
      case 5:
        return types.Matrix(kind == Scalar::kDouble ? kind : Scalar::kFloat, 1 + Below(4),
                            1 + Below(4));
      case 6: return types.Matrix(kind, 2 + Below(3), 2 + Below(3));
      case 7: return types.Array(Type(shader, depth - 1), 1 + static_cast<std::uint32_t>(Below(3)));
      default: {
        ir::Struct structure;
        structure.name = "S" + std::to_string(types.structs().size());
        const bool row_major = Below(2) == 0;
        for (int i = 0, count = 1 + Below(3); i < count; ++i) {
          ir::Field field;
          field.name = std::string(1, static_cast<char>('p' + i));
          field.type = Type(shader, depth - 1);
          field.row_major = Below(4) == 0 ? !row_major : row_major;
          structure.fields.push_back(field);
        }
        return types.Of(types.AddStruct(structure));
      }
    }
  }
  int Below(std::size_t end) { return static_cast<int>(random_() % end); }

 private:
  std::mt19937 random_;
};

// Uses each leaf under `expr` and notes its offset in HLSL, of an array that of element 0 only.
void UseLeaves(TestShader& shader, ir::ExprId expr, bool row_major, const std::string& path,
               std::uint32_t offset, std::vector<Leaf>& leaves) {
  ir::Builder b = shader.Make();
  const ir::Type type = shader.program.types[b.TypeOf(expr)];
  if (type.kind == ir::TypeKind::kArray) {
    for (std::uint32_t i = 0; i < type.count; ++i) {
      const ir::ExprId base = i == 0 ? expr : ir::Clone(shader.program, expr);
      std::vector<Leaf> ignored;
      const std::uint32_t at =
          offset + i * ir::ArrayStride(shader.program.types, b.TypeOf(expr), row_major);
      UseLeaves(shader, b.At(base, i), row_major, path, at, i == 0 ? leaves : ignored);
    }
    return;
  }
  if (type.kind == ir::TypeKind::kStruct) {
    const ir::Struct structure = shader.program.types[type.structure];
    for (std::uint32_t i = 0; i < structure.fields.size(); ++i) {
      const ir::ExprId base = i == 0 ? expr : ir::Clone(shader.program, expr);
      UseLeaves(shader, b.Field(base, i), structure.fields[i].row_major,
                path + "." + structure.fields[i].name,
                offset + ir::FieldOffset(shader.program.types, type.structure, i), leaves);
    }
    return;
  }
  leaves.push_back({path, offset});
  shader.Use(expr);
}

std::map<std::string, std::uint32_t> Offsets(const std::string& reflection) {
  std::map<std::string, std::uint32_t> offsets;
  std::istringstream lines(reflection);
  static const std::regex kLine(R"(^([\w.\[\]]+): offset (\d+), type)");
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (!std::regex_search(line, match, kLine)) continue;
    const std::string name = std::regex_replace(match[1].str(), std::regex(R"(\[\d+\]|\.e\b)"), "");
    const auto offset = static_cast<std::uint32_t>(std::stoul(match[2]));
    const auto [found, is_new] = offsets.try_emplace(name, offset);
    if (!is_new && offset < found->second)
      found->second = offset;  // element 0 of an array of structs
  }
  return offsets;
}

class GlslangLayoutTest : public testing::TestWithParam<const char*> {};

TEST_P(GlslangLayoutTest, OffsetsAreDirect3ds) {
  int status = 0;
  Glslang("#version 450\nvoid main() {}\n", "", status);
  if (status != 0) GTEST_SKIP() << "no glslangValidator";
  int whole = 0, by_hand = 0;
  for (unsigned round = 0; round < 6; ++round) {
    TestShader shader;
    RandomCbuffers random(round * 977 + 1);
    std::vector<Leaf> leaves;
    for (int i = 0; i < 40; ++i) {
      std::vector<TestShader::NewMember> members;
      for (int m = 0, count = 1 + random.Below(4); m < count; ++m) {
        const std::string name = "m" + std::to_string(i) + "_" + std::to_string(m);
        members.push_back({name, random.Type(shader, 2), random.Below(2) == 0});
      }
      const std::string buffer = "Buffer" + std::to_string(i);
      const auto id = shader.AddCbuffer(buffer, members);
      std::vector<bool> is_read(shader.program.vars.size());
      for (const ir::CbufferMember& member : shader.program.cbuffers[id].members)
        is_read[member.var.index] = random.Below(3) > 0;
      const BlockLayout layout =
          LayOutBlock(shader.program, shader.program.cbuffers[id], *Target::Parse(GetParam()),
                      BlockStyle::kNamed, is_read);
      (layout.by_hand.empty() ? whole : by_hand) += 1;
      for (const ir::CbufferMember& member : shader.program.cbuffers[id].members) {
        if (!is_read[member.var.index]) continue;
        std::vector<Leaf> found;
        const ir::Var& var = shader.program.vars[member.var];
        UseLeaves(shader, shader.Make().Ref(member.var), var.row_major, buffer + "." + var.name,
                  member.offset, found);
        if (!layout.IsByHand(member.var)) leaves.insert(leaves.end(), found.begin(), found.end());
      }
      for (const BlockMember& part : layout.members) {
        if (part.form == PartForm::kWhole) continue;
        const std::string name = buffer + "." + shader.program.vars[part.var].name;
        if (part.form == PartForm::kRows) leaves.push_back({name + "_rows", part.offset});
        const int words =
            part.form == PartForm::kWords ? shader.program.types[part.type].columns : 0;
        for (int word = 0; word < words; ++word) {
          const auto at = part.offset + 4 * static_cast<std::uint32_t>(word);
          leaves.push_back({name + "_" + "xyzw"[word], at});
        }
      }
    }
    shader.Finish();
    const std::string glsl = GlslFor(shader.program, *Target::Parse(GetParam()));
    const std::string output = Glslang(glsl, "-q -l", status);
    ASSERT_EQ(status, 0) << output << glsl;
    const auto offsets = Offsets(output);
    for (const Leaf& leaf : leaves) {
      const auto found = offsets.find(leaf.path);
      ASSERT_NE(found, offsets.end()) << leaf.path << "\n" << output;
      EXPECT_EQ(found->second, leaf.offset) << leaf.path << "\n" << glsl;
    }
  }
  EXPECT_GT(whole, 20);
  EXPECT_GT(by_hand, 20);
}

INSTANTIATE_TEST_SUITE_P(Targets, GlslangLayoutTest,
                         testing::Values("glsl400", "glsl430", "glsl450"));

}  // namespace
}  // namespace clipc::glsl
