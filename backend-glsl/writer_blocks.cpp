// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Constant buffers and the reading of their members.
#include <algorithm>
#include <ranges>
#include <variant>

#include "backend-glsl/writer.h"
#include "base/invariant.h"

namespace clipc::glsl {

using namespace ir;

namespace {

std::string RegisterText(const Register& reg) {
  std::string text = reg.letter + std::to_string(reg.number);
  if (reg.space != 0) text += ", space" + std::to_string(reg.space);
  return text;
}

}  // namespace

std::uint32_t VulkanBinding(const Register& reg, const Target& target) {
  for (const BindingShift& given : target.binding_shifts | std::views::reverse) {
    if (given.letter == reg.letter && given.space.value_or(reg.space) == reg.space)
      return reg.number + given.shift;
  }
  switch (reg.letter) {
    case 'b': return reg.number + kVulkanShiftB;
    case 's': return reg.number + kVulkanShiftS;
    case 'u': return reg.number + kVulkanShiftU;
    default: return reg.number + kVulkanShiftT;
  }
}

void Writer::Blocks() {
  for (CbufferId id : program_.cbuffers.ids()) {
    if (!reached_.Has(id)) continue;
    if (layouts_[id.index].form == BlockForm::kUniforms) {
      PlainUniforms(id);
    } else {
      Block(id);
    }
  }
}

void Writer::PlainUniforms(CbufferId id) {
  const BlockLayout& layout = layouts_[id.index];
  GlslInfo::Block& info = info_.blocks.emplace_back();
  info.cbuffer = id;
  info.form = layout.form;
  blocks_ +=
      "// " + program_.cbuffers[id].name + ", " + RegisterText(program_.cbuffers[id].reg) + "\n";
  for (const BlockMember& member : layout.members) {
    if (!reached_.Has(member.var)) continue;
    const std::string& name = var_names_[member.var.index];
    blocks_ += "uniform " + Declaration(member.type, name) + ";\n";
    // Memory that is row-major in HLSL is what GLSL's columns are.
    info.members.push_back({member.var, -1, name, !member.row_major});
  }
  blocks_ += "\n";
}

std::string Writer::BlockQualifiers(const Cbuffer& cbuffer, const BlockLayout& layout,
                                    GlslInfo::Block& info) {
  std::string text = "std140";
  if (target_.IsVulkan()) {
    info.set = cbuffer.reg.space;
    info.binding = VulkanBinding(cbuffer.reg, target_);
    text += ", set = " + std::to_string(*info.set);
  } else if (target_.Has(Feature::kBindings)) {
    info.binding = FreeBinding(uniform_bindings_, cbuffer.reg.number, cbuffer.count);
  }
  if (info.binding) text += ", binding = " + std::to_string(*info.binding);
  if (layout.matrices == MatrixLayout::kRowMajor && layout.form == BlockForm::kStd140)
    text += ", row_major";
  return "layout(" + text + ")";
}

// "[4]" of `ConstantBuffer<T> cb[4]`.
std::string Writer::Dimensions(VarId var) const {
  std::string dimensions;
  for (TypeId id = program_.vars[var].type; program_.types[id].kind == TypeKind::kArray;
       id = program_.types[id].element) {
    dimensions += "[" + std::to_string(program_.types[id].count) + "]";
  }
  return dimensions;
}

void Writer::Block(CbufferId id) {
  const Cbuffer& cbuffer = program_.cbuffers[id];
  const BlockLayout& layout = layouts_[id.index];
  GlslInfo::Block info;
  info.cbuffer = id;
  info.form = layout.form;
  info.name = block_names_[id.index];
  blocks_ += BlockQualifiers(cbuffer, layout, info) + " uniform " + info.name + " {  // " +
             RegisterText(cbuffer.reg) + "\n";
  if (layout.form == BlockForm::kRows) {
    RowsBlock(id, info);
  } else {
    BlockMembers(layout, info);
    const VarId var = layout.members.empty() ? VarId{} : layout.members.front().var;
    if (layout.fields_as_members) info.instance = var_names_[var.index];
    blocks_ +=
        "}" + (layout.fields_as_members ? " " + info.instance + Dimensions(var) : "") + ";\n\n";
  }
  info_.blocks.push_back(std::move(info));
}

void Writer::BlockMembers(const BlockLayout& layout, GlslInfo::Block& info) {
  info.members.reserve(layout.members.size());
  std::uint32_t end = 0;
  const auto pad = [&](std::string_view type, std::uint32_t bytes, std::uint32_t count) {
    const std::string name = layout.fields_as_members
                                 ? "padding_" + std::to_string(end)
                                 : namer_.Global("padding_" + std::to_string(end));
    blocks_ += "    " + std::string(type) + " " + name +
               (count > 1 ? "[" + std::to_string(count) + "]" : "") + ";\n";
    end += bytes * count;
  };
  for (const BlockMember& member : layout.members) {
    // Single floats up to a row, rows, and single floats again: none of them is moved by std140.
    for (end = member.offset - member.padding; end < member.offset;) {
      const std::uint32_t rows = end % 16 == 0 ? (member.offset - end) / 16 : 0;
      rows > 0 ? pad("vec4", 16, rows) : pad("float", 4, 1);
    }
    const bool is_field = member.field >= 0;
    TypeId structure = program_.vars[member.var].type;
    while (is_field && program_.types[structure].kind == TypeKind::kArray)
      structure = program_.types[structure].element;
    const std::string name = is_field ? FieldName(program_.types[structure].structure,
                                                  static_cast<std::uint32_t>(member.field))
                                      : var_names_[member.var.index];
    std::string qualifiers;
    if (member.explicit_offset) qualifiers = "offset = " + std::to_string(member.offset);
    if (layout.matrices == MatrixLayout::kNone && member.matrices == MatrixLayout::kRowMajor) {
      qualifiers += qualifiers.empty() ? "row_major" : ", row_major";
    }
    if (!qualifiers.empty()) qualifiers = "layout(" + qualifiers + ") ";
    Append(blocks_, "    ", qualifiers, Declaration(member.type, name), ";\n");
    info.members.push_back(
        {member.var, member.field, is_field ? info.name + "." + name : name, false});
  }
}

// A buffer that neither std140 nor offsets can say: rows of 16 bytes, and a function for each
// member that is read.
void Writer::RowsBlock(CbufferId id, GlslInfo::Block& info) {
  const Cbuffer& cbuffer = program_.cbuffers[id];
  const BlockLayout& layout = layouts_[id.index];
  const std::string& rows = rows_names_[id.index];
  const std::string count = std::to_string(std::max(cbuffer.size / 16, 1u));
  info.rows = rows;
  blocks_ +=
      std::string("    ") + (layout.float_rows ? "vec4 " : "uvec4 ") + rows + "[" + count + "];\n}";
  Memory memory{rows, true, layout.float_rows};
  const bool is_array =
      cbuffer.kind == CbufferKind::kConstantBuffer && !Dimensions(cbuffer.members[0].var).empty();
  if (is_array) {
    info.instance = namer_.Global(cbuffer.name + "_buffers");
    blocks_ += " " + info.instance + Dimensions(cbuffer.members[0].var);
    memory.array = info.instance + "[" + Fresh("i") + "]." + rows;
  }
  blocks_ += ";\n\n";
  for (const CbufferMember& member : cbuffer.members) {
    if (reached_.Has(member.var)) Accessor(member, memory, is_array);
    info.members.push_back({member.var, -1, var_names_[member.var.index], false});
  }
}

void Writer::Accessor(const CbufferMember& member, const Memory& memory, bool is_buffer_array) {
  const Var& var = program_.vars[member.var];
  const Type& type = program_.types[var.type];
  const bool is_array = type.kind == TypeKind::kArray;
  const TypeId result = is_array ? type.element : var.type;
  Address address{"", member.offset};
  const std::string index = Fresh("i");
  if (is_array && !is_buffer_array) {
    const std::uint32_t stride = StrideOf(memory, var.type, var.row_major) / 16;
    address.dynamic = stride == 1 ? index : std::to_string(stride) + " * " + index;
  }
  const std::string value = Load(memory, result, var.row_major, address);
  helpers_ += TypeName(result) + " " + var_names_[member.var.index] +
              (is_array ? "(int " + index + ") {" : "() {") + "  // offset " +
              std::to_string(member.offset) + "\n    return " + value + ";\n}\n\n";
}

Text Writer::UniformText(VarId id) {
  NotConstant();
  const Var& var = program_.vars[id];
  const std::string& name = var_names_[id.index];
  if (layouts_[var.cbuffer.index].form != BlockForm::kRows) return {name};
  const Type& type = program_.types[var.type];
  if (type.kind != TypeKind::kArray) return {name + "()"};
  const std::string all = Helper(name + "_all", "", [&](const std::string& function) {
    const auto element = [&](const std::string& index) {
      return ElementText(type.element, {name + "(" + index + ")"});
    };
    return TypeName(var.type) + " " + function + "() {\n" + FilledArray(var.type, element) + "}\n";
  });
  return {all + "()"};
}

// One element of an array in a constant buffer.
Text Writer::UniformElement(VarId id, ExprId index) {
  const Var& var = program_.vars[id];
  const std::string& name = var_names_[id.index];
  std::string text = IndexValue(index);
  if (layouts_[var.cbuffer.index].form == BlockForm::kRows) {
    NotConstant();
    const bool is_int = TypeOf(index).scalar == Scalar::kInt ||
                        std::holds_alternative<Literal>(program_.exprs[index].node);
    return {name + (is_int ? "(" + text + ")" : "(int(" + text + "))")};
  }
  NotConstant();
  const TypeId element = program_.types[var.type].element;
  return {name + "[" + text + "]" + (IsWrapped(element) ? ".e" : "")};
}

// The ConstantBuffer<T> variable that `expr` is an element of, and the indices that lead there,
// outermost first.
VarId Writer::InstanceOf(ExprId expr, std::vector<ExprId>& indices) const {
  const auto& node = program_.exprs[expr].node;
  if (const auto* index = std::get_if<Index>(&node)) {
    if (TypeOf(index->base).kind != TypeKind::kArray) return {};
    const VarId var = InstanceOf(index->base, indices);
    indices.push_back(index->index);
    return var;
  }
  const auto* ref = std::get_if<VarRef>(&node);
  if (!ref || program_.vars[ref->var].storage != Storage::kUniform) return {};
  return layouts_[program_.vars[ref->var].cbuffer.index].fields_as_members ? ref->var : VarId{};
}

std::optional<std::string> Writer::InstancePath(ExprId expr) {
  if (TypeOf(expr).kind != TypeKind::kStruct) return std::nullopt;
  std::vector<ExprId> indices;
  const VarId var = InstanceOf(expr, indices);
  if (!var) return std::nullopt;
  NotConstant();
  std::string path = var_names_[var.index];
  for (ExprId index : indices) path += "[" + IndexValue(index) + "]";
  return path;
}

// The whole T of a ConstantBuffer<T>, put together from the block's members.
Text Writer::InstanceValue(ExprId expr, const std::string& path) {
  const TypeId type = program_.exprs[expr].type;
  const StructId structure = program_.types[type].structure;
  const auto value = [&](const std::string& block) {
    std::string text = TypeName(type) + "(";
    for (std::uint32_t i = 0; i < program_.types[structure].fields.size(); ++i) {
      text += (i > 0 ? ", " : "") + block + "." + FieldName(structure, i);
    }
    return text + ")";
  };
  std::vector<ExprId> indices;
  const VarId var = InstanceOf(expr, indices);
  const bool is_constant = std::ranges::all_of(indices, [&](ExprId index) {
    return std::holds_alternative<Literal>(program_.exprs[index].node);
  });
  if (is_constant && !indices.empty()) return {value(path)};

  const std::string& name = var_names_[var.index];
  std::string parameters, arguments, block = name;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const std::string parameter = Fresh(std::string(1, static_cast<char>('i' + i)));
    parameters += (i > 0 ? ", int " : "int ") + parameter;
    arguments += (i > 0 ? ", int(" : "int(") + IndexValue(indices[i]) + ")";
    block += "[" + parameter + "]";
  }
  const std::string helper = Helper(name + "_value", "", [&](const std::string& function) {
    return TypeName(type) + " " + function + "(" + parameters + ") {\n    return " + value(block) +
           ";\n}\n";
  });
  return {helper + "(" + arguments + ")"};
}

}  // namespace clipc::glsl
