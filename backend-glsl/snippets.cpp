// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/snippets.h"

#include <algorithm>

namespace clipc::glsl {

using ir::Scalar;

namespace {

constexpr std::string_view kUnpackedBytes = R"(uvec4 $N(uint x) {
    return (uvec4(x) >> uvec4(0, 8, 16, 24)) & 255u;
}
)";
constexpr std::string_view kUnpackedSigned = R"(ivec4 $N(uint x) {
    return ivec4(uvec4(x) << uvec4(24, 16, 8, 0)) >> 24;
}
)";

constexpr SnippetText kSnippets[] = {
    // ---- HLSL's own meaning, on every target
    {"saturate", SnippetText::kFloat, false,
     R"($T $N($T x) {
    return min(max($0, x), 1.0);  // 0 for NaN
}
)"},
    {"smoothstep", SnippetText::kFloat, false,
     R"($T $N($T a, $T b, $T x) {
    $T t = @saturate((x - a) / (b - a));
    return t * t * (t * -2.0 + 3.0);
}
)"},
    {"isfinite", SnippetText::kFloat, true,
     R"($B $N($T x) {
    return !(@isnan(x) || @isinf(x));
}
)"},
    {"lit", SnippetText::kFloat, true,
     R"(vec4 $N(float n_dot_l, float n_dot_h, float m) {
    float specular = n_dot_l < 0.0 || n_dot_h < 0.0 ? 0.0 : pow(n_dot_h, m);
    return vec4(1.0, max(n_dot_l, 0.0), specular, 1.0);
}
)"},
    {"msad4", SnippetText::kUint, true,
     R"(uvec4 $N(uint reference, uvec2 source, uvec4 sums) {
    uvec4 windows = uvec4(source.x, source.x >> 8 | source.y << 24, source.x >> 16 | source.y << 16, source.x >> 24 | source.y << 8);
    for (int i = 0; i < 32; i += 8) {
        int wanted = int(reference >> i & 255u);
        if (wanted != 0) sums += uvec4(abs(ivec4(windows >> i & 255u) - wanted));
    }
    return sums;
}
)"},
    {"QuadAll", SnippetText::kAny, true,
     R"(bool $N(bool x) {
    return all(bvec4(x, subgroupQuadSwapHorizontal(x), subgroupQuadSwapVertical(x), subgroupQuadSwapDiagonal(x)));
}
)"},
    {"QuadAny", SnippetText::kAny, true,
     R"(bool $N(bool x) {
    return any(bvec4(x, subgroupQuadSwapHorizontal(x), subgroupQuadSwapVertical(x), subgroupQuadSwapDiagonal(x)));
}
)"},
    {"dot2add", SnippetText::kFloat, false,
     R"(float $N(vec2 a, vec2 b, float sum) {
    return dot(a, b) + sum;
}
)"},
    {"dot4add_u8packed", SnippetText::kUint, false,
     R"(uint $N(uint a, uint b, uint sum) {
    for (int i = 0; i < 32; i += 8) sum += ((a >> i) & 255u) * ((b >> i) & 255u);
    return sum;
}
)"},
    {"dot4add_i8packed", SnippetText::kUint, false,
     R"(int $N(uint a, uint b, int sum) {
    for (int i = 0; i < 32; i += 8) sum += (int(a << i) >> 24) * (int(b << i) >> 24);
    return sum;
}
)"},
    {"pack_u8", SnippetText::kUint, false,
     R"(uint $N(uvec4 x) {
    uvec4 bytes = (x & 255u) << uvec4(0, 8, 16, 24);
    return bytes.x | bytes.y | bytes.z | bytes.w;
}
)"},
    {"pack_s8", SnippetText::kInt, false,
     R"(uint $N(ivec4 x) {
    uvec4 bytes = (uvec4(x) & 255u) << uvec4(0, 8, 16, 24);
    return bytes.x | bytes.y | bytes.z | bytes.w;
}
)"},
    {"pack_clamp_u8", SnippetText::kInt, false,
     R"(uint $N(ivec4 x) {
    uvec4 bytes = uvec4(clamp(x, 0, 255)) << uvec4(0, 8, 16, 24);
    return bytes.x | bytes.y | bytes.z | bytes.w;
}
)"},
    {"pack_clamp_s8", SnippetText::kInt, false,
     R"(uint $N(ivec4 x) {
    uvec4 bytes = (uvec4(clamp(x, -128, 127)) & 255u) << uvec4(0, 8, 16, 24);
    return bytes.x | bytes.y | bytes.z | bytes.w;
}
)"},
    {"unpack_u8u32", SnippetText::kUint, false, kUnpackedBytes},
    {"unpack_u8u16", SnippetText::kUint, false, kUnpackedBytes},
    {"unpack_s8s32", SnippetText::kUint, false, kUnpackedSigned},
    {"unpack_s8s16", SnippetText::kUint, false, kUnpackedSigned},
    {"dst", SnippetText::kFloat, false,
     R"(vec4 $N(vec4 a, vec4 b) {
    return vec4(1.0, a.y * b.y, a.z, b.w);
}
)"},
    {"frexp", SnippetText::kFloat, true,
     R"($T $N($T x, out $T exponent) {
    uint bits = floatBitsToUint(x);
    exponent = x == 0.0 ? 0.0 : float(int((bits >> 23) & 255u) - 126);
    return x == 0.0 ? 0.0 : uintBitsToFloat((bits & 0x007FFFFFu) | 0x3F000000u);
}
)"},
    {"asuint64", SnippetText::kFloat, true,
     R"(void $N(double x, out uint low, out uint high) {
    uvec2 words = unpackDouble2x32(x);
    low = words.x;
    high = words.y;
}
)"},

    // ---- before GLSL 1.30
    {"trunc", SnippetText::kFloat, false,
     R"($T $N($T x) {
    return sign(x) * floor(abs(x));
}
)"},
    {"round", SnippetText::kFloat, true,
     R"(float $N(float x) {
    float below = floor(x);
    float rest = x - below;
    return rest < 0.5 || (rest == 0.5 && mod(below, 2.0) == 0.0) ? below : below + 1.0;
}
)"},
    {"isnan", SnippetText::kFloat, true,
     R"(bool $N(float x) {
    return x != x;
}
)"},
    {"isinf", SnippetText::kFloat, true,
     R"(bool $N(float x) {
    return x != 0.0 && x + x == x;
}
)"},
    {"sinh", SnippetText::kFloat, false,
     R"($T $N($T x) {
    return 0.5 * (exp(x) - exp(-x));
}
)"},
    {"cosh", SnippetText::kFloat, false,
     R"($T $N($T x) {
    return 0.5 * (exp(x) + exp(-x));
}
)"},
    {"tanh", SnippetText::kFloat, false,
     R"($T $N($T x) {
    $T e = exp(-2.0 * abs(x));
    return sign(x) * (1.0 - e) / (1.0 + e);
}
)"},
    {"abs", SnippetText::kInt, true,
     R"(int $N(int x) {
    return x < 0 ? -x : x;
}
)"},
    {"sign", SnippetText::kInt, true,
     R"(int $N(int x) {
    return x > 0 ? 1 : x < 0 ? -1 : 0;
}
)"},
    {"min", SnippetText::kAny, true,
     R"($T $N($T x, $T y) {
    return y < x ? y : x;
}
)"},
    {"max", SnippetText::kAny, true,
     R"($T $N($T x, $T y) {
    return x < y ? y : x;
}
)"},
    {"clamp", SnippetText::kAny, true,
     R"($T $N($T x, $T low, $T high) {
    $T y = x < low ? low : x;
    return high < y ? high : y;
}
)"},

    // ---- before GLSL 1.50
    {"determinant2", SnippetText::kFloat, false,
     R"(float $N(mat2 m) {
    return m[0].x * m[1].y - m[0].y * m[1].x;
}
)"},
    {"determinant3", SnippetText::kFloat, false,
     R"(float $N(mat3 m) {
    return dot(m[0], cross(m[1], m[2]));
}
)"},
    {"determinant4", SnippetText::kFloat, false,
     R"(float $N(mat4 m) {
    vec2 a = m[0].x * m[1].yz - m[1].x * m[0].yz;
    float b = m[0].x * m[1].w - m[1].x * m[0].w;
    vec2 c = m[0].yy * m[1].zw - m[1].yy * m[0].zw;
    float d = m[0].z * m[1].w - m[1].z * m[0].w;
    vec2 e = m[2].x * m[3].yz - m[3].x * m[2].yz;
    float f = m[2].x * m[3].w - m[3].x * m[2].w;
    vec2 g = m[2].yy * m[3].zw - m[3].yy * m[2].zw;
    float h = m[2].z * m[3].w - m[3].z * m[2].w;
    return a.x * h - a.y * g.y + b * g.x + c.x * f - c.y * e.y + d * e.x;
}
)"},

    // ---- before GLSL 4.00 and GLSL ES 3.10
    {"countbits", SnippetText::kUint, false,
     R"($T $N($T x) {
    x -= (x >> 1) & 0x55555555u;
    x = (x & 0x33333333u) + ((x >> 2) & 0x33333333u);
    x = (x + (x >> 4)) & 0x0F0F0F0Fu;
    return (x * 0x01010101u) >> 24;
}
)"},
    {"reversebits", SnippetText::kUint, false,
     R"($T $N($T x) {
    x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    x = ((x >> 4) & 0x0F0F0F0Fu) | ((x & 0x0F0F0F0Fu) << 4);
    x = ((x >> 8) & 0x00FF00FFu) | ((x & 0x00FF00FFu) << 8);
    return (x >> 16) | (x << 16);
}
)"},
    {"firstbithigh", SnippetText::kUint, true,
     R"(uint $N(uint x) {
    for (int i = 31; i >= 0; --i) {
        if (((x >> i) & 1u) != 0u) return uint(i);
    }
    return 0xFFFFFFFFu;
}
)"},
    {"firstbithigh", SnippetText::kInt, true,
     R"(uint $N(int x) {
    for (int i = 30; i >= 0; --i) {
        if (((x >> i) & 1) != (x < 0 ? 1 : 0)) return uint(i);
    }
    return 0xFFFFFFFFu;
}
)"},
    {"firstbitlow", SnippetText::kAny, true,
     R"(uint $N($T x) {
    for (int i = 0; i < 32; ++i) {
        if (((x >> i) & $T(1)) != $T(0)) return uint(i);
    }
    return 0xFFFFFFFFu;
}
)"},

    // ---- GLSL ES, where the functions give a lowp int: of 16 bits, which -1 shows
    {"count_bits", SnippetText::kAny, false,
     R"($U $N($T x) {
    $I count = bitCount(x);
    return $U(count);
}
)"},
    {"first_bit_high", SnippetText::kAny, false,
     R"($U $N($T x) {
    $I bit = findMSB(x);
    return $U(bit);
}
)"},
    {"first_bit_low", SnippetText::kAny, false,
     R"($U $N($T x) {
    $I bit = findLSB(x);
    return $U(bit);
}
)"},

    // ---- before GLSL 4.20
    {"f16tof32", SnippetText::kUint, true,
     R"(float $N(uint x) {
    uint sign_bit = (x & 0x8000u) << 16;
    uint exponent = (x >> 10) & 31u;
    uint mantissa = x & 1023u;
    if (exponent == 0u) return uintBitsToFloat(sign_bit | floatBitsToUint(float(mantissa) * exp2(-24.0)));
    if (exponent == 31u) return uintBitsToFloat(sign_bit | 0x7F800000u | (mantissa << 13));
    return uintBitsToFloat(sign_bit | ((exponent + 112u) << 23) | (mantissa << 13));
}
)"},
    {"f32tof16", SnippetText::kFloat, true,
     R"(uint $N(float x) {
    uint bits = floatBitsToUint(x);
    uint sign_bit = (bits >> 16) & 0x8000u;
    bits &= 0x7FFFFFFFu;
    if (bits > 0x7F800000u) return sign_bit | 0x7E00u;
    if (bits >= 0x477FF000u) return sign_bit | 0x7C00u;
    if (bits < 0x38800000u) return sign_bit | uint(roundEven(abs(x) * 16777216.0));
    return sign_bit | ((bits - 0x38000000u + 0x0FFFu + ((bits >> 13) & 1u)) >> 13);
}
)"},
};

bool Takes(const SnippetText& snippet, const Shape& shape) {
  switch (snippet.kind) {
    case SnippetText::kFloat: return shape.IsFloating();
    case SnippetText::kInt: return shape.scalar == Scalar::kInt || shape.scalar == Scalar::kInt64;
    case SnippetText::kUint:
      return shape.scalar == Scalar::kUint || shape.scalar == Scalar::kUint64;
    case SnippetText::kAny: return true;
  }
  return false;
}

}  // namespace

const SnippetText* FindSnippet(std::string_view name, const Shape& shape) {
  for (const SnippetText& snippet : kSnippets) {
    if (snippet.name == name && Takes(snippet, shape)) return &snippet;
  }
  return nullptr;
}

std::string Expand(const SnippetText& snippet, std::string_view function, const Shape& shape,
                   bool has_unsigned,
                   const std::function<std::string(std::string_view)>& name_of_other) {
  const auto type = [&](Scalar kind) { return legalize::NameOf(shape.With(kind), has_unsigned); };
  std::string out;
  out.reserve(2 * snippet.text.size());
  for (std::size_t i = 0; i < snippet.text.size(); ++i) {
    const std::size_t place =
        std::min({snippet.text.find('@', i), snippet.text.find('$', i), snippet.text.size()});
    out += snippet.text.substr(i, place - i);
    i = place;
    if (i == snippet.text.size()) break;
    if (snippet.text[i] == '@') {
      const std::size_t end = snippet.text.find('(', i);
      out += name_of_other(snippet.text.substr(i + 1, end - i - 1));
      i = end - 1;
      continue;
    }
    switch (snippet.text[++i]) {
      case 'N': out += function; break;
      case 'T': out += legalize::NameOf(shape, has_unsigned); break;
      case '0':
        out += shape.IsScalar() ? "0.0" : legalize::NameOf(shape, has_unsigned) + "(0.0)";
        break;
      case 'B': out += type(Scalar::kBool); break;
      case 'I': out += type(Scalar::kInt); break;
      case 'U': out += type(Scalar::kUint); break;
      case 'F': out += type(Scalar::kFloat); break;
      default: break;
    }
  }
  return out;
}

}  // namespace clipc::glsl
