// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

// The dialects of GLSL that clipc writes, and what each of them can say. Sources: the GLSL
// specifications 1.20 to 4.60, GLSL ES 3.00 to 3.20, KHR_vulkan_glsl, and the extensions named.
namespace clipc::glsl {

enum class Api : std::uint8_t { kOpenGL, kOpenGLES, kVulkan };

// How a target has a feature: not at all, in its core, or through an extension that the shader must
// name.
class Support {
 public:
  static constexpr Support No() { return {false, ""}; }
  static constexpr Support Core() { return {true, ""}; }
  static constexpr Support Through(std::string_view extension) { return {true, extension}; }
  constexpr explicit operator bool() const { return has_; }
  constexpr std::string_view extension() const { return extension_; }

 private:
  constexpr Support(bool has, std::string_view extension) : has_(has), extension_(extension) {}
  bool has_;
  std::string_view extension_;
};

class Target {
 public:
  // "glsl450", "essl300", "vulkan"; nothing for a name that is none.
  static std::optional<Target> Parse(std::string_view name);
  static std::span<const std::string_view> Names();

  std::string_view name() const { return name_; }
  Api api() const { return api_; }
  bool IsVulkan() const { return api_ == Api::kVulkan; }
  bool IsEs() const { return api_ == Api::kOpenGLES; }
  int version() const { return version_; }  // as in the #version line
  std::string VersionLine() const;          // "#version 300 es"

  // ---- interface
  bool HasInAndOut() const { return AtLeast(130, 300); }  // else `attribute` and `varying`
  bool HasInputLocations() const { return AtLeast(330, 300); }
  bool HasOutputLocations() const { return AtLeast(410, 310); }
  bool HasIntegerVaryings() const { return AtLeast(130, 300); }
  bool HasDoubleVaryings() const { return AtLeast(410, kNever); }
  bool HasNoPerspective() const { return AtLeast(130, kNever); }
  bool HasCentroid() const { return AtLeast(120, 300); }
  Support PerSample() const;  // `sample out`

  // ---- uniforms
  bool HasUniformBlocks() const { return AtLeast(140, 300); }  // else plain uniforms, set by name
  bool HasBlockInstances() const { return AtLeast(150, 300); }
  bool HasExplicitOffsets() const { return AtLeast(440, kNever); }
  bool HasBindings() const { return AtLeast(420, 310); }
  // Images that shaders write. OpenGL ES has them too, and asks for no vertex shader to have any.
  bool HasImages() const { return AtLeast(420, kNever); }
  bool HasStorageBuffers() const { return AtLeast(430, 310); }
  bool HasDynamicBlockIndex() const {
    return AtLeast(400, 320);
  }  // of arrays of blocks and of samplers

  // ---- built-in variables
  Support ClipDistance() const;
  Support CullDistance() const;
  bool HasClipVertex() const { return api_ == Api::kOpenGL && version_ <= 130; }
  bool HasVertexId() const { return AtLeast(130, 300); }
  Support InstanceId() const;
  Support DrawParameters() const;  // gl_BaseVertex, gl_BaseInstance, gl_DrawID
  // Whether a draw call can have a base vertex that gl_VertexID includes: OpenGL 3.2 and OpenGL ES
  // 3.2 brought it.
  bool HasBaseVertexDraws() const { return AtLeast(150, 320); }
  Support LayerAndViewport() const;
  Support ViewIndex() const;
  Support ShadingRate() const;

  // ---- types and expressions
  bool HasUnsigned() const {
    return AtLeast(130, 300);
  }  // uint, % << >> & | ^ ~, and int overloads of functions
  bool HasSwitch() const { return AtLeast(130, 300); }
  bool HasArraysOfArrays() const {
    return AtLeast(430, 310);
  }  // else the inner array is wrapped in a struct
  bool HasGlobalInitializers() const { return !IsEs(); }  // that are no constant expressions
  bool HasPrecise() const { return AtLeast(400, 320); }
  Support Doubles() const;
  Support Int64() const;
  Support BitCasts() const;
  bool HasDoublePacking() const { return AtLeast(400, kNever); }
  bool HasHalfPacking() const { return AtLeast(420, 300); }
  bool HasBitFunctions() const {
    return AtLeast(400, 310);
  }  // bitCount, findMSB, findLSB, bitfieldReverse
  bool HasBoolMix() const { return AtLeast(130, 300); }     // mix(float, float, bool)
  bool HasIntegerMix() const { return AtLeast(450, 310); }  // mix of int, uint and bool
  bool HasRounding() const {
    return AtLeast(130, 300);
  }  // roundEven, trunc, modf, isnan, isinf, sinh ..
  bool HasDeterminant() const { return AtLeast(150, 300); }

  // ---- textures
  bool HasTextureFunctions() const {
    return AtLeast(130, 300);
  }  // textureLod, texelFetch, textureSize; integer samplers
  bool HasTextureArrays() const { return AtLeast(130, 300); }
  bool Has1D() const { return !IsEs(); }
  Support CubeArrays() const;
  bool HasMultisample() const { return AtLeast(150, 310); }
  Support MultisampleArrays() const;
  Support TextureBuffers() const;
  bool HasGather() const { return AtLeast(400, 310); }
  Support GatherOffsets() const;  // one offset for each of the four texels
  bool HasTextureLevels() const { return AtLeast(430, kNever); }
  bool HasTextureSamples() const { return AtLeast(450, kNever); }

 private:
  static constexpr int kNever = 10000;
  Target(std::string_view name, Api api, int version) : name_(name), api_(api), version_(version) {}
  // Vulkan's GLSL has what OpenGL 4.6 has, where both have it.
  bool AtLeast(int desktop, int es) const { return version_ >= (IsEs() ? es : desktop); }
  Support Gate(int desktop, int es) const {
    return AtLeast(desktop, es) ? Support::Core() : Support::No();
  }

  std::string_view name_;
  Api api_;
  int version_;
};

}  // namespace clipc::glsl
