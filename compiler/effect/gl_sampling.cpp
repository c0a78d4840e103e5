// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/effect/gl_sampling.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string_view>

#include "base/spelling.h"
#include "compiler/effect/gl_words.h"

namespace clipc {
namespace {

using ast::EffectState;
using ast::EffectValue;

enum class Filter : std::uint8_t { kNone, kPoint, kLinear, kAnisotropic };  // as gl_words.def

// The name in capitals and without `_`.
std::string PlainName(const EffectState& state) {
  std::string name = ToUpper(state.word);
  std::erase(name, '_');
  return name;
}

// How a value is understood.
enum class Answer : std::uint8_t { kRead, kNotConstant, kUnknownState };

class SamplingReader {
 public:
  explicit SamplingReader(bool is_old) {
    if (is_old) min_ = mag_ = Filter::kPoint;
    if (is_old) mip_ = Filter::kNone;
    made_.wrap.fill(is_old ? 0x2901 : 0x812F);
    made_.border.fill(is_old ? 0 : 1);
  }

  Answer Add(const EffectState& state) {
    const std::string name = PlainName(state);
    const EffectValue& value = state.value;
    if (name == "MINFILTER") return Read(value, min_);
    if (name == "MAGFILTER") return Read(value, mag_);
    if (name == "MIPFILTER") return Read(value, mip_);
    if (name == "ADDRESSU") return Read(GlWords::kWrap, value, made_.wrap[0]);
    if (name == "ADDRESSV") return Read(GlWords::kWrap, value, made_.wrap[1]);
    if (name == "ADDRESSW") return Read(GlWords::kWrap, value, made_.wrap[2]);
    if (name == "FILTER") return ReadFilters(value);
    if (name == "BORDERCOLOR") return ReadBorder(value);
    if (name == "MAXANISOTROPY") return Read(value, anisotropy_);
    if (name == "MIPMAPLODBIAS" || name == "MIPLODBIAS") return Read(value, made_.lod_bias);
    if (name == "MAXMIPLEVEL" || name == "MINLOD") return Read(value, made_.min_lod);
    if (name == "MAXLOD") return Read(value, made_.max_lod);
    if (name == "COMPARISONFUNC") return Read(GlWords::kCompare, value, made_.compare_func);
    return Answer::kUnknownState;
  }

  GlSampling Finish() && {
    const std::uint32_t is_linear = IsLinear(min_) ? 1 : 0;
    const std::uint32_t levels = mip_ == Filter::kNone ? 0 : mip_ == Filter::kPoint ? 0x100 : 0x102;
    made_.min_filter = kGlNearest + levels + is_linear;
    made_.mag_filter = kGlNearest + (IsLinear(mag_) ? 1 : 0);
    if (min_ == Filter::kAnisotropic || mag_ == Filter::kAnisotropic)
      made_.max_anisotropy = anisotropy_;
    return made_;
  }

 private:
  static bool IsLinear(Filter filter) {
    return filter == Filter::kLinear || filter == Filter::kAnisotropic;
  }

  static Answer Read(GlWords list, const EffectValue& value, std::uint32_t& to) {
    const auto word = ReadWord(list, value);
    if (word) to = *word;
    return word ? Answer::kRead : Answer::kNotConstant;
  }
  static Answer Read(const EffectValue& value, Filter& to) {
    std::uint32_t word = 0;
    const Answer answer = Read(GlWords::kFilter, value, word);
    if (answer == Answer::kRead) to = static_cast<Filter>(word);
    return answer;
  }
  static Answer Read(const EffectValue& value, double& to) {
    if (!value.IsNumber()) return Answer::kNotConstant;
    to = value.number;
    return Answer::kRead;
  }

  // MIN_MAG_LINEAR_MIP_POINT, COMPARISON_ANISOTROPIC
  Answer ReadFilters(const EffectValue& value) {
    const std::string upper = ToUpper(value.word);
    std::string_view rest = upper;
    for (const std::string_view prefix : {"D3D10_FILTER_", "D3D11_FILTER_", "FILTER_"}) {
      if (rest.starts_with(prefix)) rest.remove_prefix(prefix.size());
    }
    constexpr std::string_view kCompares = "COMPARISON_";
    if (rest.starts_with(kCompares)) {
      rest.remove_prefix(kCompares.size());
      if (made_.compare_func == 0) made_.compare_func = 0x200;
    }
    if (rest == "ANISOTROPIC") {
      min_ = mag_ = Filter::kAnisotropic;
      mip_ = Filter::kLinear;
      return Answer::kRead;
    }
    std::vector<Filter*> named;
    while (!rest.empty()) {
      const std::string_view part = rest.substr(0, rest.find('_'));
      rest.remove_prefix(std::min(part.size() + 1, rest.size()));
      if (part == "MIN" || part == "MAG" || part == "MIP") {
        named.push_back(part == "MIN" ? &min_ : part == "MAG" ? &mag_ : &mip_);
      } else if (part == "POINT" || part == "LINEAR") {
        for (Filter* filter : named) *filter = part == "POINT" ? Filter::kPoint : Filter::kLinear;
        named.clear();
      } else {
        return Answer::kNotConstant;
      }
    }
    return value.word.empty() ? Answer::kNotConstant : Answer::kRead;
  }

  // 0xAARRGGBB, or up to four numbers.
  Answer ReadBorder(const EffectValue& value) {
    auto color = ReadNumbers(value);
    if (!color) return Answer::kNotConstant;
    if (value.IsNumber() && value.is_integer) {
      const std::uint32_t bits = ReadUnsigned(value).value_or(0);
      color->clear();
      for (const int shift : {16, 8, 0, 24}) color->push_back((bits >> shift & 255) / 255.0);
    }
    color->resize(made_.border.size(), 1.0);
    std::ranges::copy(*color, made_.border.begin());
    return Answer::kRead;
  }

  GlSampling made_;
  Filter min_ = Filter::kLinear, mag_ = Filter::kLinear, mip_ = Filter::kLinear;
  double anisotropy_ = 1;
};

bool NamesTexture(const EffectState& state) { return PlainName(state) == "TEXTURE"; }

}  // namespace

GlSampling ReadGlSampling(const std::vector<EffectState>& states, bool is_old,
                          StateReport& report) {
  SamplingReader reader(is_old);
  for (const EffectState& state : states) {
    if (state.is_wrong) continue;
    if (NamesTexture(state)) {
      if (NameIn(state).empty()) report.NotConstant(state);
      continue;
    }
    const Answer answer = reader.Add(state);
    if (answer == Answer::kUnknownState) report.Unknown(state);
    if (answer == Answer::kNotConstant) report.NotConstant(state);
  }
  return std::move(reader).Finish();
}

std::string NameIn(const EffectState& state) {
  std::string name = state.text;
  std::erase_if(
      name, [](char c) { return std::string_view("<>() \t").find(c) != std::string_view::npos; });
  const bool is_name = std::ranges::all_of(name, [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '[' || c == ']';
  });
  return is_name ? name : "";
}

std::string TextureOf(const std::vector<EffectState>& states) {
  std::string name;
  for (const EffectState& state : states) {
    if (NamesTexture(state)) name = NameIn(state);
  }
  return name;
}

}  // namespace clipc
