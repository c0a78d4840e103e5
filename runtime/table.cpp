// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/table.h"

#include <exception>

#include "clip-table/read.h"

namespace clipc::runtime {
namespace {

TablePlane FromPlane(const clip_table::Plane& from) {
  TablePlane plane;
  plane.text = from.text;
  plane.in_register = from.constant.has_value();
  if (!from.constant) return plane;
  plane.cbuffer = from.constant->cbuffer;
  plane.register_number = from.constant->register_number;
  plane.register_space = from.constant->register_space;
  plane.byte_offset = from.constant->byte_offset;
  plane.glsl_block = from.constant->glsl_block;
  plane.glsl_member = from.constant->glsl_member;
  return plane;
}

// Runs `read`, which gives a clip_table::Result. Its only other failure is a lack
// of memory.
template <typename Read>
Result<Table> ReadWith(Read read) noexcept {
  try {
    const clip_table::Result<clip_table::ClipTable> result = read();
    if (!result.value.has_value())
      return Status::Failure(Error::kDamagedTable, "%s", result.error.c_str());
    const clip_table::ClipTable& from = *result.value;
    Result<Table> table;
    table.value.entry = from.entry;
    table.value.profile = from.profile;
    table.value.lowering = from.lowering;
    table.value.plane_space = from.plane_space;
    table.value.enable_mask = from.enable_mask;
    for (const clip_table::Plane& plane : from.planes)
      table.value.planes.push_back(FromPlane(plane));
    return table;
  } catch (const std::exception&) {
    return Status::Failure(Error::kOutOfMemory, "no memory to read the clip table");
  }
}

// A header that clipc wrote has no null pointer; a StaticClipTable that was zeroed or never filled
// has.
bool HasNull(const StaticClipTable& table) {
  if (!table.entry || !table.profile || !table.lowering || !table.position_space) return true;
  for (unsigned i = 0; i < table.plane_count && i < kMaxClipPlanes; ++i) {
    const StaticClipPlane& plane = table.planes[i];
    if (!plane.text || !plane.cbuffer || !plane.glsl_block || !plane.glsl_member) return true;
  }
  return false;
}

}  // namespace

Result<Table> ReadTable(const void* bytes, std::size_t size) noexcept {
  if (bytes == nullptr)
    return Status::Failure(Error::kInvalidArgument, "no bytes to read a clip table from");
  return ReadWith([&] { return clip_table::Read({static_cast<const char*>(bytes), size}); });
}

Result<Table> ReadTable(const StaticClipTable& table) noexcept {
  if (HasNull(table))
    return Status::Failure(Error::kDamagedTable, "a name in the clip table is a null pointer");
  return ReadWith([&] { return clip_table::FromStatic(table); });
}

}  // namespace clipc::runtime
