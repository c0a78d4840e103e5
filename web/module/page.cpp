// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A function that the page calls beside those of module.cpp and runtime/clipc_runtime.h: it writes
// SPIR-V as text.
#include <cstddef>
#include <string>

#include "compiler/clipc.h"
#include "compiler/compile/list_spirv.h"

#define CLIPC_EXPORT(name) __attribute__((export_name(#name)))

extern "C" {

// Writes `words`, a SPIR-V module that clipc made, as text. The text lives until the next call.
CLIPC_EXPORT(clipc_module_disassemble)
const clipc_bytes* clipc_module_disassemble(const unsigned* words, std::size_t count) {
  static std::string text;
  static clipc_bytes bytes;
  text = clipc::ListSpirv({words, words + count});
  bytes = {text.data(), text.size()};
  return &bytes;
}

}  // extern "C"
