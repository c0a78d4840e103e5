// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <bit>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/draw/opengl/image.h"
#include "tools/draw/opengl/program.h"

// Tests of the tool itself, on GLSL that nobody generated: right shaders pass, and each kind of
// mistake is seen.
namespace clipc::draw {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// Makes the context that compiles the shader current. One OpenGL serves the whole run, since making
// contexts takes the time.
void UseContextFor(const std::string& shader) {
  static harness::OpenGl opengl;
  opengl.Use(VersionOf(shader).api);
}

Words WordsOf(std::initializer_list<float> values) {
  Words words;
  for (const float value : values) words.push_back(std::bit_cast<std::uint32_t>(value));
  return words;
}

std::vector<float> Floats(const Captured& captured) {
  std::vector<float> values;
  for (const std::uint32_t word : captured.words) values.push_back(std::bit_cast<float>(word));
  return values;
}

Bytes BytesOf(std::initializer_list<float> values) {
  Bytes bytes;
  for (const std::uint32_t word : WordsOf(values)) {
    for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<std::uint8_t>(word >> 8 * i));
  }
  return bytes;
}

// ---- capture

std::string CaptureShader(const std::string& head, const std::string& out) {
  return head +
         "in vec4 p; in uvec2 n;\nuniform vec4 scale[2];\nuniform Planes { vec4 plane; };\n" + out +
         "out float gl_ClipDistance[1];\nflat out uvec2 a; out vec2 b;\n"
         "void main() { gl_Position = p * scale[1]; gl_ClipDistance[0] = dot(p, plane); a = n + "
         "1u; b = p.zw; }\n";
}

Inputs TwoVertices() {
  Inputs inputs;
  inputs.vertices = 2;
  inputs.attributes = {{"p", WordsOf({1, 2, 3, 4, 5, 6, 7, 8})}, {"n", {1, 2, 0xffffffff, 4}}};
  inputs.uniforms = {{"scale", WordsOf({0, 0, 0, 0, 2, 2, 2, 0.5})}};
  inputs.blocks = {{"Planes", BytesOf({0, 0, 1, -1})}};
  return inputs;
}

void ExpectCaptured(const std::string& shader) {
  UseContextFor(shader);
  const std::string names[] = {"b", "gl_ClipDistance", "a", "gl_Position"};
  const auto captured = Capture(shader, names, TwoVertices());
  ASSERT_EQ(captured.size(), 4u);
  EXPECT_THAT(Floats(captured[0]), ElementsAre(3, 4, 7, 8));
  EXPECT_THAT(Floats(captured[1]), ElementsAre(-1, -1));
  EXPECT_THAT(captured[2].words, ElementsAre(2, 3, 0, 5));
  EXPECT_THAT(Floats(captured[3]), ElementsAre(2, 4, 6, 2, 10, 12, 14, 4));
}

TEST(Capture, EveryApi) {
  ExpectCaptured(CaptureShader("#version 450\n", ""));
  ExpectCaptured(CaptureShader("#version 150\n", ""));
  ExpectCaptured(
      CaptureShader("#version 140\n#extension GL_ARB_uniform_buffer_object : enable\n", ""));
  ExpectCaptured(
      CaptureShader("#version 130\n#extension GL_ARB_uniform_buffer_object : enable\n", ""));
  for (const char* version : {"300", "310", "320"}) {
    ExpectCaptured(CaptureShader(std::string("#version ") + version + " es\n", "")
                       .insert(16, "#extension GL_EXT_clip_cull_distance : require\n"));
  }
}

TEST(Capture, ClipVertexOfTheOldestVersion) {
  const std::string shader =
      "#version 120\nattribute vec4 p;\nvoid main() { gl_ClipVertex = p; gl_Position = -p; }\n";
  const std::string names[] = {"gl_ClipVertex", "gl_Position"};
  UseContextFor(shader);
  const auto captured = Capture(shader, names, TwoVertices());
  EXPECT_THAT(Floats(captured[0]), ElementsAre(1, 2, 3, 4, 5, 6, 7, 8));
  EXPECT_THAT(Floats(captured[1]), ElementsAre(-1, -2, -3, -4, -5, -6, -7, -8));
}

TEST(Capture, MoreOutputsThanOneRunTakes) {
  std::string shader = "#version 450\nin vec4 p;\n", body;
  std::vector<std::string> names = {"gl_Position"};
  for (int i = 0; i < 28; ++i) {
    names.push_back("v" + std::to_string(i));
    shader += "out vec4 " + names.back() + ";\n";
    body += names.back() + " = p + " + std::to_string(i) + ".0; ";
  }
  shader += "void main() { gl_Position = p; " + body + "}\n";
  UseContextFor(shader);
  const auto captured = Capture(shader, names, TwoVertices());
  ASSERT_EQ(captured.size(), 29u);
  for (int i = 0; i < 28; ++i) EXPECT_EQ(Floats(captured[i + 1])[7], 8.0f + static_cast<float>(i));
}

TEST(Capture, Instances) {
  Inputs inputs = TwoVertices();
  inputs.instances = 3;
  const std::string shader =
      "#version 450\nin vec4 p; flat out ivec2 v;\nvoid main() { gl_Position = p; v = "
      "ivec2(gl_VertexID, gl_InstanceID); }\n";
  const std::string names[] = {"v"};
  UseContextFor(shader);
  EXPECT_THAT(Capture(shader, names, inputs)[0].words,
              ElementsAre(0, 0, 1, 0, 0, 1, 1, 1, 0, 2, 1, 2));
}

std::string ErrorOf(const std::string& shader, const Inputs& inputs) {
  const std::string names[] = {"gl_Position"};
  UseContextFor(shader);
  try {
    Capture(shader, names, inputs);
  } catch (const DrawError& error) {
    return error.what();
  }
  return "";
}

TEST(Capture, SaysWhatIsMissingOrWrong) {
  const std::string shader = CaptureShader("#version 450\n", "");
  Inputs inputs = TwoVertices();
  inputs.attributes.erase(inputs.attributes.begin());
  EXPECT_THAT(ErrorOf(shader, inputs), HasSubstr("attribute `p`, which has no value"));
  inputs = TwoVertices();
  inputs.attributes[0].words.pop_back();
  EXPECT_THAT(ErrorOf(shader, inputs), HasSubstr("`p` has 4 components; 7 words for 2 vertices"));
  inputs = TwoVertices();
  inputs.blocks.clear();
  inputs.uniforms.clear();
  EXPECT_THAT(ErrorOf(shader, inputs), HasSubstr("which has no value"));
  EXPECT_THAT(ErrorOf("#version 450\nvoid main() { x; }\n", inputs),
              HasSubstr("OpenGL refuses the vertex shader"));
}

// ---- images

// A shader as a clip-distance lowering would write it; `fix_up` and `distances` may have a mistake.
std::string ImageShader(const std::string& version, const std::string& fix_up,
                        const std::string& distances) {
  return version +
         "in vec4 p;\nuniform vec4 plane[2];\nout float gl_ClipDistance[2];\n"
         "void main() { gl_Position = p; " +
         distances + fix_up + "}\n";
}

const std::string kRight =
    "gl_ClipDistance[0] = dot(gl_Position, plane[0]); gl_ClipDistance[1] = dot(gl_Position, "
    "plane[1]); ";
const std::string kFlip = "gl_Position.y = -gl_Position.y; ";
const std::string kDepth = "gl_Position.z = 2.0 * gl_Position.z - gl_Position.w; ";

// Two planes: one that depends on depth, one that depends on height.
const std::array<double, 4> kPlanes[] = {{1, 0.25, -0.5, 0.35}, {0.125, -1, 0, 0.5}};

bool IsRight(const std::string& shader, ImageOptions options, bool flipped) {
  Inputs inputs;
  inputs.vertices = static_cast<int>(FullTarget().size());
  inputs.attributes = {{"p", {}}};
  for (const auto& vertex : FullTarget()) {
    for (const float value : vertex)
      inputs.attributes[0].words.push_back(std::bit_cast<std::uint32_t>(value));
  }
  inputs.uniforms = {{"plane", {}}};
  for (const auto& plane : kPlanes) {
    for (const double value : plane)
      inputs.uniforms[0].words.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(value)));
  }
  if (options.enable_mask == 0) options.enable_mask = 3;
  UseContextFor(shader);
  const DrawnImage image = Draw(shader, inputs, options);
  const Difference difference = Compare(image, {{kPlanes[0], kPlanes[1]}, flipped});
  EXPECT_GT(difference.drawn, 500);
  return difference.missing == 0 && difference.extra == 0 && difference.depth_error < 1e-5;
}

TEST(Image, RightOnesPass) {
  const ImageOptions zero_to_one{.zero_to_one = true};
  const std::string versions[] = {
      "#version 450\n", "#version 150\n", "#version 130\n",
      "#version 300 es\n#extension GL_EXT_clip_cull_distance : require\n"};
  for (const std::string& version : versions) {
    EXPECT_TRUE(IsRight(ImageShader(version, kDepth, kRight), {}, false)) << version;
    EXPECT_TRUE(IsRight(ImageShader(version, kFlip + kDepth, kRight), {}, true)) << version;
    if (VersionOf(version).es) continue;
    EXPECT_TRUE(IsRight(ImageShader(version, "", kRight), zero_to_one, false)) << version;
    EXPECT_TRUE(IsRight(ImageShader(version, kFlip, kRight), zero_to_one, true)) << version;
  }
}

TEST(Image, MistakesAreSeen) {
  const ImageOptions zero_to_one{.zero_to_one = true};
  const auto wrong = [&](const std::string& distances) {
    return !IsRight(ImageShader("#version 450\n", "", distances), zero_to_one, false);
  };
  const std::string first = "gl_ClipDistance[0] = dot(gl_Position, plane[0]); ";
  const std::string second = "gl_ClipDistance[1] = dot(gl_Position, plane[1]); ";
  EXPECT_TRUE(wrong("gl_ClipDistance[0] = -dot(gl_Position, plane[0]); " + second)) << "sign";
  EXPECT_TRUE(wrong(first + "gl_ClipDistance[1] = dot(gl_Position, plane[0]); ")) << "plane";
  EXPECT_TRUE(wrong("gl_ClipDistance[0] = 1.0; " + second)) << "no distance";
  EXPECT_TRUE(wrong("gl_ClipDistance[0] = dot(gl_Position.xyz, plane[0].xyz); " + second))
      << "no w";
  EXPECT_TRUE(
      wrong("gl_ClipDistance[0] = dot(gl_Position.xyz / gl_Position.w, plane[0].xyz); " + second))
      << "w";
  EXPECT_TRUE(
      wrong(first + "gl_ClipDistance[1] = dot(gl_Position * vec4(1, -1, 1, 1), plane[1]); "))
      << "space";
}

TEST(Image, PlanesInTheWrongSpaceAreSeen) {
  const auto shader = [](const std::string& before, const std::string& after) {
    return ImageShader("#version 450\n", after, before + kRight);
  };
  EXPECT_TRUE(IsRight(shader("", kDepth), {}, false));
  EXPECT_FALSE(IsRight(shader(kDepth, ""), {}, false)) << "distances after the depth range";
  EXPECT_FALSE(IsRight(shader(kFlip, ""), {.zero_to_one = true}, true))
      << "distances after the flip";
  EXPECT_FALSE(IsRight(shader("", kDepth), {.zero_to_one = true}, false))
      << "another depth range than the target's";
  EXPECT_FALSE(IsRight(shader("", ""), {}, false)) << "no depth fix-up";
  EXPECT_FALSE(IsRight(shader("", kFlip), {.zero_to_one = true}, false)) << "upside down";
}

TEST(Image, OnlyEnabledPlanesClip) {
  ImageOptions options{.enable_mask = 1, .zero_to_one = true};
  EXPECT_FALSE(IsRight(ImageShader("#version 450\n", "", kRight), options, false));
}

TEST(Image, ClipVertex) {
  const std::string shader =
      "#version 120\nattribute vec4 p;\nvoid main() { gl_Position = p; gl_ClipVertex = p; " +
      kFlip + kDepth + "}\n";
  const ImageOptions options{.clip_planes = {{0, kPlanes[0]}, {1, kPlanes[1]}}};
  EXPECT_TRUE(IsRight(shader, options, true));
  const ImageOptions swapped{.clip_planes = {{0, kPlanes[0]}, {1, kPlanes[0]}}};
  EXPECT_FALSE(IsRight(shader, swapped, true));
  const std::string fixed_up = "#version 120\nattribute vec4 p;\nvoid main() { gl_Position = p; " +
                               kFlip + kDepth + "gl_ClipVertex = gl_Position; }\n";
  EXPECT_FALSE(IsRight(fixed_up, options, true));
}

}  // namespace
}  // namespace clipc::draw
