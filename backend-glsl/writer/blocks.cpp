// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/blocks.h"

#include <algorithm>
#include <unordered_set>

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
  BlockWriter(Code& code, CbufferId id, Bindings& bindings, UniformBlocks& blocks)
      : code_(code),
        bindings_(bindings),
        cbuffer_(code[id]),
        layout_(code.layouts[id.index]),
        info_(blocks.info.emplace_back()),
        text_(blocks.text) {
    info_.cbuffer = id;
    info_.is_shared = code.IsShared(id);
    info_.form = layout_.form;
    register_ = RegisterText(cbuffer_.reg);
    if (cbuffer_.reg.space != 0) Append(register_, ", space", std::to_string(cbuffer_.reg.space));
  }

  void Write() {
    if (layout_.form == BlockForm::kUniforms) return PlainUniforms();
    info_.name = code_.names.blocks[info_.cbuffer.index];
    if (cbuffer_.count == 0) code_.Require("GL_EXT_nonuniform_qualifier");
    const bool is_rows = layout_.form == BlockForm::kRows;
    if (is_rows && !code_.Has(Feature::kUniformBlocks)) return RowUniform();
    const bool turned = layout_.matrices == MatrixLayout::kRowMajor && !is_rows;
    const bool is_pushed = cbuffer_.is_push_constant && code_.target.IsVulkan();
    info_.is_push_constant = is_pushed;
    const std::string place = is_pushed ? "push_constant"
                              : cbuffer_.declared
                                  ? Bind(code_, info_, *cbuffer_.declared)
                                  : Bind(code_, info_, cbuffer_.reg, bindings_, cbuffer_.count,
                                         code_.LaidBlock(info_.cbuffer));
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
    const std::string& name = code_.NameOf(member);
    const Var& var = code_[member];
    Append(text, "uniform ", PrecisionOf(member), UniformDeclaration(code_, var.type, name), ";\n");
    // Rows of HLSL are columns of GLSL, so a matrix that is row-major in HLSL needs no transposing.
    info_.members.push_back({member, -1, name, true, !var.row_major});
  }

  void Members() {
    info_.members.reserve(layout_.members.size());
    for (const BlockMember& member : layout_.members) Member(member);
    for (const ByHand& member : layout_.by_hand) {
      const BlockMember& part = layout_.members[member.part];
      // A struct without fields takes no room in any part.
      if (part.form != PartForm::kRows && part.var != member.var) Reader(member.var);
    }
    text_ += "}";
    if (layout_.has_instance) {
      const VarId var = layout_.members.front().var;
      const bool is_variable = layout_.fields_as_members;
      info_.instance = is_variable ? code_.NameOf(var) : code_.names.instances[info_.cbuffer.index];
      Append(text_, " ", info_.instance, is_variable ? Dimensions(code_, var) : "");
    }
    text_ += ";\n\n";
  }

  const std::string& NameOf(const BlockMember& member) const {
    if (member.field < 0) return code_.NameOf(member.var);
    const Type& type = code_[code_.types.Innermost(code_[member.var].type)];
    return code_.names.fields[type.structure.index][static_cast<std::size_t>(member.field)];
  }

  // A name that nothing else in the block has, for what is not a member in HLSL.
  std::string PartName(std::string name) {
    if (!layout_.has_instance) return code_.namer.Global(name);
    if (part_names_.empty()) {
      for (const BlockMember& member : layout_.members) {
        if (member.form == PartForm::kWhole) part_names_.insert(NameOf(member));
      }
    }
    name = LegalFieldName(name);
    while (!part_names_.insert(name).second) name = LegalFieldName(name + "_2");
    return name;
  }

  // Padding is single floats up to a row, rows, and single floats again: std140 moves none of them.
  void Padding(const BlockMember& member) {
    for (std::uint32_t end = member.offset - member.padding; end < member.offset;) {
      const std::uint32_t rows = end % kRow == 0 ? (member.offset - end) / kRow : 0;
      Append(text_, rows > 0 ? "    vec4 " : "    float ", PartName(fmt::format("padding_{}", end)),
             rows > 1 ? fmt::format("[{}]", rows) : "", ";\n");
      end += rows > 0 ? rows * kRow : 4;
    }
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
    const std::string& name = NameOf(member);
    AppendPart(text_, PrecisionOf(member.var, member.field));
    if (code_.IsWrittenAsUint(member.var)) {
      const Shape shape = ShapeOf(code_[member.type], code_.needs);
      AppendDeclaration(code_, text_, shape.With(Scalar::kUint), name);
    } else {
      AppendDeclaration(code_, text_, member.type, name);
    }
    AppendPart(text_, ";\n");
    info_.members.push_back({member.var, member.field, HostName(name)});
  }

  std::string HostName(const std::string& name) const {
    return layout_.has_instance ? Concat(info_.name, ".", name) : name;
  }
  // Writes an array of rows, and the functions that read members out of it.
  void PartInRows(const BlockMember& part) {
    const std::string name = PartName(code_[part.var].name + "_rows");
    text_ += fmt::format("{} {}[{}];\n", part.float_rows ? "vec4" : "uvec4", name, part.rows);
    code_.names.vars[part.memory.index] = name;
    for (const ByHand& member : layout_.by_hand) {
      if (&layout_.members[member.part] != &part) continue;
      info_.members.push_back(
          {member.var, -1, HostName(name), false, false, code_.NameOf(member.var), part.offset});
      Reader(member.var);
    }
  }

  // Writes a scalar for each component of a vector, and the function that reads the vector.
  void PartInWords(const BlockMember& part) {
    const Scalar kind = BaseOf(code_[part.type].scalar);
    const Shape scalar = ShapeOf(kind == Scalar::kBool ? Scalar::kUint : kind, 1, 1);
    for (std::uint32_t i = 0; i < code_[part.type].columns; ++i) {
      const std::string name =
          PartName(Concat(code_[part.var].name, "_", std::string_view("xyzw").substr(i, 1)));
      // The first is after its layout.
      Append(text_, i > 0 ? "    " : "", TypeName(code_, scalar), " ", name, ";\n");
      code_.names.vars[part.memory.index + i] = name;
      if (i == 0) {
        info_.members.push_back(
            {part.var, -1, HostName(name), false, false, code_.NameOf(part.var)});
      }
    }
    Reader(part.var);
  }

  // Writes a buffer that neither std140 nor offsets can lay out: rows of 16 bytes, and a function
  // for each member that is read.
  void Rows() {
    info_.rows = code_.names.rows[info_.cbuffer.index];
    text_ += fmt::format("    {} {}[{}];\n}}", layout_.float_rows ? "vec4" : "uvec4", info_.rows,
                         std::max(cbuffer_.size / kRow, 1u));
    std::string& memory = code_.names.vars[layout_.memory.index];
    memory = info_.rows;
    const std::string dimensions = cbuffer_.kind == CbufferKind::kConstantBuffer
                                       ? Dimensions(code_, cbuffer_.members[0].var)
                                       : "";
    if (!dimensions.empty()) {
      info_.instance = code_.namer.Global(cbuffer_.name + "_buffers");
      Append(text_, " ", info_.instance, dimensions);
      memory = info_.instance;
      const TypeId rows = code_.types.Innermost(code_[layout_.memory].type);
      code_.names.fields[code_[rows].structure.index][0] = info_.rows;
    }
    text_ += ";\n\n";
    for (const CbufferMember& member : cbuffer_.members) {
      Reader(member.var);
      info_.members.push_back({member.var, -1, code_.NameOf(member.var)});
    }
  }

  // Writes a buffer where the target has no blocks: an array of rows, up to the last one that is
  // read, to which the host gives the bytes of the buffer.
  void RowUniform() {
    info_.rows = code_.names.rows[info_.cbuffer.index];
    info_.name.clear();
    code_.names.vars[layout_.memory.index] = info_.rows;
    std::string uniforms;
    std::uint32_t end = 0;
    for (const CbufferMember& member : cbuffer_.members) {
      const bool is_by_hand = OnlyFloats(code_.types, code_[member.var].type);
      // The two stages of a pair declare the same rows.
      if (is_by_hand && code_.IsReadInProgram(member.var))
        end = std::max(end, member.offset + member.size);
      if (!code_.reached.Has(member.var)) continue;
      if (!is_by_hand) {
        PlainUniform(uniforms, member.var);
        continue;
      }
      Reader(member.var);
      info_.members.push_back({member.var, -1, code_.NameOf(member.var)});
    }
    if (end > 0) {
      text_ += fmt::format("uniform vec4 {}[{}];  // {}\n", info_.rows, (end + kRow - 1) / kRow,
                           register_);
    } else {
      Append(text_, "// ", cbuffer_.name, ", ", register_, "\n");
      info_.rows.clear();
    }
    Append(text_, uniforms, "\n");
  }

  // Writes the function that reads the member, unless only the other stage of a pair reads it.
  void Reader(VarId member) {
    if (const FunctionId reader = code_.readers[member.index])
      WriteReader(code_, reader, code_.NameOf(member));
  }

  Code& code_;
  Bindings& bindings_;
  const Cbuffer& cbuffer_;
  const BlockLayout& layout_;
  GlslInfo::UniformBlock& info_;
  std::string& text_;
  std::string register_;
  std::unordered_set<std::string> part_names_;  // those in the block; filled for the first part
};

}  // namespace

UniformBlocks WriteBlocks(Code& code) {
  UniformBlocks blocks;
  blocks.text.reserve(1024);
  blocks.info.reserve(code.program.cbuffers.size());
  Bindings bindings;
  for (const OtherStage& other : code.others) {
    if (!other.laid) continue;
    for (const GlslInfo::UniformBlock& block : other.laid->blocks) bindings.Take(block);
  }
  for (const CbufferId id : code.program.cbuffers.ids()) {
    if (code.reached.Has(id)) bindings.Reserve(code[id].reg, code[id].count);
  }
  for (const CbufferId id : code.program.cbuffers.ids()) {
    if (code.reached.Has(id)) BlockWriter(code, id, bindings, blocks).Write();
  }
  return blocks;
}

}  // namespace clipc::glsl
