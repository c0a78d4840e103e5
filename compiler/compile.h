// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "clip-table/clip_table.h"
#include "compiler/message.h"

// clipc as a library: one HLSL vertex shader in, GLSL and what the host must know out.
namespace clipc {

enum class MatrixOrder : std::uint8_t { kColumnMajor, kRowMajor };  // -Zpc, -Zpr
enum class DepthRange : std::uint8_t {
  kZeroToOne,
  kNegativeOneToOne
};  // of gl_Position after perspective division
enum class Stage : std::uint8_t { kTokens, kAst, kIr, kGlsl, kTable };  // --dump=

struct CompileRequest {
  std::string path;  // a file, or "-": standard input; a label and a folder when `text` is given
  std::optional<std::string> text;  // compile this instead of reading `path`
  std::vector<std::string> include_dirs;
  std::vector<std::string> defines;  // "NAME" or "NAME=VALUE"

  std::string profile = "vs_5_0";
  std::string entry = "main";
  MatrixOrder matrices = MatrixOrder::kColumnMajor;

  std::string target = "glsl450";
  // None: kLevel9 for the level_9_x profiles, kClipDistance for the others.
  std::optional<Lowering> lowering;
  // What the planes are dotted with: kXyw1 and kObject are for lowerings kClipDistance, kNearPlane
  // and kDiscard, and the application then gives other constants (docs/runtime.md, "Plane spaces").
  PlaneSpace plane_space = PlaneSpace::kClip;
  std::string
      position_input;  // with kObject: the semantic of the vertex's position; empty: POSITION0
  DepthRange depth_range = DepthRange::kZeroToOne;
  bool flip_y = false;
  bool separable = false;  // for program pipelines: gl_PerVertex is redeclared
  // With lowering kDiscard: the GLSL of a fragment shader, to which the discard is added; none: it
  // is an include of its own.
  std::optional<std::string> fragment;
  bool variants = false;                  // fill CompileResult::variants
  std::size_t variant_planes = SIZE_MAX;  // the most planes that one of them has

  WarningOptions warnings;
  bool validate = false;  // give the GLSL to glslang before returning it
  bool reflect = false;   // fill CompileResult::reflection
  bool verify = false;    // check the typed program between passes, as debug builds always do
  bool draw_text = true;  // fill CompileResult::text
  bool colour = false;    // in it

  std::optional<Stage> dump;  // stop there; the stage is in CompileResult::dump
  std::vector<std::string>
      dump_after;  // passes; the program after each is appended to CompileResult::dump
  std::string
      stop_after;  // a pass: stop behind it; the program is dumped unless dump_after dumps some
};

enum class Status : std::uint8_t {
  kOk,
  kErrors,      // the shader has errors
  kBadRequest,  // an unknown profile, target or pass, or a main file that cannot be read
};

// The shader with the first so many of its clip planes.
struct Variant {
  std::string glsl;
  std::string fragment;
};

struct CompileResult {
  Status status = Status::kOk;
  std::string glsl;      // empty unless kOk, and when stopped before it
  std::string fragment;  // with lowering kDiscard: the fragment shader, or what to include there
  std::vector<Variant>
      variants;  // on request: [k] has the first k planes, as far as variant_planes
  std::optional<clip_table::ClipTable> table;  // with `glsl`
  std::string reflection;                      // JSON, with `glsl`, on request
  std::string dump;
  std::vector<Message> messages;  // in the order of discovery
  std::string text;               // the messages with their source lines, as a terminal shows them
  std::vector<std::string> dependencies;  // files read, each once, in the order first entered

  bool ok() const { return status == Status::kOk; }
};

// Compiles many shaders; keeps what they share. Use one per thread. Nothing is thrown out of
// Compile, whatever the request is; the same request gives the same result, byte for byte.
class Compiler {
 public:
  Compiler();
  ~Compiler();
  Compiler(const Compiler&) = delete;
  Compiler& operator=(const Compiler&) = delete;

  CompileResult Compile(const CompileRequest& request);

 private:
  struct Shared;
  std::unique_ptr<Shared> shared_;
};

// One shader. May be called on several threads at once.
CompileResult Compile(const CompileRequest& request);

}  // namespace clipc
