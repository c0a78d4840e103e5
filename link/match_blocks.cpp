// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <string>
#include <string_view>

#include "ir/access.h"
#include "link/match_inputs.h"
#include "link/members.h"
#include "link/names.h"

namespace clipc::link {
namespace {

// The name without underscores at its ends, which tools add to names that GLSL reserves.
std::string_view Stem(std::string_view name) {
  while (name.starts_with('_')) name.remove_prefix(1);
  while (name.ends_with('_')) name.remove_suffix(1);
  return name;
}

// The name by which buffers of two tools are compared: glslang calls HLSL's $Globals `$Global`, and
// DXC writes `type.` before a buffer's name.
std::string BlockKey(std::string_view name) {
  std::string key = GlslNameOf(name);
  if (key.starts_with("type_")) key.erase(0, 5);
  key = Stem(key);
  return key == "Globals" ? "Global" : key;
}

// Whether both members have one type. A bool is a uint in memory, and most compilers declare it
// so.
bool IsSameType(const UniformMember& ours, const UniformMember& theirs) {
  if (ours.type == theirs.type) return true;
  if (!ours.type || ours.type->scalar != ir::Scalar::kBool || !ours.type->dimensions.empty())
    return false;
  GlslType as_uint = *ours.type;
  as_uint.scalar = ir::Scalar::kUint;
  return theirs.type == as_uint;
}

// Names the first member that differs; empty if both lists are the same.
std::string Difference(const std::vector<UniformMember>& ours,
                       const std::vector<UniformMember>& theirs) {
  for (std::size_t i = 0; i < std::max(ours.size(), theirs.size()); ++i) {
    if (i >= theirs.size()) return ours[i].name;
    if (i >= ours.size()) return theirs[i].name;
    const UniformMember& a = ours[i];
    const UniformMember& b = theirs[i];
    const bool is_same = Stem(GlslNameOf(a.name)) == Stem(GlslNameOf(b.name)) && IsSameType(a, b) &&
                         a.struct_dimensions == b.struct_dimensions &&
                         (!b.offset || a.offset == b.offset) &&
                         (a.matrices == b.matrices || a.matrices == ir::MatrixLayout::kNone);
    if (!is_same) return a.name;
    const std::string inner = Difference(a.fields, b.fields);
    if (!inner.empty()) return a.name + "." + inner;
  }
  return {};
}

// Returns whether the members are the same; if not, reports the first that differs, except for
// Vulkan.
bool IsSame(const ir::Cbuffer& cbuffer, const std::vector<UniformMember>& ours,
            const UniformBlock& theirs, const MatchOptions& options, Diagnostics& diagnostics) {
  const std::string difference = Difference(ours, theirs.members);
  if (difference.empty() || options.is_vulkan) return difference.empty();
  const bool is_of_file = cbuffer.kind == ir::CbufferKind::kGlobals;
  diagnostics
      .Report(cbuffer.span, is_of_file ? diag::PixelGlobalsDiffer : diag::PixelBlockDiffers,
              cbuffer.name, difference)
      .Note({}, diag::PixelBlockHere, theirs.where, theirs.name);
  return false;
}

// Matches members that the pixel shader has as variables, which must have their types.
Matches::Buffer MatchLoose(const ir::Cbuffer& cbuffer, const std::vector<UniformMember>& ours,
                           const std::vector<UniformMember>& uniforms, Diagnostics& diagnostics) {
  Matches::Buffer match;
  for (const UniformMember& member : ours) {
    const auto found = std::ranges::find(uniforms, member.name, &UniformMember::name);
    const bool is_loose = found != uniforms.end();
    match.precisions.push_back(is_loose ? found->precision : ir::Precision::kHigh);
    if (!is_loose) continue;
    match.is_loose = true;
    if (found->type != member.type)
      diagnostics.Report(cbuffer.span, diag::PixelBlockDiffers, cbuffer.name, member.name);
  }
  return match;
}

// Whether any function mentions each variable, by VarId.
std::vector<bool> Mentioned(const ir::Program& program) {
  std::vector<bool> is_mentioned(program.vars.size());
  for (const ir::FunctionId function : program.functions.ids()) {
    ir::ForEachExpr(program, program.functions[function].body, [&](ir::ExprId id) {
      if (const auto* ref = ir::As<ir::VarRef>(program, id)) is_mentioned[ref->var.index] = true;
    });
  }
  return is_mentioned;
}

// Reports the first used member below `highp`: in OpenGL ES both stages declare a variable with one
// precision, by which a vertex shader may lose digits.
void ReportPrecision(const ir::Cbuffer& cbuffer, const std::vector<UniformMember>& ours,
                     const std::vector<ir::Precision>& theirs, const std::vector<bool>& is_used,
                     Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < ours.size(); ++i) {
    // A ConstantBuffer<T> is one variable.
    const ir::VarId var = cbuffer.members[std::min(i, cbuffer.members.size() - 1)].var;
    if (theirs[i] == ir::Precision::kHigh || !is_used[var.index]) continue;
    const char* const name = theirs[i] == ir::Precision::kLow ? "lowp" : "mediump";
    diagnostics.Report(cbuffer.span, diag::PixelPrecision, ours[i].name, cbuffer.name, name);
    return;
  }
}

}  // namespace

std::vector<Matches::Buffer> MatchBlocks(const ir::Program& program, const Interface& pixel,
                                         const MatchOptions& options, Diagnostics& diagnostics) {
  std::vector<Matches::Buffer> buffers(program.cbuffers.size());
  const std::vector<bool> is_used = options.is_es ? Mentioned(program) : std::vector<bool>();
  for (const ir::CbufferId id : program.cbuffers.ids()) {
    const ir::Cbuffer& cbuffer = program.cbuffers[id];
    const std::vector<UniformMember> members = MembersOf(program, cbuffer);
    const std::string key = BlockKey(cbuffer.name);
    const auto block = std::ranges::find_if(pixel.blocks, [&](const UniformBlock& candidate) {
      return BlockKey(candidate.name) == key;
    });
    Matches::Buffer& buffer = buffers[id.index];
    if (block == pixel.blocks.end()) {
      buffer = MatchLoose(cbuffer, members, pixel.uniforms, diagnostics);
    } else if (IsSame(cbuffer, members, *block, options, diagnostics)) {
      buffer.block = static_cast<std::size_t>(block - pixel.blocks.begin());
      for (const UniformMember& member : block->members)
        buffer.precisions.push_back(member.precision);
    }
    if (options.is_es && (buffer.block || buffer.is_loose))
      ReportPrecision(cbuffer, members, buffer.precisions, is_used, diagnostics);
  }
  return buffers;
}

}  // namespace clipc::link
