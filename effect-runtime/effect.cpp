// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "effect-runtime/effect.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <memory>
#include <vector>

#include "effect-runtime/effect_gl.h"
#include "runtime/c_interface.h"
#include "runtime/gl/clip_switches.h"

using namespace clipc::runtime;

namespace {

enum : unsigned {
  kUniformBuffer = 0x8A11,
  kDynamicDraw = 0x88E8,
  kVertexShader = 0x8B31,
  kFragmentShader = 0x8B30,
  kCompileStatus = 0x8B81,
  kLinkStatus = 0x8B82,
  kTexture0 = 0x84C0,
  kInvalidIndex = 0xFFFFFFFF,
};
constexpr std::uint32_t kRegister = 16;  // bytes of a vector of a constant buffer

char Lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool EqualIgnoringCase(const char* a, const char* b) {
  while (*a != '\0' && Lower(*a) == Lower(*b)) ++a, ++b;
  return Lower(*a) == Lower(*b);
}

bool IsNone(const char* name) { return name == nullptr || *name == '\0'; }

}  // namespace

// NOLINTBEGIN(readability-identifier-naming): names of the C interface.
struct clipc_gl_effect {
  clipc_gl_effect(const gl::EffectFunctions& functions, const clipc_gl_effect_table& effect)
      : gl(functions), table(effect), switches(functions.basic) {}

  ~clipc_gl_effect() {
    for (const unsigned program : programs) gl.DeleteProgram(program);
    if (!buffers.empty()) gl.DeleteBuffers(static_cast<int>(buffers.size()), buffers.data());
    if (!samplers.empty()) gl.DeleteSamplers(static_cast<int>(samplers.size()), samplers.data());
  }
  clipc_gl_effect(const clipc_gl_effect&) = delete;
  clipc_gl_effect& operator=(const clipc_gl_effect&) = delete;

  gl::EffectFunctions gl;
  const clipc_gl_effect_table& table;
  gl::ClipSwitches switches;
  std::vector<unsigned> programs, buffers, samplers;  // of OpenGL
  std::vector<unsigned> textures;                     // what the application set
  struct BlockContents {
    std::vector<unsigned char> bytes;
    bool is_changed = true;
  };
  std::vector<BlockContents> blocks;
};
// NOLINTEND(readability-identifier-naming)

namespace {

// ---- programs

Status Attach(const gl::EffectFunctions& gl, unsigned program, unsigned stage, const char* text) {
  const unsigned shader = gl.CreateShader(stage);
  if (shader == 0)
    return Status::Failure(Error::kDeviceFailed,
                           "OpenGL makes no shader; a context must be current");
  gl.ShaderSource(shader, 1, &text, nullptr);
  gl.CompileShader(shader);
  int is_compiled = 0;
  gl.GetShaderiv(shader, kCompileStatus, &is_compiled);
  Status status;
  if (is_compiled == 0) {
    char log[Status::kMessageSize] = "";
    gl.GetShaderInfoLog(shader, sizeof log, nullptr, log);
    status = Status::Failure(Error::kDeviceFailed, "a shader does not compile: %s", log);
  }
  gl.AttachShader(program, shader);
  gl.DeleteShader(shader);  // once the program is deleted
  return status;
}

Status Link(clipc_gl_effect& effect, const clipc_gl_effect_program& program) {
  const gl::EffectFunctions& gl = effect.gl;
  effect.programs.push_back(gl.CreateProgram());
  const unsigned made = effect.programs.back();
  Status status = Attach(gl, made, kVertexShader, program.vertex);
  if (status.ok() && program.fragment) status = Attach(gl, made, kFragmentShader, program.fragment);
  if (!status.ok()) return status;
  gl.LinkProgram(made);
  int is_linked = 0;
  gl.GetProgramiv(made, kLinkStatus, &is_linked);
  if (is_linked == 0) {
    char log[Status::kMessageSize] = "";
    gl.GetProgramInfoLog(made, sizeof log, nullptr, log);
    return Status::Failure(Error::kDeviceFailed, "a program does not link: %s", log);
  }
  for (std::uint32_t i = 0; i < program.use_count; ++i) {
    const unsigned index =
        gl.GetUniformBlockIndex(made, effect.table.uses[program.first_use + i].name);
    if (index != kInvalidIndex) gl.UniformBlockBinding(made, index, i);
  }
  gl.UseProgram(made);
  for (std::uint32_t i = 0; i < program.sampler_count; ++i) {
    const int place =
        gl.GetUniformLocation(made, effect.table.samplers[program.first_sampler + i].name);
    if (place >= 0) gl.Uniform1i(place, static_cast<int>(i));
  }
  return {};
}

// ---- samplers

void SetSampling(const gl::EffectFunctions& gl, unsigned sampler,
                 const clipc_gl_effect_sampling& from) {
  const auto number = [&](unsigned name, std::uint32_t value) {
    gl.SamplerParameteri(sampler, name, static_cast<int>(value));
  };
  number(0x2801, from.min_filter);
  number(0x2800, from.mag_filter);
  number(0x2802, from.wrap_s);
  number(0x2803, from.wrap_t);
  number(0x8072, from.wrap_r);
  number(0x884C, from.compare_func != 0 ? 0x884E : 0);  // GL_COMPARE_REF_TO_TEXTURE, GL_NONE
  if (from.compare_func != 0) number(0x884D, from.compare_func);
  gl.SamplerParameterf(sampler, 0x813A, from.min_lod);
  gl.SamplerParameterf(sampler, 0x813B, from.max_lod);
  // An extension before OpenGL 4.6; a context without it notes an error otherwise.
  if (from.max_anisotropy > 1) gl.SamplerParameterf(sampler, 0x84FE, from.max_anisotropy);
  if (gl.is_es) return;
  gl.SamplerParameterf(sampler, 0x8501, from.lod_bias);
  gl.SamplerParameterfv(sampler, 0x1004, from.border);
}

// ---- parameters

std::size_t SizeOf(const clipc_gl_effect_parameter& parameter) {
  const std::size_t element =
      parameter.rows == 0 ? parameter.columns : std::size_t{4} * parameter.rows * parameter.columns;
  return element * (parameter.elements == 0 ? 1 : parameter.elements);
}

// Writes the first `elements` elements into the buffer. Direct3D packs a vector of a matrix, and an
// element of an array, into registers of their own.
void Place(const clipc_gl_effect_parameter& parameter, const clipc_gl_effect_place& place,
           const unsigned char* from, std::size_t size, std::vector<unsigned char>& to) {
  const auto put = [&](std::size_t at, std::size_t source, std::size_t bytes) {
    if (source + bytes <= size && at + bytes <= to.size())
      std::memcpy(to.data() + at, from + source, bytes);
  };
  const std::uint32_t rows = parameter.rows, columns = parameter.columns;
  if (rows == 0) return put(place.offset, 0, size);
  const std::uint32_t vectors = place.row_major != 0 ? rows : columns;
  const bool is_matrix = rows > 1;
  const std::size_t stride = is_matrix ? std::size_t{kRegister} * vectors : kRegister;
  const std::uint32_t elements = parameter.elements == 0 ? 1 : parameter.elements;
  for (std::uint32_t e = 0; e < elements; ++e) {
    const std::size_t first = place.offset + e * stride;
    for (std::uint32_t r = 0; r < rows; ++r) {
      for (std::uint32_t c = 0; c < columns; ++c) {
        const std::uint32_t vector = !is_matrix ? 0 : place.row_major != 0 ? r : c;
        const std::uint32_t component = !is_matrix ? c : place.row_major != 0 ? c : r;
        put(first + std::size_t{kRegister} * vector + std::size_t{4} * component,
            std::size_t{4} * ((e * rows + r) * columns + c), 4);
      }
    }
  }
}

void Set(clipc_gl_effect& effect, const clipc_gl_effect_parameter& parameter, const void* values,
         std::size_t size) {
  for (std::uint32_t i = 0; i < parameter.place_count; ++i) {
    const clipc_gl_effect_place& place = effect.table.places[parameter.first_place + i];
    clipc_gl_effect::BlockContents& block = effect.blocks[place.block];
    Place(parameter, place, static_cast<const unsigned char*>(values), size, block.bytes);
    block.is_changed = true;
  }
}

void SetDefault(clipc_gl_effect& effect, const clipc_gl_effect_parameter& parameter) {
  const std::size_t size = std::size_t{4} * parameter.value_count;
  for (std::uint32_t i = 0; size != 0 && i < parameter.place_count; ++i) {
    const clipc_gl_effect_place& place = effect.table.places[parameter.first_place + i];
    std::vector<unsigned char>& bytes = effect.blocks[place.block].bytes;
    if (place.offset + size <= bytes.size())
      std::memcpy(bytes.data() + place.offset, parameter.value, size);
  }
}

Status Make(clipc_gl_effect& effect) {
  const clipc_gl_effect_table& table = effect.table;
  for (std::uint32_t i = 0; i < table.program_count; ++i) {
    const Status status = Link(effect, table.programs[i]);
    if (!status.ok()) return status;
  }
  effect.samplers.resize(table.sampling_count);
  if (table.sampling_count != 0)
    effect.gl.GenSamplers(static_cast<int>(table.sampling_count), effect.samplers.data());
  for (std::uint32_t i = 0; i < table.sampling_count; ++i)
    SetSampling(effect.gl, effect.samplers[i], table.samplings[i]);
  effect.textures.resize(table.texture_count);
  effect.buffers.resize(table.block_count);
  if (table.block_count != 0)
    effect.gl.GenBuffers(static_cast<int>(table.block_count), effect.buffers.data());
  effect.blocks.resize(table.block_count);
  for (std::uint32_t i = 0; i < table.block_count; ++i)
    effect.blocks[i].bytes.resize(table.block_sizes[i]);
  for (std::uint32_t i = 0; i < table.parameter_count; ++i) SetDefault(effect, table.parameters[i]);
  return {};
}

const clipc_gl_effect_pass* PassOf(const clipc_gl_effect* effect, std::uint32_t number) {
  const clipc_gl_effect_table& table = effect->table;
  for (std::uint32_t i = 0; i < table.technique_count; ++i) {
    const clipc_gl_effect_technique& technique = table.techniques[i];
    if (number - technique.first_pass < technique.pass_count) return &table.passes[number];
  }
  return nullptr;
}

const clipc_gl_effect_program* ProgramOf(const clipc_gl_effect* effect, std::uint32_t number) {
  const clipc_gl_effect_pass* pass = effect ? PassOf(effect, number) : nullptr;
  return pass ? &effect->table.programs[pass->program] : nullptr;
}

void BindBlocks(clipc_gl_effect& effect, const clipc_gl_effect_program& program) {
  for (std::uint32_t i = 0; i < program.use_count; ++i) {
    const std::uint32_t number = effect.table.uses[program.first_use + i].block;
    clipc_gl_effect::BlockContents& block = effect.blocks[number];
    effect.gl.BindBufferBase(kUniformBuffer, i, effect.buffers[number]);
    if (!block.is_changed) continue;
    effect.gl.BufferData(kUniformBuffer, static_cast<std::ptrdiff_t>(block.bytes.size()),
                         block.bytes.data(), kDynamicDraw);
    block.is_changed = false;
  }
}

void BindTextures(clipc_gl_effect& effect, const clipc_gl_effect_program& program) {
  for (std::uint32_t i = 0; i < program.sampler_count; ++i) {
    const clipc_gl_effect_sampler& sampler = effect.table.samplers[program.first_sampler + i];
    effect.gl.ActiveTexture(kTexture0 + i);
    effect.gl.BindTexture(effect.table.textures[sampler.texture].target,
                          effect.textures[sampler.texture]);
    effect.gl.BindSampler(i, effect.samplers[sampler.sampling]);
  }
}

}  // namespace

extern "C" {

clipc_error clipc_gl_effect_create(clipc_gl_loader loader, const clipc_gl_effect_table* table,
                                   clipc_gl_effect** effect, char* message) {
  if (IsMissing({table, static_cast<const void*>(effect)}, message)) return CLIPC_INVALID_ARGUMENT;
  *effect = nullptr;
  const Result<gl::EffectFunctions> functions = gl::LoadEffectFunctions(loader);
  if (!functions.ok()) return Report(functions.status, message);
  try {
    auto made = std::make_unique<clipc_gl_effect>(functions.value, *table);
    const Status status = Make(*made);
    if (!status.ok()) return Report(status, message);
    *effect = made.release();
    return Report({}, message);
  } catch (const std::exception&) {
    return Report(Status::Failure(Error::kOutOfMemory, "no memory for the effect"), message);
  }
}

void clipc_gl_effect_free(clipc_gl_effect* effect) { delete effect; }

clipc_error clipc_gl_effect_find(const clipc_gl_effect* effect, const char* technique,
                                 const char* pass, uint32_t* number, char* message) {
  if (IsMissing({effect, technique, number}, message)) return CLIPC_INVALID_ARGUMENT;
  const clipc_gl_effect_table& table = effect->table;
  for (std::uint32_t i = 0; i < table.technique_count; ++i) {
    const clipc_gl_effect_technique& of = table.techniques[i];
    if (std::strcmp(of.name, technique) != 0) continue;
    for (std::uint32_t k = 0; k < of.pass_count; ++k) {
      if (pass && std::strcmp(table.passes[of.first_pass + k].name, pass) != 0) continue;
      *number = of.first_pass + k;
      return Report({}, message);
    }
  }
  return Report(Status::Failure(Error::kInvalidArgument, "the effect has no pass `%s` of `%s`",
                                pass ? pass : "", technique),
                message);
}

const char* clipc_gl_effect_by_semantic(const clipc_gl_effect* effect, const char* semantic) {
  if (effect == nullptr || IsNone(semantic)) return nullptr;
  for (std::uint32_t i = 0; i < effect->table.parameter_count; ++i) {
    const clipc_gl_effect_parameter& parameter = effect->table.parameters[i];
    if (EqualIgnoringCase(parameter.semantic, semantic)) return parameter.name;
  }
  return nullptr;
}

clipc_error clipc_gl_effect_set(clipc_gl_effect* effect, const char* name, const void* values,
                                size_t size, char* message) {
  if (IsMissing({effect, name, values}, message)) return CLIPC_INVALID_ARGUMENT;
  for (std::uint32_t i = 0; i < effect->table.parameter_count; ++i) {
    const clipc_gl_effect_parameter& parameter = effect->table.parameters[i];
    if (std::strcmp(parameter.name, name) != 0) continue;
    const std::size_t whole = SizeOf(parameter);
    const std::size_t element = whole / (parameter.elements == 0 ? 1 : parameter.elements);
    if (size == 0 || size > whole || size % element != 0) {
      return Report(Status::Failure(
                        Error::kInvalidArgument, "%lu bytes for the parameter `%s`, which has %lu",
                        static_cast<unsigned long>(size), name, static_cast<unsigned long>(whole)),
                    message);
    }
    Set(*effect, parameter, values, size);
    return Report({}, message);
  }
  return Report(Status::Failure(Error::kInvalidArgument, "no program reads a parameter `%s`", name),
                message);
}

clipc_error clipc_gl_effect_set_texture(clipc_gl_effect* effect, const char* name, unsigned texture,
                                        char* message) {
  if (IsMissing({effect, name}, message)) return CLIPC_INVALID_ARGUMENT;
  bool is_found = false;
  for (std::uint32_t i = 0; i < effect->table.texture_count; ++i) {
    if (std::strcmp(effect->table.textures[i].name, name) != 0) continue;
    effect->textures[i] = texture;
    is_found = true;
  }
  if (is_found) return Report({}, message);
  return Report(Status::Failure(Error::kInvalidArgument, "no program reads a texture `%s`", name),
                message);
}

clipc_error clipc_gl_effect_apply(clipc_gl_effect* effect, uint32_t pass, char* message) {
  const clipc_gl_effect_program* program = ProgramOf(effect, pass);
  if (program == nullptr)
    return Report(Status::Failure(Error::kInvalidArgument, "the effect has no pass %u", pass),
                  message);
  const clipc_gl_effect_pass& with = effect->table.passes[pass];
  effect->gl.UseProgram(effect->programs[with.program]);
  BindBlocks(*effect, *program);
  BindTextures(*effect, *program);
  const std::uint32_t by_state =
      gl::ApplyStates(effect->gl, effect->table.states + with.first_state, with.state_count);
  return Report(effect->switches.Enable(by_state | program->clip_distances), message);
}

const clipc_gl_effect_technique* clipc_gl_effect_technique_of(const clipc_gl_effect* effect,
                                                              uint32_t i) {
  return effect && i < effect->table.technique_count ? &effect->table.techniques[i] : nullptr;
}

const clipc_gl_effect_pass* clipc_gl_effect_pass_of(const clipc_gl_effect* effect, uint32_t i) {
  return effect ? PassOf(effect, i) : nullptr;
}

const clipc_gl_effect_parameter* clipc_gl_effect_parameter_of(const clipc_gl_effect* effect,
                                                              uint32_t i) {
  return effect && i < effect->table.parameter_count ? &effect->table.parameters[i] : nullptr;
}

const clipc_gl_effect_texture* clipc_gl_effect_texture_of(const clipc_gl_effect* effect,
                                                          uint32_t i) {
  return effect && i < effect->table.texture_count ? &effect->table.textures[i] : nullptr;
}

const clipc_gl_effect_annotation* clipc_gl_effect_annotation_of(const clipc_gl_effect* effect,
                                                                uint32_t i) {
  return effect && i < effect->table.annotation_count ? &effect->table.annotations[i] : nullptr;
}

const clipc_vk_effect_state* clipc_vk_effect_states(const clipc_gl_effect_table* table,
                                                    uint32_t pass, uint32_t* count) {
  const bool is_there = table && pass < table->vulkan_pass_count;
  const clipc_vk_effect_pass range =
      is_there ? table->vulkan_passes[pass] : clipc_vk_effect_pass{0, 0};
  if (count) *count = range.state_count;
  return range.state_count > 0 ? table->vulkan_states + range.first_state : nullptr;
}

unsigned clipc_gl_effect_program_of(const clipc_gl_effect* effect, uint32_t pass) {
  return ProgramOf(effect, pass) ? effect->programs[effect->table.passes[pass].program] : 0;
}

uint32_t clipc_gl_effect_plane_count(const clipc_gl_effect* effect, uint32_t pass) {
  const clipc_gl_effect_program* program = ProgramOf(effect, pass);
  return program ? program->plane_count : 0;
}

const clipc_gl_effect_plane* clipc_gl_effect_plane_of(const clipc_gl_effect* effect, uint32_t pass,
                                                      uint32_t i) {
  const clipc_gl_effect_program* program = ProgramOf(effect, pass);
  return program && i < program->plane_count ? &effect->table.planes[program->first_plane + i]
                                             : nullptr;
}

}  // extern "C"
