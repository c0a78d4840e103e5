// A loop of OpenGL ES 2 counts from constant to constant; its index is declared in its head.
// RUN: %clipc -T vs_5_0 --target=essl100 --verify --dump-after=lower-to-es100 --stop-after=lower-to-es100 %s | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=essl100 --validate %s -o %t
// RUN: %draw compare %s -T vs_5_0 --target essl100,glsl450 --lower none --ints 0..5
// AUTOUPDATE
int count;
static const int kLast = 6;
float4 main(float4 p : POSITION) : SV_Position {
  int i;
  for (i = 0; i < 4; ++i) p.x += i;
  for (i = 8; i >= 2 && i > count; i -= 2) {
    if (p.y > 1000) continue;
    p.y += i;
  }
  for (uint j = 1, k = count; j <= kLast - 1; ++j) p.z += j + k++;
  [unroll] for (float f = 0.5; f < 3; f += 0.5) p.w += f;
  return p;
}

// CHECK: program vs_5_0 form inlined
// CHECK-NEXT: globals $Globals : b0, 16 bytes {
// CHECK-NEXT:   int count at 0, 4 bytes
// CHECK-NEXT: }
// CHECK-NEXT: input float4 in_POSITION0 : POSITION0 location 0
// CHECK-NEXT: output float4 vs_SV_POSITION0 : SV_Position0 builtin position
// CHECK-NEXT: const int kLast = 6
// CHECK-NEXT: entry void main() {
// CHECK-NEXT: }
// CHECK-NEXT: main void main.1() {
// CHECK-NEXT:   vs_SV_POSITION0 = in_POSITION0
// CHECK-NEXT:   int i
// CHECK-NEXT:   for (int i.1 = 0; i.1 < 4; i.1++) {
// CHECK-NEXT:     vs_SV_POSITION0.x += convert<float>(i.1)
// CHECK-NEXT:   }
// CHECK-NEXT:   for (int i.2 = 8; i.2 >= 2; i.2 -= 2) {
// CHECK-NEXT:     if (!(i.2 > count)) {
// CHECK-NEXT:       break
// CHECK-NEXT:     }
// CHECK-NEXT:     if (vs_SV_POSITION0.y > 1000.0) {
// CHECK-NEXT:       continue
// CHECK-NEXT:     }
// CHECK-NEXT:     vs_SV_POSITION0.y += convert<float>(i.2)
// CHECK-NEXT:   }
// CHECK-NEXT:   {
// CHECK-NEXT:     uint k = convert<uint>(count)
// CHECK-NEXT:     for (uint j = 1u; j <= convert<uint>(kLast - 1); j++) {
// CHECK-NEXT:       vs_SV_POSITION0.z += convert<float>(j + (k++))
// CHECK-NEXT:     }
// CHECK-NEXT:   }
// CHECK-NEXT:   for (float f = 0.5; f < 3.0; f += 0.5) {
// CHECK-NEXT:     vs_SV_POSITION0.w += f
// CHECK-NEXT:   }
// CHECK-NEXT: }
