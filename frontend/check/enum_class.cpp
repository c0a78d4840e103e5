// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/enum_class.h"

#include <optional>

#include "frontend/check/scope.h"
#include "frontend/check/type.h"
#include "frontend/check/type_names.h"

namespace clipc::check {
namespace {

// An enum, or none for a number; nullopt: not known.
using Known = std::optional<SymbolId>;

const ast::EnumDecl* EnumOf(const Context& context, SymbolId symbol) {
  const ast::DeclId decl = context[symbol].decl;
  return decl ? context.GetIf<ast::EnumDecl>(decl) : nullptr;
}

bool IsClass(const Context& context, SymbolId enumeration) {
  return enumeration && EnumOf(context, enumeration)->is_class;
}

Known MeaningOf(Context& context, ast::TypeId id) {
  const ast::Type& type = context[id];
  if (!type.name.name || type.struct_definition || type.outer || type.has_arguments)
    return std::nullopt;
  const SymbolId symbol = Find(context, type.name, true);
  if (symbol) return EnumOf(context, symbol) ? Known(symbol) : std::nullopt;
  const bool is_plain = type.name.scopes.empty() && !type.name.from_global;
  return is_plain && NumericType(context, type.name.name) ? Known(SymbolId{}) : std::nullopt;
}

Known MeaningOf(Context& context, const ast::VarDecl& var) {
  return var.dimensions.empty() ? MeaningOf(context, var.type) : std::nullopt;
}

Known MeaningOf(const Context& context, ExprId value) {
  const auto found = context.enum_values.find(value.index);
  if (found != context.enum_values.end()) return found->second;
  return context.Is<Literal>(value) ? Known(SymbolId{}) : std::nullopt;
}

// The same for a conversion, which every enum takes part in that is not a class.
Known ClassOf(const Context& context, Known meaning) {
  return meaning && *meaning && !IsClass(context, *meaning) ? std::nullopt : meaning;
}

void Note(Context& context, ExprId value, Known meaning) {
  if (meaning && !context.IsError(value))
    context.enum_values.insert_or_assign(value.index, *meaning);
  else
    context.enum_values.erase(value.index);
}

std::string NameOf(const Context& context, SymbolId meaning, TypeId number) {
  return meaning ? std::string(context[context[meaning].name]) : context.TypeName(number);
}

}  // namespace

SymbolId EnumOf(Context& context, const ast::VarDecl& var) {
  if (!context.file.has_enums) return {};
  return MeaningOf(context, var).value_or(SymbolId{});
}

std::uint64_t EnumCost(const Context& context, ExprId value, SymbolId enumeration) {
  // The conversion has an error of its own where nothing else fits.
  constexpr std::uint64_t kNone = std::uint64_t{1} << 56;
  if (!context.file.has_enums) return 0;
  Known meaning = MeaningOf(context, value);
  // What is computed is a number ([conv.prom] of C++).
  if (!meaning && (context.Is<Binary>(value) || context.Is<Convert>(value) ||
                   context.Is<Unary>(value) || context.Is<IntrinsicCall>(value)))
    meaning = SymbolId{};
  if (!meaning || *meaning == enumeration) return 0;
  const bool is_promotion = !enumeration && !IsClass(context, *meaning);
  return is_promotion ? 1 : kNone;
}

void NoteType(Context& context, SymbolId symbol, const ast::VarDecl& var) {
  if (!context.file.has_enums) return;
  if (const Known meaning = MeaningOf(context, var))
    context.enum_symbols.insert_or_assign(symbol.index, *meaning);
}

void NoteValue(Context& context, ExprId value, SymbolId symbol) {
  if (!context.file.has_enums) return;
  auto known = context.enum_symbols.find(symbol.index);
  const ast::DeclId decl = context[symbol].decl;
  const auto* var = decl ? context.GetIf<ast::VarDecl>(decl) : nullptr;
  if (known == context.enum_symbols.end() && var && context[symbol].scope) {
    const ViewSwitch in(context, ViewOf(context, symbol));
    NoteType(context, symbol, *var);
    known = context.enum_symbols.find(symbol.index);
  }
  if (known != context.enum_symbols.end()) Note(context, value, known->second);
}

void NoteEnumerator(Context& context, ExprId value, SymbolId enumeration) {
  const ast::EnumDecl* decl = EnumOf(context, enumeration);
  if (!decl) return Note(context, value, std::nullopt);
  // Up to the closing brace an enumerator has the underlying type (C++ 7.2, dcl.enum).
  const auto known = context.structs.enum_values.find(enumeration.index);
  const bool is_open =
      known != context.structs.enum_values.end() && known->second.size() < decl->enumerators.size;
  Note(context, value, is_open ? SymbolId{} : enumeration);
}

void NoteCastTo(Context& context, ExprId value, ast::TypeId type) {
  if (context.file.has_enums) Note(context, value, MeaningOf(context, type));
}

void NoteChoice(Context& context, ExprId value, ExprId one, ExprId other) {
  const Known meaning = MeaningOf(context, one);
  if (context.file.has_enums && meaning == MeaningOf(context, other)) Note(context, value, meaning);
}

bool CheckEnumClass(Context& context, ast::TypeId type, ExprId value) {
  if (!context.file.has_enums || context.IsError(value)) return true;
  const Known from = ClassOf(context, MeaningOf(context, value));
  const Known to = ClassOf(context, MeaningOf(context, type));
  if (!from || !to || *from == *to) return true;
  const TypeId number = context.TypeIdOf(value);
  context.Report(context[value].span, diag::EnumClassConversion, NameOf(context, *from, number),
                 NameOf(context, *to, number));
  return false;
}

bool CheckEnumClasses(Context& context, ExprId left, ExprId right, Span span) {
  if (!context.file.has_enums || context.IsError(left, right)) return true;
  const Known one = ClassOf(context, MeaningOf(context, left));
  const Known other = ClassOf(context, MeaningOf(context, right));
  if (!one || !other || *one == *other) return true;
  context.Report(span, diag::EnumClassConversion, NameOf(context, *one, context.TypeIdOf(left)),
                 NameOf(context, *other, context.TypeIdOf(right)));
  return false;
}

bool CheckNoEnumClass(Context& context, std::string_view op, ExprId operand, Span span) {
  if (!context.file.has_enums) return true;
  const Known meaning = ClassOf(context, MeaningOf(context, operand));
  if (!meaning || !*meaning) return true;
  context.Report(span, diag::BadOperand, op, NameOf(context, *meaning, {}));
  return false;
}

}  // namespace clipc::check
