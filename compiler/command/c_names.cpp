// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/command/c_names.h"

#include <algorithm>
#include <iterator>

namespace clipc {
namespace {

constexpr std::string_view kKeywords[] = {
    "_Alignas",
    "_Alignof",
    "_Atomic",
    "_BitInt",
    "_Bool",
    "_Complex",
    "_Decimal128",
    "_Decimal32",
    "_Decimal64",
    "_Generic",
    "_Imaginary",
    "_Noreturn",
    "_Static_assert",
    "_Thread_local",
    "alignas",
    "alignof",
    "and",
    "and_eq",
    "asm",
    "auto",
    "bitand",
    "bitor",
    "bool",
    "break",
    "case",
    "catch",
    "char",
    "char16_t",
    "char32_t",
    "char8_t",
    "class",
    "co_await",
    "co_return",
    "co_yield",
    "compl",
    "concept",
    "const",
    "const_cast",
    "consteval",
    "constexpr",
    "constinit",
    "continue",
    "decltype",
    "default",
    "delete",
    "do",
    "double",
    "dynamic_cast",
    "else",
    "enum",
    "explicit",
    "export",
    "extern",
    "false",
    "float",
    "for",
    "friend",
    "goto",
    "if",
    "inline",
    "int",
    "long",
    "mutable",
    "namespace",
    "new",
    "noexcept",
    "not",
    "not_eq",
    "nullptr",
    "operator",
    "or",
    "or_eq",
    "private",
    "protected",
    "public",
    "register",
    "reinterpret_cast",
    "requires",
    "restrict",
    "return",
    "short",
    "signed",
    "sizeof",
    "static",
    "static_assert",
    "static_cast",
    "struct",
    "switch",
    "template",
    "this",
    "thread_local",
    "throw",
    "true",
    "try",
    "typedef",
    "typeid",
    "typename",
    "typeof",
    "union",
    "unsigned",
    "using",
    "virtual",
    "void",
    "volatile",
    "wchar_t",
    "while",
    "xor",
    "xor_eq",
};

}  // namespace

bool IsKeywordInC(std::string_view name) { return std::ranges::binary_search(kKeywords, name); }

bool IsMacroInC(std::string_view name) {
  constexpr std::string_view kAlone[] = {"NULL", "linux", "offsetof", "unix"};
  constexpr std::string_view kKinds[] = {"INT",        "UINT",  "PTRDIFF", "SIZE",
                                         "SIG_ATOMIC", "WCHAR", "WINT"};
  constexpr std::string_view kEnds[] = {"_MAX", "_MIN", "_WIDTH"};
  const auto begins = [&](std::string_view kind) { return name.starts_with(kind); };
  const auto ends = [&](std::string_view end) { return name.ends_with(end); };
  return std::ranges::find(kAlone, name) != std::end(kAlone) ||
         (std::ranges::any_of(kKinds, begins) && std::ranges::any_of(kEnds, ends));
}

}  // namespace clipc
