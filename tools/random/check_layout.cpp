// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/random/check_layout.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "tools/draw/memory.h"
#include "tools/random/layout.h"

namespace clipc::random {
namespace {

std::vector<std::uint32_t> BytesOf(const ir::Program& program, const ir::CbufferMember& member) {
  const ir::Var& var = program.vars[member.var];
  std::vector<std::uint32_t> bytes;
  draw::ForEachComponent(program.types, var.type, var.row_major, member.offset,
                         [&](ir::Scalar, std::uint32_t byte) { bytes.push_back(byte); });
  return bytes;
}

std::string Numbers(const std::vector<std::uint32_t>& bytes) {
  std::string text;
  for (std::size_t i = 0; i < bytes.size() && i < 12; ++i) text += " " + std::to_string(bytes[i]);
  return text;
}

}  // namespace

std::string LayoutProblem(const Program& program, const ir::Program& checked) {
  for (const ir::CbufferId id : checked.cbuffers.ids()) {
    const ir::Cbuffer& cbuffer = checked.cbuffers[id];
    const auto buffer = std::ranges::find(program.buffers, cbuffer.name, &ConstantBuffer::name);
    if (buffer == program.buffers.end()) return "no buffer is called `" + cbuffer.name + "`";
    const std::vector<std::vector<std::uint32_t>> all = OffsetsOf(program.structs, *buffer);
    for (const ir::CbufferMember& member : cbuffer.members) {
      const std::string& name = checked.vars[member.var].name;
      const auto declared = std::ranges::find(buffer->members, name, &Member::name);
      if (declared == buffer->members.end()) return "`" + cbuffer.name + "` has no `" + name + "`";
      const auto& expected = all[static_cast<std::size_t>(declared - buffer->members.begin())];
      const std::vector<std::uint32_t> bytes = BytesOf(checked, member);
      if (bytes != expected)
        return "the components of `" + name + "` lie elsewhere:" + Numbers(bytes) + "; expected" +
               Numbers(expected);
    }
  }
  return {};
}

}  // namespace clipc::random
