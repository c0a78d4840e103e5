// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <initializer_list>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <spirv/unified1/spirv.hpp11>

namespace clipc::spirv {

// The number by which a module names a result, SPIR-V's <id>. 0 names nothing.
using Ref = std::uint32_t;
using Words = std::vector<std::uint32_t>;

// The number of an enumerator of SPIR-V's.
constexpr std::uint32_t NumberOf(auto enumerator) { return static_cast<std::uint32_t>(enumerator); }

// Appends an instruction.
void Put(Words& to, spv::Op op, std::span<const std::uint32_t> operands);
void Put(Words& to, spv::Op op, std::initializer_list<std::uint32_t> operands);
// Appends a literal string: four letters a word, with a zero at the end.
void PutText(Words& to, std::string_view text);

// The parts of a module, in the order of section 2.4 of the SPIR-V specification. Types and
// constants are declared once, and capabilities and extensions only if something asks for them.
class Module {
 public:
  explicit Module(std::uint32_t minor_version) : minor_version_(minor_version) {}

  Ref NewRef() { return next_++; }
  std::uint32_t minor_version() const { return minor_version_; }

  void Require(spv::Capability capability) { capabilities_.insert(capability); }
  void Require(std::string_view extension) { extensions_.emplace(extension); }
  // The set of functions "GLSL.std.450".
  Ref ExtendedSet();

  // The type or the constant of the instruction, which has its result first or after its type.
  Ref Type(spv::Op op, std::initializer_list<std::uint32_t> operands);
  Ref Type(spv::Op op, std::span<const std::uint32_t> operands);
  Ref Constant(spv::Op op, Ref type, std::span<const std::uint32_t> operands = {});
  Ref Constant(spv::Op op, Ref type, std::initializer_list<std::uint32_t> operands);
  // A type of its own, whatever other types are alike: decorations may differ.
  Ref OwnType(spv::Op op, std::span<const std::uint32_t> operands);
  // A constant of its own, which a decoration specialises.
  Ref OwnConstant(spv::Op op, Ref type, std::initializer_list<std::uint32_t> operands);
  // A variable at global scope. `initial` is a constant, or 0.
  Ref Variable(Ref pointer_type, spv::StorageClass storage, Ref initial = 0);

  // ---- debug information
  // The string of a text, of which there is one.
  Ref String(std::string_view text);
  // The file and, if it is not empty, the text of OpSource.
  void Source(Ref file, std::string_view text);
  void Processed(std::string_view by);
  // The set "NonSemantic.Shader.DebugInfo.100", and an instruction of it before the functions.
  Ref DebugSet();
  Ref DebugGlobal(std::uint32_t instruction, Ref void_type,
                  std::span<const std::uint32_t> operands);

  void Name(Ref of, std::string_view name);
  void NameMember(Ref structure, std::uint32_t member, std::string_view name);
  void Decorate(Ref of, spv::Decoration decoration,
                std::initializer_list<std::uint32_t> operands = {});
  void DecorateText(Ref of, spv::Decoration decoration, std::string_view text);
  void DecorateMember(Ref structure, std::uint32_t member, spv::Decoration decoration,
                      std::initializer_list<std::uint32_t> operands = {});
  void Execution(spv::ExecutionMode mode, std::initializer_list<std::uint32_t> operands = {}) {
    modes_.emplace_back(mode, operands);
  }

  Words functions;  // the definitions, complete

  // The whole module, with one entry point. `hlsl_version` is that of the language's profile, 510.
  Words Finish(spv::ExecutionModel model, Ref entry, std::string_view name,
               std::span<const Ref> interface, std::uint32_t hlsl_version) const;

 private:
  void PutSource(Words& to, std::uint32_t hlsl_version) const;
  // An instruction of which there is one with the same words.
  struct Interning {
    std::uint32_t hash = 0, place = 0;  // in `globals_`, from 1 on; 0: none
  };
  Ref Interned(spv::Op op, Ref type, std::span<const std::uint32_t> operands);
  void GrowTable();

  std::uint32_t minor_version_;
  Ref next_ = 1;
  Ref extended_ = 0, debug_set_ = 0, source_file_ = 0;
  std::string source_text_, processed_;
  std::map<std::string, Ref, std::less<>> strings_;
  std::set<spv::Capability> capabilities_ = {spv::Capability::Shader};
  std::set<std::string> extensions_;
  std::vector<std::pair<spv::ExecutionMode, Words>> modes_;
  Words names_, decorations_, globals_, debug_globals_, strings_words_;
  std::vector<Interning> interned_;  // a table of hashes
  std::size_t interned_count_ = 0;
};

}  // namespace clipc::spirv
