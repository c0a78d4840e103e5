// Function templates: the more special one of two ([temp.func.order] of C++), a specialisation of one of them, deduction through instances of structs and objects, recursion that a specialisation ends, and a declaration before the definition.
// RUN: %clipc %s -T vs_6_0 -o - | FileCheck %s
// RUN: %draw compare %s -T vs_6_0 --target=glsl450
template<typename T> float Size(T a) { return 1; }
template<typename T> float Size(vector<T, 2> a) { return 3; }
template<> float Size<int>(int a) { return 4; }
template<typename T> struct Pair { T a, b; };
template<typename T, int N> struct Row { T of[N]; };
template<typename T> T Total(Pair<T> pair) { return pair.a + pair.b; }
template<typename T, int N> T Last(Row<T, N> row) { return row.of[N - 1]; }
template<typename T> T Read(StructuredBuffer<T> buffer, uint i) { return buffer[i]; }
template<typename T> T Texel(Texture2D<T> texture) { return texture.Load(0); }
template<int N> int Factorial() { return N * Factorial<N - 1>(); }
template<> int Factorial<0>() { return 1; }
template<int N> int Later();
int Before() { return Later<5>(); }
template<int N> int Later() { return N; }
StructuredBuffer<float4> buffer;
Texture2D<float2> image;
float4 main(float4 p : P, int i : I, uint u : U) : SV_Position {
  // CHECK-DAG: return 3.0;
  // CHECK-DAG: return 4.0;
  float4 sum = float4(Size(p.xy), Size(i), Size(p.xyz), Size(u));
  Pair<float> pair = {p.x, p.y};
  Row<float2, 3> row = {p.xy, p.zw, p.yz};
  // CHECK-DAG: pair.a + pair.b
  // CHECK-DAG: row.of[3 - 1]
  sum += Total(pair) + Last(row).xyxy + Read(buffer, u) + Texel(image).xyxy;
  // CHECK-DAG: return 3 * 
  // CHECK-DAG: return 5;
  return sum + Factorial<3>() + Later<5>() + Before();
}
