// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "base/invariant.h"
#include "frontend/typing/conversion.h"
#include "ir/builder.h"
#include "ir/print.h"
#include "ir/program.h"
#include "ir/verify.h"

namespace clipc::typing {

// A program for tests with a few variables, and the messages about expressions made of them.
class ProgramForTest final : public TemporaryMaker {
 public:
  ir::Program program;
  Diagnostics diagnostics;

  ir::Builder Make() { return ir::Builder(program); }

  // The numeric type with the name `text`: "float4x3", "min16uint2", "bool".
  ir::TypeId Type(std::string_view text) {
    for (int kind = 0; kind <= static_cast<int>(ir::Scalar::kUint64); ++kind) {
      const auto scalar = static_cast<ir::Scalar>(kind);
      const std::string_view name = ir::NameOf(scalar);
      if (!text.starts_with(name)) continue;
      const std::string_view shape = text.substr(name.size());
      if (shape.empty()) return program.types.Make(scalar);
      if (shape.size() == 1) return program.types.Vector(scalar, shape[0] - '0');
      if (shape.size() == 3 && shape[1] == 'x')
        return program.types.Matrix(scalar, shape[0] - '0', shape[2] - '0');
    }
    CLIPC_CHECK(!"a numeric type");
    return {};
  }
  ir::TypeId Struct(std::string name, const std::vector<ir::TypeId>& fields) {
    ir::Struct structure;
    structure.name = std::move(name);
    for (std::size_t i = 0; i < fields.size(); ++i) {
      ir::Field field;
      field.name = std::string(1, static_cast<char>('p' + i));
      field.type = fields[i];
      structure.fields.push_back(field);
    }
    return program.types.Of(program.types.AddStruct(structure));
  }

  ir::ExprId Var(std::string name, ir::TypeId type) {
    const ir::VarId var = Make().Local(std::move(name), type);
    locals_.push_back(var);
    return Make().Ref(var);
  }
  ir::ExprId Var(std::string name, std::string_view type) {
    return Var(std::move(name), Type(type));
  }
  ir::ExprId Object(std::string name, ir::ObjectKind kind, ir::TypeId element = {}) {
    const ir::ExprId object = Var(std::move(name), program.types.Object(kind, element));
    program.vars[locals_.back()].storage = ir::Storage::kResource;
    locals_.pop_back();
    return object;
  }
  ir::VarId Constant(std::string name, ir::ExprId value) {
    const ir::VarId var = Make().Local(std::move(name), program.exprs[value].type);
    program.vars[var].storage = ir::Storage::kConstant;
    program.vars[var].init = value;
    return var;
  }

  Temporary Make(ir::ExprId value) override {
    const ir::VarId var =
        Make().Local("t" + std::to_string(++temporaries_), program.exprs[value].type);
    locals_.push_back(var);
    return {var, Make().AssignTo(Make().Ref(var), value)};
  }

  // Returns "type: expression", or the messages if the expression is an error.
  std::string Text(ir::ExprId expr) {
    const ir::TypeId type = program.exprs[expr].type;
    if (type == program.types.Error()) return Said();
    return program.types.Name(type) + ": " + ir::PrintExpr(program, expr);
  }
  // Returns all messages with their suffixes, joined by " | ", and forgets them.
  std::string Said() {
    std::string text;
    for (const Diagnostic& each : diagnostics.all()) {
      if (!text.empty()) text += " | ";
      text += each.message + MessageSuffix(each);
    }
    diagnostics = Diagnostics();
    return text;
  }
  // Returns the fault that Verify finds in a function that evaluates `expr`, or an empty text. Uses
  // the program up.
  std::string Broken(ir::ExprId expr) {
    std::vector<ir::StmtId> body;
    for (const ir::VarId local : locals_) body.push_back(Make().Stmt(ir::Declare{local, {}}));
    body.push_back(Make().Eval(expr));
    AddFunction(program.entry, "entry", body);
    const std::vector<ir::StmtId> call = {Make().Eval(Make().CallOf(program.entry, {}))};
    AddFunction(program.main, "main", call);
    return ir::Verify(program, ir::Form::kTyped).value_or("");
  }

 private:
  void AddFunction(ir::FunctionId& id, std::string name, const std::vector<ir::StmtId>& body) {
    ir::Function function;
    function.name = std::move(name);
    function.return_type = program.types.Void();
    function.body = Make().BlockOf(body);
    id = program.functions.Add(std::move(function));
  }

  std::vector<ir::VarId> locals_;
  int temporaries_ = 0;
};

}  // namespace clipc::typing
