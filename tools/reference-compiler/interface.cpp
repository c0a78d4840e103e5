// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/reference-compiler/interface.h"

#include <algorithm>

#include "tools/draw/feed.h"
#include "tools/draw/textures.h"
#include "tools/draw/vulkan/bind.h"

namespace clipc::draw::reference_compiler {
namespace {

using namespace ir;

const Reads::Binding* FindBinding(const Reads& reads, const std::string& name) {
  const auto found = std::ranges::find(reads.bindings, name, &Reads::Binding::name);
  return found == reads.bindings.end() ? nullptr : &*found;
}

// The program with ordinary inputs in place of the built-in ones that the reference compiler takes
// for ordinary.
Program WithReferenceInputs(const Program& program, const std::vector<const Vector*>& vectors) {
  Program changed = program;
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    if (vectors[i]) changed.inputs[i].builtin = Builtin::kNone;
  }
  return changed;
}

// The places where the reference compiler's shader reads the inputs and objects of the program,
// under the names of the HLSL.
GlslInfo InfoOf(const Program& program, const Reads& reads,
                const std::vector<const Vector*>& vectors, const RandomInputs& random) {
  GlslInfo info;
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    GlslInfo::Variable& variable = info.inputs.emplace_back();
    variable.name = "input" + std::to_string(i);
    if (vectors[i]) variable.location = vectors[i]->location;
  }
  for (const Resource& resource : program.resources) {
    const std::string& name = program.vars[resource.var].name;
    const Reads::Binding* binding = FindBinding(reads, name);
    if (!binding) continue;
    const bool is_read =
        random.textures.contains(resource.var.index) || random.buffers.contains(resource.var.index);
    info.objects.push_back({{binding->set, binding->binding},
                            is_read ? resource.var : VarId{},
                            is_read ? VarId{} : resource.var,
                            name});
  }
  return info;
}

// Adds the reference compiler's blocks to the draw call. A block that holds several cbuffers gets
// the members of each.
void GiveBlocks(const Program& program, const Module& module, const Reads& reads,
                const RandomInputs& random, DrawCall& call) {
  for (const ReferenceBlock& block : module.blocks) {
    const Reads::Binding* binding = FindBinding(reads, block.name);
    if (!binding) continue;
    std::vector<Bytes> elements(1, Bytes(block.size));
    for (const CbufferId id : program.cbuffers.ids()) {
      const Cbuffer& cbuffer = program.cbuffers[id];
      if (Find(module.blocks, cbuffer) != &block) continue;
      elements.resize(cbuffer.count, elements[0]);
      for (std::uint32_t i = 0; i < cbuffer.count; ++i) {
        Relocate(program, cbuffer, block,
                 random.cbuffers[id.index].data() + std::size_t{i} * cbuffer.size, elements[i]);
      }
    }
    using enum DescriptorKind;
    for (std::uint32_t i = 0; i < elements.size(); ++i) {
      call.descriptors.push_back({binding->set, binding->binding, i,
                                  block.is_storage ? kStorage : kUniforms, std::move(elements[i])});
    }
  }
}

// The key of a built-in output. All clip distances are one array, and all cull distances are
// another.
std::string KeyOfBuiltin(const Output& output) {
  if (output.name == "gl_ClipDistance") return "SV_CLIPDISTANCE0";
  if (output.name == "gl_CullDistance") return "SV_CULLDISTANCE0";
  const std::size_t digits = output.semantic.find_last_not_of("0123456789") + 1;
  return digits < output.semantic.size() ? output.semantic : KeyOf(output.semantic, 0);
}

// The captured vector at that location; it has no words if no output is there.
Captured PartAt(const std::vector<Output>& outputs, const std::vector<Captured>& captured,
                std::uint32_t location) {
  Captured part;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (!outputs[i].location || location < *outputs[i].location) continue;
    const std::size_t size = outputs[i].layout.rows, whole = outputs[i].Words();
    const std::size_t first = (location - *outputs[i].location) * size;
    if (first >= whole) continue;
    part.layout = outputs[i].layout;
    part.layout.columns = 1;
    for (std::size_t at = first; at < captured[i].words.size(); at += whole) {
      for (std::size_t k = 0; k < size; ++k) part.words.push_back(captured[i].words[at + k]);
    }
  }
  return part;
}

}  // namespace

std::vector<const Vector*> Match(const IoVars& list, const std::vector<Vector>& vectors) {
  std::vector<const Vector*> matches(list.size());
  std::vector<bool> taken(vectors.size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    for (std::size_t k = 0; k < vectors.size() && !matches[i]; ++k) {
      if (taken[k] || vectors[k].key != KeyOf(list[i].semantic, list[i].index)) continue;
      matches[i] = &vectors[k];
      taken[k] = true;
    }
  }
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!matches[i] && list[i].builtin == Builtin::kNone) left.push_back(i);
  }
  if (static_cast<std::ptrdiff_t>(left.size()) !=
      std::ranges::count(vectors, std::string(), &Vector::key))
    return matches;
  std::size_t next = 0;
  for (const Vector& vector : vectors) {
    if (vector.key.empty()) matches[left[next++]] = &vector;
  }
  return matches;
}

DrawCall MakeDrawCall(const Program& program, const Module& module, const RandomInputs& random,
                      const RandomOptions& draw) {
  const Reads reads = vulkan::ReadsOf(module.run);
  const std::vector<const Vector*> vectors = Match(program.inputs, module.inputs);
  const Program changed = WithReferenceInputs(program, vectors);
  const GlslInfo info = InfoOf(changed, reads, vectors, random);
  RandomInputs relocated = random;
  for (const Resource& resource : program.resources) {
    const auto elements = std::ranges::find(module.elements, program.vars[resource.var].name,
                                            &ReferenceElements::name);
    if (elements == module.elements.end() ||
        !IsStructured(ObjectTypeOf(program, resource.var).object))
      continue;
    for (Buffer& buffer : relocated.buffers[resource.var.index])
      buffer = Relocated(program, resource.var, *elements, buffer);
  }
  DrawCall call = vulkan::MakeDrawCall(changed, info, MakeInputs(changed, info, relocated, draw));
  GiveBlocks(program, module, reads, random, call);
  return call;
}

std::vector<Captured> PickOutputs(const Program& program, const Module& module,
                                  const std::vector<Output>& outputs,
                                  const std::vector<Captured>& captured) {
  const std::vector<const Vector*> vectors = Match(program.outputs, module.outputs);
  std::vector<Captured> picked;
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    if (vectors[i]) {
      picked.push_back(PartAt(outputs, captured, vectors[i]->location));
      continue;
    }
    const std::string key = KeyOf(program.outputs[i].semantic, program.outputs[i].index);
    Captured& found = picked.emplace_back();
    for (std::size_t k = 0; k < outputs.size(); ++k) {
      if (!outputs[k].location && KeyOfBuiltin(outputs[k]) == key) found = captured[k];
    }
  }
  return picked;
}

}  // namespace clipc::draw::reference_compiler
