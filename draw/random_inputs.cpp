// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "draw/random_inputs.h"

#include <algorithm>
#include <cstring>

#include "draw/memory.h"
#include "ir/scalar.h"

namespace clipc::draw {
namespace {

class Values {
 public:
  explicit Values(const RandomOptions& options) : options_(options), random_(options.seed) {}

  std::uint32_t Next(ir::Scalar kind) {
    switch (kind) {
      case ir::Scalar::kBool: return Below(2);
      case ir::Scalar::kInt: return static_cast<std::uint32_t>(Int(options_.least_int));
      case ir::Scalar::kUint: return static_cast<std::uint32_t>(Int(std::max(options_.least_int, 0)));
      default: return static_cast<std::uint32_t>(ir::BitsOf(Float()));
    }
  }

 private:
  // mt19937's numbers are the same everywhere; the standard distributions are not.
  std::uint32_t Below(std::uint32_t limit) { return static_cast<std::uint32_t>(random_() % limit); }
  int Int(int least) {
    const std::int64_t count = std::int64_t{options_.greatest_int} - least + 1;
    return static_cast<int>(least + std::int64_t{Below(static_cast<std::uint32_t>(count))});
  }
  float Float() {
    if (Below(4) == 0) return static_cast<float>(static_cast<int>(Below(5)) - 2);
    return static_cast<float>(Below(1u << 24)) * 0x1p-22f - 2.0f;
  }

  RandomOptions options_;
  std::mt19937 random_;
};

ir::IoBits ValueOf(const ir::Program& program, const ir::IoVar& input, Values& values) {
  const ir::Type& type = program.types[program.vars[input.var].type];
  ir::IoBits bits{};
  for (std::uint32_t i = 0; i < type.Components(); ++i) bits[i] = values.Next(ir::BaseOf(type.scalar));
  return bits;
}

// What the draw call gives. Direct3D counts vertices and instances from 0 wherever the draw call starts.
void SetBuiltins(const ir::Program& program, const RandomOptions& options, int run, std::vector<ir::IoBits>& inputs) {
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const ir::Builtin builtin = program.inputs[i].builtin;
    if (builtin == ir::Builtin::kNone) continue;
    inputs[i] = {};
    const auto set = [&](ir::Builtin which, int value) {
      if (builtin == which) inputs[i][0] = static_cast<std::uint64_t>(value);
    };
    set(ir::Builtin::kVertexId, run % options.vertices);
    set(ir::Builtin::kInstanceId, run / options.vertices);
    set(ir::Builtin::kVertexIndex, options.first_vertex + run % options.vertices);
    set(ir::Builtin::kInstanceIndex, options.base_instance + run / options.vertices);
    set(ir::Builtin::kBaseVertex, options.first_vertex);
    set(ir::Builtin::kBaseInstance, options.base_instance);
  }
}

}  // namespace

RandomInputs MakeRandomInputs(const ir::Program& program, const RandomOptions& options) {
  Values values(options);
  RandomInputs inputs;
  for (const ir::CbufferId id : program.cbuffers.ids()) {
    const ir::Cbuffer& cbuffer = program.cbuffers[id];
    std::vector<std::uint8_t>& bytes = inputs.cbuffers.emplace_back(std::size_t{cbuffer.size} * cbuffer.count);
    for (const ir::CbufferMember& member : cbuffer.members) {
      const ir::Var& var = program.vars[member.var];
      const bool is_array_of_buffers = cbuffer.count > 1;
      const ir::TypeId type = is_array_of_buffers ? program.types[var.type].element : var.type;
      for (std::uint32_t i = 0; i < cbuffer.count; ++i) {
        ForEachComponent(program.types, type, var.row_major, member.offset + i * cbuffer.size,
                         [&](ir::Scalar kind, std::uint32_t byte) {
                           const std::uint32_t word = values.Next(kind);
                           std::memcpy(&bytes.at(byte), &word, 4);
                         });
      }
    }
  }
  for (int vertex = 0; vertex < options.vertices; ++vertex) {
    std::vector<ir::IoBits>& attributes = inputs.vertices.emplace_back();
    for (const ir::IoVar& input : program.inputs) attributes.push_back(ValueOf(program, input, values));
  }
  for (int run = 0; run < options.vertices * options.instances; ++run) {
    if (run >= options.vertices) inputs.vertices.push_back(inputs.vertices[run % options.vertices]);
    SetBuiltins(program, options, run, inputs.vertices[run]);
  }
  return inputs;
}

}  // namespace clipc::draw
