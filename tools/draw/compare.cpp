// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/compare.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>

#include "ir/scalar.h"
#include "tools/draw/feed.h"

namespace clipc::draw {
namespace {

using namespace ir;

constexpr std::size_t kMistakesKept = 4;

double LargestOf(const Expected& expected) {
  double largest = 0;
  for (const double number : expected.numbers) {
    if (std::isfinite(number)) largest = std::max(largest, std::abs(number));
  }
  return largest;
}

std::string Describe(const Expected& expected, std::size_t index, std::uint32_t got,
                     const char* why) {
  const std::size_t components = expected.components;
  const bool is_float = expected.kind == Scalar::kFloat;
  const auto number = [&](std::uint32_t word) {
    return NumberOf(word, is_float ? Scalar::kFloat : expected.kind);
  };
  char text[256];
  std::snprintf(text, sizeof text, "vertex %zu, %s[%zu]: %.9g, expected %.9g (%.17g in double)%s",
                index / components, expected.name.c_str(), index % components, number(got),
                number(expected.words[index]), expected.numbers[index], why);
  return text;
}

class Comparer {
 public:
  explicit Comparer(const Tolerance& tolerance) : tolerance_(tolerance) {}

  void Compare(const Expected& expected, const Captured& captured) {
    if (captured.words.empty()) {
      ++result_.missing;
      return Fail(expected.name + " is not written");
    }
    const WordLayout& layout = captured.layout;
    if (layout.Words() * captured.count != expected.components ||
        captured.words.size() != expected.words.size()) {
      return Fail(expected.name + " has another number of components");
    }
    const double largest = LargestOf(expected);
    for (std::size_t i = 0; i < expected.words.size(); ++i) {
      ++result_.values;
      if (expected.open[i]) {
        ++result_.undefined;
      } else if (expected.kind == Scalar::kFloat) {
        CompareFloat(expected, i, captured.words[i], largest);
      } else if (captured.words[i] == (layout.kind == WordKind::kFloat
                                           ? AsFloat(expected.words[i], expected.kind)
                                           : expected.words[i])) {
        ++result_.equal;
      } else {
        Fail(Describe(expected, i, captured.words[i], ""));
      }
    }
  }

  Comparison& result() { return result_; }

 private:
  void CompareFloat(const Expected& expected, std::size_t index, std::uint32_t word,
                    double largest) {
    const float got = std::bit_cast<float>(word),
                want = std::bit_cast<float>(expected.words[index]);
    if (std::isnan(want)) {
      ++result_.undefined;
      return;
    }
    if (got == want) {
      ++result_.equal;
      return;
    }
    const double number = expected.numbers[index];
    const double unit = 0x1p-24 * std::max(std::abs(number), largest);
    const double error = std::abs(got - number) / unit;
    const double allowed =
        std::max(tolerance_.ulps * unit, tolerance_.roundings * RoundingOf(expected, index));
    if (!(std::abs(got - number) <= allowed)) return Fail(Describe(expected, index, word, ""));
    result_.worst = std::max(result_.worst, error);
  }

  // The largest difference between the evaluator's own float32 and double results in the vector
  // that `index` belongs to.
  static double RoundingOf(const Expected& expected, std::size_t index) {
    const std::size_t size = expected.components;
    const std::size_t first = index / size * size;
    double worst = 0;
    for (std::size_t i = first; i < first + size; ++i) {
      const double rounding =
          std::abs(std::bit_cast<float>(expected.words[i]) - expected.numbers[i]);
      if (std::isfinite(rounding)) worst = std::max(worst, rounding);
    }
    return worst;
  }

  void Fail(std::string what) {
    ++result_.wrong;
    if (result_.mistakes.size() < kMistakesKept) result_.mistakes.push_back(std::move(what));
  }

  Tolerance tolerance_;
  Comparison result_;
};

}  // namespace

std::vector<const Expected*> Defined(const std::vector<Expected>& expected) {
  std::vector<const Expected*> outputs;
  for (const Expected& output : expected) {
    if (std::ranges::find(output.open, false) != output.open.end()) outputs.push_back(&output);
  }
  return outputs;
}

std::vector<std::string> NamesOf(const std::vector<const Expected*>& outputs) {
  std::vector<std::string> names;
  for (const Expected* output : outputs) names.push_back(output->name);
  return names;
}

std::vector<Captured> Chosen(const std::vector<Captured>& captured,
                             const std::vector<const Expected*>& expected) {
  std::vector<Captured> chosen;
  for (const Expected* output : expected)
    chosen.push_back(*std::ranges::find(captured, output->name, &Captured::name));
  return chosen;
}

Comparison CompareOutputs(const std::vector<const Expected*>& expected,
                          const std::vector<Captured>& captured, const Tolerance& tolerance) {
  Comparer comparer(tolerance);
  for (std::size_t i = 0; i < expected.size(); ++i) comparer.Compare(*expected[i], captured[i]);
  return comparer.result();
}

}  // namespace clipc::draw
