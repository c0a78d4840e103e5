// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/arguments.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "tools/harness/options.h"

namespace clipc::draw {
namespace {

// "a=b" => {"a", "b"}
std::pair<std::string, std::string> Halves(const std::string& text, char separator) {
  const std::size_t at = text.find(separator);
  if (at == text.npos) throw DrawError("`" + text + "` has no `" + separator + "`");
  return {text.substr(0, at), text.substr(at + 1)};
}

std::uint32_t ParseWord(const std::string& text) {
  char* end = nullptr;
  std::uint32_t word = 0;
  if (text.starts_with("0x")) {
    word = std::strtoul(text.c_str(), &end, 16);
  } else if (text.ends_with('i') || text.ends_with('u')) {
    word = std::strtoll(text.c_str(), &end, 10);
    ++end;
  } else {
    word = std::bit_cast<std::uint32_t>(std::strtof(text.c_str(), &end));
  }
  if (text.empty() || end != text.c_str() + text.size())
    throw DrawError("`" + text + "` is not a number");
  return word;
}

}  // namespace

std::vector<std::string> Split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end; (end = text.find(separator, begin)) != text.npos; begin = end + 1) {
    parts.push_back(text.substr(begin, end - begin));
  }
  parts.push_back(text.substr(begin));
  return parts;
}

Words ParseWords(const std::string& text) {
  if (text == "identity") return ParseWords("1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1");
  Words words;
  for (const std::string& part : Split(text, ',')) words.push_back(ParseWord(part));
  return words;
}

std::array<double, 4> ParsePlane(const std::string& text) {
  const Words words = ParseWords(text);
  if (words.size() != 4) throw DrawError("a plane is four numbers, not `" + text + "`");
  std::array<double, 4> plane{};
  std::ranges::transform(words, plane.begin(),
                         [](std::uint32_t word) { return std::bit_cast<float>(word); });
  return plane;
}

void AddAttribute(const std::string& text, Inputs& inputs) {
  const auto [name, values] = Halves(text, '=');
  const std::vector<std::string> vertices = Split(values, '/');
  if (!inputs.attributes.empty() && vertices.size() != static_cast<std::size_t>(inputs.vertices)) {
    throw DrawError("attribute `" + name + "` has another number of vertices than the first");
  }
  inputs.vertices = static_cast<int>(vertices.size());
  Inputs::Attribute& attribute = inputs.attributes.emplace_back(Inputs::Attribute{name, {}});
  for (const std::string& vertex : vertices) {
    const Words words = ParseWords(vertex);
    attribute.words.insert(attribute.words.end(), words.begin(), words.end());
  }
}

void AddBlock(const std::string& text, Inputs& inputs) {
  const auto [place, values] = Halves(text, '=');
  const auto [name, offset_text] = Halves(place, '@');
  const std::uint32_t offset = harness::options::ParseNumber(offset_text);
  auto block = std::ranges::find_if(
      inputs.blocks,
      [&, name = name](const Inputs::UniformBlock& known) { return known.name == name; });
  if (block == inputs.blocks.end()) block = inputs.blocks.insert(block, {name, {}});
  const Words words = ParseWords(values);
  block->bytes.resize(std::max<std::size_t>(block->bytes.size(), offset + 4 * words.size()));
  std::memcpy(block->bytes.data() + offset, words.data(), 4 * words.size());
}

void AddUniform(const std::string& text, Inputs& inputs) {
  const auto [name, values] = Halves(text, '=');
  inputs.uniforms.push_back({name, ParseWords(values)});
}

}  // namespace clipc::draw
