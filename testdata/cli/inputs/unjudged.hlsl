// GLSL that glslang 12 does not know.
#ifndef N
#define N 0
#endif
float depth(float x : X) : SV_DepthLessEqual { return x * 0.5 + N; }
float4 index(uint i : SV_SampleIndex) : SV_Target { return i; }
float4 coverage(uint c : SV_Coverage) : SV_Target { return c; }
float4 place(float4 p : P) : SV_Target { return EvaluateAttributeAtSample(p, 1); }
