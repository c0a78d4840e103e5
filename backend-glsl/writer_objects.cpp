// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Declarations of textures, samplers and buffers. OpenGL knows a texture only together with its sampler: each pair that is
// used becomes one sampler variable, and a function that is handed a texture and a sampler is handed the pair.
#include <algorithm>
#include <variant>

#include "backend-glsl/writer_state.h"
#include "base/check.h"

namespace clipc::glsl {

using namespace ir;

VarId Writer::ObjectVar(ExprId object) const {
  const auto& node = program_.exprs[object].node;
  if (const auto* index = std::get_if<Index>(&node)) return ObjectVar(index->base);
  return std::get<VarRef>(node).var;
}

const Type& Writer::ObjectTypeOf(VarId var) const {
  TypeId id = program_.vars[var].type;
  while (program_.types[id].kind == TypeKind::kArray) id = program_.types[id].element;
  return program_.types[id];
}

bool Writer::IsShadow(VarId sampler) const {
  return sampler && ObjectTypeOf(sampler).object == ObjectKind::kSamplerComparison;
}

namespace {

bool TakesSampler(ObjectOp op) { return op <= ObjectOp::kGatherAlpha; }
bool IsStorage(ObjectKind kind) { return kind == ObjectKind::kStructuredBuffer || kind == ObjectKind::kByteAddressBuffer; }

}  // namespace

void Writer::AddTextureUse(FunctionId function, TextureUse use) {
  if (IsStorage(ObjectTypeOf(use.texture).object)) return;
  const auto is_parameter = [&](VarId var) { return var && program_.vars[var].storage != Storage::kResource; };
  auto& uses = is_parameter(use.texture) || is_parameter(use.sampler) ? parameter_uses_[function.index] : texture_uses_;
  if (std::ranges::find(uses, use) == uses.end()) uses.push_back(use);
}

TextureUse Writer::InCaller(const TextureUse& use, const Call& call) const {
  const auto& parameters = program_.functions[call.function].parameters;
  const auto map = [&](VarId var) {
    const auto found = std::ranges::find(parameters, var);
    if (!var || found == parameters.end()) return var;
    return ObjectVar(program_.expr_lists[call.arguments][static_cast<std::size_t>(found - parameters.begin())]);
  };
  return {map(use.texture), map(use.sampler)};
}

void Writer::UsesIn(FunctionId function) {
  ForEachExpr(program_, program_.functions[function].body, [&](ExprId id) {
    const auto& node = program_.exprs[id].node;
    if (const auto* call = std::get_if<Call>(&node)) {
      for (const TextureUse& use : parameter_uses_[call->function.index]) AddTextureUse(function, InCaller(use, *call));
    }
    const auto* object = std::get_if<ObjectCall>(&node);
    if (!object) return;
    const auto arguments = program_.expr_lists[object->arguments];
    AddTextureUse(function, {ObjectVar(arguments[0]), TakesSampler(object->op) ? ObjectVar(arguments[1]) : VarId{}});
  });
}

// Names every pair. A texture that goes with one sampler keeps its name; a read without sampler goes through any pair of the
// texture that does not compare.
void Writer::FindTextureUses() {
  parameter_uses_.resize(program_.functions.size());
  for (FunctionId function : reached_.functions) UsesIn(function);
  if (target_.IsVulkan()) return;
  const auto settle = [&](std::vector<TextureUse>& uses) {
    std::ranges::stable_sort(uses);
    std::erase_if(uses, [&](const TextureUse& use) {
      return !use.sampler && std::ranges::any_of(uses, [&](const TextureUse& other) {
        return other.texture == use.texture && other.sampler && !IsShadow(other.sampler);
      });
    });
  };
  settle(texture_uses_);
  for (auto& uses : parameter_uses_) settle(uses);
  for (const TextureUse& use : texture_uses_) {
    const auto same = std::ranges::count(texture_uses_, use.texture, &TextureUse::texture);
    const std::string& texture = program_.vars[use.texture].name;
    if (same == 1 || !use.sampler) {
      combined_[use] = var_names_[use.texture.index];
    } else {
      combined_[use] = namer_.Global(texture + "_" + program_.vars[use.sampler].name);
    }
  }
}

// "[i][2]" of textures[i][2].
std::string Writer::IndicesOf(ExprId object) {
  std::string indices;
  const ir::Expr* expr = &program_.exprs[object];
  while (const auto* index = std::get_if<Index>(&expr->node)) {
    indices.insert(0, "[" + IndexValue(index->index) + "]");
    expr = &program_.exprs[index->base];
  }
  return indices;
}

const std::string& Writer::CombinedName(const TextureUse& use) const {
  auto found = combined_.find(use);
  if (found == combined_.end()) {
    found = std::ranges::find_if(combined_, [&](const auto& pair) {
      return pair.first.texture == use.texture && !IsShadow(pair.first.sampler);
    });
  }
  CLIPC_CHECK(found != combined_.end());
  return found->second;
}

std::string Writer::ObjectName(ExprId texture, ExprId sampler) {
  const std::string indices = IndicesOf(texture);
  const VarId texture_var = ObjectVar(texture);
  if (!target_.IsVulkan()) {
    return CombinedName({texture_var, sampler ? ObjectVar(sampler) : VarId{}}) + indices;
  }
  const std::string name = var_names_[texture_var.index] + indices;
  if (!sampler) return name;
  return SamplerType(texture_var, IsShadow(ObjectVar(sampler))) + "(" + name + ", " + ObjectName(sampler, {}) + ")";
}

// "isampler2DArray", "sampler2DShadow"; for Vulkan's separate ones see SeparateObject.
std::string Writer::SamplerType(VarId var, bool shadow) const {
  const Type& type = ObjectTypeOf(var);
  const auto dimension = [&]() -> std::string {
    switch (type.object) {
      case ObjectKind::kTexture1D:
      case ObjectKind::kSampler1D: return "1D";
      case ObjectKind::kTexture1DArray: return "1DArray";
      case ObjectKind::kTexture2DArray: return "2DArray";
      case ObjectKind::kTexture2DMS: return "2DMS";
      case ObjectKind::kTexture2DMSArray: return "2DMSArray";
      case ObjectKind::kTexture3D:
      case ObjectKind::kSampler3D: return "3D";
      case ObjectKind::kTextureCube:
      case ObjectKind::kSamplerCube: return "Cube";
      case ObjectKind::kTextureCubeArray: return "CubeArray";
      case ObjectKind::kBuffer: return "Buffer";
      default: return "2D";
    }
  };
  const Scalar element = type.element ? BaseOf(program_.types[type.element].scalar) : Scalar::kFloat;
  const char* prefix = element == Scalar::kInt ? "i" : element == Scalar::kUint ? "u" : "";
  return prefix + ("sampler" + dimension()) + (shadow ? "Shadow" : "");
}

std::uint32_t Writer::FreeBinding(std::set<std::uint32_t>& taken, std::uint32_t wanted, std::uint32_t count) {
  const auto is_free = [&](std::uint32_t first) {
    const auto next = taken.lower_bound(first);
    return next == taken.end() || *next - first >= count;
  };
  if (!is_free(wanted)) {
    for (wanted = 0; !is_free(wanted); ++wanted) {
    }
  }
  for (std::uint32_t i = 0; i < count; ++i) taken.insert(wanted + i);
  return wanted;
}

namespace {

std::uint32_t CountOf(const Program& program, VarId var) {
  std::uint64_t count = 1;
  for (TypeId id = program.vars[var].type; program.types[id].kind == TypeKind::kArray; id = program.types[id].element) {
    count = std::min<std::uint64_t>(count * program.types[id].count, 1u << 16);
  }
  return static_cast<std::uint32_t>(count);
}

}  // namespace

void Writer::Objects() {
  for (const Resource& resource : program_.resources) {
    if (!reached_.Has(resource.var)) continue;
    if (IsStorage(ObjectTypeOf(resource.var).object)) {
      BufferObject(resource);
    } else if (target_.IsVulkan()) {
      SeparateObject(resource);
    }
  }
  if (!target_.IsVulkan()) CombinedSamplers();
}

void Writer::CombinedSamplers() {
  for (const TextureUse& use : texture_uses_) {
    GlslInfo::Object info{use.texture, use.sampler, combined_[use], std::nullopt, std::nullopt};
    const auto resource = std::ranges::find(program_.resources, use.texture, &Resource::var);
    std::string line;
    if (target_.HasBindings()) {
      const std::uint32_t wanted = resource == program_.resources.end() ? 0 : resource->reg.number;
      info.binding = FreeBinding(texture_bindings_, wanted, CountOf(program_, use.texture));
      line = "layout(binding = " + std::to_string(*info.binding) + ") ";
    }
    switch (ObjectTypeOf(use.texture).object) {
      case ObjectKind::kTextureCubeArray: Require(target_.CubeArrays()); break;
      case ObjectKind::kTexture2DMSArray: Require(target_.MultisampleArrays()); break;
      case ObjectKind::kBuffer: Require(target_.TextureBuffers()); break;
      default: break;
    }
    line += target_.IsEs() ? "uniform highp " : "uniform ";
    line += SamplerType(use.texture, IsShadow(use.sampler)) + " " + info.name + Dimensions(use.texture) + ";";
    if (use.sampler) line += "  // " + program_.vars[use.texture].name + " with " + program_.vars[use.sampler].name;
    objects_ += line + "\n";
    info_.objects.push_back(std::move(info));
  }
}

std::string Writer::ObjectTypeName(VarId var) const {
  const ObjectKind kind = ObjectTypeOf(var).object;
  if (kind == ObjectKind::kSampler) return "sampler";
  if (kind == ObjectKind::kSamplerComparison) return "samplerShadow";
  std::string type = SamplerType(var, false);
  const bool is_combined = kind >= ObjectKind::kSampler1D && kind <= ObjectKind::kSamplerCube;
  if (!is_combined) type.replace(type.find("sampler"), 7, "texture");
  return type;
}

void Writer::SeparateObject(const Resource& resource) {
  const ObjectKind kind = ObjectTypeOf(resource.var).object;
  const bool is_sampler = kind == ObjectKind::kSampler || kind == ObjectKind::kSamplerComparison;
  GlslInfo::Object info;
  (is_sampler ? info.sampler : info.texture) = resource.var;
  info.name = var_names_[resource.var.index];
  info.set = resource.reg.space;
  info.binding = VulkanBinding(resource.reg);
  objects_ += "layout(set = " + std::to_string(*info.set) + ", binding = " + std::to_string(*info.binding) + ") uniform " +
              ObjectTypeName(resource.var) + " " + info.name + Dimensions(resource.var) + ";  // " + resource.reg.letter +
              std::to_string(resource.reg.number) + "\n";
  info_.objects.push_back(std::move(info));
}

void Writer::BufferObject(const Resource& resource) {
  const Var& var = program_.vars[resource.var];
  const Type& type = ObjectTypeOf(resource.var);
  GlslInfo::Object info{resource.var, {}, var_names_[resource.var.index], std::nullopt, std::nullopt};
  std::string qualifiers = "std430";
  if (target_.IsVulkan()) {
    info.set = resource.reg.space;
    info.binding = VulkanBinding(resource.reg);
    qualifiers += ", set = " + std::to_string(*info.set);
  } else {
    info.binding = FreeBinding(storage_bindings_, resource.reg.number, 1);
  }
  qualifiers += ", binding = " + std::to_string(*info.binding);
  std::string element = "uint ";
  const bool is_structured = type.object == ObjectKind::kStructuredBuffer;
  if (const auto extent = is_structured ? Std430(program_.types, type.element, var.row_major) : std::nullopt) {
    element = TypeName(type.element) + " ";
    if (extent->matrices == MatrixLayout::kRowMajor) qualifiers += ", row_major";
  }
  const std::string block = namer_.Global(var.name + "_block");
  objects_ += "layout(" + qualifiers + ") readonly buffer " + block + " {  // " + resource.reg.letter +
              std::to_string(resource.reg.number) + "\n    " + element + info.name + "[];\n};\n";
  info_.objects.push_back(std::move(info));
}

std::string Writer::CombinedParameters(FunctionId function) {
  std::string text;
  for (const TextureUse& use : parameter_uses_[function.index]) {
    const auto same = std::ranges::count(parameter_uses_[function.index], use.texture, &TextureUse::texture);
    std::string wanted = program_.vars[use.texture].name;
    if (same > 1 && use.sampler) wanted += "_" + program_.vars[use.sampler].name;
    combined_[use] = namer_.Local(wanted);
    text += std::string(text.empty() ? "" : ", ") + (target_.IsEs() ? "highp " : "") +
            SamplerType(use.texture, IsShadow(use.sampler)) + " " + combined_[use] + Dimensions(use.texture);
  }
  return text;
}

std::string Writer::CombinedArguments(const Call& call) {
  const auto& parameters = program_.functions[call.function].parameters;
  std::string text;
  for (const TextureUse& use : parameter_uses_[call.function.index]) {
    if (!text.empty()) text += ", ";
    text += CombinedName(InCaller(use, call));
    const auto texture = std::ranges::find(parameters, use.texture);
    if (texture == parameters.end()) continue;
    text += IndicesOf(program_.expr_lists[call.arguments][static_cast<std::size_t>(texture - parameters.begin())]);
  }
  return text;
}

}  // namespace clipc::glsl
