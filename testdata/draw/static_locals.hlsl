// A static variable gets its value when control first reaches its declaration, as in dxc (glslang's issue 1432, by an author of
// DXC: `static const float v = val;` keeps the value of the first call).
// RUN: %draw compare %s -T vs_6_0 --target=glsl450,glsl330,essl300,vulkan
// RUN: %draw compare %s -T vs_6_0 --target=glsl130,essl310
float size, scale;
static float g = 9;
static int calls;

float once() { ++calls; return 2; }
float of_global() { static float n = g; return n; }
float of_parameter(float x) { static float n = x; n += 1; return n; }
float of_array(float x) { static const float a[2] = {x, x * 2}; return a[0] + a[1]; }
struct S { float3 a; int b; float2x2 m; };
S of_struct(float x) { static S s = {x, x, x, 3, x, 1, 2, x}; s.b += 1; return s; }
float4x4 of_matrix(float4 p) { static const float4x4 m = float4x4(p, p * 2, p * 3, p * 4); return m; }
float never(float x) { static float n = once() * x; return n; }
float of_call(float x) { static float n = once() + x; return n; }
float of_uniform(float x) { static const float w = 1.0 / (size + 2); static float v = scale * w; v += x; return v * w; }
float in_loop(int count) {
  float sum = 0;
  for (int i = 1; i < 4; ++i) {
    static int n = i + count;
    sum += n;
  }
  return sum;
}
float in_switch(int k) {
  float r = 0;
  for (int i = 0; i < 3; ++i) {
    switch (k) {
      case 0: { static float n = i + k; r += n; break; }
      default: r += 1; break;
    }
  }
  return r;
}
struct Counter {
  float step;
  float next() { static float n = step; n += step; return n; }
};

float4 main(float4 p : POSITION, int k : K, out float4 more : MORE, out float4 other : OTHER) : SV_Position {
  g = p.w;
  static const float w = 1.0 / (p.w + 3);
  float4 r = of_global();
  g = 4;
  r.y += of_global() + of_parameter(p.x) + of_parameter(p.y);
  r.z += of_array(p.x) + of_array(p.z);
  r.w += of_struct(p.x).b + of_struct(p.y).b + of_struct(p.z).m[1][1];
  more = mul(of_matrix(p), p) + mul(of_matrix(p.wzyx), p);
  if (p.x > 1e6) more.x += never(p.x);
  more.y += of_call(p.x) + of_call(p.y) + calls;
  other = float4(of_uniform(p.x), of_uniform(p.y), in_loop(k), in_switch(k & 1)) * w;
  Counter c = {p.x};
  other.x += c.next() + c.next();
  return r;
}
