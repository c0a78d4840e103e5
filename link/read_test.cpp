// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "link/read.h"

#include <cstring>
#include <random>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "link/names.h"

namespace clipc::link {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// The words of a small fragment shader: it reads component 1 of a flat vec2 at location 3, a
// member of an array of two mat3 at location 5, and not the vec4 at location 1. Made with
// glslang from GLSL of our own would be shorter to say; by hand every word is in sight.
class Assembler {
 public:
  Assembler() : words_{0x07230203, 0x00010000, 0, 40, 0} {}
  Assembler& Op(std::uint32_t opcode, std::initializer_list<std::uint32_t> operands,
                std::string_view text = {}, std::initializer_list<std::uint32_t> rest = {}) {
    const std::size_t start = words_.size();
    words_.push_back(0);
    words_.insert(words_.end(), operands);
    if (!text.empty()) Text(text);
    words_.insert(words_.end(), rest);
    words_[start] = static_cast<std::uint32_t>(words_.size() - start) << 16 | opcode;
    return *this;
  }
  std::string Bytes() const {
    return {reinterpret_cast<const char*>(words_.data()), words_.size() * 4};
  }

 private:
  void Text(std::string_view text) {
    for (std::size_t i = 0; i <= text.size(); i += 4) {
      std::uint32_t word = 0;
      for (std::size_t k = i; k < std::min(i + 4, text.size()); ++k)
        word |= std::uint32_t{static_cast<unsigned char>(text[k])} << (k - i) * 8;
      words_.push_back(word);
    }
  }
  std::vector<std::uint32_t> words_;
};

std::string SmallModule(std::initializer_list<std::string_view> entries = {"ps"}) {
  Assembler module;
  for (const std::string_view entry : entries)
    module.Op(15, {4, 1}, entry, {20, 21, 22});  // OpEntryPoint Fragment
  module.Op(5, {20}, "i.uv").Op(5, {21}, "tangents").Op(5, {22}, "spare");
  module.Op(71, {20, 30, 3}).Op(71, {20, 14}).Op(71, {21, 30, 5}).Op(71, {22, 30, 1});
  module.Op(5632, {20, 5635}, "TEXCOORD2");  // OpDecorateString UserSemantic
  module.Op(71, {12, 2}).Op(71, {24, 34, 1}).Op(71, {24, 33, 7});
  module.Op(5, {12}, "type.Frame").Op(5, {24}, "Frame").Op(6, {12, 0}, "tint");
  module.Op(72, {12, 0, 35, 0});
  module.Op(19, {2}).Op(33, {3, 2}).Op(22, {4, 32}).Op(21, {5, 32, 0});
  module.Op(23, {6, 4, 2}).Op(23, {7, 4, 3}).Op(24, {8, 7, 3}).Op(23, {9, 4, 4});
  module.Op(43, {5, 10, 2}).Op(43, {5, 14, 1});  // the constants 2 and 1
  module.Op(28, {11, 8, 10}).Op(30, {12, 9});    // mat3[2], struct {vec4}
  module.Op(32, {15, 1, 6})
      .Op(32, {16, 1, 11})
      .Op(32, {17, 1, 9})
      .Op(32, {18, 2, 12})
      .Op(32, {19, 1, 4});
  module.Op(59, {15, 20, 1}).Op(59, {16, 21, 1}).Op(59, {17, 22, 1}).Op(59, {18, 24, 2});
  module.Op(54, {2, 1, 0, 3}).Op(248, {30});            // OpFunction, OpLabel
  module.Op(65, {19, 31, 20, 14}).Op(61, {4, 32, 31});  // component 1
  module.Op(61, {11, 33, 21}).Op(81, {8, 34, 33, 1}).Op(253, {}).Op(56, {});
  return module.Bytes();
}

TEST(Spirv, ReadsTheInterface) {
  const ReadResult result = ReadSpirv(SmallModule(), "a.spv", "ps");
  ASSERT_THAT(result.problems, testing::IsEmpty());
  ASSERT_EQ(result.interface.inputs.size(), 3u);
  const Input& uv = result.interface.inputs[0];
  EXPECT_EQ(uv.name, "i_uv");
  EXPECT_EQ(uv.semantic, "TEXCOORD");
  EXPECT_EQ(uv.index, 2u);
  EXPECT_EQ(uv.location, 3u);
  EXPECT_EQ(NameOf(uv.type), "vec2");
  EXPECT_EQ(uv.interpolation, ir::Interpolation::kNoInterpolation);
  EXPECT_TRUE(uv.is_read);
  EXPECT_EQ(uv.components_read, 2u);
  const Input& tangents = result.interface.inputs[1];
  EXPECT_EQ(NameOf(tangents.type), "mat3[2]");
  EXPECT_EQ(tangents.type.Elements(), 6u);
  EXPECT_TRUE(tangents.is_read);
  EXPECT_FALSE(result.interface.inputs[2].is_read);
  ASSERT_EQ(result.interface.blocks.size(), 1u);
  const UniformBlock& block = result.interface.blocks[0];
  EXPECT_EQ(block.name, "type_Frame");
  EXPECT_EQ(block.instance, "Frame");
  EXPECT_EQ(block.set, 1u);
  EXPECT_EQ(block.binding, 7u);
  ASSERT_EQ(block.members.size(), 1u);
  EXPECT_EQ(block.members[0].name, "tint");
  EXPECT_EQ(block.members[0].offset, 0u);
}

TEST(Spirv, ReadsEitherOrderOfBytes) {
  std::string bytes = SmallModule();
  for (std::size_t i = 0; i < bytes.size(); i += 4) std::reverse(&bytes[i], &bytes[i] + 4);
  EXPECT_EQ(LanguageOf(bytes), Language::kSpirv);
  EXPECT_EQ(ReadSpirv(bytes, "a.spv", "").interface.inputs.size(), 3u);
}

TEST(Spirv, SaysWhatIsWrong) {
  const std::string bytes = SmallModule();
  EXPECT_THAT(ReadSpirv(bytes, "a.spv", "other").problems,
              ElementsAre("a.spv: there is no fragment shader `other`; there is `ps`"));
  EXPECT_THAT(ReadSpirv(bytes.substr(0, 7), "a.spv", "ps").problems,
              ElementsAre("a.spv: the SPIR-V ends within its header"));
}

TEST(Spirv, OneOfSeveralFragmentShadersIsNamed) {
  const std::string bytes = SmallModule({"ps", "shadow"});
  EXPECT_EQ(ReadSpirv(bytes, "a.spv", "shadow").interface.inputs.size(), 3u);
  EXPECT_THAT(ReadSpirv(bytes, "a.spv", "").problems,
              ElementsAre("a.spv: there are several fragment shaders, `ps`, `shadow`; "
                          "`--pixel-entry` names one"));
}

// Struct 20 has 16 members of struct 20.
TEST(Spirv, CountsMembersOfStructsThatNameThemselves) {
  std::vector<std::uint32_t> words = {0x07230203, 0x10000, 0, 100, 0};
  const auto add = [&](std::uint32_t opcode, const std::vector<std::uint32_t>& operands) {
    words.push_back(static_cast<std::uint32_t>(operands.size() + 1) << 16 | opcode);
    words.insert(words.end(), operands.begin(), operands.end());
  };
  std::vector<std::uint32_t> structure(17, 20);
  add(15, {4, 4, 0x73, 21});  // the entry point "s"
  add(71, {20, 2});           // a UniformBlock
  add(30, structure);
  add(32, {22, 2, 20});
  add(59, {22, 21, 2});
  std::string bytes(words.size() * 4, 0);
  std::memcpy(bytes.data(), words.data(), bytes.size());
  EXPECT_THAT(ReadSpirv(bytes, "a.spv", "").problems,
              ElementsAre("a.spv: the blocks have more than 65536 members"));
}

// No beginning of a module and no change of a byte does harm.
TEST(Spirv, SurvivesAnyBytes) {
  const std::string bytes = SmallModule();
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(ReadSpirv(bytes.substr(0, size), "a.spv", "ps").problems.empty() &&
                 ReadSpirv(bytes.substr(0, size), "a.spv", "ps").interface.inputs.size() > 3);
  std::mt19937 random(1);
  for (int i = 0; i < 20000; ++i) {
    std::string changed = bytes;
    for (int k = 0; k < 3; ++k)
      changed[20 + random() % (bytes.size() - 20)] = static_cast<char>(random());
    const ReadResult result = ReadSpirv(changed, "a.spv", "");
    if (result.problems.empty()) Problem(result.interface);
  }
}

TEST(Glsl, ReadsTheInterface) {
  const ReadResult result = ReadGlsl(R"(#version 450
layout(location = 2) flat in uvec2 id;
layout(location = 4) centroid noperspective in mat3x4 bones[2];
layout(location = 12) in vec4 spare;
layout(std140, binding = 3) uniform Frame { layout(row_major) mat4 view; vec3 eye[2]; } frame;
layout(std140, row_major, binding = 4) uniform Plain { mat4 world; float pad; };
uniform vec4 loose;
layout(location = 0) out vec4 target;
float twice(float x) { return 2.0 * x + float(id.y); }
void main() { target = bones[1][0] * twice(frame.eye[1].x) * gl_FragCoord.x * loose; }
)",
                                     "a.frag");
  ASSERT_THAT(result.problems, testing::IsEmpty());
  ASSERT_EQ(result.interface.inputs.size(), 3u);
  const Input& id = result.interface.inputs[0];
  EXPECT_EQ(NameOf(id.type), "uvec2");
  EXPECT_EQ(id.location, 2u);
  EXPECT_EQ(id.interpolation, ir::Interpolation::kNoInterpolation);
  EXPECT_EQ(id.components_read, 2u);
  EXPECT_EQ(id.where, "a.frag:2");
  const Input& bones = result.interface.inputs[1];
  EXPECT_EQ(NameOf(bones.type), "mat3x4[2]");
  EXPECT_TRUE(bones.centroid);
  EXPECT_EQ(bones.interpolation, ir::Interpolation::kNoPerspective);
  EXPECT_FALSE(result.interface.inputs[2].is_read);
  ASSERT_EQ(result.interface.blocks.size(), 2u);
  const UniformBlock& frame = result.interface.blocks[0];
  EXPECT_EQ(frame.instance, "frame");
  EXPECT_EQ(frame.binding, 3u);
  EXPECT_FALSE(frame.rows_on_block);
  EXPECT_EQ(frame.members[0].matrices, ir::MatrixLayout::kRowMajor);
  EXPECT_EQ(NameOf(*frame.members[1].type), "vec3[2]");
  EXPECT_FALSE(result.interface.blocks[1].has_instance);
  EXPECT_TRUE(result.interface.blocks[1].rows_on_block);
  ASSERT_EQ(result.interface.uniforms.size(), 1u);
  EXPECT_EQ(result.interface.uniforms[0].name, "loose");
}

TEST(Glsl, KnowsTheDialects) {
  EXPECT_TRUE(
      ReadGlsl("#version 120\nvarying vec2 uv; void main() { gl_FragColor = uv.xyxy; }", "a")
          .problems.empty());
  EXPECT_TRUE(ReadGlsl("#version 300 es\nprecision highp float; in vec2 uv; out vec4 c;\n"
                       "void main() { c = uv.xyxy; }",
                       "a")
                  .problems.empty());
  EXPECT_TRUE(ReadGlsl("#version 450\nlayout(set = 1, binding = 2) uniform texture2D t;\n"
                       "layout(set = 0, binding = 1) uniform sampler s;\n"
                       "layout(location = 0) out vec4 c;\n"
                       "void main() { c = texture(sampler2D(t, s), vec2(0)); }",
                       "a")
                  .problems.empty());
}

// GLSL that glslang refuses and drivers take: a function of a later version, an unknown extension.
TEST(Glsl, IsReadLeniently) {
  EXPECT_TRUE(ReadGlsl("#version 330\n#extension GL_ARB_texture_query_levels : require\n"
                       "uniform sampler2D t; in vec2 uv; out vec4 c;\n"
                       "void main() { c = vec4(textureQueryLevels(t)) + uv.x; }",
                       "a")
                  .problems.empty());
  EXPECT_TRUE(ReadGlsl("#version 300 es\nprecision highp float; in vec2 uv; out vec4 c;\n"
                       "layout(early_fragment_tests) in; void main() { c = uv.xyxy; }",
                       "a")
                  .problems.empty());
}

TEST(Glsl, RefusesStructsThatDouble) {
  std::string text = "#version 450\nstruct S0 { vec4 a; };\n";
  for (int i = 1; i < 40; ++i)
    text += fmt::format("struct /* doubled */ S{0} {{ S{1} a; highp S{1} b; }};\n", i, i - 1);
  text += "uniform C { S39 s; } c;\nvoid main() {}\n";
  EXPECT_THAT(ReadGlsl(text, "a.frag").problems,
              ElementsAre("a.frag: a struct has more than 65536 members"));
}

TEST(Glsl, LooksIntoMacros) {
  const auto doubled = [](int count) {
    std::string text = "#version 450\n#define A0 c\n";
    for (int i = 1; i < count; ++i) text += fmt::format("#define A{0} A{1} + A{1}\n", i, i - 1);
    return text + fmt::format("layout(location = 0) out float c;\nvoid main() {{ c = A{}; }}\n",
                              count - 1);
  };
  EXPECT_THAT(ReadGlsl(doubled(8), "a.frag").problems, testing::IsEmpty());
  EXPECT_THAT(ReadGlsl(doubled(16), "a.frag").problems,
              ElementsAre("a.frag: a statement has more than 4096 operators"));
  EXPECT_THAT(ReadGlsl(doubled(60), "a.frag").problems,
              ElementsAre("a.frag: its macros may make more than 1048576 words of it"));
  std::string pasted = doubled(60);
  pasted.replace(pasted.find("A59;"), 4, "PASTE(A, 59);");
  EXPECT_THAT(ReadGlsl("#version 450\n#define PASTE(a, b) a##b\n" + pasted, "a.frag").problems,
              ElementsAre(HasSubstr("its macros may make")));
  const std::string nested = "#version 450\n#define F(x) x + x\nout float c;\nvoid main() { c = ";
  std::string calls = "c";
  for (int i = 0; i < 40; ++i) calls.insert(0, "F(").append(")");
  EXPECT_THAT(ReadGlsl(nested + calls + "; }\n", "a.frag").problems,
              ElementsAre(HasSubstr("its macros may make")));
}

TEST(Glsl, RefusesStatementsThatGlslangCannotWalk) {
  std::string sum = "#version 450\nlayout(location = 0) out float c;\nvoid main() { c = 1.0";
  for (int i = 0; i < 200000; ++i) sum += "+c";
  EXPECT_THAT(ReadGlsl(sum + "; }", "a.frag").problems,
              ElementsAre(HasSubstr("more than 4096 operators")));
}

TEST(Language, IsToldByContent) {
  EXPECT_EQ(LanguageOf("/* mine */\n#version 330\nvoid main() {}"), Language::kGlsl);
  EXPECT_EQ(LanguageOf("varying vec2 uv; void main() { gl_FragColor = uv.xyxy; }"),
            Language::kGlsl);
  EXPECT_EQ(LanguageOf("float4 main() : SV_Target { return 0; } // vec4"), Language::kHlsl);
  EXPECT_EQ(LanguageOf("static const float4 version = 1;"), Language::kHlsl);
  EXPECT_EQ(LanguageOf(""), Language::kHlsl);
}

TEST(Names, AreSpelledAsSpirvCrossSpellsThem) {
  EXPECT_EQ(GlslNameOf("i.a[1]"), "i_a_1_");
  EXPECT_EQ(GlslNameOf("in.var.TEXCOORD0"), "in_var_TEXCOORD0");
  EXPECT_EQ(GlslNameOf("@entryPointOutput"), "_entryPointOutput");
}

TEST(Problem, FindsInputsInOnePlace) {
  Interface interface;
  interface.inputs.resize(2);
  for (Input& input : interface.inputs) input.where = "a.spv: `x`";
  EXPECT_EQ(Problem(interface), "");
  interface.inputs[0].location = 1;
  EXPECT_EQ(Problem(interface), "some inputs have a location and some have none");
  interface.inputs[0].type.columns = 4;
  interface.inputs[1].location = 4;
  EXPECT_EQ(Problem(interface),
            "a.spv: `x`: location 4 has another input; give each a location of its own, without "
            "`component`");
  interface.inputs[1].location = 5;
  EXPECT_EQ(Problem(interface), "");
  interface.inputs[1].type.dimensions = {70000, 70000};
  EXPECT_THAT(Problem(interface), HasSubstr("an array of 1 to 256 vectors"));
}

}  // namespace
}  // namespace clipc::link
