// RUN: not %clipc -T vs_5_0 -E main %s 2>&1 | FileCheck %s
// CHECK: [[#@LINE+1]]:8: error: struct `Open` is declared but not defined [incomplete-type, X3000]
struct Open;
// CHECK: [[#@LINE+1]]:8: error: type `Loop` contains itself [type-contains-itself, X3000]
struct Loop { Loop inner; };
typedef float Row[4];
float size;
int count() { return 3; }
template<typename T> struct Box { T x; };
float4 main(float4 position : POSITION) : SV_Position {
  Open a;
  Loop b;
  // CHECK: [[#@LINE+1]]:11: error: the array has -1 elements; the size must be from 1 to 1048576 [bad-array-size, X3058]
  float c[-1];
  // CHECK: [[#@LINE+1]]:11: error: `size` is not a constant integer; it must be known at compile time [not-constant-integer, X3058]
  float d[size];
  // CHECK: [[#@LINE+1]]:9: error: array dimensions must be given; only the first one may follow from an initialiser [array-without-size, X3072]
  float e[];
  // CHECK: [[#@LINE+1]]:17: error: size 5 of `vector`; a vector has 1 to 4 components, a matrix 1 to 4 rows and columns [bad-vector-size, X3052]
  vector<float, 5> f;
  // CHECK: [[#@LINE+1]]:10: error: `float2` is the component type of a `vector`; it must be a scalar type [component-not-scalar, X3122]
  vector<float2, 2> g;
  // CHECK: [[#@LINE+1]]:3: error: too many template arguments for `matrix`; it takes at most 3 [too-many-type-arguments, X3000]
  matrix<float, 1, 2, 3> h;
  // CHECK: [[#@LINE+1]]:8: error: `i` of type `void`; `void` has no values [void-value, X3038]
  void i;
  // CHECK: [[#@LINE+1]]:9: error: the type has more than 1048576 components [type-too-large, X3059]
  float j[1024][1024][2];
  // CHECK: [[#@LINE+1]]:9: error: structs and arrays are nested more than 64 levels deep [type-too-deep]
  float k[1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1];
  // CHECK: [[#@LINE+1]]:3: error: `Box` is used without its template arguments [missing-type-argument, X3000]
  Box l;
  // CHECK: [[#@LINE+1]]:12: error: `SamplerState` has no size [size-unknown, X3000]
  uint n = sizeof(SamplerState);
  // CHECK: [[#@LINE+1]]:3: error: `uint16_t3`, a type of 16 bits in memory (`min16uint3` may have more), is not supported [unsupported]
  uint16_t3 three = 0;
  return position;
}
