// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "clip-table/clip_table.h"
#include "compiler/facts.h"
#include "compiler/message.h"
#include "compiler/token_digest.h"
#include "frontend/lex/source.h"

// What a compile gives.
namespace clipc {

enum class Status : std::uint8_t {
  kOk,
  kErrors,      // the shader has errors
  kBadRequest,  // an unknown profile or pass, or a main file that cannot be read
  kCancelled,   // Limits::is_cancelled
};

struct Shaders {
  std::string vertex;
  // The pixel shader of a pair. Otherwise the fragment shader of lowering kDiscard, or the include
  // with the discard; empty for other lowerings.
  std::string fragment;
  friend bool operator==(const Shaders&, const Shaders&) = default;
};

struct CompileResult {
  Status status = Status::kOk;
  Shaders shaders;                  // empty unless kOk, and when compilation stopped before them
  std::vector<Shaders> variants;    // on request: variants[k] has the first k planes
  std::optional<std::string> hlsl;  // on request, instead of all that comes with `shaders`
  std::optional<clip_table::ClipTable> table;  // with `shaders`
  std::optional<Facts> facts;                  // with `shaders`, on request
  std::vector<std::uint32_t> spirv;            // of `shaders.vertex`, on request
  std::vector<std::uint32_t> pixel_spirv;      // of `shaders.fragment` of a pair, on request
  std::string listing;       // with `shaders`, on request: see OutputOptions::source_lines
  std::string preprocessed;  // HLSL, on request
  std::string dump;
  std::vector<Message> messages;  // in the order of the text: CollectMessages
  std::string text;               // the messages with their source lines, as a terminal shows them
  std::vector<std::string> dependencies;  // files read, each once, in the order first entered
  std::vector<Include> includes;          // every entry into an include file, in order
  std::vector<std::string> macros_used;   // on request: Source::MacrosUsed
  std::optional<TokenDigest> digest;      // the one that CompileRequest::is_known was asked about
  bool is_repeated = false;

  bool ok() const { return status == Status::kOk; }
};

}  // namespace clipc
