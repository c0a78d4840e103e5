// Outputs of a pixel that some paths write, and parts of them. Oracles: fxc X4000, "use of potentially uninitialized variable", X3578 and
// X3507, "Not all control paths return a value". An out parameter of the entry function is an output, X3578: only in other functions does
// one that nothing writes make fxc refuse the shader, X3508.
// RUN: %clipc -T ps_5_0 -E paths -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=PATHS
// RUN: %clipc -T ps_5_0 -E paths -Wno-output-not-always-written -fsyntax-only %s 2>&1 | count 0
// RUN: %clipc -T ps_5_0 -E result -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=RESULT
// RUN: %clipc -T ps_5_0 -E parts -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=PARTS
// RUN: %clipc -T ps_5_0 -E parameters -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=PARAMETERS
// RUN: %clipc -T ps_5_0 -E every -fsyntax-only %s 2>&1 | count 0
// RUN: %clipc -T vs_5_0 -E vertex -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=VERTEX
struct Out {
  float4 color : SV_Target0;
  float depth : SV_Depth;
};
// PATHS: [[#@LINE-2]]:17: warning: the output `depth` is not written on every path; where it is not, its value is undefined [-Woutput-not-always-written]
Out paths(float2 t : T) {
  Out o;
  o.color = 1;
  if (t.x > 0) o.depth = 0.5;
  return o;
}
// RESULT: [[#@LINE+1]]:31: warning: the output `SV_Target` is not written on every path; where it is not, its value is undefined
float4 result(float2 t : T) : SV_Target {
  float4 r;
  if (t.x > 0) r = 1;
  return r;
}
// PARTS: warning: the output `color` is not written completely; the next stage reads what is undefined [-Woutput-not-written]
Out parts(float2 t : T) {
  Out o;
  o.color.xyz = 1;
  o.depth = 0;
  return o;
}
// PARAMETERS: [[#@LINE+2]]:36: warning: the output `color` is not written completely; the next stage reads what is undefined [-Woutput-not-written]
// PARAMETERS: [[#@LINE+1]]:65: warning: the output `depth` is never written; the next stage reads what is undefined [-Woutput-not-written]
void parameters(out float4 color : SV_Target, out float depth : SV_Depth) { color.xy = 1; }
Out every(float2 t : T) {
  Out o;
  if (t.x > 0) {
    o.color = 1;
    o.depth = 0;
  } else {
    o.depth = 1;
    o.color = 0;
  }
  return o;
}
struct Vertex {
  float4 position : SV_Position;
  float4 color : COLOR;
};
// VERTEX: [[#@LINE-2]]:18: warning: the output `color` is not written on every path
Vertex vertex(float4 p : POSITION) {
  Vertex v;
  v.position = p;
  if (p.x > 0) v.color = p;
  return v;
}
