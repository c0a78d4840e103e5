// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/level9_binder.h"

#include <cmath>
#include <cstring>

namespace clipc::runtime {
namespace {

const BoundBuffer* FindBuffer(const TablePlane& plane, const BoundBuffer* buffers,
                              std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const BoundBuffer& buffer = buffers[i];
    if (buffer.register_number == plane.register_number &&
        buffer.register_space == plane.register_space && buffer.bytes != nullptr) {
      return &buffer;
    }
  }
  return nullptr;
}

// The plane's 16 bytes; null, with the reason in `status`, if there are none.
const unsigned char* FindPlane(const TablePlane& plane, std::uint32_t index,
                               const BoundBuffer* buffers, std::size_t count, Status& status) {
  const BoundBuffer* buffer = FindBuffer(plane, buffers, count);
  if (buffer == nullptr) {
    status = Status::Failure(Error::kMissingBuffer,
                             "clip plane %u lies in constant buffer b%u `%s`, which is not bound",
                             index, plane.register_number, plane.cbuffer.c_str());
    return nullptr;
  }
  if (buffer->size < 16 || buffer->size - 16 < plane.byte_offset) {
    status = Status::Failure(
        Error::kShortBuffer, "clip plane %u lies at bytes %u to %llu of b%u `%s`, which has %llu",
        index, plane.byte_offset, plane.byte_offset + 15ULL, plane.register_number,
        plane.cbuffer.c_str(), static_cast<unsigned long long>(buffer->size));
    return nullptr;
  }
  return static_cast<const unsigned char*>(buffer->bytes) + plane.byte_offset;
}

Status CheckFinite(const float (&plane)[4], std::uint32_t index) {
  for (const float coefficient : plane) {
    if (!std::isfinite(coefficient)) {
      return Status::Failure(Error::kNotFinite, "clip plane %u is (%g, %g, %g, %g)", index,
                             static_cast<double>(plane[0]), static_cast<double>(plane[1]),
                             static_cast<double>(plane[2]), static_cast<double>(plane[3]));
    }
  }
  return {};
}

}  // namespace

Level9Binder::Level9Binder(ClipDevice& device, std::uint32_t max_planes) noexcept
    : device_(&device), max_planes_(max_planes) {}

Status Level9Binder::Bind(const Table& table, const BoundBuffer* buffers, std::size_t buffer_count,
                          std::uint32_t needed) noexcept {
  if (table.lowering == Lowering::kNone) return BindNone();
  if (table.lowering != Lowering::kLevel9) {
    return Status::Failure(Error::kWrongLowering,
                           "the shader clips in another way; SetClipPlane is for lowering level9");
  }
  const std::uint32_t mask = table.enable_mask & needed;

  // The planes that must change. The device is told nothing until all of them are known to be good.
  float changed[kMaxClipPlanes][4];
  std::uint32_t changed_planes = 0;
  for (std::uint32_t i = 0; mask >> i != 0; ++i) {
    if ((mask >> i & 1) == 0) continue;
    if (i >= max_planes_ || i >= kMaxClipPlanes || i >= table.planes.size()) {
      return Status::Failure(Error::kInvalidCall,
                             "clip plane %u; the device has %u and the table %u", i, max_planes_,
                             static_cast<unsigned>(table.planes.size()));
    }
    Status status;
    const unsigned char* bytes = FindPlane(table.planes[i], i, buffers, buffer_count, status);
    if (bytes == nullptr) return status;
    if ((known_planes_ >> i & 1) != 0 && std::memcmp(bytes, planes_[i], sizeof(planes_[i])) == 0)
      continue;
    std::memcpy(changed[i], bytes, sizeof(changed[i]));
    if (status = CheckFinite(changed[i], i); !status.ok()) return status;
    changed_planes |= std::uint32_t{1} << i;
  }

  for (std::uint32_t i = 0; changed_planes >> i != 0; ++i) {
    const std::uint32_t bit = std::uint32_t{1} << i;
    if ((changed_planes & bit) == 0) continue;
    known_planes_ &= ~bit;
    if (!device_->SetClipPlane(i, changed[i])) {
      return Status::Failure(Error::kDeviceFailed, "the device refused SetClipPlane(%u)", i);
    }
    std::memcpy(planes_[i], changed[i], sizeof(planes_[i]));
    known_planes_ |= bit;
  }
  return Enable(mask);
}

Status Level9Binder::BindNone() noexcept { return Enable(0); }

void Level9Binder::Invalidate() noexcept {
  known_planes_ = 0;
  mask_is_known_ = false;
}

Status Level9Binder::Enable(std::uint32_t mask) noexcept {
  if (mask_is_known_ && mask_ == mask) return {};
  mask_is_known_ = false;
  if (!device_->SetClipPlaneEnable(mask)) {
    return Status::Failure(Error::kDeviceFailed, "the device refused D3DRS_CLIPPLANEENABLE = %u",
                           mask);
  }
  mask_is_known_ = true;
  mask_ = mask;
  return {};
}

}  // namespace clipc::runtime
