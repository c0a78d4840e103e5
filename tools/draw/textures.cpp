// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/textures.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "ir/scalar.h"

namespace clipc::draw {
namespace {

using ir::ObjectKind;
using ir::ObjectOp;
using Size = std::array<std::uint32_t, 3>;

struct Form {
  int axes;  // that become half with every level
  bool is_array = false, is_cube = false;
  GLenum target;

  int Sizes() const { return axes + is_array; }
};

std::optional<Form> FormOf(ObjectKind kind) {
  switch (kind) {
    case ObjectKind::kTexture1D:
    case ObjectKind::kSampler1D: return Form{.axes = 1, .target = GL_TEXTURE_1D};
    case ObjectKind::kTexture1DArray:
      return Form{.axes = 1, .is_array = true, .target = GL_TEXTURE_1D_ARRAY};
    case ObjectKind::kTexture2D:
    case ObjectKind::kSampler2D: return Form{.axes = 2, .target = GL_TEXTURE_2D};
    case ObjectKind::kTexture2DArray:
      return Form{.axes = 2, .is_array = true, .target = GL_TEXTURE_2D_ARRAY};
    case ObjectKind::kTexture3D:
    case ObjectKind::kSampler3D: return Form{.axes = 3, .target = GL_TEXTURE_3D};
    case ObjectKind::kTextureCube:
    case ObjectKind::kSamplerCube:
      return Form{.axes = 2, .is_cube = true, .target = GL_TEXTURE_CUBE_MAP};
    case ObjectKind::kTextureCubeArray:
      return Form{
          .axes = 2, .is_array = true, .is_cube = true, .target = GL_TEXTURE_CUBE_MAP_ARRAY};
    default: return std::nullopt;
  }
}

Size SizeOf(const Form& form, Size size, std::size_t level) {
  for (int i = 0; i < form.axes; ++i) size[i] = std::max(size[i] >> level, 1u);
  return size;
}

ir::Scalar KindOf(const ir::Program& program, ir::VarId var) {
  const ir::TypeId element = ObjectTypeOf(program, var).element;
  return element ? ir::BaseOf(program.types[element].scalar) : ir::Scalar::kFloat;
}

// How the shader reads a texture, wherever the call is.
struct Uses {
  bool sampled = false, compared = false, constant = false;
};

std::map<std::uint32_t, Uses> FindUses(const ir::Program& program) {
  std::map<std::uint32_t, Uses> uses;
  for (const ir::ExprId id : program.exprs.ids()) {
    const auto* call = std::get_if<ir::ObjectCall>(&program.exprs[id].node);
    if (!call) continue;
    const auto var = [&](std::uint32_t argument) {
      ir::ExprId object = program.expr_lists[call->arguments][argument];
      while (const auto* index = std::get_if<ir::Index>(&program.exprs[object].node))
        object = index->base;
      const auto* ref = std::get_if<ir::VarRef>(&program.exprs[object].node);
      return ref ? ref->var : ir::VarId{};
    };
    if (!var(0)) continue;
    Uses& found = uses[var(0).index];
    const bool has_sampler = ir::TakesSampler(call->op) && var(1);
    if (has_sampler || call->op == ObjectOp::kD3d9Sample || call->op == ObjectOp::kD3d9SampleLevel)
      found.sampled = true;
    if (call->op == ObjectOp::kSampleGrad) found.constant = true;
    if (has_sampler && ObjectTypeOf(program, var(1)).object == ObjectKind::kSamplerComparison)
      found.compared = true;
  }
  return uses;
}

using Texel4 = std::array<std::uint32_t, 4>;

// The last texel of an axis is the first again.
std::uint32_t Representative(std::uint32_t at, std::uint32_t size) {
  return at + 1 == size ? 0 : at;
}

class Maker {
 public:
  Maker(const Form& form, const Uses& uses, ir::Scalar kind, RandomValues& values)
      : form_(form), uses_(uses), kind_(kind), values_(values) {}

  Texture Make() {
    Texture texture;
    for (int i = 0; i < form_.axes; ++i) {
      texture.size[i] = form_.is_cube && i == 1
                            ? texture.size[0]
                            : 3 + 2 * values_.Below(6);  // odd: 0.5 is not a border
    }
    if (form_.is_array) texture.size[form_.axes] = 3 + values_.Below(3);
    texture.is_constant = uses_.constant;
    const auto constant = Texel();
    const std::uint32_t largest =
        *std::max_element(texture.size.begin(), texture.size.begin() + form_.axes);
    for (std::size_t level = 0; largest >> level != 0; ++level) {
      const Size size = SizeOf(form_, texture.size, level);
      std::vector<Texel4> texels(std::size_t{size[0]} * size[1] * size[2]);
      for (std::size_t i = 0; i < texels.size(); ++i) {
        const std::size_t first = uses_.sampled ? FirstLike(i, size) : i;
        texels[i] = uses_.constant ? constant : first < i ? texels[first] : Texel();
      }
      auto& words = texture.levels.emplace_back();
      for (std::size_t i = 0; i < texels.size() * (form_.is_cube ? 6 : 1); ++i) {
        const Texel4& texel =
            texels[form_.is_cube ? i / (6 * size[0] * size[1]) * size[0] * size[1] : i];
        words.insert(words.end(), texel.begin(), texel.end());
      }
    }
    return texture;
  }

 private:
  // The texel that texel `index` repeats.
  std::size_t FirstLike(std::size_t index, const Size& size) const {
    std::size_t first = 0, stride = 1;
    for (int i = 0; i < 3; ++i) {
      const auto at = static_cast<std::uint32_t>(index / stride % size[i]);
      first += stride * (i < form_.axes ? Representative(at, size[i]) : at);
      stride *= size[i];
    }
    return first;
  }

  Texel4 Texel() {
    Texel4 texel;
    for (std::uint32_t& word : texel)
      word = static_cast<std::uint32_t>(uses_.compared ? Depth() : values_.Next(kind_));
    return texel;
  }
  // Inside of ]0, 1[: then it does not matter whether reference values are clamped to [0, 1] first.
  std::uint64_t Depth() {
    return ir::BitsOf((static_cast<float>(values_.Below(1u << 20)) + 0.5f) * 0x1p-20f);
  }

  Form form_;
  Uses uses_;
  ir::Scalar kind_;
  RandomValues& values_;
};

class Reader {
 public:
  Reader(const Form& form, const Texture& texture, const ir::ObjectRequest& request)
      : form_(form), texture_(texture), request_(request) {}

  // Returns false where the texture does not have what the shader asks for, or it is open.
  bool Read(std::span<std::uint64_t> result) const {
    switch (request_.op) {
      case ObjectOp::kSampleLevel:
      case ObjectOp::kD3d9SampleLevel: return Sample(LevelAt(Argument(Coordinates())), 1, result);
      case ObjectOp::kSampleGrad:
      case ObjectOp::kD3d9Sample: return Sample(0, 0, result);
      case ObjectOp::kSampleCmpLevelZero: return Compare(result);
      case ObjectOp::kGather:
      case ObjectOp::kGatherGreen:
      case ObjectOp::kGatherBlue:
      case ObjectOp::kGatherAlpha: return Gather(result);
      case ObjectOp::kTextureLoad: return Load(result);
      case ObjectOp::kTextureSize: return Sizes(result);
      case ObjectOp::kTextureLevels: result[0] = texture_.levels.size(); return true;
      default: return false;
    }
  }

 private:
  // How far a float may be from another that a driver computes for it, in texels, elements and
  // levels. A shader whose coordinates lose more than that (a sin of a large pow) finds other
  // texels; with constant textures it does not.
  static constexpr double kMargin = 1.0 / 64, kFar = 500;

  static bool Copy(const std::uint32_t* texel, std::span<std::uint64_t> result) {
    std::copy_n(texel, result.size(), result.begin());
    return true;
  }

  std::size_t Coordinates() const {
    return static_cast<std::size_t>(form_.Sizes() + form_.is_cube);
  }
  double Argument(std::size_t i) const { return ir::FloatOf(request_.arguments[i]); }
  // Component `axis` of the offset that begins at argument `first`; 0 where there is none.
  int Offset(std::size_t first, int axis) const {
    const std::size_t at = first + static_cast<std::size_t>(axis);
    return at < request_.arguments.size() ? ir::IntOf(request_.arguments[at]) : 0;
  }

  // The whole number below `value`, if a value that is a little off has the same.
  static std::optional<std::int64_t> Below(double value) {
    if (!(std::abs(value) < kFar)) return std::nullopt;
    const double low = std::floor(value - kMargin), high = std::floor(value + kMargin);
    return low == high ? std::optional(static_cast<std::int64_t>(low)) : std::nullopt;
  }

  // The texel of an axis that repeats, where its neighbour across a near border is not another.
  static std::optional<std::uint32_t> Repeated(double place, int offset, std::uint32_t size) {
    if (!(std::abs(place) < kFar)) return std::nullopt;
    const auto texel = [&](double at) {
      const auto whole = static_cast<std::int64_t>(std::floor(at)) + offset,
                 count = std::int64_t{size};
      return Representative(static_cast<std::uint32_t>((whole % count + count) % count), size);
    };
    const std::uint32_t low = texel(place - kMargin), high = texel(place + kMargin);
    return low == high ? std::optional(low) : std::nullopt;
  }

  std::optional<std::size_t> LevelAt(double lod) const {
    if (texture_.levels.size() == 1 || texture_.is_constant) return 0;
    const auto last = static_cast<double>(texture_.levels.size() - 1);
    const auto level = Below(std::clamp(lod, -1.0, last + 1) + 0.5);  // NaN stays
    if (!level) return std::nullopt;
    return static_cast<std::size_t>(std::clamp(static_cast<double>(*level), 0.0, last));
  }

  // The texel around the coordinate, `shift` texels further, with the offset at argument
  // `first_offset`.
  const std::uint32_t* TexelAt(std::size_t level, double shift, std::array<int, 2> step,
                               std::size_t first_offset) const {
    if (texture_.is_constant) return texture_.levels[0].data();
    const Size size = SizeOf(form_, texture_.size, level);
    std::size_t index = 0, stride = 1;
    for (int i = 0; i < form_.axes; ++i) {
      if (!form_.is_cube) {
        const int offset =
            Offset(first_offset, i) + (i < 2 ? step[static_cast<std::size_t>(i)] : 0);
        const auto at =
            Repeated(Argument(static_cast<std::size_t>(i)) * size[i] + shift, offset, size[i]);
        if (!at) return nullptr;
        index += *at * stride;
      }
      stride *= size[i];
    }
    if (form_.is_array) {
      const auto last = static_cast<double>(size[form_.axes] - 1);
      const auto element = Below(std::clamp(Argument(Coordinates() - 1), -1.0, last + 1) + 0.5);
      if (!element) return nullptr;
      index += static_cast<std::size_t>(std::clamp(static_cast<double>(*element), 0.0, last)) *
               stride * (form_.is_cube ? 6 : 1);
    }
    return &texture_.levels[level][4 * index];
  }

  // `between`: the number of arguments between the coordinate and the offset.
  bool Sample(std::optional<std::size_t> level, std::size_t between,
              std::span<std::uint64_t> result) const {
    const std::uint32_t* texel = level ? TexelAt(*level, 0, {}, Coordinates() + between) : nullptr;
    return texel && Copy(texel, result);
  }

  // The four texels that a linear filter would mix, counterclockwise from the lower left. With an
  // offset for each, of each footprint the upper left one.
  bool Gather(std::span<std::uint64_t> result) const {
    static constexpr std::array<std::array<int, 2>, 4> kSteps{{{0, 1}, {1, 1}, {1, 0}, {0, 0}}};
    const auto component =
        static_cast<std::size_t>(request_.op) - static_cast<std::size_t>(ObjectOp::kGather);
    const bool has_four = request_.arguments.size() == Coordinates() + 8;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t first_offset = Coordinates() + (has_four ? 2 * i : 0);
      const std::uint32_t* texel =
          TexelAt(0, -0.5, has_four ? std::array{0, 0} : kSteps[i], first_offset);
      if (!texel) return false;
      result[i] = texel[component];
    }
    return true;
  }

  bool Compare(std::span<std::uint64_t> result) const {
    const std::uint32_t* texel = TexelAt(0, 0, {}, Coordinates() + 1);
    if (!texel) return false;
    result[0] = ir::BitsOf(Argument(Coordinates()) <= ir::FloatOf(*texel) ? 1.0f : 0.0f);
    return true;
  }

  bool Load(std::span<std::uint64_t> result) const {
    const auto sizes = static_cast<std::size_t>(form_.Sizes());
    const auto level = static_cast<std::size_t>(request_.arguments[sizes]);
    if (level >= texture_.levels.size()) return false;
    const Size size = SizeOf(form_, texture_.size, level);
    std::uint32_t index = 0, stride = 1;
    for (std::size_t i = 0; i < sizes; ++i) {
      std::uint32_t at = ir::UintOf(request_.arguments[i]);
      const bool has_offset =
          request_.arguments.size() > sizes + 1 && i < static_cast<std::size_t>(form_.axes);
      if (has_offset) at += ir::UintOf(request_.arguments[sizes + 1 + i]);
      if (at >= size[i]) return false;  // a negative one is large
      index += at * stride;
      stride *= size[i];
    }
    return Copy(&texture_.levels[level][4 * std::size_t{index}], result);
  }

  bool Sizes(std::span<std::uint64_t> result) const {
    const std::uint64_t level = request_.arguments.empty() ? 0 : request_.arguments[0];
    if (level >= texture_.levels.size()) return false;
    const Size size = SizeOf(form_, texture_.size, level);
    std::copy_n(size.begin(), result.size(), result.begin());
    return true;
  }

  const Form& form_;
  const Texture& texture_;
  const ir::ObjectRequest& request_;
};

Inputs::Texture Uploaded(const Form& form, const Texture& texture, ir::Scalar kind, bool compares) {
  Inputs::Texture upload;
  upload.target = form.target;
  upload.compares = compares;
  upload.kind = KindOfTexels(kind);
  for (std::size_t level = 0; level < texture.levels.size(); ++level) {
    Size size = SizeOf(form, texture.size, level);
    if (form.is_cube && form.is_array) size[2] *= 6;
    std::vector<std::uint32_t> words = texture.levels[level];
    if (compares) {  // one word for each texel
      for (std::size_t i = 0; 4 * i < words.size(); ++i) words[i] = words[4 * i];
      words.resize(words.size() / 4);
    }
    upload.levels.push_back({size, std::move(words)});
  }
  return upload;
}

}  // namespace

Shape::Kind KindOfTexels(ir::Scalar kind) {
  return kind == ir::Scalar::kInt    ? Shape::Kind::kInt
         : kind == ir::Scalar::kUint ? Shape::Kind::kUint
                                     : Shape::Kind::kFloat;
}

const ir::Type& ObjectTypeOf(const ir::Program& program, ir::VarId var) {
  return program.types[program.types.Innermost(program.vars[var].type)];
}

std::vector<std::string> ElementIndices(const ir::Program& program, ir::VarId var) {
  std::vector<std::string> all{""};
  for (ir::TypeId id = program.vars[var].type; program.types[id].kind == ir::TypeKind::kArray;
       id = program.types[id].element) {
    if (all.size() * program.types[id].count > 256)
      throw DrawError("a large array of objects, which no test draws with");
    std::vector<std::string> longer;
    for (const std::string& indices : all) {
      for (std::uint32_t i = 0; i < program.types[id].count; ++i)
        longer.push_back(indices + "[" + std::to_string(i) + "]");
    }
    all = std::move(longer);
  }
  return all;
}

Textures MakeTextures(const ir::Program& program, const RandomOptions& options,
                      RandomValues& values) {
  std::map<std::uint32_t, Uses> uses = FindUses(program);
  Textures textures;
  for (const ir::Resource& resource : program.resources) {
    const ObjectKind kind = ObjectTypeOf(program, resource.var).object;
    if (kind == ObjectKind::kTexture2DMS || kind == ObjectKind::kTexture2DMSArray) {
      throw DrawError("the shader reads a multisampled texture, which no test draws with");
    }
    Uses& found = uses[resource.var.index];
    found.constant = found.constant || (found.sampled && options.constant_textures);
    const std::optional<Form> form =
        FormOf(kind == ObjectKind::kSampler && found.sampled ? ObjectKind::kSampler2D : kind);
    if (!form) continue;
    Maker maker(*form, found, KindOf(program, resource.var), values);
    for (std::size_t i = 0; i < ElementIndices(program, resource.var).size(); ++i) {
      textures[resource.var.index].push_back(maker.Make());
    }
  }
  return textures;
}

void ReadTexture(const ir::Program& program, const Textures& textures,
                 const ir::ObjectRequest& request, double undefined,
                 std::span<std::uint64_t> result) {
  const std::vector<Texture>& elements = textures.at(request.object.index);
  const ObjectKind kind = ObjectTypeOf(program, request.object).object;
  const Form form = FormOf(kind).value_or(Form{.axes = 2, .target = GL_TEXTURE_2D});
  const ir::Scalar component = KindOf(program, request.object);
  if (request.object_element < elements.size() &&
      Reader(form, elements[request.object_element], request).Read(result)) {
    return;
  }
  const bool is_query =
      request.op == ObjectOp::kTextureSize || request.op == ObjectOp::kTextureLevels;
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = UndefinedBits(request, undefined, is_query ? ir::Scalar::kInt : component, i);
  }
}

void GiveTextures(const ir::Program& program, const glsl::GlslInfo& info, const Textures& textures,
                  Inputs& inputs) {
  for (const glsl::GlslInfo::Object& object : info.objects) {
    const auto found = object.texture ? textures.find(object.texture.index) : textures.end();
    if (found == textures.end()) continue;
    const ObjectKind kind = ObjectTypeOf(program, object.texture).object;
    const Form form = FormOf(kind).value_or(Form{.axes = 2, .target = GL_TEXTURE_2D});
    const bool compares = object.sampler && ObjectTypeOf(program, object.sampler).object ==
                                                ObjectKind::kSamplerComparison;
    const std::vector<std::string> indices = ElementIndices(program, object.texture);
    for (std::size_t i = 0; i < indices.size(); ++i) {
      Inputs::Texture upload =
          Uploaded(form, found->second[i], KindOf(program, object.texture), compares);
      upload.name = object.name + indices[i];
      inputs.textures.push_back(std::move(upload));
    }
  }
}

}  // namespace clipc::draw
