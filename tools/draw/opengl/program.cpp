// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/opengl/program.h"

#include <algorithm>
#include <array>

#include "tools/draw/opengl/upload.h"
#include "tools/harness/drawing.h"

namespace clipc::draw {
namespace {

// Returns the value called `name`; "planes" may stand for "planes[0]", the name that OpenGL gives
// arrays. Throws DrawError where there is none.
template <typename Value>
const Value& Find(const std::vector<Value>& values, const std::string& name, const char* what) {
  const std::string plain = name.substr(0, name.size() - (name.ends_with("[0]") ? 3 : 0));
  for (const Value& value : values) {
    if (value.name == name || value.name == plain) return value;
  }
  throw DrawError(std::string("the shader reads the ") + what + " `" + name +
                  "`, which has no value");
}

// The variables that have a location: gl_VertexID and the members of blocks do not have one.
std::vector<Active> List(GLuint program, GLenum count_of, decltype(glGetActiveUniform) describe,
                         decltype(glGetUniformLocation) locate) {
  GLint count = 0;
  glGetProgramiv(program, count_of, &count);
  std::vector<Active> all;
  for (GLint i = 0; i < count; ++i) {
    char name[512] = "";
    Active active;
    describe(program, i, sizeof name, nullptr, &active.count, &active.type, name);
    active.name = name;
    active.location = locate(program, name);
    if (active.location >= 0) all.push_back(active);
  }
  return all;
}

void SetUniform(const Active& active, const WordLayout& layout, const std::uint32_t* words) {
  const int at = active.location, n = active.count;
  const auto* f = reinterpret_cast<const GLfloat*>(words);
  const auto* i = reinterpret_cast<const GLint*>(words);
  const int size = layout.rows - 1;
  if (layout.columns > 1) {
    const std::array set{glUniformMatrix2fv,   glUniformMatrix2x3fv, glUniformMatrix2x4fv,
                         glUniformMatrix3x2fv, glUniformMatrix3fv,   glUniformMatrix3x4fv,
                         glUniformMatrix4x2fv, glUniformMatrix4x3fv, glUniformMatrix4fv};
    return set[3 * (layout.columns - 2) + size - 1](at, n, GL_FALSE, f);
  }
  switch (layout.kind) {
    case WordKind::kFloat:
      return std::array{glUniform1fv, glUniform2fv, glUniform3fv, glUniform4fv}[size](at, n, f);
    case WordKind::kInt:
      return std::array{glUniform1iv, glUniform2iv, glUniform3iv, glUniform4iv}[size](at, n, i);
    case WordKind::kUint:
      return std::array{glUniform1uiv, glUniform2uiv, glUniform3uiv, glUniform4uiv}[size](at, n,
                                                                                          words);
  }
}

}  // namespace

std::string Version::Line() const {
  return "#version " + std::to_string(number) + (es && number >= 300 ? " es\n" : "\n");
}

std::string Version::Head() const {
  if (!es || number >= 320) return Line();
  return Line() +
         "#extension GL_EXT_shader_io_blocks : enable\n"
         "#extension GL_EXT_tessellation_shader : enable\n";
}

Version VersionOf(const std::string& glsl) {
  Version version;
  const std::size_t at = glsl.find("#version");
  if (at == glsl.npos) return version;
  const std::string line = glsl.substr(at, glsl.find('\n', at) - at);
  std::sscanf(line.c_str(), "#version %d", &version.number);
  version.es = version.number == 100 || line.find(" es") != line.npos;
  const bool is_old = version.number < 140 || line.find("compatibility") != line.npos;
  using enum harness::Api;
  version.api = version.es ? kEs : is_old ? kCompatibility : kCore;
  return version;
}

std::optional<WordLayout> FindLayout(GLenum type) {
  // The types of vectors, by kind and then by components; a bool counts as a uint.
  constexpr GLenum kVectors[][4] = {
      {GL_FLOAT, GL_FLOAT_VEC2, GL_FLOAT_VEC3, GL_FLOAT_VEC4},
      {GL_INT, GL_INT_VEC2, GL_INT_VEC3, GL_INT_VEC4},
      {GL_UNSIGNED_INT, GL_UNSIGNED_INT_VEC2, GL_UNSIGNED_INT_VEC3, GL_UNSIGNED_INT_VEC4},
      {GL_BOOL, GL_BOOL_VEC2, GL_BOOL_VEC3, GL_BOOL_VEC4}};
  // The types of matrices, by columns from 2 and then by rows from 2.
  constexpr GLenum kMatrices[][3] = {{GL_FLOAT_MAT2, GL_FLOAT_MAT2x3, GL_FLOAT_MAT2x4},
                                     {GL_FLOAT_MAT3x2, GL_FLOAT_MAT3, GL_FLOAT_MAT3x4},
                                     {GL_FLOAT_MAT4x2, GL_FLOAT_MAT4x3, GL_FLOAT_MAT4}};
  for (int kind = 0; kind < 4; ++kind) {
    for (int i = 0; i < 4; ++i) {
      if (type == kVectors[kind][i])
        return WordLayout{static_cast<WordKind>(std::min(kind, 2)), 1, i + 1};
    }
  }
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      if (type == kMatrices[column][row]) return WordLayout{WordKind::kFloat, column + 2, row + 2};
    }
  }
  return std::nullopt;
}

WordLayout LayoutOf(const Active& active) {
  if (const std::optional<WordLayout> layout = FindLayout(active.type)) return *layout;
  throw DrawError("`" + active.name + "` has a type of OpenGL that no test draws with");
}

GlProgram::GlProgram(const std::string& vertex, const std::string& fragment,
                     std::span<const std::string> captured,
                     const std::function<void(GLuint program)>& before_linking)
    : program_(harness::LinkProgram(vertex, fragment, [&](GLuint program) {
        if (before_linking) before_linking(program);
        std::vector<const char*> names;
        for (const std::string& name : captured) names.push_back(name.c_str());
        if (names.empty()) return;
        glTransformFeedbackVaryings(program, static_cast<GLsizei>(names.size()), names.data(),
                                    GL_INTERLEAVED_ATTRIBS);
      })) {
  glGenVertexArrays(1, &vertex_array_);
}

GlProgram::GlProgram(std::span<const harness::StageText> stages,
                     std::span<const std::string> captured)
    : program_(harness::LinkStages(stages, [&](GLuint program) {
        std::vector<const char*> names;
        for (const std::string& name : captured) names.push_back(name.c_str());
        glTransformFeedbackVaryings(program, static_cast<GLsizei>(names.size()), names.data(),
                                    GL_INTERLEAVED_ATTRIBS);
      })) {
  glGenVertexArrays(1, &vertex_array_);
}

GlProgram::GlProgram(const std::string& compute) : program_(harness::LinkComputeProgram(compute)) {
  glGenVertexArrays(1, &vertex_array_);
}

GlProgram::~GlProgram() {
  glUseProgram(0);
  glBindVertexArray(0);
  glDeleteVertexArrays(1, &vertex_array_);
  glDeleteTextures(static_cast<GLsizei>(textures_.size()), textures_.data());
  glDeleteBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
  glDeleteProgram(program_);
}

std::vector<Active> GlProgram::Attributes() const {
  return List(program_, GL_ACTIVE_ATTRIBUTES, glGetActiveAttrib, glGetAttribLocation);
}

std::vector<Active> GlProgram::Uniforms() const {
  return List(program_, GL_ACTIVE_UNIFORMS, glGetActiveUniform, glGetUniformLocation);
}

std::vector<ActiveBlock> GlProgram::Blocks() const {
  GLint count = 0;
  glGetProgramiv(program_, GL_ACTIVE_UNIFORM_BLOCKS, &count);
  std::vector<ActiveBlock> all;
  for (GLint i = 0; i < count; ++i) {
    char name[512] = "";
    ActiveBlock block;
    glGetActiveUniformBlockName(program_, i, sizeof name, nullptr, name);
    glGetActiveUniformBlockiv(program_, i, GL_UNIFORM_BLOCK_DATA_SIZE, &block.size);
    block.name = name;
    all.push_back(block);
  }
  return all;
}

std::vector<ActiveMember> GlProgram::Members() const {
  const std::vector<ActiveBlock> blocks = Blocks();
  GLint count = 0;
  glGetProgramiv(program_, GL_ACTIVE_UNIFORMS, &count);
  std::vector<ActiveMember> all;
  for (GLint i = 0; i < count; ++i) {
    const auto index = static_cast<GLuint>(i);
    const auto get = [&](GLenum what) {
      GLint value = 0;
      glGetActiveUniformsiv(program_, 1, &index, what, &value);
      return value;
    };
    const GLint block = get(GL_UNIFORM_BLOCK_INDEX);
    if (block < 0) continue;
    all.push_back({blocks[static_cast<std::size_t>(block)].name,
                   static_cast<GLenum>(get(GL_UNIFORM_TYPE)), get(GL_UNIFORM_OFFSET),
                   get(GL_UNIFORM_SIZE), get(GL_UNIFORM_ARRAY_STRIDE)});
  }
  return all;
}

GLuint GlProgram::NewBuffer(GLenum target, const void* data, std::size_t size) {
  return buffers_.emplace_back(harness::NewBuffer(target, data, size));
}

void GlProgram::BindAttribute(const Active& active, const Inputs& inputs) {
  const auto& value = Find(inputs.attributes, active.name, "attribute");
  const WordLayout layout = LayoutOf(active);
  if (layout.columns != 1 || active.count != 1)
    throw DrawError("attribute `" + active.name + "` is a matrix or an array");
  if (value.words.size() != static_cast<std::size_t>(layout.rows) * inputs.vertices) {
    throw DrawError("attribute `" + active.name + "` has " + std::to_string(layout.rows) +
                    " components; " + std::to_string(value.words.size()) + " words for " +
                    std::to_string(inputs.vertices) + " vertices");
  }
  Words words(static_cast<std::size_t>(layout.rows) * inputs.first_vertex);
  words.insert(words.end(), value.words.begin(), value.words.end());
  NewBuffer(GL_ARRAY_BUFFER, words.data(), 4 * words.size());
  const GLuint index = active.location;
  if (layout.kind == WordKind::kFloat) {
    glVertexAttribPointer(index, layout.rows, GL_FLOAT, GL_FALSE, 0, nullptr);
  } else {
    const GLenum type = layout.kind == WordKind::kInt ? GL_INT : GL_UNSIGNED_INT;
    glVertexAttribIPointer(index, layout.rows, type, 0, nullptr);
  }
  glEnableVertexAttribArray(index);
}

void GlProgram::BindUniform(const Active& active, const Inputs& inputs) {
  const WordLayout layout = LayoutOf(active);
  Words words;
  if (inputs.find_uniform) words = inputs.find_uniform(active.name);
  if (words.empty()) words = Find(inputs.uniforms, active.name, "uniform").words;
  words.resize(static_cast<std::size_t>(layout.Words()) *
               active.count);  // an array's unused tail may be cut
  SetUniform(active, layout, words.data());
}

void GlProgram::BindSampler(const Active& active, const Inputs& inputs) {
  const bool is_array = active.name.ends_with("[0]");
  const std::string name = active.name.substr(0, active.name.size() - (is_array ? 3 : 0));
  for (int i = 0; i < active.count; ++i) {
    const auto unit = static_cast<GLint>(textures_.size());
    const Inputs::Texture& texture =
        Find(inputs.textures, is_array ? name + "[" + std::to_string(i) + "]" : name, "texture");
    glActiveTexture(GL_TEXTURE0 + unit);
    textures_.push_back(UploadTexture(texture, [&](const Words& words) {
      return NewBuffer(GL_TEXTURE_BUFFER, words.data(), 4 * words.size());
    }));
    if (texture.is_image) {
      GLint image_unit = 0;  // that of its binding: OpenGL ES sets no other
      glGetUniformiv(program_, active.location + i, &image_unit);
      BindImage(texture, textures_.back(), static_cast<GLuint>(image_unit));
      images_.push_back({&texture, textures_.back()});
    } else {
      glUniform1iv(active.location + i, 1, &unit);
    }
  }
}

void GlProgram::Bind(const Inputs& inputs) {
  glUseProgram(program_);
  glBindVertexArray(vertex_array_);
  for (const Active& attribute : Attributes()) BindAttribute(attribute, inputs);
  for (const Active& uniform : Uniforms()) {
    FindLayout(uniform.type) ? BindUniform(uniform, inputs) : BindSampler(uniform, inputs);
  }
  GLuint index = 0;
  for (const ActiveBlock& block : Blocks()) {
    Bytes bytes = Find(inputs.blocks, block.name, "uniform block").bytes;
    bytes.resize(std::max<std::size_t>(bytes.size(), block.size));
    const GLuint buffer = NewBuffer(GL_UNIFORM_BUFFER, bytes.data(), bytes.size());
    glUniformBlockBinding(program_, index, index);
    glBindBufferBase(GL_UNIFORM_BUFFER, index, buffer);
    ++index;
  }
  for (const Inputs::Storage& storage : inputs.storage) {
    const GLuint buffer =
        NewBuffer(GL_SHADER_STORAGE_BUFFER, storage.bytes.data(), storage.bytes.size());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, storage.binding, buffer);
  }
  harness::CheckErrors("binding the shader's inputs");
}

}  // namespace clipc::draw
