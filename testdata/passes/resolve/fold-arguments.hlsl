// A technique's argument is the constant that the entry reads, and the branch that it does not choose is removed.
// RUN: rm -rf %t && mkdir %t && %clipc --effect %s --verify --validate -o %t
// RUN: cat %t/T.P.vert | FileCheck %s
// CHECK-NOT: Fog
// CHECK: gl_Position = in_POSITION0;
float4 Fog(float4 p) { return p * p.w; }
float4 VS(float4 p : POSITION, uniform bool fog) : POSITION {
  if (fog) p = Fog(p);
  return p;
}
technique T {
  pass P {
    VertexShader = compile vs_3_0 VS(false);
  }
}
