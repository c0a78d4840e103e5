// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "frontend/check/check_options.h"
#include "frontend/parse/ast.h"
#include "ir/program.h"

// The entry point alone, for a tool that leaves the rest of the file as it is.
namespace clipc {

// A parameter of the entry function, as HLSL: "uniform float4x4 m[2] : NORMAL = 1" is `before` +
// name + `after` + `initial`.
struct EntryParameterText {
  std::string before, name, after;  // the name of an unnamed parameter is empty
  std::string initial;              // " = 1", or empty
  bool is_out = false;              // out or inout
  bool is_in = true;                // in or inout
};

// The entry function, its clip planes and the places in the text that they are written at. The
// strings are HLSL in which no macro is left.
struct EntryPoint {
  ir::Program program;  // whose functions have no bodies if they were not checked
  std::string name;
  std::string scope;       // the namespaces around it, "A::B::"; empty: none
  std::string attributes;  // without the clip planes: "[RootSignature(\"\")]\n"
  // "precise noperspective float4", ": SV_Position".
  std::string return_type, return_semantic;
  std::string result_type;  // that of a local variable with the result: "precise float4"
  std::vector<EntryParameterText> parameters;
  std::vector<std::string> planes;  // the operands
  // The entry function's name and the first names of the operands and of the result's type: a local
  // variable may not hide them.
  std::vector<std::string> not_hidden;
  // What text may be put before a name so that the file has no such name: "clipc_".
  std::string prefix;

  // The attributes with the planes; an empty Span for one that shares its brackets with others.
  std::vector<Span> clip_planes;
  std::vector<std::string> clip_plane_words;  // their names as written, "clipplanes"
  std::vector<Span>
      shader_kinds;         // the attributes [shader("vertex")], which the wrapper takes over
  std::vector<Span> names;  // the function's name in its definition and its prototypes
  std::vector<Span> declarations;  // these, whole
  Span definition;
  std::string unnamed_type;  // not empty: the parameter, or the result, with a type without a name
};

// The value of an input or output in the entry function: that of a parameter, or a part of it.
struct EntryAccess {
  std::size_t parameter = 0;  // the number of parameters: the result
  std::string path;           // ".nested.position", ".positions[1]"
  ir::TypeId type;
};
EntryAccess AccessOf(const EntryPoint& entry, const ir::IoVar& io);

// Whether the bodies that the entry function reaches are checked. Otherwise the program has the
// signature and the planes alone, and a mistake elsewhere is not reported.
enum class EntryBodies : std::uint8_t { kCheck, kLeave };

// Finds the entry point and checks its signature and its clip planes, with the rules of Check. The
// result is meaningful only when `diagnostics` has no errors afterwards.
EntryPoint CheckEntryPoint(const ast::File& file, const CheckOptions& options, EntryBodies bodies,
                           Diagnostics& diagnostics);

// Whether a function of the name `entry`, which may be qualified, has clip planes or an attribute
// that is spelled nearly so; also if the file has the attribute and no such function.
bool MayHaveClipPlanes(const ast::File& file, const std::string& entry);

}  // namespace clipc
