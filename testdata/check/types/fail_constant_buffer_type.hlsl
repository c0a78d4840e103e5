// The type argument of a ConstantBuffer or TextureBuffer is a struct, also where nothing uses the buffer: fxc X3594, "can only be a
// struct", in DXC's issue 784; DXC's cbuffer-struct.hlsl and cbuffer-structarray.hlsl.
// RUN: not %clipc -T vs_5_1 %s -o - 2>&1 | FileCheck %s
// RUN: not %clipc -T vs_6_0 %s -o - 2>&1 | FileCheck %s
// RUN: not %clipc -T vs_5_1 -E endless %s -o - 2>&1 | FileCheck %s --check-prefix=ENDLESS
// RUN: not %clipc -T vs_6_0 -E push %s -o - 2>&1 | FileCheck %s --check-prefix=PUSH
// RUN: not %clipc -T ps_6_6 -E pixel %s -o - 2>&1 | FileCheck %s --check-prefix=PIXEL
struct Frame { float4 a; };
typedef Frame Frames[2];
enum Kind { kNone };
// CHECK-DAG: [[#@LINE+1]]:16: error: `ConstantBuffer` is given the type `float4`; it must be a struct, which may have one member of that type [constant-buffer-type, X3594]
ConstantBuffer<float4> vectors;
// CHECK-DAG: [[#@LINE+1]]:16: error: `ConstantBuffer` is given the type `bool`; {{.*}} [constant-buffer-type, X3594]
ConstantBuffer<bool> bools;
// CHECK-DAG: [[#@LINE+1]]:16: error: `ConstantBuffer` is given the type `float4x4`
ConstantBuffer<float4x4> matrices;
// CHECK-DAG: [[#@LINE+1]]:16: error: `ConstantBuffer` is given the type `float4[2]`
ConstantBuffer<float4[2]> arrays;
// CHECK-DAG: [[#@LINE+1]]:16: error: `ConstantBuffer` is given the type `Frame[2]`
ConstantBuffer<Frames> structs;
// CHECK-DAG: [[#@LINE+1]]:16: error: `ConstantBuffer` is given the type `int`
ConstantBuffer<Kind> kinds;
// CHECK-DAG: [[#@LINE+1]]:15: error: `TextureBuffer` is given the type `float4`
TextureBuffer<float4> texels;
// CHECK-DAG: [[#@LINE+1]]:16: error: `ConstantBuffer` is given the type `double`
ConstantBuffer<double> unused[3] : register(b3);
// CHECK-DAG: [[#@LINE+1]]:1: error: `ConstantBuffer` is used without its template arguments [missing-type-argument, X3000]
ConstantBuffer none;
ConstantBuffer<Frame> right;
float4 main(float4 p : P) : SV_Position {
  return p + vectors + bools + mul(p, matrices) + arrays[1] + structs[1].a + kinds + texels.x + right.a;
}

// PIXEL: `ConstantBuffer` is given the type `float2`
float4 pixel() : SV_Target { ConstantBuffer<float2> local; return local.xyxy; }

// ENDLESS: [[#@LINE+1]]:22: error: a `TextureBuffer` array without a size is not supported [unsupported]
TextureBuffer<Frame> endless_texels[];
float4 endless(uint i : I) : SV_Position { return endless_texels[i].a; }

// PUSH: error: push constant `pushed` has type `Texture2D<float4>`; it must be a struct [push-constant-not-struct]
[[vk::push_constant]] Texture2D pushed;
float4 push() : SV_Position { return pushed.Load(0); }
