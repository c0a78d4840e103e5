// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "link/spirv_module.h"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

namespace clipc::link {
namespace {

constexpr std::size_t kHeaderWords = 5;
constexpr std::uint32_t kSwappedMagic = 0x03022307;

std::uint32_t Swapped(std::uint32_t word) {
  return word << 24 | (word & 0xFF00) << 8 | (word >> 8 & 0xFF00) | word >> 24;
}

// Returns a string literal: UTF-8, four bytes a word from the lowest on, up to a zero. Sets `used`
// to the number of its words.
std::string StringAt(std::span<const std::uint32_t> words, std::size_t* used = nullptr) {
  std::string text;
  for (std::size_t i = 0; i < words.size() * 4; ++i) {
    const char c = static_cast<char>(words[i / 4] >> (i % 4 * 8) & 0xFF);
    if (used) *used = i / 4 + 1;
    if (c == 0) break;
    text += c;
  }
  return text;
}

class Reader {
 public:
  explicit Reader(SpirvModule& module) : module_(module) {}

  // Reads one instruction, `words` being those after the first. Words that it lacks are taken for
  // 0, or the instruction is ignored.
  void Read(std::uint32_t opcode, std::span<const std::uint32_t> words) {
    if (opcode == 54 && words.size() >= 2) function_ = words[1];  // OpFunction
    if (function_ != 0) module_.functions[function_].push_back({opcode, words});
    if (opcode == 56) function_ = 0;  // OpFunctionEnd
    if (words.empty()) return;
    if (opcode >= 19 && opcode <= 32) return Type(opcode, words);
    switch (opcode) {
      case 15: return EntryPointAt(words);
      case 5: module_.names[{words[0]}] = StringAt(words.subspan(1)); return;
      case 6:  // OpMemberName
        if (words.size() > 1) module_.names[{words[0], words[1]}] = StringAt(words.subspan(2));
        return;
      case 43:  // OpConstant, OpSpecConstant
      case 50:
        if (words.size() >= 3) module_.constants[words[1]] = words[2];
        return;
      case 59:  // OpVariable
        if (words.size() >= 3 && function_ == 0)
          module_.variables.push_back({words[1], words[0], words[2]});
        return;
      case 71: return Decorate({words[0]}, words.subspan(1));
      case 72:  // OpMemberDecorate
        if (words.size() > 1) Decorate({words[0], words[1]}, words.subspan(2));
        return;
      case 5632:  // OpDecorateString
        if (words.size() > 1 && words[1] == spv::kUserSemantic)
          module_.semantics[{words[0]}] = StringAt(words.subspan(2));
        return;
      default: return;
    }
  }

 private:
  void EntryPointAt(std::span<const std::uint32_t> words) {
    if (words.size() < 3) return;
    std::size_t used = 0;
    EntryPoint entry{words[0], words[1], StringAt(words.subspan(2), &used), {}};
    const auto interface = words.subspan(2 + used);
    entry.interface.assign(interface.begin(), interface.end());
    module_.entry_points.push_back(std::move(entry));
  }

  void Decorate(SpirvPlace place, std::span<const std::uint32_t> words) {
    if (!words.empty()) module_.decorations[place][words[0]] = words.size() > 1 ? words[1] : 0;
  }

  void Type(std::uint32_t opcode, std::span<const std::uint32_t> words) {
    SpirvType type;
    const auto word = [&](std::size_t i) { return i < words.size() ? words[i] : 0; };
    switch (opcode) {
      case 20: type.kind = SpirvKind::kBool; break;
      case 21:
        type.kind = word(2) != 0 ? SpirvKind::kInt : SpirvKind::kUint;
        type.count = word(1);
        break;
      case 22: type = {SpirvKind::kFloat, word(1), 0, 0, {}}; break;
      case 23: type = {SpirvKind::kVector, word(2), word(1), 0, {}}; break;
      case 24: type = {SpirvKind::kMatrix, word(2), word(1), 0, {}}; break;
      case 28: {
        const std::uint32_t* length = FindIn(module_.constants, word(2));
        type = {SpirvKind::kArray, length ? *length : 0, word(1), 0, {}};
        break;
      }
      case 30:
        type.kind = SpirvKind::kStruct;
        type.members.assign(words.begin() + 1, words.end());
        break;
      case 32: type = {SpirvKind::kPointer, 0, word(2), word(1), {}}; break;
      default: break;
    }
    module_.types[words[0]] = std::move(type);
  }

  SpirvModule& module_;
  SpirvId function_ = 0;
};

}  // namespace

SpirvModule ReadModule(std::string_view bytes, std::string& problem) {
  SpirvModule module;
  if (bytes.size() / 4 < kHeaderWords) {
    problem = "the SPIR-V ends within its header";
    return module;
  }
  module.words.resize(bytes.size() / 4);
  std::memcpy(module.words.data(), bytes.data(), module.words.size() * 4);
  if (module.words[0] == kSwappedMagic)
    std::ranges::transform(module.words, module.words.begin(), Swapped);
  Reader reader(module);
  const std::span<const std::uint32_t> words(module.words);
  for (std::size_t at = kHeaderWords; at < words.size();) {
    const std::size_t length = words[at] >> 16;
    if (length == 0 || length > words.size() - at) {
      problem = fmt::format("the SPIR-V ends within the instruction at word {}", at);
      return module;
    }
    reader.Read(words[at] & 0xFFFF, words.subspan(at + 1, length - 1));
    at += length;
  }
  if (bytes.size() % 4 != 0) problem = "the SPIR-V ends within a word";
  return module;
}

}  // namespace clipc::link
