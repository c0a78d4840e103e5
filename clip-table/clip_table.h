// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "vocabulary.h"

/// The clip table: what an application must know about a shader's clip planes to draw with it. It
/// says which constants hold the planes, where these constants lie, and what to enable. A plane
/// keeps the vertices with dot(position, plane) >= 0.
namespace clipc::clip_table {

/// The place where the application finds a plane: one whole float4 register of a constant buffer.
struct Constant {
  std::string cbuffer;  ///< as written; "$Globals" for uniforms outside any cbuffer
  /// For an array of ConstantBuffers, the element that holds the plane; otherwise 0.
  std::uint32_t cbuffer_element = 0;
  std::uint32_t register_number = 0;  ///< n of b<n>; the element of an array is already added
  std::uint32_t register_space = 0;
  std::uint32_t float4_register = 0;  ///< m of cb<n>[m]: the 16-byte row in the buffer
  std::uint32_t byte_offset = 0;      ///< 16 * float4_register
  std::string glsl_block;             ///< the uniform block in the GLSL; empty for a plain uniform
  /// The member or uniform, "water_plane" or "planes[2]"; empty if the shader does not read it.
  std::string glsl_member;
  friend bool operator==(const Constant&, const Constant&) = default;
};

struct Plane {
  std::uint32_t index = 0;           ///< the operand's position: planes[i].index == i
  std::string text;                  ///< the operand as written: "planes[2]"
  std::optional<Constant> constant;  ///< none when the operand is composed: float4(a, b, c, d)
  friend bool operator==(const Plane&, const Plane&) = default;
};

struct ClipTable {
  std::string entry;    ///< the entry function
  std::string profile;  ///< "vs_4_0_level_9_1"
  Lowering lowering = Lowering::kClipDistance;
  PlaneSpace plane_space = PlaneSpace::kClip;
  std::uint32_t enable_mask = 0;  ///< EnableMask(lowering, planes.size())
  std::vector<Plane> planes;
  friend bool operator==(const ClipTable&, const ClipTable&) = default;
};

/// The bits of the clip distances to enable: (1 << planes) - 1 where the device clips, otherwise 0.
/// A clip distance that is enabled but not written is undefined in OpenGL.
constexpr std::uint32_t EnableMask(Lowering lowering, std::size_t planes) {
  const bool device_clips = lowering == Lowering::kClipDistance || lowering == Lowering::kLevel9;
  return device_clips ? (std::uint32_t{1} << planes) - 1 : 0;
}

/// The meaning of a plane's length, as the text forms spell it. "any": only the sign of
/// dot(position, plane) counts. "depth": dot(position, plane) becomes z, and where it exceeds w,
/// the far plane clips. The application then scales the plane so that dot(v, plane) <= w at the
/// corners v of the frustum's far side (Lengyel, "Oblique view frustum depth projection and
/// clipping"), and must have the eye on the clipped side. A plane of zeros clips nothing but leaves
/// no depth.
constexpr const char* PlaneScaleOf(Lowering lowering) {
  return lowering == Lowering::kNearPlane ? "depth" : "any";
}

/// A plane space as the text forms spell it. They say "direct3d-clip" for what the command line
/// calls "clip", and "position_space" for what clipc calls plane space: both are part of the
/// format.
inline constexpr Named<PlaneSpace> kTableSpaceNames[] = {{PlaneSpace::kClip, "direct3d-clip"},
                                                         {PlaneSpace::kXyw1, "xyw1"},
                                                         {PlaneSpace::kObject, "object"}};
constexpr const char* TableNameOf(PlaneSpace space) { return NameIn<kTableSpaceNames>(space); }
constexpr std::optional<PlaneSpace> ParseTableSpace(std::string_view name) {
  return EnumeratorOf(name, kTableSpaceNames);
}

/// Describes the first contradiction in the table; returns an empty text for a good table. Readers
/// and writers refuse a table that is not good.
std::string ProblemOf(const ClipTable& table);

/// The reason why a value cannot be made, in words.
struct Problem {
  std::string what;
};

/// A value, or the problem that keeps it from being made. Functions that return one throw nothing
/// but std::bad_alloc.
template <typename T>
struct Result {
  std::optional<T> value;
  std::string error;  ///< not empty exactly when there is no value

  Result(T made) : value(std::move(made)) {}
  Result(Problem problem) : error(std::move(problem.what)) {}

  explicit operator bool() const { return value.has_value(); }
  T& operator*() { return *value; }
  const T& operator*() const { return *value; }
  T* operator->() { return &*value; }
  const T* operator->() const { return &*value; }
};

enum class Format : std::uint8_t { kJson, kBinary, kHeader };
/// The format that the extension of `path` names: .json; .bin; .h, .hpp or .inc. Returns nullopt
/// for another extension.
std::optional<Format> FormatOf(std::string_view path);

}  // namespace clipc::clip_table
