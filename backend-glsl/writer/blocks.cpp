// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/blocks.h"

#include <algorithm>
#include <unordered_set>

#include <fmt/format.h>

#include "backend-glsl/text.h"
#include "backend-glsl/writer/bindings.h"
#include "backend-glsl/writer/helper.h"
#include "backend-glsl/writer/memory.h"
#include "backend-glsl/writer/types.h"
#include "ir/packing.h"

namespace clipc::glsl {

using namespace ir;

namespace {

class BlockWriter {
 public:
  BlockWriter(WriterContext& context, CbufferId id, Bindings& bindings, UniformBlocks& blocks)
      : context_(context),
        bindings_(bindings),
        cbuffer_(context[id]),
        layout_(context.layouts[id.index]),
        info_(blocks.info.emplace_back()),
        text_(blocks.text) {
    info_.cbuffer = id;
    info_.is_shared = context.IsShared(id);
    info_.form = layout_.form;
    register_ = RegisterText(cbuffer_.reg);
    if (cbuffer_.reg.space != 0) Append(register_, ", space", std::to_string(cbuffer_.reg.space));
  }

  void Write() {
    if (layout_.form == BlockForm::kUniforms) return PlainUniforms();
    info_.name = context_.names.blocks[info_.cbuffer.index];
    if (cbuffer_.count == 0) context_.Require("GL_EXT_nonuniform_qualifier");
    const bool is_rows = layout_.form == BlockForm::kRows;
    if (is_rows && !context_.Has(Feature::kUniformBlocks)) return RowUniform();
    const bool turned = layout_.matrices == MatrixLayout::kRowMajor && !is_rows;
    const bool is_pushed = cbuffer_.is_push_constant && context_.target.IsVulkan();
    info_.is_push_constant = is_pushed;
    const std::string place = is_pushed ? "push_constant"
                              : cbuffer_.declared
                                  ? Bind(context_, info_, *cbuffer_.declared)
                                  : Bind(context_, info_, cbuffer_.reg, bindings_, cbuffer_.count,
                                         context_.LaidBlock(info_.cbuffer));
    Append(text_, LayoutText({"std140", place, turned ? "row_major" : ""}), "uniform ", info_.name,
           is_pushed ? " {\n" : Concat(" {  // ", register_, "\n"));
    is_rows ? Rows() : Members();
  }

 private:
  void PlainUniforms() {
    Append(text_, "// ", cbuffer_.name, ", ", register_, "\n");
    for (const BlockMember& member : layout_.members) {
      if (context_.reached.Has(member.var)) PlainUniform(text_, member.var);
    }
    text_ += "\n";
  }

  // The qualifier of a member that another stage declares below `highp`, which a vertex shader has
  // by default; empty for other members.
  std::string_view PrecisionOf(VarId member, int field = -1) const {
    const bool is_struct = cbuffer_.kind == CbufferKind::kConstantBuffer && field < 0;
    if (!cbuffer_.declared || !context_.target.IsEs() || is_struct) return "";
    const auto at = std::ranges::find(cbuffer_.members, member, &CbufferMember::var);
    const auto number = static_cast<std::size_t>(field < 0 ? at - cbuffer_.members.begin() : field);
    const auto& members = cbuffer_.declared->members;
    if (number >= members.size() || members[number].precision == Precision::kHigh) return "";
    return members[number].precision == Precision::kLow ? "lowp " : "mediump ";
  }

  void PlainUniform(std::string& text, VarId member) {
    const std::string& name = context_.NameOf(member);
    const Var& var = context_[member];
    Append(text, "uniform ", PrecisionOf(member), UniformDeclaration(context_, var.type, name),
           ";\n");
    // Rows of HLSL are columns of GLSL, so a matrix that is row-major in HLSL needs no transposing.
    info_.members.push_back({member, -1, name, true, !var.row_major});
  }

  void Members() {
    info_.members.reserve(layout_.members.size());
    for (const BlockMember& member : layout_.members) Member(member);
    for (const ByHand& member : layout_.by_hand) {
      const BlockMember& part = layout_.members[member.part];
      // A struct without fields takes no room in any part.
      if (part.form != PartForm::kRows && part.var != member.var)
        Accessor(member.var, member.offset, member.offset, {}, false);
    }
    text_ += "}";
    if (layout_.has_instance) {
      const VarId var = layout_.members.front().var;
      const bool is_variable = layout_.fields_as_members;
      info_.instance =
          is_variable ? context_.NameOf(var) : context_.names.instances[info_.cbuffer.index];
      Append(text_, " ", info_.instance, is_variable ? Dimensions(context_, var) : "");
    }
    text_ += ";\n\n";
  }

  const std::string& NameOf(const BlockMember& member) const {
    if (member.field < 0) return context_.NameOf(member.var);
    const Type& type = context_[context_.types.Innermost(context_[member.var].type)];
    return context_.names.fields[type.structure.index][static_cast<std::size_t>(member.field)];
  }

  // A name that nothing else in the block has, for what is not a member in HLSL.
  std::string PartName(std::string name) {
    if (!layout_.has_instance) return context_.namer.Global(name);
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
    if (context_.IsWrittenAsUint(member.var)) {
      const Shape shape = ShapeOf(context_[member.type], context_.needs);
      AppendDeclaration(context_, text_, shape.With(Scalar::kUint), name);
    } else {
      AppendDeclaration(context_, text_, member.type, name);
    }
    AppendPart(text_, ";\n");
    info_.members.push_back({member.var, member.field, HostName(name)});
  }

  std::string HostName(const std::string& name) const {
    return layout_.has_instance ? Concat(info_.name, ".", name) : name;
  }
  // The text that reads what the block declares as `name`.
  std::string PathOf(const std::string& name) const {
    return layout_.has_instance ? Concat(context_.names.instances[info_.cbuffer.index], ".", name)
                                : name;
  }

  // Writes an array of rows, and the functions that read members out of it.
  void PartInRows(const BlockMember& part) {
    const std::string name = PartName(context_[part.var].name + "_rows");
    text_ += fmt::format("{} {}[{}];\n", part.float_rows ? "vec4" : "uvec4", name, part.rows);
    const Memory memory{PathOf(name), part.float_rows};
    for (const ByHand& member : layout_.by_hand) {
      if (&layout_.members[member.part] != &part) continue;
      info_.members.push_back(
          {member.var, -1, HostName(name), false, false, context_.NameOf(member.var), part.offset});
      Accessor(member.var, member.offset, part.offset, memory, false);
    }
  }

  // Writes a scalar for each component of a vector, and the function that reads the vector.
  void PartInWords(const BlockMember& part) {
    const Scalar kind = BaseOf(context_[part.type].scalar);
    const Shape scalar = ShapeOf(kind == Scalar::kBool ? Scalar::kUint : kind, 1, 1);
    const char* indent = "";  // the first is after its layout
    const std::string words = ListOf(context_[part.type].columns, [&](std::uint32_t i) {
      const std::string name =
          PartName(Concat(context_[part.var].name, "_", std::string_view("xyzw").substr(i, 1)));
      Append(text_, indent, TypeName(context_, scalar), " ", name, ";\n");
      indent = "    ";
      if (i == 0) {
        info_.members.push_back(
            {part.var, -1, HostName(name), false, false, context_.NameOf(part.var)});
      }
      return PathOf(name);
    });
    const std::string value = Called(TypeName(context_, part.type), {words}).text;
    Function(part.var, part.type, "", part.offset, value);
  }

  // Writes a buffer that neither std140 nor offsets can lay out: rows of 16 bytes, and a function
  // for each member that is read.
  void Rows() {
    info_.rows = context_.names.rows[info_.cbuffer.index];
    text_ += fmt::format("    {} {}[{}];\n}}", layout_.float_rows ? "vec4" : "uvec4", info_.rows,
                         std::max(cbuffer_.size / kRow, 1u));
    Memory memory{info_.rows, layout_.float_rows};
    const std::string dimensions = cbuffer_.kind == CbufferKind::kConstantBuffer
                                       ? Dimensions(context_, cbuffer_.members[0].var)
                                       : "";
    if (!dimensions.empty()) {
      info_.instance = context_.namer.Global(cbuffer_.name + "_buffers");
      Append(text_, " ", info_.instance, dimensions);
      memory.array = fmt::format("{}[{}].{}", info_.instance, Fresh(context_, "i"), info_.rows);
    }
    text_ += ";\n\n";
    for (const CbufferMember& member : cbuffer_.members) {
      if (context_.reached.Has(member.var))
        Accessor(member.var, member.offset, 0, memory, !dimensions.empty());
      info_.members.push_back({member.var, -1, context_.NameOf(member.var)});
    }
  }

  // Writes a buffer where the target has no blocks: an array of rows, up to the last one that is
  // read, to which the host gives the bytes of the buffer.
  void RowUniform() {
    info_.rows = context_.names.rows[info_.cbuffer.index];
    info_.name.clear();
    const Memory memory{info_.rows, true};
    std::string uniforms;
    std::uint32_t end = 0;
    for (const CbufferMember& member : cbuffer_.members) {
      const bool is_by_hand = context_.IsByHand(member.var);
      // The two stages of a pair declare the same rows.
      if (is_by_hand && context_.IsReadInProgram(member.var))
        end = std::max(end, member.offset + member.size);
      if (!context_.reached.Has(member.var)) continue;
      if (!is_by_hand) {
        PlainUniform(uniforms, member.var);
        continue;
      }
      Accessor(member.var, member.offset, 0, memory, false);
      info_.members.push_back({member.var, -1, context_.NameOf(member.var)});
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

  // Writes the function that reads the member at this offset, or one element of an array, from rows
  // that begin at `begin`. It is a macro where the target accepts only constants and the indices of
  // loops as indices, which a parameter is not.
  void Accessor(VarId member, std::uint32_t offset, std::uint32_t begin, const Memory& memory,
                bool is_buffer_array) {
    const Var& var = context_[member];
    const Type& type = context_[var.type];
    const bool is_array = type.kind == TypeKind::kArray;
    const TypeId result = is_array ? type.element : var.type;
    Address address{"", offset - begin};
    const bool is_macro = is_array && InfoOf(context_.program.stage).draws_pixels &&
                          !context_.Has(Feature::kFreeIndices);
    const std::string index = Fresh(context_, "i");
    if (is_array && !is_buffer_array) {
      address.dynamic = Scaled(ArrayStride(context_.types, var.type, var.row_major) / kRow,
                               is_macro ? Concat("(", index, ")") : index);
    }
    const std::string value = Load(context_, memory, result, var.row_major, address);
    if (is_macro && context_.reached.Has(member)) {
      context_.helpers += fmt::format("// offset {}\n#define {}({}) ({})\n\n", offset,
                                      context_.NameOf(member), index, value);
      return;
    }
    Function(member, result, is_array ? "int " + index : "", offset, value);
  }

  void Function(VarId member, TypeId result, const std::string& parameter, std::uint32_t offset,
                const std::string& value) {
    if (!context_.reached.Has(member)) return;  // the other stage of a pair reads it
    context_.helpers +=
        fmt::format("{} {}({}) {{  // offset {}\n    return {};\n}}\n\n",
                    TypeName(context_, result), context_.NameOf(member), parameter, offset, value);
  }

  WriterContext& context_;
  Bindings& bindings_;
  const Cbuffer& cbuffer_;
  const BlockLayout& layout_;
  GlslInfo::UniformBlock& info_;
  std::string& text_;
  std::string register_;
  std::unordered_set<std::string> part_names_;  // those in the block; filled for the first part
};

}  // namespace

UniformBlocks WriteBlocks(WriterContext& context) {
  UniformBlocks blocks;
  blocks.text.reserve(1024);
  blocks.info.reserve(context.program.cbuffers.size());
  Bindings bindings;
  const OtherStage* other = context.other;
  if (other && other->laid) {
    for (const GlslInfo::UniformBlock& block : other->laid->blocks) bindings.Take(block);
  }
  for (const CbufferId id : context.program.cbuffers.ids()) {
    if (context.reached.Has(id)) bindings.Reserve(context[id].reg, context[id].count);
  }
  for (const CbufferId id : context.program.cbuffers.ids()) {
    if (context.reached.Has(id)) BlockWriter(context, id, bindings, blocks).Write();
  }
  return blocks;
}

}  // namespace clipc::glsl
