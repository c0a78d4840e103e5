// Arguments: defaults, `out` of another type through a temporary, matrix components.
// RUN: %clipc -T vs_5_0 -E main --dump=ir %s | FileCheck %s
float defaults(float x, float y = 2, float3 z = float3(1, 2, 3));
float defaults(float x, float y, float3 z) { return x + y + z.x; }
void out_float(out float x) { x = 1; }
float inout_int(inout int x) { x += 1; return x; }
void out_two(out float2 x) { x = 1; }
float4 main(float4 position : POSITION) : SV_Position {
  // CHECK: float a = defaults(1.0, 2.0, float3(1.0, 2.0, 3.0)) + defaults(1.0, 3.0, float3(1.0, 2.0, 3.0))
  float a = defaults(1) + defaults(1, 3);
  int i;
  // CHECK: out_float(temporary)
  // CHECK-NEXT: i = convert<int>(temporary)
  out_float(i);
  // CHECK: int temporary.1 = convert<int>(a)
  // CHECK-NEXT: float temporary.2 = inout_int(temporary.1)
  // CHECK-NEXT: a = convert<float>(temporary.1)
  // CHECK-NEXT: float b = temporary.2
  float b = inout_int(a);
  float4x4 m = 0;
  // CHECK: out_float(m[1u][2u])
  out_float(m._m12);
  // CHECK: out_two(m[0u].yx)
  out_two(m._12_11);
  // CHECK: out_two(temporary.3)
  // CHECK: m[0u][0u] = {{temporary.[0-9]+}}.x
  // CHECK: m[1u][1u] = {{temporary.[0-9]+}}.y
  out_two(m._m00_m11);
  // CHECK: out_float(position.z)
  out_float(position.z);
  return position * a * b + m[0] + i;
}
