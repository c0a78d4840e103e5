// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/vulkan/bind.h"

#include <algorithm>

#include "ir/scalar.h"
#include "tools/draw/textures.h"
#include "tools/draw/vulkan/driver_bugs.h"

namespace clipc::draw::vulkan {
namespace {

using ir::ObjectKind;

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
  Binder(const ir::Program& program, const Inputs& inputs, DrawCall& call)
      : program_(program), inputs_(inputs), call_(call) {}

  void Bind(const glsl::GlslInfo::Block& block) {
    const std::uint32_t count = program_.cbuffers[block.cbuffer].count;
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::string name = count == 1 ? block.name : block.name + "[" + std::to_string(i) + "]";
      Add(block, i, DrawCall::Kind::kUniforms).bytes = Find(inputs_.blocks, name).bytes;
    }
  }

  void Bind(const glsl::GlslInfo::Object& object) {
    const ir::VarId var = object.texture ? object.texture : object.sampler;
    const ObjectKind kind = ObjectTypeOf(program_, var).object;
    const std::vector<std::string> indices = ElementIndices(program_, var);
    for (std::uint32_t i = 0; i < indices.size(); ++i) {
      const std::string name = object.name + indices[i];
      if (!object.texture) {
        Add(object, i, DrawCall::Kind::kSampler).compares = kind == ObjectKind::kSamplerComparison;
      } else if (ir::IsStorageBuffer(kind)) {
        Add(object, i, DrawCall::Kind::kStorage).bytes = Find(inputs_.storage, name).bytes;
      } else {
        const DrawCall::Kind how = kind == ObjectKind::kBuffer ? DrawCall::Kind::kTexels
                                   : ir::IsSampler(kind)       ? DrawCall::Kind::kTextureWithSampler
                                                               : DrawCall::Kind::kTexture;
        Add(object, i, how).texture = Find(inputs_.textures, name);
      }
    }
  }

 private:
  template <typename Written>
  DrawCall::Descriptor& Add(const Written& written, std::uint32_t element, DrawCall::Kind kind) {
    return call_.descriptors.emplace_back(DrawCall::Descriptor{
        Require(written.set, written.name), Require(written.binding, written.name), element, kind});
  }

  const ir::Program& program_;
  const Inputs& inputs_;
  DrawCall& call_;
};

}  // namespace

DrawCall MakeDrawCall(const ir::Program& program, const glsl::GlslInfo& info,
                      const Inputs& inputs) {
  RefuseDriverBugs(program);
  DrawCall call;
  call.vertices = inputs.vertices;
  call.instances = inputs.instances;
  call.first_vertex = inputs.first_vertex;
  call.base_instance = inputs.base_instance;
  for (std::size_t i = 0; i < program.inputs.size(); ++i) {
    if (program.inputs[i].builtin != ir::Builtin::kNone) continue;
    const glsl::GlslInfo::Variable& written = info.inputs.at(i);
    const ir::Scalar kind =
        ir::BaseOf(program.types[program.vars[program.inputs[i].var].type].scalar);
    if (kind == ir::Scalar::kDouble)
      throw DrawError("an attribute of doubles, which no test draws with");
    const Shape::Kind words = kind == ir::Scalar::kBool ? Shape::Kind::kUint : KindOfTexels(kind);
    call.attributes.push_back({Require(written.location, written.name), words,
                               Find(inputs.attributes, written.name).words});
  }
  Binder binder(program, inputs, call);
  for (const glsl::GlslInfo::Block& block : info.blocks) binder.Bind(block);
  for (const glsl::GlslInfo::Object& object : info.objects) binder.Bind(object);
  return call;
}

}  // namespace clipc::draw::vulkan
