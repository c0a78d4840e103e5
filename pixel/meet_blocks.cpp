// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <string>
#include <string_view>

#include "base/spelling.h"
#include "pixel/meet_inputs.h"
#include "pixel/members.h"
#include "pixel/names.h"

namespace clipc::pixel {
namespace {

// Tools write names that GLSL reserves with an underscore more.
std::string_view Stem(std::string_view name) {
  while (name.starts_with('_')) name.remove_prefix(1);
  while (name.ends_with('_')) name.remove_suffix(1);
  return name;
}

// glslang calls HLSL's $Globals `$Global`, and DXC writes `type.` before a buffer's name.
std::string BlockKey(std::string_view name) {
  std::string key = GlslNameOf(name);
  if (key.starts_with("type_")) key.erase(0, 5);
  key = Stem(key);
  return key == "Globals" ? "Global" : key;
}

// A bool is a uint in memory, and most compilers declare it so.
bool IsSameShape(const Member& ours, const Member& theirs) {
  if (ours.shape == theirs.shape) return true;
  if (!ours.shape || ours.shape->scalar != ir::Scalar::kBool || !ours.shape->dimensions.empty())
    return false;
  Shape as_uint = *ours.shape;
  as_uint.scalar = ir::Scalar::kUint;
  return theirs.shape == as_uint;
}

// Names the first member that differs; empty when both lists are the same.
std::string Difference(const std::vector<Member>& ours, const std::vector<Member>& theirs) {
  for (std::size_t i = 0; i < std::max(ours.size(), theirs.size()); ++i) {
    if (i >= theirs.size()) return ours[i].name;
    if (i >= ours.size()) return theirs[i].name;
    const Member& a = ours[i];
    const Member& b = theirs[i];
    const bool is_same = Stem(GlslNameOf(a.name)) == Stem(GlslNameOf(b.name)) &&
                         IsSameShape(a, b) && a.struct_dimensions == b.struct_dimensions &&
                         (!b.offset || a.offset == b.offset) &&
                         (a.matrices == b.matrices || a.matrices == MatrixLayout::kNone);
    if (!is_same) return a.name;
    const std::string inner = Difference(a.fields, b.fields);
    if (!inner.empty()) return a.name + "." + inner;
  }
  return {};
}

// Reports what differs; returns whether nothing does.
bool IsSame(const ir::Cbuffer& cbuffer, const std::vector<Member>& ours, const Block& theirs,
            const MeetOptions& options, Diagnostics& diagnostics) {
  const std::string difference = Difference(ours, theirs.members);
  if (difference.empty() || options.is_vulkan) return difference.empty();
  const bool is_of_file = cbuffer.kind == ir::CbufferKind::kGlobals;
  diagnostics
      .Report(cbuffer.span, is_of_file ? diag::PixelGlobalsDiffer : diag::PixelBlockDiffers,
              cbuffer.name, difference)
      .Note({}, diag::PixelBlockHere, theirs.where, theirs.name);
  return false;
}

// Whether the pixel shader has members of the buffer as variables, which must have their types.
bool IsLoose(const ir::Cbuffer& cbuffer, const std::vector<Member>& ours,
             const std::vector<Member>& uniforms, Diagnostics& diagnostics) {
  bool is_loose = false;
  for (const Member& member : ours) {
    const auto found = std::ranges::find(uniforms, member.name, &Member::name);
    if (found == uniforms.end()) continue;
    is_loose = true;
    if (found->shape != member.shape)
      diagnostics.Report(cbuffer.span, diag::PixelBlockDiffers, cbuffer.name, member.name);
  }
  return is_loose;
}

}  // namespace

std::vector<Meeting::Buffer> MeetBlocks(const ir::Program& program, const Interface& pixel,
                                        const MeetOptions& options, Diagnostics& diagnostics) {
  std::vector<Meeting::Buffer> met(program.cbuffers.size());
  for (const ir::CbufferId id : program.cbuffers.ids()) {
    const ir::Cbuffer& cbuffer = program.cbuffers[id];
    const std::vector<Member> members = MembersOf(program, cbuffer);
    const std::string key = BlockKey(cbuffer.name);
    const auto block = std::ranges::find_if(
        pixel.blocks, [&](const Block& candidate) { return BlockKey(candidate.name) == key; });
    if (block == pixel.blocks.end()) {
      met[id.index].is_loose = IsLoose(cbuffer, members, pixel.uniforms, diagnostics);
    } else if (IsSame(cbuffer, members, *block, options, diagnostics)) {
      met[id.index].block = static_cast<std::size_t>(block - pixel.blocks.begin());
    }
  }
  return met;
}

}  // namespace clipc::pixel
