// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/values/script.h"

#include <bit>
#include <cctype>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace clipc::values {
namespace {

bool IsSpace(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

// A function of <cstdlib> on the text, whose result is the end of what it has read.
template <typename Read>
auto ReadWith(std::string_view& rest, Read&& read) {
  const std::string text(rest);
  char* end = nullptr;
  const auto value = read(text.c_str(), &end);
  const auto length = static_cast<std::size_t>(end - text.c_str());
  if (length == 0) throw std::runtime_error("no number: `" + text + "`");
  rest.remove_prefix(length);
  return value;
}

}  // namespace

std::string Section::Text() const {
  std::string text;
  for (const Line& line : lines) text += line.text + "\n";
  return text;
}

std::vector<Section> ReadSections(const std::string& text) {
  std::vector<Section> sections;
  std::istringstream stream(text);
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (line.ends_with('\r')) line.pop_back();
    if (line.starts_with('%')) continue;
    if (line.starts_with('[') && line.ends_with(']')) {
      sections.push_back({{number, line.substr(1, line.size() - 2)}, {}});
    } else if (!sections.empty()) {
      sections.back().lines.push_back({number, line});
    }
  }
  return sections;
}

void Scanner::SkipSpaces() {
  while (!rest_.empty() && IsSpace(rest_.front())) rest_.remove_prefix(1);
}

bool Scanner::Take(std::string_view word) {
  if (!rest_.starts_with(word)) return false;
  if (rest_.size() > word.size()) {
    const char next = rest_[word.size()];
    if (!IsSpace(next) && next != '(') return false;
  }
  rest_.remove_prefix(word.size());
  SkipSpaces();
  return true;
}

bool Scanner::TakeMark(char mark) {
  if (!rest_.starts_with(mark)) return false;
  rest_.remove_prefix(1);
  SkipSpaces();
  return true;
}

void Scanner::ExpectMark(char mark) {
  if (!TakeMark(mark))
    throw std::runtime_error(std::string("no `") + mark + "` at `" + std::string(rest_) + "`");
}

std::string Scanner::TakeName() {
  std::size_t length = 0;
  while (length < rest_.size() && !IsSpace(rest_[length])) ++length;
  std::string name(rest_.substr(0, length));
  rest_.remove_prefix(length);
  SkipSpaces();
  return name;
}

double Scanner::TakeNumber() {
  const double number =
      ReadWith(rest_, [](const char* text, char** end) { return std::strtod(text, end); });
  SkipSpaces();
  return number;
}

std::uint64_t Scanner::TakeInteger() {
  const bool is_negative = rest_.starts_with('-');
  const std::uint64_t value = ReadWith(rest_, [&](const char* text, char** end) {
    return is_negative ? static_cast<std::uint64_t>(std::strtoll(text, end, 0))
                       : std::uint64_t{std::strtoull(text, end, 0)};
  });
  SkipSpaces();
  return value;
}

std::uint32_t Scanner::TakeCount() { return static_cast<std::uint32_t>(TakeInteger()); }

std::optional<std::uint32_t> Scanner::TakeWord() {
  // The words of a line end at what is not a number, such as a comment.
  if (at_end() || (std::isdigit(static_cast<unsigned char>(rest_.front())) == 0 &&
                   rest_.front() != '-' && rest_.front() != '.'))
    return std::nullopt;
  std::string_view after = rest_;
  const auto integer =
      ReadWith(after, [](const char* text, char** end) { return std::strtoll(text, end, 0); });
  if (after.starts_with('.')) return std::bit_cast<std::uint32_t>(static_cast<float>(TakeNumber()));
  rest_ = after;
  SkipSpaces();
  return static_cast<std::uint32_t>(integer);
}

std::vector<double> Scanner::TakeList() {
  std::vector<double> numbers;
  if (!TakeMark('(')) return numbers;
  do numbers.push_back(TakeNumber());
  while (TakeMark(','));
  ExpectMark(')');
  return numbers;
}

Qualifier Scanner::TakeConjunction(Model model) {
  Qualifier all;
  do {
    const bool is_negated = TakeMark('!');
    const bool is_least = rest_.starts_with("sm>=");
    if (is_least || rest_.starts_with("sm<")) {
      rest_.remove_prefix(is_least ? 4 : 3);
      std::size_t length = 0;
      while (length < rest_.size() && (std::isdigit(rest_[length]) != 0 || rest_[length] == '.'))
        ++length;
      std::string name(rest_.substr(0, length));
      if (name.find('.') == name.npos) name += ".0";
      Model bound = 0;
      while (bound < kModels.size() && kModels[bound] != name) ++bound;
      rest_.remove_prefix(length);
      SkipSpaces();
      const ModelMask below = (ModelMask{1} << bound) - 1;
      all.models &= is_least ? ~below : below;
      all.holds = all.holds && (is_least ? model >= bound : model < bound);
      continue;
    }
    // A driver or a host of vkd3d's own. Microsoft's runtime is Direct3D 12 from model 4 on.
    std::size_t length = 0;
    while (length < rest_.size() && rest_[length] != ')' && rest_[length] != '&' &&
           rest_[length] != '|')
      ++length;
    const bool is_microsoft = rest_.substr(0, length).starts_with("d3d12") && model >= kModel4;
    rest_.remove_prefix(length);
    all.holds = all.holds && is_microsoft != is_negated;
  } while (TakeMark('&'));
  return all;
}

Qualifier Scanner::TakeQualifier(Model model) {
  if (!TakeMark('(')) return {};
  Qualifier any{0, false};
  do {
    const Qualifier part = TakeConjunction(model);
    any.models |= part.models;
    any.holds = any.holds || part.holds;
  } while (TakeMark('|'));
  ExpectMark(')');
  return any;
}

}  // namespace clipc::values
