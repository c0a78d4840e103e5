// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// The values of an enum class are numbers in the typed program, and converted by casts only in the
// text: DXC refuses `int a = E::b`. What is known to be of an enum class, or to be a number, is
// noted; what is neither, as a variable of a template's type, is not judged.
namespace clipc::check {

// The enum class that the variable is of; none for other types.
SymbolId EnumClassOf(Context& context, const ast::VarDecl& var);
// Whether the value is known not to be of `enumeration`, or with none not to be a number.
bool IsOfOtherEnum(const Context& context, ExprId value, SymbolId enumeration);
// Notes that the symbol is a local variable or a parameter of this type.
void NoteType(Context& context, SymbolId symbol, const ast::VarDecl& var);
// Notes that the value is that of the symbol, which has a type.
void NoteValue(Context& context, ExprId value, SymbolId symbol);
// Notes that the value is of the enum, if that is a class; between its braces it is a number.
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
