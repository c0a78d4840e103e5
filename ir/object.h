// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>

#include "base/stage.h"

// The textures, samplers and buffers of HLSL: one row of base/builtin_types.def each, where HLSL
// has a word for it.
namespace clipc::ir {

enum class ObjectKind : std::uint8_t {
#define OBJECT(Enumerator, ...) k##Enumerator,
#include "base/builtin_types.def"
  kSampler2DShadow,  // a sampler2D whose texture Direct3D 9's driver compares, less or equal: HLSL
                     // has no word for it, resolve::CompareSamplers makes it
  kOther,  // an object that clipc lets no stage use (a state, ...): it may only be declared
};

enum class ObjectCategory : std::uint8_t {
  kTexture,
  kSampler,          // SamplerState and SamplerComparisonState; Direct3D 9's `sampler` before its
                     // first use
  kCombinedSampler,  // Direct3D 9's sampler2D and the like: a texture and its sampler in one
  kSubpass,          // SubpassInput<T>: the pixel's own place of what an earlier subpass drew
  kTypedBuffer,      // Buffer<T>
  kStructuredBuffer,
  kByteAddressBuffer,
  kStream,  // TriangleStream<T>: the vertices that a shader emits
  kOther,
};

struct ObjectInfo {
  const char* name;  // HLSL's spelling, as messages print it
  ObjectCategory category;
  std::uint8_t model;  // the first shader model that has it, 41 for 4.1
  std::uint8_t axes;   // 1 to 3 dimensions of a texel's place; 0: not a texture
  bool is_writable;    // RWTexture2D, RWBuffer and the like
  bool is_ordered;     // RasterizerOrderedTexture2D and the like: the invocations of a pixel access
                       // it one after the other, in the order of the primitives
  bool is_array;
  bool is_cube;
  bool is_multisampled;
  bool compares;  // a sampler that compares the texture with a reference
};
const ObjectInfo& InfoOf(ObjectKind kind);

// The first shader model in which shaders of the stage have the object: in groups, Direct3D 10.1
// writes structured and byte address buffers already ("Compute shaders on downlevel hardware" of
// the Direct3D 11 reference).
int FirstModelOf(ObjectKind kind, const StageInfo& stage);

bool IsWritable(ObjectKind kind);
bool IsOrdered(ObjectKind kind);
// Whether the object is a texture that the shader cannot write: Texture1D to TextureCubeArray.
bool IsTexture(ObjectKind kind);
// Whether the object is a SamplerState, a SamplerComparisonState or one of Direct3D 9's samplers,
// which hold their texture too.
bool IsSampler(ObjectKind kind);
// Whether the object is one of Direct3D 9's sampler1D to samplerCUBE.
bool IsCombinedSampler(ObjectKind kind);
// Whether the object is an RWBuffer or RWTexture: a format lies between the shader and the memory.
bool IsImage(ObjectKind kind);
bool IsStructured(ObjectKind kind);
// Whether the shader names the elements of the buffer: not of an append or consume buffer, whose
// counter does.
bool HasNamedElements(ObjectKind kind);
bool IsByteAddress(ObjectKind kind);
// Whether the object is a PointStream, LineStream or TriangleStream.
bool IsStream(ObjectKind kind);
// Whether the object is a StructuredBuffer or ByteAddressBuffer, RW or not: the shader sees the
// memory itself.
bool IsStorageBuffer(ObjectKind kind);
// Whether the type is written with the type of its elements: Texture2D<float4>.
bool HasElement(ObjectKind kind);
// Whether the elements are texels, of one scalar or vector each: of textures and typed buffers.
bool HasTexels(ObjectKind kind);
// The letter of the registers that hold the object: s, t, or u for a writable one.
char RegisterLetter(ObjectKind kind);

}  // namespace clipc::ir
