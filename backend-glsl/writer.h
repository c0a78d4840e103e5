// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "backend-glsl/block_layout.h"
#include "backend-glsl/names.h"
#include "backend-glsl/operators.h"
#include "backend-glsl/reach.h"
#include "backend-glsl/shape.h"
#include "backend-glsl/snippets.h"
#include "backend-glsl/target.h"
#include "backend-glsl/text.h"
#include "backend-glsl/write.h"
#include "ir/access.h"
#include "ir/program.h"

namespace clipc::glsl {

inline constexpr std::uint32_t kLongArray =
    17;  // elements; from here on a loop fills an array, not a constructor

// A texture and the sampler it is read with; none for reads without one.
struct TextureUse {
  ir::VarId texture, sampler;
  friend auto operator<=>(const TextureUse&, const TextureUse&) = default;
};

// An operand: its text, or the scalar that fills it.
struct Operand {
  Text text;  // empty when scalar is given
  Shape shape;
  std::optional<Text> scalar;        // every component is this
  std::optional<Constant> constant;  // the value of `scalar`, where the program says it
  bool repeatable = false;           // short and without effects: may be written twice
};

// The scalar that fills the operand, or the whole operand.
inline Text ScalarOr(Operand operand) {
  return operand.scalar ? std::move(*operand.scalar) : std::move(operand.text);
}

// Where a value lies in an array of words or rows.
struct Address {
  std::string dynamic;       // added to the constant part, in the array's units; may be empty
  std::uint32_t offset = 0;  // bytes
};
struct Memory {
  std::string array;      // "Light_rows", "vertices_words"
  bool is_rows = true;    // rows of four words; else single words
  bool is_float = false;  // the words are floats; else uints
};

// The state of one WriteGlsl. Its methods are spread over writer*.cpp by subject.
class Writer {
 public:
  Writer(const ir::Program& program, const Target& target, const WriteOptions& options,
         GlslInfo& info, Reached reached);
  std::string Write();

 private:
  // ---- writer.cpp: the order of the file
  std::string Header() const;
  void Globals();
  void Functions();
  void OneFunction(ir::FunctionId id);
  void Main();
  std::string Signature(ir::FunctionId id);

  // ---- writer_names.cpp
  void NameEverything();
  void NameInterface();
  void NameUniforms();
  void NameStructs();
  void NameFunctions();
  std::string OverloadKey(const ir::Function& function);

  // ---- writer_types.cpp
  struct TypeParts {
    std::string base, dimensions;  // "vec4" and "[2][3]"
  };
  TypeParts PartsOf(ir::TypeId type);
  std::string TypeName(ir::TypeId type);
  std::string TypeName(const Shape& shape) const {
    return GlslName(shape, target_.Has(Feature::kUnsigned));
  }
  std::string Declaration(ir::TypeId type, std::string_view name);  // "float name[3]"
  std::string Declaration(const Shape& shape, std::string_view name) const;
  void UseStruct(ir::StructId id);
  bool IsWrapped(ir::TypeId array_element) const;
  std::string FilledArray(ir::TypeId type,
                          const std::function<std::string(const std::string&)>& element);
  std::string WrapperOf(ir::TypeId array);
  std::string ElementText(ir::TypeId element, Text text);  // as an argument of an array constructor
  std::string ZeroText(ir::TypeId type);
  std::string ZeroText(const Shape& shape) const;
  std::string FieldName(ir::StructId id, std::uint32_t field) const {
    return field_names_[id.index][field];
  }

  // ---- writer_interface.cpp
  void Inputs();
  void Outputs();
  void PerVertex();
  std::string InputText(const ir::IoVar& input, GlslInfo::Variable& info);
  std::string OutputName(const ir::IoVar& output) const;
  std::uint32_t WrittenElements(ir::VarId array) const;

  // ---- writer_blocks.cpp
  void Blocks();
  void Block(ir::CbufferId id);
  void PlainUniforms(ir::CbufferId id);
  void BlockMembers(const BlockLayout& layout, GlslInfo::Block& info);
  void RowsBlock(ir::CbufferId id, GlslInfo::Block& info);
  void Accessor(const ir::CbufferMember& member, const Memory& memory, bool is_buffer_array);
  std::string BlockQualifiers(const ir::Cbuffer& cbuffer, const BlockLayout& layout,
                              GlslInfo::Block& info);
  std::string Dimensions(ir::VarId var) const;
  Text UniformText(ir::VarId var);
  Text UniformElement(ir::VarId var, ir::ExprId index);
  ir::VarId InstanceOf(ir::ExprId expr, std::vector<ir::ExprId>& indices) const;
  std::optional<std::string> InstancePath(
      ir::ExprId expr);  // "lights[i]" of a block with an instance name
  Text InstanceValue(ir::ExprId expr, const std::string& path);

  // ---- writer_memory.cpp: values out of arrays of words
  std::string Load(const Memory& memory, ir::TypeId type, bool row_major, const Address& address);
  std::string LoadArray(const Memory& memory, ir::TypeId type, bool row_major,
                        const Address& address);
  std::string LoadMatrix(const Memory& memory, const ir::Type& type, bool row_major,
                         const Address& address);
  std::string LoadVector(const Memory& memory, ir::Scalar kind, int components,
                         const Address& address);
  std::string Words(const Memory& memory, const Address& address, int count);
  std::string FromWords(const Memory& memory, ir::Scalar kind, int components, std::string words);
  std::uint32_t StrideOf(const Memory& memory, ir::TypeId array, bool row_major) const;

  // ---- writer_stmt.cpp
  void Comment(Span span);
  void Statement(ir::StmtId id);
  void Statements(std::span<const ir::StmtId> list);
  void Body(ir::StmtId id);  // of a compound statement, in braces
  void If(const ir::If& node, std::string_view lead);
  void For(const ir::For& node);
  void Switch(const ir::Switch& node);
  std::string DeclareText(const ir::Declare& node);
  template <typename... Parts>
  void Line(const Parts&... parts) {
    out_->append(static_cast<std::size_t>(indent_) * 4, ' ');
    Append(*out_, parts..., "\n");
  }

  // ---- writer_expr.cpp
  Text Expr(ir::ExprId id);
  std::string ArgumentOf(ir::ExprId id) { return Argument(Expr(id)); }
  Text VarText(ir::VarId var);
  Text IndexText(const ir::Expr& expr, const ir::Index& node);
  std::string IndexValue(ir::ExprId index);
  Text SwizzleText(const ir::Swizzle& node);
  Text MatrixSwizzleText(const ir::Expr& expr, const ir::MatrixSwizzle& node);
  Text UnaryText(const ir::Unary& node);
  Text AssignText(const ir::Assign& node);
  Text ConvertText(const ir::Expr& expr, const ir::Convert& node);
  Text ConstructText(const ir::Expr& expr, const ir::Construct& node);
  Text NumericConstruct(const Shape& shape, std::span<const ir::ExprId> arguments);
  Text MatrixTruncateText(const ir::Expr& expr, const ir::MatrixTruncate& node);
  Text CallText(const ir::Call& node);
  const ir::Type& TypeOf(ir::ExprId id) const { return program_.types[program_.exprs[id].type]; }
  Shape ShapeAt(ir::ExprId id) const { return ShapeOf(TypeOf(id)); }
  bool IsRepeatable(ir::ExprId id) const;

  // ---- writer_operators.cpp: operations on texts
  Operand OperandOf(ir::ExprId id);
  std::vector<Operand> OperandsOf(List<ir::ExprId> list);
  Text Full(const Operand& operand);  // of its whole shape
  Text SplatText(const Text& scalar, const Shape& shape, bool repeatable, bool is_zero = false);
  Text UnaryOn(ir::UnaryOp op, const Operand& operand);
  Text BinaryOn(ir::BinaryOp op, Operand left, Operand right);
  Text ConvertOn(ir::Scalar kind, const Operand& operand);

  // ---- writer_helpers.cpp: functions that GLSL or the target lacks
  // A name for a parameter or local of a function that is being defined, unlike everything it may
  // mention.
  std::string Fresh(std::string_view wanted);
  // The GLSL name of helper `name`; defines it by define(glsl name) when `key` is new.
  std::string Helper(std::string_view name, const std::string& key,
                     const std::function<std::string(const std::string&)>& define);
  // The GLSL name of a helper function of the program; writes the function when it is new.
  std::string HelperFunction(ir::FunctionId id);
  // A call of the snippet `name` (see snippets.cpp) for the first operand's shape.
  Text SnippetCall(std::string_view name, std::span<const Operand> operands);
  // The GLSL name of the snippet for arguments of this shape.
  std::string SnippetName(const SnippetText& snippet, const Shape& shape);
  Text CallOn(std::string_view function, std::span<const Operand> operands);
  Text CallOn(std::string_view function, std::span<const Operand> operands, unsigned scalars);

  // ---- writer_intrinsics.cpp
  Text IntrinsicText(const ir::Expr& expr, const ir::IntrinsicCall& node);
  std::optional<Text> BitFunctionOn(ir::Intrinsic op, std::span<const Operand> operands,
                                    const Shape& result);
  Text CastOn(ir::Scalar to, const Operand& operand);
  Text ReduceOn(ir::Intrinsic op, const Operand& operand);
  Text MulText(ir::ExprId left, ir::ExprId right, const Shape& result);

  // ---- writer_objects.cpp
  void FindTextureUses();
  void UsesIn(ir::FunctionId function);
  void Objects();
  void CombinedSamplers();
  void SeparateObject(const ir::Resource& resource);
  void ImageObject(const ir::Resource& resource);
  void BufferObject(const ir::Resource& resource);
  std::string SamplerType(ir::VarId texture, bool shadow) const;
  std::string ObjectTypeName(ir::VarId var) const;  // Vulkan's: "texture2D", "sampler"
  bool IsShadow(ir::VarId sampler) const;
  Text ObjectText(const ir::Expr& expr, const ir::ObjectCall& node);
  Text SampleText(const ir::Expr& expr, const ir::ObjectCall& node);
  Text CompareText(const ir::ObjectCall& node);
  Text GatherText(const ir::Expr& expr, const ir::ObjectCall& node);
  Text TexelText(const ir::Expr& expr, const ir::ObjectCall& node);
  Text QueryText(const ir::ObjectCall& node);
  Text BufferText(const ir::Expr& expr, const ir::ObjectCall& node);
  Text ByteLoadText(const ir::Expr& expr, const ir::ObjectCall& node);
  Text StoreText(const ir::ObjectCall& node);
  std::string ObjectName(ir::ExprId texture, ir::ExprId sampler);
  const std::string& CombinedName(const TextureUse& use) const;
  std::string IndicesOf(ir::ExprId object);
  Text Narrow(std::string four, const ir::Type& type);
  ir::VarId ObjectVar(ir::ExprId object) const;
  const ir::Type& ObjectTypeOf(ir::VarId var) const;
  // The wanted binding, or the first free one, for `count` objects.
  std::uint32_t FreeBinding(std::set<std::uint32_t>& taken, std::uint32_t wanted,
                            std::uint32_t count);

  // A name for a parameter or a variable that is declared here.
  std::string LocalName(const std::string& wanted, std::string_view fallback) {
    return in_helper_ ? wanted : namer_.Local(wanted, fallback);
  }
  void Require(Feature feature) {
    const std::string_view extension = target_.Of(feature).extension;
    if (!extension.empty()) extensions_.emplace(extension);
  }
  void Require(std::string_view extension) { extensions_.emplace(extension); }
  void RequireType(const ir::Type& type);  // what makes a `double` or a 64-bit integer known
  void NotConstant() { constant_ = false; }

  const ir::Program& program_;
  const Target& target_;
  const WriteOptions& options_;
  GlslInfo& info_;
  const Reached reached_;

  Namer namer_;
  std::vector<std::string> var_names_;
  std::vector<std::string> function_names_;
  std::vector<std::string> struct_names_;
  std::vector<std::vector<std::string>> field_names_;
  std::vector<std::string> block_names_;  // by CbufferId
  std::vector<std::string> rows_names_;
  std::vector<BlockLayout> layouts_;
  std::map<TextureUse, std::string> combined_;
  std::vector<TextureUse> texture_uses_;  // of global objects
  std::set<ir::VarId> mutable_globals_;   // written without `const`
  std::set<std::uint32_t> uniform_bindings_, texture_bindings_, storage_bindings_, image_bindings_;

  std::vector<bool> struct_used_;
  std::map<std::string, std::string> wrappers_;
  std::unordered_map<std::string, std::string> helper_names_;
  std::set<std::string> helper_keys_;
  std::vector<ir::VarId> integer_outputs_;  // uint in HLSL, int as built-in variables
  std::vector<std::pair<std::string, std::string>>
      late_globals_;  // name and value: ES initialises them in main

  std::set<std::string> extensions_;
  std::string comment_;  // the last of Comment
  std::string structs_, blocks_, objects_, inputs_, outputs_, helpers_, globals_, functions_;
  std::string* out_ = nullptr;  // where Line writes
  int indent_ = 0;
  bool in_helper_ = false;  // whose names nothing else can take
  bool constant_ = true;    // what is being written is a constant expression so far
};

}  // namespace clipc::glsl
