// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "backend-glsl/target.h"
#include "legalize/shape.h"

namespace clipc::glsl {

using legalize::Shape;

// A function that GLSL, or an older version of it, lacks. In the text $N is its name, $T the type
// of its first argument, $B $I $U $F the bool, int, uint and float types of the same size, $0 its
// zero, and @name another snippet for the same type.
struct SnippetText {
  std::string_view name;  // HLSL's name, or clipc's own as in "determinant2"
  enum Kind : char {
    kFloat = 'f',
    kInt = 'i',
    kUint = 'u',
    kAny = 'a'
  } kind;            // of the first argument
  bool scalar_only;  // vectors are done component by component
  std::string_view text;
};

// Returns the snippet for a first argument of this shape; null if there is none.
const SnippetText* FindSnippet(std::string_view name, const Shape& shape);
std::string Expand(const SnippetText& snippet, std::string_view function, const Shape& shape,
                   bool has_unsigned,
                   const std::function<std::string(std::string_view)>& name_of_other);

}  // namespace clipc::glsl
