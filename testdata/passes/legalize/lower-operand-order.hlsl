// An operand that a later one changes is read into a variable before it; other operands stay.
// RUN: %clipc -T vs_5_0 --verify --dump-after=lower-operand-order --stop-after=lower-operand-order %s | FileCheck %s
// RUN: %draw compare %s -T vs_5_0
// AUTOUPDATE
static int n = 1;
int f(int k) {
  n += k;
  return k;
}
float4 main(float4 p : POSITION, int i : I) : SV_Position {
  int first = n + f(2);
  int second = f(2) + n;
  int third = i > 0 ? i : i++;
  do third += i * (i += 2); while (i + i++ < 9);
  return p + first + second + third + i;
}

// CHECK: program vs_5_0 form inlined
// CHECK-NEXT: input float4 in_POSITION0 : POSITION0 location 0
// CHECK-NEXT: input int in_I0 : I0 location 1
// CHECK-NEXT: output float4 vs_SV_POSITION0 : SV_Position0 builtin position
// CHECK-NEXT: static int n = 1
// CHECK-NEXT: entry void main() {
// CHECK-NEXT: }
// CHECK-NEXT: int f(int k) {
// CHECK-NEXT:   n += k
// CHECK-NEXT:   return k
// CHECK-NEXT: }
// CHECK-NEXT: main void main.1() {
// CHECK-NEXT:   int i = in_I0
// CHECK-NEXT:   int old_n = n
// CHECK-NEXT:   int first = old_n + f(2)
// CHECK-NEXT:   int second = f(2) + n
// CHECK-NEXT:   bool temporary = i > 0
// CHECK-NEXT:   int temporary.1 = i
// CHECK-NEXT:   int temporary.2 = i++
// CHECK-NEXT:   int third = temporary ? temporary.1 : temporary.2
// CHECK-NEXT:   int old_i
// CHECK-NEXT:   do {
// CHECK-NEXT:     int old_i.1 = i
// CHECK-NEXT:     third += old_i.1 * (i += 2)
// CHECK-NEXT:   } while (((old_i = i) + (i++)) < 9)
// CHECK-NEXT:   vs_SV_POSITION0 = (((in_POSITION0 + splat<float4>(convert<float>(first))) + splat<float4>(convert<float>(second))) + splat<float4>(convert<float>(third))) + splat<float4>(convert<float>(i))
// CHECK-NEXT: }
