// The types in all their spellings.
// RUN: %clipc -T vs_5_0 -E main --dump=ir %s | FileCheck %s
typedef float4 vec4;
typedef float Pair[2];
typedef Pair Pairs[3];
static const int kSize = 2 + 1;
unsigned int get() { return 1u; }
float4 main(float4 position : POSITION) : SV_Position {
  // CHECK: float3 a = splat<float3>(0.0)
  vector<float, 3> a = (vector<float, 3>)0;
  // CHECK: float4 b
  vector b = position;
  // CHECK: float3x2 c
  matrix<float, 3, 2> c = 0;
  // CHECK: float4x4 d
  matrix d = 1;
  // CHECK: uint2 e
  dword2 e = 0;
  // CHECK: min16float3 f
  min16float3 f = 1;
  // CHECK: half4x3 g
  half4x3 g = 1;
  // CHECK: float1 h
  float1 h = 1;
  // CHECK: float1x1 i
  float1x1 i = 1;
  // CHECK: double j
  double j = 1.5L;
  // CHECK: float k[3][2]
  Pairs k = {1, 2, 3, 4, 5, 6};
  // CHECK: int l[3][4]
  int l[kSize][4] = (int[3][4])0;
  // CHECK: float4 m[2][3][2]
  vec4 m[2][3][2];
  // CHECK: uint n = get()
  unsigned int n = get();
  // CHECK: uint o = 24u
  uint o = sizeof(float3x2);
  // CHECK: bool3 p
  vector<bool, kSize> p = false;
  return position + b + h + i + k[2][1] + l[0][0] + n + o;
}
