// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/printer.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "base/overloaded.h"
#include "base/shortest_text.h"
#include "clip-table/vocabulary.h"
#include "ir/access.h"
#include "ir/scalar.h"
#include "ir/walk.h"

namespace clipc::ir {
namespace {

std::string_view TextOf(BinaryOp op) {
  if (!IsShortCircuit(op)) return SpellingOf(op);
  return op == BinaryOp::kShortCircuitAnd ? "and_then" : "or_else";
}

const char* StorageText(Storage storage) {
  switch (storage) {
    case Storage::kOut: return "out ";
    case Storage::kInOut: return "inout ";
    case Storage::kStatic: return "static ";
    case Storage::kShared: return "groupshared ";
    case Storage::kConstant: return "const ";
    default: return "";
  }
}

// The shortest text that reads back as the same number, always with a point or an exponent.
template <typename T>
std::string NumberText(T value, std::uint64_t bits) {
  if (std::isnan(value)) {
    char buffer[16];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, bits, 16).ptr;
    return "nan(0x" + std::string(buffer, end) + ")";
  }
  std::string text = ShortestText(value);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

template <typename Range, typename NameFn>
std::vector<std::uint32_t> Suffixes(const Range& range, NameFn&& name_of) {
  std::unordered_map<std::string_view, std::uint32_t> used;
  std::vector<std::uint32_t> suffixes;
  for (auto id : range.ids()) suffixes.push_back(used[name_of(range[id])]++);
  return suffixes;
}

std::string Suffixed(const std::string& name, std::uint32_t suffix) {
  const std::string base = name.empty() ? "<unnamed>" : name;
  return suffix == 0 ? base : base + "." + std::to_string(suffix);
}

bool NeedsParentheses(const Expr& expr) {
  return Visit(
      Overloaded{
          [](const OneOf<Binary, Unary, Assign, Conditional, Comma> auto&) { return true; },
          [](const auto&) { return false; },
      },
      expr.node);
}

}  // namespace

Printer::Printer(const Program& program)
    : program_(program),
      var_suffixes_(
          Suffixes(program.vars, [](const Var& var) { return std::string_view(var.name); })),
      function_suffixes_(Suffixes(program.functions, [](const Function& function) {
        return std::string_view(function.name);
      })) {}

std::string Printer::NameOf(VarId var) const {
  return var.index < var_suffixes_.size()
             ? Suffixed(program_.vars[var].name, var_suffixes_[var.index])
             : "<no such variable>";
}

std::string Printer::NameOf(FunctionId function) const {
  return function.index < function_suffixes_.size()
             ? Suffixed(program_.functions[function].name, function_suffixes_[function.index])
             : "<no such function>";
}

void Printer::Line(std::string_view text) {
  text_.append(static_cast<std::size_t>(indent_) * 2, ' ');
  Put(text, "\n");
}

std::string Printer::Declaration(VarId id, ExprId init) {
  const Var& var = program_.vars[id];
  return std::string(StorageText(var.storage)) + (var.row_major ? "row_major " : "") +
         (var.precise ? "precise " : "") + Declarator(var.type, NameOf(id)) +
         (init ? " = " + ExprText(init) : "");
}

std::string Printer::Declarator(TypeId type, const std::string& name) const {
  const std::string text = program_.types.Name(type);
  const std::size_t dimensions = std::min(text.find('['), text.size());
  return text.substr(0, dimensions) + " " + name + text.substr(dimensions);
}

std::string Printer::ExprText(ExprId expr) {
  std::string outer = std::exchange(text_, {});
  Put(expr);
  return std::exchange(text_, std::move(outer));
}

void Printer::PrintFunction(FunctionId id, std::string_view role) {
  const Function& function = program_.functions[id];
  std::string line =
      std::string(role) + program_.types.Name(function.return_type) + " " + NameOf(id) + "(";
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    line += (i == 0 ? "" : ", ") + Declaration(function.parameters[i]);
  }
  if (!function.body) return Line(line + ")");
  Line(line + ") {");
  PutBody(function.body);
  Line("}");
}

// ---- expressions

void Printer::Put(List<ExprId> list) {
  for (std::uint32_t i = 0; i < list.size; ++i)
    Put(i == 0 ? "" : ", ", program_.expr_lists[list][i]);
}

void Printer::PutLiteral(const Type& type, std::uint64_t bits) {
  using enum Scalar;
  const Scalar base = BaseOf(type.scalar);
  switch (base) {
    case kBool: return Put(bits != 0 ? "true" : "false");
    case kInt: Put(std::to_string(IntOf(bits))); break;
    case kUint: Put(std::to_string(UintOf(bits))); break;
    case kInt64: return Put(std::to_string(Int64Of(bits)), "LL");
    case kUint64: return Put(std::to_string(bits), "ULL");
    case kDouble: return Put(NumberText(DoubleOf(bits), bits), "L");
    default: Put(NumberText(FloatOf(bits), bits));
  }
  if (type.scalar == kUint) Put("u");
  if (type.scalar == kHalf) return Put("h");
  if (type.scalar != base) Put(":", ir::NameOf(type.scalar));
}

void Printer::Put(Operand operand) {
  if (NeedsParentheses(program_.exprs[operand.expr])) return Put("(", operand.expr, ")");
  Put(operand.expr);
}

void Printer::PutUnary(const Unary& node) {
  const std::string_view text = SpellingOf(node.op);
  const bool is_post = IsPostfix(node.op);
  Put(is_post ? "" : text, Operand{node.operand}, is_post ? text : "");
}

void Printer::PutField(const FieldRef& node) {
  const Type& base = program_.types[program_.exprs[node.base].type];
  const bool has_field =
      base.kind == TypeKind::kStruct && node.field < program_.types[base.structure].fields.size();
  Put(Operand{node.base}, ".",
      has_field ? program_.types[base.structure].fields[node.field].name : "<no field>");
}

void Printer::PutObjectCall(const ObjectCall& node) {
  Put(InfoOf(node.op).name, "(");
  ForEachNamedOperand(program_, node, [&](OperandKind kind, ExprId operand) {
    if (kind != OperandKind::kObject) Put(", ");
    if (kind > OperandKind::kPlace) Put(ir::NameOf(kind), ": ");
    Put(operand);
  });
  Put(")");
}

void Printer::Put(ExprId id) {
  if (!id || id.index >= program_.exprs.size()) return Put("<no expression>");
  const Expr& expr = program_.exprs[id];
  const Type& type = program_.types[expr.type];
  const std::string type_name = program_.types.Name(expr.type);
  const auto typed = [&](const char* what, ExprId operand) {
    Put(what, "<", type_name, ">(", operand, ")");
  };
  std::visit(
      Overloaded{
          [&](const Literal& n) { PutLiteral(type, n.bits); },
          [&](const Zero&) { Put("zero<", type_name, ">"); },
          [&](const VarRef& n) { Put(NameOf(n.var)); },
          [&](const FieldRef& n) { PutField(n); },
          [&](const Index& n) { Put(Operand{n.base}, "[", n.index, "]"); },
          [&](const Swizzle& n) {
            Put(Operand{n.base}, ".");
            for (int i = 0; i < n.count; ++i) text_ += "xyzw"[n.components[i] & 3];
          },
          [&](const MatrixSwizzle& n) {
            Put(Operand{n.base}, ".");
            for (int i = 0; i < n.count; ++i)
              Put("_m", std::to_string(n.rows[i]), std::to_string(n.columns[i]));
          },
          [&](const Unary& n) { PutUnary(n); },
          [&](const Binary& n) { Put(Operand{n.left}, " ", TextOf(n.op), " ", Operand{n.right}); },
          [&](const Assign& n) {
            Put(Operand{n.target}, " ", n.op ? TextOf(*n.op) : "", "= ", n.value);
          },
          [&](const Conditional& n) {
            Put(Operand{n.condition}, " ? ", Operand{n.when_true}, " : ", Operand{n.when_false});
          },
          [&](const Select& n) {
            Put("select(", n.condition, ", ", n.when_true, ", ", n.when_false, ")");
          },
          [&](const Convert& n) { typed("convert", n.operand); },
          [&](const Splat& n) { typed("splat", n.operand); },
          [&](const Construct& n) {
            const bool braces = !type.IsNumeric();
            Put(type_name, braces ? "{" : "(", n.arguments, braces ? "}" : ")");
          },
          [&](const MatrixTruncate& n) { typed("truncate", n.operand); },
          [&](const Call& n) { Put(NameOf(n.function), "(", n.arguments, ")"); },
          [&](const IntrinsicCall& n) { Put(ir::NameOf(n.op), "(", n.arguments, ")"); },
          [&](const ObjectCall& n) { PutObjectCall(n); },
          [&](const Comma& n) { Put(Operand{n.first}, ", ", Operand{n.second}); },
      },
      expr.node);
}

// ---- statements

void Printer::PutBody(StmtId id) {
  ++indent_;
  if (const Block* block = std::get_if<Block>(&program_.stmts[id].node)) {
    for (StmtId stmt : program_.stmt_lists[block->body]) PutStmt(stmt);
  } else {
    PutStmt(id);
  }
  --indent_;
}

void Printer::PutFor(const For& node) {
  std::string line = "for (";
  for (std::uint32_t i = 0; i < node.init.size; ++i) {
    const auto& init = program_.stmts[program_.stmt_lists[node.init][i]].node;
    if (i != 0) line += ", ";
    if (const Evaluate* evaluate = std::get_if<Evaluate>(&init)) line += ExprText(evaluate->expr);
    if (const Declare* declare = std::get_if<Declare>(&init))
      line += Declaration(declare->var, declare->init);
  }
  line += "; " + (node.condition ? ExprText(node.condition) : "") + "; " +
          (node.step ? ExprText(node.step) : "");
  Line(line + ") {");
  PutBody(node.body);
  Line("}");
}

void Printer::PutSwitch(const Switch& node) {
  Line("switch (" + ExprText(node.value) + ") {");
  for (const SwitchCase& arm : program_.switch_cases[node.cases]) {
    for (ExprId label : program_.expr_lists[arm.labels]) Line("case " + ExprText(label) + ":");
    if (arm.is_default) Line("default:");
    ++indent_;
    for (StmtId stmt : program_.stmt_lists[arm.body]) PutStmt(stmt);
    --indent_;
  }
  Line("}");
}

void Printer::PutStmt(StmtId id) {
  std::visit(Overloaded{
                 [&](const Block&) { Line("{"), PutBody(id), Line("}"); },
                 [&](const Declare& n) { Line(Declaration(n.var, n.init)); },
                 [&](const Evaluate& n) { Line(ExprText(n.expr)); },
                 [&](const If& n) {
                   Line("if (" + ExprText(n.condition) + ") {");
                   PutBody(n.then);
                   if (n.otherwise) {
                     Line("} else {");
                     PutBody(n.otherwise);
                   }
                   Line("}");
                 },
                 [&](const For& n) { PutFor(n); },
                 [&](const While& n) {
                   Line("while (" + ExprText(n.condition) + ") {"), PutBody(n.body), Line("}");
                 },
                 [&](const DoWhile& n) {
                   Line("do {"), PutBody(n.body), Line("} while (" + ExprText(n.condition) + ")");
                 },
                 [&](const Switch& n) { PutSwitch(n); },
                 [&](const Return& n) { Line(n.value ? "return " + ExprText(n.value) : "return"); },
                 [&](const Break&) { Line("break"); },
                 [&](const Continue&) { Line("continue"); },
                 [&](const Discard&) { Line("discard"); },
             },
             program_.stmts[id].node);
}

}  // namespace clipc::ir
