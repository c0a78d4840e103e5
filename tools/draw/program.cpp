// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/program.h"

#include <algorithm>
#include <cstring>

#include "tools/draw/upload.h"

namespace clipc::draw {
namespace {

// The value of that name; "planes" may stand for "planes[0]", the name that OpenGL gives arrays.
template <typename Value>
const Value& Find(const std::vector<Value>& values, const std::string& name, const char* what) {
  const std::string plain = name.substr(0, name.size() - (name.ends_with("[0]") ? 3 : 0));
  for (const Value& value : values) {
    if (value.name == name || value.name == plain) return value;
  }
  throw DrawError(std::string("the shader reads the ") + what + " `" + name +
                  "`, which has no value");
}

void SetUniform(const Gl& gl, const Active& active, const Shape& shape,
                const std::uint32_t* words) {
  const int at = active.location, n = active.count;
  const auto* f = reinterpret_cast<const GLfloat*>(words);
  const auto* i = reinterpret_cast<const GLint*>(words);
  switch (active.type) {
    case GL_FLOAT_MAT2: return gl.UniformMatrix2fv(at, n, GL_FALSE, f);
    case GL_FLOAT_MAT2x3: return gl.UniformMatrix2x3fv(at, n, GL_FALSE, f);
    case GL_FLOAT_MAT2x4: return gl.UniformMatrix2x4fv(at, n, GL_FALSE, f);
    case GL_FLOAT_MAT3: return gl.UniformMatrix3fv(at, n, GL_FALSE, f);
    case GL_FLOAT_MAT3x2: return gl.UniformMatrix3x2fv(at, n, GL_FALSE, f);
    case GL_FLOAT_MAT3x4: return gl.UniformMatrix3x4fv(at, n, GL_FALSE, f);
    case GL_FLOAT_MAT4: return gl.UniformMatrix4fv(at, n, GL_FALSE, f);
    case GL_FLOAT_MAT4x2: return gl.UniformMatrix4x2fv(at, n, GL_FALSE, f);
    case GL_FLOAT_MAT4x3: return gl.UniformMatrix4x3fv(at, n, GL_FALSE, f);
    default: break;
  }
  const int size = shape.rows - 1;
  switch (shape.kind) {
    case Shape::Kind::kFloat: {
      const PFNGLUNIFORM4FVPROC set[] = {gl.Uniform1fv, gl.Uniform2fv, gl.Uniform3fv,
                                         gl.Uniform4fv};
      return set[size](at, n, f);
    }
    case Shape::Kind::kInt: {
      const PFNGLUNIFORM4IVPROC set[] = {gl.Uniform1iv, gl.Uniform2iv, gl.Uniform3iv,
                                         gl.Uniform4iv};
      return set[size](at, n, i);
    }
    case Shape::Kind::kUint: {
      const PFNGLUNIFORM4UIVPROC set[] = {gl.Uniform1uiv, gl.Uniform2uiv, gl.Uniform3uiv,
                                          gl.Uniform4uiv};
      return set[size](at, n, words);
    }
  }
}

}  // namespace

Shape ShapeOf(GLenum type) {
  using enum Shape::Kind;
  switch (type) {
    case GL_FLOAT: return {kFloat, 1, 1};
    case GL_FLOAT_VEC2: return {kFloat, 1, 2};
    case GL_FLOAT_VEC3: return {kFloat, 1, 3};
    case GL_FLOAT_VEC4: return {kFloat, 1, 4};
    case GL_INT: return {kInt, 1, 1};
    case GL_INT_VEC2: return {kInt, 1, 2};
    case GL_INT_VEC3: return {kInt, 1, 3};
    case GL_INT_VEC4: return {kInt, 1, 4};
    case GL_BOOL:
    case GL_UNSIGNED_INT: return {kUint, 1, 1};
    case GL_BOOL_VEC2:
    case GL_UNSIGNED_INT_VEC2: return {kUint, 1, 2};
    case GL_BOOL_VEC3:
    case GL_UNSIGNED_INT_VEC3: return {kUint, 1, 3};
    case GL_BOOL_VEC4:
    case GL_UNSIGNED_INT_VEC4: return {kUint, 1, 4};
    case GL_FLOAT_MAT2: return {kFloat, 2, 2};
    case GL_FLOAT_MAT2x3: return {kFloat, 2, 3};
    case GL_FLOAT_MAT2x4: return {kFloat, 2, 4};
    case GL_FLOAT_MAT3x2: return {kFloat, 3, 2};
    case GL_FLOAT_MAT3: return {kFloat, 3, 3};
    case GL_FLOAT_MAT3x4: return {kFloat, 3, 4};
    case GL_FLOAT_MAT4x2: return {kFloat, 4, 2};
    case GL_FLOAT_MAT4x3: return {kFloat, 4, 3};
    case GL_FLOAT_MAT4: return {kFloat, 4, 4};
    default:
      throw DrawError("an attribute, uniform or output of OpenGL type " + std::to_string(type) +
                      ", which no test draws with");
  }
}

Program::Program(const Gl& gl, const std::string& vertex, const std::string& fragment,
                 std::span<const std::string> captured)
    : gl_(gl), program_(gl.CreateProgram()) {
  AddShader(GL_VERTEX_SHADER, vertex);
  if (!fragment.empty()) AddShader(GL_FRAGMENT_SHADER, fragment);
  std::vector<const char*> names;
  for (const std::string& name : captured) names.push_back(name.c_str());
  if (!names.empty()) {
    gl_.TransformFeedbackVaryings(program_, static_cast<GLsizei>(names.size()), names.data(),
                                  GL_INTERLEAVED_ATTRIBS);
  }
  Link();
  gl_.GenVertexArrays(1, &vertex_array_);
}

Program::~Program() {
  gl_.UseProgram(0);
  gl_.BindVertexArray(0);
  gl_.DeleteVertexArrays(1, &vertex_array_);
  gl_.DeleteTextures(static_cast<GLsizei>(textures_.size()), textures_.data());
  gl_.DeleteBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
  gl_.DeleteProgram(program_);
}

void Program::AddShader(GLenum stage, const std::string& source) {
  const GLuint shader = gl_.CreateShader(stage);
  const char* text = source.c_str();
  gl_.ShaderSource(shader, 1, &text, nullptr);
  gl_.CompileShader(shader);
  GLint ok = 0;
  gl_.GetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (!ok) {
    char log[4096] = "";
    gl_.GetShaderInfoLog(shader, sizeof log, nullptr, log);
    throw DrawError(std::string("OpenGL refuses the ") +
                    (stage == GL_VERTEX_SHADER ? "vertex" : "fragment") + " shader:\n" + log +
                    "\n" + source);
  }
  gl_.AttachShader(program_, shader);
  gl_.DeleteShader(shader);
}

void Program::Link() {
  gl_.LinkProgram(program_);
  GLint ok = 0;
  gl_.GetProgramiv(program_, GL_LINK_STATUS, &ok);
  if (ok) return;
  char log[4096] = "";
  gl_.GetProgramInfoLog(program_, sizeof log, nullptr, log);
  throw DrawError(std::string("OpenGL cannot link the shader:\n") + log);
}

std::vector<Active> Program::Attributes() const {
  GLint count = 0;
  gl_.GetProgramiv(program_, GL_ACTIVE_ATTRIBUTES, &count);
  std::vector<Active> all;
  for (GLint i = 0; i < count; ++i) {
    char name[512] = "";
    Active active;
    gl_.GetActiveAttrib(program_, i, sizeof name, nullptr, &active.count, &active.type, name);
    active.name = name;
    active.location = gl_.GetAttribLocation(program_, name);
    if (active.location >= 0) all.push_back(active);  // gl_VertexID and its like have none
  }
  return all;
}

std::vector<Active> Program::Uniforms() const {
  GLint count = 0;
  gl_.GetProgramiv(program_, GL_ACTIVE_UNIFORMS, &count);
  std::vector<Active> all;
  for (GLint i = 0; i < count; ++i) {
    char name[512] = "";
    Active active;
    gl_.GetActiveUniform(program_, i, sizeof name, nullptr, &active.count, &active.type, name);
    active.name = name;
    active.location = gl_.GetUniformLocation(program_, name);
    all.push_back(active);
  }
  return all;
}

std::vector<ActiveBlock> Program::Blocks() const {
  GLint count = 0;
  gl_.GetProgramiv(program_, GL_ACTIVE_UNIFORM_BLOCKS, &count);
  std::vector<ActiveBlock> all;
  for (GLint i = 0; i < count; ++i) {
    char name[512] = "";
    ActiveBlock block;
    gl_.GetActiveUniformBlockName(program_, i, sizeof name, nullptr, name);
    gl_.GetActiveUniformBlockiv(program_, i, GL_UNIFORM_BLOCK_DATA_SIZE, &block.size);
    block.name = name;
    all.push_back(block);
  }
  return all;
}

GLuint Program::NewBuffer(GLenum target, const void* data, std::size_t size) {
  GLuint buffer = 0;
  gl_.GenBuffers(1, &buffer);
  gl_.BindBuffer(target, buffer);
  gl_.BufferData(target, static_cast<GLsizeiptr>(size), data, GL_STATIC_DRAW);
  buffers_.push_back(buffer);
  return buffer;
}

void Program::BindAttribute(const Active& active, const Inputs& inputs) {
  const auto& value = Find(inputs.attributes, active.name, "attribute");
  const Shape shape = ShapeOf(active.type);
  if (shape.columns != 1 || active.count != 1)
    throw DrawError("attribute `" + active.name + "` is a matrix or an array");
  if (value.words.size() != static_cast<std::size_t>(shape.rows) * inputs.vertices) {
    throw DrawError("attribute `" + active.name + "` has " + std::to_string(shape.rows) +
                    " components; " + std::to_string(value.words.size()) + " words for " +
                    std::to_string(inputs.vertices) + " vertices");
  }
  std::vector<std::uint32_t> words(static_cast<std::size_t>(shape.rows) * inputs.first_vertex);
  words.insert(words.end(), value.words.begin(), value.words.end());
  NewBuffer(GL_ARRAY_BUFFER, words.data(), 4 * words.size());
  const auto index = static_cast<GLuint>(active.location);
  if (shape.kind == Shape::Kind::kFloat) {
    gl_.VertexAttribPointer(index, shape.rows, GL_FLOAT, GL_FALSE, 0, nullptr);
  } else {
    const GLenum type = shape.kind == Shape::Kind::kInt ? GL_INT : GL_UNSIGNED_INT;
    gl_.VertexAttribIPointer(index, shape.rows, type, 0, nullptr);
  }
  gl_.EnableVertexAttribArray(index);
}

void Program::BindUniform(const Active& active, const Inputs& inputs) {
  const Shape shape = ShapeOf(active.type);
  std::vector<std::uint32_t> words;
  if (inputs.find_uniform) words = inputs.find_uniform(active.name);
  if (words.empty()) words = Find(inputs.uniforms, active.name, "uniform").words;
  words.resize(static_cast<std::size_t>(shape.Words()) *
               active.count);  // an array's unused tail may be cut
  SetUniform(gl_, active, shape, words.data());
}

void Program::BindSampler(const Active& active, const Inputs& inputs) {
  const bool is_array = active.name.ends_with("[0]");
  const std::string name = active.name.substr(0, active.name.size() - (is_array ? 3 : 0));
  for (int i = 0; i < active.count; ++i) {
    const auto unit = static_cast<GLint>(textures_.size());
    const Inputs::Texture& texture =
        Find(inputs.textures, is_array ? name + "[" + std::to_string(i) + "]" : name, "texture");
    gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    textures_.push_back(UploadTexture(gl_, texture, [&](const std::vector<std::uint32_t>& words) {
      return NewBuffer(GL_TEXTURE_BUFFER, words.data(), 4 * words.size());
    }));
    gl_.Uniform1iv(active.location + i, 1, &unit);
  }
}

void Program::Bind(const Inputs& inputs) {
  gl_.UseProgram(program_);
  gl_.BindVertexArray(vertex_array_);
  for (const Active& attribute : Attributes()) BindAttribute(attribute, inputs);
  for (const Active& uniform : Uniforms()) {
    if (uniform.location < 0) continue;
    IsSampler(uniform.type) ? BindSampler(uniform, inputs) : BindUniform(uniform, inputs);
  }
  GLuint index = 0;
  for (const ActiveBlock& block : Blocks()) {
    std::vector<std::uint8_t> bytes = Find(inputs.blocks, block.name, "uniform block").bytes;
    bytes.resize(std::max(bytes.size(), static_cast<std::size_t>(block.size)));
    const GLuint buffer = NewBuffer(GL_UNIFORM_BUFFER, bytes.data(), bytes.size());
    gl_.UniformBlockBinding(program_, index, index);
    gl_.BindBufferBase(GL_UNIFORM_BUFFER, index, buffer);
    ++index;
  }
  for (const Inputs::Storage& storage : inputs.storage) {
    const GLuint buffer =
        NewBuffer(GL_SHADER_STORAGE_BUFFER, storage.bytes.data(), storage.bytes.size());
    gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, storage.binding, buffer);
  }
  CheckErrors(gl_, "binding the shader's inputs");
}

}  // namespace clipc::draw
