// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Draws each effect of this folder through effect-runtime/effect.h and compares pixels with what
// the comments at its head expect:
//   // DRAW Technique Pass     draws the quad with the pass, over what is drawn already
//   // PIXEL x y = r g b a     the color there now; y counts from the top
//   // SET Name = 1 2 3.5      sets a parameter to floats; SETI, to ints
//   // CLEAR                   clears color, depth and stencil
//   // WALK = T P Tint<float Max=1>    techniques with passes, parameters and textures
//   // PLANES Technique Pass = 0:Water    the planes that the pass clips with
//   // VULKAN Technique Pass = 3:1 4:0    its states for Vulkan, clipc_vk_state:value
// The quad covers the target: position, normal (0, 0, -1), color (1, 0.5, 0.25, 1), and texture
// coordinates from 0 at the upper left. Textures of two dimensions have the texels red, green,
// blue and white; faces of cube maps are red, cyan, green, magenta, blue and yellow.
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include "all.effect.h"
#include "effect-runtime/effect.h"
#include "tools/harness/offscreen.h"

namespace clipc {
namespace {

constexpr int kSize = 16;
constexpr float kQuad[] = {-1, 1,  0.5F, 1, 0, 0, -1, 1, 0.5F, 0.25F, 1, 0, 0,  //
                           1,  1,  0.5F, 1, 0, 0, -1, 1, 0.5F, 0.25F, 1, 1, 0,  //
                           -1, -1, 0.5F, 1, 0, 0, -1, 1, 0.5F, 0.25F, 1, 0, 1,  //
                           1,  -1, 0.5F, 1, 0, 0, -1, 1, 0.5F, 0.25F, 1, 1, 1};
// As a strip: upper left, upper right, lower left, lower right; clockwise.
constexpr unsigned char kTexels[] = {255, 0, 0,   255, 0,   255, 0,   255,
                                     0,   0, 255, 255, 255, 255, 255, 255};
constexpr unsigned char kFaces[6][4] = {{255, 0, 0, 255},   {0, 255, 255, 255}, {0, 255, 0, 255},
                                        {255, 0, 255, 255}, {0, 0, 255, 255},   {255, 255, 0, 255}};

class EffectDrawing {
 public:
  explicit EffectDrawing(const clipc_gl_effect_table& table) {
    glViewport(0, 0, kSize, kSize);
    GLuint buffers[2];
    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glGenRenderbuffers(2, buffers);
    glBindRenderbuffer(GL_RENDERBUFFER, buffers[0]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, kSize, kSize);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffers[0]);
    glBindRenderbuffer(GL_RENDERBUFFER, buffers[1]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, kSize, kSize);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                              buffers[1]);
    GLuint vertices = 0, array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glGenBuffers(1, &vertices);
    glBindBuffer(GL_ARRAY_BUFFER, vertices);
    glBufferData(GL_ARRAY_BUFFER, sizeof kQuad, kQuad, GL_STATIC_DRAW);
    char message[CLIPC_MESSAGE_SIZE] = "";
    EXPECT_EQ(clipc_gl_effect_create(harness::OpenGl::Load, &table, &effect_, message), CLIPC_OK)
        << message;
    for (std::uint32_t i = 0; effect_ && i < table.texture_count; ++i)
      MakeTexture(table.textures[i]);
    Clear();
  }
  ~EffectDrawing() { clipc_gl_effect_free(effect_); }
  EffectDrawing(const EffectDrawing&) = delete;
  EffectDrawing& operator=(const EffectDrawing&) = delete;

  bool ok() const { return effect_ != nullptr; }

  void Clear() {
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glStencilMask(~0U);
    glDisable(GL_SCISSOR_TEST);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  }

  std::uint32_t Find(const std::string& technique, const std::string& pass) {
    std::uint32_t number = 0;
    char message[CLIPC_MESSAGE_SIZE] = "";
    EXPECT_EQ(clipc_gl_effect_find(effect_, technique.c_str(),
                                   pass.empty() ? nullptr : pass.c_str(), &number, message),
              CLIPC_OK)
        << message;
    return number;
  }

  void Draw(const std::string& technique, const std::string& pass) {
    const std::uint32_t number = Find(technique, pass);
    char message[CLIPC_MESSAGE_SIZE] = "";
    EXPECT_EQ(clipc_gl_effect_apply(effect_, number, message), CLIPC_OK) << message;
    const GLuint program = clipc_gl_effect_program_of(effect_, number);
    Attribute(program, "in_POSITION0", 4, 0);
    Attribute(program, "in_SV_POSITION0", 4, 0);
    Attribute(program, "in_NORMAL0", 3, 4);
    Attribute(program, "in_COLOR0", 4, 7);
    Attribute(program, "in_TEXCOORD0", 2, 11);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    harness::CheckErrors(technique + "." + pass);
  }

  void Set(const std::string& name, const std::vector<std::uint32_t>& words) {
    char message[CLIPC_MESSAGE_SIZE] = "";
    EXPECT_EQ(clipc_gl_effect_set(effect_, name.c_str(), words.data(), words.size() * 4, message),
              CLIPC_OK)
        << message;
  }

  // The names of the passes, the parameters and the textures, each with its annotations.
  std::string Walk() const {
    std::string text;
    for (std::uint32_t i = 0; const auto* it = clipc_gl_effect_technique_of(effect_, i); ++i) {
      Say(*it, text);
      for (std::uint32_t k = it->first_pass; k < it->first_pass + it->pass_count; ++k)
        Say(*clipc_gl_effect_pass_of(effect_, k), text);
    }
    for (std::uint32_t i = 0; const auto* it = clipc_gl_effect_parameter_of(effect_, i); ++i)
      Say(*it, text);
    for (std::uint32_t i = 0; const auto* it = clipc_gl_effect_texture_of(effect_, i); ++i)
      Say(*it, text);
    return text;
  }

  std::string Planes(const std::string& technique, const std::string& pass) {
    const std::uint32_t number = Find(technique, pass);
    std::string text;
    for (std::uint32_t i = 0; i < clipc_gl_effect_plane_count(effect_, number); ++i) {
      const clipc_gl_effect_plane* plane = clipc_gl_effect_plane_of(effect_, number, i);
      text += (text.empty() ? "" : " ") + std::to_string(plane->index) + ":" + plane->text;
    }
    return text;
  }

  std::string Vulkan(const clipc_gl_effect_table& table, const std::string& technique,
                     const std::string& pass) {
    std::uint32_t count = 0;
    const clipc_vk_effect_state* states =
        clipc_vk_effect_states(&table, Find(technique, pass), &count);
    std::string text;
    for (std::uint32_t i = 0; i < count; ++i) {
      text += (text.empty() ? "" : " ") + std::to_string(states[i].state) + ":" +
              std::to_string(states[i].value);
    }
    return text;
  }

  static std::string Pixel(int x, int y) {
    unsigned char color[4] = {};
    glReadPixels(x, kSize - 1 - y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, color);
    std::ostringstream text;
    for (const unsigned char c : color) text << (text.tellp() == 0 ? "" : " ") << int{c};
    return text.str();
  }

 private:
  void Say(const auto& named, std::string& text) const {
    text += (text.empty() ? "" : " ") + std::string(named.name);
    for (std::uint32_t i = 0; i < named.annotation_count; ++i) {
      const auto* it = clipc_gl_effect_annotation_of(effect_, named.first_annotation + i);
      text += std::string("<") + it->type + ' ' + it->name + '=' + it->value + '>';
    }
  }

  static void Attribute(GLuint program, const char* name, int components, int first) {
    const GLint place = glGetAttribLocation(program, name);
    if (place < 0) return;
    glVertexAttribPointer(static_cast<GLuint>(place), components, GL_FLOAT, GL_FALSE, 13 * 4,
                          reinterpret_cast<const void*>(static_cast<std::uintptr_t>(first) * 4));
    glEnableVertexAttribArray(static_cast<GLuint>(place));
  }

  void MakeTexture(const clipc_gl_effect_texture& texture) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(texture.target, name);
    if (texture.target == GL_TEXTURE_CUBE_MAP) {
      for (GLuint face = 0; face < 6; ++face)
        glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA8, 1, 1, 0, GL_RGBA,
                     GL_UNSIGNED_BYTE, kFaces[face]);
    } else if (texture.target == GL_TEXTURE_2D_ARRAY || texture.target == GL_TEXTURE_3D) {
      glTexImage3D(texture.target, 0, GL_RGBA8, 2, 1, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, kTexels);
    } else if (std::string(texture.name).find("Shadow") != std::string::npos) {
      const float depth = 0.5F;
      glTexImage2D(texture.target, 0, GL_DEPTH_COMPONENT32F, 1, 1, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                   &depth);
    } else {
      glTexImage2D(texture.target, 0, GL_RGBA8, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, kTexels);
    }
    glTexParameteri(texture.target, GL_TEXTURE_MAX_LEVEL, 0);
    EXPECT_EQ(clipc_gl_effect_set_texture(effect_, texture.name, name, nullptr), CLIPC_OK);
  }

  clipc_gl_effect* effect_ = nullptr;
  GLuint framebuffer_ = 0;
};

std::vector<std::uint32_t> WordsIn(std::istream& from, bool are_ints) {
  std::vector<std::uint32_t> words;
  for (std::string text; from >> text;) {
    const float number = std::strtof(text.c_str(), nullptr);
    std::uint32_t word = 0;
    std::memcpy(&word, &number, sizeof word);
    words.push_back(are_ints ? static_cast<std::uint32_t>(std::atoi(text.c_str())) : word);
  }
  return words;
}

// Whether each number is at most one off.
bool IsNear(const std::string& color, const std::string& expected) {
  std::istringstream a(color), b(expected);
  for (int i = 0; i < 4; ++i) {
    int x = 0, y = 0;
    if (!(a >> x) || !(b >> y) || std::abs(x - y) > 1) return false;
  }
  return true;
}

class Effects : public ::testing::TestWithParam<std::size_t> {
 protected:
  const harness::OpenGl context_{harness::Api::kCore};
};

TEST_P(Effects, DrawsWhatItsCommentsSay) {
  const auto& [name, table] = kEffects[GetParam()];
  EffectDrawing drawing(*table);
  ASSERT_TRUE(drawing.ok());
  std::ifstream file(std::string(CLIPC_EFFECTS) + "/" + name + ".fx");
  int expectations = 0;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string slashes, what, first, second, equal;
    if (!(words >> slashes >> what) || slashes != "//") continue;
    if (what == "CLEAR") drawing.Clear();
    if (what == "DRAW") {
      words >> first >> second;
      drawing.Draw(first, second);
    } else if (what == "SET" || what == "SETI") {
      words >> first >> equal;
      drawing.Set(first, WordsIn(words, what == "SETI"));
    } else if (what == "PIXEL") {
      int x = 0, y = 0;
      words >> x >> y >> equal >> std::ws;
      std::string expected;
      std::getline(words, expected);
      const std::string color = EffectDrawing::Pixel(x, y);
      EXPECT_TRUE(IsNear(color, expected)) << name << ": " << line << "\nis " << color;
      ++expectations;
    } else if (what == "PLANES") {
      words >> first >> second >> equal >> std::ws;
      std::string expected;
      std::getline(words, expected);
      EXPECT_EQ(drawing.Planes(first, second), expected) << name;
      ++expectations;
    } else if (what == "VULKAN") {
      words >> first >> second >> equal >> std::ws;
      std::string expected;
      std::getline(words, expected);
      EXPECT_EQ(drawing.Vulkan(*table, first, second), expected) << name;
      ++expectations;
    } else if (what == "WALK") {
      words >> equal >> std::ws;
      std::string expected;
      std::getline(words, expected);
      EXPECT_EQ(drawing.Walk(), expected) << name;
      ++expectations;
    }
  }
  EXPECT_GT(expectations, 0);
}

TEST(EffectTable, HasStatesForVulkanWithoutAContext) {
  std::uint32_t count = 0;
  const clipc_vk_effect_state* states = clipc_vk_effect_states(&stencil_effect, 1, &count);
  ASSERT_EQ(count, 5U);
  EXPECT_EQ(states[0].state, CLIPC_VK_STENCIL_TEST_ENABLE);
  EXPECT_EQ(states[0].value, 1U);
  EXPECT_EQ(states[3].state, CLIPC_VK_FRONT_COMPARE_OP);
  EXPECT_EQ(states[3].value, 2U);  // VK_COMPARE_OP_EQUAL
  EXPECT_EQ(clipc_vk_effect_states(&stencil_effect, 2, &count), nullptr);
  EXPECT_EQ(count, 0U);
  EXPECT_EQ(clipc_vk_effect_states(nullptr, 0, nullptr), nullptr);
}

INSTANTIATE_TEST_SUITE_P(All, Effects, ::testing::Range<std::size_t>(0, std::size(kEffects)),
                         [](const auto& of) { return std::string(kEffects[of.param].name); });

}  // namespace
}  // namespace clipc
