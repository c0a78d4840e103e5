// RUN: %clipc --dump=ast %s | FileCheck %s
// AUTOUPDATE
// Where only the meaning of a name tells how to read the text.
struct Light { float4 position; };
struct Box { float value; Box other(); };
static const int count = 4;
template<typename T> T twice(T x) { return x + x; }

void casts(float a, float b) {
  x = (float3x3)m;
  x = (Light)0;
  x = (Light[2])0;
  x = (const float4)a;
  x = (unsigned int)a;
  x = (vector<float, 3>)a;
  x = (struct Light)0;
  x = (struct { float y; })0;
  x = (a)-b;
  x = (a)(b);
  x = (Unknown)b;
  x = (Unknown)(b);
  x = (Unknown)-b;
  x = -(float)a * (int)b.x;
  x = (float[2])a;
  x = (count) + 1;
}
void constructors() {
  x = float4(1, 2, 3, 4);
  x = vector<float, 3>(1, 2, 3);
  x = matrix<float, 2, 2>(1, 2, 3, 4);
  x = Light(a);
  x = unsigned(a);
}
void angles(int a, int b, int c) {
  x = a < b;
  x = a < b > (c);
  x = count < b && a > c;
  x = twice<float>(a);
  x = twice < float3 > (a);
  x = buffer.Load<float4>(0);
  x = buffer.Load<float[2]>(0);
  x = later<float4, 3>(a);
  x = a.value < b;
  for (int i = 0; i < count; i++) { }
}
void shadows() {
  Light light;
  Light Light;
  Light.position = 0;
  x = (Light)-1;
  x = Light < 1;
  Light other;
}
// Words that are keywords only where a keyword fits.
void words() {
  float sample = 1, point = 2, line = 3, triangle = 4, linear = 5, precise = 6;
  float texture = 7, matrix = 8, vector = 9, string = 10, buffer = 11, sampler = 12;
  float technique = 13, pass = 14, compile = 15, register = 16, packoffset = 17, shared = 18, center = 19;
  sample = point * line + linear - (precise)+1;
  texture[0] = matrix < vector;
  technique = pass(compile);
  precise float exact = sample;
  linear = precise;
  int int1 = 1;
  int1 = int1 + 1;
}
linear centroid float4 interpolated;
