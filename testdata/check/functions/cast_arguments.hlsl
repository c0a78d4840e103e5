// A cast of a variable is taken for an inout or out parameter, and its components are written back one after another: fxc compiles the
// materials of an engine that passes its vertex so.
// RUN: %clipc -T vs_5_0 %s --validate -o - | FileCheck %s
struct A { float4 p; float2 t; };
struct B { float4 p : POSITION; float t : T; float3 d : D; };
void change(inout A v) { v.p *= 2; v.t = v.t.yx; }
void write(out A v) { v.p = 1; v.t = 2; }
void scale(inout float2 v) { v *= 3; }
void count(inout int n) { n += 2; }
float4 main(B v) : SV_Position {
  change((A)v);
  // CHECK: v.p = temporary.p;
  // CHECK-NEXT: v.t = temporary.t.x;
  // CHECK-NEXT: v.d.x = temporary.t.y;
  B w = v;
  write((A)w);
  // CHECK: w.d.x = temporary_2.t.y;
  scale((float2)v.d);
  // CHECK: scale(temporary_3);
  // CHECK-NEXT: v.d.xy = temporary_3;
  float f = v.t * 7.5;
  count((int)f);
  // CHECK: count(temporary_4);
  // CHECK-NEXT: f = float(temporary_4);
  int i = 0;
  B several[2] = { v, w };
  change((A)several[i++]);
  // CHECK: int temporary_5 = i++;
  // CHECK: several[temporary_5].d.x = temporary_6.t.y;
  return v.p + w.p + f + float4(v.d, w.t) + i + several[0].p + float4(several[0].t, several[0].d);
}
