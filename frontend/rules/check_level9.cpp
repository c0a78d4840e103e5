// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/check_level9.h"

#include <optional>
#include <string_view>
#include <vector>

#include "frontend/rules/constant.h"
#include "ir/walk.h"

namespace clipc {
namespace {

// Shader model 2 through 10Level9. Sources: "vs_2_0" register tables of the Direct3D 9 reference;
// the "runtime generated constant mappings" that fxc prints for 9_x targets take one float constant
// for the half-pixel position offset.
constexpr std::size_t kMaxInputs = 16;
constexpr std::size_t kMaxOutputs = 8;                // texture coordinate registers oT0..oT7
constexpr std::uint32_t kMaxConstantRegisters = 255;  // c0..c255 less the position offset
constexpr std::uint32_t kMaxInstructions = 256;

class Level9Checker {
 public:
  Level9Checker(const ir::Program& program, Diagnostics& diagnostics)
      : program_(program), diagnostics_(diagnostics) {}

  void Run() {
    CheckInterface();
    CheckConstants();
    for (ir::FunctionId id : program_.functions.ids()) {
      CheckStmt(program_.functions[id].body);
    }
    if (instructions_ > kMaxInstructions) {
      diagnostics_.Report(program_.functions[program_.entry].span, diag::Level9Instructions,
                          instructions_, kMaxInstructions, Target());
    }
  }

 private:
  std::string_view Target() const { return program_.profile.name; }

  void CheckInterface() {
    std::size_t inputs = 0, outputs = 0;
    for (const ir::IoVar& input : program_.inputs) {
      inputs += input.builtin == ir::Builtin::kNone;
      if (input.builtin == ir::Builtin::kNone) continue;
      diagnostics_.Report(program_.vars[input.var].span, diag::Level9SystemValue, input.semantic,
                          Target());
    }
    for (const ir::IoVar& output : program_.outputs) {
      outputs += output.builtin == ir::Builtin::kNone;
      if (output.builtin == ir::Builtin::kClipDistance ||
          output.builtin == ir::Builtin::kCullDistance) {
        diagnostics_.Report(program_.vars[output.var].span, diag::Level9ClipDistance,
                            output.semantic, Target());
      } else if (output.builtin != ir::Builtin::kNone && output.builtin != ir::Builtin::kPosition) {
        diagnostics_.Report(program_.vars[output.var].span, diag::Level9SystemValue,
                            output.semantic, Target());
      }
    }
    const Span span = program_.functions[program_.entry].span;
    if (inputs > kMaxInputs)
      diagnostics_.Report(span, diag::Level9Inputs, inputs, kMaxInputs, Target());
    if (outputs > kMaxOutputs)
      diagnostics_.Report(span, diag::Level9Outputs, outputs, kMaxOutputs, Target());
  }

  void CheckConstants() {
    std::uint32_t registers = 0;
    for (ir::CbufferId id : program_.cbuffers.ids()) {
      const ir::Cbuffer& buffer = program_.cbuffers[id];
      if (buffer.kind == ir::CbufferKind::kTbuffer)
        diagnostics_.Report(buffer.span, diag::Level9Tbuffer, buffer.name, Target());
      registers += (buffer.size + 15) / 16 * buffer.count;
    }
    if (registers > kMaxConstantRegisters) {
      diagnostics_.Report(program_.functions[program_.entry].span, diag::Level9Constants, registers,
                          kMaxConstantRegisters, Target());
    }
  }

  void CheckStmt(ir::StmtId id) {
    ir::ForEachPart(
        program_, id, [&](ir::ExprId expr) { CheckExpr(expr); },
        [&](ir::StmtId stmt) { CheckStmt(stmt); });
  }

  void CheckExpr(ir::ExprId id) {
    const ir::Expr& expr = program_.exprs[id];
    std::visit(Overloaded{[&](const ir::Binary& binary) { CheckOperator(binary.op, expr.span); },
                          [&](const ir::Assign& assign) {
                            if (assign.op) CheckOperator(*assign.op, expr.span);
                          },
                          [&](const ir::Unary& unary) {
                            if (unary.op == ir::UnaryOp::kComplement) ReportBits(expr.span);
                          },
                          [&](const ir::IntrinsicCall& call) { CheckIntrinsic(call, expr.span); },
                          [&](const ir::ObjectCall&) {
                            diagnostics_.Report(expr.span, diag::Level9Texture, Target());
                          },
                          [&](const ir::Index& index) { CheckIndex(index, expr.span); },
                          [](const auto&) {}},
               expr.node);
    ir::ForEachOperand(program_, id, [&](ir::ExprId operand) { CheckExpr(operand); });
  }

  void ReportBits(Span span) { diagnostics_.Report(span, diag::Level9BitOperation, Target()); }

  void CheckOperator(ir::BinaryOp op, Span span) {
    switch (op) {
      case ir::BinaryOp::kShiftLeft:
      case ir::BinaryOp::kShiftRight:
      case ir::BinaryOp::kBitAnd:
      case ir::BinaryOp::kBitOr:
      case ir::BinaryOp::kBitXor: ReportBits(span); break;
      case ir::BinaryOp::kMul: ++instructions_; break;  // an addition may be fused with it
      default: break;
    }
  }

  void CheckIntrinsic(const ir::IntrinsicCall& call, Span span) {
    if (ir::InfoOf(call.op).first_model >= 4) {
      diagnostics_.Report(span, diag::Level9Intrinsic, ir::NameOf(call.op), Target());
    } else {
      instructions_ += call.op == ir::Intrinsic::kMul ? MulInstructions(call) : 1;
    }
  }

  // A dot product, or a multiplication and addition, per row or column of the larger matrix.
  std::uint32_t MulInstructions(const ir::IntrinsicCall& call) const {
    std::uint32_t instructions = 1;
    for (ir::ExprId argument : program_.expr_lists[call.arguments]) {
      const ir::Type& type = program_.types[program_.exprs[argument].type];
      if (type.kind == ir::TypeKind::kMatrix)
        instructions = std::max<std::uint32_t>(instructions, std::min(type.rows, type.columns));
    }
    return instructions;
  }

  // Only constants can be indexed by a value of run time: there is one address register, and it
  // counts constants.
  void CheckIndex(const ir::Index& index, Span span) {
    if (EvaluateInteger(program_, index.index)) return;
    ir::ExprId base = index.base;
    while (true) {
      const auto& node = program_.exprs[base].node;
      if (const auto* inner = std::get_if<ir::Index>(&node))
        base = inner->base;
      else if (const auto* field = std::get_if<ir::FieldRef>(&node))
        base = field->base;
      else
        break;
    }
    const auto* ref = std::get_if<ir::VarRef>(&program_.exprs[base].node);
    if (ref && (program_.vars[ref->var].storage == ir::Storage::kUniform ||
                program_.vars[ref->var].storage == ir::Storage::kConstant))
      return;
    diagnostics_.Report(span, diag::Level9DynamicIndex, Target());
  }

  const ir::Program& program_;
  Diagnostics& diagnostics_;
  std::uint32_t instructions_ = 0;  // a lower bound: no loop is counted twice, no addition at all
};

}  // namespace

void CheckLevel9(const ir::Program& program, Diagnostics& diagnostics) {
  if (program.profile.level9 == ir::Level9::kNone) return;
  Level9Checker(program, diagnostics).Run();
}

}  // namespace clipc
