// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/kept_blocks.h"
#include "base/span.h"
#include "base/stage.h"
#include "ir/ids.h"
#include "ir/type.h"
#include "ir/variable.h"

// The interface of a shader to the application and to the next stage: constant buffers, objects,
// inputs, outputs and clip planes.
namespace clipc::ir {

// [[vk::binding(3, 1)]]
struct Descriptor {
  std::uint32_t binding = 0, set = 0;
};

// register(b3, space1): letter b, number 3, space 1.
struct Register {
  char letter = 'b';
  std::uint32_t number = 0;
  std::uint32_t space = 0;
  bool is_explicit = false;  // written in the source; clipc chose the number otherwise
  std::optional<Descriptor> descriptor = {};  // where Vulkan and OpenGL bind it, if written
};

struct CbufferMember {
  VarId var;
  std::uint32_t offset = 0;  // bytes from the start of the buffer, HLSL packing
  std::uint32_t size = 0;    // bytes
  // The offset is written in the source: packoffset(c1.y), or register(c1) in $Globals.
  bool has_packoffset = false;
  // The components of the initial value as ConstantBits gives them, which the application may put
  // into the buffer; empty: none.
  std::vector<std::uint64_t> initial = {};
};
enum class CbufferKind : std::uint8_t {
  kCbuffer,
  kTbuffer,
  kGlobals,  // "$Globals": the uniforms outside any cbuffer
  kParams,   // "$Params": the `uniform` parameters of the entry point
  // ConstantBuffer<T>: one member at offset 0, whose type is T, or T[count] with one buffer for
  // each element
  kConstantBuffer,
};
// The precision of a uniform in OpenGL ES, on which the stages of a program must agree.
enum class Precision : std::uint8_t { kHigh, kMedium, kLow };
// The declaration of a constant buffer in the GLSL of another stage that uses it too. Two stages of
// a program declare a block alike.
struct BlockDeclaration {
  std::string name;
  bool has_instance = false;  // members are reached through `instance`
  bool is_loose = false;      // uniform variables outside blocks; only their precisions count
  std::string instance;
  bool rows_on_block = false;  // row_major qualifies the block; else the members
  std::optional<std::uint32_t> set, binding;
  struct DeclaredMember {
    std::string name;
    bool is_uint = false;  // a bool, which most compilers declare as the uint that it is in memory
    Precision precision = Precision::kHigh;
  };
  std::vector<DeclaredMember>
      members;  // in the order of Cbuffer::members, or of the fields of their T
};
struct Cbuffer {
  std::string name;
  CbufferKind kind = CbufferKind::kCbuffer;
  Register reg;
  std::vector<CbufferMember> members;
  std::uint32_t size = 0;         // bytes, a multiple of 16 as HLSL binds it
  std::uint32_t count = 1;        // the number of buffers: 4 of ConstantBuffer<T> cb[4]
  bool is_push_constant = false;  // [[vk::push_constant]]: Vulkan binds no buffer to it
  Span span;
  std::optional<BlockDeclaration> declared;  // none: the target decides
};

struct Resource {
  VarId var;
  Register reg;             // its letter is t, s or u
  std::string format = {};  // [[vk::image_format("rgba8")]] in GLSL's spelling; empty: none
  // [[vk::input_attachment_index(..)]]
  std::optional<std::uint32_t> input_attachment = {};
  std::optional<std::uint32_t> counter_binding = {};  // [[vk::counter_binding(..)]]
  // The structured buffer whose counter is the one element of this hidden buffer; none of a
  // resource that the shader declares.
  VarId counter_of = {};
  // The type that the shader declares, where a pass made another kind of buffer of it; else none.
  TypeId declared_type = {};
  // The array that the shader declares and the number of this element of it, counted through all
  // dimensions, where a pass made resources of its elements; else none.
  VarId element_of = {};
  std::uint32_t element = 0;
};

// The meaning of an input or output to the pipeline.
enum class Builtin : std::uint8_t {
  kNone,
  kUntranslated,  // an input that no target has; it may be declared, of any type, and is not read
#define BUILTIN(Enumerator, Name, Direction, Scalar, Components) k##Enumerator,
#include "ir/builtins.def"
};

struct BuiltinInfo {
  std::string_view name;
  Storage storage;  // kInput or kOutput
  Scalar scalar;
  int components;  // 0: an array of distances or factors
};
inline constexpr BuiltinInfo kBuiltinInfos[] = {
    {"none", Storage::kLocal, Scalar::kFloat, 1},
    {"untranslated", Storage::kInput, Scalar::kFloat, 1},
#define BUILTIN(Enumerator, Name, Direction, Kind, Components) \
  {Name, Storage::k##Direction, Scalar::k##Kind, Components},
#include "ir/builtins.def"
};
constexpr const BuiltinInfo& InfoOf(Builtin builtin) {
  return kBuiltinInfos[static_cast<std::size_t>(builtin)];
}
// Whether the output is the depth of the pixel.
constexpr bool IsDepth(Builtin builtin) {
  return builtin == Builtin::kDepth || builtin == Builtin::kDepthGreaterEqual ||
         builtin == Builtin::kDepthLessEqual;
}
// Whether the input is what a function of HLSL gives, like WaveGetLaneIndex(): every function of
// the program may read it, and not `main` alone.
constexpr bool IsReadAnywhere(Builtin builtin) {
  return builtin == Builtin::kLaneCount || builtin == Builtin::kLaneIndex ||
         builtin == Builtin::kSampleCount || builtin == Builtin::kHelperLane;
}

// A block that inputs of the next stage are members of, `in Varyings { vec2 uv; } v`, or an input
// that is a struct. A shader declares it alike, with the members that it does not write.
struct OutputGroup {
  struct GroupMember {
    std::string name;
    // The type in GLSL: a vector of `components`, a matrix of `columns` such vectors, or an array.
    Scalar scalar = Scalar::kFloat;
    std::uint8_t components = 1;
    std::uint8_t columns = 1;
    std::vector<std::uint32_t> dimensions = {};
    Interpolation interpolation = Interpolation::kDefault;
    bool centroid = false;
    bool sample = false;
    std::optional<std::uint32_t> location = {};  // if the member has its own
  };
  bool is_block = true;                        // false: a struct
  std::string type;                            // the name of the block or the struct
  std::string instance;                        // empty: the members are global names
  std::optional<std::uint32_t> location = {};  // if the whole has one
  std::vector<GroupMember> members = {};
};

// The input of the next stage that an output matches, whose form the output takes.
struct Reader {
  bool is_known = true;  // false: a supposition; the next stage is not known
  Stage stage = Stage::kPixel;
  std::string name;          // empty: the output is named after its semantic
  bool has_location = true;  // false: the stages match by name
  // The columns and array dimensions of the whole input. The output is the element (or column)
  // number `element` of it.
  std::uint32_t columns = 1;
  std::vector<std::uint32_t> dimensions;
  std::uint32_t element = 0;
  // For a member of a block or a struct: the number of the group in Program::output_groups, and the
  // number of the member in the group.
  std::optional<std::size_t> group = {};
  std::size_t member = 0;

  bool IsWhole() const { return columns == 1 && dimensions.empty(); }
  friend bool operator==(const Reader&, const Reader&) = default;
};

// One input or output of the shader: a scalar or vector of float, int, uint or double (a bool
// arrives as uint), or the array of kClipDistance or kCullDistance. Structs, arrays and matrices in
// the signature were taken apart, matrices by columns (`row_major` ones by rows).
struct IoVar {
  VarId var;
  std::string semantic;  // as written, without its index: "TEXCOORD"
  std::uint32_t index = 0;
  Builtin builtin = Builtin::kNone;
  // The place among the inputs (outputs) that are not built in, in order of declaration; of an
  // output of a pixel shader, the number of the render target.
  std::uint32_t location = 0;
  Interpolation interpolation = Interpolation::kDefault;
  bool centroid = false;
  bool sample = false;
  bool has_index = false;  // the index is written: TEXCOORD0, not TEXCOORD
  bool is_placed = false;  // [[vk::location]] gives the location
  std::string name = {};   // of the field, parameter or function that has the semantic: "uv"
  // The path to it in the signature, from the name of the parameter or function on: "input.uv[1]".
  // The rows of a matrix have the matrix's path.
  std::string path = {};
  std::optional<Reader> reader = {};  // for an output with a known or supposed input
  bool is_unwritten = false;          // of an output: no path writes it, which is reported
  bool may_be_unwritten = false;      // of an output: a path does not write it, which is reported
  // Of an output of a pixel shader: 1 for the second of the two colors that are blended.
  std::uint32_t blend_index = 0;
  bool has_min_precision = false;  // its type in the HLSL is half, min16float or the like
  bool is_of_patch = false;        // of the whole patch, and not of each of its control points
  friend bool operator==(const IoVar&, const IoVar&) = default;
};

using IoVars = KeptVector<IoVar>;

// The locations that an input or output of this scalar or vector type needs: two for three or four
// components of 64 bits.
std::uint32_t LocationCount(const Type& type);
// Sorts the inputs or outputs that are not built in by location and puts them after the built-in
// ones. A list in which they have that order already is left as it is.
void SortByLocation(IoVars& list);

// Where the distances of one semantic index lie in the array of a shader's clip or cull distances,
// which is an input or an output: `count` elements from `first` on. They are the components of the
// semantic from `component` on.
struct DistancePiece {
  VarId array;
  std::uint32_t index = 0;
  std::uint32_t first = 0, count = 0;
  std::uint32_t component = 0;
};

// The semantic of the outputs that carry distances to clip planes to a fragment shader that
// discards. A shader cannot name it: the names that begin with SV_ are Direct3D's.
inline constexpr std::string_view kClipPlaneDistance = "SV_ClipPlaneDistance";

// An operand of [clipplanes(...)].
struct ClipPlane {
  ExprId value;  // a float4 made of cbuffer members; none after LowerClipPlanes
  Span span;
  std::string text;           // as written: "planes[2]"
  CbufferId cbuffer;          // when whole_register
  std::uint32_t offset = 0;   // bytes in that buffer, a multiple of 16, when whole_register
  std::uint32_t element = 0;  // index in an array of ConstantBuffers
  // The operand is one whole float4 register, its components in order: Direct3D 9 takes nothing
  // else.
  bool whole_register = false;
};

}  // namespace clipc::ir
