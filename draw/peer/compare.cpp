// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "draw/peer/compare.h"

#include <algorithm>
#include <cctype>

#include "draw/feed.h"
#include "draw/options.h"
#include "draw/vulkan/bind.h"
#include "draw/vulkan/glslang.h"

namespace clipc::draw::peer {
namespace {

// Both of its forms, and what they say.
struct Module {
  vulkan::Spirv declared, run;
  std::vector<Block> blocks;
  std::vector<Vector> inputs, outputs;
};

Module Compile(const BuildOptions& options) {
  vulkan::HlslSource source{options.path, ReadFile(options.path), options.entry, options.defines, options.include_dirs};
  source.row_major = options.packing == MatrixPacking::kRowMajor;
  Module module;
  module.declared = vulkan::SpirvOfHlsl(source, false);
  module.run = vulkan::SpirvOfHlsl(source, true);
  module.blocks = BlocksOf(module.declared);
  module.inputs = InputsOf(module.declared);
  module.outputs = OutputsOf(module.declared);
  return module;
}

std::string SemanticOf(const ir::IoVar& io) {
  std::string name = io.semantic;
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return name + std::to_string(io.index);
}

const vulkan::Reads::Binding* FindBinding(const vulkan::Reads& reads, const std::string& name) {
  const auto found = std::ranges::find(reads.bindings, name, &vulkan::Reads::Binding::name);
  return found == reads.bindings.end() ? nullptr : &*found;
}

// The peer's shader in the terms of clipc's: where its inputs are, and under which names they are given.
glsl::GlslInfo InfoOf(const ir::Program& program, const Module& module, const RandomInputs& random) {
  const vulkan::Reads reads = vulkan::ReadsOf(module.run);
  glsl::GlslInfo info;
  for (const ir::IoVar& input : program.inputs) {
    glsl::GlslInfo::Variable& variable = info.inputs.emplace_back();
    variable.name = SemanticOf(input);
    const auto found = std::ranges::find(module.inputs, variable.name, &Vector::semantic);
    if (found != module.inputs.end()) variable.location = found->location;
  }
  for (const ir::CbufferId id : program.cbuffers.ids()) {
    const Block* block = Find(module.blocks, program.cbuffers[id]);
    const vulkan::Reads::Binding* binding = block ? FindBinding(reads, block->name) : nullptr;
    if (!binding) continue;
    glsl::GlslInfo::Block& written = info.blocks.emplace_back();
    written.cbuffer = id;
    written.name = program.cbuffers[id].name;
    written.set = binding->set;
    written.binding = binding->binding;
  }
  for (const ir::Resource& resource : program.resources) {
    const std::string& name = program.vars[resource.var].name;
    const vulkan::Reads::Binding* binding = FindBinding(reads, name);
    if (!binding) continue;
    const bool is_read = random.textures.contains(resource.var.index) || random.buffers.contains(resource.var.index);
    info.objects.push_back({is_read ? resource.var : ir::VarId{}, is_read ? ir::VarId{} : resource.var, name, binding->set, binding->binding});
  }
  return info;
}

// The constants where the peer reads them.
void Relocate(const ir::Program& program, const glsl::GlslInfo& info, const std::vector<Block>& blocks, const RandomInputs& random,
              vulkan::DrawCall& call) {
  for (const glsl::GlslInfo::Block& written : info.blocks) {
    const ir::Cbuffer& cbuffer = program.cbuffers[written.cbuffer];
    const Block& block = *Find(blocks, cbuffer);
    for (vulkan::DrawCall::Descriptor& descriptor : call.descriptors) {
      if (descriptor.kind != vulkan::DrawCall::Kind::kUniforms || descriptor.set != written.set || descriptor.binding != written.binding) continue;
      const std::uint8_t* bytes = random.cbuffers[written.cbuffer.index].data() + std::size_t{descriptor.element} * cbuffer.size;
      descriptor.bytes = Relocated(program, cbuffer, block, bytes);
      if (block.is_storage) descriptor.kind = vulkan::DrawCall::Kind::kStorage;
    }
  }
}

// Takes arrays and matrices apart, as clipc does: one for each semantic. What is built in keeps its name.
std::vector<Captured> Split(const std::vector<vulkan::Output>& outputs, const std::vector<Captured>& captured, const std::vector<Vector>& vectors) {
  std::vector<Captured> all;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (!outputs[i].location) {
      all.push_back(captured[i]);
      continue;
    }
    const auto size = static_cast<std::size_t>(outputs[i].shape.rows), whole = static_cast<std::size_t>(outputs[i].Words());
    for (std::uint32_t k = 0; k < whole / size; ++k) {
      const auto found = std::ranges::find(vectors, *outputs[i].location + k, &Vector::location);
      if (found == vectors.end()) continue;
      Captured& part = all.emplace_back(Captured{found->semantic, outputs[i].shape, 1, {}});
      part.shape.columns = 1;
      for (std::size_t at = k * size; at < captured[i].words.size(); at += whole) {
        part.words.insert(part.words.end(), captured[i].words.begin() + static_cast<std::ptrdiff_t>(at),
                          captured[i].words.begin() + static_cast<std::ptrdiff_t>(at + size));
      }
    }
  }
  return all;
}

}  // namespace

PeerComparison CompareWithGlslang(const vulkan::Runner& runner, const Shader& shader, const BuildOptions& options,
                                  const std::vector<Expected>& expected, const RandomInputs& random, const RandomOptions& draw,
                                  const Tolerance& tolerance) {
  const ir::Program& program = shader.lowered;
  const Module module = Compile(options);
  PeerComparison result;
  result.layout = CompareLayout(program, module.blocks);
  const glsl::GlslInfo info = InfoOf(program, module, random);
  const Inputs inputs = MakeInputs(program, info, random, draw);
  vulkan::DrawCall call = vulkan::MakeDrawCall(program, info, inputs);
  Relocate(program, info, module.blocks, random, call);

  const std::vector<vulkan::Output> outputs = vulkan::OutputsOf(module.run);
  const std::vector<Captured> captured = Split(outputs, runner.Capture(module.run, outputs, call), module.outputs);
  const std::vector<const Expected*> defined = Defined(expected);
  std::vector<Captured> matching;
  for (const Expected* output : defined) {
    const ir::IoVar& io = program.outputs[static_cast<std::size_t>(output - expected.data())];
    const auto find = [&](const std::string& name) { return std::ranges::find(captured, name, &Captured::name); };
    const auto found = find(io.builtin == ir::Builtin::kNone ? SemanticOf(io) : output->name);
    matching.push_back(found == captured.end() ? Captured{} : *found);
  }
  result.values = CompareOutputs(defined, matching, tolerance);
  return result;
}

}  // namespace clipc::draw::peer
