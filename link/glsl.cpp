// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The interface of a fragment shader in GLSL, from glslang's tree.
#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <glslang/Include/intermediate.h>
#include <glslang/MachineIndependent/localintermediate.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>

#include "link/glsl_limits.h"
#include "link/glslang_process.h"
#include "link/names.h"
#include "link/read.h"

namespace clipc::link {
namespace {

std::vector<std::string> Problems(std::string_view log, const std::string& path) {
  std::vector<std::string> problems;
  for (const auto& [line, text] : GlslangErrors(log))
    problems.push_back(fmt::format("{}:{}{} {}", path, line, line.empty() ? "" : ":", text));
  return problems;
}

// The line where the name is first used, which is taken for its declaration; 1 if it is not used.
std::size_t LineOf(std::string_view text, std::string_view name) {
  for (std::size_t at = text.find(name); at != text.npos; at = text.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    const bool is_word = (at == 0 || !IsWordCharacter(text[at - 1])) &&
                         (end == text.size() || !IsWordCharacter(text[end]));
    if (is_word) return 1 + static_cast<std::size_t>(std::ranges::count(text.substr(0, at), '\n'));
  }
  return 1;
}

// ---- glslang's types

std::vector<std::uint32_t> DimensionsOf(const glslang::TType& type) {
  std::vector<std::uint32_t> dimensions;
  if (!type.isArray()) return dimensions;
  for (int i = 0; i < type.getArraySizes()->getNumDims(); ++i)
    dimensions.push_back(static_cast<std::uint32_t>(type.getArraySizes()->getDimSize(i)));
  return dimensions;
}

std::optional<GlslType> GlslTypeFrom(const glslang::TType& type) {
  GlslType result;
  switch (type.getBasicType()) {
    case glslang::EbtFloat: break;
    case glslang::EbtDouble: result.scalar = ir::Scalar::kDouble; break;
    case glslang::EbtInt: result.scalar = ir::Scalar::kInt; break;
    case glslang::EbtUint: result.scalar = ir::Scalar::kUint; break;
    case glslang::EbtBool: result.scalar = ir::Scalar::kBool; break;
    default: return std::nullopt;
  }
  result.components =
      static_cast<std::uint8_t>(type.isMatrix() ? type.getMatrixRows() : type.getVectorSize());
  result.columns = static_cast<std::uint8_t>(type.isMatrix() ? type.getMatrixCols() : 1);
  result.dimensions = DimensionsOf(type);
  return result;
}

ir::MatrixLayout LayoutOf(const glslang::TQualifier& qualifier) {
  if (qualifier.layoutMatrix == glslang::ElmRowMajor) return ir::MatrixLayout::kRowMajor;
  return qualifier.layoutMatrix == glslang::ElmColumnMajor ? ir::MatrixLayout::kColumnMajor
                                                           : ir::MatrixLayout::kNone;
}

ir::Precision PrecisionOf(const glslang::TType& type) {
  switch (type.getQualifier().precision) {
    case glslang::EpqLow: return ir::Precision::kLow;
    case glslang::EpqMedium: return ir::Precision::kMedium;
    default: return ir::Precision::kHigh;
  }
}

std::vector<UniformMember> MembersIn(const glslang::TType& type) {
  std::vector<UniformMember> members;
  for (const glslang::TTypeLoc& field : *type.getStruct()) {
    UniformMember& member = members.emplace_back();
    member.name = field.type->getFieldName();
    member.type = GlslTypeFrom(*field.type);
    member.matrices = LayoutOf(field.type->getQualifier());
    member.precision = PrecisionOf(*field.type);
    if (field.type->getQualifier().hasOffset())
      member.offset = static_cast<std::uint32_t>(field.type->getQualifier().layoutOffset);
    if (!field.type->isStruct()) continue;
    member.struct_dimensions = DimensionsOf(*field.type);
    member.fields = MembersIn(*field.type);
  }
  return members;
}

// ---- reads of the shader

// A search for the components of global variables, and of their members, that any statement
// mentions.
class ReadFinder : public glslang::TIntermTraverser {
 public:
  static constexpr int kWhole = -1;  // in place of a member's number

  void visitSymbol(glslang::TIntermSymbol* symbol) override {
    masks_[{symbol->getId(), kWhole}] = 0xF;
  }
  bool visitBinary(glslang::TVisit, glslang::TIntermBinary* node) override {
    if (const auto member = PlaceOf(*node)) {
      masks_[*member] = 0xF;
      return false;
    }
    const auto place = PlaceOf(*node->getLeft());
    if (!place || !node->getLeft()->getType().isVector()) return true;
    std::uint32_t mask = 0;
    const auto add = [&](const TIntermNode* index) {
      const auto* constant = index->getAsConstantUnion();
      mask |= constant ? 1u << (constant->getConstArray()[0].getIConst() & 3) : 0xF;
    };
    if (node->getOp() == glslang::EOpIndexDirect) {
      add(node->getRight());
    } else if (node->getOp() == glslang::EOpVectorSwizzle && node->getRight()->getAsAggregate()) {
      for (const TIntermNode* index : node->getRight()->getAsAggregate()->getSequence()) add(index);
    } else {
      return true;
    }
    masks_[*place] |= mask;
    return false;
  }
  // The list of all globals is not a read.
  bool visitAggregate(glslang::TVisit, glslang::TIntermAggregate* node) override {
    return node->getOp() != glslang::EOpLinkerObjects;
  }

  // The components of a variable, or of a member of it, that are read; 0 for none. A read of the
  // whole variable reads its members.
  std::uint32_t Of(const glslang::TIntermSymbol& symbol, int member = kWhole) const {
    const auto mask_of = [&](int place) {
      const auto found = masks_.find({symbol.getId(), place});
      return found == masks_.end() ? 0 : found->second;
    };
    return mask_of(kWhole) | mask_of(member);
  }

 private:
  using Place = std::pair<long long, int>;  // numbers of a symbol and of a member

  // The place of a variable, or of a member of one; none for other nodes.
  static std::optional<Place> PlaceOf(glslang::TIntermTyped& node) {
    if (const auto* symbol = node.getAsSymbolNode()) return Place(symbol->getId(), kWhole);
    auto* access = node.getAsBinaryNode();
    if (!access || access->getOp() != glslang::EOpIndexDirectStruct) return std::nullopt;
    const auto* symbol = access->getLeft()->getAsSymbolNode();
    const auto* index = access->getRight()->getAsConstantUnion();
    if (!symbol || !index) return std::nullopt;
    return Place(symbol->getId(), index->getConstArray()[0].getIConst());
  }

  std::map<Place, std::uint32_t> masks_;
};

enum class Rules : std::uint8_t {
  kOpenGl,
  kVulkan,   // separate textures and samplers
  kLenient,  // the newest version: drivers take more than the version that a shader names
};

// The version and profile by which glslang reads a text without #version or, if forced, any text.
struct Reading {
  int version = 110;
  EProfile profile = ENoProfile;
  bool forces_version = false;
};

Reading Prepare(glslang::TShader& shader, Rules rules, bool is_es) {
  Reading reading;
  if (rules == Rules::kVulkan) {
    shader.setEnvInput(glslang::EShSourceGlsl, EShLangFragment, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
  } else if (rules == Rules::kLenient) {
    reading = {is_es ? 320 : 460, is_es ? EEsProfile : ECompatibilityProfile, true};
  } else if (is_es) {
    reading = {100, EEsProfile, false};
  }
  return reading;
}

bool Parse(const char* text, glslang::TShader& shader, Rules rules, bool is_es) {
  shader.setStrings(&text, 1);
  const Reading reading = Prepare(shader, rules, is_es);
  return shader.parse(GetDefaultResources(), reading.version, reading.profile,
                      reading.forces_version, false, EShMsgDefault);
}

// Returns the limit that the text exceeds once its macros are expanded; empty if there is none.
std::string LimitOfExpanded(const char* text, Rules rules, bool is_es) {
  glslang::TShader shader(EShLangFragment);
  shader.setStrings(&text, 1);
  const Reading reading = Prepare(shader, rules, is_es);
  glslang::TShader::ForbidIncluder no_includes;
  std::string expanded;
  shader.preprocess(GetDefaultResources(), reading.version, reading.profile, reading.forces_version,
                    false, EShMsgDefault, &expanded, no_includes);
  return GlslLimit(expanded);
}

// The text with `require` turned into `enable` for extensions, which glslang may not know.
std::string Lenient(std::string_view text) {
  constexpr std::string_view kRequire = "require";
  std::string lenient(text);
  for (std::size_t at = 0; (at = lenient.find("#extension", at)) != lenient.npos; ++at) {
    const std::size_t word = lenient.find(kRequire, at);
    if (word < lenient.find('\n', at)) lenient.replace(word, kRequire.size(), "enable ");
  }
  return lenient;
}

class GlslReader {
 public:
  GlslReader(const glslang::TIntermediate& tree, std::string_view text, const std::string& path)
      : text_(text), path_(path) {
    tree.getTreeRoot()->traverse(&reads_);
    const glslang::TIntermAggregate* objects = tree.findLinkerObjects();
    for (TIntermNode* object : objects ? objects->getSequence() : glslang::TIntermSequence()) {
      if (const glslang::TIntermSymbol* symbol = object->getAsSymbolNode()) Symbol(*symbol);
    }
  }

  ReadResult Take() { return std::move(result_); }

 private:
  void Symbol(const glslang::TIntermSymbol& symbol) {
    const glslang::TQualifier& qualifier = symbol.getType().getQualifier();
    if (qualifier.builtIn != glslang::EbvNone) return;
    if (qualifier.storage == glslang::EvqVaryingIn) return AddInput(symbol, qualifier);
    if (qualifier.storage != glslang::EvqUniform) return;
    if (symbol.getBasicType() == glslang::EbtBlock) return AddBlock(symbol, qualifier);
    UniformMember uniform;
    uniform.name = symbol.getName();
    uniform.type = GlslTypeFrom(symbol.getType());
    uniform.precision = PrecisionOf(symbol.getType());
    if (uniform.type || symbol.getType().isStruct()) result_.interface.uniforms.push_back(uniform);
  }

  void AddInput(const glslang::TIntermSymbol& symbol, const glslang::TQualifier& qualifier) {
    const glslang::TType& type = symbol.getType();
    if (type.isStruct() || type.getBasicType() == glslang::EbtBlock) return AddGroup(symbol, type);
    Input input;
    input.name = symbol.getName();
    input.where = Where(input.name);
    if (qualifier.hasLocation()) input.location = qualifier.layoutLocation;
    AddInput(std::move(input), type, qualifier, reads_.Of(symbol));
  }

  void AddInput(Input input, const glslang::TType& type, const glslang::TQualifier& qualifier,
                std::uint32_t components) {
    const std::optional<GlslType> known = GlslTypeFrom(type);
    if (!known) return Refuse(input.where, input.name, "a struct in a struct or block");
    input.type = *known;
    if (qualifier.flat) input.interpolation = ir::Interpolation::kNoInterpolation;
    if (qualifier.nopersp) input.interpolation = ir::Interpolation::kNoPerspective;
    input.centroid = qualifier.centroid;
    input.sample = qualifier.sample;
    input.is_read = components != 0;
    if (input.is_read) input.components_read = components;
    result_.interface.inputs.push_back(std::move(input));
  }

  // Adds a block or a struct: each member is an input.
  void AddGroup(const glslang::TIntermSymbol& symbol, const glslang::TType& type) {
    const glslang::TQualifier& qualifier = type.getQualifier();
    Group group;
    group.is_block = type.getBasicType() == glslang::EbtBlock;
    group.type = type.getTypeName();
    if (group.type.starts_with("gl_")) return;
    if (!glslang::IsAnonymous(symbol.getName())) group.instance = symbol.getName();
    if (qualifier.hasLocation()) group.location = qualifier.layoutLocation;
    const std::string shown = group.is_block ? group.type : group.instance;
    group.where = Where(shown);
    if (type.isArray()) return Refuse(group.where, shown, "an array of structs or blocks");
    const std::size_t number = result_.interface.groups.size();
    std::optional<std::uint32_t> next = group.location;
    int member = 0;
    for (const glslang::TTypeLoc& field : *type.getStruct()) {
      const glslang::TQualifier& own = field.type->getQualifier();
      Input input;
      input.name = field.type->getFieldName();
      input.where = group.where;
      input.group = number;
      input.has_own_location = own.hasLocation();
      if (own.hasLocation()) next = own.layoutLocation;
      input.location = next;
      AddInput(std::move(input), *field.type, group.is_block ? own : qualifier,
               reads_.Of(symbol, member++));
      if (!result_.problems.empty()) return;
      if (next) *next += result_.interface.inputs.back().type.Elements();
    }
    result_.interface.groups.push_back(std::move(group));
  }

  void Refuse(std::string_view where, std::string_view name, std::string_view what) {
    result_.problems.push_back(fmt::format(
        "{}: `{}` is {}; numbers, arrays of them, and structs and blocks of both can match outputs",
        where, name, what));
  }

  void AddBlock(const glslang::TIntermSymbol& symbol, const glslang::TQualifier& qualifier) {
    UniformBlock block;
    block.name = symbol.getType().getTypeName();
    block.has_instance = !glslang::IsAnonymous(symbol.getName());
    if (block.has_instance) block.instance = symbol.getName();
    block.rows_on_block = LayoutOf(qualifier) == ir::MatrixLayout::kRowMajor;
    block.members = MembersIn(symbol.getType());
    if (qualifier.hasSet()) block.set = qualifier.layoutSet;
    if (qualifier.hasBinding()) block.binding = qualifier.layoutBinding;
    block.where = Where(block.name);
    result_.interface.blocks.push_back(std::move(block));
  }

  std::string Where(std::string_view name) const {
    return fmt::format("{}:{}", path_, LineOf(text_, name));
  }

  std::string_view text_;
  const std::string& path_;
  ReadFinder reads_;
  ReadResult result_{.is_glsl = true};
};

}  // namespace

ReadResult ReadGlsl(std::string_view text, const std::string& path, Dialect expected) {
  ReadResult result{.is_glsl = true};
  if (const std::string limit = GlslLimit(text); !limit.empty()) {
    result.problems.push_back(fmt::format("{}: {}", path, limit));
    return result;
  }
  InitializeGlslang();
  bool is_es = expected == Dialect::kEs;
  for (const Rules rules : {Rules::kOpenGl, Rules::kVulkan, Rules::kLenient}) {
    const std::string given = rules == Rules::kLenient ? Lenient(text) : std::string(text);
    if (const std::string limit = LimitOfExpanded(given.c_str(), rules, is_es); !limit.empty()) {
      result.problems = {fmt::format("{}: {}", path, limit)};
      return result;
    }
    glslang::TShader shader(EShLangFragment);
    if (Parse(given.c_str(), shader, rules, is_es))
      return GlslReader(*shader.getIntermediate(), text, path).Take();
    is_es = shader.getIntermediate()->isEsProfile();
    if (rules == (expected == Dialect::kVulkan ? Rules::kVulkan : Rules::kOpenGl))
      result.problems = Problems(shader.getInfoLog(), path);
  }
  return result;
}

}  // namespace clipc::link
