// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/textures.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "ir/access.h"
#include "ir/scalar.h"

namespace clipc::draw {
namespace {

using namespace ir;

using Size = std::array<std::uint32_t, 3>;

const ObjectInfo& FormOf(ObjectKind kind) {
  return InfoOf(kind == ObjectKind::kSampler ? ObjectKind::kTexture2D : kind);
}

// The axes become half with every level; the elements of an array do not.
Size SizeOf(const ObjectInfo& form, Size size, std::size_t level) {
  for (int i = 0; i < form.axes; ++i) size[i] = std::max(size[i] >> level, 1u);
  return size;
}

// The images of a level that lie one after another: an array has all of its elements for each
// sample.
std::uint32_t ImagesOf(const ObjectInfo& form, const Size& size) {
  return size[2] * (form.is_multisampled && form.is_array ? kSamples : 1);
}

// The ways in which all calls of the shader together read a texture.
struct Uses {
  bool sampled = false, compared = false, constant = false;
};

std::map<std::uint32_t, Uses> FindUses(const Program& program) {
  std::map<std::uint32_t, Uses> uses;
  for (const ExprId id : program.exprs.ids()) {
    const auto* call = std::get_if<ObjectCall>(&program.exprs[id].node);
    if (!call) continue;
    const VarId object = RootOf(program, OperandOf(program, *call, OperandKind::kObject));
    if (!object) continue;
    Uses& found = uses[object.index];
    const ExprId path = OperandOf(program, *call, OperandKind::kSampler);
    const VarId sampler = path ? RootOf(program, path) : VarId{};
    if (sampler || IsSampler(ObjectTypeOf(program, object).object)) found.sampled = true;
    if (call->op == ObjectOp::kSampleGrad || call->op == ObjectOp::kD3d9SampleGrad)
      found.constant = true;
    if (InfoOf(ObjectTypeOf(program, sampler ? sampler : object).object).compares)
      found.compared = true;
  }
  return uses;
}

using Texel4 = std::array<std::uint32_t, 4>;

// The index of the texel that an axis has at `at`: the last texel is the first again.
std::uint32_t Representative(std::uint32_t at, std::uint32_t size) {
  return at + 1 == size ? 0 : at;
}

class Maker {
 public:
  Maker(const ObjectInfo& form, const Uses& uses, Scalar kind, RandomValues& values)
      : form_(form), uses_(uses), kind_(kind), values_(values) {}

  Texture Make() {
    Texture texture;
    for (int i = 0; i < form_.axes; ++i) {
      texture.size[i] = form_.is_cube && i == 1
                            ? texture.size[0]
                            : 3 + 2 * values_.Below(6);  // odd: 0.5 is not a border
    }
    if (form_.is_array) texture.size[form_.axes] = 3 + values_.Below(3);
    if (form_.is_multisampled && !form_.is_array) texture.size[form_.axes] = kSamples;
    texture.is_constant = uses_.constant;
    const auto constant = Texel();
    const std::uint32_t largest =
        *std::max_element(texture.size.begin(), texture.size.begin() + form_.axes);
    const std::uint32_t smallest = form_.is_multisampled ? largest : 1;
    for (std::size_t level = 0; largest >> level >= smallest; ++level) {
      const Size size = SizeOf(form_, texture.size, level);
      const std::size_t face = std::size_t{size[0]} * size[1];
      std::vector<Texel4> texels(face * ImagesOf(form_, size));
      for (std::size_t i = 0; i < texels.size(); ++i) {
        const std::size_t first = uses_.sampled ? FirstLike(i, size) : i;
        texels[i] = uses_.constant ? constant : first < i ? texels[first] : Texel();
      }
      Words& words = texture.levels.emplace_back();
      for (std::size_t i = 0; i < texels.size() * (form_.is_cube ? 6 : 1); ++i) {
        const Texel4& texel = texels[form_.is_cube ? i / (6 * face) * face : i];
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
      const std::uint32_t at = index / stride % size[i];
      first += stride * (i < form_.axes ? Representative(at, size[i]) : at);
      stride *= size[i];
    }
    return first;
  }

  Texel4 Texel() {
    Texel4 texel;
    for (std::uint32_t& word : texel) word = uses_.compared ? Depth() : values_.Next(kind_);
    return texel;
  }
  // A random depth inside of ]0, 1[: then it does not matter whether reference values are clamped
  // to [0, 1] first.
  std::uint64_t Depth() {
    return BitsOf((static_cast<float>(values_.Below(1u << 20)) + 0.5f) * 0x1p-20f);
  }

  const ObjectInfo& form_;
  Uses uses_;
  Scalar kind_;
  RandomValues& values_;
};

class Reader {
 public:
  Reader(const ObjectInfo& form, const Texture& texture, const ObjectRequest& request)
      : form_(form), texture_(texture), request_(request) {}

  // Answers the request. Returns false where the texture does not have the texel that the shader
  // asks for, or the texel is open.
  bool Read(std::span<std::uint64_t> result) const {
    switch (request_.op) {
      case ObjectOp::kSampleLevel:
      case ObjectOp::kD3d9SampleLevel: return Sample(LevelAt(Number(OperandKind::kLevel)), result);
      case ObjectOp::kSampleBias:
      case ObjectOp::kD3d9SampleBias:
        return Sample(LevelFromNeighbours(Number(OperandKind::kBias)), result);
      case ObjectOp::kSample:
      case ObjectOp::kD3d9Sample:
      case ObjectOp::kD3d9SampleProjected: return Sample(LevelFromNeighbours(0), result);
      case ObjectOp::kSampleGrad:
      case ObjectOp::kD3d9SampleGrad: return Sample(0, result);
      case ObjectOp::kSampleCmp: return Compare(LevelFromNeighbours(0), result);
      case ObjectOp::kSampleCmpLevelZero: return Compare(0, result);
      case ObjectOp::kGather:
      case ObjectOp::kGatherGreen:
      case ObjectOp::kGatherBlue:
      case ObjectOp::kGatherAlpha: return Gather(result);
      case ObjectOp::kTextureLoad: return Load(result);
      case ObjectOp::kTextureSize: return Sizes(result);
      case ObjectOp::kTextureSamples: result[0] = kSamples; return true;
      case ObjectOp::kTextureLevels: result[0] = texture_.levels.size(); return true;
      default: return false;
    }
  }

 private:
  // kMargin is the largest difference between a coordinate and the one that a driver computes for
  // it, in texels, elements and levels; kFar is the largest coordinate that is read, in texels. A
  // shader whose coordinates lose more than kMargin (a sin of a large pow) finds other texels; with
  // constant textures it does not.
  static constexpr double kMargin = 1.0 / 64, kFar = 500;
  // The largest error of the logarithm by which a driver finds a level.
  static constexpr double kLogarithmError = 0.1;

  static bool Copy(const std::uint32_t* texel, std::span<std::uint64_t> result) {
    if (texel) std::copy_n(texel, result.size(), result.begin());
    return texel != nullptr;
  }

  // The only component of an operand.
  double Number(OperandKind kind) const { return FloatOf(request_.Of(kind)[0]); }
  double Given(std::size_t i) const { return FloatOf(request_.Of(OperandKind::kCoordinate)[i]); }
  // Component `axis` of an offset; 0 where there is none.
  int Offset(std::size_t axis, std::size_t which = 0) const {
    const auto offsets = request_.Of(OperandKind::kOffset);
    const std::size_t at = which * form_.axes + axis;
    return at < offsets.size() ? IntOf(offsets[at]) : 0;
  }

  // The number from 0 to `last` that is nearest to `value`; none if a value that is a little off
  // has another.
  static std::optional<std::size_t> Nearest(double value, std::size_t last) {
    const double end = static_cast<double>(last), within = std::clamp(value, 0.0, end) + 0.5;
    const double low = std::floor(within - kMargin), high = std::floor(within + kMargin);
    if (low != high) return std::nullopt;  // NaN too
    return static_cast<std::size_t>(low);
  }

  // The texel at `place` of an axis that repeats; none if the neighbour across a near border is
  // another texel.
  static std::optional<std::uint32_t> Repeated(double place, int offset, std::uint32_t size) {
    if (!(std::abs(place) < kFar)) return std::nullopt;
    const auto texel = [&](double at) {
      const auto whole = static_cast<std::int64_t>(std::floor(at)) + offset,
                 count = std::int64_t{size};
      return Representative((whole % count + count) % count, size);
    };
    const std::uint32_t low = texel(place - kMargin), high = texel(place + kMargin);
    return low == high ? std::optional(low) : std::nullopt;
  }

  double Clamp() const {
    return request_.Of(OperandKind::kClamp).empty() ? 0 : Number(OperandKind::kClamp);
  }
  std::optional<std::size_t> LevelAt(double lod) const {
    return texture_.is_constant ? 0 : Nearest(std::max(lod, Clamp()), texture_.levels.size() - 1);
  }

  // The level that the coordinates of the quad give: that of the longest step from pixel to pixel,
  // in texels. Drivers measure it in any row and column, as the largest component or as the length,
  // so the level is open where these differ.
  std::optional<std::size_t> LevelFromNeighbours(double bias) const {
    if (texture_.is_constant) return 0;
    if (request_.coordinates.empty()) return LevelAt(bias);
    if (form_.is_cube) return std::nullopt;
    double least = HUGE_VAL, most = 0;
    for (const std::size_t row : {0, 2}) {
      for (const std::size_t column : {0, 1}) {
        double largest = 0, along_x = 0, along_y = 0;
        for (std::size_t i = 0; i < form_.axes; ++i) {
          const double x = Step(row, row + 1, i), y = Step(column, column + 2, i);
          if (std::isnan(x + y)) return std::nullopt;
          largest = std::max({largest, std::abs(x), std::abs(y)});
          along_x = std::hypot(along_x, x), along_y = std::hypot(along_y, y);
        }
        least = std::min(least, largest), most = std::max({most, along_x, along_y});
      }
    }
    const auto low = LevelAt(std::log2(least) + bias - kLogarithmError);
    const auto high = LevelAt(std::log2(most) + bias + kLogarithmError);
    return low == high ? low : std::nullopt;
  }

  // The texels along axis `i` between two pixels of the quad.
  double Step(std::size_t from, std::size_t to, std::size_t i) const {
    const std::size_t size = request_.coordinates.size() / kQuadPixels;
    const bool divides = request_.op == ObjectOp::kD3d9SampleProjected;
    const auto at = [&](std::size_t pixel) {
      const double* coordinate = &request_.coordinates[pixel * size];
      return coordinate[i] / (divides ? coordinate[3] : 1);
    };
    return (at(to) - at(from)) * texture_.size[i];
  }
  // Component i of the pixel's own coordinate.
  double Coordinate(std::size_t i) const {
    return Given(i) / (request_.op == ObjectOp::kD3d9SampleProjected ? Given(3) : 1);
  }

  // The texel around the coordinate, `shift` texels further, with the offset of that number; null
  // where it is open.
  const std::uint32_t* TexelAt(std::size_t level, double shift = 0, std::array<int, 3> step = {},
                               std::size_t offset = 0) const {
    if (texture_.is_constant) return texture_.levels[0].data();
    const Size size = SizeOf(form_, texture_.size, level);
    std::size_t index = 0, stride = 1;
    for (std::size_t i = 0; i < form_.axes; ++i) {
      if (!form_.is_cube) {
        const auto at =
            Repeated(Coordinate(i) * size[i] + shift, Offset(i, offset) + step[i], size[i]);
        if (!at) return nullptr;
        index += *at * stride;
      }
      stride *= size[i];
    }
    if (form_.is_array) {
      const auto element = Nearest(Given(coordinates_ - 1), size[form_.axes] - 1);
      if (!element) return nullptr;
      index += *element * stride * (form_.is_cube ? 6 : 1);
    }
    return &texture_.levels[level][4 * index];
  }

  bool Sample(std::optional<std::size_t> level, std::span<std::uint64_t> result) const {
    if (form_.compares) return Compare(level, result);
    return level && Copy(TexelAt(*level), result);
  }

  // Reads the four texels that a linear filter would mix, counterclockwise from the lower left,
  // each with its own offset if there are four.
  bool Gather(std::span<std::uint64_t> result) const {
    static constexpr std::array<int, 3> kSteps[] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    const bool has_four = request_.Of(OperandKind::kOffset).size() == 8;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint32_t* texel = TexelAt(0, -0.5, kSteps[i], has_four ? i : 0);
      if (!texel) return false;
      result[i] = texel[ComponentOf(request_.op)];
    }
    return true;
  }

  bool Compare(std::optional<std::size_t> level, std::span<std::uint64_t> result) const {
    if (!level) return false;
    // The reference of Direct3D 9's reads is a component of the coordinate.
    const double reference =
        form_.compares ? Coordinate(coordinates_) : Number(OperandKind::kReference);
    const std::uint32_t* texel = TexelAt(*level);
    if (texel) result[0] = BitsOf(reference <= FloatOf(*texel) ? 1.0f : 0.0f);
    return texel != nullptr;
  }

  bool Load(std::span<std::uint64_t> result) const {
    // The level of a texture that has no other ones is the sample.
    const auto place = request_.Of(OperandKind::kPlace);
    const std::uint64_t number = UintOf(request_.Of(OperandKind::kLevel)[0]);
    const std::uint64_t level = form_.is_multisampled ? 0 : number;
    if (level >= texture_.levels.size()) return false;
    const Size size = SizeOf(form_, texture_.size, level);
    std::size_t index = 0, stride = 1;
    for (std::size_t i = 0; i < place.size(); ++i) {
      std::uint32_t at = UintOf(place[i]);
      if (i < form_.axes) at += Offset(i);
      if (at >= size[i]) return false;  // a negative one is large
      index += at * stride;
      stride *= size[i];
    }
    if (form_.is_multisampled) {
      if (number >= kSamples) return false;
      index += number * stride;
    }
    return Copy(&texture_.levels[level][4 * index], result);
  }

  bool Sizes(std::span<std::uint64_t> result) const {
    const std::uint64_t level = request_.Of(OperandKind::kLevel)[0];
    if (level >= texture_.levels.size()) return false;
    const Size size = SizeOf(form_, texture_.size, level);
    std::copy_n(size.begin(), result.size(), result.begin());
    return true;
  }

  const ObjectInfo& form_;
  const Texture& texture_;
  const ObjectRequest& request_;
  // The number of components of a coordinate: a cube's is a direction, and an array's has the
  // element too.
  const std::size_t coordinates_ = std::size_t{form_.axes} + form_.is_array + form_.is_cube;
};

Inputs::Texture Uploaded(const ObjectInfo& form, const Texture& texture, Scalar kind,
                         bool compares) {
  Inputs::Texture upload;
  upload.target = TargetOf(form), upload.kind = KindOfTexels(kind), upload.compares = compares;
  for (std::size_t level = 0; level < texture.levels.size(); ++level) {
    Size size = SizeOf(form, texture.size, level);
    size[2] = ImagesOf(form, size);
    if (form.is_cube && form.is_array) size[2] *= 6;
    Words words = texture.levels[level];
    if (compares) {  // one word for each texel
      for (std::size_t i = 0; 4 * i < words.size(); ++i) words[i] = words[4 * i];
      words.resize(words.size() / 4);
    }
    upload.levels.push_back({size, std::move(words)});
  }
  return upload;
}

}  // namespace

GLenum TargetOf(const ObjectInfo& form) {
  if (form.is_multisampled)
    return form.is_array ? GL_TEXTURE_2D_MULTISAMPLE_ARRAY : GL_TEXTURE_2D_MULTISAMPLE;
  constexpr GLenum kTargets[][2] = {{GL_TEXTURE_1D, GL_TEXTURE_1D_ARRAY},
                                    {GL_TEXTURE_2D, GL_TEXTURE_2D_ARRAY},
                                    {GL_TEXTURE_3D, GL_NONE},
                                    {GL_TEXTURE_CUBE_MAP, GL_TEXTURE_CUBE_MAP_ARRAY}};
  return kTargets[form.is_cube ? 3 : form.axes - 1][form.is_array];
}

WordKind KindOfTexels(Scalar kind) {
  return kind == Scalar::kInt    ? WordKind::kInt
         : kind == Scalar::kUint ? WordKind::kUint
                                 : WordKind::kFloat;
}

Scalar ElementKind(const Program& program, VarId var) {
  const TypeId element = ObjectTypeOf(program, var).element;
  return element ? BaseOf(program.types[element].scalar) : Scalar::kFloat;
}

const Type& ObjectTypeOf(const Program& program, VarId var) {
  return program.types[program.types.Innermost(program.vars[var].type)];
}

std::vector<std::string> ElementIndices(const Program& program, VarId var) {
  constexpr std::uint32_t kUnsized = 4;  // elements of an array without a size
  std::vector<std::string> all{""};
  for (TypeId id = program.vars[var].type; program.types[id].kind == TypeKind::kArray;
       id = program.types[id].element) {
    const std::uint32_t count = program.types[id].count == 0 ? kUnsized : program.types[id].count;
    if (all.size() * count > 256)
      throw DrawError("a large array of objects, which no test draws with");
    std::vector<std::string> longer;
    for (const std::string& indices : all) {
      for (std::uint32_t i = 0; i < count; ++i)
        longer.push_back(indices + "[" + std::to_string(i) + "]");
    }
    all = std::move(longer);
  }
  return all;
}

Textures MakeTextures(const Program& program, const RandomOptions& options, RandomValues& values) {
  std::map<std::uint32_t, Uses> uses = FindUses(program);
  Textures textures;
  for (const Resource& resource : program.resources) {
    const ObjectKind kind = ObjectTypeOf(program, resource.var).object;
    Uses& found = uses[resource.var.index];
    found.constant = found.constant || (found.sampled && options.constant_textures);
    if (!IsTexture(kind) && !IsCombinedSampler(kind) &&
        !(kind == ObjectKind::kSampler && found.sampled))
      continue;
    Maker maker(FormOf(kind), found, ElementKind(program, resource.var), values);
    for (std::size_t i = 0; i < ElementIndices(program, resource.var).size(); ++i)
      textures[resource.var.index].push_back(maker.Make());
  }
  return textures;
}

void ReadTexture(const Program& program, const Textures& textures, const ObjectRequest& request,
                 double undefined, std::span<std::uint64_t> result) {
  const std::vector<Texture>& elements = textures.at(request.object.index);
  const ObjectInfo& form = FormOf(ObjectTypeOf(program, request.object).object);
  if (request.object_element < elements.size() &&
      Reader(form, elements[request.object_element], request).Read(result)) {
    return;
  }
  const bool is_query = request.op == ObjectOp::kTextureSize ||
                        request.op == ObjectOp::kTextureLevels ||
                        request.op == ObjectOp::kTextureSamples;
  const Scalar kind = is_query ? Scalar::kInt : ElementKind(program, request.object);
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = UndefinedBits(request, undefined, kind, i);
}

void GiveTextures(const Program& program, const GlslInfo& info, const Textures& textures,
                  Inputs& inputs) {
  for (const GlslInfo::Object& object : info.objects) {
    const auto found = object.texture ? textures.find(object.texture.index) : textures.end();
    if (found == textures.end()) continue;
    const VarId sampler = object.sampler ? object.sampler : object.texture;
    const bool compares = InfoOf(ObjectTypeOf(program, sampler).object).compares;
    const std::vector<std::string> indices = ElementIndices(program, object.texture);
    for (std::size_t i = 0; i < indices.size(); ++i) {
      Inputs::Texture& upload = inputs.textures.emplace_back(
          Uploaded(FormOf(ObjectTypeOf(program, object.texture).object), found->second[i],
                   ElementKind(program, object.texture), compares));
      upload.name = object.name + indices[i];
    }
  }
}

}  // namespace clipc::draw
