// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/vulkan/bind.h"

#include <algorithm>

#include "ir/scalar.h"
#include "tools/draw/memory.h"
#include "tools/draw/surface.h"
#include "tools/draw/textures.h"
#include "tools/draw/vulkan/driver_bugs.h"

namespace clipc::draw::vulkan {
namespace {

using namespace ir;

template <typename Value>
const Value& Find(const std::vector<Value>& values, const std::string& name) {
  const auto found = std::ranges::find(values, name, &Value::name);
  if (found == values.end()) throw DrawError("`" + name + "` has no value");
  return *found;
}

std::uint32_t Require(const std::optional<std::uint32_t>& number, const std::string& name) {
  if (!number) throw DrawError("nothing says where `" + name + "` is bound");
  return *number;
}

class Binder {
 public:
  Binder(const Program& program, const Inputs& inputs, DrawCall& call)
      : program_(program), inputs_(inputs), call_(call) {}

  void Bind(const GlslInfo::UniformBlock& block) {
    if (block.is_push_constant) {
      call_.push_constants = Find(inputs_.blocks, block.name).bytes;
      return;
    }
    const std::vector<std::string> names = BlockNames(program_, block);
    for (std::uint32_t i = 0; i < names.size(); ++i)
      Add(block, {names[i], i}, DescriptorKind::kUniforms).bytes =
          Find(inputs_.blocks, names[i]).bytes;
  }

  void Bind(const GlslInfo::Object& object) {
    const VarId var = object.texture ? object.texture : object.sampler;
    const ObjectKind kind = ObjectTypeOf(program_, var).object;
    const std::vector<std::string> indices = ElementIndices(program_, var);
    for (std::uint32_t i = 0; i < indices.size(); ++i) {
      const std::string name = object.name + indices[i];
      if (!object.texture) {
        Add(object, {name, i}, DescriptorKind::kSampler).compares = InfoOf(kind).compares;
      } else if (IsStorageBuffer(kind)) {
        Add(object, {name, i}, DescriptorKind::kStorage).bytes = Find(inputs_.storage, name).bytes;
      } else {
        const bool is_image = IsImage(kind);
        const bool is_buffer = InfoOf(kind).category == ObjectCategory::kTypedBuffer;
        const DescriptorKind how = is_image && is_buffer         ? DescriptorKind::kImageTexels
                                   : is_image                    ? DescriptorKind::kImage
                                   : kind == ObjectKind::kBuffer ? DescriptorKind::kTexels
                                   : IsSampler(kind) ? DescriptorKind::kTextureWithSampler
                                                     : DescriptorKind::kTexture;
        DrawCall::Descriptor& added = Add(object, {name, i}, how);
        added.texture = Find(inputs_.textures, name);
        added.compares = InfoOf(kind).compares;
      }
    }
  }

 private:
  struct Element {
    const std::string& name;
    std::uint32_t index;
  };
  template <typename Written>
  DrawCall::Descriptor& Add(const Written& written, const Element& element, DescriptorKind kind) {
    return call_.descriptors.emplace_back(
        DrawCall::Descriptor{.set = Require(written.set, written.name),
                             .binding = Require(written.binding, written.name),
                             .element = element.index,
                             .kind = kind,
                             .name = element.name});
  }

  const Program& program_;
  const Inputs& inputs_;
  DrawCall& call_;
};

WordKind AttributeKind(const Program& program, const IoVar& input) {
  const Scalar kind = BaseOf(program.types[program.vars[input.var].type].scalar);
  if (kind == Scalar::kDouble) throw DrawError("an attribute of doubles, which no test draws with");
  return kind == Scalar::kBool ? WordKind::kUint : KindOfTexels(kind);
}

void AddAttributes(const Program& program, const GlslInfo& info, const Inputs& inputs,
                   DrawCall& call) {
  const bool draws_pixels = clipc::InfoOf(program.stage).draws_pixels;
  if (clipc::InfoOf(program.stage).reads_vertices) return;  // tools/draw/pass_on.h gives them
  if (draws_pixels)
    call.attributes.push_back(
        {0, WordKind::kFloat, Find(inputs.attributes, NameOfFeed(std::nullopt)).words});
  for (std::size_t i = 0; i < program.inputs.size(); ++i) {
    if (program.inputs[i].builtin != Builtin::kNone) continue;
    const GlslInfo::Variable& written = info.inputs.at(i);
    const WordKind kind = AttributeKind(program, program.inputs[i]);
    if (draws_pixels) {
      call.attributes.push_back(
          {static_cast<std::uint32_t>(i) + 1, kind, Find(inputs.attributes, NameOfFeed(i)).words});
    } else {
      call.attributes.push_back({Require(written.location, written.name), kind,
                                 Find(inputs.attributes, written.name).words});
    }
  }
}

}  // namespace

DrawCall MakeDrawCall(const Program& program, const GlslInfo& info, const Inputs& inputs) {
  RefuseDriverBugs(program);
  DrawCall call;
  call.vertices = inputs.vertices;
  call.instances = inputs.instances;
  call.first_vertex = inputs.first_vertex;
  call.base_instance = inputs.base_instance;
  AddAttributes(program, info, inputs, call);
  Binder binder(program, inputs, call);
  for (const GlslInfo::UniformBlock& block : info.blocks) binder.Bind(block);
  for (const GlslInfo::Object& object : info.objects) binder.Bind(object);
  return call;
}

}  // namespace clipc::draw::vulkan
