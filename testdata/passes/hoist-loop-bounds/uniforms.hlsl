// The bound of a loop is read once where it is a constant of the draw call; what else the condition reads stays there.
// RUN: %clipc -T vs_5_0 --verify --dump-after=hoist-loop-bounds --stop-after=hoist-loop-bounds %s | FileCheck %s
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s --check-prefix=GLSL
// RUN: %draw compare %s -T vs_5_0 --ints 0..5
// AUTOUPDATE
struct Light { int first; uint count; };
int lights;
Light range[2];
float4 color[100];
float4 main(float4 p : POSITION, int many : MANY, uniform int last) : SV_Position {
  for (int i = 0; i < lights; i++) p += color[i];
  for (int j = 0; j < last && j < many; ++j) p *= 2;
  uint k = 0;
  while (k + 1 < range[1].count * 2) p.x += k++;
  // A bound that the loop changes, and none at all.
  for (int l = 0; l < many; l++) many -= lights;
  if (p.x > 0) while (k < (uint)lights) p.y += k++;
  switch (many) {
    case 1:
      for (int m = 0; m != lights; m++) p.z += m;
      break;
  }
  for (int n = 0; n < 3; n++) p.w += n;
  return p;
}

// CHECK: program vs_5_0 form inlined
// CHECK-NEXT: struct Light {
// CHECK-NEXT:   int first
// CHECK-NEXT:   uint count
// CHECK-NEXT: }
// CHECK-NEXT: globals $Globals : b0, 1648 bytes {
// CHECK-NEXT:   int lights at 0, 4 bytes
// CHECK-NEXT:   Light range[2] at 16, 24 bytes
// CHECK-NEXT:   float4 color[100] at 48, 1600 bytes
// CHECK-NEXT: }
// CHECK-NEXT: params $Params : b1, 16 bytes {
// CHECK-NEXT:   int last.1 at 0, 4 bytes
// CHECK-NEXT: }
// CHECK-NEXT: input float4 in_POSITION0 : POSITION0 location 0
// CHECK-NEXT: input int in_MANY0 : MANY0 location 1
// CHECK-NEXT: output float4 vs_SV_POSITION0 : SV_Position0 builtin position
// CHECK-NEXT: entry void main() {
// CHECK-NEXT: }
// CHECK-NEXT: main void main.1() {
// CHECK-NEXT:   vs_SV_POSITION0 = in_POSITION0
// CHECK-NEXT:   int many = in_MANY0
// CHECK-NEXT:   int lights.1 = lights
// CHECK-NEXT:   for (int i = 0; i < lights.1; i++) {
// CHECK-NEXT:     vs_SV_POSITION0 += color[i]
// CHECK-NEXT:   }
// CHECK-NEXT:   int last.2 = last.1
// CHECK-NEXT:   for (int j = 0; (j < last.2) && (j < many); ++j) {
// CHECK-NEXT:     vs_SV_POSITION0 *= splat<float4>(2.0)
// CHECK-NEXT:   }
// CHECK-NEXT:   uint k = 0u
// CHECK-NEXT:   uint count = range[1].count * 2u
// CHECK-NEXT:   while ((k + 1u) < count) {
// CHECK-NEXT:     vs_SV_POSITION0.x += convert<float>(k++)
// CHECK-NEXT:   }
// CHECK-NEXT:   for (int l = 0; l < many; l++) {
// CHECK-NEXT:     many -= lights
// CHECK-NEXT:   }
// CHECK-NEXT:   if (vs_SV_POSITION0.x > 0.0) {
// CHECK-NEXT:     uint lights.2 = convert<uint>(lights)
// CHECK-NEXT:     while (k < lights.2) {
// CHECK-NEXT:       vs_SV_POSITION0.y += convert<float>(k++)
// CHECK-NEXT:     }
// CHECK-NEXT:   }
// CHECK-NEXT:   switch (many) {
// CHECK-NEXT:   case 1:
// CHECK-NEXT:     int lights.3 = lights
// CHECK-NEXT:     for (int m = 0; m != lights.3; m++) {
// CHECK-NEXT:       vs_SV_POSITION0.z += convert<float>(m)
// CHECK-NEXT:     }
// CHECK-NEXT:     break
// CHECK-NEXT:   }
// CHECK-NEXT:   for (int n = 0; n < 3; n++) {
// CHECK-NEXT:     vs_SV_POSITION0.w += convert<float>(n)
// CHECK-NEXT:   }
// CHECK-NEXT: }

// GLSL: #version 450
// GLSL-EMPTY:
// GLSL-NEXT: struct Light {
// GLSL-NEXT:     int first;
// GLSL-NEXT:     uint count;
// GLSL-NEXT: };
// GLSL-EMPTY:
// GLSL-NEXT: layout(std140, binding = 0) uniform Globals {  // b0
// GLSL-NEXT:     int lights;
// GLSL-NEXT:     Light range[2];
// GLSL-NEXT:     vec4 color[100];
// GLSL-NEXT: } globals;
// GLSL-EMPTY:
// GLSL-NEXT: layout(std140, binding = 1) uniform Params {  // b1
// GLSL-NEXT:     int last;
// GLSL-NEXT: } params;
// GLSL-EMPTY:
// GLSL-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// GLSL-NEXT: layout(location = 1) in int in_MANY0;  // many : MANY0
// GLSL-EMPTY:
// GLSL-NEXT: void main() {
// GLSL-NEXT:     gl_Position = in_POSITION0;
// GLSL-NEXT:     int many = in_MANY0;
// GLSL-NEXT:     int lights = globals.lights;
// GLSL-NEXT:     for (int i = 0; i < lights; i++) {
// GLSL-NEXT:         gl_Position += globals.color[i];
// GLSL-NEXT:     }
// GLSL-NEXT:     int last = params.last;
// GLSL-NEXT:     for (int j = 0; j < last && j < many; ++j) {
// GLSL-NEXT:         gl_Position *= 2.0;
// GLSL-NEXT:     }
// GLSL-NEXT:     uint k = 0u;
// GLSL-NEXT:     uint count = globals.range[1].count * 2u;
// GLSL-NEXT:     while (k + 1u < count) {
// GLSL-NEXT:         gl_Position.x += float(k++);
// GLSL-NEXT:     }
// GLSL-NEXT:     for (int l = 0; l < many; l++) {
// GLSL-NEXT:         many -= globals.lights;
// GLSL-NEXT:     }
// GLSL-NEXT:     if (gl_Position.x > 0.0) {
// GLSL-NEXT:         uint lights_2 = uint(globals.lights);
// GLSL-NEXT:         while (k < lights_2) {
// GLSL-NEXT:             gl_Position.y += float(k++);
// GLSL-NEXT:         }
// GLSL-NEXT:     }
// GLSL-NEXT:     switch (many) {
// GLSL-NEXT:     case 1:
// GLSL-NEXT:         int lights_2 = globals.lights;
// GLSL-NEXT:         for (int m = 0; m != lights_2; m++) {
// GLSL-NEXT:             gl_Position.z += float(m);
// GLSL-NEXT:         }
// GLSL-NEXT:         break;
// GLSL-NEXT:     }
// GLSL-NEXT:     for (int n = 0; n < 3; n++) {
// GLSL-NEXT:         gl_Position.w += float(n);
// GLSL-NEXT:     }
// GLSL-NEXT: }
