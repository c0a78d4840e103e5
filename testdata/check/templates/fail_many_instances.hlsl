// One message says that templates have too many instances, of functions and of structs; none is about the instances that are missing.
// RUN: not %clipc -T vs_6_6 -DENDLESS %s -o - 2>&1 | FileCheck %s --implicit-check-not=error
// RUN: not %clipc -T vs_6_6 %s -o - 2>&1 | FileCheck %s --implicit-check-not=error
// CHECK: error: templates have more than 4096 instances [too-many-instances]
template<int N> float shifted(float x) { return x + N; }
template<int N> struct Pair { float first, second; };
template<int N> float endless(float x) { return endless<N + 1>(x); }

#define ONE(n) sum += shifted<n>(p.x);
#define D1(n) ONE(n) ONE((n) + 1)
#define D2(n) D1(n) D1((n) + 2)
#define D3(n) D2(n) D2((n) + 4)
#define D4(n) D3(n) D3((n) + 8)
#define D5(n) D4(n) D4((n) + 16)
#define D6(n) D5(n) D5((n) + 32)
#define D7(n) D6(n) D6((n) + 64)
#define D8(n) D7(n) D7((n) + 128)
#define D9(n) D8(n) D8((n) + 256)
#define D10(n) D9(n) D9((n) + 512)
#define D11(n) D10(n) D10((n) + 1024)

float4 main(float4 p : POSITION) : SV_Position {
  float sum = 0;
#ifdef ENDLESS
  sum = endless<0>(p.x);
#else
  D11(0) D11(2048) D1(4096) D1(4096)
  Pair<1> one, other;
  one.first = other.second = sum;
  sum = one.first;
#endif
  return p * sum;
}
