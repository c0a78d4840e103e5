// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "clip-table/clip_table.h"

namespace clipc::clip_table {

// Calls visit(key, member) for each member of a Constant, const or not, with its key in JSON. Every
// text form lists them in this order.
template <typename MaybeConst, typename Visit>
void ForEachMember(MaybeConst& constant, Visit&& visit) {
  visit("cbuffer", constant.cbuffer);
  visit("cbuffer_element", constant.cbuffer_element);
  visit("register", constant.register_number);
  visit("space", constant.register_space);
  visit("float4_register", constant.float4_register);
  visit("byte_offset", constant.byte_offset);
  visit("glsl_block", constant.glsl_block);
  visit("glsl_member", constant.glsl_member);
}

// The table in JSON, all of it ASCII: indented and ending in a newline, or in one line without a
// newline.
std::string JsonText(const ClipTable& table, bool one_line);

}  // namespace clipc::clip_table
