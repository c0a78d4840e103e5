// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// The declarations of a SPIR-V module, by id. Source: the SPIR-V specification 1.6, sections 2.3
// (the words of a module) and 3.52 (the instructions).
namespace clipc::link {

// The value that a map has for a key; null if it has none.
template <typename Map>
const typename Map::mapped_type* FindIn(const Map& map, const typename Map::key_type& key) {
  const auto found = map.find(key);
  return found == map.end() ? nullptr : &found->second;
}

using SpirvId = std::uint32_t;
// The member of a SpirvPlace that is an id as a whole.
inline constexpr std::uint32_t kWhole = ~0u;
// An owner of a name and decorations: an id, or a member of the struct type of that id.
struct SpirvPlace {
  SpirvId id = 0;
  std::uint32_t member = kWhole;
  auto operator<=>(const SpirvPlace&) const = default;
};

enum class SpirvKind : std::uint8_t {
  kOther,
  kBool,
  kInt,
  kUint,
  kFloat,
  kVector,
  kMatrix,
  kArray,
  kStruct,
  kPointer
};
struct SpirvType {
  SpirvKind kind = SpirvKind::kOther;
  std::uint32_t count = 0;       // bits of a number; components, columns or elements
  SpirvId element = 0;           // also the type that a pointer points to
  std::uint32_t storage = 0;     // of a pointer
  std::vector<SpirvId> members;  // of a struct
};
// The first operands, or 0, of the decorations of one place, by the decorations' numbers.
using Decorations = std::map<std::uint32_t, std::uint32_t>;
struct SpirvVariable {
  SpirvId id = 0, type = 0;  // the type is a pointer
  std::uint32_t storage = 0;
};
struct EntryPoint {
  std::uint32_t model = 0;
  SpirvId function = 0;
  std::string name;
  std::vector<SpirvId> interface;
};
// One instruction of a function: its opcode, and its words after the first.
struct Instruction {
  std::uint32_t opcode = 0;
  std::span<const std::uint32_t> words;
};

struct SpirvModule {
  std::vector<std::uint32_t> words;  // in this machine's order
  std::map<SpirvId, SpirvType> types;
  std::map<SpirvId, std::uint32_t> constants;  // of 32 bits
  std::map<SpirvPlace, std::string> names;
  std::map<SpirvPlace, std::string> semantics;  // UserSemantic
  std::map<SpirvPlace, Decorations> decorations;
  std::vector<SpirvVariable> variables;  // outside functions, in the order of the module
  std::vector<EntryPoint> entry_points;
  std::map<SpirvId, std::vector<Instruction>> functions;

  const SpirvType* TypeOf(SpirvId id) const { return FindIn(types, id); }
  // The name of the place; empty if it has none.
  std::string_view NameOf(SpirvPlace place) const {
    const std::string* name = FindIn(names, place);
    return name ? *name : std::string_view();
  }
  std::optional<std::uint32_t> Decoration(SpirvPlace place, std::uint32_t which) const {
    const Decorations* all = FindIn(decorations, place);
    const std::uint32_t* operand = all ? FindIn(*all, which) : nullptr;
    return operand ? std::optional(*operand) : std::nullopt;
  }
};

// The decorations, opcodes and storage classes that the reader looks for, by the names of section
// 3.
namespace spv {
enum Decoration : std::uint32_t {
  kRelaxedPrecision = 0,
  kBlock = 2,
  kRowMajor = 4,
  kColMajor = 5,
  kBuiltIn = 11,
  kNoPerspective = 13,
  kFlat = 14,
  kCentroid = 16,
  kSample = 17,
  kLocation = 30,
  kBinding = 33,
  kDescriptorSet = 34,
  kOffset = 35,
  kUserSemantic = 5635,
};
enum Storage : std::uint32_t { kInput = 1, kUniform = 2 };
enum Opcode : std::uint32_t {
  kExtInst = 12,
  kFunctionCall = 57,
  kLoad = 61,
  kCopyMemory = 63,
  kAccessChain = 65,
  kInBoundsAccessChain = 66,
  kVectorShuffle = 79,
  kCompositeExtract = 81,
};
inline constexpr std::uint32_t kFragment = 4;  // the execution model
}  // namespace spv

// Reads a module. If the words are not one, sets `problem` and returns the part read so far.
SpirvModule ReadModule(std::string_view bytes, std::string& problem);

}  // namespace clipc::link
