// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/compile.h"

#include <sstream>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "compiler/command/options.h"

namespace clipc {
namespace {

ProgramRequest TwoPlanes(int variant = 0) {
  ProgramRequest request;
  request.first().path = "two.hlsl";
  request.first().text =
      "cbuffer Planes { float4 left, right; };\n"
      "[clipplanes(left, right)]\n"
      "float4 main(float4 p : POSITION) : SV_Position { return p + " +
      std::to_string(variant) + "; }\n";
  return request;
}

TEST(Compile, GivesGlslAndTable) {
  ProgramRequest request = TwoPlanes();
  request.outputs.validate = true;
  request.outputs.facts = true;
  const CompileResult result = Compile(request);
  ASSERT_TRUE(result.ok()) << result.text;
  const Outputs& outputs = *result.outputs;
  ASSERT_EQ(outputs.shaders.size(), 1u);
  EXPECT_NE(outputs.shaders[0].text.find("gl_ClipDistance[1]"), std::string::npos)
      << outputs.shaders[0].text;
  ASSERT_TRUE(outputs.table.has_value());
  EXPECT_EQ(outputs.table->enable_mask, 3u);
  ASSERT_EQ(outputs.table->planes.size(), 2u);
  EXPECT_EQ(outputs.table->planes[1].text, "right");
  EXPECT_EQ(outputs.table->planes[1].constant->byte_offset, 16u);
  ASSERT_TRUE(outputs.facts && outputs.facts->planes);
  EXPECT_EQ(outputs.facts->planes->enable_mask, 3u);
}

constexpr const char* kTwoShaders =
    "cbuffer Frame : register(b3) { float4 tint; };\n"
    "struct Varyings { float4 position : SV_Position; float2 uv : UV; float unread : UNREAD; };\n"
    "Varyings vs(float4 p : POSITION) { Varyings o; o.position = p * tint; o.uv = p.xy; "
    "o.unread = p.z; return o; }\n"
    "float4 ps(Varyings i) : SV_Target { return i.uv.xyxy * tint; }\n";

TEST(Compile, AProgramIsAListOfShaders) {
  ProgramRequest request;
  request.shaders = {{.path = "two.hlsl", .text = kTwoShaders, .entry = "vs"},
                     {.entry = "ps", .profile = "ps_5_0"}};
  request.outputs.facts = true;
  const CompileResult result = Compile(request);
  ASSERT_TRUE(result.ok()) << result.text;
  const Outputs& outputs = *result.outputs;
  ASSERT_EQ(outputs.shaders.size(), 2u);
  const std::string& vertex = outputs.shaders[0].text;
  const std::string& pixel = outputs.shaders[1].text;
  EXPECT_NE(vertex.find("out vec2 vs_UV0;"), std::string::npos) << vertex;
  EXPECT_EQ(vertex.find("UNREAD"), std::string::npos) << vertex;
  EXPECT_NE(pixel.find("in vec2 vs_UV0;"), std::string::npos) << pixel;
  ASSERT_EQ(outputs.facts->stages.size(), 2u);
  EXPECT_EQ(outputs.facts->stages[0].buffers[0].block->name,
            outputs.facts->stages[1].buffers[0].block->name);
  EXPECT_TRUE(outputs.facts->stages[1].buffers[0].block->is_shared);
}

TEST(Compile, ErrorsOfEachShaderAreReported) {
  ProgramRequest request;
  request.shaders = {{.path = "two.hlsl",
                      .text = "float4 vs() : SV_Position { return missing; }\n"
                              "float4 ps() : SV_Target { return absent; }\n",
                      .entry = "vs"},
                     {.entry = "ps", .profile = "ps_5_0"}};
  const CompileResult result = Compile(request);
  EXPECT_EQ(result.status, Status::kErrors);
  EXPECT_FALSE(result.outputs.has_value());
  ASSERT_EQ(result.messages.size(), 2u) << result.text;
  EXPECT_EQ(result.messages[0].place.line, 1u);
  EXPECT_EQ(result.messages[1].place.line, 2u);
}

TEST(Compile, ANeighbourHasItsOwnNames) {
  ProgramRequest request;
  request.shaders = {{.path = "two.hlsl", .text = kTwoShaders, .entry = "vs"}};
  request.neighbour = {.path = "given.frag",
                       .text =
                           "#version 450\nlayout(location = 0) in vec2 place;\n"
                           "out vec4 color;\nvoid main() { color = place.xyxy; }\n"};
  const CompileResult result = Compile(request);
  ASSERT_TRUE(result.ok()) << result.text;
  ASSERT_EQ(result.outputs->shaders.size(), 1u);
  const std::string& vertex = result.outputs->shaders[0].text;
  EXPECT_NE(vertex.find("layout(location = 0) out vec2 place;"), std::string::npos) << vertex;
}

TEST(Compile, ErrorsLeaveNoOutput) {
  ProgramRequest request = TwoPlanes();
  *request.first().text += "float broken(";
  const CompileResult result = Compile(request);
  EXPECT_EQ(result.status, Status::kErrors);
  EXPECT_FALSE(result.outputs.has_value());
  ASSERT_FALSE(result.messages.empty());
  EXPECT_EQ(result.messages[0].place.file, "two.hlsl");
  EXPECT_NE(result.text.find("two.hlsl:4:"), std::string::npos) << result.text;
}

TEST(Compile, BadRequests) {
  for (const auto& change : std::vector<void (*)(ProgramRequest&)>{
           [](ProgramRequest& r) { r.first().profile = "vs_9_9"; },
           [](ProgramRequest& r) { r.debug.stop_after = "nothing"; },
           [](ProgramRequest& r) {
             r.first().text.reset(), r.first().path = "/no/such/file.hlsl";
           }}) {
    ProgramRequest request = TwoPlanes();
    change(request);
    const CompileResult result = Compile(request);
    EXPECT_EQ(result.status, Status::kBadRequest);
    ASSERT_EQ(result.messages.size(), 1u);
    EXPECT_TRUE(result.messages[0].place.file.empty());
  }
  ProgramRequest pixel = TwoPlanes();
  pixel.first().text = "float4 main() : SV_Position { return 0; }";
  pixel.first().profile = "ps_5_0";
  EXPECT_EQ(Compile(pixel).status, Status::kErrors);
}

TEST(Compile, OneCompilerManyShaders) {
  Compiler compiler;
  for (int i = 0; i < 20; ++i) {
    const CompileResult alone = Compile(TwoPlanes(i));
    const CompileResult together = compiler.Compile(TwoPlanes(i));
    ASSERT_TRUE(together.ok()) << together.text;
    EXPECT_EQ(alone.outputs->shaders, together.outputs->shaders);
  }
}

TEST(Compile, ThreadsDoNotMeet) {
  const CompileResult expected = Compile(TwoPlanes(7));
  std::vector<std::thread> threads;
  std::vector<std::string> results(4);
  for (std::string& result : results) {
    threads.emplace_back([&result] {
      Compiler compiler;
      for (int i = 0; i < 10; ++i) {
        ProgramRequest request = TwoPlanes(7);
        request.outputs.validate = i == 9;
        result = compiler.Compile(request).outputs->shaders[0].text;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::string& result : results) EXPECT_EQ(result, expected.outputs->shaders[0].text);
}

TEST(ParseCommandLine, SlashIsAnOptionOnlyWhereItIsNoPath) {
  const char* const arguments[] = {"/T",           "vs_4_0",         "/Emain", "/DX=1",
                                   "/usr/include", "/tmp/none.hlsl", "-o",     "/Tx"};
  const ParsedCommandLine parsed = ParseCommandLine(arguments);
  ASSERT_TRUE(parsed.result);
  EXPECT_EQ(parsed.command.request.first().profile, "vs_4_0");
  EXPECT_EQ(parsed.command.request.first().entry, "main");
  EXPECT_EQ(parsed.command.request.defines, std::vector<std::string>{"X=1"});
  EXPECT_EQ(parsed.command.inputs, (std::vector<std::string>{"/usr/include", "/tmp/none.hlsl"}));
  EXPECT_EQ(parsed.command.output, "/Tx");
}

TEST(ParseCommandLine, EveryOptionOfTheHelpIsOne) {
  std::istringstream help(HelpText());
  int options = 0;
  for (std::string line; std::getline(help, line);) {
    if (!line.starts_with("  -")) continue;
    const std::string name = line.substr(2, line.find_first_of(" =<", 2) - 2);
    const char* const arguments[] = {name.c_str(), "x"};
    const Result<> result = ParseCommandLine(arguments).result;
    EXPECT_TRUE(result || result.problem().find("unknown option") == std::string::npos) << name;
    ++options;
  }
  EXPECT_GT(options, 30);
}

TEST(ParseCommandLine, ValidatesWhereItIsAsked) {
  const char* const one[] = {"a.hlsl"};
  const char* const two[] = {"a.hlsl", "b.hlsl"};
  const char* const asked[] = {"a.hlsl", "b.hlsl", "--validate"};
  const char* const off[] = {"a.hlsl", "--validate", "--no-validate"};
  EXPECT_FALSE(ParseCommandLine(one).command.request.outputs.validate);
  EXPECT_FALSE(ParseCommandLine(two).command.request.outputs.validate);
  EXPECT_TRUE(ParseCommandLine(asked).command.request.outputs.validate);
  EXPECT_FALSE(ParseCommandLine(off).command.request.outputs.validate);
}

}  // namespace
}  // namespace clipc
