// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/clipc.h"

#include <cstring>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using testing::AllOf;
using testing::Eq;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

constexpr const char* kShader =
    "#include \"planes.hlsli\"\n"
    "[clipplanes(water)]\n"
    "float4 main(float4 p : POSITION) : SV_Position { return p + SHIFT; }\n";

class CInterface : public testing::Test {
 protected:
  clipc_status Compile(std::vector<const char*> options, std::string_view text = kShader) {
    clipc_request request{};
    request.size = sizeof request;
    request.path = path_;
    request.text = text.data();
    request.text_size = text.size();
    request.options = options.data();
    request.option_count = options.size();
    request.read_include = ReadInclude;
    request.read_include_context = this;
    return Run(request);
  }

  clipc_status Run(const clipc_request& request) {
    clipc_result* made = nullptr;
    const clipc_status status = clipc_compile(compiler_.get(), &request, &made);
    result_.reset(made);
    return status;
  }

  std::string_view Get(clipc_part part) const {
    const clipc_bytes bytes = clipc_result_get(result_.get(), part);
    EXPECT_NE(bytes.data, nullptr);
    EXPECT_EQ(bytes.data[bytes.size], '\0');
    return {bytes.data, bytes.size};
  }

  static int ReadInclude(void* context, const char* path, clipc_bytes* text) {
    auto& self = *static_cast<CInterface*>(context);
    self.asked_.emplace_back(path);
    const auto found = self.includes_.find(path);
    if (found == self.includes_.end()) return 0;
    *text = {found->second.data(), found->second.size()};
    return 1;
  }

  const char* path_ = "shaders/water.hlsl";
  std::map<std::string, std::string> includes_ = {
      {"shaders/planes.hlsli",
       "#pragma once\n#include \"common/shift.hlsli\"\n"
       "#include \"planes.hlsli\"\ncbuffer Clip { float4 water; };\n"},
      {"lib/common/shift.hlsli", "#define SHIFT 2\n"}};
  std::vector<std::string> asked_;
  std::unique_ptr<clipc_compiler, decltype(&clipc_compiler_free)> compiler_{clipc_compiler_create(),
                                                                            &clipc_compiler_free};
  std::unique_ptr<clipc_result, decltype(&clipc_result_free)> result_{nullptr, &clipc_result_free};
};

TEST_F(CInterface, CompilesFromMemory) {
  ASSERT_EQ(Compile({"-T", "vs_5_0", "-Ilib", "--target=vulkan", "-spirv"}), CLIPC_COMPILED)
      << Get(CLIPC_PART_MESSAGES);
  EXPECT_THAT(Get(CLIPC_PART_MESSAGES), IsEmpty());
  EXPECT_THAT(Get(CLIPC_PART_GLSL), StartsWith("#version 460"));
  EXPECT_THAT(Get(CLIPC_PART_GLSL), HasSubstr("gl_ClipDistance"));
  EXPECT_THAT(Get(CLIPC_PART_SPIRV), StartsWith("\x03\x02\x23\x07"));
  EXPECT_THAT(Get(CLIPC_PART_REFLECTION), HasSubstr("\"clipPlanes\""));
  EXPECT_THAT(Get(CLIPC_PART_TABLE_JSON), HasSubstr("\"clipc.clip-table\""));
  EXPECT_THAT(Get(CLIPC_PART_TABLE_HEADER), HasSubstr("StaticClipTable"));
  EXPECT_EQ(Get(CLIPC_PART_TABLE_BINARY).size(), 20u);
  EXPECT_EQ(Get(CLIPC_PART_DEPENDENCIES), "shaders/planes.hlsli\nlib/common/shift.hlsli\n");
  EXPECT_THAT(Get(CLIPC_PART_DISCARD), IsEmpty());
  EXPECT_THAT(Get(static_cast<clipc_part>(99)), IsEmpty());
  EXPECT_EQ(asked_, (std::vector<std::string>{"shaders/planes.hlsli", "shaders/common/shift.hlsli",
                                              "lib/common/shift.hlsli"}));
}

TEST_F(CInterface, ReadsNoFileWhereIncludesComeFromMemory) {
  EXPECT_EQ(Compile({"-I/usr/include"}, "#include <stdio.h>\n"), CLIPC_HAS_ERRORS);
  EXPECT_THAT(Get(CLIPC_PART_MESSAGES), HasSubstr("[missing-include, X1507]"));
  EXPECT_EQ(Compile({}, "#include \"/etc/hostname\"\n"), CLIPC_HAS_ERRORS);
  EXPECT_THAT(Get(CLIPC_PART_DEPENDENCIES), IsEmpty());
}

TEST_F(CInterface, DoesNotFindIncludesWhoseNameIsNotThatOfAFile) {
  const std::vector<std::string> names = {"a/", "/", "//", "a\\\\", "planes.hlsli/", {"a\0b", 3}};
  for (const std::string& name : names) {
    const std::string text = "#include \"" + name + "\"\n";
    EXPECT_EQ(Compile({"-Ilib/"}, text), CLIPC_HAS_ERRORS) << name;
    EXPECT_THAT(Get(CLIPC_PART_MESSAGES), HasSubstr("[missing-include, X1507]")) << name;
  }
  EXPECT_EQ(Compile({}, "#include \"\"\n"), CLIPC_HAS_ERRORS);
  EXPECT_THAT(Get(CLIPC_PART_MESSAGES), HasSubstr("empty filename"));
  EXPECT_THAT(asked_, IsEmpty());
}

TEST_F(CInterface, DoesNotTakeTheNameOfAFolderForThatOfItsText) {
  for (const char* path : {"a/", "/", "//"}) {
    path_ = path;
    EXPECT_EQ(Compile({}), CLIPC_BAD_REQUEST) << path;
    EXPECT_THAT(Get(CLIPC_PART_MESSAGES), HasSubstr("[cannot-read-file, X1507]")) << path;
  }
}

TEST_F(CInterface, ReportsErrors) {
  includes_["shaders/planes.hlsli"] = "cbuffer Clip { float3 water; };\n#define SHIFT 0\n";
  EXPECT_EQ(Compile({}), CLIPC_HAS_ERRORS);
  EXPECT_THAT(Get(CLIPC_PART_MESSAGES),
              StartsWith("shaders/water.hlsl:2:13: error: clip plane `water` has type `float3`"));
  EXPECT_THAT(Get(CLIPC_PART_MESSAGES_JSON), HasSubstr("\"clip-plane-not-float4\""));
  EXPECT_THAT(Get(CLIPC_PART_GLSL), IsEmpty());
  EXPECT_THAT(Get(CLIPC_PART_TABLE_JSON), IsEmpty());
}

TEST_F(CInterface, RefusesOptionsThatItDoesNotKnowOrThatNameFiles) {
  EXPECT_EQ(Compile({"--tabel=x"}), CLIPC_BAD_REQUEST);
  EXPECT_EQ(Get(CLIPC_PART_MESSAGES),
            "clipc: error: unknown option `--tabel=x`; did you mean `--table=x`?\n");
  for (const char* option :
       {"x.hlsl", "-ox.vert", "--table=x.json", "-MD", "--help", "-Px.i", "--batch=x.json",
        "--index=x.json", "--shard=1/2", "-k", "--watch", "--resume", "--shard=merge",
        "--reflect=x.h", "-fsyntax-only", "--dump=ir"}) {
    EXPECT_EQ(Compile({option}), CLIPC_BAD_REQUEST) << option;
    EXPECT_THAT(Get(CLIPC_PART_MESSAGES), HasSubstr("` is for the program; the library compiles"));
    EXPECT_THAT(Get(CLIPC_PART_MESSAGES_JSON), HasSubstr("\"name\": \"command-line\""));
  }
  EXPECT_EQ(Compile({"--target=450"}), CLIPC_BAD_REQUEST);
}

TEST_F(CInterface, GivesTheHlslThatIsAskedFor) {
  EXPECT_EQ(Compile({"-Ilib", "--target=hlsl"}), CLIPC_COMPILED) << Get(CLIPC_PART_MESSAGES);
  EXPECT_THAT(Get(CLIPC_PART_HLSL), HasSubstr(": SV_ClipDistance0"));
  EXPECT_THAT(Get(CLIPC_PART_HLSL), HasSubstr("#include \"planes.hlsli\""));
  for (const clipc_part other : {CLIPC_PART_GLSL, CLIPC_PART_SPIRV, CLIPC_PART_TABLE_JSON})
    EXPECT_THAT(Get(other), IsEmpty());
  EXPECT_EQ(Compile({"-Ilib", "--target=hlsl", "--lower=level9"}), CLIPC_BAD_REQUEST);
  EXPECT_THAT(Get(CLIPC_PART_HLSL), IsEmpty());
  EXPECT_EQ(Compile({"-Ilib"}), CLIPC_COMPILED) << Get(CLIPC_PART_MESSAGES);
  EXPECT_THAT(Get(CLIPC_PART_HLSL), IsEmpty());
}

constexpr std::string_view kHalves =
    "float4 vs(float4 p : POSITION, out float2 uv : UV) : SV_Position { uv = p.xy; return p; }\n"
    "float4 ps(float2 uv : UV) : SV_Target { return uv.xyxy; }\n";

TEST_F(CInterface, CompilesThePairOfOneText) {
  ASSERT_EQ(Compile({"-E", "vs", "--pixel-entry=ps", "--pixel-output=.frag", "-spirv"}, kHalves),
            CLIPC_COMPILED)
      << Get(CLIPC_PART_MESSAGES);
  EXPECT_THAT(Get(CLIPC_PART_GLSL), HasSubstr("out vec2 vs_UV0;"));
  EXPECT_THAT(Get(CLIPC_PART_PIXEL), HasSubstr("in vec2 vs_UV0;"));
  EXPECT_THAT(Get(CLIPC_PART_PIXEL_SPIRV), StartsWith("\x03\x02\x23\x07"));
  EXPECT_THAT(Get(CLIPC_PART_REFLECTION), HasSubstr("\"pixelShader\""));
}

TEST_F(CInterface, GivesEveryShaderOfAProgram) {
  const std::string text = std::string(kHalves) +
                           "struct V { float4 p : SV_Position; float2 uv : UV; };\n"
                           "[maxvertexcount(1)] void gs(point V v[1], inout PointStream<V> s) {\n"
                           "  s.Append(v[0]); }\n";
  ASSERT_EQ(Compile({"-E", "vs", "--geometry-entry=gs", "--geometry-output=.geom",
                     "--pixel-entry=ps", "--pixel-output=.frag", "-spirv"},
                    text),
            CLIPC_COMPILED)
      << Get(CLIPC_PART_MESSAGES);
  std::vector<std::string_view> stages;
  while (const clipc_shader* shader = clipc_result_shader(result_.get(), stages.size())) {
    stages.emplace_back(shader->stage);
    EXPECT_THAT(std::string_view(shader->spirv.data, shader->spirv.size),
                StartsWith("\x03\x02\x23\x07"));
    EXPECT_THAT(shader->reflection->profile, ::testing::EndsWith("s_5_0"));
  }
  EXPECT_THAT(stages, ::testing::ElementsAre("vertex", "geometry", "pixel"));
  const clipc_shader* const geometry = clipc_result_shader(result_.get(), 1);
  EXPECT_THAT(geometry->text.data, HasSubstr("EmitVertex()"));
  EXPECT_STREQ(geometry->reflection->input_primitive, "point");
  EXPECT_EQ(clipc_result_shader(result_.get(), 0)->text.data, Get(CLIPC_PART_GLSL).data());
  EXPECT_EQ(clipc_result_shader(result_.get(), 2)->text.data, Get(CLIPC_PART_PIXEL).data());

  // Without a pixel shader there is none, and what discards is not a shader of it.
  ASSERT_EQ(Compile({"-E", "vs", "--geometry-entry=gs", "--geometry-output=.geom"}, text),
            CLIPC_COMPILED);
  EXPECT_THAT(Get(CLIPC_PART_PIXEL), IsEmpty());
  EXPECT_EQ(clipc_result_reflection(result_.get())->pixel_shader, nullptr);
  ASSERT_EQ(Compile({"-Ilib", "--lower=discard"}), CLIPC_COMPILED) << Get(CLIPC_PART_MESSAGES);
  EXPECT_THAT(Get(CLIPC_PART_DISCARD), HasSubstr("discard"));
  EXPECT_EQ(clipc_result_shader(result_.get(), 1), nullptr);
  EXPECT_EQ(Compile({"-E", "vs", "--geometry-entry=gs", "--geometry-output=x.geom"}, text),
            CLIPC_BAD_REQUEST);
  EXPECT_THAT(Get(CLIPC_PART_MESSAGES), HasSubstr("`--geometry-output` is for the program"));
  EXPECT_EQ(clipc_result_shader(result_.get(), 0), nullptr);
  EXPECT_EQ(Compile({"-E", "vs", "--geometry-entry=gs"}, text), CLIPC_BAD_REQUEST);
}

TEST_F(CInterface, CompilesAPixelShaderAlone) {
  ASSERT_EQ(Compile({"-T", "ps_5_0", "-E", "ps", "-spirv"}, kHalves), CLIPC_COMPILED)
      << Get(CLIPC_PART_MESSAGES);
  EXPECT_THAT(Get(CLIPC_PART_GLSL), HasSubstr("out vec4 SV_Target0;"));
  EXPECT_THAT(Get(CLIPC_PART_SPIRV), StartsWith("\x03\x02\x23\x07"));
  EXPECT_THAT(Get(CLIPC_PART_REFLECTION), HasSubstr("\"stage\": \"pixel\""));
  EXPECT_THAT(Get(CLIPC_PART_TABLE_JSON), HasSubstr("\"planes\": []"));
  EXPECT_EQ(Compile({"-T", "ps_5_0", "-E", "vs"}, kHalves), CLIPC_HAS_ERRORS);
}

TEST_F(CInterface, TakesThePixelShaderFromMemory) {
  includes_["half.hlsl"] = "float4 main(float2 uv : UV) : SV_Target { return uv.yxyx; }\n";
  const std::vector<const char*> fits = {"-E", "vs", "--pixel-shader=half.hlsl"};
  std::vector<const char*> pair = fits;
  pair.push_back("--pixel-output=.frag");
  ASSERT_EQ(Compile(fits, kHalves), CLIPC_COMPILED) << Get(CLIPC_PART_MESSAGES);
  EXPECT_THAT(Get(CLIPC_PART_GLSL), HasSubstr("out vec2 uv;"));
  EXPECT_THAT(Get(CLIPC_PART_PIXEL), IsEmpty());
  ASSERT_EQ(Compile(pair, kHalves), CLIPC_COMPILED) << Get(CLIPC_PART_MESSAGES);
  EXPECT_THAT(Get(CLIPC_PART_PIXEL), HasSubstr("vs_UV0.yxyx"));

  includes_.clear();
  EXPECT_EQ(Compile(fits, kHalves), CLIPC_HAS_ERRORS);
  EXPECT_THAT(Get(CLIPC_PART_MESSAGES), HasSubstr("half.hlsl: there is no such file"));
  EXPECT_EQ(Compile(pair, kHalves), CLIPC_BAD_REQUEST);
  EXPECT_THAT(Get(CLIPC_PART_MESSAGES), HasSubstr("half.hlsl: there is no such file"));

  clipc_request request{};
  request.size = sizeof request;
  request.path = "water.hlsl";
  request.text = kHalves.data();
  request.text_size = kHalves.size();
  request.options = pair.data();
  request.option_count = pair.size();
  request.pixel_text = "float4 main(float2 uv : UV) : SV_Target { return uv.yyyy; }";
  request.pixel_text_size = std::strlen(request.pixel_text);
  ASSERT_EQ(Run(request), CLIPC_COMPILED) << Get(CLIPC_PART_MESSAGES);
  EXPECT_THAT(Get(CLIPC_PART_PIXEL), HasSubstr("vs_UV0.yyyy"));
}

TEST_F(CInterface, AsksForTheIncludesOfEachShaderOfAPair) {
  constexpr std::string_view kPair =
      "#include \"planes.hlsli\"\n"
      "[clipplanes(water)] float4 vs(float4 p : POSITION) : SV_Position { return p + SHIFT; }\n"
      "float4 ps() : SV_Target { return SHIFT; }\n";
  const std::vector<const char*> pair = {"-Ilib", "-E", "vs", "--pixel-entry=ps",
                                         "--pixel-output=.frag"};
  const auto with = [&](std::vector<const char*> more) {
    more.insert(more.begin(), pair.begin(), pair.end());
    return more;
  };
  for (const auto& options :
       {pair, with({"--variants"}), with({"--lower=discard"}), with({"--target=vulkan", "-spirv"}),
        with({"--target=hlsl", "--lower=discard"})}) {
    EXPECT_EQ(Compile(options, kPair), CLIPC_COMPILED)
        << options.back() << ": " << Get(CLIPC_PART_MESSAGES);
  }
  ASSERT_EQ(Compile(pair, kPair), CLIPC_COMPILED);
  EXPECT_THAT(Get(CLIPC_PART_PIXEL), HasSubstr("vec4(2.0)"));

  // The pixel shader has a text of its own, and an include that the other shader has too.
  clipc_request request{};
  request.size = sizeof request;
  request.path = path_;
  request.text = kPair.data();
  request.text_size = kPair.size();
  const std::vector<const char*> options = with({"--pixel-shader=shaders/half.hlsl"});
  request.options = options.data();
  request.option_count = options.size();
  request.read_include = ReadInclude;
  request.read_include_context = this;
  request.pixel_text = "#include \"planes.hlsli\"\nfloat4 ps() : SV_Target { return SHIFT + 1; }\n";
  request.pixel_text_size = std::strlen(request.pixel_text);
  ASSERT_EQ(Run(request), CLIPC_COMPILED) << Get(CLIPC_PART_MESSAGES);
  EXPECT_THAT(Get(CLIPC_PART_PIXEL), HasSubstr("2 + 1"));
}

TEST_F(CInterface, GivesTheHlslOfBothShadersThatDiscard) {
  constexpr std::string_view kPlane =
      "float4 plane;\n"
      "[clipplanes(plane)] float4 vs(float4 p : POSITION) : SV_Position { return p; }\n"
      "float4 ps() : SV_Target { return 1; }\n";
  const std::vector<const char*> one = {"-E", "vs", "--pixel-entry=ps", "--target=hlsl",
                                        "--lower=discard"};
  std::vector<const char*> two = one;
  two.push_back("--pixel-output=.frag");
  ASSERT_EQ(Compile(one, kPlane), CLIPC_COMPILED) << Get(CLIPC_PART_MESSAGES);
  EXPECT_THAT(Get(CLIPC_PART_HLSL), AllOf(HasSubstr("clipc_vs("), HasSubstr("discard;")));
  EXPECT_THAT(Get(CLIPC_PART_PIXEL), IsEmpty());
  ASSERT_EQ(Compile(two, kPlane), CLIPC_COMPILED) << Get(CLIPC_PART_MESSAGES);
  EXPECT_THAT(Get(CLIPC_PART_HLSL), Not(HasSubstr("discard;")));
  EXPECT_THAT(Get(CLIPC_PART_PIXEL), AllOf(HasSubstr("[clipplanes"), HasSubstr("discard;")));

  // A file of its own is rewritten by itself, whether its output is named or not.
  includes_["other.hlsl"] = "float4 ps() : SV_Target { return 0.5; }\n";
  std::vector<const char*> apart = one;
  apart.push_back("--pixel-shader=other.hlsl");
  ASSERT_EQ(Compile(apart, kPlane), CLIPC_COMPILED) << Get(CLIPC_PART_MESSAGES);
  EXPECT_THAT(Get(CLIPC_PART_HLSL), Not(HasSubstr("discard;")));
  EXPECT_THAT(Get(CLIPC_PART_PIXEL), AllOf(HasSubstr("return 0.5;"), HasSubstr("discard;")));
}

TEST_F(CInterface, EndsWhenTheCallerCancels) {
  std::string long_shader = kShader;
  for (int i = 0; i < 3000; ++i)
    long_shader += "float f" + std::to_string(i) + "(float x) { return x + SHIFT; }\n";
  struct Budget {
    int calls = 0, allowed = 0;
  } budget;
  clipc_request request{};
  request.size = sizeof request;
  request.path = "shaders/water.hlsl";
  request.text = long_shader.data();
  request.text_size = long_shader.size();
  const char* const options[] = {"-Ilib"};
  request.options = options;
  request.option_count = 1;
  request.read_include = ReadInclude;
  request.read_include_context = this;
  request.is_cancelled = [](void* context) {
    auto& left = *static_cast<Budget*>(context);
    return ++left.calls > left.allowed ? 1 : 0;
  };
  request.is_cancelled_context = &budget;
  // The compile is cancelled at every point where the callback is asked: while the text is read,
  // and between the passes.
  int most = 0;
  for (; budget.allowed = most, budget.calls = 0, Run(request) != CLIPC_COMPILED; ++most) {
    ASSERT_LT(most, 1000);
    EXPECT_THAT(Get(CLIPC_PART_MESSAGES),
                Eq("clipc: error: the caller cancelled the compile [cancelled]\n"));
    EXPECT_THAT(Get(CLIPC_PART_MESSAGES_JSON), HasSubstr("\"cancelled\""));
    EXPECT_THAT(Get(CLIPC_PART_GLSL), IsEmpty());
    EXPECT_EQ(budget.calls, most + 1) << "asked again after the answer";
  }
  EXPECT_GT(most, 50);
}

TEST_F(CInterface, HasLimits) {
  EXPECT_EQ(Compile({"-Ilib", "--max-bytes=1000", "--max-tokens=1000", "--max-seconds=60"}),
            CLIPC_COMPILED)
      << Get(CLIPC_PART_MESSAGES);
  EXPECT_EQ(Compile({"-Ilib", "--max-bytes=100"}), CLIPC_HAS_ERRORS);
  EXPECT_THAT(Get(CLIPC_PART_MESSAGES), HasSubstr("more than 100 bytes of text"));
}

TEST_F(CInterface, TakesTheRequestOfAnOlderCaller) {
  const std::string file = std::string(testing::TempDir()) + "clipc_no_such_file.hlsl";
  clipc_request request;
  std::memset(&request, 0xff, sizeof request);
  request.size = offsetof(clipc_request, options);
  request.path = file.c_str();
  request.text = "float4 main(float4 p : POSITION) : SV_Position { return p; }";
  request.text_size = std::strlen(request.text);
  EXPECT_EQ(Run(request), CLIPC_COMPILED) << Get(CLIPC_PART_MESSAGES);
  request.text = nullptr;
  EXPECT_EQ(Run(request), CLIPC_BAD_REQUEST);
  EXPECT_THAT(Get(CLIPC_PART_MESSAGES), HasSubstr("cannot read"));
}

TEST_F(CInterface, GivesTheMessagesAsStructs) {
  EXPECT_EQ(Compile({"-Ilib"},
                    "float4 main(float4 p : POSITION) : SV_Position { return -p; }\n"
                    "float4 main(float4 p : POSITION) : SV_Position { return p; }\n"),
            CLIPC_HAS_ERRORS);
  const clipc_diagnostic* first = clipc_result_diagnostic(result_.get(), 0);
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(first->severity, CLIPC_ERROR);
  EXPECT_STREQ(first->file, path_);
  EXPECT_GT(first->line, 0U);
  std::size_t count = 0, notes = 0;
  while (const clipc_diagnostic* each = clipc_result_diagnostic(result_.get(), count)) {
    EXPECT_NE(*each->text, '\0');
    notes += each->severity == CLIPC_NOTE ? 1 : 0;
    ++count;
  }
  EXPECT_EQ(notes, 2U) << Get(CLIPC_PART_MESSAGES);
  EXPECT_EQ(Compile({"--tabel=x"}), CLIPC_BAD_REQUEST);
  EXPECT_STREQ(clipc_result_diagnostic(result_.get(), 0)->name, "command-line");
}

TEST_F(CInterface, GivesTheReflectionAsStructs) {
  constexpr std::string_view kPair =
      "cbuffer Frame : register(b1) { float4 tint, shift; };\n"
      "Texture2D map : register(t2); SamplerState near : register(s0);\n"
      "float4 vs(float4 p : POSITION, float2 uv : TEXCOORD3, out float2 to : UV) : SV_Position {\n"
      "  to = uv; return p + shift; }\n"
      "float4 ps(float2 uv : UV) : SV_Target { return map.Sample(near, uv) * tint; }\n";
  ASSERT_EQ(Compile({"-E", "vs", "--pixel-entry=ps", "--pixel-output=.frag"}, kPair),
            CLIPC_COMPILED)
      << Get(CLIPC_PART_MESSAGES);
  EXPECT_EQ(clipc_result_diagnostic(result_.get(), 0), nullptr);
  const clipc_reflection* shader = clipc_result_reflection(result_.get());
  ASSERT_NE(shader, nullptr);
  EXPECT_EQ(clipc_result_reflection(result_.get()), shader);
  EXPECT_STREQ(shader->entry, "vs");
  ASSERT_EQ(shader->input_count, 2U);
  EXPECT_STREQ(shader->inputs[1]->semantic, "TEXCOORD");
  EXPECT_EQ(shader->inputs[1]->index, 3U);
  EXPECT_STREQ(shader->inputs[1]->type, "float2");
  EXPECT_EQ(shader->inputs[1]->location, 1);
  ASSERT_EQ(shader->buffer_count, 1U);
  EXPECT_STREQ(shader->buffers[0]->hlsl_register, "b1");
  EXPECT_EQ(shader->buffers[0]->binding, 1);
  ASSERT_EQ(shader->buffers[0]->member_count, 2U);
  EXPECT_EQ(shader->buffers[0]->members[1]->offset, 16U);
  EXPECT_STREQ(shader->buffers[0]->members[1]->glsl, "Frame.shift");
  ASSERT_NE(shader->pixel_shader, nullptr);
  ASSERT_EQ(shader->pixel_shader->resource_count, 1U);
  const clipc_resource* map = shader->pixel_shader->resources[0];
  EXPECT_STREQ(map->texture_register, "t2");
  EXPECT_STREQ(map->sampler, "near");
  EXPECT_EQ(map->binding, 2);
  EXPECT_EQ(Compile({"--target=450"}), CLIPC_BAD_REQUEST);
  EXPECT_EQ(clipc_result_reflection(result_.get()), nullptr);
}

TEST_F(CInterface, ReflectsTheGroupsOfAComputeShader) {
  constexpr std::string_view kShader =
      "RWBuffer<float> to; RWBuffer<float> log_; groupshared float3 memory[8];\n"
      "[numthreads(4, 2, 1)] void main(uint i : SV_GroupIndex) {\n"
      "  memory[i] = log_[i]; GroupMemoryBarrierWithGroupSync(); to[i] = memory[7 - i].x; }\n";
  ASSERT_EQ(Compile({"-T", "cs_5_0"}, kShader), CLIPC_COMPILED) << Get(CLIPC_PART_MESSAGES);
  const clipc_reflection* shader = clipc_result_reflection(result_.get());
  ASSERT_NE(shader, nullptr);
  EXPECT_THAT(shader->group_size, ::testing::ElementsAre(4U, 2U, 1U));
  EXPECT_EQ(shader->shared_bytes, 96U);
  ASSERT_EQ(shader->resource_count, 2U);
  EXPECT_STREQ(shader->resources[0]->access, "write");
  EXPECT_STREQ(shader->resources[1]->access, "read");
  ASSERT_EQ(Compile({"-Ilib"}), CLIPC_COMPILED);
  EXPECT_THAT(clipc_result_reflection(result_.get())->group_size, ::testing::Each(0U));
}

TEST_F(CInterface, GivesTheVariantsOfOneCompile) {
  ASSERT_EQ(Compile({"-Ilib", "--variants"}), CLIPC_COMPILED) << Get(CLIPC_PART_MESSAGES);
  const auto glsl_of = [&](std::size_t planes) -> std::string_view {
    return clipc_result_get(clipc_result_variant(result_.get(), planes), CLIPC_PART_GLSL).data;
  };
  EXPECT_THAT(glsl_of(0), Not(HasSubstr("gl_ClipDistance")));
  EXPECT_THAT(glsl_of(1), HasSubstr("gl_ClipDistance[0] ="));
  EXPECT_EQ(clipc_result_variant(result_.get(), 2), nullptr);
}

TEST_F(CInterface, GivesThePreprocessedTextAndStructs) {
  ASSERT_EQ(Compile({"-Ilib", "-P"}), CLIPC_COMPILED) << Get(CLIPC_PART_MESSAGES);
  EXPECT_THAT(Get(CLIPC_PART_PREPROCESSED), HasSubstr("float4 water;"));
  EXPECT_EQ(Get(CLIPC_PART_GLSL), "");
  ASSERT_EQ(Compile({"-Ilib", "--reflect=.h"}), CLIPC_COMPILED) << Get(CLIPC_PART_MESSAGES);
  EXPECT_THAT(Get(CLIPC_PART_STRUCTS), HasSubstr("struct Clip {"));
}

TEST_F(CInterface, HasAKeyForACache) {
  std::set<std::string> keys;
  const auto compile = [&](std::vector<const char*> options, const char* text) {
    clipc_request request{};
    request.size = sizeof request;
    request.path = path_;
    request.text = text;
    request.text_size = std::strlen(text);
    request.options = options.data();
    request.option_count = options.size();
    request.is_known_context = &keys;
    request.is_known = [](void* context, const char* key) {
      EXPECT_EQ(std::strlen(key), 32U);
      return static_cast<std::set<std::string>*>(context)->insert(key).second ? 0 : 1;
    };
    return Run(request);
  };
  const char* const text =
      "#ifdef FOG\n#define SHIFT 1\n#else\n#define SHIFT 0\n#endif\n"
      "float4 main(float4 p : POSITION) : SV_Position { return p + SHIFT; }\n";
  EXPECT_EQ(compile({"-D", "FOG"}, text), CLIPC_COMPILED);
  EXPECT_EQ(compile({}, text), CLIPC_COMPILED);
  EXPECT_EQ(compile({"-DNO_SUCH=2"}, text), CLIPC_KNOWN);  // the same text
  EXPECT_EQ(Get(CLIPC_PART_GLSL), "");
  EXPECT_EQ(compile({"-DFOG=3", "-I", "lib"}, text), CLIPC_KNOWN);
  EXPECT_EQ(compile({"--target=essl300"}, text), CLIPC_COMPILED);  // another option
  EXPECT_EQ(compile({"-Zi"}, text), CLIPC_COMPILED);  // is not asked: lines are a part of it
  EXPECT_EQ(keys.size(), 3U);
}

TEST(CInterfaceVersion, IsThatOfTheHeader) {
  EXPECT_EQ(clipc_abi(), std::uint32_t{CLIPC_ABI});
  EXPECT_EQ(std::string_view(clipc_version()), CLIPC_VERSION);
}

}  // namespace
