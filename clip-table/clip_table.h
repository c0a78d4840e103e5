// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The clip table: what an application must know about a shader's clip planes to draw with it. Which
// constants hold the planes, where they lie, and what to enable. A plane keeps the vertices with
// dot(position, plane) >= 0.
namespace clipc::clip_table {

// The limit of [clipplanes(...)] and of Direct3D 9.
inline constexpr std::size_t kMaxPlanes = 6;

// How the shader was lowered, and so what the application does for bit i of the enable mask.
enum class Lowering : std::uint8_t {
  kClipDistance,  // the shader writes gl_ClipDistance[i]: glEnable(GL_CLIP_DISTANCE0 + i)
  // the shader writes no distance: SetClipPlane(i, plane) and D3DRS_CLIPPLANEENABLE, or glClipPlane
  kLevel9,
  kNone,       // the planes are ignored; nothing to enable
  kNearPlane,  // the one plane takes the near plane's place; see PlaneScale::kDepth
  kDiscard,    // the fragment shader discards what is clipped; nothing to enable
};

// Which lengths of a plane mean the same.
enum class PlaneScale : std::uint8_t {
  kAny,  // only the sign of dot(position, plane) counts
  // dot(position, plane) becomes z: where it exceeds w, the far plane clips. The application scales
  // the plane so
  kDepth,
  // that dot(v, plane) <= w at the corners v of the frustum's far side (Lengyel, "Oblique view
  // frustum depth projection and clipping"), and must have the eye on the clipped side. A plane of
  // zeros clips nothing but leaves no depth.
};

// The space of the position that the planes are dotted with, and so the space an application must
// give them in.
enum class PositionSpace : std::uint8_t {
  // SV_Position as the HLSL shader wrote it: y up, 0 <= z <= w, whatever the target's conventions
  kDirect3DClip,
  // (x, y, w, 1) of that position: without z, which loses digits where depth is not reversed
  kXyw1,
  kObject,  // the vertex as it comes in, w = 1 where the input is a float3: the object's own space
};

// Where the application finds the plane: one whole float4 register of a constant buffer.
struct Constant {
  std::string cbuffer;                // as written; "$Globals" for uniforms outside any cbuffer
  std::uint32_t cbuffer_element = 0;  // which buffer of an array of ConstantBuffers
  std::uint32_t register_number = 0;  // n of b<n>, the element of an array already added
  std::uint32_t register_space = 0;
  std::uint32_t float4_register = 0;  // m of cb<n>[m]: the 16-byte row in the buffer
  std::uint32_t byte_offset = 0;      // 16 * float4_register
  std::string glsl_block;             // the uniform block in the GLSL; empty: a plain uniform
  std::string
      glsl_member;  // the member or uniform: "water_plane", "planes[2]"; empty: the shader does not read it
  friend bool operator==(const Constant&, const Constant&) = default;
};

struct Plane {
  std::uint32_t index = 0;           // of the operand: planes[i].index == i
  std::string text;                  // the operand as written: "planes[2]"
  std::optional<Constant> constant;  // none when the operand is composed: float4(a, b, c, d)
  friend bool operator==(const Plane&, const Plane&) = default;
};

struct ClipTable {
  std::string entry;    // the entry function
  std::string profile;  // "vs_4_0_level_9_1"
  Lowering lowering = Lowering::kClipDistance;
  PositionSpace position_space = PositionSpace::kDirect3DClip;
  std::uint32_t enable_mask = 0;  // EnableMask(lowering, planes.size())
  std::vector<Plane> planes;
  friend bool operator==(const ClipTable&, const ClipTable&) = default;
};

// (1 << planes) - 1 where the device clips, else 0: what is enabled but not written is undefined in
// OpenGL.
constexpr std::uint32_t EnableMask(Lowering lowering, std::size_t planes) {
  const bool device_clips = lowering == Lowering::kClipDistance || lowering == Lowering::kLevel9;
  return device_clips ? (std::uint32_t{1} << planes) - 1 : 0;
}

// Whether a shader of that lowering can dot its planes with positions of that space: where the
// device does it, and where nobody does, the planes are in clip space.
constexpr bool KnowsSpace(Lowering lowering, PositionSpace space) {
  return space == PositionSpace::kDirect3DClip ||
         (lowering != Lowering::kLevel9 && lowering != Lowering::kNone);
}

constexpr PlaneScale PlaneScaleOf(Lowering lowering) {
  return lowering == Lowering::kNearPlane ? PlaneScale::kDepth : PlaneScale::kAny;
}

// "clip-distance", "level9", "none", "near-plane", "discard"; "direct3d-clip", "xyw1", "object";
// "any", "depth": the spelling in every text form.
std::string_view NameOf(Lowering lowering);
std::string_view NameOf(PositionSpace space);
std::string_view NameOf(PlaneScale scale);
std::optional<Lowering> ParseLowering(std::string_view name);
std::optional<PositionSpace> ParsePositionSpace(std::string_view name);

// What makes a table contradict itself, in words; empty for a good one. Readers and writers refuse
// what this refuses.
std::string ProblemOf(const ClipTable& table);

// A value, or what stands in its way, in words. Nothing here throws.
template <typename T>
struct Result {
  std::optional<T> value;
  std::string error;  // not empty exactly when there is no value

  explicit operator bool() const { return value.has_value(); }
  T& operator*() { return *value; }
  const T& operator*() const { return *value; }
  T* operator->() { return &*value; }
  const T* operator->() const { return &*value; }

  static Result Error(std::string what) { return {std::nullopt, std::move(what)}; }
};

enum class Format : std::uint8_t { kJson, kBinary, kHeader };
// By the file's extension: .json; .bin; .h, .hpp, .inc. Nothing for another.
std::optional<Format> FormatOf(std::string_view path);

}  // namespace clipc::clip_table
