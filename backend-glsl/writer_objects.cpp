// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Declarations of textures, samplers and
// buffers. OpenGL knows a texture only together with its sampler: each pair that is used becomes
// one sampler variable.
#include <algorithm>
#include <variant>

#include "backend-glsl/needs.h"
#include "backend-glsl/writer.h"
#include "base/invariant.h"

namespace clipc::glsl {

using namespace ir;

VarId Writer::ObjectVar(ExprId object) const { return RootOf(program_, object); }

const Type& Writer::ObjectTypeOf(VarId var) const {
  TypeId id = program_.vars[var].type;
  while (program_.types[id].kind == TypeKind::kArray) id = program_.types[id].element;
  return program_.types[id];
}

bool Writer::IsShadow(VarId sampler) const {
  return sampler && ObjectTypeOf(sampler).object == ObjectKind::kSamplerComparison;
}

namespace {

// "2DMSArray", the end of a sampler's or an image's type.
std::string Dimension(ObjectKind kind) {
  const ObjectInfo& info = InfoOf(kind);
  if (info.category == ObjectCategory::kTypedBuffer) return "Buffer";
  const int axes = info.axes == 0 ? 2 : info.axes;  // `sampler` of Direct3D 9 is one of 2D textures
  return (info.is_cube ? "Cube" : std::to_string(axes) + "D") + (info.is_multisampled ? "MS" : "") +
         (info.is_array ? "Array" : "");
}

}  // namespace

void Writer::UsesIn(FunctionId function) {
  ForEachExpr(program_, program_.functions[function].body, [&](ExprId id) {
    const auto* call = std::get_if<ObjectCall>(&program_.exprs[id].node);
    if (!call) return;
    const auto arguments = program_.expr_lists[call->arguments];
    const TextureUse use{ObjectVar(arguments[0]),
                         TakesSampler(call->op) ? ObjectVar(arguments[1]) : VarId{}};
    const ObjectKind kind = ObjectTypeOf(use.texture).object;
    if (IsStorageBuffer(kind) || IsImage(kind)) return;
    if (std::ranges::find(texture_uses_, use) == texture_uses_.end()) texture_uses_.push_back(use);
  });
}

// Names every pair. A texture that goes with one sampler keeps its name; a read without sampler
// goes through any pair of the texture that does not compare.
void Writer::FindTextureUses() {
  if (program_.resources.empty()) return;
  for (FunctionId function : reached_.functions) UsesIn(function);
  if (target_.IsVulkan()) return;
  std::ranges::stable_sort(texture_uses_);
  std::erase_if(texture_uses_, [&](const TextureUse& use) {
    return !use.sampler && std::ranges::any_of(texture_uses_, [&](const TextureUse& other) {
      return other.texture == use.texture && other.sampler && !IsShadow(other.sampler);
    });
  });
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
  const bool is_plain = ir::IsWritable(ObjectTypeOf(texture_var).object);
  if (!target_.IsVulkan() && !is_plain) {
    return CombinedName({texture_var, sampler ? ObjectVar(sampler) : VarId{}}) + indices;
  }
  const std::string name = var_names_[texture_var.index] + indices;
  if (!sampler) return name;
  return SamplerType(texture_var, IsShadow(ObjectVar(sampler))) + "(" + name + ", " +
         ObjectName(sampler, {}) + ")";
}

// "isampler2DArray", "sampler2DShadow"; for Vulkan's separate ones see SeparateObject.
std::string Writer::SamplerType(VarId var, bool shadow) const {
  const Type& type = ObjectTypeOf(var);
  const Scalar element =
      type.element ? BaseOf(program_.types[type.element].scalar) : Scalar::kFloat;
  const char* prefix = element == Scalar::kInt ? "i" : element == Scalar::kUint ? "u" : "";
  return prefix + ("sampler" + Dimension(type.object)) + (shadow ? "Shadow" : "");
}

std::uint32_t Writer::FreeBinding(std::set<std::uint32_t>& taken, std::uint32_t wanted,
                                  std::uint32_t count) {
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
  for (TypeId id = program.vars[var].type; program.types[id].kind == TypeKind::kArray;
       id = program.types[id].element) {
    count = std::min<std::uint64_t>(count * program.types[id].count, 1u << 16);
  }
  return static_cast<std::uint32_t>(count);
}

}  // namespace

void Writer::Objects() {
  for (const Resource& resource : program_.resources) {
    if (!reached_.Has(resource.var)) continue;
    const ObjectKind kind = ObjectTypeOf(resource.var).object;
    if (IsStorageBuffer(kind)) {
      BufferObject(resource);
    } else if (IsImage(kind)) {
      ImageObject(resource);
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
    if (target_.Has(Feature::kBindings)) {
      const std::uint32_t wanted = resource == program_.resources.end() ? 0 : resource->reg.number;
      info.binding = FreeBinding(texture_bindings_, wanted, CountOf(program_, use.texture));
      line = "layout(binding = " + std::to_string(*info.binding) + ") ";
    }
    const Need* need = NeedOf(ObjectTypeOf(use.texture).object);
    if (need) Require(need->feature);
    line += target_.IsEs() ? "uniform highp " : "uniform ";
    line += SamplerType(use.texture, IsShadow(use.sampler)) + " " + info.name +
            Dimensions(use.texture) + ";";
    if (use.sampler)
      line +=
          "  // " + program_.vars[use.texture].name + " with " + program_.vars[use.sampler].name;
    objects_ += line + "\n";
    info_.objects.push_back(std::move(info));
  }
}

std::string Writer::ObjectTypeName(VarId var) const {
  const ObjectKind kind = ObjectTypeOf(var).object;
  if (kind == ObjectKind::kSampler) return "sampler";
  if (kind == ObjectKind::kSamplerComparison) return "samplerShadow";
  std::string type = SamplerType(var, false);
  if (!IsCombinedSampler(kind)) type.replace(type.find("sampler"), 7, "texture");
  return type;
}

void Writer::SeparateObject(const Resource& resource) {
  const ObjectKind kind = ObjectTypeOf(resource.var).object;
  const bool is_sampler = InfoOf(kind).category == ObjectCategory::kSampler;
  GlslInfo::Object info;
  (is_sampler ? info.sampler : info.texture) = resource.var;
  info.name = var_names_[resource.var.index];
  info.set = resource.reg.space;
  info.binding = VulkanBinding(resource.reg, target_);
  objects_ += "layout(set = " + std::to_string(*info.set) +
              ", binding = " + std::to_string(*info.binding) + ") uniform " +
              ObjectTypeName(resource.var) + " " + info.name + Dimensions(resource.var) + ";  // " +
              resource.reg.letter + std::to_string(resource.reg.number) + "\n";
  info_.objects.push_back(std::move(info));
}

void Writer::BufferObject(const Resource& resource) {
  const Var& var = program_.vars[resource.var];
  const Type& type = ObjectTypeOf(resource.var);
  GlslInfo::Object info{
      resource.var, {}, var_names_[resource.var.index], std::nullopt, std::nullopt};
  std::string qualifiers = "std430";
  if (target_.IsVulkan()) {
    info.set = resource.reg.space;
    info.binding = VulkanBinding(resource.reg, target_);
    qualifiers += ", set = " + std::to_string(*info.set);
  } else {
    info.binding = FreeBinding(storage_bindings_, resource.reg.number, 1);
  }
  qualifiers += ", binding = " + std::to_string(*info.binding);
  std::string element = "uint ";
  const bool is_structured = IsStructured(type.object);
  if (const auto extent =
          is_structured ? Std430(program_.types, type.element, var.row_major) : std::nullopt) {
    element = TypeName(type.element) + " ";
    if (extent->matrices == MatrixLayout::kRowMajor) qualifiers += ", row_major";
  }
  const std::string block = namer_.Global(var.name + "_block");
  objects_ += "layout(" + qualifiers + ")" + (ir::IsWritable(type.object) ? "" : " readonly") +
              " buffer " + block + " {  // " + resource.reg.letter +
              std::to_string(resource.reg.number) + "\n    " + element + info.name + "[];\n};\n";
  info_.objects.push_back(std::move(info));
}

// GLSL wants the format of an image that is read; HLSL tells the components and their kind: 32 bits
// each.
void Writer::ImageObject(const Resource& resource) {
  const Type& type = ObjectTypeOf(resource.var);
  const Shape element =
      type.element ? ShapeOf(program_.types[type.element]) : ShapeOf(Scalar::kFloat, 1, 4);
  GlslInfo::Object info{
      resource.var, {}, var_names_[resource.var.index], std::nullopt, std::nullopt};
  std::string qualifiers;
  if (target_.IsVulkan()) {
    info.set = resource.reg.space;
    info.binding = VulkanBinding(resource.reg, target_);
    qualifiers = "set = " + std::to_string(*info.set) + ", ";
  } else {
    info.binding =
        FreeBinding(image_bindings_, resource.reg.number, CountOf(program_, resource.var));
  }
  const std::string prefix = element.scalar == Scalar::kInt    ? "i"
                             : element.scalar == Scalar::kUint ? "u"
                                                               : "";
  qualifiers += "binding = " + std::to_string(*info.binding) + ", ";
  qualifiers += std::string("rgba").substr(
                    0, element.size == 3 ? 4 : static_cast<std::size_t>(element.size)) +
                "32";
  qualifiers += prefix == "u" ? "ui" : prefix == "i" ? "i" : "f";
  objects_ += "layout(" + qualifiers + ") uniform " + prefix + "image" + Dimension(type.object) +
              " " + info.name + Dimensions(resource.var) + ";  // " + resource.reg.letter +
              std::to_string(resource.reg.number) + "\n";
  info_.objects.push_back(std::move(info));
}

}  // namespace clipc::glsl
