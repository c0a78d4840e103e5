// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <span>

#include "ir/run_passes.h"
#include "legalize/legalizer.h"

// The legalising passes, one a function, with before => after. They replace the parts of a program
// that the target lacks by parts that it has, so that the writer only prints. A pass puts the work
// that it cannot do in place into helper functions (Function::is_helper).
namespace clipc::legalize {

// Reads an operand into a variable where a later operand may write what it reads. HLSL evaluates
// operands from left to right; a driver may read a variable as late as it uses the value.
//
//   return n + f(2);   =>  int old_n = n; return old_n + f(2);
//   while (n + f(2));  =>  int old_n; while ((old_n = n) + f(2));
void LowerOperandOrder(Legalizer& legalizer);

// Makes a variable of each element of an array of objects that is split: split_arrays.h.
//
//   t.Sample(samplers[1], uv)  =>  t.Sample(samplers_1, uv)
void SplitArrays(Legalizer& legalizer);

// Makes one dimension of the several of an array of textures, samplers or buffers, where the target
// has no arrays of arrays of them.
//
//   Texture2D maps[2][3]; maps[i][1]  =>  Texture2D maps[6]; maps[i * 3 + 1]
void FlattenArrays(Legalizer& legalizer);

// Evaluates indices that have effects and that GLSL does without before the expression that has
// them: a matrix of one row is a vector, float1 a scalar.
//
//   row[i++] = v;  =>  i++, row[0] = v;
//   f(row[i++])    =>  f((i++, row[0]))
void LowerIndices(Legalizer& legalizer);

// Rewrites loops and indices for targets with the limits of appendix A of GLSL ES 1.00; those of
// other targets stay (legalize/es100/lower_to_es100.h).
//
//   for (i = 0; i < 4 && more; ++i) ..  =>  for (int i = 0; i < 4; i++) { if (!more) break; .. }
//   a[i]                                =>  element(a, i)
void LowerToEs100(Legalizer& legalizer);

// Replaces `a op= b` where GLSL has no such operator: of matrices, % that is not on uint, and
// divisions that LowerDivisions replaces.
//
//   m *= n;       =>  m = m * n;
//   a[i++] %= b;  =>  assign_modulo(a[i++], b);
void LowerAssignments(Legalizer& legalizer);

// Applies operators and functions that GLSL has for vectors only row by row: all of them on
// matrices of integers and of bool, and all but the four arithmetic operators on other matrices.
//
//   max(m, n)  =>  max(m, n) with float2x2 max(float2x2 a, float2x2 b) {
//                                   return float2x2(max(a[0], b[0]), max(a[1], b[1]));
//                                 }
//   i++        =>  post_increment(i)
void LowerMatrixOperators(Legalizer& legalizer);

// Replaces functions of matrices that GLSL has for float matrices only, and dot() of integers.
//
//   all(m)  =>  all(m) with bool all(bool2x2 m) { return all(m[0]) && all(m[1]); }
//   mul(i, j), transpose(i), (int2x2)i, dot(i, j)  =>  sums, constructors
void LowerMatrixFunctions(Legalizer& legalizer);

// Replaces functions that write their arguments, which GLSL has in another form or for scalars
// only.
//
//   sincos(x, s, c)    =>  sincos(x, s, c) with { s = sin(x); c = cos(x); }
//   frexp(v, e)        =>  frexp(v, e) with { return float2(frexp(a[0], b[0]), ...); }
void LowerWrittenArguments(Legalizer& legalizer);

// Replaces conversions of floats to integers, which GLSL leaves undefined if the value does not
// fit.
//
//   (int)x  =>  to_int(x) with abs(x) < 2^31 ? int(x) : x > 0 ? 2^31 - 1 : x < 0 ? -2^31 : 0
void LowerConversions(Legalizer& legalizer);

// Replaces divisions of integers by what may be 0, and signed ones of the least integer by -1,
// which have no result in GLSL; the latter ends Mesa's compiler. In Direct3D the quotient and the
// remainder of udiv by 0 are 0xffffffff; for signed numbers fxc divides the magnitudes by udiv and
// sets the sign (vkd3d's arithmetic-int.shader_test, line 95), so 5 / 0 is -1, -5 / 0 is 1, and the
// least integer by -1 is itself, with the remainder 0.
//
//   u / v             =>  divide(u, v) with y == 0u ? ~0u : x / (y == 0u ? 1u : y)
//   x / -1            =>  -x
//   0x80000000 / y    =>  divide(0x80000000, y) with y == -1 ? -x : x / (y == -1 ? 1 : y)
void LowerDivisions(Legalizer& legalizer);

// Replaces logical operators and choices that evaluate both sides: GLSL evaluates the side that it
// needs.
//
//   a && b      =>  a and_then b, or all(bool2(a, b)) when b has effects
//   select(..)  =>  c ? a : b for each component, where the target has no mix() for it
void LowerChoices(Legalizer& legalizer);

// Evaluates the operands of a sample before it where one has a choice in it.
//
//   t.Sample(s, c ? a : b)  =>  operand = c ? a : b, t.Sample(s, operand)
void LowerSampleOperands(Legalizer& legalizer);

// Replaces operators and functions that are short for others, and bounds the counts of shifts.
//
//   rcp(x) => 1 / x, mad(a, b, c) => a * b + c, x % y => fmod(x, y) with x - y * trunc(x / y)
//   x << n => x << (n & 31)
void LowerArithmetic(Legalizer& legalizer);

// Replaces calls of functions that the target, or the helper function in their place, has for
// scalars only by one call for each component.
void LowerComponents(Legalizer& legalizer);

// Replaces functions that the target lacks by helper functions (functions.h).
//
//   saturate(x)  =>  saturate(x) with min(max(0, x), 1)
void LowerFunctions(Legalizer& legalizer);

// Makes words of the floats that a group shares and that atomic operations change: GLSL has such
// operations of integers only. The rules have seen that the shader only reads and assigns single
// ones.
//
//   InterlockedExchange(sums[i], v, old);  =>  old = asfloat(atomicExchange(sums[i], asuint(v)));
//   sums[i] = v;                           =>  sums[i] = asuint(v);
void LowerSharedFloats(Legalizer& legalizer);

// Makes buffers of words out of structured buffers whose elements lie tighter than std430 can say.
// A load or a store is a call of a function of its buffer (Function::is_accessor).
//
//   normals[k].x     =>  normals_at(k).x with float3(asfloat(normals[3 * i]), ..)
//   normals[k].z = x  =>  normals_store2_at(k, x) with normals[3 * i + 2] = asuint(x)
void LowerStructuredBuffers(Legalizer& legalizer);

// Makes structured buffers of words out of byte address buffers. A load or a store is a call of a
// function of its buffer (Function::is_accessor).
//
//   bytes.Load2(a)     =>  bytes_load2(a) with i = a / 4; return uint2(bytes[i], bytes[i + 1]);
//   bytes.Store(a, x)  =>  bytes_store(a, x) with bytes[a / 4] = x;
//   an atomic at a     =>  an atomic at a / 4
void LowerByteBuffers(Legalizer& legalizer);

// The passes in the order in which they run.
std::span<const ir::Pass<Legalizer>> LegalizePasses();
// Takes the program from Form::kInlined to Form::kAddressed, unless options.stop_after ends it
// earlier. Returns whether all passes ran.
bool Legalize(ir::Program& program, const Needs& needs, const ir::PassOptions& options = {});

}  // namespace clipc::legalize
