// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/stage.h"
#include "clip-table/clip_table.h"
#include "compiler/compile/facts.h"
#include "compiler/compile/message.h"
#include "compiler/compile/token_digest.h"
#include "frontend/lex/source.h"

// What a compile gives.
namespace clipc {

enum class Status : std::uint8_t {
  kOk,
  kErrors,      // the shader has errors
  kBadRequest,  // an unknown profile or pass, or a main file that cannot be read
  kCancelled,   // Limits::is_cancelled
};

// A shader as it is written.
struct ShaderOutput {
  std::string text;                  // GLSL, where it is wanted, or HLSL
  std::vector<std::uint32_t> spirv;  // of the GLSL, on request
  std::optional<Stage> stage;        // none: what lowering kDiscard adds
  friend bool operator==(const ShaderOutput&, const ShaderOutput&) = default;
};

// Everything that is made of a program without errors.
struct Outputs {
  // By stage, in the order of the request. Lowering kDiscard adds the fragment shader of the
  // request, or the include with the discard, where no shader of the program discards.
  std::vector<ShaderOutput> shaders;
  // On request: the shaders of variants[k] have the first k planes.
  std::vector<std::vector<ShaderOutput>> variants;
  std::optional<clip_table::ClipTable> table;  // with GLSL
  std::optional<Facts> facts;                  // with GLSL, on request
  std::string listing;                         // on request: OutputOptions::source_lines
};

struct CompileResult {
  Status status = Status::kOk;
  std::optional<Outputs> outputs;  // none unless kOk, and where the compile ends before them
  std::string preprocessed;        // HLSL, on request
  std::string dump;
  std::vector<Message> messages;  // in the order of the text: CollectMessages
  std::string text;               // the messages with their source lines, as a terminal shows them
  std::vector<std::string> dependencies;  // files read, each once, in the order first entered
  std::vector<Include> includes;          // every entry into an include file, in order
  std::vector<std::string> macros_used;   // on request: Source::MacrosUsed
  std::optional<TokenDigest> digest;      // the one that ProgramRequest::is_known was asked about
  bool is_repeated = false;

  bool ok() const { return status == Status::kOk; }
};

}  // namespace clipc
