// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The text of vkd3d's shader_test files: sections with a header in brackets, and the words in them.
namespace clipc::values {

// The shader models that a file may name, by number.
using Model = std::uint32_t;
inline constexpr std::array<std::string_view, 8> kModels = {"2.0", "3.0", "4.0", "4.1",
                                                            "5.0", "5.1", "6.0", "6.2"};
inline constexpr Model kModel4 = 2, kModel6 = 6;
using ModelMask = std::uint32_t;  // bit i: kModels[i]

// The models whose byte code is one format. A file is run once for each family, at the least model
// that its [require] allows, as vkd3d's own runner does.
struct Family {
  std::string_view name;
  Model least, greatest;
};
inline constexpr std::array<Family, 3> kFamilies = {
    {{"2.0", 0, 1}, {"4.0", kModel4, 5}, {"6.0", kModel6, 7}}};

struct Line {
  int number = 0;  // from 1 on
  std::string text;
};
struct Section {
  Line header;  // "pixel shader fail(sm<4)", without its brackets
  std::vector<Line> lines;

  std::string Text() const;  // all lines, each with a newline
};
// The sections of a file, without the lines that begin with `%`, which are comments.
std::vector<Section> ReadSections(const std::string& text);

// "(sm>=4 & sm<6 | !llvmpipe)" after a word such as `if`, `fail` or `todo`.
struct Qualifier {
  ModelMask models = ~ModelMask{0};  // where it may hold
  bool holds = true;                 // for the model that runs
};

// What is left of a line. Throws std::runtime_error at what the format does not have.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : rest_(text) { SkipSpaces(); }

  bool at_end() const { return rest_.empty(); }
  std::string_view rest() const { return rest_; }
  // Reads a word that a space, a parenthesis or the end follows, and the spaces after it.
  bool Take(std::string_view word);
  // Reads one character, and the spaces after it.
  bool TakeMark(char mark);
  void ExpectMark(char mark);
  // Reads the characters up to the next space.
  std::string TakeName();
  double TakeNumber();
  std::uint32_t TakeCount();
  // Reads an integer in any base that C has, negative ones as two's complement.
  std::uint64_t TakeInteger();
  // Reads a word of a resource: the bits of a float where there is a point, else an integer.
  std::optional<std::uint32_t> TakeWord();
  // Reads the numbers in parentheses, if the next character opens some.
  std::vector<double> TakeList();
  // Reads a qualifier, or nothing, which holds everywhere.
  Qualifier TakeQualifier(Model model);

 private:
  void SkipSpaces();
  Qualifier TakeConjunction(Model model);

  std::string_view rest_;
};

}  // namespace clipc::values
