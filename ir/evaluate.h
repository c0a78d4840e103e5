// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ir/program.h"

// The reference evaluator: runs `main` on the CPU, so that tests can say what a shader means and
// that a pass changed only what it says. One rounding per operation, in the order written: dot, mul
// and the like multiply first, then add from left to right, and nothing is fused. Where HLSL or the
// Direct3D 11.3 functional specification leaves a choice:
//
// * Functions such as sin, exp and pow are computed in double and rounded once; a GPU may differ by
//   its error bound.
// * Denormals are kept; Direct3D 11 flushes them to zero, shader model 6 lets the compiler choose.
// * An array, vector or matrix index out of bounds reads EvalOptions::undefined, and a write there
//   is dropped; bytes after the end of a cbuffer are 0.
// * A variable without initialiser is EvalOptions::undefined, and so are the outputs that the
//   shader does not write.
// * x / 0u and x % 0u are 0xffffffff (udiv). Signed division is what fxc makes of udiv: on the
//   magnitudes, then the sign; so 5 / 0 is -1, -5 / 0 is 1, and INT_MIN / -1 is INT_MIN.
// * x % y and fmod of floats are x - y * trunc(x / y), in three roundings.
// * pow(x, y) is exp2(y * log2(x)): NaN for x < 0, and for pow(0, 0).
// * normalize multiplies by rsqrt(dot(x, x)); lerp is x + s * (y - x); determinant expands along
//   the first row; the mantissa of frexp is positive.
// * A derivative is the difference within the row or column of the pixel itself, the finest that
//   Direct3D allows. It is undefined where not all four pixels of the quad compute it.
// * A pixel that is discarded runs on, and writes no object from then on.
// * The threads of a group run one after the other from one wait for the group to the next. Memory
//   that they share begins as EvalOptions::undefined.
// * A lane of a wave is active at a call if it runs the call in the same iterations of all loops
//   around it as the lane that asks. Sums go from the lowest lane to the highest; the value of a
//   lane that is not active is EvalOptions::undefined.
namespace clipc::ir {

// The components of one input or output as Literal holds them; for an array (clip distances), its
// elements.
using IoBits = std::array<std::uint64_t, 8>;
using IoNumbers = std::array<double, 8>;

// A read through a texture or buffer object, for the test to answer.
struct ObjectRequest {
  ObjectOp op;
  VarId object;
  std::uint32_t object_element = 0;  // of an array of objects
  VarId sampler = {};                // none for an operation without a sampler
  std::uint32_t sampler_element = 0;
  // The components of the other operands but steps, as Literal holds them, and where those of each
  // kind are. Of() gives the components of the operands of a kind.
  std::span<const std::uint64_t> words = {};
  std::array<OperandRun, kOperandKinds> runs = {};
  // The coordinate of each pixel of the quad, in the order of RunQuad, for an operation that takes
  // its level of detail from them: NaN where not all pixels run it. Empty for every other
  // operation, and in a stage without neighbours.
  std::span<const double> coordinates = {};
  // Where a store or an atomic operation changes a part of an element: the number of its first
  // component, counted through structs, arrays and matrices.
  std::optional<std::uint32_t> part = std::nullopt;
  // The kind of the value of an atomic operation, which is that of a word of bytes.
  Scalar kind = Scalar::kUint;

  std::span<const std::uint64_t> Of(OperandKind kind) const {
    const OperandRun& run = runs[static_cast<std::size_t>(kind)];
    return words.subspan(run.first, run.count);
  }
};

struct EvalOutputs {
  std::vector<IoBits> values;        // by index into Program::outputs; floats rounded to float
  std::vector<IoNumbers> numbers;    // `values` as numbers, unrounded with in_double
  bool wrote_out_of_bounds = false;  // an assignment was dropped
  bool is_discarded = false;         // the pixel is not drawn: the outputs do not matter
};

struct EvalInputs {
  // The inputs by index into Program::inputs; a missing one is zero.
  std::vector<IoBits> values;
  // The same for each vertex of the primitive, in a stage that emits vertices: of the inputs that
  // it reads at a vertex.
  std::vector<std::vector<IoBits>> vertices = {};
  // The bytes of the cbuffers by index, as the application uploads them, in HLSL packing; missing
  // ones are zero. Buffer e of an array of ConstantBuffers starts at byte e * Cbuffer::size.
  std::vector<std::vector<std::uint8_t>> cbuffers;
  // Fills in the components of the result, which start as zeros. If it is empty, all reads give
  // zero.
  std::function<void(const ObjectRequest&, std::span<std::uint64_t> result)> read_object;
  // Called before `main` begins: RunQuad runs it several times. It may be empty.
  std::function<void()> start;
  // In a stage that makes patches, the control point that runs, and what the others wrote.
  std::uint32_t point = 0;
  std::vector<EvalOutputs> points = {};
  // Returns a function that gives the objects what they hold now. RunGroup calls both where lanes
  // of a wave ask each other: the wave runs several times. It may be empty.
  std::function<std::function<void()>()> remember = {};
};

struct EvalOptions {
  // The number of statements and calls that may run: a shader that loops forever ends with an
  // error.
  std::uint64_t step_limit = 10'000'000;
  // Computes all floats in double, as a yardstick for the rounding errors of float: cbuffers,
  // inputs and literals are the same floats, only results differ. Comparisons may then take another
  // branch.
  bool in_double = false;
  // The first component of a value that HLSL leaves undefined, converted to its kind; the second
  // component is twice as large, and so on. Out-of-bounds reads also flip sign pseudo-randomly,
  // depending on this value. Comparing two runs with different values shows which outputs depend on
  // undefined values.
  double undefined = 0;
};

// A vertex that a shader emits, with the outputs that it has then.
struct EvalVertex {
  std::uint32_t stream = 0;
  bool starts_strip = false;  // it is the first of the stream, or the first after RestartStrip
  EvalOutputs outputs;
};

// Either outputs or an error.
struct EvalResult {
  EvalOutputs outputs;
  std::vector<EvalVertex> vertices = {};  // of a stage that emits vertices, in their order
  std::string error;                      // empty if `main` ran to the end
  explicit operator bool() const { return error.empty(); }
};

// Runs Program::main. `program` must satisfy Verify.
EvalResult RunMain(const Program& program, const EvalInputs& inputs,
                   const EvalOptions& options = {});

// Runs Program::main for the pixels (x, y), (x + 1, y), (x, y + 1) and (x + 1, y + 1) of a quad in
// step, where y grows downwards as in Direct3D.
inline constexpr std::size_t kQuadPixels = 4;
std::array<EvalResult, kQuadPixels> RunQuad(const Program& program,
                                            const std::array<EvalInputs, kQuadPixels>& pixels,
                                            const EvalOptions& options = {});

struct PatchResult {
  std::vector<EvalOutputs> points;  // by control point; the first has the constants of the patch
  std::string error = {};           // empty if all ran to the end
  explicit operator bool() const { return error.empty(); }
};
// Runs Program::main for the control points of a patch, of a stage that makes patches. The first
// control point is the last that runs: it reads what the others wrote.
PatchResult RunPatch(const Program& program, const EvalInputs& inputs,
                     const EvalOptions& options = {});

// A group that a dispatch runs.
struct GroupRun {
  std::array<std::uint32_t, 3> group = {};  // SV_GroupID
  bool is_reversed = false;                 // the last thread runs first
  // WaveGetLaneCount(), from 4 to 128. Thread i of the group (SV_GroupIndex) is lane i % lanes of
  // its wave number i / lanes; the last wave may have fewer threads.
  std::uint32_t lanes = 8;
};
struct GroupResult {
  // Empty if all threads ran to the end, and no two raced for the memory that they share: then
  // what they stored does not depend on which of them was first, but for atomic operations and
  // objects.
  std::string error = {};
  explicit operator bool() const { return error.empty(); }
};
// Runs Program::main for the threads of a group of a stage that runs in groups. `inputs` has no
// values: those follow from the group. EvalInputs::start is called for each thread, several times.
GroupResult RunGroup(const Program& program, const EvalInputs& inputs, const GroupRun& run,
                     const EvalOptions& options = {});

// The value of an expression of literals, operators, intrinsics and constants (Storage::kConstant
// with an init), component after component in the order of the type. Returns nullopt if the
// expression has anything else in it, divides an integer by zero, indexes out of bounds, or is too
// much work: the evaluation takes time linear in the expression, and the work inside variables is
// bounded. The program need not be complete.
std::optional<std::vector<std::uint64_t>> ConstantBits(const Program& program, ExprId expr);

}  // namespace clipc::ir
