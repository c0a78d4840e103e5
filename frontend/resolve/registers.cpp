// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/resolve/registers.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <vector>

namespace clipc::resolve {
namespace {

// A cbuffer or resource that takes registers: `count` in a row, or all from its first on if `count`
// is 0.
struct Taker {
  Register* reg;
  std::uint32_t count;
  std::string_view name;
  Span span;
};

// The number of the last register in Direct3D 11; shader model 5.1 lifts the limits.
std::uint32_t HighestRegister(char letter, const Profile& profile) {
  // ps_2_0 to ps_3_0 have s0 to s15: "Pixel shader registers" of the Direct3D 9 reference.
  if (letter == 's' && profile.IsDirect3D9() && profile.stage == Stage::kPixel) return 15;
  if (profile.IsAtLeast(5, 1) || profile.IsDirect3D9()) return 0xfffffffeu;
  // D3D11_1_UAV_SLOT_COUNT is 64.
  return letter == 'b' ? 13 : letter == 's' ? 15 : letter == 'u' ? 63 : 127;
}

class Allocator {
 public:
  // Before 5.1 the views of a pixel shader's unordered access follow its `targets` (vkd3d's
  // uav-rwtexture.shader_test, checked against fxc). One bound before is fxc's X4509, "UAV
  // registers live in the same name space as outputs".
  Allocator(const Profile& profile, std::uint32_t targets, Diagnostics& diagnostics)
      : profile_(profile),
        first_view_(profile.IsAtLeast(5, 1) ? 0 : targets),
        diagnostics_(diagnostics) {}

  void Run(std::vector<Taker>& takers, std::span<const ReservedRegisters> reserved) {
    for (Taker& taker : takers) {
      if (taker.reg->is_explicit) Occupy(taker);
    }
    for (const ReservedRegisters& each : reserved) Reserve(each);
    for (Taker& taker : takers) {
      if (!taker.reg->is_explicit && taker.count != 0) Choose(taker);
    }
    for (Taker& taker : takers) {
      if (!taker.reg->is_explicit && taker.count == 0) Choose(taker);
    }
  }

 private:
  using Key = std::tuple<char, std::uint32_t, std::uint32_t>;  // letter, space, first register
  struct Range {
    std::uint32_t first, count;
    const Taker* taker;  // null: the registers are reserved
    std::uint64_t End() const { return std::uint64_t{first} + count; }
  };

  static std::string Written(const Register& reg) {
    std::string text = fmt::format("{}{}", reg.letter, reg.number);
    if (reg.space != 0) text += fmt::format(", space{}", reg.space);
    return text;
  }

  // What has a register of [first, first + count); null if nothing has.
  const Range* Overlap(char letter, std::uint32_t space, std::uint64_t first,
                       std::uint64_t count) const {
    auto next =
        taken_.upper_bound(Key{letter, space, static_cast<std::uint32_t>(first + count - 1)});
    if (next == taken_.begin()) return nullptr;
    --next;
    const auto& [next_letter, next_space, start] = next->first;
    const bool shares = next_letter == letter && next_space == space && next->second.End() > first;
    return shares ? &next->second : nullptr;
  }

  // Takes what is still free of the registers.
  void Reserve(const ReservedRegisters& reserved) {
    const Register& reg = reserved.first;
    const std::uint64_t beyond = std::uint64_t{HighestRegister(reg.letter, profile_)} + 1;
    const std::uint64_t end =
        reserved.count == 0 ? beyond : std::min(beyond, std::uint64_t{reg.number} + reserved.count);
    for (std::uint64_t at = reg.number; at < end;) {
      if (const Range* other = Overlap(reg.letter, reg.space, at, 1)) {
        at = other->End();
        continue;
      }
      const auto first = static_cast<std::uint32_t>(at);
      const auto next = taken_.upper_bound(Key{reg.letter, reg.space, first});
      const bool is_near = next != taken_.end() && std::get<0>(next->first) == reg.letter &&
                           std::get<1>(next->first) == reg.space;
      at = is_near ? std::min(end, std::uint64_t{next->second.first}) : end;
      taken_.emplace(Key{reg.letter, reg.space, first},
                     Range{first, static_cast<std::uint32_t>(at - first), nullptr});
    }
  }

  void Occupy(Taker& taker) {
    const Register& reg = *taker.reg;
    const std::uint32_t highest = HighestRegister(reg.letter, profile_);
    if (taker.count == 0) taker.count = highest - std::min(reg.number, highest) + 1;
    const std::uint64_t last = std::uint64_t{reg.number} + taker.count - 1;
    if (last > highest) {
      diagnostics_.Report(taker.span, diag::RegisterTooHigh, Written(reg), taker.name, highest);
      return;
    }
    if (reg.letter == 'u' && reg.number < first_view_) {
      diagnostics_.Report(taker.span, diag::RegisterOfTarget, taker.name, reg.number, first_view_);
      return;
    }
    if (const Range* range = Overlap(reg.letter, reg.space, reg.number, taker.count)) {
      const Taker* other = range->taker;
      // Of an array without a size only the beginning was chosen.
      if (!other) return;
      diagnostics_.Report(taker.span, diag::RegisterTwice, other->name, taker.name, Written(reg))
          .Note(other->span, diag::DeclaredHere, other->name);
      return;
    }
    taken_.emplace(Key{reg.letter, reg.space, reg.number}, Range{reg.number, taker.count, &taker});
  }

  void Choose(Taker& taker) {
    Register& reg = *taker.reg;
    const std::uint32_t least = std::max(taker.count, 1u);
    std::uint32_t& first = first_free_[Key{reg.letter, reg.space, least}];
    if (reg.letter == 'u') first = std::max(first, first_view_);
    while (const Range* other = Overlap(reg.letter, reg.space, first, least))
      first = static_cast<std::uint32_t>(other->End());
    reg.number = first;
    Occupy(taker);
  }

  const Profile& profile_;
  std::uint32_t first_view_;
  Diagnostics& diagnostics_;
  std::map<Key, Range> taken_;
  // The register before which no run of `count` free registers begins, by letter, space and count.
  std::map<Key, std::uint32_t> first_free_;
};

// One more than the highest number of a render target.
std::uint32_t TargetCount(const Program& program) {
  std::uint32_t count = 0;
  if (InfoOf(program.stage).has_stage_after) return count;
  for (const IoVar& output : program.outputs) {
    if (output.builtin == Builtin::kNone) count = std::max(count, output.location + 1);
  }
  return count;
}

}  // namespace

std::uint32_t RegisterCount(const TypeTable& types, TypeId type) {
  std::uint32_t count = 1;
  for (; types[type].kind == TypeKind::kArray; type = types[type].element)
    count *= types[type].count;
  return count;
}

void AssignRegisters(Program& program, std::span<const ReservedRegisters> reserved,
                     Diagnostics& diagnostics) {
  // fxc's order: $Globals, $Params, the others as declared (vkd3d's hlsl_d3d12.c, test_reflection,
  // checked against fxc). Push constants need a register only if they become a buffer.
  const auto rank = [&](CbufferId id) {
    const Cbuffer& buffer = program.cbuffers[id];
    return buffer.is_push_constant                ? 3
           : buffer.kind == CbufferKind::kGlobals ? 0
           : buffer.kind == CbufferKind::kParams  ? 1
                                                  : 2;
  };
  std::vector<CbufferId> order;
  order.reserve(program.cbuffers.size());
  for (CbufferId id : program.cbuffers.ids()) order.push_back(id);
  if (order.size() > 1) std::ranges::stable_sort(order, {}, rank);
  std::vector<Taker> takers;
  takers.reserve(order.size() + program.resources.size());
  for (CbufferId id : order) {
    Cbuffer& buffer = program.cbuffers[id];
    if (buffer.kind == CbufferKind::kTbuffer) buffer.reg.letter = 't';
    takers.push_back({&buffer.reg, buffer.count, buffer.name, buffer.span});
  }
  for (Resource& resource : program.resources) {
    const Var& var = program.vars[resource.var];
    takers.push_back({&resource.reg, RegisterCount(program.types, var.type), var.name, var.span});
  }
  Allocator(program.profile, TargetCount(program), diagnostics).Run(takers, reserved);
}

}  // namespace clipc::resolve
