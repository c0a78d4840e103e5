// Values of the other pixels of a quad, drawn. Oracle: the evaluator, which runs the four pixels in step.
// RUN: %draw compare %s -T ps_6_0 --target vulkan
struct Colors {
  float4 a : SV_Target0;
  float4 b : SV_Target1;
};
Colors main(float4 p : P, float4 q : Q) {
  Colors result;
  result.a = QuadReadAcrossX(p) + QuadReadAcrossY(q);
  result.b = QuadReadAcrossDiagonal(p * q) + QuadReadLaneAt(p, 1);
  return result;
}
