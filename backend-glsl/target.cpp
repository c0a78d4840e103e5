// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/target.h"

#include <array>

#include "base/spelling.h"

namespace clipc::glsl {
namespace {

struct Profile {
  std::string_view name;
  Api api;
  int version;
};
constexpr std::array kProfiles = {
    Profile{"glsl120", Api::kOpenGL, 120},   Profile{"glsl130", Api::kOpenGL, 130},
    Profile{"glsl140", Api::kOpenGL, 140},   Profile{"glsl150", Api::kOpenGL, 150},
    Profile{"glsl330", Api::kOpenGL, 330},   Profile{"glsl400", Api::kOpenGL, 400},
    Profile{"glsl410", Api::kOpenGL, 410},   Profile{"glsl420", Api::kOpenGL, 420},
    Profile{"glsl430", Api::kOpenGL, 430},   Profile{"glsl440", Api::kOpenGL, 440},
    Profile{"glsl450", Api::kOpenGL, 450},   Profile{"glsl460", Api::kOpenGL, 460},
    Profile{"essl300", Api::kOpenGLES, 300}, Profile{"essl310", Api::kOpenGLES, 310},
    Profile{"essl320", Api::kOpenGLES, 320}, Profile{"vulkan", Api::kVulkan, 460},
};

constexpr auto kNames = [] {
  std::array<std::string_view, kProfiles.size()> names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = kProfiles[i].name;
  return names;
}();

}  // namespace

std::optional<Target> Target::Parse(std::string_view name) {
  for (const Profile& profile : kProfiles) {
    if (EqualIgnoringCase(profile.name, name)) {
      return Target(profile.name, profile.api, profile.version);
    }
  }
  return std::nullopt;
}

std::span<const std::string_view> Target::Names() { return kNames; }

std::string Target::VersionLine() const {
  return "#version " + std::to_string(version_) + (IsEs() ? " es" : "");
}

Support Target::PerSample() const {
  if (api_ == Api::kOpenGLES && version_ < 320) {
    return Support::Through("GL_OES_shader_multisample_interpolation");
  }
  return Gate(400, 320);
}

Support Target::ClipDistance() const {
  return IsEs() ? Support::Through("GL_EXT_clip_cull_distance") : Gate(130, kNever);
}

Support Target::CullDistance() const {
  if (IsEs()) return Support::Through("GL_EXT_clip_cull_distance");
  return Gate(450, kNever);
}

Support Target::InstanceId() const {
  return AtLeast(140, 300) ? Support::Core() : Support::Through("GL_ARB_draw_instanced");
}

Support Target::DrawParameters() const {
  // The extension is older (OpenGL 3.1), but glslang knows its variables from GLSL 4.50 on only.
  if (IsEs() || version_ < 450) return Support::No();
  return version_ >= 460 ? Support::Core() : Support::Through("GL_ARB_shader_draw_parameters");
}

Support Target::LayerAndViewport() const {
  return AtLeast(410, kNever) ? Support::Through("GL_ARB_shader_viewport_layer_array")
                              : Support::No();
}

Support Target::ViewIndex() const {
  if (IsVulkan()) return Support::Through("GL_EXT_multiview");
  return AtLeast(330, 300) ? Support::Through("GL_OVR_multiview2") : Support::No();
}

Support Target::ShadingRate() const {
  return AtLeast(450, 310) ? Support::Through("GL_EXT_fragment_shading_rate") : Support::No();
}

Support Target::Doubles() const {
  if (!IsEs() && version_ >= 150 && version_ < 400)
    return Support::Through("GL_ARB_gpu_shader_fp64");
  return Gate(400, kNever);
}

Support Target::Int64() const {
  return AtLeast(400, kNever) ? Support::Through("GL_ARB_gpu_shader_int64") : Support::No();
}

Support Target::BitCasts() const {
  if (!IsEs() && version_ >= 150 && version_ < 330)
    return Support::Through("GL_ARB_shader_bit_encoding");
  return Gate(330, 300);
}

Support Target::CubeArrays() const {
  if (!IsEs() && version_ >= 130 && version_ < 400)
    return Support::Through("GL_ARB_texture_cube_map_array");
  if (IsEs() && version_ == 310) return Support::Through("GL_EXT_texture_cube_map_array");
  return Gate(400, 320);
}

Support Target::MultisampleArrays() const {
  if (IsEs() && version_ == 310)
    return Support::Through("GL_OES_texture_storage_multisample_2d_array");
  return Gate(150, 320);
}

Support Target::GatherOffsets() const {
  if (IsEs() && version_ == 310) return Support::Through("GL_EXT_gpu_shader5");
  return Gate(400, 320);
}

Support Target::TextureBuffers() const {
  if (IsEs() && version_ == 310) return Support::Through("GL_EXT_texture_buffer");
  return Gate(140, 320);
}

}  // namespace clipc::glsl
