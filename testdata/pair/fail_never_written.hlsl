// An output that is declared and never written matches no input that is read: Direct3D's linker would accept the signatures, and the
// pixel shader would read what is undefined (fxc X3578). One that the pixel shader does not read is only warned of.
// RUN: not %clipc -T vs_6_0 %s --pixel-shader=%s --pixel-entry=reads -o - 2>&1 | FileCheck %s --check-prefix=READ
// RUN: %clipc -T vs_6_0 %s --pixel-shader=%s --pixel-entry=ignores -o - 2>&1 | FileCheck %s --check-prefix=IGNORED
// RUN: %clipc -T vs_6_0 %s --pixel-shader=%s --pixel-entry=reads --zero-unwritten -o - 2>&1 | FileCheck %s --check-prefix=ZERO
struct Vertex {
  float4 position : SV_Position;
  // READ: [[#@LINE+2]]:18: warning: the output `v.color` is never written; the next stage reads what is undefined [-Woutput-not-written]
  // IGNORED: [[#@LINE+1]]:18: warning: the output `v.color` is never written
  float4 color : COLOR0;
  float2 uv : TEXCOORD0;
};
void main(float4 position : POSITION, out Vertex v) {
  v.position = position;
  v.uv = position.xy;
}
// READ: error: the vertex shader writes nothing that matches the pixel shader's input `COLOR0`; with `--zero-unwritten` it is 0
float4 reads(Vertex v) : SV_Target { return v.color + v.uv.xyxy; }
// IGNORED-NOT: out vec4
// IGNORED: out vec2 v_uv;
float4 ignores(Vertex v) : SV_Target { return v.uv.xyxy; }
// ZERO: v_color = vec4(0.0);
