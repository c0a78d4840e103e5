// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <cstring>

#include "effect-runtime/effect_gl.h"

namespace clipc::runtime::gl {
namespace {

enum : unsigned {
  kFront = 0x0404,
  kBack = 0x0405,
  kFrontAndBack = 0x0408,
  kClockwise = 0x0900,
  kCullFace = 0x0B44,
  kDepthTest = 0x0B71,
  kStencilTest = 0x0B90,
  kBlend = 0x0BE2,
  kScissorTest = 0x0C11,
  kFill = 0x1B02,
  kKeep = 0x1E00,
  kVersion = 0x1F02,
  kPolygonOffsetPoint = 0x2A01,
  kPolygonOffsetLine = 0x2A02,
  kPolygonOffsetFill = 0x8037,
  kMultisample = 0x809D,
  kSampleAlphaToCoverage = 0x809E,
  kDepthClamp = 0x864F,
  kFramebufferSrgb = 0x8DB9,
  kSampleMask = 0x8E51,
  kAlways = 0x0207,
  kLessOrEqual = 0x0203,
  kAdd = 0x8006,
  kZero = 0,
  kOne = 1,
};
constexpr std::uint32_t kFloatOne = 0x3F800000;

// What Direct3D 9 begins with, except that nothing of its fixed functions is there.
constexpr std::uint32_t DefaultOf(std::uint32_t state) noexcept {
  switch (state) {
    case CLIPC_GL_DEPTH_TEST:
    case CLIPC_GL_DEPTH_WRITE:
    case CLIPC_GL_MULTISAMPLE: return 1;
    case CLIPC_GL_DEPTH_FUNC: return kLessOrEqual;
    case CLIPC_GL_CULL_FACE: return kBack;
    case CLIPC_GL_FRONT_FACE: return kClockwise;
    case CLIPC_GL_POLYGON_MODE: return kFill;
    case CLIPC_GL_SAMPLE_MASK:
    case CLIPC_GL_STENCIL_READ_MASK:
    case CLIPC_GL_STENCIL_WRITE_MASK: return ~0U;
    case CLIPC_GL_BLEND_SOURCE:
    case CLIPC_GL_BLEND_SOURCE_ALPHA: return kOne;
    case CLIPC_GL_BLEND_EQUATION:
    case CLIPC_GL_BLEND_EQUATION_ALPHA: return kAdd;
    case CLIPC_GL_BLEND_RED:
    case CLIPC_GL_BLEND_GREEN:
    case CLIPC_GL_BLEND_BLUE:
    case CLIPC_GL_BLEND_ALPHA: return kFloatOne;
    case CLIPC_GL_COLOR_MASK_0:
    case CLIPC_GL_COLOR_MASK_1:
    case CLIPC_GL_COLOR_MASK_2:
    case CLIPC_GL_COLOR_MASK_3: return 15;
    case CLIPC_GL_STENCIL_FUNC:
    case CLIPC_GL_STENCIL_BACK_FUNC: return kAlways;
    case CLIPC_GL_STENCIL_FAIL:
    case CLIPC_GL_STENCIL_DEPTH_FAIL:
    case CLIPC_GL_STENCIL_PASS:
    case CLIPC_GL_STENCIL_BACK_FAIL:
    case CLIPC_GL_STENCIL_BACK_DEPTH_FAIL:
    case CLIPC_GL_STENCIL_BACK_PASS: return kKeep;
    default: return kZero;
  }
}

class States {
 public:
  States(const EffectFunctions& gl, const clipc_gl_effect_state* states,
         std::uint32_t count) noexcept
      : gl_(gl) {
    for (std::uint32_t i = 0; i < CLIPC_GL_STATE_COUNT; ++i) values_[i] = DefaultOf(i);
    for (std::uint32_t i = 0; i < count; ++i) {
      if (states[i].state < CLIPC_GL_STATE_COUNT) values_[states[i].state] = states[i].value;
    }
  }

  std::uint32_t operator[](std::uint32_t state) const noexcept { return values_[state]; }

  void Apply() const noexcept {
    Rasterizer();
    Depth();
    Stencil();
    Blend();
  }

 private:
  float Float(std::uint32_t state) const noexcept {
    float value = 0;
    std::memcpy(&value, &values_[state], sizeof value);
    return value;
  }

  void Switch(unsigned capability, bool on) const noexcept {
    (on ? gl_.basic.Enable : gl_.basic.Disable)(capability);
  }
  // Of a capability that OpenGL ES does not have.
  void SwitchDesktop(unsigned capability, bool on) const noexcept {
    if (!gl_.is_es) Switch(capability, on);
  }

  void Rasterizer() const noexcept {
    const std::uint32_t cull = values_[CLIPC_GL_CULL_FACE];
    Switch(kCullFace, cull != 0);
    if (cull != 0) gl_.CullFace(cull);
    gl_.FrontFace(values_[CLIPC_GL_FRONT_FACE]);
    if (gl_.PolygonMode) gl_.PolygonMode(kFrontAndBack, values_[CLIPC_GL_POLYGON_MODE]);
    const float bias = Float(CLIPC_GL_DEPTH_BIAS), slope = Float(CLIPC_GL_SLOPE_DEPTH_BIAS);
    const bool is_moved = bias != 0 || slope != 0;
    Switch(kPolygonOffsetFill, is_moved);
    SwitchDesktop(kPolygonOffsetLine, is_moved);
    SwitchDesktop(kPolygonOffsetPoint, is_moved);
    gl_.PolygonOffset(slope, bias);
    Switch(kScissorTest, values_[CLIPC_GL_SCISSOR_TEST] != 0);
    SwitchDesktop(kDepthClamp, values_[CLIPC_GL_DEPTH_CLAMP] != 0);
    SwitchDesktop(kMultisample, values_[CLIPC_GL_MULTISAMPLE] != 0);
    Switch(kSampleAlphaToCoverage, values_[CLIPC_GL_ALPHA_TO_COVERAGE] != 0);
    SwitchDesktop(kFramebufferSrgb, values_[CLIPC_GL_SRGB_WRITE] != 0);
    if (!gl_.SampleMaski) return;
    Switch(kSampleMask, values_[CLIPC_GL_SAMPLE_MASK] != ~0U);
    gl_.SampleMaski(0, values_[CLIPC_GL_SAMPLE_MASK]);
  }

  void Depth() const noexcept {
    Switch(kDepthTest, values_[CLIPC_GL_DEPTH_TEST] != 0);
    gl_.DepthMask(values_[CLIPC_GL_DEPTH_WRITE] != 0);
    gl_.DepthFunc(values_[CLIPC_GL_DEPTH_FUNC]);
  }

  void Stencil() const noexcept {
    Switch(kStencilTest, values_[CLIPC_GL_STENCIL_TEST] != 0);
    gl_.StencilMask(values_[CLIPC_GL_STENCIL_WRITE_MASK]);
    const std::uint32_t back = values_[CLIPC_GL_STENCIL_TWO_SIDED] != 0 ? CLIPC_GL_STENCIL_BACK_FUNC
                                                                        : CLIPC_GL_STENCIL_FUNC;
    StencilSide(kFront, CLIPC_GL_STENCIL_FUNC);
    StencilSide(kBack, back);
  }

  // `first` is the first of the four states of a side.
  void StencilSide(unsigned face, std::uint32_t first) const noexcept {
    gl_.StencilFuncSeparate(face, values_[first],
                            static_cast<int>(values_[CLIPC_GL_STENCIL_REFERENCE]),
                            values_[CLIPC_GL_STENCIL_READ_MASK]);
    gl_.StencilOpSeparate(face, values_[first + 1], values_[first + 2], values_[first + 3]);
  }

  void Blend() const noexcept {
    Switch(kBlend, values_[CLIPC_GL_BLEND] != 0);
    const std::uint32_t alpha = values_[CLIPC_GL_BLEND_SEPARATE_ALPHA] != 0
                                    ? CLIPC_GL_BLEND_SOURCE_ALPHA
                                    : CLIPC_GL_BLEND_SOURCE;
    gl_.BlendFuncSeparate(values_[CLIPC_GL_BLEND_SOURCE], values_[CLIPC_GL_BLEND_TARGET],
                          values_[alpha], values_[alpha + 1]);
    gl_.BlendEquationSeparate(values_[CLIPC_GL_BLEND_EQUATION], values_[alpha + 2]);
    gl_.BlendColor(Float(CLIPC_GL_BLEND_RED), Float(CLIPC_GL_BLEND_GREEN),
                   Float(CLIPC_GL_BLEND_BLUE), Float(CLIPC_GL_BLEND_ALPHA));
    const auto bit = [&](std::uint32_t target, int i) {
      return static_cast<unsigned char>(values_[CLIPC_GL_COLOR_MASK_0 + target] >> i & 1U);
    };
    gl_.ColorMask(bit(0, 0), bit(0, 1), bit(0, 2), bit(0, 3));
    if (!gl_.ColorMaski) return;
    for (std::uint32_t i = 1; i < 4; ++i)
      gl_.ColorMaski(i, bit(i, 0), bit(i, 1), bit(i, 2), bit(i, 3));
  }

  const EffectFunctions& gl_;
  std::uint32_t values_[CLIPC_GL_STATE_COUNT] = {};
};

}  // namespace

std::uint32_t ApplyStates(const EffectFunctions& gl, const clipc_gl_effect_state* states,
                          std::uint32_t count) noexcept {
  const States all(gl, states, count);
  all.Apply();
  return all[CLIPC_GL_CLIP_PLANES];
}

Result<EffectFunctions> LoadEffectFunctions(Loader loader) noexcept {
  const Result<Functions> basic = LoadFunctions(loader);
  if (!basic.ok()) return basic.status;
  EffectFunctions gl;
  gl.basic = basic.value;
#define CLIPC_GL_LOAD(result, name, arguments) \
  gl.name = reinterpret_cast<decltype(gl.name)>(loader("gl" #name));
  CLIPC_GL_EFFECT_FUNCTIONS(CLIPC_GL_LOAD)
  CLIPC_GL_EFFECT_EXTRAS(CLIPC_GL_LOAD)
#undef CLIPC_GL_LOAD
#define CLIPC_GL_REQUIRE(result, name, arguments) \
  if (!gl.name)                                   \
    return Status::Failure(Error::kDeviceFailed, "the loader does not find gl%s", #name);
  CLIPC_GL_EFFECT_FUNCTIONS(CLIPC_GL_REQUIRE)
#undef CLIPC_GL_REQUIRE
  const auto get_string =
      reinterpret_cast<const char*(CLIPC_GL_API*)(unsigned)>(loader("glGetString"));
  const char* version = get_string ? get_string(kVersion) : nullptr;
  gl.is_es = version != nullptr && std::strncmp(version, "OpenGL ES", 9) == 0;
  // A loader may give an address for a function that the context does not have.
  if (gl.is_es) gl.PolygonMode = nullptr, gl.SampleMaski = nullptr, gl.ColorMaski = nullptr;
  return gl;
}

}  // namespace clipc::runtime::gl
