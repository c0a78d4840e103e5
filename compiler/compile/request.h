// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "backend-glsl/check_layout.h"
#include "backend-glsl/style.h"
#include "backend-glsl/target.h"
#include "base/diagnostics.h"
#include "clip-table/vocabulary.h"
#include "compiler/compile/spirv_request.h"
#include "compiler/compile/token_digest.h"
#include "frontend/check/check.h"
#include "passes/adjust_clip_space.h"

// What a compile is asked for.
namespace clipc {

// The stage whose result --dump= prints.
enum class DumpStage : std::uint8_t { kTokens, kAst, kIr, kGlsl, kTable };

// The options for people who work on clipc.
struct DebugOptions {
  // Compilation stops after this stage, which is in CompileResult::dump.
  std::optional<DumpStage> dump;
  // The names of passes. The program after each of them is appended to CompileResult::dump.
  std::vector<std::string> dump_after;
  // The name of the pass after which the first shader's compilation stops. Its program is dumped
  // unless `dump_after` dumps some.
  std::string stop_after;
  // The typed program is verified between passes, as in debug builds.
  bool verify = false;

  // Whether the options ask for a dump, or end the compile before its result.
  bool changes_result() const { return dump || !dump_after.empty() || !stop_after.empty(); }
};

// One stage of a program, as it is asked for.
struct ShaderSource {
  // A file, or "-" for standard input. When `text` is given, it is compiled instead, and `path` is
  // the label in messages and says in which folder includes are looked up. Empty, of a shader after
  // the first: the function is in the text of the first.
  std::string path = {};
  std::optional<std::string> text = {};
  std::string entry = "main";
  std::string entry_call = {};  // CheckOptions::entry_call
  std::string profile = "vs_5_0";
};

// A shader of another tool that reads what the program writes. Its interface and its layout are
// given, and the program is written to fit them: its outputs, and the constant buffers that both
// use.
struct Neighbour {
  // A file with HLSL, GLSL or SPIR-V. When `text` is given, it is read instead, and `path` is the
  // label in messages. HLSL is read with the include folders, macros and packing of the request.
  std::string path;
  std::optional<std::string> text = {};
  std::string entry = {};  // of HLSL and SPIR-V; empty: `main` of HLSL, the only one of SPIR-V
};

// The version of HLSL and the way it is read.
struct LanguageOptions {
  LanguageVersion version = LanguageVersion::k2021;
  // The number of the effect that the shaders are of, which then have a preshader,
  // CheckOptions::has_preshader; 0: they are of none. The requests with one number differ in their
  // shaders alone, whose text does not change, and a Compiler does once what several of them need.
  std::uint64_t effect = 0;
  bool call_names_parameters = false;        // CheckOptions::call_names_parameters
  std::vector<std::string> shadow_samplers;  // CheckOptions::shadow_samplers
  bool legacy_macro_expansion = false;       // read `##` as fxc from shader model 6 on too
  bool byte_matrices_by_row = false;         // CheckOptions::byte_matrices_by_row
  MatrixPacking packing = MatrixPacking::kColumnMajor;
  signature::PositionName position_name = signature::PositionName::kSystemValue;
};

// The places of the files that a shader includes.
struct IncludeOptions {
  std::vector<std::string> dirs;
  std::vector<std::string> forced;  // files, included before the first line
  std::string preamble;             // SourceInput::preamble
  // If not empty, includes come from this function, and no file is read for them:
  // SourceInput::read_include.
  std::function<std::optional<std::string>(const std::string& path)> read;
  // If not empty, include files are read only from this folder, wherever a path or a link to them
  // lies.
  std::string sandbox;
};

// The way of the clip planes.
struct PlaneOptions {
  std::optional<Lowering> lowering;  // none: DefaultLowering of the profile
  PlaneSpace space = PlaneSpace::kClip;
  // The semantic of the vertex's position, for plane space kObject; empty: POSITION0.
  std::string position_input;
  // The GLSL of a fragment shader, to which lowering kDiscard adds the discard. Without it the
  // discard is an include of its own.
  std::optional<std::string> fragment;
  // The caller reads the planes of lowering kLevel9 from the table or the reflection and gives them
  // to the device. Without that, clip planes that the GLSL does not have are an error.
  bool given_to_device = false;
  // The planes of the first shader are those of the last one before the rasteriser, which writes
  // the positions that are clipped.
  bool in_last_stage = false;
  // Fill Outputs::variants; the number is the most planes of a variant.
  std::optional<std::uint32_t> variants;
};

// The form of the GLSL and what it promises.
struct StyleOptions {
  passes::ClipSpaceOptions clip_space;
  bool separable = false;  // for program pipelines: gl_PerVertex is redeclared
  bool base_vertex_is_zero = false, base_instance_is_zero = false;  // backend-glsl/write.h
  bool precise = false;    // -Gis: every output, and what goes into it, is computed as written
  bool invariant = false;  // gl_Position is invariant: backend-glsl/write.h
  // Values of half and of min16float and the like may have 16 bits: backend-glsl/write.h.
  bool relaxed_precision = false;
  // The form of constant buffers: see backend-glsl/style.h.
  glsl::BlockStyle blocks = glsl::BlockStyle::kNamed;
  // The layout that the buffers must have, which is Direct3D's too or an error.
  glsl::BufferLayout layout = glsl::BufferLayout::kDirect3D;
  // The style of names: "hlslcc", "dxc", "spirv-cross" or a pattern for outputs. Empty: the names
  // of the neighbour, or "hlslcc" where there is none.
  std::string names;
};

// What the hull shader of a domain shader says that is compiled without it. Where neither this nor
// the file says it, the first of each is assumed, with a warning.
struct TessellationOptions {
  std::optional<ir::Partitioning> partitioning;
  std::optional<ir::OutputTopology> topology;
};

// How the outputs of a stage and the inputs of the next one are made to fit.
struct LinkOptions {
  bool keep_outputs = false;    // keep outputs that the next stage does not read
  bool zero_unwritten = false;  // unwritten inputs of the next stage become 0
};

// HLSL instead of GLSL: the main file with the planes of its entry points as clip distances. Under
// lowering kDiscard the second shader of the request discards, in a file that is an output of its
// own.
struct HlslOptions {
  bool wanted = false;
  std::vector<std::string> entries;   // beside the first shader's
  std::string wrapper_entry;          // rewrite::Options
  std::uint32_t plane_distances = 0;  // the least number of clip distances; 0: as many as planes
  bool in_one_file = false;           // the second shader is in the main file, and stays there
};

// The parts of the result that are filled besides the shaders and the table.
struct OutputOptions {
  bool glsl = true;                   // fill ShaderOutput::text, if there is SPIR-V too
  bool validate = false;              // give the GLSL to glslang before returning it
  bool source_lines = false;          // put the lines of the HLSL as comments into the GLSL
  bool listing = false;               // fill Outputs::listing
  bool facts = false;                 // fill Outputs::facts
  std::optional<SpirvRequest> spirv;  // fill ShaderOutput::spirv
  bool preprocess = false;            // fill CompileResult::preprocessed, and stop
  bool text = true;                   // fill CompileResult::text
  bool colour = false;                // put escape sequences of a terminal into `text`
};

// The limits of one compile; beyond one there is an error. Memory follows from the first two:
// some 27 bytes for each byte of text and 100 for each token of macros, measured.
struct Limits {
  std::size_t bytes = SIZE_MAX;  // of the shader and its includes, each time that one is entered
  std::size_t tokens = std::size_t{4} << 20;  // that macros add to those of the text
  std::uint32_t seconds = UINT32_MAX;
  // Asked on the thread that compiles, often except while glslang works. When it returns true, the
  // compile ends with Status::kCancelled.
  std::function<bool()> is_cancelled;
};

// A program: its shaders, and what they share.
struct ProgramRequest {
  std::vector<ShaderSource> shaders = std::vector<ShaderSource>(1);  // by stage, at least one
  std::optional<Neighbour> neighbour;  // it reads what the last shader writes
  std::vector<std::string> defines;    // "NAME" or "NAME=VALUE"
  IncludeOptions includes;
  LanguageOptions language;
  glsl::Target target = *glsl::Target::Parse("glsl450");
  PlaneOptions planes;  // of the shader that PlaneStage names
  StyleOptions style;
  LinkOptions link;
  TessellationOptions tessellation;
  HlslOptions hlsl;
  OutputOptions outputs;
  WarningOptions warnings;
  Limits limits;
  DebugOptions debug;

  // The first shader, which is the only one of most programs.
  ShaderSource& first() { return shaders.front(); }
  const ShaderSource& first() const { return shaders.front(); }

  // The shader that has the file of shader `number`: itself or the first.
  const ShaderSource& FileOf(std::size_t number) const {
    return shaders[number].path.empty() ? first() : shaders[number];
  }

  // The number of the last shader before the rasteriser, whose positions are clipped; of the first
  // one where there is none.
  std::size_t PlaneStage() const;

  // Whether a shader of the program is fitted to what reads its outputs.
  bool is_linked() const { return shaders.size() > 1 || neighbour; }

  bool record_macros = false;  // fill CompileResult::macros_used
  // Asked about the text after preprocessing, if nothing else decides the result; when it returns
  // true, the compile ends there, with CompileResult::is_repeated.
  std::function<bool(const TokenDigest& digest)> is_known;
};

}  // namespace clipc
