// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "ir/evaluate.h"
#include "ir/evaluate_group.h"
#include "ir/evaluate_math.h"
#include "ir/evaluate_quad.h"

namespace clipc::ir {

// The most words that one value, or all variables together, may have: 128 MiB.
inline constexpr std::uint32_t kMaxWords = 1u << 24;

// One run of one program. A value is its components in order, one word each (a matrix by rows, a
// struct by fields, an array by elements); an object is one word that names a resource. Expressions
// push their value on a stack; each variable has its own place in `memory_`, since no function can
// be active twice.
class Machine {
 public:
  // `neighbours` are those of a pixel, `thread` is one of a group; null for a run without any.
  Machine(const Program& program, const EvalInputs& inputs, const EvalOptions& options,
          Neighbours* neighbours = nullptr, GroupThread* thread = nullptr);

  EvalResult Run();
  // The value of an expression outside of all functions, by which a test sees one operation.
  std::vector<Word> Value(ExprId expr);
  // The value of a constant expression, as ConstantBits() returns it.
  std::optional<std::vector<Word>> Constant(ExprId expr);

 private:
  enum class Flow : std::uint8_t { kNext, kBreak, kContinue, kReturn, kStop };
  // The words of a target. If count is above 0, they are the words at `address` plus each of
  // `components`, in that order.
  struct TargetWords {
    std::uint32_t address = 0;
    bool in_bounds = true;
    std::uint8_t count = 0;
    std::array<std::uint8_t, 4> components{};
  };

  // evaluate.cpp: from the program's inputs to its outputs
  bool Prepare();  // false if the program is too large
  void LoadCbuffer(CbufferId id);
  void Unpack(const std::vector<std::uint8_t>& bytes, std::uint64_t offset, TypeId type,
              bool row_major, Word*& to);
  void UnpackMatrix(const std::vector<std::uint8_t>& bytes, std::uint64_t offset, const Type& type,
                    bool row_major, Word*& to);
  Word UnpackComponent(const std::vector<std::uint8_t>& bytes, std::uint64_t offset,
                       Scalar kind) const;
  void LoadInput(const IoVar& io, const IoBits& bits);
  void InitialiseGlobals();
  void Initialise(VarId var);
  EvalOutputs ReadOutputs() const;

  // evaluate.cpp: how values lie in words
  Scalar RepOf(
      Scalar kind) const;  // the base kind, with kDouble for kFloat when computing in double
  Scalar RepOf(ExprId expr) const { return RepOf(TypeOf(expr).scalar); }
  Word FromBits(Word bits, Scalar kind) const;  // from the bits of a Literal
  Word ToBits(Word word, Scalar kind) const;
  const Type& TypeOf(ExprId expr) const { return program_.types[program_.exprs[expr].type]; }
  std::uint32_t WordsOf(TypeId type);
  std::uint32_t WordsOf(ExprId expr) { return WordsOf(program_.exprs[expr].type); }
  std::uint32_t FieldWord(StructId structure, std::uint32_t field);
  Word UndefinedOf(Scalar kind, std::size_t component, bool negated) const;
  bool NextUndefinedIsNegated();
  void SetUndefined(VarId var);

  // evaluate_stmt.cpp
  bool Step();  // false if the limit is reached
  Flow Exec(StmtId stmt);
  Flow ExecList(List<StmtId> list);
  Flow Exec(const Block& node) { return ExecList(node.body); }
  Flow Exec(const Declare& node);
  Flow Exec(const Evaluate& node);
  Flow Exec(const If& node);
  Flow Exec(const For& node);
  Flow Exec(const While& node) { return Loop(node.condition, {}, node.body); }
  Flow Exec(const DoWhile& node);
  Flow Exec(const Switch& node);
  Flow Exec(const Return& node);
  Flow Exec(const Break&) { return Flow::kBreak; }
  Flow Exec(const Continue&) { return Flow::kContinue; }
  Flow Exec(const Discard&) { return is_discarded_ = true, Flow::kNext; }
  Flow Loop(ExprId condition, ExprId step, StmtId body);
  bool Test(ExprId condition);
  void CallFunction(FunctionId function, std::size_t base);

  // evaluate_expr.cpp: each pushes the value of the node
  void Eval(ExprId expr) { only_constants_ ? EvalConstant(expr) : EvalNode(expr); }
  void EvalNode(ExprId expr);
  void EvalNode(ExprId expr, const Literal& node);
  void EvalNode(ExprId expr, const Zero&) { PushZeros(WordsOf(expr)); }
  void EvalNode(ExprId expr, const VarRef& node);
  void EvalNode(ExprId expr, const FieldRef&) { EvalPart(expr); }
  void EvalNode(ExprId expr, const Index&) { EvalPart(expr); }
  void EvalNode(ExprId expr, const Swizzle& node);
  void EvalNode(ExprId expr, const MatrixSwizzle& node);
  void EvalNode(ExprId expr, const Unary& node);
  void EvalNode(ExprId expr, const Binary& node);
  void EvalNode(ExprId expr, const Assign& node);
  void EvalNode(ExprId expr, const Conditional& node);
  void EvalNode(ExprId expr, const Select& node);
  void EvalNode(ExprId expr, const Convert& node);
  void EvalNode(ExprId expr, const Splat& node);
  void EvalNode(ExprId expr, const Construct& node);
  void EvalNode(ExprId expr, const MatrixTruncate& node);
  void EvalNode(ExprId expr, const Comma& node);
  void EvalAndDrop(ExprId expr);  // pushes nothing
  Word EvalScalar(ExprId expr);   // gives the word and pushes nothing
  void EvalInto(ExprId expr, std::uint32_t address);
  void EvalPart(ExprId expr);
  void EvalUnsizedElement(const Index& node);
  void EvalShortCircuit(const Binary& node);
  bool IsPath(ExprId expr) const;
  TargetWords Locate(ExprId expr);
  // Evaluates the index; none when it is out of bounds.
  std::optional<std::uint32_t> IndexInto(const Type& base, ExprId index);
  void PushFrom(const TargetWords& place, TypeId type);
  void Store(const TargetWords& place, std::uint32_t words, const Word* from);
  void PushZeros(std::uint32_t words) { stack_.resize(stack_.size() + words, 0); }
  void PushUndefined(TypeId type);
  // Removes the words after `base` from the stack, except the `words` words at `from`.
  void Keep(std::size_t base, std::size_t from, std::uint32_t words);
  // Removes the words after `base` from the stack, except the first `count` of `places`, which are
  // counted from `base`.
  void Keep(std::size_t base, int count, const std::array<std::size_t, 4>& places);

  // evaluate_call.cpp
  void EvalNode(ExprId expr, const Call& node);
  void EvalNode(ExprId expr, const IntrinsicCall& node);
  std::uint32_t ComponentAt(TypeId whole, std::span<const Word> steps);
  void EvalNode(ExprId expr, const ObjectCall& node);
  void EvalBits(ExprId expr, const IntrinsicCall& node);
  void EvalWriting(const IntrinsicCall& node);
  void EvalAtomic(const IntrinsicCall& node);
  void EvalVertexCall(const IntrinsicCall& node);
  void PushInputOf(std::uint32_t vertex, VarId var);
  void PushOutputOf(std::uint32_t point, VarId var);

  // evaluate_quad.cpp
  void EvalDerivative(ExprId expr, const IntrinsicCall& node);
  void EvalQuad(ExprId expr, const IntrinsicCall& node);
  // ObjectRequest::coordinates, where the pixel's own is `own`.
  std::vector<double> CoordinatesOf(ExprId call, Scalar rep, std::span<const Word> own);

  // evaluate_wave.cpp
  void EvalWave(ExprId expr, const IntrinsicCall& node);
  void PushFold(ExprId expr, Intrinsic op, const Lanes::Operands& operands);
  void PushAllEqual(Scalar rep, std::span<const Word> own, const Lanes::Operands& operands);

  // evaluate_constant.cpp
  void EvalConstant(ExprId expr);
  void EvalConstantVar(VarId var);
  void EvalConstantMember(ExprId expr);
  void EvalConstantWhole(ExprId expr);
  void EvalInVariable(ExprId expr);
  void PushNoConstant();
  bool IsTooMuch();
  ExprId SourceOf(ExprId expr);
  ExprId MemberOf(ExprId expr);

  const Program& program_;
  const EvalInputs& inputs_;
  const EvalOptions& options_;
  Neighbours* const neighbours_;
  GroupThread* const thread_;
  std::uint64_t flow_ = 0;  // a number for the calls and iterations that run: Lanes::Ask
  std::vector<Word> memory_, stack_;
  std::vector<std::uint32_t> address_;                   // by variable
  std::vector<std::uint32_t> aggregate_words_;           // by type, 0: not known yet
  std::vector<std::vector<std::uint32_t>> field_words_;  // by struct, empty: not known yet
  std::string error_;
  std::uint64_t steps_ = 0;
  int depth_ = 0;
  std::uint64_t undefined_reads_ = 0;
  bool only_constants_ = false;  // Constant() runs
  bool is_constant_ = true;      // false once something was not constant
  int variables_ = 0;            // constant variables whose values are being evaluated
  std::unordered_map<std::uint32_t, std::vector<Word>> known_;  // values of constant variables
  std::vector<EvalVertex> vertices_;                            // that were emitted
  std::vector<bool> starts_strip_;                              // by stream: of the next vertex
  bool wrote_out_of_bounds_ = false;
  bool is_discarded_ = false;
  std::uint32_t shared_words_ = 0;  // the first of `memory_`, which a group shares
  bool is_atomic_ = false;          // an atomic operation runs
  bool is_waiting_ = false;         // for the other threads of the group: the run ends
};

}  // namespace clipc::ir
