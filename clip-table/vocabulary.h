// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

/// The words that every room uses for clip planes. C++17, and it includes nothing of clipc, so that
/// the compiler, the clip table and an application that links clipc::runtime share one definition.
namespace clipc {

/// The number of planes that [clipplanes(...)] has at most: Direct3D 9 has D3DCS_PLANE0 to 5.
inline constexpr std::uint32_t kMaxClipPlanes = 6;

/// The way in which a compiled shader clips with its planes, which decides what the application
/// does for bit i of the clip table's enable mask. A plane keeps the vertices with dot(position,
/// plane) >= 0.
enum class Lowering : std::uint8_t {
  /// The shader writes gl_ClipDistance[i]. The application calls glEnable(GL_CLIP_DISTANCE0 + i).
  kClipDistance,
  /// The shader writes no distance, at most gl_ClipVertex. The application gives the plane to the
  /// device: SetClipPlane(i, plane) and D3DRS_CLIPPLANEENABLE, or glClipPlane.
  kLevel9,
  /// The shader ignores the planes, on the user's request. The mask is 0.
  kNone,
  /// dot(position, plane) becomes the depth, so that the test against the near plane clips. Only
  /// for one plane. The application scales the plane (runtime/near_plane.h). The mask is 0.
  kNearPlane,
  /// The shader passes the distances to the fragment shader, which discards. The mask is 0.
  kDiscard,
};

/// The space of the positions that the planes are dotted with, and so the space in which the
/// application gives the planes (docs/runtime.md, "Plane spaces").
enum class PlaneSpace : std::uint8_t {
  /// Direct3D clip space, fxc's meaning: SV_Position as the HLSL shader wrote it, y up, 0 <= z <=
  /// w, whatever the target's conventions.
  kClip,
  /// The vector (x, y, w, 1) of the position in clip space: without z, which loses digits where
  /// depth is not reversed.
  kXyw1,
  /// The object's own space: the vertex as it comes in, with w = 1 where the input is a float3.
  kObject,
};

/// Whether a shader of that lowering can dot its planes with positions of that plane space. Where
/// the device does it, and where nobody does, the planes are in clip space.
constexpr bool Supports(Lowering lowering, PlaneSpace space) noexcept {
  return space == PlaneSpace::kClip ||
         (lowering != Lowering::kLevel9 && lowering != Lowering::kNone);
}

/// An enumerator and its name: a row of a table of names.
template <typename Enum>
struct Named {
  Enum value;
  const char* name;
};

template <typename Enum, std::size_t kCount>
constexpr bool AreInOrder(const Named<Enum> (&names)[kCount]) noexcept {
  for (std::size_t i = 0; i < kCount; ++i) {
    if (static_cast<std::size_t>(names[i].value) != i) return false;
  }
  return true;
}

/// The name of `value` in a table that has a row for each enumerator, in their order.
template <const auto& kNames, typename Enum>
constexpr const char* NameIn(Enum value) noexcept {
  static_assert(AreInOrder(kNames));
  return kNames[static_cast<std::size_t>(value)].name;
}

/// The enumerator whose name in the table is `name`; no value if there is no such name.
template <typename Enum, std::size_t kCount>
constexpr std::optional<Enum> EnumeratorOf(std::string_view name,
                                           const Named<Enum> (&names)[kCount]) noexcept {
  for (const Named<Enum>& named : names) {
    if (name == named.name) return named.value;
  }
  return std::nullopt;
}

/// The spellings in --lower=, in --plane-space= and in messages. The clip table's text forms
/// spell lowerings so too, but have kTableSpaceNames for plane spaces.
inline constexpr Named<Lowering> kLoweringNames[] = {{Lowering::kClipDistance, "clip-distance"},
                                                     {Lowering::kLevel9, "level9"},
                                                     {Lowering::kNone, "none"},
                                                     {Lowering::kNearPlane, "near-plane"},
                                                     {Lowering::kDiscard, "discard"}};
inline constexpr Named<PlaneSpace> kPlaneSpaceNames[] = {
    {PlaneSpace::kClip, "clip"}, {PlaneSpace::kXyw1, "xyw1"}, {PlaneSpace::kObject, "object"}};

constexpr const char* NameOf(Lowering lowering) noexcept {
  return NameIn<kLoweringNames>(lowering);
}
constexpr const char* NameOf(PlaneSpace space) noexcept { return NameIn<kPlaneSpaceNames>(space); }

constexpr std::optional<Lowering> ParseLowering(std::string_view name) noexcept {
  return EnumeratorOf(name, kLoweringNames);
}
constexpr std::optional<PlaneSpace> ParsePlaneSpace(std::string_view name) noexcept {
  return EnumeratorOf(name, kPlaneSpaceNames);
}

}  // namespace clipc
