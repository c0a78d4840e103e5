// Names and locations come from the semantics; each target says of them what it can.
// RUN: %clipc -T vs_5_0 --target=glsl410 --validate %s -o - | FileCheck %s --check-prefix=GL410
// RUN: %clipc -T vs_5_0 --target=glsl330 --validate %s -o - | FileCheck %s --check-prefix=GL330
// RUN: %clipc -T vs_5_0 --target=glsl130 --validate %s -o - | FileCheck %s --check-prefix=GL130
// RUN: %clipc -T vs_5_0 --target=glsl120 -DFLOATS --validate %s -o - | FileCheck %s --check-prefix=GL120
// RUN: %clipc -T vs_5_0 --target=essl300 --validate %s -o - | FileCheck %s --check-prefix=ES300
// RUN: %clipc -T vs_5_0 --target=essl310 --validate %s -o - | FileCheck %s --check-prefix=ES310
// AUTOUPDATE
struct Input {
  float3 position : POSITION;
  float2 uv[2] : TexCoord3;
  row_major float2x3 instance : INSTANCE;
  bool mirrored : MIRRORED;
  int4 bones : BLENDINDICES;
};
struct Output {
  float4 position : SV_Position;
  centroid float3 normal : NORMAL;
  float2 uv[2] : TEXCOORD0;
#ifndef FLOATS
  uint id : ID;
  nointerpolation float flat_one : FLAT;
#endif
};

Output main(Input input) {
  Output output;
  output.position = float4(input.position, 1);
  output.normal = mul(input.uv[1], input.instance) + input.bones.xyz;
  output.uv = input.uv;
  if (input.mirrored) output.uv[0].x = 1 - output.uv[0].x;
#ifndef FLOATS
  output.id = input.bones.w;
  output.flat_one = input.bones.x;
#endif
  return output;
}

// GL410: #version 410
// GL410-EMPTY:
// GL410-NEXT: layout(location = 0) in vec3 in_POSITION0;  // position : POSITION0
// GL410-NEXT: layout(location = 1) in vec2 in_TEXCOORD3;  // uv : TexCoord3
// GL410-NEXT: layout(location = 2) in vec2 in_TEXCOORD4;  // uv : TexCoord4
// GL410-NEXT: layout(location = 3) in vec3 in_INSTANCE0;  // instance : INSTANCE0
// GL410-NEXT: layout(location = 4) in vec3 in_INSTANCE1;  // instance : INSTANCE1
// GL410-NEXT: layout(location = 5) in uint in_MIRRORED0;  // mirrored : MIRRORED0
// GL410-NEXT: layout(location = 6) in ivec4 in_BLENDINDICES0;  // bones : BLENDINDICES0
// GL410-EMPTY:
// GL410-NEXT: layout(location = 0) centroid out vec3 vs_NORMAL0;  // normal : NORMAL0
// GL410-NEXT: layout(location = 1) out vec2 vs_TEXCOORD0;  // uv : TEXCOORD0
// GL410-NEXT: layout(location = 2) out vec2 vs_TEXCOORD1;  // uv : TEXCOORD1
// GL410-NEXT: layout(location = 3) flat out uint vs_ID0;  // id : ID0
// GL410-NEXT: layout(location = 4) flat out float vs_FLAT0;  // flat_one : FLAT0
// GL410-EMPTY:
// GL410-NEXT: void main() {
// GL410-NEXT:     vec2 uv[2];
// GL410-NEXT:     mat2x3 instance;
// GL410-NEXT:     uv[0] = in_TEXCOORD3;
// GL410-NEXT:     uv[1] = in_TEXCOORD4;
// GL410-NEXT:     instance[0] = in_INSTANCE0;
// GL410-NEXT:     instance[1] = in_INSTANCE1;
// GL410-NEXT:     bool mirrored = bool(in_MIRRORED0);
// GL410-NEXT:     gl_Position = vec4(in_POSITION0, 1.0);
// GL410-NEXT:     vs_NORMAL0 = instance * uv[1] + vec3(in_BLENDINDICES0.xyz);
// GL410-NEXT:     vec2 uv_2[2] = uv;
// GL410-NEXT:     if (mirrored) {
// GL410-NEXT:         uv_2[0].x = 1.0 - uv_2[0].x;
// GL410-NEXT:     }
// GL410-NEXT:     vs_ID0 = uint(in_BLENDINDICES0.w);
// GL410-NEXT:     vs_FLAT0 = float(in_BLENDINDICES0.x);
// GL410-NEXT:     vs_TEXCOORD0 = uv_2[0];
// GL410-NEXT:     vs_TEXCOORD1 = uv_2[1];
// GL410-NEXT: }

// GL330: #version 330
// GL330-EMPTY:
// GL330-NEXT: layout(location = 0) in vec3 in_POSITION0;  // position : POSITION0
// GL330-NEXT: layout(location = 1) in vec2 in_TEXCOORD3;  // uv : TexCoord3
// GL330-NEXT: layout(location = 2) in vec2 in_TEXCOORD4;  // uv : TexCoord4
// GL330-NEXT: layout(location = 3) in vec3 in_INSTANCE0;  // instance : INSTANCE0
// GL330-NEXT: layout(location = 4) in vec3 in_INSTANCE1;  // instance : INSTANCE1
// GL330-NEXT: layout(location = 5) in uint in_MIRRORED0;  // mirrored : MIRRORED0
// GL330-NEXT: layout(location = 6) in ivec4 in_BLENDINDICES0;  // bones : BLENDINDICES0
// GL330-EMPTY:
// GL330-NEXT: centroid out vec3 vs_NORMAL0;  // normal : NORMAL0
// GL330-NEXT: out vec2 vs_TEXCOORD0;  // uv : TEXCOORD0
// GL330-NEXT: out vec2 vs_TEXCOORD1;  // uv : TEXCOORD1
// GL330-NEXT: flat out uint vs_ID0;  // id : ID0
// GL330-NEXT: flat out float vs_FLAT0;  // flat_one : FLAT0
// GL330-EMPTY:
// GL330-NEXT: void main() {
// GL330-NEXT:     vec2 uv[2];
// GL330-NEXT:     mat2x3 instance;
// GL330-NEXT:     uv[0] = in_TEXCOORD3;
// GL330-NEXT:     uv[1] = in_TEXCOORD4;
// GL330-NEXT:     instance[0] = in_INSTANCE0;
// GL330-NEXT:     instance[1] = in_INSTANCE1;
// GL330-NEXT:     bool mirrored = bool(in_MIRRORED0);
// GL330-NEXT:     gl_Position = vec4(in_POSITION0, 1.0);
// GL330-NEXT:     vs_NORMAL0 = instance * uv[1] + vec3(in_BLENDINDICES0.xyz);
// GL330-NEXT:     vec2 uv_2[2] = uv;
// GL330-NEXT:     if (mirrored) {
// GL330-NEXT:         uv_2[0].x = 1.0 - uv_2[0].x;
// GL330-NEXT:     }
// GL330-NEXT:     vs_ID0 = uint(in_BLENDINDICES0.w);
// GL330-NEXT:     vs_FLAT0 = float(in_BLENDINDICES0.x);
// GL330-NEXT:     vs_TEXCOORD0 = uv_2[0];
// GL330-NEXT:     vs_TEXCOORD1 = uv_2[1];
// GL330-NEXT: }

// GL130: #version 130
// GL130-EMPTY:
// GL130-NEXT: in vec3 in_POSITION0;  // position : POSITION0
// GL130-NEXT: in vec2 in_TEXCOORD3;  // uv : TexCoord3
// GL130-NEXT: in vec2 in_TEXCOORD4;  // uv : TexCoord4
// GL130-NEXT: in vec3 in_INSTANCE0;  // instance : INSTANCE0
// GL130-NEXT: in vec3 in_INSTANCE1;  // instance : INSTANCE1
// GL130-NEXT: in uint in_MIRRORED0;  // mirrored : MIRRORED0
// GL130-NEXT: in ivec4 in_BLENDINDICES0;  // bones : BLENDINDICES0
// GL130-EMPTY:
// GL130-NEXT: centroid out vec3 vs_NORMAL0;  // normal : NORMAL0
// GL130-NEXT: out vec2 vs_TEXCOORD0;  // uv : TEXCOORD0
// GL130-NEXT: out vec2 vs_TEXCOORD1;  // uv : TEXCOORD1
// GL130-NEXT: flat out uint vs_ID0;  // id : ID0
// GL130-NEXT: flat out float vs_FLAT0;  // flat_one : FLAT0
// GL130-EMPTY:
// GL130-NEXT: void main() {
// GL130-NEXT:     vec2 uv[2];
// GL130-NEXT:     mat2x3 instance;
// GL130-NEXT:     uv[0] = in_TEXCOORD3;
// GL130-NEXT:     uv[1] = in_TEXCOORD4;
// GL130-NEXT:     instance[0] = in_INSTANCE0;
// GL130-NEXT:     instance[1] = in_INSTANCE1;
// GL130-NEXT:     bool mirrored = bool(in_MIRRORED0);
// GL130-NEXT:     gl_Position = vec4(in_POSITION0, 1.0);
// GL130-NEXT:     vs_NORMAL0 = instance * uv[1] + vec3(in_BLENDINDICES0.xyz);
// GL130-NEXT:     vec2 uv_2[2] = uv;
// GL130-NEXT:     if (mirrored) {
// GL130-NEXT:         uv_2[0].x = 1.0 - uv_2[0].x;
// GL130-NEXT:     }
// GL130-NEXT:     vs_ID0 = uint(in_BLENDINDICES0.w);
// GL130-NEXT:     vs_FLAT0 = float(in_BLENDINDICES0.x);
// GL130-NEXT:     vs_TEXCOORD0 = uv_2[0];
// GL130-NEXT:     vs_TEXCOORD1 = uv_2[1];
// GL130-NEXT: }

// GL120: #version 120
// GL120-EMPTY:
// GL120-NEXT: attribute vec3 in_POSITION0;  // position : POSITION0
// GL120-NEXT: attribute vec2 in_TEXCOORD3;  // uv : TexCoord3
// GL120-NEXT: attribute vec2 in_TEXCOORD4;  // uv : TexCoord4
// GL120-NEXT: attribute vec3 in_INSTANCE0;  // instance : INSTANCE0
// GL120-NEXT: attribute vec3 in_INSTANCE1;  // instance : INSTANCE1
// GL120-NEXT: attribute float in_MIRRORED0;  // mirrored : MIRRORED0
// GL120-NEXT: attribute vec4 in_BLENDINDICES0;  // bones : BLENDINDICES0
// GL120-EMPTY:
// GL120-NEXT: centroid varying vec3 vs_NORMAL0;  // normal : NORMAL0
// GL120-NEXT: varying vec2 vs_TEXCOORD0;  // uv : TEXCOORD0
// GL120-NEXT: varying vec2 vs_TEXCOORD1;  // uv : TEXCOORD1
// GL120-EMPTY:
// GL120-NEXT: void main() {
// GL120-NEXT:     vec2 uv[2];
// GL120-NEXT:     mat2x3 instance;
// GL120-NEXT:     uv[0] = in_TEXCOORD3;
// GL120-NEXT:     uv[1] = in_TEXCOORD4;
// GL120-NEXT:     instance[0] = in_INSTANCE0;
// GL120-NEXT:     instance[1] = in_INSTANCE1;
// GL120-NEXT:     bool mirrored = bool(int(in_MIRRORED0));
// GL120-NEXT:     gl_Position = vec4(in_POSITION0, 1.0);
// GL120-NEXT:     vs_NORMAL0 = instance * uv[1] + vec3(ivec4(in_BLENDINDICES0).xyz);
// GL120-NEXT:     vec2 uv_2[2] = uv;
// GL120-NEXT:     if (mirrored) {
// GL120-NEXT:         uv_2[0].x = 1.0 - uv_2[0].x;
// GL120-NEXT:     }
// GL120-NEXT:     vs_TEXCOORD0 = uv_2[0];
// GL120-NEXT:     vs_TEXCOORD1 = uv_2[1];
// GL120-NEXT: }

// ES300: #version 300 es
// ES300-EMPTY:
// ES300-NEXT: layout(location = 0) in vec3 in_POSITION0;  // position : POSITION0
// ES300-NEXT: layout(location = 1) in vec2 in_TEXCOORD3;  // uv : TexCoord3
// ES300-NEXT: layout(location = 2) in vec2 in_TEXCOORD4;  // uv : TexCoord4
// ES300-NEXT: layout(location = 3) in vec3 in_INSTANCE0;  // instance : INSTANCE0
// ES300-NEXT: layout(location = 4) in vec3 in_INSTANCE1;  // instance : INSTANCE1
// ES300-NEXT: layout(location = 5) in uint in_MIRRORED0;  // mirrored : MIRRORED0
// ES300-NEXT: layout(location = 6) in ivec4 in_BLENDINDICES0;  // bones : BLENDINDICES0
// ES300-EMPTY:
// ES300-NEXT: centroid out vec3 vs_NORMAL0;  // normal : NORMAL0
// ES300-NEXT: out vec2 vs_TEXCOORD0;  // uv : TEXCOORD0
// ES300-NEXT: out vec2 vs_TEXCOORD1;  // uv : TEXCOORD1
// ES300-NEXT: flat out uint vs_ID0;  // id : ID0
// ES300-NEXT: flat out float vs_FLAT0;  // flat_one : FLAT0
// ES300-EMPTY:
// ES300-NEXT: void main() {
// ES300-NEXT:     vec2 uv[2];
// ES300-NEXT:     mat2x3 instance;
// ES300-NEXT:     uv[0] = in_TEXCOORD3;
// ES300-NEXT:     uv[1] = in_TEXCOORD4;
// ES300-NEXT:     instance[0] = in_INSTANCE0;
// ES300-NEXT:     instance[1] = in_INSTANCE1;
// ES300-NEXT:     bool mirrored = bool(in_MIRRORED0);
// ES300-NEXT:     gl_Position = vec4(in_POSITION0, 1.0);
// ES300-NEXT:     vs_NORMAL0 = instance * uv[1] + vec3(in_BLENDINDICES0.xyz);
// ES300-NEXT:     vec2 uv_2[2] = uv;
// ES300-NEXT:     if (mirrored) {
// ES300-NEXT:         uv_2[0].x = 1.0 - uv_2[0].x;
// ES300-NEXT:     }
// ES300-NEXT:     vs_ID0 = uint(in_BLENDINDICES0.w);
// ES300-NEXT:     vs_FLAT0 = float(in_BLENDINDICES0.x);
// ES300-NEXT:     vs_TEXCOORD0 = uv_2[0];
// ES300-NEXT:     vs_TEXCOORD1 = uv_2[1];
// ES300-NEXT: }

// ES310: #version 310 es
// ES310-EMPTY:
// ES310-NEXT: layout(location = 0) in vec3 in_POSITION0;  // position : POSITION0
// ES310-NEXT: layout(location = 1) in vec2 in_TEXCOORD3;  // uv : TexCoord3
// ES310-NEXT: layout(location = 2) in vec2 in_TEXCOORD4;  // uv : TexCoord4
// ES310-NEXT: layout(location = 3) in vec3 in_INSTANCE0;  // instance : INSTANCE0
// ES310-NEXT: layout(location = 4) in vec3 in_INSTANCE1;  // instance : INSTANCE1
// ES310-NEXT: layout(location = 5) in uint in_MIRRORED0;  // mirrored : MIRRORED0
// ES310-NEXT: layout(location = 6) in ivec4 in_BLENDINDICES0;  // bones : BLENDINDICES0
// ES310-EMPTY:
// ES310-NEXT: layout(location = 0) centroid out vec3 vs_NORMAL0;  // normal : NORMAL0
// ES310-NEXT: layout(location = 1) out vec2 vs_TEXCOORD0;  // uv : TEXCOORD0
// ES310-NEXT: layout(location = 2) out vec2 vs_TEXCOORD1;  // uv : TEXCOORD1
// ES310-NEXT: layout(location = 3) flat out uint vs_ID0;  // id : ID0
// ES310-NEXT: layout(location = 4) flat out float vs_FLAT0;  // flat_one : FLAT0
// ES310-EMPTY:
// ES310-NEXT: void main() {
// ES310-NEXT:     vec2 uv[2];
// ES310-NEXT:     mat2x3 instance;
// ES310-NEXT:     uv[0] = in_TEXCOORD3;
// ES310-NEXT:     uv[1] = in_TEXCOORD4;
// ES310-NEXT:     instance[0] = in_INSTANCE0;
// ES310-NEXT:     instance[1] = in_INSTANCE1;
// ES310-NEXT:     bool mirrored = bool(in_MIRRORED0);
// ES310-NEXT:     gl_Position = vec4(in_POSITION0, 1.0);
// ES310-NEXT:     vs_NORMAL0 = instance * uv[1] + vec3(in_BLENDINDICES0.xyz);
// ES310-NEXT:     vec2 uv_2[2] = uv;
// ES310-NEXT:     if (mirrored) {
// ES310-NEXT:         uv_2[0].x = 1.0 - uv_2[0].x;
// ES310-NEXT:     }
// ES310-NEXT:     vs_ID0 = uint(in_BLENDINDICES0.w);
// ES310-NEXT:     vs_FLAT0 = float(in_BLENDINDICES0.x);
// ES310-NEXT:     vs_TEXCOORD0 = uv_2[0];
// ES310-NEXT:     vs_TEXCOORD1 = uv_2[1];
// ES310-NEXT: }
