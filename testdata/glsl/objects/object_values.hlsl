// Textures, samplers and buffers as parameters, local variables, members of structs and results: each function is made anew
// for the objects it is called with. An index known at run time becomes a parameter or a variable.
// RUN: %clipc -T vs_5_0 --target=glsl450 --validate %s -o - | FileCheck %s --check-prefix=CHECK
// RUN: %clipc -T vs_5_0 --target=vulkan --validate %s -o - | FileCheck %s --check-prefix=VULKAN
// AUTOUPDATE
Texture2D wood, stone;
Texture2D many[4];
SamplerState smooth;
StructuredBuffer<float4> offsets;
struct Maps {
  Texture2D color;
  SamplerState state;
  float level;
  Texture2D details[2];
  float4 Get(float2 uv) { return color.SampleLevel(state, uv, level) + details[1].SampleLevel(state, uv, 0); }
};
struct Pair {
  Maps maps[2];
  float weight;
};
struct Material {
  float4 scale;
  Texture2D map;
};
Material material;
int which;

float4 Read(Texture2D map, SamplerState state, float2 uv) { return map.SampleLevel(state, uv, 0); }
float4 Twice(Texture2D map, SamplerState state, float2 uv) { return Read(map, state, uv) + Read(map, state, uv + 1); }
float4 Offset(StructuredBuffer<float4> from, uint i) { return from[i]; }
void Fill(out Maps maps) {
  maps.color = stone;
  maps.state = smooth;
  maps.level = 2;
  maps.details[0] = wood;
  maps.details[1] = wood;
}
Texture2D Choose() { return stone; }
Maps Make(Texture2D map) {
  Maps maps = {map, smooth, 1, wood, stone};
  return maps;
}

float4 main(float2 uv : TEXCOORD, uint id : SV_VertexID) : SV_Position {
  Maps filled, copy;
  Fill(filled);
  copy = filled;
  copy.color = wood;
  Pair pair;
  pair.maps[0] = filled;
  pair.maps[1] = copy;
  pair.weight = 2;
  Texture2D chosen = many[which];
  Texture2D again = wood;
  float4 r = Read(again, smooth, uv);
  again = stone;
  r += Read(again, smooth, uv) + Twice(stone, smooth, uv) + Twice(many[2], smooth, uv) + Twice(many[id], smooth, uv);
  r += filled.Get(uv) + copy.Get(uv) + pair.maps[1].Get(uv) * pair.weight + Make(stone).Get(uv);
  r += Read(chosen, smooth, uv) + Choose().SampleLevel(smooth, uv, 0) + Offset(offsets, id);
  return r + material.map.SampleLevel(smooth, uv, 0) * material.scale;
}

// CHECK: #version 450
// CHECK-NEXT: #extension GL_ARB_shader_draw_parameters : require
// CHECK-EMPTY:
// CHECK-NEXT: struct Maps {
// CHECK-NEXT:     float level;
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: struct Material {
// CHECK-NEXT:     vec4 scale;
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: struct Pair {
// CHECK-NEXT:     Maps maps[2];
// CHECK-NEXT:     float weight;
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 0) uniform Globals {  // b0
// CHECK-NEXT:     Material material;
// CHECK-NEXT:     int which;
// CHECK-NEXT: } globals;
// CHECK-EMPTY:
// CHECK-NEXT: layout(std430, binding = 6) readonly buffer offsets_block {  // t6
// CHECK-NEXT:     vec4 offsets[];
// CHECK-NEXT: };
// CHECK-NEXT: layout(binding = 0) uniform sampler2D wood;  // t0 with smooth : s0
// CHECK-NEXT: layout(binding = 2) uniform sampler2D many[4];  // t2 with smooth : s0
// CHECK-NEXT: layout(binding = 1) uniform sampler2D stone;  // t1 with smooth : s0
// CHECK-NEXT: layout(binding = 7) uniform sampler2D material_map;  // t7 with smooth : s0
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec2 in_TEXCOORD0;  // uv : TEXCOORD0
// CHECK-EMPTY:
// CHECK-NEXT: void Fill(out Maps maps) {
// CHECK-NEXT:     maps.level = 2.0;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Read(vec2 uv) {
// CHECK-NEXT:     return textureLod(wood, uv, 0.0);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Read_2(vec2 uv) {
// CHECK-NEXT:     return textureLod(stone, uv, 0.0);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Twice(vec2 uv) {
// CHECK-NEXT:     return Read_2(uv) + Read_2(uv + 1.0);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Read_3(vec2 uv) {
// CHECK-NEXT:     return textureLod(many[2], uv, 0.0);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Twice_2(vec2 uv) {
// CHECK-NEXT:     return Read_3(uv) + Read_3(uv + 1.0);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Read(vec2 uv, uint many_index) {
// CHECK-NEXT:     return textureLod(many[many_index], uv, 0.0);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Twice(vec2 uv, uint many_index) {
// CHECK-NEXT:     return Read(uv, many_index) + Read(uv + 1.0, many_index);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Get(inout Maps self, vec2 uv) {
// CHECK-NEXT:     return textureLod(stone, uv, self.level) + textureLod(wood, uv, 0.0);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Get_2(inout Maps self, vec2 uv) {
// CHECK-NEXT:     return textureLod(wood, uv, self.level) + textureLod(wood, uv, 0.0);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: Maps Make() {
// CHECK-NEXT:     Maps maps = Maps(1.0);
// CHECK-NEXT:     return maps;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Get_3(inout Maps self, vec2 uv) {
// CHECK-NEXT:     return textureLod(stone, uv, self.level) + textureLod(stone, uv, 0.0);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Read(vec2 uv, int many_index) {
// CHECK-NEXT:     return textureLod(many[many_index], uv, 0.0);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 Offset(uint i) {
// CHECK-NEXT:     return offsets[i];
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     uint id = uint(gl_VertexID - gl_BaseVertexARB);
// CHECK-NEXT:     int chosen_index;
// CHECK-NEXT:     Maps filled;
// CHECK-NEXT:     Maps copy;
// CHECK-NEXT:     Fill(filled);
// CHECK-NEXT:     copy = filled;
// CHECK-NEXT:     Pair pair;
// CHECK-NEXT:     pair.maps[0] = filled;
// CHECK-NEXT:     pair.maps[1] = copy;
// CHECK-NEXT:     pair.weight = 2.0;
// CHECK-NEXT:     chosen_index = globals.which;
// CHECK-NEXT:     vec4 r = Read(in_TEXCOORD0);
// CHECK-NEXT:     r += Read_2(in_TEXCOORD0) + Twice(in_TEXCOORD0) + Twice_2(in_TEXCOORD0) + Twice(in_TEXCOORD0, id);
// CHECK-NEXT:     Maps temporary;
// CHECK-NEXT:     r += Get(filled, in_TEXCOORD0) + Get_2(copy, in_TEXCOORD0) + Get_2(pair.maps[1], in_TEXCOORD0) * pair.weight + (temporary = Make(), Get_3(temporary, in_TEXCOORD0));
// CHECK-NEXT:     r += Read(in_TEXCOORD0, chosen_index) + textureLod(stone, in_TEXCOORD0, 0.0) + Offset(id);
// CHECK-NEXT:     gl_Position = r + textureLod(material_map, in_TEXCOORD0, 0.0) * globals.material.scale;
// CHECK-NEXT: }

// VULKAN: #version 460
// VULKAN-EMPTY:
// VULKAN-NEXT: struct Maps {
// VULKAN-NEXT:     float level;
// VULKAN-NEXT: };
// VULKAN-EMPTY:
// VULKAN-NEXT: struct Material {
// VULKAN-NEXT:     vec4 scale;
// VULKAN-NEXT: };
// VULKAN-EMPTY:
// VULKAN-NEXT: struct Pair {
// VULKAN-NEXT:     Maps maps[2];
// VULKAN-NEXT:     float weight;
// VULKAN-NEXT: };
// VULKAN-EMPTY:
// VULKAN-NEXT: layout(std140, set = 0, binding = 0) uniform Globals {  // b0
// VULKAN-NEXT:     Material material;
// VULKAN-NEXT:     int which;
// VULKAN-NEXT: } globals;
// VULKAN-EMPTY:
// VULKAN-NEXT: layout(set = 0, binding = 32) uniform texture2D wood;  // t0
// VULKAN-NEXT: layout(set = 0, binding = 33) uniform texture2D stone;  // t1
// VULKAN-NEXT: layout(set = 0, binding = 34) uniform texture2D many[4];  // t2
// VULKAN-NEXT: layout(set = 0, binding = 16) uniform sampler smooth_;  // s0
// VULKAN-NEXT: layout(std430, set = 0, binding = 38) readonly buffer offsets_block {  // t6
// VULKAN-NEXT:     vec4 offsets[];
// VULKAN-NEXT: };
// VULKAN-NEXT: layout(set = 0, binding = 39) uniform texture2D material_map;  // t7
// VULKAN-EMPTY:
// VULKAN-NEXT: layout(location = 0) in vec2 in_TEXCOORD0;  // uv : TEXCOORD0
// VULKAN-EMPTY:
// VULKAN-NEXT: void Fill(out Maps maps) {
// VULKAN-NEXT:     maps.level = 2.0;
// VULKAN-NEXT: }
// VULKAN-EMPTY:
// VULKAN-NEXT: vec4 Read(vec2 uv) {
// VULKAN-NEXT:     return textureLod(sampler2D(wood, smooth_), uv, 0.0);
// VULKAN-NEXT: }
// VULKAN-EMPTY:
// VULKAN-NEXT: vec4 Read_2(vec2 uv) {
// VULKAN-NEXT:     return textureLod(sampler2D(stone, smooth_), uv, 0.0);
// VULKAN-NEXT: }
// VULKAN-EMPTY:
// VULKAN-NEXT: vec4 Twice(vec2 uv) {
// VULKAN-NEXT:     return Read_2(uv) + Read_2(uv + 1.0);
// VULKAN-NEXT: }
// VULKAN-EMPTY:
// VULKAN-NEXT: vec4 Read_3(vec2 uv) {
// VULKAN-NEXT:     return textureLod(sampler2D(many[2], smooth_), uv, 0.0);
// VULKAN-NEXT: }
// VULKAN-EMPTY:
// VULKAN-NEXT: vec4 Twice_2(vec2 uv) {
// VULKAN-NEXT:     return Read_3(uv) + Read_3(uv + 1.0);
// VULKAN-NEXT: }
// VULKAN-EMPTY:
// VULKAN-NEXT: vec4 Read(vec2 uv, uint many_index) {
// VULKAN-NEXT:     return textureLod(sampler2D(many[many_index], smooth_), uv, 0.0);
// VULKAN-NEXT: }
// VULKAN-EMPTY:
// VULKAN-NEXT: vec4 Twice(vec2 uv, uint many_index) {
// VULKAN-NEXT:     return Read(uv, many_index) + Read(uv + 1.0, many_index);
// VULKAN-NEXT: }
// VULKAN-EMPTY:
// VULKAN-NEXT: vec4 Get(inout Maps self, vec2 uv) {
// VULKAN-NEXT:     return textureLod(sampler2D(stone, smooth_), uv, self.level) + textureLod(sampler2D(wood, smooth_), uv, 0.0);
// VULKAN-NEXT: }
// VULKAN-EMPTY:
// VULKAN-NEXT: vec4 Get_2(inout Maps self, vec2 uv) {
// VULKAN-NEXT:     return textureLod(sampler2D(wood, smooth_), uv, self.level) + textureLod(sampler2D(wood, smooth_), uv, 0.0);
// VULKAN-NEXT: }
// VULKAN-EMPTY:
// VULKAN-NEXT: Maps Make() {
// VULKAN-NEXT:     Maps maps = Maps(1.0);
// VULKAN-NEXT:     return maps;
// VULKAN-NEXT: }
// VULKAN-EMPTY:
// VULKAN-NEXT: vec4 Get_3(inout Maps self, vec2 uv) {
// VULKAN-NEXT:     return textureLod(sampler2D(stone, smooth_), uv, self.level) + textureLod(sampler2D(stone, smooth_), uv, 0.0);
// VULKAN-NEXT: }
// VULKAN-EMPTY:
// VULKAN-NEXT: vec4 Read(vec2 uv, int many_index) {
// VULKAN-NEXT:     return textureLod(sampler2D(many[many_index], smooth_), uv, 0.0);
// VULKAN-NEXT: }
// VULKAN-EMPTY:
// VULKAN-NEXT: vec4 Offset(uint i) {
// VULKAN-NEXT:     return offsets[i];
// VULKAN-NEXT: }
// VULKAN-EMPTY:
// VULKAN-NEXT: void main() {
// VULKAN-NEXT:     uint id = uint(gl_VertexIndex - gl_BaseVertex);
// VULKAN-NEXT:     int chosen_index;
// VULKAN-NEXT:     Maps filled;
// VULKAN-NEXT:     Maps copy;
// VULKAN-NEXT:     Fill(filled);
// VULKAN-NEXT:     copy = filled;
// VULKAN-NEXT:     Pair pair;
// VULKAN-NEXT:     pair.maps[0] = filled;
// VULKAN-NEXT:     pair.maps[1] = copy;
// VULKAN-NEXT:     pair.weight = 2.0;
// VULKAN-NEXT:     chosen_index = globals.which;
// VULKAN-NEXT:     vec4 r = Read(in_TEXCOORD0);
// VULKAN-NEXT:     r += Read_2(in_TEXCOORD0) + Twice(in_TEXCOORD0) + Twice_2(in_TEXCOORD0) + Twice(in_TEXCOORD0, id);
// VULKAN-NEXT:     Maps temporary;
// VULKAN-NEXT:     r += Get(filled, in_TEXCOORD0) + Get_2(copy, in_TEXCOORD0) + Get_2(pair.maps[1], in_TEXCOORD0) * pair.weight + (temporary = Make(), Get_3(temporary, in_TEXCOORD0));
// VULKAN-NEXT:     r += Read(in_TEXCOORD0, chosen_index) + textureLod(sampler2D(stone, smooth_), in_TEXCOORD0, 0.0) + Offset(id);
// VULKAN-NEXT:     gl_Position = r + textureLod(sampler2D(material_map, smooth_), in_TEXCOORD0, 0.0) * globals.material.scale;
// VULKAN-NEXT: }
