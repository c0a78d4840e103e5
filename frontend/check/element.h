// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// Elements of writable objects as targets: `buffer[i]`, and parts of them. A store to a part of an
// element of a structured buffer writes that part alone, since other invocations may change the
// others at the same time: fxc's store_structured has a mask and a byte offset, and DXC stores each
// component that is written ("gep + store", EmitStoreThroughExtVectorComponentLValue).
namespace clipc::check {

// The read of a writable object that a path of fields, indices and swizzles starts at, `buffer[i]`
// in `buffer[i].x`; none for other expressions.
ExprId ElementIn(const Context& context, ExprId expr);
// Whether the value is the same whatever the shader writes: that of a literal, a constant or a
// uniform.
bool StaysTheSame(const Context& context, ExprId value);
// Evaluates what chooses a path in a variable or in an element that ElementIn found, before what
// follows: the path can then be cloned. What is evaluated later may change what the indices read if
// `may_change` says so.
void FixIndices(Context& context, ExprId path, bool may_change, Exprs& prologue);
// An assignment to an element of an object or to a part of one. If it `is_used`, it is a part of an
// expression, and has the value that was stored.
struct ElementTarget {
  ExprId element, target;
  bool is_used = false;
};
// The assignment target = value, of the same type, as stores into the object. None if no store
// writes the target alone: ChangeElement can.
ExprId StoreToElement(Context& context, const ElementTarget& to, ExprId value, Span span);
// Turns `element` in `target` into a variable that holds the value read, so that `target` can be
// changed in place. Returns the stores of what may have changed into the object, which come after.
// `prologue` must come before; `may_change` as in FixIndices.
Exprs ChangeElement(Context& context, ExprId element, ExprId target, bool may_change,
                    Exprs& prologue);

}  // namespace clipc::check
