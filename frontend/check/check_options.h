// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "frontend/lex/source.h"
#include "frontend/signature/semantics.h"
#include "ir/profile.h"

// What the check of a shader is asked for.
namespace clipc {

// The layout of matrices in memory if neither a qualifier nor #pragma pack_matrix gives one: the
// options -Zpc (the default) and -Zpr.
enum class MatrixPacking : std::uint8_t { kColumnMajor, kRowMajor };

struct CheckOptions {
  // The rules of that version of the language, which hold from shader model 6 on; the older shader
  // models have one language. Options that are not of the language have their defaults.
  static CheckOptions For(ir::Profile profile, LanguageVersion language);

  ir::Profile profile;
  std::string entry = "main";  // may be qualified: "NS::main"
  // The functions whose `[clipplanes]` the entry has in place of its own, those of the stages
  // before in the same file.
  std::vector<std::string> planes_entries = {};
  // "Main(true, 4)", as a technique of the file compiles the entry: the arguments are the values of
  // its `uniform` parameters. Empty: these are uniforms.
  std::string entry_call;
  // Whether the call has an argument for every parameter of the entry, "Main(v_in, true)", and
  // those without a semantic have the value of theirs: OBS Studio's effects.
  bool call_names_parameters = false;
  // Whether an effect has the shader, whose preshader computes what depends on uniforms alone.
  bool has_preshader = false;
  MatrixPacking packing = MatrixPacking::kColumnMajor;
  // Whether clip planes go to SetClipPlane (the level9 lowering), which takes whole registers only:
  // anything less is reported (X4594).
  bool whole_register_planes = false;
  signature::PositionName position_name = signature::PositionName::kSystemValue;
  // Whether `&&`, `||` and `?:` of scalars evaluate only the operands that decide the value, as
  // they do in HLSL 2021 (dxc's "Logical Operation Short Circuiting"). Before it, both sides are
  // evaluated.
  bool short_circuits = false;
  // Whether a Store of a byte address buffer stores a value of any type, bit by bit, as it does
  // from HLSL 2018 on. Before it, the value is converted to uint.
  bool stores_any_type = false;
  // Whether matrices lie row by row in byte address buffers, as in the SPIR-V of older releases of
  // dxc.
  bool byte_matrices_by_row = false;
  // What the versions of the language differ in: whether there are templates (from 2021 on) and
  // enums (from 2017 on), whether a struct becomes another only by a cast, and whether a variable
  // of a loop's head ends with the loop, as in C++ (both from 2021 on).
  LanguageVersion language = LanguageVersion::k2021;
  bool has_templates = true, has_enums = true;
  bool casts_structs = false, scopes_loops = false;
  // The names of the samplers of a pixel shader that Direct3D 9's driver compares:
  // resolve::CompareSamplers.
  std::vector<std::string> shadow_samplers;
  // Whether the program has the objects and constant buffers that nothing reaches.
  bool keeps_bindings = false;
  bool is_interface_only = false;    // ir::Program::is_interface_only
  bool stages_match_by_row = false;  // signature::EntrySignature::stages_match_by_row
};

}  // namespace clipc
