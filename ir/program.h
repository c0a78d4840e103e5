// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/arena.h"
#include "base/id.h"
#include "base/span.h"
#include "ir/intrinsic.h"
#include "ir/profile.h"
#include "ir/type.h"

// What a shader means: names resolved, every conversion explicit, every node typed.
//
// Values are HLSL's. A vector has columns components; a matrix has rows x columns, M[i] is row i,
// mul() is HLSL's, and how a matrix lies in memory is a property of the variable or field that
// holds it (row_major), never of a value. Operands of one operator have the same type, unless the
// node says otherwise. Arguments are evaluated left to right. Every expression has exactly one
// parent; Verify says so.
namespace clipc::ir {

struct Expr;
struct Stmt;
struct Var;
struct Function;
struct Cbuffer;
struct SwitchCase;
using ExprId = Id<Expr>;
using StmtId = Id<Stmt>;
using VarId = Id<Var>;
using FunctionId = Id<Function>;
using CbufferId = Id<Cbuffer>;

// ---- expressions

// A scalar. bits: bool 0 or 1; int, uint: the value; float kinds: the bits of a float; double: the
// bits of a double. Vectors and matrices of constants are Constructs of Literals.
struct Literal {
  std::uint64_t bits;
};
// A zero of any type, structs and arrays included: (T)0.
struct Zero {};
struct VarRef {
  VarId var;
};
struct FieldRef {
  ExprId base;  // of struct type
  std::uint32_t field;
};
// array[i], vector[i] (a scalar), matrix[i] (row i, a vector). The index is an int or uint scalar.
// StructuredBuffer and Buffer reads are ObjectOps.
struct Index {
  ExprId base, index;
};
// Components of a vector: base.xyz. One component gives a scalar. An assignment target has no
// repeated component.
struct Swizzle {
  ExprId base;
  std::array<std::uint8_t, 4> components;
  std::uint8_t count;
};
// Components of a matrix, as a value only: m._m00_m11. base is a path of variables, fields and
// constant or pure indices. Targets of assignments were decomposed into Index nodes.
struct MatrixSwizzle {
  ExprId base;
  std::array<std::uint8_t, 4> rows, columns;
  std::uint8_t count;
};
enum class UnaryOp : std::uint8_t {
  kNegate,
  kNot,
  kComplement,  // kNot: of bool shapes
  kPreIncrement,
  kPreDecrement,
  kPostIncrement,
  kPostDecrement  // of an lvalue, int, uint or float shapes
};
struct Unary {
  UnaryOp op;
  ExprId operand;
};
// Component-wise; left and right have the same type (for shifts: the same shape). Comparisons and
// logical operators give bool of that shape. kMod on floats is fmod (sign of the dividend). Shift
// counts are taken modulo 32. The logical operators evaluate both sides, as HLSL before 2021 does;
// the short-circuit forms are for scalars (HLSL 2021).
enum class BinaryOp : std::uint8_t {
  kMul,
  kDiv,
  kMod,
  kAdd,
  kSub,
  kShiftLeft,
  kShiftRight,
  kLess,
  kGreater,
  kLessEqual,
  kGreaterEqual,
  kEqual,
  kNotEqual,
  kBitAnd,
  kBitXor,
  kBitOr,
  kLogicalAnd,
  kLogicalOr,
  kShortCircuitAnd,
  kShortCircuitOr
};
// Comparisons and logical operators.
constexpr bool GivesBool(BinaryOp op) {
  return (op >= BinaryOp::kLess && op <= BinaryOp::kNotEqual) || op >= BinaryOp::kLogicalAnd;
}
struct Binary {
  BinaryOp op;
  ExprId left, right;
};
// target = value, or target op= value; both have the same type. The value of the expression is the
// target's new value. A target is a path of VarRef, FieldRef, Index and at most one last Swizzle.
struct Assign {
  std::optional<BinaryOp> op;  // arithmetic, bit and shift operators only
  ExprId target, value;
};
// A scalar bool condition. Only the chosen side is evaluated; where HLSL evaluates both and it
// matters, the checker hoisted them.
struct Conditional {
  ExprId condition, when_true, when_false;
};
// Component-wise choice by a bool vector or matrix; all three are evaluated.
struct Select {
  ExprId condition, when_true, when_false;
};
// The same shape, another component kind. float to int truncates; to bool is != 0; from bool is 0
// or 1; signed and unsigned keep the bits. Between half, float and minimum-precision floats it is
// the identity.
struct Convert {
  ExprId operand;
};
// A scalar in every component of a vector or matrix.
struct Splat {
  ExprId operand;
};
// A vector, from scalars and vectors of the same kind whose components add up; a matrix, from
// scalars in row order or from its rows; a struct or an array, from one expression per field or
// element of exactly that type.
struct Construct {
  List<ExprId> arguments;
};
// The upper left part of a matrix.
struct MatrixTruncate {
  ExprId operand;
};
// Arguments have exactly the parameters' types; those of out and inout parameters are assignment
// targets, copied in (inout) before the call and out after it, left to right.
struct Call {
  FunctionId function;
  List<ExprId> arguments;
};
struct IntrinsicCall {
  Intrinsic op;
  List<ExprId> arguments;
};
// Reads through texture and buffer objects. arguments[0] is the object: a VarRef, or an Index of
// one for an array of them.
enum class ObjectOp : std::uint8_t {
  kSampleLevel,  // (texture, sampler, coordinate float{1..4}, lod float [, offset int{1..3} of
                 // literals])
  kSampleGrad,   // (texture, sampler, coordinate, ddx, ddy [, offset])
  kSampleCmpLevelZero,  // (texture, comparison sampler, coordinate, reference [, offset])
  // (texture, sampler, coordinate [, offset, or one for each texel of the four]); component 0
  // (red); kGatherGreen.. the others
  kGather,
  kGatherGreen,
  kGatherBlue,
  kGatherAlpha,
  kTextureLoad,      // (texture, coordinate int{1..3} without level, level int [, offset]);
                     // multisampled: level is the sample
  kBufferLoad,       // (Buffer<T>, index): the element, an ObjectType's element type
  kStructuredLoad,   // (StructuredBuffer<T>, index)
  kByteLoad,         // (ByteAddressBuffer, byte address uint): uint..uint4 as the node's type says
  kTextureSize,      // (texture, level uint): int scalar or vector: width [, height [, depth]] [,
                     // elements]
  kTextureLevels,    // (texture): int
  kTextureSamples,   // (texture): int
  kBufferSize,       // (buffer): int elements; of a ByteAddressBuffer bytes
  kD3d9SampleLevel,  // (sampler2D and so on, coordinate with the level in w already split off, lod)
  kD3d9Sample,       // (sampler, coordinate): level 0 in a vertex shader
  kImageLoad,        // (RWTexture, coordinate int{1..3})
  kStore,  // (a writable object, place as the load of that object has it, value): void; the
           // place of an RWByteAddressBuffer is a byte address, the value uint..uint4
};
// arguments[1] is a sampler.
constexpr bool TakesSampler(ObjectOp op) {
  switch (op) {
    case ObjectOp::kSampleLevel:
    case ObjectOp::kSampleGrad:
    case ObjectOp::kSampleCmpLevelZero:
    case ObjectOp::kGather:
    case ObjectOp::kGatherGreen:
    case ObjectOp::kGatherBlue:
    case ObjectOp::kGatherAlpha: return true;
    default: return false;
  }
}
struct ObjectCall {
  ObjectOp op;
  List<ExprId> arguments;
};
// Evaluates first, then second, whose value it has.
struct Comma {
  ExprId first, second;
};

struct Expr {
  TypeId type;
  Span span;
  std::variant<Literal, Zero, VarRef, FieldRef, Index, Swizzle, MatrixSwizzle, Unary, Binary,
               Assign, Conditional, Select, Convert, Splat, Construct, MatrixTruncate, Call,
               IntrinsicCall, ObjectCall, Comma>
      node;
};

// ---- statements

struct Block {
  List<StmtId> body;
};
// Brings a local variable into scope; without init its value is undefined (the evaluator: zero).
struct Declare {
  VarId var;
  ExprId init;  // of exactly the variable's type, or none
};
struct Evaluate {
  ExprId expr;
};
struct If {
  ExprId condition;
  StmtId then, otherwise;  // otherwise may be none
};
struct For {
  List<StmtId> init;  // Declares of one type, or one Evaluate
  ExprId condition;   // bool scalar; none: forever
  ExprId step;        // or none
  StmtId body;
};
struct While {
  ExprId condition;
  StmtId body;
};
struct DoWhile {
  StmtId body;
  ExprId condition;
};
// One arm: its labels and the statements up to the next label; control falls into the next arm.
struct SwitchCase {
  List<ExprId> labels;  // Literals of the value's type
  bool is_default = false;
  List<StmtId> body;
};
struct Switch {
  ExprId value;  // int or uint scalar
  List<SwitchCase> cases;
};
struct Return {
  ExprId value;  // or none
};
struct Break {};
struct Continue {};

struct Stmt {
  Span span;
  std::variant<Block, Declare, Evaluate, If, For, While, DoWhile, Switch, Return, Break, Continue>
      node;
};

// ---- variables, functions, buffers

enum class Storage : std::uint8_t {
  kLocal,
  kIn,
  kOut,
  kInOut,     // parameters
  kStatic,    // a mutable global: `static float x = ...;`
  kConstant,  // `static const`, `const` local with a constant value; init is a constant expression
  kUniform,   // a member of a Cbuffer
  kResource,  // a texture, sampler or buffer object, or an array of them
  kInput,
  kOutput,  // of the whole shader: only `main` touches them
};

struct Var {
  std::string name;  // as written; made legal and unique by the back end
  TypeId type;
  Storage storage = Storage::kLocal;
  Span span;
  ExprId init;        // kStatic, kConstant
  CbufferId cbuffer;  // kUniform
  bool row_major = false;
  bool precise = false;
};

struct Function {
  std::string name;
  TypeId return_type;
  std::vector<VarId> parameters;
  StmtId body;  // a Block
  Span span;
};

// b3, space1.
struct Register {
  char letter = 'b';
  std::uint32_t number = 0;
  std::uint32_t space = 0;
  bool is_explicit =
      false;  // written by the user, or the implicit choice (see design of the clip table)
};

struct CbufferMember {
  VarId var;
  std::uint32_t offset = 0;  // bytes from the start of the buffer, HLSL packing
  std::uint32_t size = 0;    // bytes
  bool has_packoffset =
      false;  // offset is the user's: packoffset(c1.y), or register(c1) in $Globals
};
enum class CbufferKind : std::uint8_t {
  kCbuffer,
  kTbuffer,
  kGlobals,         // "$Globals": uniforms outside any cbuffer
  kParams,          // "$Params": `uniform` parameters of the entry point
  kConstantBuffer,  // ConstantBuffer<T>: one member at offset 0 whose type is T, or T[count] with
                    // one buffer per element
};
struct Cbuffer {
  std::string name;
  CbufferKind kind = CbufferKind::kCbuffer;
  Register reg;
  std::vector<CbufferMember> members;
  std::uint32_t size = 0;   // bytes, a multiple of 16 as HLSL binds it
  std::uint32_t count = 1;  // ConstantBuffer<T> cb[4]: 4
  Span span;
};

struct Resource {
  VarId var;
  Register reg;  // letter t or s
};

enum class Builtin : std::uint8_t {
  kNone,
  kPosition,      // output, float4, Direct3D clip space until AdjustClipSpace
  kClipVertex,    // output, float4: gl_ClipVertex
  kClipDistance,  // output, float[n], n <= 8
  kCullDistance,  // output, float[n]
  kPointSize,     // output, float
  kVertexId,
  kInstanceId,  // input, uint: without base vertex and base instance
  kBaseVertex,
  kBaseInstance,  // input, int, uint: SV_StartVertexLocation, SV_StartInstanceLocation
  kDrawIndex,
  kViewId,  // input, uint
  kVertexIndex,
  kInstanceIndex,  // input, uint: with base vertex and base instance, as Vulkan counts
  kShadingRate,    // output, uint: Direct3D's log2 of the width << 2 | log2 of the height
  kLayer,
  kViewportIndex,  // output, uint
};

// One input or output of the shader: a scalar or vector of float, int, uint or double (bool arrives
// as uint), or the arrays of kClipDistance and kCullDistance. Struct, array and matrix parameters
// were taken apart (matrices by rows). The semantic of outputs that carry distances to clip planes
// to a fragment shader that discards. No shader can write it.
inline constexpr std::string_view kClipPlaneDistance = "SV_ClipPlaneDistance";

struct IoVar {
  VarId var;
  std::string semantic;  // as written without its index: "TEXCOORD"
  std::uint32_t index = 0;
  Builtin builtin = Builtin::kNone;
  std::uint32_t location =
      0;  // order of declaration among the inputs (outputs) that are no builtin
  Interpolation interpolation = Interpolation::kDefault;
  bool centroid = false;
  bool sample = false;
};

// An operand of [clipplanes(...)]. value is a float4 made of cbuffer members; LowerClipPlanes takes
// it away (none).
struct ClipPlane {
  ExprId value;
  Span span;
  std::string text;           // as written: "planes[2]"
  CbufferId cbuffer;          // when whole_register
  std::uint32_t offset = 0;   // bytes in that buffer, a multiple of 16, when whole_register
  std::uint32_t element = 0;  // which buffer of an array of ConstantBuffers
  bool whole_register =
      false;  // the operand is one whole float4 register in order: what Direct3D 9 can be told
};

// What holds of a program; each includes the ones before. Verify(program, form) checks it.
enum class Form : std::uint8_t {
  kTyped,            // as Check returns it
  kNoClipPlanes,     // clip planes are outputs, or table entries only: no ClipPlane has a value
  kTargetClipSpace,  // kPosition is in the target's clip space
  kInlined,          // main may hold the entry's statements; then the entry is empty
};

struct Program {
  Profile profile;
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
  FunctionId main;   // generated: reads the inputs, calls entry once, writes the outputs; void, no
                     // parameters
  std::vector<IoVar> inputs, outputs;
  std::vector<VarId>
      globals;  // kStatic and kConstant at global scope that are reached, in order of declaration
  std::vector<Resource> resources;  // reached, in order of declaration
  std::vector<ClipPlane> clip_planes;
  Form form = Form::kTyped;
};

}  // namespace clipc::ir
