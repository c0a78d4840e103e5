// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/check_level9.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "frontend/rules/known_values.h"
#include "frontend/rules/loop_iterations.h"
#include "frontend/typing/constant.h"
#include "ir/access.h"
#include "ir/counted_loop.h"
#include "ir/walk.h"

namespace clipc::rules {
namespace {

// The limits of shader model 2 through 10Level9. Sources: "vs_2_0" register tables of the Direct3D
// 9 reference; the "runtime generated constant mappings" that fxc prints for 9_x targets take one
// float constant for the half-pixel position offset.
constexpr std::size_t kMaxInputs = 16;
constexpr std::size_t kMaxOutputs = 8;                // texture coordinate registers oT0..oT7
constexpr std::uint32_t kMaxConstantRegisters = 255;  // c0..c255 less the position offset
constexpr std::uint32_t kMaxInstructions = 256;
// fxc's error X3511: "loop does not appear to terminate in a timely manner (1024 iterations)".
constexpr std::uint32_t kMaxIterations = 1024;

class Level9Checker {
 public:
  Level9Checker(const Program& program, bool has_preshader, Diagnostics& diagnostics)
      : program_(program), has_preshader_(has_preshader), diagnostics_(diagnostics) {}

  // Reports what a pixel shader of level 9 lacks, which runs as ps_2_0 or, at 9_3, ps_2_a: loops
  // whose number of iterations is computed, bit operations, and most ways to read a texture.
  void RunPixel() {
    for (const FunctionId id : program_.functions.ids()) {
      const StmtId body = program_.functions[id].body;
      ForEachStmt(program_, body, [&](StmtId stmt) { CheckLoop(stmt); });
      ForEachExpr(program_, body, [&](ExprId expr) { CheckPixelExpr(expr); });
    }
  }

  // Reports a vertex shader without a position, and what Direct3D 9 lacks too: bit operations and,
  // before vs_2_a, loops whose number of iterations is computed.
  void RunDirect3D9() {
    const auto is_position = [](const IoVar& output) {
      return output.builtin == Builtin::kPosition;
    };
    if (program_.stage == Stage::kVertex && !program_.is_interface_only &&
        std::ranges::none_of(program_.outputs, is_position))
      diagnostics_.Report(program_.functions[program_.entry].span, diag::PositionMissing);
    // ps_2_0 to ps_2_b have no flow control: D3DXGetPixelShaderProfile.
    const bool has_loops = Target() != "vs_1_1" && Target() != "vs_2_0" &&
                           (program_.stage != Stage::kPixel || program_.profile.major > 2);
    for (const FunctionId id : program_.functions.ids()) {
      if (!has_loops)
        ForEachStmt(program_, program_.functions[id].body, [&](StmtId stmt) { CheckLoop(stmt); });
      ForEachExpr(program_, program_.functions[id].body, [&](ExprId expr) { CheckBitUses(expr); });
    }
  }

  void Run() {
    CheckInterface();
    CheckConstants();
    for (FunctionId id : program_.functions.ids()) {
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
    for (const IoVar& input : program_.inputs) {
      inputs += input.builtin == Builtin::kNone;
      if (input.builtin == Builtin::kNone) continue;
      diagnostics_.Report(program_.vars[input.var].span, diag::Level9SystemValue, input.semantic,
                          Target());
    }
    for (const IoVar& output : program_.outputs) {
      outputs += output.builtin == Builtin::kNone;
      if (output.builtin == Builtin::kClipDistance || output.builtin == Builtin::kCullDistance) {
        diagnostics_.Report(program_.vars[output.var].span, diag::Level9ClipDistance,
                            output.semantic, Target());
      } else if (output.builtin != Builtin::kNone && output.builtin != Builtin::kPosition) {
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
    for (CbufferId id : program_.cbuffers.ids()) {
      const Cbuffer& buffer = program_.cbuffers[id];
      if (buffer.kind == CbufferKind::kTbuffer)
        diagnostics_.Report(buffer.span, diag::Level9Tbuffer, buffer.name, Target());
      registers += (buffer.size + 15) / 16 * buffer.count;
    }
    if (registers > kMaxConstantRegisters) {
      diagnostics_.Report(program_.functions[program_.entry].span, diag::Level9Constants, registers,
                          kMaxConstantRegisters, Target());
    }
  }

  void CheckStmt(StmtId id) {
    ForEachPart(
        program_, id, [&](ExprId expr) { CheckExpr(expr); }, [&](StmtId stmt) { CheckStmt(stmt); });
  }

  void CheckExpr(ExprId id) {
    const Expr& expr = program_.exprs[id];
    std::visit(
        Overloaded{[&](const Binary& binary) { CheckOperator(binary.op, id); },
                   [&](const Assign& assign) {
                     if (assign.op) CheckOperator(*assign.op, id);
                   },
                   [&](const Unary& unary) {
                     if (unary.op == UnaryOp::kComplement) CheckBits(id);
                   },
                   [&](const IntrinsicCall& call) { CheckIntrinsic(call, expr.span); },
                   [&](const ObjectCall&) {
                     diagnostics_.Report(expr.span, diag::Level9Texture, Target());
                   },
                   [&](const Index& index) { CheckIndex(index, expr.span); }, [](const auto&) {}},
        expr.node);
    ForEachOperand(program_, id, [&](ExprId operand) { CheckExpr(operand); });
  }

  void CheckPixelExpr(ExprId id) {
    const Expr& expr = program_.exprs[id];
    if (const auto* call = As<IntrinsicCall>(program_, id)) {
      const IntrinsicInfo& info = InfoOf(call->op);
      if (info.first_model >= 4)
        diagnostics_.Report(expr.span, diag::Level9Intrinsic, NameOf(call->op), Target());
    } else if (const auto* object = As<ObjectCall>(program_, id)) {
      if (!MayRead(object->op)) diagnostics_.Report(expr.span, diag::Level9Sample, Target());
    } else {
      CheckBitUses(id);
    }
  }

  bool MayRead(ObjectOp op) const {
    using enum ObjectOp;
    switch (op) {
      case kSample:
      case kSampleBias:
      case kSampleCmp:
      case kSampleCmpLevelZero:
      case kD3d9Sample:
      case kD3d9SampleBias:
      case kD3d9SampleProjected: return true;
      case kSampleGrad:
      case kD3d9SampleGrad: return program_.profile.level9 == Level9::k9_3;
      default: return false;
    }
  }

  void CheckBitUses(ExprId id) {
    const auto* unary = As<Unary>(program_, id);
    if (unary && unary->op == UnaryOp::kComplement) CheckBits(id);
    const auto* binary = As<Binary>(program_, id);
    if (binary) CheckOperator(binary->op, id);
    const auto* assign = As<Assign>(program_, id);
    if (assign && assign->op) CheckOperator(*assign->op, id);
  }

  void CheckLoop(StmtId id) {
    clipc::Visit(Overloaded{
                     [&](const OneOf<For, While, DoWhile> auto& loop) {
                       if (Counts(loop)) return;
                       if (loop.condition && !IsKnownCount(loop.condition))
                         diagnostics_.Report(program_.exprs[loop.condition].span,
                                             diag::Level9UnknownLoop, Target());
                     },
                     [](const auto&) {},
                 },
                 program_.stmts[id].node);
  }

  // Whether the loop counts from one number to another, which it does also where a condition that
  // is not known decides whether it runs.
  template <typename Loop>
  bool Counts(const Loop& loop) const {
    constexpr std::int64_t kMost = 1 << 20;
    if constexpr (std::is_same_v<Loop, For>) return EndsWithin(program_, loop, kMost) == true;
    return false;
  }

  // Whether a loop with the condition can be unrolled, or counts to an int that the application
  // sets, which vs_2_0 has integer registers for. The preshader of an effect sets them to what it
  // computes.
  bool IsKnownCount(ExprId condition) {
    if (!known_) known_.emplace(program_);
    if (known_->Has(condition)) return true;
    if (has_preshader_ && Target() == "vs_2_0") {
      if (!known_to_preshader_)
        known_to_preshader_.emplace(program_, std::span<const VarId>(),
                                    KnownValues::Kind::kUniforms);
      return known_to_preshader_->Has(condition);
    }
    const auto* compare = As<Binary>(program_, condition);
    const auto* bound = compare ? As<VarRef>(program_, compare->right) : nullptr;
    return bound && Target() == "vs_2_0" &&
           program_.vars[bound->var].storage == Storage::kUniform &&
           TypeOf(program_, compare->right).scalar == Scalar::kInt;
  }

  // Whether the expression has a known value once loops are unrolled, and so takes no instruction.
  bool IsKnown(ExprId id) {
    if (!known_) known_.emplace(program_);
    if (!known_->Has(id)) return false;
    CheckIterations(id);
    return true;
  }

  // Reports a value that is known only when a loop of more than kMaxIterations iterations is
  // unrolled.
  void CheckIterations(ExprId id) {
    if (!known_in_short_loops_) {
      std::vector<VarId> counters;
      for (const StmtId stmt : program_.stmts.ids()) {
        const auto* loop = As<For>(program_, stmt);
        if (loop && EndsWithin(program_, *loop, kMaxIterations) == false)
          counters.push_back(PartsOf(program_, *loop).counter);
      }
      known_in_short_loops_.emplace(program_, counters);
    }
    if (!known_in_short_loops_->Has(id)) {
      diagnostics_.Report(program_.exprs[id].span, diag::Level9LongLoop, kMaxIterations, Target());
    }
  }

  void CheckBits(ExprId id) {
    if (!IsKnown(id))
      diagnostics_.Report(program_.exprs[id].span, diag::Level9BitOperation, Target());
  }

  void CheckOperator(BinaryOp op, ExprId id) {
    switch (op) {
      case BinaryOp::kShiftLeft:
      case BinaryOp::kShiftRight:
      case BinaryOp::kBitAnd:
      case BinaryOp::kBitOr:
      case BinaryOp::kBitXor: CheckBits(id); break;
      case BinaryOp::kMul: ++instructions_; break;  // an addition may be fused with it
      default: break;
    }
  }

  void CheckIntrinsic(const IntrinsicCall& call, Span span) {
    if (InfoOf(call.op).first_model >= 4) {
      diagnostics_.Report(span, diag::Level9Intrinsic, NameOf(call.op), Target());
    } else {
      instructions_ += call.op == CommonIntrinsic::kMul ? MulInstructions(call) : 1;
    }
  }

  // The instructions of a mul: a dot product, or a multiplication and addition, per row or column
  // of the larger matrix.
  std::uint32_t MulInstructions(const IntrinsicCall& call) const {
    std::uint32_t instructions = 1;
    for (ExprId argument : program_.expr_lists[call.arguments]) {
      const Type& type = TypeOf(program_, argument);
      if (type.kind == TypeKind::kMatrix)
        instructions = std::max<std::uint32_t>(instructions, std::min(type.rows, type.columns));
    }
    return instructions;
  }

  // Reports an index known only at run time into anything but constants: there is one address
  // register, and it counts constants. fxc unrolls the loops whose counters index anything else.
  void CheckIndex(const Index& index, Span span) {
    if (EvaluateInteger(program_, index.index)) return;
    ExprId base = index.base;
    while (As<Index>(program_, base) || As<FieldRef>(program_, base))
      base = WholeOf(program_, base);
    const auto* ref = As<VarRef>(program_, base);
    if (ref && (program_.vars[ref->var].storage == Storage::kUniform ||
                program_.vars[ref->var].storage == Storage::kConstant))
      return;
    if (!IsKnown(index.index)) diagnostics_.Report(span, diag::Level9DynamicIndex, Target());
  }

  const Program& program_;
  const bool has_preshader_;
  Diagnostics& diagnostics_;
  // The known values, built for the first rule that depends on them.
  std::optional<KnownValues> known_;
  std::optional<KnownValues> known_to_preshader_;
  std::optional<KnownValues> known_in_short_loops_;  // if no loop beyond kMaxIterations is unrolled
  std::uint32_t instructions_ = 0;  // a lower bound: no loop is counted twice, no addition at all
};

}  // namespace

void CheckLevel9(const Program& program, bool has_preshader, Diagnostics& diagnostics) {
  Level9Checker checker(program, has_preshader, diagnostics);
  if (program.profile.IsDirect3D9()) return checker.RunDirect3D9();
  const bool is_level9 = program.profile.level9 != Level9::kNone;
  if (!is_level9) return;
  if (program.stage == Stage::kVertex) return checker.Run();
  checker.RunPixel();
}

}  // namespace clipc::rules
