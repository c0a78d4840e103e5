// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/effect/dialect.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/spelling.h"
#include "ir/profile.h"

namespace clipc {
namespace {

using ast::EffectShader;
using ast::EffectState;

// What OBS Studio replaces before it gives an effect to Direct3D (libobs-d3d11,
// ShaderProcessor::BuildString). Its constant says that the image is OpenGL's, whose first row is
// the lowest.
constexpr std::string_view kObsWords =
    "#define POSITION SV_Position\n#define TARGET SV_Target\n#define VERTEXID SV_VertexID\n"
    "#define texture2d Texture2D\n#define texture3d Texture3D\n"
    "#define texture_cube TextureCube\n#define sampler_state SamplerState\n"
    "static const bool obs_glsl_compile = {};\n";

struct ObsName {
  std::string_view name;
  Stage stage;
  std::string_view profile;  // that OBS Studio compiles for
};
constexpr ObsName kObsNames[] = {{"vertex_shader", Stage::kVertex, "vs_4_0"},
                                 {"vertex_program", Stage::kVertex, "vs_4_0"},
                                 {"pixel_shader", Stage::kPixel, "ps_4_0"},
                                 {"pixel_program", Stage::kPixel, "ps_4_0"}};

const ObsName* FindObsName(const EffectState& state) {
  const auto found = std::ranges::find(kObsNames, state.name, &ObsName::name);
  return found == std::end(kObsNames) ? nullptr : found;
}

// Whether a text in parentheses is in one pair of them.
bool IsInOnePair(std::string_view text) {
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
    if (depth == 0) return i + 1 == text.size();
  }
  return false;
}

// Main(v_in, true): an argument for each parameter. A lone one is the input.
EffectShader ReadObsShader(const EffectState& state, std::string_view profile) {
  EffectShader shader;
  shader.kind = EffectShader::Kind::kOther;
  shader.text = state.text;
  shader.span = state.span;
  std::string_view text = state.text;
  if (constexpr std::string_view kCompile = "compile "; text.starts_with(kCompile))
    text.remove_prefix(kCompile.size());
  const std::size_t open = text.find('(');
  if (open == std::string_view::npos || !IsInOnePair(text.substr(open))) return shader;
  std::string_view function = text.substr(0, open);
  while (function.ends_with(' ')) function.remove_suffix(1);
  const bool is_word = !function.empty() && std::ranges::all_of(function, [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  });
  if (!is_word) return shader;
  shader.kind = EffectShader::Kind::kCompiled;
  shader.profile = profile;
  shader.function = function;
  if (text.find(',', open) != std::string_view::npos) shader.call = text;
  return shader;
}

// OBS Studio's words for the values of a sampler (libobs, shader_sampler_convert).
struct ObsWord {
  std::string_view state, word, direct3d;
};
constexpr ObsWord kObsSamplerWords[] = {
    {"filter", "linear", "MIN_MAG_MIP_LINEAR"},
    {"filter", "point", "MIN_MAG_MIP_POINT"},
    {"filter", "anisotropy", "ANISOTROPIC"},
    {"addressu", "repeat", "WRAP"},
    {"addressv", "repeat", "WRAP"},
    {"addressw", "repeat", "WRAP"},
    {"addressu", "none", "CLAMP"},
    {"addressv", "none", "CLAMP"},
    {"addressw", "none", "CLAMP"},
    {"addressu", "mirroronce", "MIRROR_ONCE"},
    {"addressv", "mirroronce", "MIRROR_ONCE"},
    {"addressw", "mirroronce", "MIRROR_ONCE"},
};

void ReadObsSampler(std::vector<EffectState>& states) {
  for (EffectState& state : states) {
    const std::string name = ToLower(state.word), word = ToLower(state.value.word);
    for (const ObsWord& row : kObsSamplerWords) {
      if (row.state == name && row.word == word) state.value.word = row.direct3d;
    }
  }
}

// Whether Direct3D does not have the shader in such a technique.
bool IsLate(const EffectShader& shader) {
  if (shader.kind != EffectShader::Kind::kCompiled) return false;
  const auto profile = ir::ParseProfile(shader.profile);
  return profile && profile->IsAtLeast(4, 0);
}

}  // namespace

EffectDialect DialectOf(const ast::Effect& effect) {
  bool is_late = false;
  for (const ast::EffectTechnique& technique : effect.techniques) {
    for (const ast::EffectPass& pass : technique.passes) {
      if (std::ranges::any_of(pass.states, FindObsName)) return EffectDialect::kObs;
      is_late =
          is_late || (technique.kind == "technique" && (IsLate(pass.vertex) || IsLate(pass.pixel)));
    }
  }
  return is_late ? EffectDialect::kMonoGame : EffectDialect::kDirect3D;
}

std::vector<std::string_view> ShaderNames(EffectDialect dialect) {
  if (dialect != EffectDialect::kObs) return {};
  std::vector<std::string_view> names;
  for (const ObsName& row : kObsNames) names.push_back(row.name);
  return names;
}

void UseDialect(EffectDialect dialect, CommandLine& command) {
  ProgramRequest& request = command.request;
  using signature::PositionName;
  if (dialect == EffectDialect::kMonoGame &&
      request.language.position_name == PositionName::kSystemValue)
    request.language.position_name = PositionName::kBoth;
  if (dialect != EffectDialect::kObs) return;
  request.language.call_names_parameters = true;
  if (!command.names_target) {
    request.target = *glsl::Target::Parse("glsl330");
    // OBS Studio draws upside down into textures: its matrices flip y there (device_draw of
    // libobs-opengl), and gl_FragCoord and dFdy are as Direct3D has them.
    if (command.header.empty()) {
      request.style.blocks = glsl::BlockStyle::kFlat;
      request.style.clip_space.host_flips_y = true;
    }
  }
  request.includes.preamble =
      fmt::format(fmt::runtime(kObsWords), !request.target.IsVulkan()) + request.includes.preamble;
}

void ReadObs(ast::Effect& effect) {
  for (ast::EffectTechnique& technique : effect.techniques) {
    for (ast::EffectPass& pass : technique.passes) {
      for (const EffectState& state : pass.states) {
        const ObsName* const name = FindObsName(state);
        if (!name) continue;
        (name->stage == Stage::kVertex ? pass.vertex : pass.pixel) =
            ReadObsShader(state, name->profile);
      }
      std::erase_if(pass.states, FindObsName);
    }
  }
  for (ast::EffectParameter& parameter : effect.parameters) ReadObsSampler(parameter.states);
}

}  // namespace clipc
