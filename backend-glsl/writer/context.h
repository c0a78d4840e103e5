// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <algorithm>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "backend-glsl/block_layout.h"
#include "backend-glsl/descriptors.h"
#include "backend-glsl/glsl_info.h"
#include "backend-glsl/names.h"
#include "backend-glsl/packed_stage.h"
#include "backend-glsl/reach.h"
#include "backend-glsl/target.h"
#include "backend-glsl/write_options.h"
#include "ir/access.h"
#include "ir/program.h"
#include "legalize/shape.h"

namespace clipc::glsl {

using legalize::Shape;
using legalize::ShapeOf;

// A texture and the sampler that it is read with, none for reads without a sampler.
struct TextureUse {
  ir::VarId texture, sampler;
  std::string name;  // of the one GLSL variable in place of both
};

// The names in the shader.
struct Names {
  // The text in place of a variable: its name, or a built-in variable of GLSL, converted. Local
  // variables are named when they are declared.
  std::vector<std::string> vars;        // by VarId
  std::vector<std::string> attributes;  // beside Program::inputs; empty: built in
  // Beside Program::outputs, in a stage that makes patches: the arrays of all control points.
  std::vector<std::string> outputs;
  std::vector<std::string> functions;  // by FunctionId
  std::vector<std::string> structs;    // by StructId
  std::vector<std::string> blocks;     // by CbufferId
  std::vector<std::string> instances;  // by CbufferId; empty: members are global
  std::vector<std::string> rows;       // by CbufferId
  // By CbufferId: what fills the room before members, in the order of ForEachPadding.
  std::vector<std::vector<std::string>> paddings;
  std::vector<std::string> groups;  // the instances of Program::output_groups; may be empty
  std::string framebuffer_height;   // of the uniform; empty: the shader does not need it
};

// The state that all subjects of the writer share. A subject is a header of free functions over it,
// or over Code (code.h), which adds the state of expressions and statements.
struct WriterContext {
  // The arguments outlive the context. `packed` keeps its program only.
  WriterContext(PackedStage& packed, const Target& target, const WriteOptions& options,
                OtherStages others);

  const ir::Program& program;
  const ir::TypeTable& types;  // of the program
  const Target& target;
  const legalize::Needs needs;  // of the target
  const WriteOptions& options;
  const OtherStages others;
  const Reached reached;
  const Descriptors descriptors;           // of a Vulkan target
  const std::vector<BlockLayout> layouts;  // by CbufferId, of the reached ones
  // By VarId: the functions that read members of blocks, or elements of such, by hand.
  const std::vector<ir::FunctionId> readers;
  Names names;
  std::vector<TextureUse> texture_uses;  // of global objects; none for Vulkan
  bool has_order = false;                // an object is accessed in the order of the primitives
  bool has_upper_left_origin = false;    // gl_FragCoord is declared anew with that origin

  // The parts of the shader that come into being where they are first needed.
  Namer namer;
  std::string structs, helpers;      // definitions
  std::set<std::string> extensions;  // extensions that the shader requires
  std::set<std::string> enabled;     // extensions that only some compilers need
  std::vector<bool> used_structs;    // by StructId: those in `structs`
  std::vector<bool> buffer_structs;  // by StructId: those of buffers; empty: not asked for yet
  std::unordered_map<std::string, std::string> wrappers;      // types.h: by the wrapped type
  std::unordered_map<std::string, std::string> helper_names;  // helper.h: by the wanted name
  std::set<std::string> helper_keys;                          // name and key of those in `helpers`

  const ir::Expr& operator[](ir::ExprId id) const { return program.exprs[id]; }
  const ir::Var& operator[](ir::VarId id) const { return program.vars[id]; }
  const ir::Function& operator[](ir::FunctionId id) const { return program.functions[id]; }
  const ir::Cbuffer& operator[](ir::CbufferId id) const { return program.cbuffers[id]; }
  const ir::Type& operator[](ir::TypeId id) const { return types[id]; }
  // The operand of a call of an object; none where it has none.
  ir::ExprId Operand(const ir::ObjectCall& call, ir::OperandKind kind) const {
    return OperandOf(program, call, kind);
  }
  std::span<const ir::ExprId> operator[](List<ir::ExprId> list) const {
    return program.expr_lists[list];
  }
  std::span<const ir::StmtId> operator[](List<ir::StmtId> list) const {
    return program.stmt_lists[list];
  }
  // The node of an id if it is a `Node`; otherwise null.
  template <typename Node>
  const Node* As(auto id) const {
    return ir::As<Node>(program, id);
  }

  const ir::Type& TypeOf(ir::ExprId id) const { return types[program.exprs[id].type]; }
  const ir::Type& TypeOf(ir::VarId id) const { return types[program.vars[id].type]; }
  Shape ShapeAt(auto id) const { return ShapeOf(TypeOf(id), needs); }
  const BlockLayout& LayoutOf(ir::VarId member) const {
    return layouts[program.vars[member].cbuffer.index];
  }
  // Whether a member is read by a function.
  bool IsByHand(ir::VarId member) const { return bool(readers[member.index]); }
  // Whether a member of a block is a bool, or a vector of them, that is written as a uint.
  bool IsWrittenAsUint(ir::VarId member) const;
  const std::string& NameOf(ir::VarId id) const { return names.vars[id.index]; }
  const std::string& NameOf(const BlockMember& member) const;

  // Whether another stage has the block too.
  bool IsShared(ir::CbufferId id) const {
    return std::ranges::any_of(
        others, [&](const OtherStage& other) { return bool(other.cbuffers[id.index]); });
  }
  // Whether any stage reads the member.
  bool IsReadInProgram(ir::VarId member) const {
    return reached.Has(member) || std::ranges::any_of(others, [&](const OtherStage& other) {
             return other.is_read[member.index];
           });
  }
  // The block as a stage has it that is laid out before; null if it is not shared, or is laid out
  // here first.
  const GlslInfo::UniformBlock* LaidBlock(ir::CbufferId id) const;
  // The same for an object: the one of this texture with this sampler, either of which may be none.
  const GlslInfo::Object* LaidObject(ir::VarId texture, ir::VarId sampler) const;

  bool Has(Feature feature) const { return target.Has(feature); }
  // Adds the extension through which the target has the feature, if there is one.
  void Require(Feature feature) { Require(target.Of(feature).extension); }
  void Require(std::string_view extension) {
    if (!extension.empty()) extensions.emplace(extension);
  }
  // Adds the extension that a `double` or a 64-bit integer needs, if the type is one.
  void RequireType(const ir::Type& type) {
    if (ir::IsWide(type.scalar)) RequireWide(type);
  }
  void RequireWide(const ir::Type& type);
  // The names of the fields of a struct, which are made when they are first asked for: a shader
  // needs those of few structs.
  std::vector<std::string>& FieldsOf(ir::StructId id) const;

 private:
  mutable std::vector<std::vector<std::string>> fields_;  // by StructId
};

// The rows of a buffer up to the last that any stage reads, where the target has no blocks. All
// stages declare the same rows.
std::uint32_t RowsRead(const WriterContext& context, const ir::Cbuffer& cbuffer);

}  // namespace clipc::glsl
