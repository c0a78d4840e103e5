// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/objects.h"

#include <algorithm>
#include <span>
#include <tuple>
#include <unordered_map>

#include <fmt/format.h>

#include "backend-glsl/images.h"
#include "backend-glsl/requirements.h"
#include "backend-glsl/text.h"
#include "backend-glsl/writer/bindings.h"
#include "backend-glsl/writer/types.h"
#include "base/invariant.h"
#include "ir/std_layout.h"

namespace clipc::glsl {

using namespace ir;

namespace {

// The end "2DMSArray" of a sampler's or an image's type.
std::string Dimension(ObjectKind kind) {
  const ObjectInfo& info = InfoOf(kind);
  if (info.category == ObjectCategory::kTypedBuffer) return "Buffer";
  const int axes = info.axes == 0 ? 2 : info.axes;  // `sampler` of Direct3D 9 is one of 2D textures
  return Concat(info.is_cube ? "Cube" : std::to_string(axes) + "D",
                info.is_multisampled ? "MS" : "", info.is_array ? "Array" : "");
}

// The prefix of a sampler's or an image's type: "i" of isampler2D.
std::string_view PrefixOf(const WriterContext& context, const Type& object) {
  const Scalar kind = object.element ? BaseOf(context[object.element].scalar) : Scalar::kFloat;
  return kind == Scalar::kInt ? "i" : kind == Scalar::kUint ? "u" : "";
}

std::uint32_t CountOf(const WriterContext& context, VarId var) {
  std::uint64_t count = 1;
  for (const Type* type = &context.TypeOf(var); type->kind == TypeKind::kArray;
       type = &context[type->element]) {
    count = std::min<std::uint64_t>(count * type->count, 1u << 16);
  }
  return static_cast<std::uint32_t>(count);
}

// The uses of a texture among `uses`, which are sorted by texture.
std::span<const TextureUse> UsesOf(const std::vector<TextureUse>& uses, VarId texture) {
  return std::ranges::equal_range(uses, texture.index, {},
                                  [](const TextureUse& use) { return use.texture.index; });
}

class ObjectWriter {
 public:
  explicit ObjectWriter(WriterContext& context) : context_(context) {}

  Objects Write() {
    const bool is_vulkan = context_.target.IsVulkan();
    for (const OtherStage& other : context_.others) {
      if (!other.laid) continue;
      for (const GlslInfo::Object& object : other.laid->objects)
        BindingsOf(object.kind).Take(object);
    }
    for (const Resource& resource : context_.program.resources) {
      // OpenGL has no samplers of their own.
      const bool is_sampler =
          InfoOf(ObjectTypeOf(context_, resource.var).object).category == ObjectCategory::kSampler;
      if (context_.reached.Has(resource.var) && !is_sampler)
        BindingsOf(ObjectTypeOf(context_, resource.var).object)
            .Reserve(resource.reg, CountOf(context_, resource.var));
    }
    for (const Resource& resource : context_.program.resources) {
      if (!context_.reached.Has(resource.var)) continue;
      const ObjectKind kind = ObjectTypeOf(context_, resource.var).object;
      if (IsStorageBuffer(kind)) {
        Buffer(resource);
      } else if (IsImage(kind)) {
        Image(resource);
      } else if (is_vulkan) {
        Separate(resource);
      }
    }
    if (is_vulkan) return std::move(objects_);
    std::unordered_map<std::uint32_t, const Resource*> by_var;
    for (const Resource& resource : context_.program.resources)
      by_var.emplace(resource.var.index, &resource);
    for (const TextureUse& use : context_.texture_uses) {
      Combined(use, *by_var.at(use.texture.index),
               use.sampler ? by_var.at(use.sampler.index) : nullptr);
    }
    return std::move(objects_);
  }

 private:
  Bindings& BindingsOf(ObjectKind kind) {
    return IsStorageBuffer(kind) ? buffers_ : IsImage(kind) ? images_ : textures_;
  }

  // The object in HLSL, "tex : t0"; without the name if it is that of the variable.
  std::string PlaceOf(const Resource& resource, const std::string& name) const {
    const std::string& written = context_[resource.var].name;
    const std::string place = RegisterText(resource.reg);
    return written == name ? place : Concat(written, " : ", place);
  }

  void Combined(const TextureUse& use, const Resource& resource, const Resource* sampler) {
    const ObjectKind kind = ObjectTypeOf(context_, use.texture).object;
    GlslInfo::Object info{{}, use.texture, use.sampler, use.name, kind};
    const std::string place =
        Bind(context_, info, resource.reg, textures_, CountOf(context_, use.texture),
             context_.LaidObject(use.texture, use.sampler));
    if (const Requirement* requirement = RequirementOf(kind))
      context_.Require(requirement->feature);
    Append(text_, LayoutText({place}), context_.target.IsEs() ? "uniform highp " : "uniform ",
           TextureType(context_, use.texture, "sampler"),
           IsShadow(context_, use.sampler ? use.sampler : use.texture) ? "Shadow " : " ", use.name,
           Dimensions(context_, use.texture), ";  // ", PlaceOf(resource, use.name));
    if (sampler) Append(text_, " with ", PlaceOf(*sampler, use.name));
    text_ += "\n";
    objects_.info.push_back(std::move(info));
  }

  // Declares a texture or a sampler of Vulkan.
  void Separate(const Resource& resource) {
    const ObjectKind kind = ObjectTypeOf(context_, resource.var).object;
    GlslInfo::Object& info = Add(resource);
    if (InfoOf(kind).category == ObjectCategory::kSampler) std::swap(info.texture, info.sampler);
    const std::string type =
        kind == ObjectKind::kSampler             ? "sampler"
        : kind == ObjectKind::kSamplerComparison ? "samplerShadow"
        : InfoOf(kind).category == ObjectCategory::kSubpass
            ? Concat(PrefixOf(context_, ObjectTypeOf(context_, resource.var)),
                     InfoOf(kind).is_multisampled ? "subpassInputMS" : "subpassInput")
            : Concat(TextureType(context_, resource.var,
                                 IsCombinedSampler(kind) ? "sampler" : "texture"),
                     InfoOf(kind).compares ? "Shadow" : "");
    const std::string place = Bind(context_, info, resource.reg, textures_, 1);
    const std::string attachment =
        resource.input_attachment
            ? Concat("input_attachment_index = ", std::to_string(*resource.input_attachment))
            : "";
    Append(text_, LayoutText({attachment, place}), "uniform ", type, " ", info.name,
           Dimensions(context_, resource.var), ";  // ", RegisterText(resource.reg), "\n");
  }

  void Buffer(const Resource& resource) {
    const Var& var = context_[resource.var];
    const Type& type = ObjectTypeOf(context_, resource.var);
    GlslInfo::Object& info = Add(resource);
    const std::string place =
        Bind(context_, info, resource.reg, buffers_, 1, context_.LaidObject(resource.var, {}));
    const auto extent = Std430(context_.types, type.element, var.row_major);
    const std::string element = TypeName(context_, type.element);
    const bool is_turned = extent && extent->matrices == MatrixLayout::kRowMajor;
    const std::string dimensions = Dimensions(context_, resource.var);
    text_ += fmt::format("{}{}buffer {} {{  // {}\n    {} {}[];\n}}{};\n",
                         LayoutText({"std430", place, is_turned ? "row_major" : ""}),
                         var.coherent                  ? "coherent "
                         : ir::IsWritable(type.object) ? ""
                                                       : "readonly ",
                         BlockName(info.name, var.name), Origin(resource), element,
                         dimensions.empty() ? info.name : "elements",
                         dimensions.empty() ? "" : Concat(" ", info.name, dimensions));
  }

  // What the HLSL has in place of the buffer.
  std::string Origin(const Resource& resource) const {
    return resource.counter_of ? Concat("the counter of ", context_[resource.counter_of].name)
                               : RegisterText(resource.reg);
  }

  // The name of a block with a storage buffer. The stages of a pair have one name for a buffer that
  // they share, and two names for others.
  std::string BlockName(const std::string& name, const std::string& written) {
    return context_.namer.Global(Concat(context_.others.empty() ? written : name, "_block"));
  }

  // Declares an image. GLSL requires the format of one that is read.
  void Image(const Resource& resource) {
    const Type& type = ObjectTypeOf(context_, resource.var);
    GlslInfo::Object& info = Add(resource);
    const std::string place =
        Bind(context_, info, resource.reg, images_, CountOf(context_, resource.var),
             context_.LaidObject(resource.var, {}));
    if (InfoOf(type.object).category == ObjectCategory::kTypedBuffer)
      context_.Require(Feature::kTextureBuffers);
    Append(text_, LayoutText({place, ImageFormat(context_.program, resource)}),
           context_[resource.var].coherent ? "coherent " : "",
           ImageAccess(context_.program, images_used_, context_.target, resource),
           context_.target.IsEs() ? "uniform highp " : "uniform ", PrefixOf(context_, type),
           "image", Dimension(type.object), " ", info.name, Dimensions(context_, resource.var),
           ";  // ", RegisterText(resource.reg), "\n");
  }

  GlslInfo::Object& Add(const Resource& resource) {
    const Type& type = context_.TypeOf(resource.var);
    if (ir::IsOrdered(ObjectTypeOf(context_, resource.var).object)) {
      context_.has_order = true;
      context_.Require(Feature::kInterlocks);
    }
    if (type.kind == TypeKind::kArray && type.count == 0)
      context_.Require("GL_EXT_nonuniform_qualifier");
    const TypeId declared =
        resource.declared_type ? resource.declared_type : context_[resource.var].type;
    return objects_.info.emplace_back(
        GlslInfo::Object{{},
                         resource.var,
                         {},
                         context_.NameOf(resource.var),
                         context_[context_.types.Innermost(declared)].object});
  }

  WriterContext& context_;
  Objects objects_;
  std::string& text_ = objects_.text;
  Bindings textures_{
      .end = context_.target.TextureUnits(),
      .base = InfoOf(context_.program.stage).draws_pixels ? context_.target.PixelBase() : 0};
  Bindings buffers_, images_;
  const std::vector<ImageUse> images_used_ =
      UsesOfImages(context_.program, context_.reached, context_.target);
};

}  // namespace

const Type& ObjectTypeOf(const WriterContext& context, VarId object) {
  return context[context.types.Innermost(context[object].type)];
}

bool IsShadow(const WriterContext& context, VarId sampler) {
  return sampler && InfoOf(ObjectTypeOf(context, sampler).object).compares;
}

std::string TextureType(const WriterContext& context, VarId texture, std::string_view stem) {
  const Type& type = ObjectTypeOf(context, texture);
  return Concat(PrefixOf(context, type), stem, Dimension(type.object));
}

std::vector<TextureUse> FindTextureUses(WriterContext& context) {
  std::vector<TextureUse> uses;
  if (context.program.resources.empty() || context.target.IsVulkan()) return uses;
  for (const FunctionId function : context.reached.functions) {
    ForEachExpr(context.program, context[function].body, [&](ExprId id) {
      const auto* call = context.As<ObjectCall>(id);
      if (!call) return;
      const auto root = [&](OperandKind kind) {
        const ExprId path = context.Operand(*call, kind);
        return path ? RootOf(context.program, path) : VarId{};
      };
      TextureUse use{root(OperandKind::kObject), root(OperandKind::kSampler), {}};
      const ObjectKind kind = ObjectTypeOf(context, use.texture).object;
      if (!IsStorageBuffer(kind) && !IsImage(kind)) uses.push_back(std::move(use));
    });
  }
  const auto key = [](const TextureUse& use) { return std::tie(use.texture, use.sampler); };
  std::ranges::sort(uses, {}, key);
  uses.erase(std::ranges::unique(uses, {}, key).begin(), uses.end());
  // A read without a sampler goes through any pair of the texture that does not compare.
  const std::vector<TextureUse> all = uses;
  std::erase_if(uses, [&](const TextureUse& use) {
    return !use.sampler &&
           std::ranges::any_of(UsesOf(all, use.texture), [&](const TextureUse& other) {
             return other.sampler && !IsShadow(context, other.sampler);
           });
  });
  // A texture that goes with one sampler keeps its name, unless the other stage of a pair reads the
  // texture without a sampler under that name.
  for (TextureUse& use : uses) {
    if (const GlslInfo::Object* written = context.LaidObject(use.texture, use.sampler)) {
      use.name = written->name;
      continue;
    }
    const std::string& name = context.NameOf(use.texture);
    const bool is_only =
        UsesOf(uses, use.texture).size() == 1 && !context.LaidObject(use.texture, {});
    use.name = is_only || !use.sampler ? name
                                       : context.namer.Global(Concat(context[use.texture].name, "_",
                                                                     context[use.sampler].name));
  }
  return uses;
}

Objects WriteObjects(WriterContext& context) { return ObjectWriter(context).Write(); }

const std::string& CombinedName(const WriterContext& context, VarId texture, VarId sampler) {
  const TextureUse* found = nullptr;
  for (const TextureUse& use : UsesOf(context.texture_uses, texture)) {
    if (use.sampler == sampler) return use.name;
    if (!found && !IsShadow(context, use.sampler)) found = &use;
  }
  CLIPC_CHECK(found != nullptr);
  return found->name;
}

}  // namespace clipc::glsl
