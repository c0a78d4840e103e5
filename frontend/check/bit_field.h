// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>

#include "frontend/check/context.h"

// The bit-fields of HLSL 2021, `uint a : 3`. Those of one type that follow each other share an int
// or a uint, from the lowest bit up, as DXC lays them out; one that does not fit begins the next.
// The typed program has that number as a field, and shifts and masks where a bit-field is used.
namespace clipc::check {

// Adds the bit-field to the struct that is being resolved, where the symbol is declared. Returns
// false after an error, which was reported.
bool AddBitField(Context& context, const ast::VarDecl& var, TypeId structure, SymbolId symbol,
                 Field field);
// The field, or the bit-field, of the object to which `owner`, the object's type or a base of it,
// gives this name; none if it gives none.
ExprId FieldNamed(Context& context, ExprId object, TypeId owner, Name name, Span span);
// The value of the bit-field of an object of its struct's type, as FieldNamed returns it.
ExprId ReadBits(Context& context, ExprId object, const BitField& bits, Span span);
// The number in which the bit-field has the value, and every other bit is 0.
ExprId PlaceBits(Context& context, ExprId value, const BitField& bits);
// Whether FieldNamed returned the value of a bit-field.
bool IsBitField(const Context& context, ExprId value);
// The assignment bits = value, or bits op= value: `bits` is what FieldNamed returned.
ExprId AssignToBits(Context& context, std::optional<BinaryOp> op, ExprId bits, ExprId value,
                    Span span);
// The increment or decrement of what FieldNamed returned.
ExprId IncrementBits(Context& context, UnaryOp op, ExprId bits, Span span);
// Whether a value of the type has bit-fields in it.
bool HoldsBits(const Context& context, TypeId type);
// Whether one of the types has bit-fields, so that there is no conversion between them. Reports it.
bool RefusesBits(Context& context, TypeId from, TypeId to, Span span);

}  // namespace clipc::check
