// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/arena.h"
#include "ir/emission.h"
#include "ir/expr.h"
#include "ir/ids.h"
#include "ir/interface.h"
#include "ir/profile.h"
#include "ir/stmt.h"
#include "ir/tessellation.h"
#include "ir/type.h"
#include "ir/variable.h"

// The meaning of a shader: names resolved, every conversion explicit, every node typed.
//
// Values are HLSL's. A vector has columns components; a matrix has rows x columns, M[i] is row i,
// mul() is HLSL's, and how a matrix lies in memory is a property of the variable or field that
// holds it (row_major), never of a value. Operands of one operator have the same type, unless the
// node says otherwise. Arguments are evaluated left to right. Every expression has exactly one
// parent; Verify says so.
namespace clipc::ir {

// The promises that a program keeps. Each form includes the ones before it. Verify(program, form)
// checks them.
enum class Form : std::uint8_t {
  kTyped,            // objects are values, and a sampler's kind is that of each use
  kResolved,         // as Check returns it: an object is a global variable or an element of one
  kNoClipPlanes,     // clip planes are outputs, or entries of the table only: none has a value
  kTargetClipSpace,  // kPosition is in the target's clip space
  kInlined,          // main may hold the entry's statements; then the entry is empty
  kLegalized,        // operators are those of C-like shading languages: see ir/verify_legal.cpp
  kAddressed,        // memory is read and written as such languages do: by elements of buffers
};

struct Program {
  Profile profile;
  Stage stage = Stage::kVertex;  // the rules by which the program was checked
  // Only the inputs and constant buffers that the stage before must match are of interest: what
  // clipc cannot translate is a zero, and no GLSL is written.
  bool is_interface_only = false;
  // Whether CheckOptions::shadow_samplers names some: until CompareSamplers, tex2Dlod and tex2Dbias
  // keep the third coordinate.
  bool keeps_third_coordinate = false;
  TypeTable types;
  Arena<Expr> exprs;
  Arena<Stmt> stmts;
  Arena<Var> vars;
  Arena<Function> functions;
  Arena<Cbuffer> cbuffers;
  Pool<ExprId> expr_lists;
  Pool<StmtId> stmt_lists;
  Pool<SwitchCase> switch_cases;

  FunctionId entry;  // the user's function
  // The generated function without parameters and result: it reads the inputs, calls the entry
  // once, and writes the outputs, which in a stage that emits vertices Stream::emit does.
  FunctionId main;
  IoVars inputs, outputs;
  std::vector<DistancePiece> distances;    // of the inputs and outputs, by hand
  std::vector<OutputGroup> output_groups;  // where the next stage is known
  // The kStatic, kShared and kConstant variables at global scope that are reached, in order of
  // declaration.
  std::vector<VarId> globals;
  std::vector<Resource> resources;  // the objects that are reached, in order of declaration
  std::vector<ClipPlane> clip_planes;
  bool tests_early = false;  // [earlydepthstencil]: depth and stencil are tested before it runs
  // [numthreads]: the threads of a group in x, y and z; 0 in a stage that does not run in groups.
  std::array<std::uint32_t, 3> group_size = {};
  // The constants with a Var::constant_id that [numthreads] names; none: a number that stays.
  std::array<VarId, 3> group_size_constants = {};
  Emission emission;          // of a stage that emits vertices
  Tessellation tessellation;  // of a stage that makes or reads patches
  Form form = Form::kResolved;
  // Whether a method of an object, and whether NonUniformResourceIndex, was ever called: a search
  // for such calls need not look at the nodes of other programs.
  bool calls_objects = false, calls_nonuniform = false;
};

}  // namespace clipc::ir
