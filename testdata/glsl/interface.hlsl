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
// GL410-NEXT: struct Input {
// GL410-NEXT:     vec3 position;
// GL410-NEXT:     vec2 uv[2];
// GL410-NEXT:     mat2x3 instance;
// GL410-NEXT:     bool mirrored;
// GL410-NEXT:     ivec4 bones;
// GL410-NEXT: };
// GL410-EMPTY:
// GL410-NEXT: struct Output {
// GL410-NEXT:     vec4 position;
// GL410-NEXT:     vec3 normal;
// GL410-NEXT:     vec2 uv[2];
// GL410-NEXT:     uint id;
// GL410-NEXT:     float flat_one;
// GL410-NEXT: };
// GL410-EMPTY:
// GL410-NEXT: layout(location = 0) in vec3 in_POSITION0;  // POSITION0
// GL410-NEXT: layout(location = 1) in vec2 in_TEXCOORD3;  // TexCoord3
// GL410-NEXT: layout(location = 2) in vec2 in_TEXCOORD4;  // TexCoord4
// GL410-NEXT: layout(location = 3) in vec3 in_INSTANCE0;  // INSTANCE0
// GL410-NEXT: layout(location = 4) in vec3 in_INSTANCE1;  // INSTANCE1
// GL410-NEXT: layout(location = 5) in uint in_MIRRORED0;  // MIRRORED0
// GL410-NEXT: layout(location = 6) in ivec4 in_BLENDINDICES0;  // BLENDINDICES0
// GL410-EMPTY:
// GL410-NEXT: layout(location = 0) centroid out vec3 vs_NORMAL0;  // NORMAL0
// GL410-NEXT: layout(location = 1) out vec2 vs_TEXCOORD0;  // TEXCOORD0
// GL410-NEXT: layout(location = 2) out vec2 vs_TEXCOORD1;  // TEXCOORD1
// GL410-NEXT: layout(location = 3) flat out uint vs_ID0;  // ID0
// GL410-NEXT: layout(location = 4) flat out float vs_FLAT0;  // FLAT0
// GL410-EMPTY:
// GL410-NEXT: Output shader_main(Input input_) {
// GL410-NEXT:     Output output_;
// GL410-NEXT:     output_.position = vec4(input_.position, 1.0);
// GL410-NEXT:     output_.normal = input_.instance * input_.uv[1] + vec3(input_.bones.xyz);
// GL410-NEXT:     output_.uv = input_.uv;
// GL410-NEXT:     if (input_.mirrored) {
// GL410-NEXT:         output_.uv[0].x = 1.0 - output_.uv[0].x;
// GL410-NEXT:     }
// GL410-NEXT:     output_.id = uint(input_.bones.w);
// GL410-NEXT:     output_.flat_one = float(input_.bones.x);
// GL410-NEXT:     return output_;
// GL410-NEXT: }
// GL410-EMPTY:
// GL410-NEXT: void main() {
// GL410-NEXT:     Input input_;
// GL410-NEXT:     input_.position = in_POSITION0;
// GL410-NEXT:     input_.uv[0] = in_TEXCOORD3;
// GL410-NEXT:     input_.uv[1] = in_TEXCOORD4;
// GL410-NEXT:     input_.instance[0] = in_INSTANCE0;
// GL410-NEXT:     input_.instance[1] = in_INSTANCE1;
// GL410-NEXT:     input_.mirrored = bool(in_MIRRORED0);
// GL410-NEXT:     input_.bones = in_BLENDINDICES0;
// GL410-NEXT:     Output result = shader_main(input_);
// GL410-NEXT:     gl_Position = result.position;
// GL410-NEXT:     vs_NORMAL0 = result.normal;
// GL410-NEXT:     vs_TEXCOORD0 = result.uv[0];
// GL410-NEXT:     vs_TEXCOORD1 = result.uv[1];
// GL410-NEXT:     vs_ID0 = result.id;
// GL410-NEXT:     vs_FLAT0 = result.flat_one;
// GL410-NEXT: }

// GL330: #version 330
// GL330-EMPTY:
// GL330-NEXT: struct Input {
// GL330-NEXT:     vec3 position;
// GL330-NEXT:     vec2 uv[2];
// GL330-NEXT:     mat2x3 instance;
// GL330-NEXT:     bool mirrored;
// GL330-NEXT:     ivec4 bones;
// GL330-NEXT: };
// GL330-EMPTY:
// GL330-NEXT: struct Output {
// GL330-NEXT:     vec4 position;
// GL330-NEXT:     vec3 normal;
// GL330-NEXT:     vec2 uv[2];
// GL330-NEXT:     uint id;
// GL330-NEXT:     float flat_one;
// GL330-NEXT: };
// GL330-EMPTY:
// GL330-NEXT: layout(location = 0) in vec3 in_POSITION0;  // POSITION0
// GL330-NEXT: layout(location = 1) in vec2 in_TEXCOORD3;  // TexCoord3
// GL330-NEXT: layout(location = 2) in vec2 in_TEXCOORD4;  // TexCoord4
// GL330-NEXT: layout(location = 3) in vec3 in_INSTANCE0;  // INSTANCE0
// GL330-NEXT: layout(location = 4) in vec3 in_INSTANCE1;  // INSTANCE1
// GL330-NEXT: layout(location = 5) in uint in_MIRRORED0;  // MIRRORED0
// GL330-NEXT: layout(location = 6) in ivec4 in_BLENDINDICES0;  // BLENDINDICES0
// GL330-EMPTY:
// GL330-NEXT: centroid out vec3 vs_NORMAL0;  // NORMAL0
// GL330-NEXT: out vec2 vs_TEXCOORD0;  // TEXCOORD0
// GL330-NEXT: out vec2 vs_TEXCOORD1;  // TEXCOORD1
// GL330-NEXT: flat out uint vs_ID0;  // ID0
// GL330-NEXT: flat out float vs_FLAT0;  // FLAT0
// GL330-EMPTY:
// GL330-NEXT: Output shader_main(Input input_) {
// GL330-NEXT:     Output output_;
// GL330-NEXT:     output_.position = vec4(input_.position, 1.0);
// GL330-NEXT:     output_.normal = input_.instance * input_.uv[1] + vec3(input_.bones.xyz);
// GL330-NEXT:     output_.uv = input_.uv;
// GL330-NEXT:     if (input_.mirrored) {
// GL330-NEXT:         output_.uv[0].x = 1.0 - output_.uv[0].x;
// GL330-NEXT:     }
// GL330-NEXT:     output_.id = uint(input_.bones.w);
// GL330-NEXT:     output_.flat_one = float(input_.bones.x);
// GL330-NEXT:     return output_;
// GL330-NEXT: }
// GL330-EMPTY:
// GL330-NEXT: void main() {
// GL330-NEXT:     Input input_;
// GL330-NEXT:     input_.position = in_POSITION0;
// GL330-NEXT:     input_.uv[0] = in_TEXCOORD3;
// GL330-NEXT:     input_.uv[1] = in_TEXCOORD4;
// GL330-NEXT:     input_.instance[0] = in_INSTANCE0;
// GL330-NEXT:     input_.instance[1] = in_INSTANCE1;
// GL330-NEXT:     input_.mirrored = bool(in_MIRRORED0);
// GL330-NEXT:     input_.bones = in_BLENDINDICES0;
// GL330-NEXT:     Output result = shader_main(input_);
// GL330-NEXT:     gl_Position = result.position;
// GL330-NEXT:     vs_NORMAL0 = result.normal;
// GL330-NEXT:     vs_TEXCOORD0 = result.uv[0];
// GL330-NEXT:     vs_TEXCOORD1 = result.uv[1];
// GL330-NEXT:     vs_ID0 = result.id;
// GL330-NEXT:     vs_FLAT0 = result.flat_one;
// GL330-NEXT: }

// GL130: #version 130
// GL130-EMPTY:
// GL130-NEXT: struct Input {
// GL130-NEXT:     vec3 position;
// GL130-NEXT:     vec2 uv[2];
// GL130-NEXT:     mat2x3 instance;
// GL130-NEXT:     bool mirrored;
// GL130-NEXT:     ivec4 bones;
// GL130-NEXT: };
// GL130-EMPTY:
// GL130-NEXT: struct Output {
// GL130-NEXT:     vec4 position;
// GL130-NEXT:     vec3 normal;
// GL130-NEXT:     vec2 uv[2];
// GL130-NEXT:     uint id;
// GL130-NEXT:     float flat_one;
// GL130-NEXT: };
// GL130-EMPTY:
// GL130-NEXT: in vec3 in_POSITION0;  // POSITION0
// GL130-NEXT: in vec2 in_TEXCOORD3;  // TexCoord3
// GL130-NEXT: in vec2 in_TEXCOORD4;  // TexCoord4
// GL130-NEXT: in vec3 in_INSTANCE0;  // INSTANCE0
// GL130-NEXT: in vec3 in_INSTANCE1;  // INSTANCE1
// GL130-NEXT: in uint in_MIRRORED0;  // MIRRORED0
// GL130-NEXT: in ivec4 in_BLENDINDICES0;  // BLENDINDICES0
// GL130-EMPTY:
// GL130-NEXT: centroid out vec3 vs_NORMAL0;  // NORMAL0
// GL130-NEXT: out vec2 vs_TEXCOORD0;  // TEXCOORD0
// GL130-NEXT: out vec2 vs_TEXCOORD1;  // TEXCOORD1
// GL130-NEXT: flat out uint vs_ID0;  // ID0
// GL130-NEXT: flat out float vs_FLAT0;  // FLAT0
// GL130-EMPTY:
// GL130-NEXT: Output shader_main(Input input_) {
// GL130-NEXT:     Output output_;
// GL130-NEXT:     output_.position = vec4(input_.position, 1.0);
// GL130-NEXT:     output_.normal = input_.instance * input_.uv[1] + vec3(input_.bones.xyz);
// GL130-NEXT:     output_.uv = input_.uv;
// GL130-NEXT:     if (input_.mirrored) {
// GL130-NEXT:         output_.uv[0].x = 1.0 - output_.uv[0].x;
// GL130-NEXT:     }
// GL130-NEXT:     output_.id = uint(input_.bones.w);
// GL130-NEXT:     output_.flat_one = float(input_.bones.x);
// GL130-NEXT:     return output_;
// GL130-NEXT: }
// GL130-EMPTY:
// GL130-NEXT: void main() {
// GL130-NEXT:     Input input_;
// GL130-NEXT:     input_.position = in_POSITION0;
// GL130-NEXT:     input_.uv[0] = in_TEXCOORD3;
// GL130-NEXT:     input_.uv[1] = in_TEXCOORD4;
// GL130-NEXT:     input_.instance[0] = in_INSTANCE0;
// GL130-NEXT:     input_.instance[1] = in_INSTANCE1;
// GL130-NEXT:     input_.mirrored = bool(in_MIRRORED0);
// GL130-NEXT:     input_.bones = in_BLENDINDICES0;
// GL130-NEXT:     Output result = shader_main(input_);
// GL130-NEXT:     gl_Position = result.position;
// GL130-NEXT:     vs_NORMAL0 = result.normal;
// GL130-NEXT:     vs_TEXCOORD0 = result.uv[0];
// GL130-NEXT:     vs_TEXCOORD1 = result.uv[1];
// GL130-NEXT:     vs_ID0 = result.id;
// GL130-NEXT:     vs_FLAT0 = result.flat_one;
// GL130-NEXT: }

// GL120: #version 120
// GL120-EMPTY:
// GL120-NEXT: struct Input {
// GL120-NEXT:     vec3 position;
// GL120-NEXT:     vec2 uv[2];
// GL120-NEXT:     mat2x3 instance;
// GL120-NEXT:     bool mirrored;
// GL120-NEXT:     ivec4 bones;
// GL120-NEXT: };
// GL120-EMPTY:
// GL120-NEXT: struct Output {
// GL120-NEXT:     vec4 position;
// GL120-NEXT:     vec3 normal;
// GL120-NEXT:     vec2 uv[2];
// GL120-NEXT: };
// GL120-EMPTY:
// GL120-NEXT: attribute vec3 in_POSITION0;  // POSITION0
// GL120-NEXT: attribute vec2 in_TEXCOORD3;  // TexCoord3
// GL120-NEXT: attribute vec2 in_TEXCOORD4;  // TexCoord4
// GL120-NEXT: attribute vec3 in_INSTANCE0;  // INSTANCE0
// GL120-NEXT: attribute vec3 in_INSTANCE1;  // INSTANCE1
// GL120-NEXT: attribute float in_MIRRORED0;  // MIRRORED0
// GL120-NEXT: attribute vec4 in_BLENDINDICES0;  // BLENDINDICES0
// GL120-EMPTY:
// GL120-NEXT: centroid varying vec3 vs_NORMAL0;  // NORMAL0
// GL120-NEXT: varying vec2 vs_TEXCOORD0;  // TEXCOORD0
// GL120-NEXT: varying vec2 vs_TEXCOORD1;  // TEXCOORD1
// GL120-EMPTY:
// GL120-NEXT: Output shader_main(Input input_) {
// GL120-NEXT:     Output output_;
// GL120-NEXT:     output_.position = vec4(input_.position, 1.0);
// GL120-NEXT:     output_.normal = input_.instance * input_.uv[1] + vec3(input_.bones.xyz);
// GL120-NEXT:     output_.uv = input_.uv;
// GL120-NEXT:     if (input_.mirrored) {
// GL120-NEXT:         output_.uv[0].x = 1.0 - output_.uv[0].x;
// GL120-NEXT:     }
// GL120-NEXT:     return output_;
// GL120-NEXT: }
// GL120-EMPTY:
// GL120-NEXT: void main() {
// GL120-NEXT:     Input input_;
// GL120-NEXT:     input_.position = in_POSITION0;
// GL120-NEXT:     input_.uv[0] = in_TEXCOORD3;
// GL120-NEXT:     input_.uv[1] = in_TEXCOORD4;
// GL120-NEXT:     input_.instance[0] = in_INSTANCE0;
// GL120-NEXT:     input_.instance[1] = in_INSTANCE1;
// GL120-NEXT:     input_.mirrored = bool(int(in_MIRRORED0));
// GL120-NEXT:     input_.bones = ivec4(in_BLENDINDICES0);
// GL120-NEXT:     Output result = shader_main(input_);
// GL120-NEXT:     gl_Position = result.position;
// GL120-NEXT:     vs_NORMAL0 = result.normal;
// GL120-NEXT:     vs_TEXCOORD0 = result.uv[0];
// GL120-NEXT:     vs_TEXCOORD1 = result.uv[1];
// GL120-NEXT: }

// ES300: #version 300 es
// ES300-EMPTY:
// ES300-NEXT: struct Input {
// ES300-NEXT:     vec3 position;
// ES300-NEXT:     vec2 uv[2];
// ES300-NEXT:     mat2x3 instance;
// ES300-NEXT:     bool mirrored;
// ES300-NEXT:     ivec4 bones;
// ES300-NEXT: };
// ES300-EMPTY:
// ES300-NEXT: struct Output {
// ES300-NEXT:     vec4 position;
// ES300-NEXT:     vec3 normal;
// ES300-NEXT:     vec2 uv[2];
// ES300-NEXT:     uint id;
// ES300-NEXT:     float flat_one;
// ES300-NEXT: };
// ES300-EMPTY:
// ES300-NEXT: layout(location = 0) in vec3 in_POSITION0;  // POSITION0
// ES300-NEXT: layout(location = 1) in vec2 in_TEXCOORD3;  // TexCoord3
// ES300-NEXT: layout(location = 2) in vec2 in_TEXCOORD4;  // TexCoord4
// ES300-NEXT: layout(location = 3) in vec3 in_INSTANCE0;  // INSTANCE0
// ES300-NEXT: layout(location = 4) in vec3 in_INSTANCE1;  // INSTANCE1
// ES300-NEXT: layout(location = 5) in uint in_MIRRORED0;  // MIRRORED0
// ES300-NEXT: layout(location = 6) in ivec4 in_BLENDINDICES0;  // BLENDINDICES0
// ES300-EMPTY:
// ES300-NEXT: centroid out vec3 vs_NORMAL0;  // NORMAL0
// ES300-NEXT: out vec2 vs_TEXCOORD0;  // TEXCOORD0
// ES300-NEXT: out vec2 vs_TEXCOORD1;  // TEXCOORD1
// ES300-NEXT: flat out uint vs_ID0;  // ID0
// ES300-NEXT: flat out float vs_FLAT0;  // FLAT0
// ES300-EMPTY:
// ES300-NEXT: Output shader_main(Input input_) {
// ES300-NEXT:     Output output_;
// ES300-NEXT:     output_.position = vec4(input_.position, 1.0);
// ES300-NEXT:     output_.normal = input_.instance * input_.uv[1] + vec3(input_.bones.xyz);
// ES300-NEXT:     output_.uv = input_.uv;
// ES300-NEXT:     if (input_.mirrored) {
// ES300-NEXT:         output_.uv[0].x = 1.0 - output_.uv[0].x;
// ES300-NEXT:     }
// ES300-NEXT:     output_.id = uint(input_.bones.w);
// ES300-NEXT:     output_.flat_one = float(input_.bones.x);
// ES300-NEXT:     return output_;
// ES300-NEXT: }
// ES300-EMPTY:
// ES300-NEXT: void main() {
// ES300-NEXT:     Input input_;
// ES300-NEXT:     input_.position = in_POSITION0;
// ES300-NEXT:     input_.uv[0] = in_TEXCOORD3;
// ES300-NEXT:     input_.uv[1] = in_TEXCOORD4;
// ES300-NEXT:     input_.instance[0] = in_INSTANCE0;
// ES300-NEXT:     input_.instance[1] = in_INSTANCE1;
// ES300-NEXT:     input_.mirrored = bool(in_MIRRORED0);
// ES300-NEXT:     input_.bones = in_BLENDINDICES0;
// ES300-NEXT:     Output result = shader_main(input_);
// ES300-NEXT:     gl_Position = result.position;
// ES300-NEXT:     vs_NORMAL0 = result.normal;
// ES300-NEXT:     vs_TEXCOORD0 = result.uv[0];
// ES300-NEXT:     vs_TEXCOORD1 = result.uv[1];
// ES300-NEXT:     vs_ID0 = result.id;
// ES300-NEXT:     vs_FLAT0 = result.flat_one;
// ES300-NEXT: }

// ES310: #version 310 es
// ES310-EMPTY:
// ES310-NEXT: struct Input {
// ES310-NEXT:     vec3 position;
// ES310-NEXT:     vec2 uv[2];
// ES310-NEXT:     mat2x3 instance;
// ES310-NEXT:     bool mirrored;
// ES310-NEXT:     ivec4 bones;
// ES310-NEXT: };
// ES310-EMPTY:
// ES310-NEXT: struct Output {
// ES310-NEXT:     vec4 position;
// ES310-NEXT:     vec3 normal;
// ES310-NEXT:     vec2 uv[2];
// ES310-NEXT:     uint id;
// ES310-NEXT:     float flat_one;
// ES310-NEXT: };
// ES310-EMPTY:
// ES310-NEXT: layout(location = 0) in vec3 in_POSITION0;  // POSITION0
// ES310-NEXT: layout(location = 1) in vec2 in_TEXCOORD3;  // TexCoord3
// ES310-NEXT: layout(location = 2) in vec2 in_TEXCOORD4;  // TexCoord4
// ES310-NEXT: layout(location = 3) in vec3 in_INSTANCE0;  // INSTANCE0
// ES310-NEXT: layout(location = 4) in vec3 in_INSTANCE1;  // INSTANCE1
// ES310-NEXT: layout(location = 5) in uint in_MIRRORED0;  // MIRRORED0
// ES310-NEXT: layout(location = 6) in ivec4 in_BLENDINDICES0;  // BLENDINDICES0
// ES310-EMPTY:
// ES310-NEXT: layout(location = 0) centroid out vec3 vs_NORMAL0;  // NORMAL0
// ES310-NEXT: layout(location = 1) out vec2 vs_TEXCOORD0;  // TEXCOORD0
// ES310-NEXT: layout(location = 2) out vec2 vs_TEXCOORD1;  // TEXCOORD1
// ES310-NEXT: layout(location = 3) flat out uint vs_ID0;  // ID0
// ES310-NEXT: layout(location = 4) flat out float vs_FLAT0;  // FLAT0
// ES310-EMPTY:
// ES310-NEXT: Output shader_main(Input input_) {
// ES310-NEXT:     Output output_;
// ES310-NEXT:     output_.position = vec4(input_.position, 1.0);
// ES310-NEXT:     output_.normal = input_.instance * input_.uv[1] + vec3(input_.bones.xyz);
// ES310-NEXT:     output_.uv = input_.uv;
// ES310-NEXT:     if (input_.mirrored) {
// ES310-NEXT:         output_.uv[0].x = 1.0 - output_.uv[0].x;
// ES310-NEXT:     }
// ES310-NEXT:     output_.id = uint(input_.bones.w);
// ES310-NEXT:     output_.flat_one = float(input_.bones.x);
// ES310-NEXT:     return output_;
// ES310-NEXT: }
// ES310-EMPTY:
// ES310-NEXT: void main() {
// ES310-NEXT:     Input input_;
// ES310-NEXT:     input_.position = in_POSITION0;
// ES310-NEXT:     input_.uv[0] = in_TEXCOORD3;
// ES310-NEXT:     input_.uv[1] = in_TEXCOORD4;
// ES310-NEXT:     input_.instance[0] = in_INSTANCE0;
// ES310-NEXT:     input_.instance[1] = in_INSTANCE1;
// ES310-NEXT:     input_.mirrored = bool(in_MIRRORED0);
// ES310-NEXT:     input_.bones = in_BLENDINDICES0;
// ES310-NEXT:     Output result = shader_main(input_);
// ES310-NEXT:     gl_Position = result.position;
// ES310-NEXT:     vs_NORMAL0 = result.normal;
// ES310-NEXT:     vs_TEXCOORD0 = result.uv[0];
// ES310-NEXT:     vs_TEXCOORD1 = result.uv[1];
// ES310-NEXT:     vs_ID0 = result.id;
// ES310-NEXT:     vs_FLAT0 = result.flat_one;
// ES310-NEXT: }
