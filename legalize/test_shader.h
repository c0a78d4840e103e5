// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/invariant.h"
#include "ir/builder.h"
#include "ir/packing.h"
#include "ir/program.h"
#include "ir/verify.h"

namespace clipc::legalize {

// A shader for tests, whose entry adds up expressions and returns the sum.
class TestShader {
 public:
  ir::Program program;

  TestShader() {
    ir::Builder b(program);
    float_ = program.types.Make(ir::Scalar::kFloat);
    float4_ = program.types.Vector(ir::Scalar::kFloat, 4);
    sum_ = b.Local("sum", float_);
    statements_.push_back(b.Stmt(ir::Declare{sum_, b.Float(0)}));
  }

  ir::Builder Make() { return ir::Builder(program); }
  ir::TypeId Vector(ir::Scalar kind, int n) {
    return n == 1 ? program.types.Make(kind) : program.types.Vector(kind, n);
  }

  // A member of a cbuffer that AddCbuffer adds.
  struct NewMember {
    std::string name;
    ir::TypeId type;
    bool row_major = false;
    std::optional<std::uint32_t> packoffset = {};
  };
  // Adds a cbuffer b<n> with these members, laid out by HLSL's rules.
  ir::CbufferId AddCbuffer(std::string name, const std::vector<NewMember>& members,
                           ir::CbufferKind kind = ir::CbufferKind::kCbuffer) {
    ir::Cbuffer cbuffer;
    cbuffer.name = std::move(name);
    cbuffer.kind = kind;
    cbuffer.reg = {'b', program.cbuffers.size(), 0, true};
    const ir::CbufferId id{program.cbuffers.size()};
    for (const NewMember& member : members) {
      ir::Var var;
      var.name = member.name;
      var.type = member.type;
      var.storage = ir::Storage::kUniform;
      var.cbuffer = id;
      var.row_major = member.row_major;
      ir::CbufferMember placed;
      placed.var = program.vars.Add(var);
      placed.offset = member.packoffset.value_or(0);
      placed.has_packoffset = member.packoffset.has_value();
      cbuffer.members.push_back(placed);
      if (kind == ir::CbufferKind::kConstantBuffer) {
        for (ir::TypeId type = member.type; program.types[type].kind == ir::TypeKind::kArray;
             type = program.types[type].element) {
          cbuffer.count *= program.types[type].count;
        }
      }
    }
    ir::LayOut(program.types, program.vars, cbuffer);
    return program.cbuffers.Add(cbuffer);
  }

  ir::VarId AddResource(std::string name, ir::TypeId type, char letter, std::uint32_t number) {
    ir::Var var;
    var.name = std::move(name);
    var.type = type;
    var.storage = ir::Storage::kResource;
    const ir::VarId id = program.vars.Add(var);
    program.resources.push_back({id, {letter, number, 0, true}});
    return id;
  }

  // Adds the components of `value`, converted to float, to the sum.
  void Use(ir::ExprId value) {
    ir::Builder b = Make();
    const ir::Type type = program.types[b.TypeOf(value)];
    if (type.Components() == 1 || type.kind == ir::TypeKind::kScalar) {
      if (type.kind == ir::TypeKind::kMatrix) value = b.At(b.At(value, 0u), 0u);
      if (type.kind == ir::TypeKind::kVector) value = b.Swizzled(value, {0});
      value = b.ConvertTo(ir::Scalar::kFloat, value);
      statements_.push_back(b.Eval(b.AssignTo(b.Ref(sum_), value, ir::BinaryOp::kAdd)));
      return;
    }
    const ir::VarId local = b.Local("value", b.TypeOf(value));
    statements_.push_back(b.Stmt(ir::Declare{local, value}));
    const int rows = type.kind == ir::TypeKind::kMatrix ? type.rows : 1;
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < type.columns; ++column) {
        ir::ExprId part = b.Ref(local);
        if (type.kind == ir::TypeKind::kMatrix) part = b.At(part, static_cast<std::uint32_t>(row));
        Use(b.Swizzled(part, {column}));
      }
    }
  }

  void Add(ir::StmtId stmt) { statements_.push_back(stmt); }

  // Adds the entry and main; call once, last.
  void Finish() {
    ir::Builder b = Make();
    statements_.push_back(b.Stmt(ir::Return{b.SplatTo(float4_, b.Ref(sum_))}));
    program.entry = program.functions.Add({"main", float4_, {}, b.BlockOf(statements_), {}});
    ir::Var position;
    position.name = "position";
    position.type = float4_;
    position.storage = ir::Storage::kOutput;
    ir::IoVar output;
    output.var = program.vars.Add(position);
    output.semantic = "SV_Position";
    output.builtin = ir::Builtin::kPosition;
    program.outputs.push_back(output);
    const ir::StmtId write = b.Eval(b.AssignTo(b.Ref(output.var), b.CallOf(program.entry, {})));
    program.main =
        program.functions.Add({"main", program.types.Void(), {}, b.BlockOf({&write, 1}), {}});
    const auto broken = ir::Verify(program, ir::Form::kTyped);
    if (broken) std::fprintf(stderr, "%s\n", broken->c_str());
    CLIPC_CHECK(!broken);
  }

 private:
  ir::TypeId float_, float4_;
  ir::VarId sum_;
  std::vector<ir::StmtId> statements_;
};

}  // namespace clipc::legalize
