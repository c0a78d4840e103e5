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

// CHECK: struct Light
// CHECK-NEXT:   field position : float4
// CHECK-NEXT: struct Box
// CHECK-NEXT:   field value : float
// CHECK-NEXT:   prototype other : Box
// CHECK-NEXT: variable count : int static const = 4
// CHECK-NEXT: function twice : T template
// CHECK-NEXT:   template parameter T : typename
// CHECK-NEXT:   parameter x : T
// CHECK-NEXT:   block
// CHECK-NEXT:     return (x + x)
// CHECK-NEXT: function casts : void
// CHECK-NEXT:   parameter a : float
// CHECK-NEXT:   parameter b : float
// CHECK-NEXT:   block
// CHECK-NEXT:     expression (x = ((float3x3)m))
// CHECK-NEXT:     expression (x = ((Light)0))
// CHECK-NEXT:     expression (x = ((Light[2])0))
// CHECK-NEXT:     expression (x = ((float4)a))
// CHECK-NEXT:     expression (x = ((uint)a))
// CHECK-NEXT:     expression (x = ((vector<float, 3>)a))
// CHECK-NEXT:     expression (x = ((Light)0))
// CHECK-NEXT:     expression (x = ((<unnamed>)0))
// CHECK-NEXT:     expression (x = (a - b))
// CHECK-NEXT:     expression (x = a(b))
// CHECK-NEXT:     expression (x = ((Unknown)b))
// CHECK-NEXT:     expression (x = ((Unknown)b))
// CHECK-NEXT:     expression (x = (Unknown - b))
// CHECK-NEXT:     expression (x = ((-((float)a)) * ((int)b.x)))
// CHECK-NEXT:     expression (x = ((float[2])a))
// CHECK-NEXT:     expression (x = (count + 1))
// CHECK-NEXT: function constructors : void
// CHECK-NEXT:   block
// CHECK-NEXT:     expression (x = float4(1, 2, 3, 4))
// CHECK-NEXT:     expression (x = vector<float, 3>(1, 2, 3))
// CHECK-NEXT:     expression (x = matrix<float, 2, 2>(1, 2, 3, 4))
// CHECK-NEXT:     expression (x = Light(a))
// CHECK-NEXT:     expression (x = uint(a))
// CHECK-NEXT: function angles : void
// CHECK-NEXT:   parameter a : int
// CHECK-NEXT:   parameter b : int
// CHECK-NEXT:   parameter c : int
// CHECK-NEXT:   block
// CHECK-NEXT:     expression (x = (a < b))
// CHECK-NEXT:     expression (x = ((a < b) > c))
// CHECK-NEXT:     expression (x = ((count < b) && (a > c)))
// CHECK-NEXT:     expression (x = twice<float>(a))
// CHECK-NEXT:     expression (x = twice<float3>(a))
// CHECK-NEXT:     expression (x = buffer.Load<float4>(0))
// CHECK-NEXT:     expression (x = buffer.Load<float[2]>(0))
// CHECK-NEXT:     expression (x = later<float4, 3>(a))
// CHECK-NEXT:     expression (x = (a.value < b))
// CHECK-NEXT:     for
// CHECK-NEXT:       init
// CHECK-NEXT:         variable i : int = 0
// CHECK-NEXT:       while (i < count)
// CHECK-NEXT:       step (i++)
// CHECK-NEXT:       block
// CHECK-NEXT: function shadows : void
// CHECK-NEXT:   block
// CHECK-NEXT:     variable light : Light
// CHECK-NEXT:     variable Light : Light
// CHECK-NEXT:     expression (Light.position = 0)
// CHECK-NEXT:     expression (x = (Light - 1))
// CHECK-NEXT:     expression (x = (Light < 1))
// CHECK-NEXT:     variable other : Light
// CHECK-NEXT: function words : void
// CHECK-NEXT:   block
// CHECK-NEXT:     variable sample : float = 1
// CHECK-NEXT:     variable point : float = 2
// CHECK-NEXT:     variable line : float = 3
// CHECK-NEXT:     variable triangle : float = 4
// CHECK-NEXT:     variable linear : float = 5
// CHECK-NEXT:     variable precise : float = 6
// CHECK-NEXT:     variable texture : float = 7
// CHECK-NEXT:     variable matrix : float = 8
// CHECK-NEXT:     variable vector : float = 9
// CHECK-NEXT:     variable string : float = 10
// CHECK-NEXT:     variable buffer : float = 11
// CHECK-NEXT:     variable sampler : float = 12
// CHECK-NEXT:     variable technique : float = 13
// CHECK-NEXT:     variable pass : float = 14
// CHECK-NEXT:     variable compile : float = 15
// CHECK-NEXT:     variable register : float = 16
// CHECK-NEXT:     variable packoffset : float = 17
// CHECK-NEXT:     variable shared : float = 18
// CHECK-NEXT:     variable center : float = 19
// CHECK-NEXT:     expression (sample = ((((point * line) + linear) - precise) + 1))
// CHECK-NEXT:     expression (texture[0] = (matrix < vector))
// CHECK-NEXT:     expression (technique = pass(compile))
// CHECK-NEXT:     variable exact : float precise = sample
// CHECK-NEXT:     expression (linear = precise)
// CHECK-NEXT:     variable int1 : int = 1
// CHECK-NEXT:     expression (int1 = (int1 + 1))
// CHECK-NEXT: variable interpolated : float4 linear centroid
