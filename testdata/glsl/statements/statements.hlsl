// A case may lead to the next one from 6.0 on.
// RUN: %clipc -T vs_6_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_6_0 --target=glsl130 --validate %s -o %t
// RUN: %clipc -T vs_6_0 --target=glsl120 -DNO_SWITCH --validate %s -o %t
// AUTOUPDATE
int n;

float4 main(float4 p : POSITION) : SV_Position {
  float4 r = p;
  for (int i = 0, j = 4; i < j; ++i, j--) r += i;
  for (;;) { if (r.x > 1) break; r.x++; continue; }
  while (r.y < 1) r.y += 0.25;
  do r.z -= 1; while (r.z > 0);
  if (r.x > 0) r.x = 1;
  else if (r.x < 0) { r.x = 2; r.y = 3; }
  else return r;
#ifndef NO_SWITCH
  switch (n) {
    case 0:
    case 1: r.x += 1; break;
    case 2: { float x = 2; r.y += x; }
    default: r.z += 1; break;
    case -1: break;
  }
#endif
  ;
  { }
  return r;
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 0) uniform Globals {  // b0
// CHECK-NEXT:     int n;
// CHECK-NEXT: } globals;
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: vec4 shader_main(vec4 p) {
// CHECK-NEXT:     vec4 r = p;
// CHECK-NEXT:     for (int i = 0, j = 4; i < j; ++i, j--) {
// CHECK-NEXT:         r += float(i);
// CHECK-NEXT:     }
// CHECK-NEXT:     for (;;) {
// CHECK-NEXT:         if (r.x > 1.0) {
// CHECK-NEXT:             break;
// CHECK-NEXT:         }
// CHECK-NEXT:         r.x++;
// CHECK-NEXT:         continue;
// CHECK-NEXT:     }
// CHECK-NEXT:     while (r.y < 1.0) {
// CHECK-NEXT:         r.y += 0.25;
// CHECK-NEXT:     }
// CHECK-NEXT:     do {
// CHECK-NEXT:         r.z -= 1.0;
// CHECK-NEXT:     } while (r.z > 0.0);
// CHECK-NEXT:     if (r.x > 0.0) {
// CHECK-NEXT:         r.x = 1.0;
// CHECK-NEXT:     } else if (r.x < 0.0) {
// CHECK-NEXT:         r.x = 2.0;
// CHECK-NEXT:         r.y = 3.0;
// CHECK-NEXT:     } else {
// CHECK-NEXT:         return r;
// CHECK-NEXT:     }
// CHECK-NEXT:     switch (globals.n) {
// CHECK-NEXT:     case 0:
// CHECK-NEXT:     case 1:
// CHECK-NEXT:         r.x += 1.0;
// CHECK-NEXT:         break;
// CHECK-NEXT:     case 2:
// CHECK-NEXT:         {
// CHECK-NEXT:             float x = 2.0;
// CHECK-NEXT:             r.y += x;
// CHECK-NEXT:         }
// CHECK-NEXT:     default:
// CHECK-NEXT:         r.z += 1.0;
// CHECK-NEXT:         break;
// CHECK-NEXT:     case -1:
// CHECK-NEXT:         break;
// CHECK-NEXT:     }
// CHECK-NEXT:     {
// CHECK-NEXT:     }
// CHECK-NEXT:     return r;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     gl_Position = shader_main(in_POSITION0);
// CHECK-NEXT: }
