// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/objects.h"

#include <algorithm>
#include <span>
#include <tuple>

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

// Resources lie in the order of their variables, but for those that a pass has added.
const Resource& ResourceOf(const WriterContext& context, VarId var) {
  const std::vector<Resource>& all = context.program.resources;
  const auto at = std::ranges::lower_bound(
      all, var.index, {}, [](const Resource& resource) { return resource.var.index; });
  if (at != all.end() && at->var == var) return *at;
  return *std::ranges::find(all, var, &Resource::var);
}

// The giver of bindings.
class ObjectLayer {
 public:
  explicit ObjectLayer(WriterContext& context) : context_(context) {}

  std::vector<GlslInfo::Object> Lay() {
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
      const ObjectKind kind = ObjectTypeOf(context_, resource.var).object;
      if (context_.reached.Has(resource.var) &&
          (is_vulkan || IsStorageBuffer(kind) || IsImage(kind)))
        Separate(resource, kind);
    }
    Combined();
    return std::move(objects_);
  }

 private:
  Bindings& BindingsOf(ObjectKind kind) {
    return IsStorageBuffer(kind) ? buffers_ : IsImage(kind) ? images_ : textures_;
  }

  void Separate(const Resource& resource, ObjectKind kind) {
    const TypeId declared =
        resource.declared_type ? resource.declared_type : context_[resource.var].type;
    GlslInfo::Object& info = objects_.emplace_back(
        GlslInfo::Object{{},
                         resource.var,
                         {},
                         context_.NameOf(resource.var),
                         context_[context_.types.Innermost(declared)].object});
    if (InfoOf(kind).category == ObjectCategory::kSampler) std::swap(info.texture, info.sampler);
    const bool is_shared = IsStorageBuffer(kind) || IsImage(kind);
    if (IsImage(kind)) info.count = CountOf(context_, resource.var);
    Bind(context_, info, resource.reg, BindingsOf(kind),
         is_shared ? context_.LaidObject(resource.var, {}) : nullptr);
  }

  // The textures of OpenGL with their samplers.
  void Combined() {
    for (const TextureUse& use : context_.texture_uses) {
      GlslInfo::Object& info = objects_.emplace_back(GlslInfo::Object{
          {}, use.texture, use.sampler, use.name, ObjectTypeOf(context_, use.texture).object});
      info.count = CountOf(context_, use.texture);
      Bind(context_, info, ResourceOf(context_, use.texture).reg, textures_,
           context_.LaidObject(use.texture, use.sampler));
    }
  }

  WriterContext& context_;
  std::vector<GlslInfo::Object> objects_;
  Bindings textures_{.end = context_.target.TextureUnits(),
                     .base = context_.target.BaseOf(context_.program.stage)};
  Bindings buffers_, images_;
};

class ObjectWriter {
 public:
  explicit ObjectWriter(WriterContext& context) : context_(context) {}

  std::string Write(std::span<const GlslInfo::Object> objects) {
    for (const GlslInfo::Object& info : objects) {
      const Resource& resource = ResourceOf(context_, info.texture ? info.texture : info.sampler);
      const Type& type = ObjectTypeOf(context_, resource.var);
      if (ir::IsOrdered(type.object)) {
        context_.has_order = true;
        context_.Require(Feature::kInterlocks);
      }
      const Type& whole = context_.TypeOf(resource.var);
      if (whole.kind == TypeKind::kArray && whole.count == 0)
        context_.Require("GL_EXT_nonuniform_qualifier");
      if (IsStorageBuffer(type.object))
        Buffer(resource, info);
      else if (IsImage(type.object))
        Image(resource, info);
      else if (context_.target.IsVulkan())
        Separate(resource, info);
      else
        Combined(resource, info);
    }
    return std::move(text_);
  }

 private:
  // The object in HLSL, "tex : t0"; without the name if it is that of the variable.
  std::string PlaceOf(const Resource& resource, const std::string& name) const {
    const std::string& written = context_[resource.var].name;
    const std::string place = RegisterText(resource.reg);
    return written == name ? place : Concat(written, " : ", place);
  }

  // What a read of the texture gives has this precision.
  std::string_view PrecisionOf(VarId texture) const {
    if (!context_.target.IsEs()) return "";
    const Type& object = ObjectTypeOf(context_, texture);
    const bool is_relaxed = object.element && !PrecisionText(context_, object.element).empty();
    return is_relaxed ? "mediump " : "highp ";
  }

  void Combined(const Resource& resource, const GlslInfo::Object& info) {
    if (const Requirement* requirement = RequirementOf(info.kind))
      context_.Require(requirement->feature);
    Append(text_, LayoutText({PlaceText(info)}), "uniform ", PrecisionOf(info.texture),
           TextureType(context_, info.texture, "sampler"),
           IsShadow(context_, info.sampler ? info.sampler : info.texture) ? "Shadow " : " ",
           info.name, Dimensions(context_, info.texture), ";  // ", PlaceOf(resource, info.name));
    if (info.sampler)
      Append(text_, " with ", PlaceOf(ResourceOf(context_, info.sampler), info.name));
    text_ += "\n";
  }

  // Declares a texture or a sampler of Vulkan.
  void Separate(const Resource& resource, const GlslInfo::Object& info) {
    const Type& object = ObjectTypeOf(context_, resource.var);
    const ObjectKind kind = object.object;
    const std::string type =
        kind == ObjectKind::kSampler             ? "sampler"
        : kind == ObjectKind::kSamplerComparison ? "samplerShadow"
        : InfoOf(kind).category == ObjectCategory::kSubpass
            ? Concat(PrefixOf(context_, object),
                     InfoOf(kind).is_multisampled ? "subpassInputMS" : "subpassInput")
            : Concat(TextureType(context_, resource.var,
                                 IsCombinedSampler(kind) ? "sampler" : "texture"),
                     InfoOf(kind).compares ? "Shadow" : "");
    const std::string attachment =
        resource.input_attachment
            ? Concat("input_attachment_index = ", std::to_string(*resource.input_attachment))
            : "";
    Append(text_, LayoutText({attachment, PlaceText(info)}), "uniform ", type, " ", info.name,
           Dimensions(context_, resource.var), ";  // ", RegisterText(resource.reg), "\n");
  }

  void Buffer(const Resource& resource, const GlslInfo::Object& info) {
    const Var& var = context_[resource.var];
    const Type& type = ObjectTypeOf(context_, resource.var);
    const auto extent = Std430(context_.types, type.element, var.row_major);
    const std::string element = TypeName(context_, type.element);
    const bool is_turned = extent && extent->matrices == MatrixLayout::kRowMajor;
    const std::string dimensions = Dimensions(context_, resource.var);
    text_ += fmt::format("{}{}buffer {} {{  // {}\n    {} {}[];\n}}{};\n",
                         LayoutText({"std430", PlaceText(info), is_turned ? "row_major" : ""}),
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
  void Image(const Resource& resource, const GlslInfo::Object& info) {
    const Type& type = ObjectTypeOf(context_, resource.var);
    if (InfoOf(type.object).category == ObjectCategory::kTypedBuffer)
      context_.Require(Feature::kTextureBuffers);
    Append(text_, LayoutText({PlaceText(info), ImageFormat(context_.program, resource)}),
           context_[resource.var].coherent ? "coherent " : "",
           ImageAccess(context_.program, images_used_, context_.target, resource),
           context_.target.IsEs() ? "uniform highp " : "uniform ", PrefixOf(context_, type),
           "image", Dimension(type.object), " ", info.name, Dimensions(context_, resource.var),
           ";  // ", RegisterText(resource.reg), "\n");
  }

  WriterContext& context_;
  std::string text_;
  const std::vector<ObjectUse> images_used_ =
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
  for (const ExprId expr : context.reached.asked) {
    const auto* call = As<ObjectCall>(context.program, expr);
    if (!call) continue;
    const auto root = [&](OperandKind kind) {
      const ExprId path = context.Operand(*call, kind);
      return path ? RootOf(context.program, path) : VarId{};
    };
    TextureUse use{root(OperandKind::kObject), root(OperandKind::kSampler), {}};
    const ObjectKind kind = ObjectTypeOf(context, use.texture).object;
    if (!IsStorageBuffer(kind) && !IsImage(kind)) uses.push_back(std::move(use));
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

std::vector<GlslInfo::Object> LayObjects(WriterContext& context) {
  return ObjectLayer(context).Lay();
}

std::string WriteObjects(WriterContext& context, std::span<const GlslInfo::Object> objects) {
  return objects.empty() ? "" : ObjectWriter(context).Write(objects);
}

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
