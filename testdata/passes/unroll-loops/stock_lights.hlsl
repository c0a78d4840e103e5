// Shaders of the shape of XNA's stock effects: functions that are called with the number of lights and of bones.
// RUN: %clipc %s -T vs_2_0 -E Three --target=webgl1 --validate --verify -o - | FileCheck %s
// RUN: %clipc %s -T vs_2_0 -E One --target=essl100 --validate --verify -o - | FileCheck %s --check-prefix=ONE
// RUN: %draw compare %s -T vs_2_0 -E Three --target essl100,glsl450
// RUN: %draw compare %s -T vs_2_0 -E One --target essl100,glsl450
// CHECK: for (int i = 0; i < 2; i++) {
// CHECK: skinning = add(skinning, multiply(Bones(int(min(abs(vin.indices[i]), 7.0))), 
// CHECK: for (int i = 0; i < 3; i++) {
// CHECK-NEXT: directions[i] = mat3(Direction0(), Direction1(), Direction2())[i];
// ONE: for (int i = 0; i < 4; i++) {
// ONE: for (int i = 0; i < 1; i++) {
float3 Direction0, Direction1, Direction2;
float3 Color0, Color1, Color2;
float4x3 Bones[8];
float4x4 WorldViewProj;
float3 Eye;
struct Lit {
  float3 diffuse;
  float3 specular;
};
struct Vertex {
  float4 position : POSITION;
  float3 normal : NORMAL;
  float4 indices : BLENDINDICES;
  float4 weights : BLENDWEIGHT;
};
struct Varyings {
  float4 position : POSITION;
  float4 diffuse : COLOR0;
  float4 specular : COLOR1;
};
Lit ComputeLights(float3 eye, float3 normal, uniform int count) {
  float3x3 directions = 0, colors = 0, halves = 0;
  [unroll]
  for (int i = 0; i < count; i++) {
    directions[i] = float3x3(Direction0, Direction1, Direction2)[i];
    colors[i] = float3x3(Color0, Color1, Color2)[i];
    halves[i] = eye - directions[i];
  }
  float3 facing = mul(-directions, normal);
  float3 shine = mul(halves, normal);
  float3 is_lit = step(0, facing);
  Lit lit;
  lit.diffuse = mul(is_lit * facing, colors);
  lit.specular = mul(max(shine, 0) * is_lit, colors);
  return lit;
}
void Skin(inout Vertex vin, uniform int boneCount) {
  float4x3 skinning = 0;
  [unroll]
  for (int i = 0; i < boneCount; i++) skinning += Bones[min(abs(vin.indices[i]), 7)] * vin.weights[i];
  vin.position.xyz = mul(vin.position, skinning);
  vin.normal = mul(vin.normal, (float3x3)skinning);
}
Varyings Shade(Vertex vin, uniform int lights, uniform int bones) {
  Varyings o;
  Skin(vin, bones);
  Lit lit = ComputeLights(Eye, vin.normal, lights);
  o.diffuse = float4(lit.diffuse, 1);
  o.specular = float4(lit.specular, 1);
  o.position = mul(vin.position, WorldViewProj);
  return o;
}
Varyings Three(Vertex vin) { return Shade(vin, 3, 2); }
Varyings One(Vertex vin) { return Shade(vin, 1, 4); }
