// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/blocks.h"

#include <algorithm>

#include <fmt/format.h>

#include "backend-glsl/text.h"
#include "backend-glsl/writer/bindings.h"
#include "backend-glsl/writer/stmt.h"
#include "backend-glsl/writer/types.h"
#include "ir/packing.h"

namespace clipc::glsl {

using namespace ir;

namespace {

class BlockWriter {
 public:
  BlockWriter(Code& code, const GlslInfo::UniformBlock& info, std::string& text)
      : code_(code),
        cbuffer_(code[info.cbuffer]),
        layout_(code.layouts[info.cbuffer.index]),
        info_(info),
        text_(text) {
    register_ = RegisterText(cbuffer_.reg);
    if (cbuffer_.reg.space != 0) Append(register_, ", space", std::to_string(cbuffer_.reg.space));
  }

  void Write() {
    if (layout_.form == BlockForm::kUniforms) return PlainUniforms();
    if (cbuffer_.count == 0) code_.Require("GL_EXT_nonuniform_qualifier");
    const bool is_rows = layout_.form == BlockForm::kRows;
    if (is_rows && !code_.Has(Feature::kUniformBlocks)) return RowUniform();
    const bool turned = layout_.matrices == MatrixLayout::kRowMajor && !is_rows;
    const bool is_pushed = info_.is_push_constant;
    const std::string place = is_pushed ? "push_constant" : PlaceText(info_);
    Append(text_, LayoutText({"std140", place, turned ? "row_major" : ""}), "uniform ", info_.name,
           is_pushed ? " {\n" : Concat(" {  // ", register_, "\n"));
    is_rows ? Rows() : Members();
  }

 private:
  void PlainUniforms() {
    Append(text_, "// ", cbuffer_.name, ", ", register_, "\n");
    for (const BlockMember& member : layout_.members) {
      if (code_.reached.Has(member.var)) PlainUniform(text_, member.var);
    }
    text_ += "\n";
  }

  // The qualifier of a member that another stage declares below `highp`, which a vertex shader has
  // by default; empty for other members.
  std::string_view PrecisionOf(VarId member, int field = -1) const {
    const bool is_struct = cbuffer_.kind == CbufferKind::kConstantBuffer && field < 0;
    if (!cbuffer_.declared || !code_.target.IsEs() || is_struct) return "";
    const auto at = std::ranges::find(cbuffer_.members, member, &CbufferMember::var);
    const auto number = static_cast<std::size_t>(field < 0 ? at - cbuffer_.members.begin() : field);
    const auto& members = cbuffer_.declared->members;
    if (number >= members.size() || members[number].precision == Precision::kHigh) return "";
    return members[number].precision == Precision::kLow ? "lowp " : "mediump ";
  }

  void PlainUniform(std::string& text, VarId member) {
    Append(text, "uniform ", PrecisionOf(member),
           UniformDeclaration(code_, code_[member].type, code_.NameOf(member)), ";\n");
  }

  void Members() {
    for (const BlockMember& member : layout_.members) Member(member);
    for (const ByHand& member : layout_.by_hand) {
      const BlockMember& part = layout_.members[member.part];
      // A struct without fields takes no room in any part.
      if (part.form != PartForm::kRows && part.var != member.var) Reader(member.var);
    }
    text_ += "}";
    if (layout_.has_instance) {
      const VarId var = layout_.members.front().var;
      Append(text_, " ", info_.instance, layout_.fields_as_members ? Dimensions(code_, var) : "");
    }
    text_ += ";\n\n";
  }

  void Padding(const BlockMember& member) {
    ForEachPadding(member, [&](std::uint32_t, std::uint32_t rows) {
      const std::string& name = code_.names.paddings[info_.cbuffer.index][paddings_++];
      Append(text_, rows > 0 ? "    vec4 " : "    float ", name,
             rows > 1 ? fmt::format("[{}]", rows) : "", ";\n");
    });
  }

  void Member(const BlockMember& member) {
    Padding(member);
    const bool turned =
        layout_.matrices == MatrixLayout::kNone && member.matrices == MatrixLayout::kRowMajor;
    AppendPart(text_, "    ");
    if (member.explicit_offset || turned) {
      text_ += LayoutText({member.explicit_offset ? fmt::format("offset = {}", member.offset) : "",
                           turned ? "row_major" : ""});
    }
    if (member.form == PartForm::kRows) return PartInRows(member);
    if (member.form == PartForm::kWords) return PartInWords(member);
    const std::string& name = code_.NameOf(member);
    AppendPart(text_, PrecisionOf(member.var, member.field));
    if (code_.IsWrittenAsUint(member.var)) {
      const Shape shape = ShapeOf(code_[member.type], code_.needs);
      AppendDeclaration(code_, text_, shape.With(Scalar::kUint), name);
    } else {
      AppendDeclaration(code_, text_, member.type, name);
    }
    AppendPart(text_, ";\n");
  }

  // Writes an array of rows, and the functions that read members out of it.
  void PartInRows(const BlockMember& part) {
    text_ += fmt::format("{} {}[{}];\n", part.float_rows ? "vec4" : "uvec4",
                         code_.NameOf(part.memory), part.rows);
    for (const ByHand& member : layout_.by_hand) {
      if (&layout_.members[member.part] == &part) Reader(member.var);
    }
  }

  // Writes a scalar for each component of a vector, and the function that reads the vector.
  void PartInWords(const BlockMember& part) {
    const Scalar kind = BaseOf(code_[part.type].scalar);
    const Shape scalar = ShapeOf(kind == Scalar::kBool ? Scalar::kUint : kind, 1, 1);
    for (std::uint32_t i = 0; i < code_[part.type].columns; ++i) {
      // The first is after its layout.
      Append(text_, i > 0 ? "    " : "", TypeName(code_, scalar), " ",
             code_.names.vars[part.memory.index + i], ";\n");
    }
    Reader(part.var);
  }

  // Writes a buffer that neither std140 nor offsets can lay out: rows of 16 bytes, and a function
  // for each member that is read.
  void Rows() {
    text_ += fmt::format("    {} {}[{}];\n}}", layout_.float_rows ? "vec4" : "uvec4", info_.rows,
                         std::max(cbuffer_.size / kRow, 1u));
    if (!info_.instance.empty())
      Append(text_, " ", info_.instance, Dimensions(code_, cbuffer_.members[0].var));
    text_ += ";\n\n";
    for (const CbufferMember& member : cbuffer_.members) Reader(member.var);
  }

  // Writes a buffer where the target has no blocks: an array of rows, up to the last one that is
  // read, to which the host gives the bytes of the buffer.
  void RowUniform() {
    std::string uniforms;
    for (const GlslInfo::UniformMember& member : info_.members)
      member.is_uniform ? PlainUniform(uniforms, member.var) : Reader(member.var);
    if (!info_.rows.empty()) {
      text_ += fmt::format("uniform vec4 {}[{}];  // {}\n", info_.rows, RowsRead(code_, cbuffer_),
                           register_);
    } else {
      Append(text_, "// ", cbuffer_.name, ", ", register_, "\n");
    }
    Append(text_, uniforms, "\n");
  }

  // Writes the function that reads the member, unless only the other stage of a pair reads it.
  void Reader(VarId member) {
    if (const FunctionId reader = code_.readers[member.index])
      WriteReader(code_, reader, code_.NameOf(member));
  }

  Code& code_;
  const Cbuffer& cbuffer_;
  const BlockLayout& layout_;
  const GlslInfo::UniformBlock& info_;
  std::string& text_;
  std::string register_;
  std::size_t paddings_ = 0;  // how many are written
};

}  // namespace

std::string WriteBlocks(Code& code, std::span<const GlslInfo::UniformBlock> blocks) {
  std::string text;
  text.reserve(1024);
  for (const GlslInfo::UniformBlock& block : blocks) BlockWriter(code, block, text).Write();
  return text;
}

}  // namespace clipc::glsl
