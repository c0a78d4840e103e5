// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/values/draw.h"

#include <algorithm>
#include <bit>
#include <cctype>

#include "tools/harness/drawing.h"
#include "tools/harness/offscreen.h"

namespace clipc::values {
namespace {

// Beyond the words of the test, as vkd3d's runner fills them.
constexpr std::uint32_t kUnsetWord = 0x7f7f7f7f;

std::string Upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

// The vertex shader with Direct3D 9's pixels: half a pixel further to the right and down.
std::string MovedHalfPixel(std::string vertex) {
  constexpr std::string_view kMain = "void main()";
  const std::size_t at = vertex.find(kMain);
  if (at == vertex.npos) throw NotDrawn("no main");
  vertex.replace(at, kMain.size(), "uniform vec2 half_pixel;\nvoid main_of_shader()");
  return vertex +
         "void main() { main_of_shader(); gl_Position.xy += half_pixel * gl_Position.w; }\n";
}

GLuint Linked(const CompiledPair& pair, const DrawCall& call) {
  std::vector<harness::StageText> stages = {
      {GL_VERTEX_SHADER, call.is_direct3d9 ? MovedHalfPixel(pair.vertex) : pair.vertex},
      {GL_FRAGMENT_SHADER, pair.pixel}};
  for (const auto& [stage, text] : pair.between) {
    stages.push_back({stage == "geometry" ? GLenum{GL_GEOMETRY_SHADER}
                      : stage == "hull"   ? GLenum{GL_TESS_CONTROL_SHADER}
                                          : GLenum{GL_TESS_EVALUATION_SHADER},
                      text});
  }
  return harness::LinkStages(stages);
}

// One draw with everything that it binds, which is gone at the end.
class Binder : NotCopied {
 public:
  Binder(const CompiledPair& pair, const Scene& scene, const DrawCall& call)
      : pair_(pair),
        scene_(scene),
        call_(call),
        program_(!pair.compute.empty() ? harness::LinkComputeProgram(pair.compute)
                                       : Linked(pair, call)) {
    glGenVertexArrays(1, &vertex_array_);
    glGenFramebuffers(1, &framebuffer_);
  }
  ~Binder() {
    glUseProgram(0);
    glBindVertexArray(0);
    for (GLuint unit = 0; unit < samplers_.size(); ++unit) glBindSampler(unit, 0);
    glDeleteSamplers(static_cast<GLsizei>(samplers_.size()), samplers_.data());
    glDeleteBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
    glDeleteVertexArrays(1, &vertex_array_);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteProgram(program_);
  }

  void Do() {
    glUseProgram(program_);
    for (const ConstantBuffer& buffer : pair_.buffers) BindConstants(buffer);
    for (const Object& object : pair_.objects) BindObject(object);
    if (pair_.compute.empty()) return Draw();
    harness::CheckErrors("binding");
    glDispatchCompute(call_.groups[0], call_.groups[1], call_.groups[2]);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    harness::CheckErrors("dispatching");
  }

 private:
  void Draw() {
    glBindVertexArray(vertex_array_);
    BindVertices();
    BindTargets();
    SetState();
    if (call_.control_points > 0)
      glPatchParameteri(GL_PATCH_VERTICES, static_cast<GLint>(call_.control_points));
    harness::CheckErrors("binding");
    glDrawArraysInstanced(call_.topology, 0, static_cast<GLsizei>(call_.vertices),
                          static_cast<GLsizei>(call_.instances));
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_SAMPLE_MASK);
    glDisable(GL_PROGRAM_POINT_SIZE);
    harness::CheckErrors("drawing");
  }

  void BindVertices() {
    std::map<std::uint32_t, std::uint32_t> strides;
    for (const Element& element : scene_.elements)
      strides[element.slot] += 4 * element.format.count;
    std::map<std::uint32_t, std::uint32_t> offsets;
    for (const Element& element : scene_.elements) {
      const std::uint32_t offset = offsets[element.slot];
      offsets[element.slot] += 4 * element.format.count;
      const auto input = std::ranges::find_if(pair_.inputs, [&](const Input& each) {
        return each.semantic == Upper(element.semantic) ||
                       Upper(each.semantic) == Upper(element.semantic)
                   ? each.index == element.index
                   : false;
      });
      if (input == pair_.inputs.end()) continue;
      const Resource* vertices = scene_.Find(Role::kVertices, element.slot);
      if (!vertices) throw NotDrawn("no vertex buffer");
      glBindBuffer(GL_ARRAY_BUFFER, vertices->buffer());
      const void* first = reinterpret_cast<const void*>(std::uintptr_t{offset});
      const auto stride = static_cast<GLsizei>(strides[element.slot]);
      const auto count = static_cast<GLint>(element.format.count);
      if (input->is_integer) {
        glVertexAttribIPointer(input->location, count, element.format.type, stride, first);
      } else {
        glVertexAttribPointer(input->location, count, element.format.type, GL_FALSE, stride, first);
      }
      glEnableVertexAttribArray(input->location);
    }
  }

  std::uint32_t UniformWord(std::size_t index) const {
    return index < scene_.uniforms.size() ? scene_.uniforms[index] : kUnsetWord;
  }

  // The words of the buffer that the test calls uniforms, which are those of b0.
  std::vector<std::uint32_t> WordsOf(const ConstantBuffer& buffer) const {
    std::vector<std::uint32_t> words((buffer.size + 15) / 16 * 4);
    if (!call_.is_direct3d9) {
      for (std::size_t i = 0; buffer.number == 0 && i < words.size(); ++i)
        words[i] = UniformWord(i);
      return words;
    }
    for (const ConstantBuffer::Component& component : buffer.components) {
      const std::uint32_t bits = UniformWord(component.constant);
      const auto value = std::bit_cast<float>(bits);
      words.at(component.byte / 4) =
          component.kind == 'i'   ? static_cast<std::uint32_t>(static_cast<std::int32_t>(value))
          : component.kind == 'b' ? static_cast<std::uint32_t>(value != 0)
                                  : bits;
    }
    return words;
  }

  void BindConstants(const ConstantBuffer& buffer) {
    const GLuint index = glGetUniformBlockIndex(program_, buffer.block.c_str());
    if (index == GL_INVALID_INDEX) return;
    std::vector<std::uint32_t> words = WordsOf(buffer);
    GLint size = 0;
    glGetActiveUniformBlockiv(program_, index, GL_UNIFORM_BLOCK_DATA_SIZE, &size);
    words.resize(std::max<std::size_t>(words.size(), (size + 3) / 4));
    const auto number = static_cast<GLuint>(buffers_.size());
    buffers_.push_back(harness::NewBuffer(GL_UNIFORM_BUFFER, words.data(), 4 * words.size()));
    glUniformBlockBinding(program_, index, number);
    glBindBufferBase(GL_UNIFORM_BUFFER, number, buffers_.back());
  }

  void BindObject(const Object& object) {
    const Role role = object.is_storage ? Role::kStorage : Role::kTexture;
    for (std::uint32_t i = 0; i < object.count; ++i) {
      Resource* resource = scene_.Find(role, object.number + i);
      const bool is_block = object.type.find("StructuredBuffer") != object.type.npos ||
                            object.type.find("ByteAddressBuffer") != object.type.npos;
      if (is_block) {
        if (!resource) throw NotDrawn("no buffer for " + object.name);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, object.binding + i, resource->buffer());
      } else if (object.is_storage) {
        if (!resource || resource->texture() == 0) throw NotDrawn("no image for " + object.name);
        glBindImageTexture(object.binding + i, resource->texture(), 0, GL_TRUE, 0, GL_READ_WRITE,
                           resource->text().format.internal);
      } else {
        BindTexture(object, i, resource);
      }
    }
  }

  // The place of an element, which OpenGL may have left out. The inner arrays of an array of arrays
  // follow each other.
  GLint LocationOf(const Object& object, std::uint32_t element) const {
    const auto find = [&](const std::string& index) {
      return glGetUniformLocation(program_, (object.name + index).c_str());
    };
    if (object.count == 1) return find("");
    const GLint of_arrays = find("[0][0]");
    return of_arrays < 0 ? find("[" + std::to_string(element) + "]")
                         : of_arrays + static_cast<GLint>(element);
  }

  void BindTexture(const Object& object, std::uint32_t element, Resource* resource) {
    const GLint location = LocationOf(object, element);
    if (location < 0) return;  // no output depends on it
    const auto unit = static_cast<GLint>(samplers_.size());
    glActiveTexture(GL_TEXTURE0 + unit);
    glGenSamplers(1, &samplers_.emplace_back());
    glUniform1i(location, unit);
    if (!resource) return;  // black, as where Direct3D has no texture
    if (object.type.starts_with("Texture2DMS") && resource->text().samples == 1)
      throw NotDrawn("a multisampled texture of one sample");
    if (resource->texture() == 0) throw NotDrawn("a buffer without a format for " + object.name);
    if (object.type == "sampler1D" && resource->target() != GL_TEXTURE_1D)
      throw NotDrawn("a texture of two dimensions for tex1D");
    glBindTexture(resource->target(),
                  object.compares ? resource->DepthTexture() : resource->texture());
    SamplerText text;
    if (!object.samplers.empty()) {
      const auto found = scene_.samplers.find(
          object.samplers[0] + (object.samplers.size() > 1 || object.count == 1 ? 0 : element));
      if (found != scene_.samplers.end()) text = found->second;
    }
    const GLuint id = samplers_.back();
    const auto set = [&](GLenum name, GLenum value) {
      glSamplerParameteri(id, name, static_cast<GLint>(value));
    };
    set(GL_TEXTURE_MIN_FILTER, text.least);
    set(GL_TEXTURE_MAG_FILTER, text.greatest);
    set(GL_TEXTURE_WRAP_S, text.wraps[0]);
    set(GL_TEXTURE_WRAP_T, text.wraps[1]);
    set(GL_TEXTURE_WRAP_R, text.wraps[2]);
    if (object.compares) {
      set(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
      set(GL_TEXTURE_COMPARE_FUNC, text.comparison == GL_NONE ? GL_NEVER : text.comparison);
    }
    glBindSampler(static_cast<GLuint>(unit), id);
  }

  void BindTargets() {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    std::vector<GLenum> places;
    for (const auto& [key, resource] : scene_.resources) {
      const auto [role, slot] = key;
      if (role != Role::kTarget && role != Role::kDepth) continue;
      const GLenum place = role == Role::kDepth ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0 + slot;
      glFramebufferTexture(GL_FRAMEBUFFER, place, resource->texture(), 0);
      width_ = std::min(width_, resource->text().width);
      height_ = std::min(height_, resource->text().height);
      has_depth_ = has_depth_ || role == Role::kDepth;
      if (role == Role::kDepth) continue;
      places.resize(std::max<std::size_t>(places.size(), slot + 1), GL_NONE);
      places[slot] = place;
    }
    glDrawBuffers(static_cast<GLsizei>(places.size()), places.data());
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
      throw NotDrawn("OpenGL has no such framebuffer");
  }

  void SetState() const {
    const auto width = static_cast<float>(width_), height = static_cast<float>(height_);
    const bool flips = scene_.IsMultisampled();
    std::map<std::uint32_t, std::array<float, 4>> views = scene_.viewports;
    views.try_emplace(0, std::array<float, 4>{0, 0, width, height});
    for (const auto& [index, view] : views)  // Direct3D counts y from the top
      glViewportIndexedf(index, view[0], flips ? view[1] : height - view[1] - view[3], view[2],
                         view[3]);
    if (call_.is_direct3d9) {
      const std::array<float, 4>& view = views.at(0);
      glUniform2f(glGetUniformLocation(program_, "half_pixel"), 2 * call_.half_pixel / view[2],
                  -2 * call_.half_pixel / view[3]);
    }
    if (pair_.vertex.find("gl_PointSize") != pair_.vertex.npos) glEnable(GL_PROGRAM_POINT_SIZE);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glFrontFace(flips ? GL_CCW : GL_CW);
    glProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
    if (has_depth_) {
      glEnable(GL_DEPTH_TEST);
      glDepthMask(GL_TRUE);
      glDepthFunc(scene_.depth_test);
    }
    if (flips) {
      glEnable(GL_SAMPLE_MASK);
      glSampleMaski(0, scene_.sample_mask);
    }
  }

  const CompiledPair& pair_;
  const Scene& scene_;
  const DrawCall call_;
  GLuint program_ = 0, vertex_array_ = 0, framebuffer_ = 0;
  std::vector<GLuint> buffers_;
  std::vector<GLuint> samplers_;  // by unit
  std::uint32_t width_ = ~0u, height_ = ~0u;
  bool has_depth_ = false;
};

}  // namespace

bool Scene::IsMultisampled() const {
  return std::ranges::any_of(resources, [](const auto& entry) {
    const ResourceText& text = entry.second->text();
    return (text.role == Role::kTarget || text.role == Role::kDepth) && text.samples > 1;
  });
}

void Draw(const CompiledPair& pair, const Scene& scene, const DrawCall& call) {
  Binder(pair, scene, call).Do();
}

}  // namespace clipc::values
