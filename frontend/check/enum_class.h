// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// The values of an enum class are numbers in the typed program, and converted by casts only in the
// text: DXC refuses `int a = E::b`. What is known to be of an enum class, or to be a number, is
// noted; what is neither, as a variable of a template's type, is not judged. The values of
// other enums are noted too, since functions may be overloaded on them.
namespace clipc::check {

// The enum that the variable is of; none for other types.
SymbolId EnumOf(Context& context, const ast::VarDecl& var);
// What it adds to the cost of a call (CostOf) that the value is passed to a parameter of the enum,
// or with none of a number: a little where an enum becomes a number, more than any conversion where
// there is none.
std::uint64_t EnumCost(const Context& context, ExprId value, SymbolId enumeration);
// Notes that the symbol is a local variable or a parameter of this type.
void NoteType(Context& context, SymbolId symbol, const ast::VarDecl& var);
// Notes that the value is that of the symbol, which has a type.
void NoteValue(Context& context, ExprId value, SymbolId symbol);
// Notes that the value is of the enum; between its braces it is a number.
void NoteEnumerator(Context& context, ExprId value, SymbolId enumeration);
// Notes that the value is what a cast to the type makes.
void NoteCastTo(Context& context, ExprId value, ast::TypeId type);
// Notes that the value is one of two.
void NoteChoice(Context& context, ExprId value, ExprId one, ExprId other);
// Whether the value may become one of the type; reports if not.
bool CheckEnumClass(Context& context, ast::TypeId type, ExprId value);
// Whether both are of one enum class, or neither is of one; reports if not.
bool CheckEnumClasses(Context& context, ExprId left, ExprId right, Span span);
// Whether the operand is of no enum class; reports if not.
bool CheckNoEnumClass(Context& context, std::string_view op, ExprId operand, Span span);

}  // namespace clipc::check
