// A precise value is followed through calls, `out` arguments and the variables between; code that no precise value needs
// stays as it is.
// RUN: %clipc -T vs_5_0 --dump-after=spread-precise %s --verify | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=glsl450 --validate %s -o - | FileCheck %s --check-prefix=GLSL
float4x4 world, projection;
bool is_flat;

// A variable that is returned becomes the precise one.
// CHECK-LABEL: float4 World(
// CHECK-NEXT: precise float4 q =
// CHECK-NEXT: q += Twice(
// CHECK-NEXT: return q
// CHECK-LABEL: void Split({{.*}}, out precise float4 a.1, out float4 b.1)
// CHECK-LABEL: float4 Project(
// CHECK-NEXT: if (is_flat)
// CHECK-NEXT: precise float4 [[flat:.*]] =
// CHECK-NEXT: return [[flat]]
// CHECK-NEXT: }
// CHECK-NEXT: precise float4 [[other:.*]] =
// CHECK-NEXT: return [[other]]
// CHECK-LABEL: float4 Other(
// CHECK-NEXT: return (
// CHECK-LABEL: float4 Twice(
// CHECK-NEXT: precise float4
// CHECK-LABEL: main void
float4 Twice(float4 p) { return p * 2 + p; }

float4 World(float4 p) {
  float4 q = mul(p, world);
  q += Twice(p);
  return q;
}

float4 Project(float4 p) {
  if (is_flat) return p * 3 + 1;
  return mul(p, projection);
}

// GLSL: void Split(vec4 p, precise out vec4 a, out vec4 b)
void Split(float4 p, out float4 a, out float4 b) {
  a = p * 4 + 1;
  b = p * 5 + 1;
}

float4 Other(float4 p) { return p * 6 + 1; }

struct Result {
  precise float4 position : SV_Position;
  float4 color : COLOR;
};

Result main(float4 p : POSITION) {
  Result result;
  float4 a, b;
  Split(World(p), a, b);
  result.position = Project(a);
  result.color = Other(b);
  return result;
}
