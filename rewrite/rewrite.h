// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "frontend/lex/source.h"
#include "rewrite/pixel_wrapper.h"
#include "rewrite/wrapper.h"

// HLSL with clip planes to HLSL with clip distances. The text is the user's but for what the
// planes ask for.
namespace clipc::rewrite {

// A token of the source that is the name of an entry function.
struct Use {
  enum class Kind : std::uint8_t {
    kCall,
    kDeclaration,  // of a function, this one or another
    kOther,        // a field, a variable, or `compile vs_5_0 main()` of an effect
  };
  Span span;
  Kind kind = Kind::kOther;
};

// An entry point with clip planes, or the pixel shader that discards for them.
struct Entry {
  const Source* source = nullptr;  // of the spans
  Diagnostics* diagnostics = nullptr;
  EntryPoint point;
  PlaneForm form;
  std::optional<PixelForm> pixel;
  std::size_t planes = 0;
  std::vector<Use> uses;  // in the order of the text
};

struct Options {
  // The name of the vertex shader's wrapper. Empty: the wrapper takes the entry's name, and the
  // entry function gets another one. That of a pixel shader always does so.
  std::string wrapper_entry;
  // The most planes of a variant: beside the entry with all planes there are NAME_0, NAME_1 .. with
  // the first 0, 1 .. of them.
  std::optional<std::uint32_t> variants;
  bool source_lines = false;  // #line, so that the lines of the user's text keep their numbers
  std::string path;           // the name of the main file for #line
};

// Returns the text of a main file in which
//
// - the attributes with the planes are removed. Those that a macro or an include makes stay, under
//   a name that no compiler knows: a #define at the beginning of the file says so;
// - the entry functions are renamed, in the text or by a #define where that cannot be;
// - a wrapper follows each entry function: WriteWrapper, WritePixelWrapper.
//
// Lowering::kNone of an entry removes the attribute alone. `text` is the main text of all entries'
// sources. Reports what cannot be rewritten to the diagnostics of its entry; the result is only
// meaningful if none of these has errors.
std::string Rewrite(const std::string& text, std::span<const Entry> entries,
                    const Options& options);

}  // namespace clipc::rewrite
