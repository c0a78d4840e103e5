// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-spirv/module.h"

#include <algorithm>

namespace clipc::spirv {
namespace {

void PutNamed(Words& to, spv::Op op, std::initializer_list<std::uint32_t> operands,
              std::string_view text) {
  Words all(operands);
  PutText(all, text);
  Put(to, op, all);
}

}  // namespace

void Put(Words& to, spv::Op op, std::span<const std::uint32_t> operands) {
  to.push_back(static_cast<std::uint32_t>(operands.size() + 1) << 16 | NumberOf(op));
  to.insert(to.end(), operands.begin(), operands.end());
}

void Put(Words& to, spv::Op op, std::initializer_list<std::uint32_t> operands) {
  Put(to, op, std::span(operands.begin(), operands.size()));
}

void PutText(Words& to, std::string_view text) {
  const std::size_t begin = to.size();
  to.resize(begin + text.size() / 4 + 1, 0);
  for (std::size_t i = 0; i < text.size(); ++i) {
    to[begin + i / 4] |= std::uint32_t{static_cast<unsigned char>(text[i])} << (i % 4 * 8);
  }
}

Ref Module::String(std::string_view text) {
  const auto found = strings_.find(text);
  if (found != strings_.end()) return found->second;
  const Ref made = NewRef();
  strings_.emplace(text, made);
  // The longest instruction has 65535 words.
  constexpr std::size_t kLongest = 4 * (0xFFFF - 3);
  PutNamed(strings_words_, spv::Op::OpString, {made}, text.substr(0, kLongest));
  return made;
}

void Module::Source(Ref file, std::string_view text) {
  source_file_ = file;
  source_text_ = text;
}

void Module::Processed(std::string_view by) { processed_ = by; }

Ref Module::DebugSet() {
  if (debug_set_ == 0) debug_set_ = NewRef();
  return debug_set_;
}

Ref Module::DebugGlobal(std::uint32_t instruction, Ref void_type,
                        std::span<const std::uint32_t> operands) {
  const Ref made = NewRef();
  Words all{void_type, made, DebugSet(), instruction};
  all.insert(all.end(), operands.begin(), operands.end());
  Put(debug_globals_, spv::Op::OpExtInst, all);
  return made;
}

Ref Module::ExtendedSet() {
  if (extended_ == 0) extended_ = NewRef();
  return extended_;
}

// The table has the places in `globals_` of the instructions, by the hashes of all their words but
// the result: FNV-1a, section 2 of draft-eastlake-fnv.
Ref Module::Interned(spv::Op op, Ref type, std::span<const std::uint32_t> operands) {
  const std::uint32_t first =
      static_cast<std::uint32_t>(operands.size() + (type != 0 ? 3 : 2)) << 16 | NumberOf(op);
  std::uint32_t hash = 0x811C9DC5;
  const auto add = [&](std::uint32_t word) { hash = (hash ^ word) * 0x01000193; };
  add(first);
  add(type);
  for (const std::uint32_t word : operands) add(word);
  if (2 * interned_count_ >= interned_.size()) GrowTable();
  std::size_t slot = hash % interned_.size();
  for (; interned_[slot].place != 0; slot = (slot + 1) % interned_.size()) {
    const std::uint32_t* words = globals_.data() + interned_[slot].place - 1;
    const bool has_type = type != 0;
    if (interned_[slot].hash == hash && words[0] == first && (!has_type || words[1] == type) &&
        std::ranges::equal(operands, std::span(words + 2 + has_type, operands.size())))
      return words[1 + has_type];
  }
  interned_[slot] = {hash, static_cast<std::uint32_t>(globals_.size() + 1)};
  ++interned_count_;
  globals_.push_back(first);
  if (type != 0) globals_.push_back(type);
  globals_.push_back(NewRef());
  globals_.insert(globals_.end(), operands.begin(), operands.end());
  return next_ - 1;
}

void Module::GrowTable() {
  constexpr std::size_t kFirst = 256;
  std::vector<Interning> old(std::max(kFirst, 2 * interned_.size()));
  old.swap(interned_);
  for (const Interning& each : old) {
    if (each.place == 0) continue;
    std::size_t slot = each.hash % interned_.size();
    while (interned_[slot].place != 0) slot = (slot + 1) % interned_.size();
    interned_[slot] = each;
  }
}

Ref Module::Type(spv::Op op, std::span<const std::uint32_t> operands) {
  return Interned(op, 0, operands);
}
Ref Module::Type(spv::Op op, std::initializer_list<std::uint32_t> operands) {
  return Interned(op, 0, std::span(operands.begin(), operands.size()));
}
Ref Module::Constant(spv::Op op, Ref type, std::span<const std::uint32_t> operands) {
  return Interned(op, type, operands);
}
Ref Module::Constant(spv::Op op, Ref type, std::initializer_list<std::uint32_t> operands) {
  return Interned(op, type, std::span(operands.begin(), operands.size()));
}

Ref Module::OwnType(spv::Op op, std::span<const std::uint32_t> operands) {
  const Ref made = NewRef();
  Words all{made};
  all.insert(all.end(), operands.begin(), operands.end());
  Put(globals_, op, all);
  return made;
}

Ref Module::OwnConstant(spv::Op op, Ref type, std::initializer_list<std::uint32_t> operands) {
  const Ref made = NewRef();
  Words all{type, made};
  all.insert(all.end(), operands);
  Put(globals_, op, all);
  return made;
}

Ref Module::Variable(Ref pointer_type, spv::StorageClass storage, Ref initial) {
  const Ref made = NewRef();
  if (initial != 0)
    Put(globals_, spv::Op::OpVariable, {pointer_type, made, NumberOf(storage), initial});
  else
    Put(globals_, spv::Op::OpVariable, {pointer_type, made, NumberOf(storage)});
  return made;
}

void Module::Name(Ref of, std::string_view name) {
  if (!name.empty()) PutNamed(names_, spv::Op::OpName, {of}, name);
}

void Module::NameMember(Ref structure, std::uint32_t member, std::string_view name) {
  PutNamed(names_, spv::Op::OpMemberName, {structure, member}, name);
}

void Module::Decorate(Ref of, spv::Decoration decoration,
                      std::initializer_list<std::uint32_t> operands) {
  Words all{of, NumberOf(decoration)};
  all.insert(all.end(), operands);
  Put(decorations_, spv::Op::OpDecorate, all);
}

void Module::DecorateText(Ref of, spv::Decoration decoration, std::string_view text) {
  PutNamed(decorations_, spv::Op::OpDecorateString, {of, NumberOf(decoration)}, text);
}

void Module::DecorateMember(Ref structure, std::uint32_t member, spv::Decoration decoration,
                            std::initializer_list<std::uint32_t> operands) {
  Words all{structure, member, NumberOf(decoration)};
  all.insert(all.end(), operands);
  Put(decorations_, spv::Op::OpMemberDecorate, all);
}

void Module::PutSource(Words& to, std::uint32_t hlsl_version) const {
  constexpr std::uint32_t kHlsl = NumberOf(spv::SourceLanguage::HLSL);
  if (source_file_ == 0) return Put(to, spv::Op::OpSource, {kHlsl, hlsl_version});
  if (source_text_.empty()) return Put(to, spv::Op::OpSource, {kHlsl, hlsl_version, source_file_});
  // The longest instruction has 65535 words.
  constexpr std::size_t kLongest = 4 * (0xFFFF - 5);
  std::string_view left = source_text_;
  PutNamed(to, spv::Op::OpSource, {kHlsl, hlsl_version, source_file_}, left.substr(0, kLongest));
  for (left.remove_prefix(std::min(kLongest, left.size())); !left.empty();
       left.remove_prefix(std::min(kLongest, left.size())))
    PutNamed(to, spv::Op::OpSourceContinued, {}, left.substr(0, kLongest));
}

Words Module::Finish(spv::ExecutionModel model, Ref entry, std::string_view name,
                     std::span<const Ref> interface, std::uint32_t hlsl_version) const {
  constexpr std::uint32_t kMagic = 0x07230203, kGenerator = 0, kSchema = 0;
  Words module{kMagic, 1u << 16 | minor_version_ << 8, kGenerator, next_, kSchema};
  for (const spv::Capability capability : capabilities_)
    Put(module, spv::Op::OpCapability, {NumberOf(capability)});
  for (const std::string& extension : extensions_)
    PutNamed(module, spv::Op::OpExtension, {}, extension);
  if (extended_ != 0) PutNamed(module, spv::Op::OpExtInstImport, {extended_}, "GLSL.std.450");
  if (debug_set_ != 0) {
    PutNamed(module, spv::Op::OpExtInstImport, {debug_set_}, "NonSemantic.Shader.DebugInfo.100");
  }
  Put(module, spv::Op::OpMemoryModel,
      {NumberOf(spv::AddressingModel::Logical), NumberOf(spv::MemoryModel::GLSL450)});
  Words point{NumberOf(model), entry};
  PutText(point, name);
  point.insert(point.end(), interface.begin(), interface.end());
  Put(module, spv::Op::OpEntryPoint, point);
  for (const auto& [mode, operands] : modes_) {
    Words words{entry, NumberOf(mode)};
    words.insert(words.end(), operands.begin(), operands.end());
    Put(module, spv::Op::OpExecutionMode, words);
  }
  module.insert(module.end(), strings_words_.begin(), strings_words_.end());
  PutSource(module, hlsl_version);
  module.insert(module.end(), names_.begin(), names_.end());
  if (!processed_.empty()) PutNamed(module, spv::Op::OpModuleProcessed, {}, processed_);
  for (const Words* part : {&decorations_, &globals_, &debug_globals_, &functions})
    module.insert(module.end(), part->begin(), part->end());
  return module;
}

}  // namespace clipc::spirv
