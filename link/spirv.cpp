// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The interface of a fragment shader in SPIR-V. The words are untrusted, so ids and nesting are
// checked here, which SPIRV-Cross leaves to its callers.
#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "frontend/signature/semantics.h"
#include "link/names.h"
#include "link/read.h"
#include "link/spirv_module.h"

namespace clipc::link {
namespace {

constexpr int kMaxDepth = 16;  // the most arrays, or structs, inside each other
// The most members of all blocks and inputs, those of a struct counted wherever it is used. A
// struct may name itself as often as it likes.
constexpr std::size_t kMaxMembers = 1u << 16;

// The reads of the module's variables in the functions that the entry point reaches.
class Reads {
 public:
  Reads(const SpirvModule& module, SpirvId entry) : module_(module) {
    for (const SpirvVariable& variable : module.variables) {
      const SpirvType* pointer = module.TypeOf(variable.type);
      const SpirvType* type = pointer ? module.TypeOf(pointer->element) : nullptr;
      if (type && type->kind == SpirvKind::kStruct) structs_.insert(variable.id);
    }
    std::vector<SpirvId> waiting{entry};
    std::set<SpirvId> seen;
    while (!waiting.empty()) {
      const SpirvId id = waiting.back();
      waiting.pop_back();
      const std::vector<Instruction>* function = FindIn(module.functions, id);
      if (!function || !seen.insert(id).second) continue;
      for (const Instruction& instruction : *function) {
        if (instruction.opcode == spv::kFunctionCall && instruction.words.size() > 2)
          waiting.push_back(instruction.words[2]);
        Visit(instruction);
      }
    }
  }

  // The components that are read of a variable, or of a member of one that is a struct; they have a
  // meaning for vectors only. None if the place is not read at all. A read of a whole struct reads
  // its members.
  std::optional<std::uint32_t> Of(SpirvPlace place) const {
    const std::uint32_t* whole = FindIn(masks_, {place.id});
    if (place.member != kWhole && whole && *whole != 0) return kAll;
    const std::uint32_t* found = FindIn(masks_, place);
    return found ? std::optional(*found) : std::nullopt;
  }

 private:
  static constexpr std::uint32_t kAll = 0xF;

  void Visit(const Instruction& instruction) {
    const auto words = instruction.words;
    switch (instruction.opcode) {
      case spv::kLoad:
        if (words.size() > 2) {
          const SpirvPlace place = PlaceOf(words[2]);
          loaded_[words[1]] = place;
          masks_.try_emplace(place, 0);
        }
        return;
      case spv::kAccessChain:
      case spv::kInBoundsAccessChain: return AccessChain(words);
      case spv::kCompositeExtract:
        if (words.size() >= 4) return Extract(words);
        break;
      case spv::kVectorShuffle:
        if (words.size() > 4) return Shuffle(words);
        break;
      default: break;
    }
    // Any word may be an operand; a literal that looks like one makes an input read at worst.
    const bool takes_pointers = instruction.opcode == spv::kFunctionCall ||
                                instruction.opcode == spv::kCopyMemory ||
                                instruction.opcode == spv::kExtInst;  // interpolateAt..
    for (const std::uint32_t word : words) {
      Read(word, kAll);
      if (takes_pointers) masks_[PlaceOf(word)] = kAll;
    }
  }

  void AccessChain(std::span<const std::uint32_t> words) {
    if (words.size() < 3) return;
    const SpirvPlace base = PlaceOf(words[2]);
    auto indices = words.subspan(3);
    const bool is_member = base.member == kWhole && structs_.contains(base.id) &&
                           !indices.empty() && module_.constants.contains(indices.front());
    const SpirvPlace place =
        is_member ? SpirvPlace{base.id, module_.constants.at(indices.front())} : base;
    if (is_member) {
      indices = indices.subspan(1);
      if (indices.empty()) {
        pointers_[words[1]] = place;
        masks_.try_emplace(place, 0);
        return;
      }
    }
    const std::uint32_t* index =
        indices.size() == 1 ? FindIn(module_.constants, indices.front()) : nullptr;
    masks_[place] |= index ? 1u << (*index & 31) : kAll;
  }

  void Extract(std::span<const std::uint32_t> words) {
    auto indices = words.subspan(3);
    const SpirvPlace* found = FindIn(loaded_, words[2]);
    if (found && found->member == kWhole && structs_.contains(found->id)) {
      const SpirvPlace member{found->id, indices.front()};
      masks_.try_emplace(member, 0);
      if (indices.size() == 1) {
        loaded_[words[1]] = member;
      } else {
        masks_[member] |= indices.size() == 2 ? 1u << (indices[1] & 31) : kAll;
      }
      return;
    }
    Read(words[2], indices.size() == 1 ? 1u << (indices.front() & 31) : kAll);
  }

  // The place of the variable, or of the member of one, that an id points to.
  SpirvPlace PlaceOf(SpirvId pointer) const {
    const SpirvPlace* found = FindIn(pointers_, pointer);
    return found ? *found : SpirvPlace{pointer};
  }

  void Shuffle(std::span<const std::uint32_t> words) {
    for (const std::uint32_t component : words.subspan(4)) {
      if (component < 4)
        Read(words[2], 1u << component);
      else
        Read(words[2], kAll), Read(words[3], kAll);
    }
  }

  void Read(SpirvId value, std::uint32_t mask) {
    if (const SpirvPlace* found = FindIn(loaded_, value)) masks_[*found] |= mask;
  }

  const SpirvModule& module_;
  std::set<SpirvId> structs_;               // variables that are structs
  std::map<SpirvId, SpirvPlace> pointers_;  // by pointer, members of structs
  std::map<SpirvId, SpirvPlace> loaded_;    // by value, the place that it was loaded from
  std::map<SpirvPlace, std::uint32_t> masks_;
};

class SpirvReader {
 public:
  SpirvReader(const SpirvModule& module, const EntryPoint& entry, std::string_view path)
      : module_(module), entry_(entry), reads_(module, entry.function), path_(path) {}

  Interface Run() {
    for (const SpirvVariable& variable : module_.variables) {
      const SpirvType* pointer = module_.TypeOf(variable.type);
      const SpirvType* type = pointer ? module_.TypeOf(pointer->element) : nullptr;
      if (!type) continue;
      if (variable.storage == spv::kInput) Variable(variable, pointer->element, *type);
      if (variable.storage == spv::kUniform && type->kind == SpirvKind::kStruct &&
          module_.Decoration({pointer->element}, spv::kBlock)) {
        AddBlock(variable, pointer->element);
      }
    }
    return std::move(interface_);
  }
  // The message about an input that cannot match an output; empty if all can.
  const std::string& problem() const { return problem_; }
  bool HasTooManyMembers() const { return member_count_ > kMaxMembers; }

 private:
  std::string Where(std::string_view name) const { return fmt::format("{}: `{}`", path_, name); }

  // ---- inputs

  void Variable(const SpirvVariable& variable, SpirvId type_id, const SpirvType& type) {
    const bool is_listed =
        std::ranges::find(entry_.interface, variable.id) != entry_.interface.end();
    if (!is_listed || module_.Decoration({variable.id}, spv::kBuiltIn)) return;
    const auto location = module_.Decoration({variable.id}, spv::kLocation);
    if (type.kind != SpirvKind::kStruct)
      return AddInput({variable.id}, {variable.id}, type_id, location);
    for (std::uint32_t i = 0; i < type.members.size(); ++i) {
      if (module_.Decoration({type_id, i}, spv::kBuiltIn)) return;
    }
    if (type.members.empty()) return;
    AddGroup(variable, type_id, type, location);
  }

  // Adds a block or a struct: each member is an input.
  void AddGroup(const SpirvVariable& variable, SpirvId type_id, const SpirvType& type,
                std::optional<std::uint32_t> location) {
    Group group;
    group.is_block = module_.Decoration({type_id}, spv::kBlock).has_value();
    const auto named = [](std::string name, std::string otherwise) {
      return name.empty() ? std::move(otherwise) : std::move(name);
    };
    const std::string number = std::to_string(interface_.groups.size());
    group.type = named(GlslNameOf(module_.NameOf({type_id})), "Varyings" + number);
    // SPIRV-Cross writes an instance of every block.
    group.instance = named(GlslNameOf(module_.NameOf({variable.id})), "varyings" + number);
    group.where = Where(group.type);
    const bool has_own = module_.Decoration({type_id, 0}, spv::kLocation).has_value();
    if (!has_own) group.location = location;
    std::uint32_t next = location.value_or(0);
    for (std::uint32_t i = 0; i < type.members.size(); ++i) {
      if (member_count_++ >= kMaxMembers) break;
      const SpirvPlace member{type_id, i};
      const std::optional<std::uint32_t> own = module_.Decoration(member, spv::kLocation);
      AddInput(member, {variable.id, i}, type.members[i], own.value_or(next));
      Input& added = interface_.inputs.back();
      added.name = named(std::move(added.name), "member_" + std::to_string(i));
      added.where = Where(group.type + "." + added.name);
      added.group = interface_.groups.size();
      added.has_own_location = own.has_value();
      if (!group.is_block && i == 0) Qualify(added, {variable.id});
      next = *added.location + added.type.Elements();
    }
    interface_.groups.push_back(std::move(group));
  }

  // Adds an input. `place` has the name and the decorations; `read` is the place that instructions
  // read.
  void AddInput(SpirvPlace place, SpirvPlace read, SpirvId type,
                std::optional<std::uint32_t> location) {
    Input& input = interface_.inputs.emplace_back();
    input.name = GlslNameOf(module_.NameOf(place));
    input.location = location;
    if (const std::string* written = FindIn(module_.semantics, place)) {
      const signature::SemanticName semantic = signature::SplitSemantic(*written);
      input.semantic = semantic.name;
      input.index = semantic.index;
    }
    const std::optional<GlslType> known = GlslTypeAt(type);
    if (!known && problem_.empty())
      problem_ = fmt::format(
          "{} is a struct in a struct or an array of structs; numbers, arrays of "
          "them, and structs and blocks of both can match outputs",
          Where(module_.NameOf(place)));
    input.type = known.value_or(GlslType{});
    Qualify(input, place);
    const std::optional<std::uint32_t> components = reads_.Of(read);
    input.is_read = components.has_value();
    const SpirvType* described = module_.TypeOf(type);
    if (described && described->kind == SpirvKind::kVector)
      input.components_read = components.value_or(0xF);
    input.where = Where(module_.NameOf(place));
  }

  void Qualify(Input& input, SpirvPlace place) const {
    const auto has = [&](std::uint32_t which) {
      return module_.Decoration(place, which).has_value();
    };
    if (has(spv::kFlat)) input.interpolation = ir::Interpolation::kNoInterpolation;
    if (has(spv::kNoPerspective)) input.interpolation = ir::Interpolation::kNoPerspective;
    input.centroid = has(spv::kCentroid);
    input.sample = has(spv::kSample);
  }

  // ---- types

  std::optional<GlslType> GlslTypeAt(SpirvId id) const {
    GlslType result;
    const SpirvType* type = module_.TypeOf(id);
    for (int i = 0; type && type->kind == SpirvKind::kArray; ++i) {
      if (i == kMaxDepth) return std::nullopt;
      result.dimensions.push_back(type->count);
      type = module_.TypeOf(type->element);
    }
    if (type && type->kind == SpirvKind::kMatrix) {
      result.columns = static_cast<std::uint8_t>(std::clamp(type->count, 2u, 4u));
      type = module_.TypeOf(type->element);
    }
    if (type && type->kind == SpirvKind::kVector) {
      result.components = static_cast<std::uint8_t>(std::clamp(type->count, 2u, 4u));
      type = module_.TypeOf(type->element);
    }
    if (!type) return std::nullopt;
    switch (type->kind) {
      case SpirvKind::kBool: result.scalar = ir::Scalar::kBool; break;
      case SpirvKind::kInt: result.scalar = ir::Scalar::kInt; break;
      case SpirvKind::kUint: result.scalar = ir::Scalar::kUint; break;
      case SpirvKind::kFloat:
        result.scalar = type->count == 64 ? ir::Scalar::kDouble : ir::Scalar::kFloat;
        break;
      default: return std::nullopt;
    }
    return result;
  }

  // ---- uniform blocks

  void AddBlock(const SpirvVariable& variable, SpirvId type) {
    UniformBlock block;
    block.name = GlslNameOf(module_.NameOf({type}));
    block.has_instance = true;  // as SPIRV-Cross writes every block
    block.instance = GlslNameOf(module_.NameOf({variable.id}));
    block.members = Members(type, 0);
    block.set = module_.Decoration({variable.id}, spv::kDescriptorSet);
    block.binding = module_.Decoration({variable.id}, spv::kBinding);
    block.where = Where(block.name);
    interface_.blocks.push_back(std::move(block));
  }

  std::vector<UniformMember> Members(SpirvId type, int depth) {
    std::vector<UniformMember> members;
    const SpirvType* structure = module_.TypeOf(type);
    if (!structure || depth == kMaxDepth) return members;
    for (std::uint32_t i = 0; i < structure->members.size(); ++i) {
      if (member_count_++ >= kMaxMembers) return members;
      const SpirvPlace place{type, i};
      UniformMember member;
      member.name = GlslNameOf(module_.NameOf(place));
      member.offset = module_.Decoration(place, spv::kOffset);
      if (module_.Decoration(place, spv::kRowMajor)) member.matrices = ir::MatrixLayout::kRowMajor;
      if (module_.Decoration(place, spv::kColMajor))
        member.matrices = ir::MatrixLayout::kColumnMajor;
      if (module_.Decoration(place, spv::kRelaxedPrecision))
        member.precision = ir::Precision::kMedium;  // as SPIRV-Cross writes it
      member.type = GlslTypeAt(structure->members[i]);
      if (!member.type) Fields(structure->members[i], depth, member);
      members.push_back(std::move(member));
    }
    return members;
  }

  void Fields(SpirvId id, int depth, UniformMember& member) {
    const SpirvType* type = module_.TypeOf(id);
    for (int i = 0; type && type->kind == SpirvKind::kArray && i < kMaxDepth; ++i) {
      member.struct_dimensions.push_back(type->count);
      id = type->element;
      type = module_.TypeOf(id);
    }
    if (type && type->kind == SpirvKind::kStruct) member.fields = Members(id, depth + 1);
  }

  const SpirvModule& module_;
  const EntryPoint& entry_;
  const Reads reads_;
  std::string_view path_;
  std::size_t member_count_ = 0;
  std::string problem_;
  Interface interface_;
};

}  // namespace

ReadResult ReadSpirv(std::string_view bytes, std::string_view path, std::string_view entry) {
  ReadResult result;
  std::string problem;
  const SpirvModule module = ReadModule(bytes, problem);
  const auto fail = [&](std::string text) {
    result.problems.push_back(fmt::format("{}: {}", path, text));
    return std::move(result);
  };
  if (!problem.empty()) return fail(problem);
  std::vector<const EntryPoint*> chosen;
  std::string names;
  for (const EntryPoint& point : module.entry_points) {
    if (point.model != spv::kFragment) continue;
    names += fmt::format("{}`{}`", names.empty() ? "" : ", ", point.name);
    if (entry.empty() || point.name == entry) chosen.push_back(&point);
  }
  if (names.empty()) return fail("the SPIR-V has no fragment shader");
  if (chosen.empty())
    return fail(fmt::format("there is no fragment shader `{}`; there is {}", entry, names));
  if (chosen.size() > 1 && entry.empty())
    return fail(
        fmt::format("there are several fragment shaders, {}; `--pixel-entry` names one", names));
  SpirvReader reader(module, *chosen[0], path);
  result.interface = reader.Run();
  if (!reader.problem().empty()) result.problems.push_back(reader.problem());
  if (reader.HasTooManyMembers())
    return fail(fmt::format("the blocks have more than {} members", kMaxMembers));
  return result;
}

}  // namespace clipc::link
