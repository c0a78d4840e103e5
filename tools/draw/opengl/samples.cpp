// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/opengl/samples.h"

#include <array>
#include <string>

#include "tools/harness/drawing.h"

namespace clipc::draw {
namespace {

constexpr char kCoverAll[] = R"(
void main() {
  gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}
)";

// Reads a texture in which the samples lie one above the other.
constexpr char kCopySample[] = R"(
precision highp float;
precision highp int;
uniform highp PREFIXsampler2D samples;
uniform int first_row;
out highp PREFIXvec4 color;
void main() {
  color = texelFetch(samples, ivec2(gl_FragCoord.xy) + ivec2(0, first_row), 0);
}
)";

GLuint LinkCopy(WordKind kind) {
  const std::string version = epoxy_is_desktop_gl() ? "#version 150\n" : "#version 310 es\n";
  std::string fragment = kCopySample;
  const char* const prefix = kind == WordKind::kInt ? "i" : kind == WordKind::kUint ? "u" : "";
  for (std::size_t at = fragment.find("PREFIX"); at != fragment.npos; at = fragment.find("PREFIX"))
    fragment.replace(at, 6, prefix);
  return harness::LinkProgram(version + kCoverAll, version + fragment, {});
}

GLint IntegerOf(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

}  // namespace

void UploadSamples(GLenum target, GLenum internal, GLenum components, GLenum type, WordKind kind,
                   const Inputs::Texture::Level& level) {
  const auto width = static_cast<GLsizei>(level.size[0]),
             height = static_cast<GLsizei>(level.size[1]), samples = static_cast<GLsizei>(kSamples),
             layers = static_cast<GLsizei>(level.size[2]) / samples;
  const bool is_array = target == GL_TEXTURE_2D_MULTISAMPLE_ARRAY,
             is_desktop = epoxy_is_desktop_gl();
  if (is_array)
    (is_desktop ? glTexImage3DMultisample : glTexStorage3DMultisample)(
        target, samples, internal, width, height, layers, GL_TRUE);
  else
    (is_desktop ? glTexImage2DMultisample : glTexStorage2DMultisample)(target, samples, internal,
                                                                       width, height, GL_TRUE);
  const auto texture = static_cast<GLuint>(IntegerOf(
      is_array ? GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY : GL_TEXTURE_BINDING_2D_MULTISAMPLE));
  const auto framebuffer = static_cast<GLuint>(IntegerOf(GL_DRAW_FRAMEBUFFER_BINDING));
  const auto program = static_cast<GLuint>(IntegerOf(GL_CURRENT_PROGRAM));
  const auto arrays = static_cast<GLuint>(IntegerOf(GL_VERTEX_ARRAY_BINDING));
  std::array<GLint, 4> viewport{};
  glGetIntegerv(GL_VIEWPORT, viewport.data());

  GLuint plain = 0, drawn = 0, none = 0;
  glGenTextures(1, &plain);
  glBindTexture(GL_TEXTURE_2D, plain);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internal), width, samples * layers * height, 0,
               components, type, level.words.data());
  glGenFramebuffers(1, &drawn);
  glBindFramebuffer(GL_FRAMEBUFFER, drawn);
  glGenVertexArrays(1, &none);
  glBindVertexArray(none);
  glViewport(0, 0, width, height);
  const GLuint copy = LinkCopy(kind);
  glUseProgram(copy);
  glUniform1i(glGetUniformLocation(copy, "samples"), IntegerOf(GL_ACTIVE_TEXTURE) - GL_TEXTURE0);
  glEnable(GL_SAMPLE_MASK);
  for (GLsizei image = 0; image < samples * layers; ++image) {
    if (is_array)
      glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, texture, 0, image % layers);
    else
      glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, target, texture, 0);
    glUniform1i(glGetUniformLocation(copy, "first_row"), image * height);
    glSampleMaski(0, 1u << image / layers);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
  glSampleMaski(0, ~0u);
  glDisable(GL_SAMPLE_MASK);

  glUseProgram(program);
  glBindVertexArray(arrays);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  glDeleteProgram(copy);
  glDeleteVertexArrays(1, &none);
  glDeleteFramebuffers(1, &drawn);
  glDeleteTextures(1, &plain);
  harness::CheckErrors("writing the samples of a texture");
}

}  // namespace clipc::draw
