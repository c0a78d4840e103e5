// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>

#include "clip_device.h"
#include "status.h"
#include "table.h"

namespace clipc::runtime {

/// The bytes of one bound constant buffer, as the application passed them to the shader.
struct BoundBuffer {
  std::uint32_t register_number = 0;  ///< n of b<n>
  std::uint32_t register_space = 0;
  const void* bytes = nullptr;  ///< of any alignment; read only during the call
  std::size_t size = 0;
};

/// The part of the 10Level9 runtime that turns a shader's clip table into SetClipPlane calls
/// (Microsoft, "User clip planes on feature level 9 hardware"). The binder remembers the state of
/// the device and calls it only for a change, bit for bit: if nothing changed, Bind makes no call.
/// The binder never allocates.
///
/// One binder belongs to one device and, like the device, to one thread at a time. Code that
/// changes the device's clip planes or D3DRS_CLIPPLANEENABLE by other means calls Invalidate()
/// afterwards.
class Level9Binder {
 public:
  /// `max_planes`: D3DCAPS9::MaxUserClipPlanes. `device` must outlive the binder.
  Level9Binder(ClipDevice& device, std::uint32_t max_planes) noexcept;

  /// Makes the device clip with the planes of `table`, read from `buffers`; call it before a draw.
  /// Sets the planes first, the mask last. A table of lowering kNone disables all planes. Planes
  /// whose bit in `needed` is 0, because the object does not need them (box_planner.h), are not
  /// read, checked or set. After an error the caller must not draw:
  ///
  ///   kWrongLowering                    the table is for another lowering
  ///   kInvalidCall                      a plane's index is not below max_planes
  ///   kMissingBuffer, kShortBuffer      no buffer, or too few bytes, for a plane
  ///   kNotFinite                        a plane with NaN or infinity
  ///   kDeviceFailed                     the device refused a call; the next Bind repeats it
  ///
  /// Every error but kDeviceFailed is found before the first call and leaves the device unchanged.
  Status Bind(const Table& table, const BoundBuffer* buffers, std::size_t buffer_count,
              std::uint32_t needed = ~std::uint32_t{0}) noexcept;

  /// Disables all planes; call it before a draw with a shader without clip planes. Errors:
  /// kDeviceFailed.
  Status BindNone() noexcept;

  /// Forgets the state of the device, so that the next Bind sets everything; call it after the
  /// device was lost or reset, or after other code changed its clip state.
  void Invalidate() noexcept;

 private:
  Status Enable(std::uint32_t mask) noexcept;

  ClipDevice* device_;
  std::uint32_t max_planes_;
  std::uint32_t known_planes_ = 0;  ///< bit i: the device holds the four floats of planes_[i]
  bool mask_is_known_ = false;
  std::uint32_t mask_ = 0;
  unsigned char planes_[kMaxClipPlanes][16] = {};
};

}  // namespace clipc::runtime
