// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <bit>
#include <string>
#include <utility>
#include <vector>

#include "ir/access.h"
#include "ir/builder.h"
#include "ir/evaluate.h"
#include "ir/evaluate_machine.h"
#include "ir/packing.h"
#include "ir/scalar.h"

// A program and an evaluation for tests only.
namespace clipc::ir {

// The value of an expression outside of all functions, component after component.
inline std::vector<std::uint64_t> ValueOf(const Program& program, ExprId expr) {
  const EvalInputs inputs;
  const EvalOptions options;
  return Machine(program, inputs, options).Value(expr);
}

// A small whole program, into which a test puts what it is about:
//
//   cbuffer Camera { float4x4 view; float4 planes[2]; float scale; }
//   static float counter = 1; static const float table[3] = {10, 20, 30};
//   float4 entry(float4 p) { <body>; return result; }
//   void main() { gl_Position = entry(position); }
class TestProgram : public Program {
 public:
  TestProgram() {
    position =
        AddIo(inputs, "position", types.Vector(Scalar::kFloat, 4), Builtin::kNone, "POSITION");
    gl_position = AddIo(outputs, "gl_Position", types.Vector(Scalar::kFloat, 4), Builtin::kPosition,
                        "SV_Position");
    AddCamera();
    counter = AddVar("counter", types.Make(Scalar::kFloat), Storage::kStatic, build.Float(1));
    const TypeId three = types.Array(types.Make(Scalar::kFloat), 3);
    table = AddVar("table", three, Storage::kConstant,
                   build.ConstructOf(three, {build.Float(10), build.Float(20), build.Float(30)}));
    globals = {counter, table};
    parameter = AddVar("p", types.Vector(Scalar::kFloat, 4), Storage::kIn);
    entry = AddFunction("entry", types.Vector(Scalar::kFloat, 4), {parameter}, {});
    const ExprId argument = build.Ref(position);
    const ExprId call = build.CallOf(entry, std::span(&argument, 1));
    main = AddFunction("main", types.Void(), {},
                       {build.Eval(build.AssignTo(build.Ref(gl_position), call))});
  }

  VarId AddVar(std::string name, TypeId type, Storage storage, ExprId init = {}) {
    const VarId id = build.Local(std::move(name), type);
    vars[id].storage = storage;
    vars[id].init = init;
    return id;
  }
  FunctionId AddFunction(std::string name, TypeId type, std::vector<VarId> parameters,
                         std::vector<StmtId> body) {
    const StmtId block = build.BlockOf(body);
    return functions.Add({.name = std::move(name),
                          .return_type = type,
                          .parameters = std::move(parameters),
                          .body = block,
                          .span = {}});
  }
  void Append(std::vector<StmtId> stmts) { AppendToBody(*this, entry, stmts); }
  StmtId Return(ExprId value) { return build.Stmt(ir::Return{value}); }
  StmtId DeclareVar(VarId var, ExprId init = {}) { return build.Stmt(Declare{var, init}); }
  List<StmtId> Stmts(std::vector<StmtId> list) {
    return stmt_lists.Add(std::span<const StmtId>(list));
  }
  ExprId Splat4(ExprId scalar) { return build.SplatTo(types.Vector(Scalar::kFloat, 4), scalar); }

  // The components of gl_Position for the input `p`; empty after an error.
  std::vector<double> Run(const std::vector<float>& p, EvalOptions options = {}) {
    EvalInputs eval;
    IoBits bits{};
    for (std::size_t i = 0; i < p.size(); ++i) bits[i] = BitsOf(p[i]);
    eval.values.push_back(bits);
    eval.cbuffers.push_back(camera_bytes);
    eval.read_object = read_object;
    const EvalResult result = RunMain(*this, eval, options);
    error = result.error;
    if (!result) return {};
    const IoNumbers& numbers = result.outputs.numbers[0];
    return {numbers.begin(), numbers.begin() + 4};
  }
  void SetFloat(std::size_t offset, float value) {
    if (camera_bytes.size() < offset + 4) camera_bytes.resize(offset + 4);
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (int i = 0; i < 4; ++i)
      camera_bytes[offset + i] = static_cast<std::uint8_t>(bits >> (8 * i));
  }

  Builder build{*this};
  VarId position, gl_position, parameter, counter, table, view, planes, scale;
  CbufferId camera;
  std::vector<std::uint8_t> camera_bytes;
  std::function<void(const ObjectRequest&, std::span<std::uint64_t>)> read_object;
  std::string error;

 private:
  VarId AddIo(IoVars& list, std::string name, TypeId type, Builtin builtin, std::string semantic) {
    IoVar io;
    io.var = AddVar(std::move(name), type, &list == &inputs ? Storage::kInput : Storage::kOutput);
    io.builtin = builtin;
    io.semantic = std::move(semantic);
    list.push_back(io);
    return io.var;
  }
  void AddCamera() {
    Cbuffer buffer;
    buffer.name = "Camera";
    camera = cbuffers.Add(std::move(buffer));
    view = AddVar("view", types.Matrix(Scalar::kFloat, 4, 4), Storage::kUniform);
    planes = AddVar("planes", types.Array(types.Vector(Scalar::kFloat, 4), 2), Storage::kUniform);
    scale = AddVar("scale", types.Make(Scalar::kFloat), Storage::kUniform);
    for (VarId var : {view, planes, scale}) {
      vars[var].cbuffer = camera;
      CbufferMember member;
      member.var = var;
      cbuffers[camera].members.push_back(member);
    }
    LayOut(types, vars, cbuffers[camera]);
  }
};

}  // namespace clipc::ir
