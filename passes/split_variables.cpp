// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "passes/split_variables.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory_resource>
#include <utility>

#include "base/invariant.h"
#include "ir/access.h"
#include "ir/builder.h"
#include "passes/outputs.h"

namespace clipc::passes {

using namespace ir;

namespace {

// Calls on_place(expr, writes) for every variable, or field of a variable, that is read or written
// in an expression.
template <typename OnPlace>
void ForEachPlace(const Program& program, ExprId id, bool writes, OnPlace&& on_place) {
  const auto read = [&](ExprId operand) { ForEachPlace(program, operand, false, on_place); };
  Visit(Overloaded{
            [&](const VarRef&) { on_place(id, writes); },
            [&](const FieldRef& node) {
              if (As<VarRef>(program, node.base)) return on_place(id, writes);
              ForEachPlace(program, node.base, writes, on_place);
            },
            [&](const OneOf<Swizzle, MatrixSwizzle> auto& node) {
              ForEachPlace(program, node.base, writes, on_place);
            },
            [&](const Index& node) {
              ForEachPlace(program, node.base, writes, on_place);
              read(node.index);
            },
            [&](const OneOf<Assign, Unary, Call, IntrinsicCall> auto&) {
              std::size_t number = 0;
              ForEachOperand(program, id, [&](ExprId operand) {
                const bool is_written = WritesOperand(program, id, number++);
                ForEachPlace(program, operand, is_written, on_place);
              });
            },
            [&](const auto&) { ForEachOperand(program, id, read); },
        },
        program.exprs[id].node);
}

template <typename OnPlace>
void ForEachPlace(const Program& program, StmtId id, OnPlace&& on_place) {
  ForEachPart(
      program, id, [&](ExprId expr) { ForEachPlace(program, expr, false, on_place); },
      [&](StmtId part) { ForEachPlace(program, part, on_place); });
}

class Splitter {
 public:
  Splitter(Program& program, const MainParts& parts)
      : program_(program),
        before_end_(parts.inputs),
        after_begin_(MainBody(program).size() - parts.outputs) {
    const auto body = MainBody(program);
    stmts_.assign(body.begin(), body.end());
    replaced_.resize(stmts_.size());
    is_replaced_.resize(stmts_.size());
    numbers_.resize(program.vars.size());
  }

  void Run() {
    FindCandidates();
    if (candidates_.empty()) return;
    for (now_ = 0; now_ < stmts_.size(); ++now_) Collect(stmts_[now_]);
    for (Candidate& candidate : candidates_)
      candidate.is_whole ? FillAtOnce(candidate) : Split(candidate);
    std::vector<StmtId> result;
    result.reserve(2 * stmts_.size());
    for (std::size_t i = 0; i < stmts_.size(); ++i) {
      result.insert(result.end(), replaced_[i].begin(), replaced_[i].end());
      if (!is_replaced_[i]) result.push_back(stmts_[i]);
    }
    SetMainBody(program_, result);
  }

 private:
  struct Use {
    ExprId expr;
    std::size_t stmt;
    bool writes;
  };
  // A field of a struct, or a whole variable of another type.
  struct Part {
    TypeId type;
    std::pmr::vector<Use> uses;  // in order of the statements
    VarId becomes;
    bool is_new = false;  // whether `becomes` is a new local variable
  };
  // A statement that gives every part a value, or declares the variable without one: `S s;`, `S s =
  // (S)0;`, `s = S(a, b);`.
  struct Definition {
    std::size_t stmt;
    ExprId value;
  };
  struct Candidate {
    VarId var;
    bool is_struct = false;
    bool is_whole = false;  // whether the variable has to be kept
    std::pmr::vector<Part> parts;
    std::pmr::vector<Definition> definitions;  // the first is the declaration
  };

  // ---- candidates and their uses

  // The variables that inputs are put into or that outputs are taken from: no other is replaced.
  void FindCandidates() {
    std::vector<bool> is_output(program_.vars.size());
    for (std::size_t i = after_begin_; i < stmts_.size(); ++i) {
      const Assign* assign = AssignmentAt(i);
      const auto* field = assign ? As<FieldRef>(program_, assign->value) : nullptr;
      const auto* ref =
          assign ? As<VarRef>(program_, field ? field->base : assign->value) : nullptr;
      if (ref) is_output[ref->var.index] = true;
    }
    for (std::size_t i = 0; i < stmts_.size(); ++i) {
      const auto* declare = As<Declare>(program_, stmts_[i]);
      if (!declare || (i >= before_end_ && !is_output[declare->var.index])) continue;
      const Var& var = program_.vars[declare->var];
      if (var.storage != Storage::kLocal || var.precise) continue;
      Candidate candidate{declare->var, program_.types[var.type].kind == TypeKind::kStruct, false,
                          std::pmr::vector<Part>(&memory_), std::pmr::vector<Definition>(&memory_)};
      if (candidate.is_struct) {
        candidate.parts.reserve(program_.types.StructOf(var.type).fields.size());
        for (const Field& field : program_.types.StructOf(var.type).fields) {
          candidate.parts.push_back({field.type, NoUses(), {}});
        }
      } else {
        candidate.parts.push_back({var.type, NoUses(), {}});
      }
      candidates_.push_back(std::move(candidate));
      numbers_[declare->var.index] = static_cast<std::uint32_t>(candidates_.size());
    }
  }

  std::pmr::vector<Use> NoUses() { return std::pmr::vector<Use>(&memory_); }

  Candidate* CandidateOf(VarId var) {
    const std::uint32_t number = numbers_[var.index];
    return number == 0 ? nullptr : &candidates_[number - 1];
  }
  Candidate* CandidateOf(ExprId expr) {
    const auto* ref = As<VarRef>(program_, expr);
    return ref ? CandidateOf(ref->var) : nullptr;
  }

  void Collect(StmtId stmt) {
    if (const auto* declare = As<Declare>(program_, stmt)) {
      if (Candidate* candidate = CandidateOf(declare->var))
        return Define(*candidate, declare->init, true);
    }
    if (const Assign* assign = AssignmentAt(now_)) {
      Candidate* candidate = CandidateOf(assign->target);
      if (candidate && candidate->is_struct) return Define(*candidate, assign->value, false);
    }
    ForEachPlace(program_, stmt, [&](ExprId expr, bool writes) { Place(expr, writes); });
  }

  void Place(ExprId expr, bool writes) {
    if (Candidate* candidate = CandidateOf(expr)) {
      if (candidate->is_struct)
        candidate->is_whole = true;
      else
        candidate->parts[0].uses.push_back({expr, now_, writes});
    } else if (const auto* field = As<FieldRef>(program_, expr)) {
      if (Candidate* base = CandidateOf(field->base))
        base->parts[field->field].uses.push_back({expr, now_, writes});
    }
  }

  // Adds a definition. The variable must be kept unless the value is a zero, or one value for each
  // part, and does not read the variable itself.
  void Define(Candidate& candidate, ExprId value, bool is_declaration) {
    std::size_t uses = 0;
    for (const Part& part : candidate.parts) uses += part.uses.size();
    if (value) {
      const bool is_by_parts = As<Zero>(program_, value) || As<Construct>(program_, value);
      if (candidate.is_struct && !is_by_parts) candidate.is_whole = true;
      ForEachPlace(program_, value, false, [&](ExprId expr, bool writes) { Place(expr, writes); });
    }
    for (const Part& part : candidate.parts) uses -= part.uses.size();
    if (uses != 0 || (!is_declaration && candidate.definitions.empty())) candidate.is_whole = true;
    candidate.definitions.push_back({now_, value});
  }

  const Assign* AssignmentAt(std::size_t stmt) const {
    return AsAssignment(program_, stmts_[stmt]);
  }

  // ---- replacement

  // Replaces `Vertex v; v.position = in_POSITION0; v.normal = in_NORMAL0;` by `Vertex v =
  // Vertex(in_POSITION0, in_NORMAL0);`.
  void FillAtOnce(Candidate& candidate) {
    if (!candidate.is_struct || candidate.definitions.empty()) return;
    const Definition& declaration = candidate.definitions.front();
    if (declaration.stmt >= before_end_ || declaration.value) return;
    std::vector<ExprId> values;
    std::size_t last = 0;
    for (const Part& part : candidate.parts) {
      const Use* first = OverwriteAfter(part, declaration.stmt);
      if (!first || first->stmt >= before_end_) return;
      if (first != &part.uses.back() && std::next(first)->stmt < before_end_) return;
      values.push_back(AssignmentAt(first->stmt)->value);
      last = std::max(last, first->stmt);
    }
    Builder b(program_, program_.stmts[stmts_[declaration.stmt]].span);
    const ExprId value = b.ConstructOf(program_.vars[candidate.var].type, values);
    replaced_[last].push_back(b.Stmt(Declare{candidate.var, value}));
    is_replaced_[declaration.stmt] = true;
    for (const Part& part : candidate.parts) is_replaced_[part.uses.front().stmt] = true;
  }

  void Split(Candidate& candidate) {
    bool is_interface = candidate.definitions.front().stmt < before_end_;
    for (Part& part : candidate.parts) {
      part.becomes = OutputOf(part);
      is_interface |= part.becomes.operator bool();
    }
    if (!is_interface) return;  // neither an input nor an output is involved
    for (Part& part : candidate.parts) {
      if (part.becomes) {
        is_replaced_[part.uses.back().stmt] = true;
      } else if (const VarId input =
                     candidate.definitions.size() == 1 && !candidate.definitions[0].value
                         ? InputOf(part)
                         : VarId{}) {
        part.becomes = input;
        is_replaced_[part.uses.front().stmt] = true;
      } else if (IsNeverRead(part)) {
        is_replaced_[part.uses.front().stmt] = true;
      } else if (!part.uses.empty()) {
        Var var = program_.vars[candidate.var];
        if (candidate.is_struct) {
          const Field& field = program_.types.StructOf(var.type).fields[NumberOf(candidate, part)];
          var.name = field.name;
          var.precise = field.precise;
        }
        var.type = part.type;
        part.becomes = program_.vars.Add(std::move(var));
        part.is_new = true;
      }
    }
    for (const Definition& definition : candidate.definitions) Replace(candidate, definition);
    for (const Part& part : candidate.parts) {
      if (!part.becomes) continue;
      for (const Use& use : part.uses) program_.exprs[use.expr].node = VarRef{part.becomes};
    }
  }

  // Whether the part is an input that the shader never reads.
  bool IsNeverRead(const Part& part) const {
    if (part.uses.size() != 1 || part.uses.front().stmt >= before_end_) return false;
    const Assign* assign = AssignmentAt(part.uses.front().stmt);
    return assign && assign->target == part.uses.front().expr && IsPure(program_, assign->value);
  }

  static std::size_t NumberOf(const Candidate& candidate, const Part& part) {
    return static_cast<std::size_t>(&part - candidate.parts.data());
  }

  // The output that takes the part's last value as it is; an invalid id if no output does.
  VarId OutputOf(const Part& part) const {
    if (part.uses.empty()) return {};
    const Use& last = part.uses.back();
    if (last.stmt < after_begin_ ||
        (part.uses.size() > 1 && part.uses[part.uses.size() - 2].stmt >= after_begin_))
      return {};
    const Assign* assign = AssignmentAt(last.stmt);
    if (!assign || assign->value != last.expr) return {};
    const auto* target = As<VarRef>(program_, assign->target);
    if (!target || program_.vars[target->var].storage != Storage::kOutput) return {};
    return program_.vars[target->var].type == part.type ? target->var : VarId{};
  }

  // The input that is the part's value from beginning to end; an invalid id if no input is.
  VarId InputOf(const Part& part) const {
    if (part.uses.empty() || std::ranges::count_if(part.uses, &Use::writes) != 1) return {};
    const Use& first = part.uses.front();
    const Assign* assign = first.stmt < before_end_ ? AssignmentAt(first.stmt) : nullptr;
    if (!assign || assign->target != first.expr) return {};
    const auto* value = As<VarRef>(program_, assign->value);
    const bool is_plain = value && IsPlainInput(program_, value->var);
    return is_plain && program_.vars[value->var].type == part.type ? value->var : VarId{};
  }

  // The part's first use after the statement `stmt` if that use is `part = value;`; otherwise null.
  const Use* OverwriteAfter(const Part& part, std::size_t stmt) const {
    const auto next = std::ranges::upper_bound(part.uses, stmt, {}, &Use::stmt);
    if (next == part.uses.end()) return nullptr;
    const bool is_only = std::next(next) == part.uses.end() || std::next(next)->stmt != next->stmt;
    const Assign* assign = AssignmentAt(next->stmt);
    return is_only && assign && assign->target == next->expr ? &*next : nullptr;
  }

  void Replace(Candidate& candidate, const Definition& definition) {
    const bool is_declaration = &definition == &candidate.definitions.front();
    const auto* construct = As<Construct>(program_, definition.value);
    const List<ExprId> values = construct ? construct->arguments : List<ExprId>{};
    is_replaced_[definition.stmt] = true;
    for (std::size_t i = 0; i < candidate.parts.size(); ++i) {
      const Part& part = candidate.parts[i];
      Builder b(program_, program_.stmts[stmts_[definition.stmt]].span);
      auto& out = replaced_[definition.stmt];
      ExprId value = !candidate.is_struct ? definition.value
                     : construct          ? program_.expr_lists[values][i]
                                          : ExprId{};
      if (!part.becomes) {
        if (value && !IsPure(program_, value)) out.push_back(b.Eval(value));
        continue;
      }
      const Use* overwrite = OverwriteAfter(part, definition.stmt);
      const bool is_zero = candidate.is_struct && definition.value && !construct;
      if (is_zero && !overwrite) value = b.ZeroOf(part.type);
      if (part.is_new && is_declaration) {
        const bool is_alone = candidate.definitions.size() == 1;
        if (!value && overwrite && is_alone) {
          const ExprId first = AssignmentAt(overwrite->stmt)->value;
          is_replaced_[overwrite->stmt] = true;
          replaced_[overwrite->stmt].push_back(b.Stmt(Declare{part.becomes, first}));
        } else {
          out.push_back(b.Stmt(Declare{part.becomes, value}));
        }
      } else if (value) {
        out.push_back(b.Eval(b.AssignTo(b.Ref(part.becomes), value)));
      }
    }
  }

  Program& program_;
  const std::size_t before_end_, after_begin_;
  // The memory of the lists of most shaders, which so ask for none.
  std::array<std::byte, 16384> first_memory_;
  std::pmr::monotonic_buffer_resource memory_{first_memory_.data(), first_memory_.size()};
  std::pmr::vector<StmtId> stmts_{&memory_};
  // The statements to insert before each statement; is_replaced_ tells whether that is removed.
  std::pmr::vector<std::pmr::vector<StmtId>> replaced_{&memory_};
  std::vector<bool> is_replaced_;
  std::size_t now_ = 0;
  std::pmr::vector<Candidate> candidates_{&memory_};
  std::pmr::vector<std::uint32_t> numbers_{&memory_};  // by VarId: its candidate, from 1, or 0
};

}  // namespace

void SplitVariables(Program& program, const MainParts& parts) {
  CLIPC_CHECK(program.form == Form::kInlined);
  Splitter(program, parts).Run();
}

}  // namespace clipc::passes
