// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <string_view>

#include "compiler/compile/facts.h"

namespace clipc {

// The text of --reflect=FILE.h: a header for C99 and C++ with a struct for each constant buffer,
// which has the buffer's bytes, and assertions of its offsets and size. A vector is an array; so is
// a matrix, as it lies in memory; structs are structs. What has no such type, an array whose
// elements are padded but for the last one, is an array of 4-byte numbers. Names that are keywords
// of C or C++, or macros, get a `_`; names of structs begin with `prefix`.
//
// The structs of a pair's pixel shader come after those of the first.
std::string WriteStructs(const Facts& facts, std::string_view prefix);

}  // namespace clipc
