// An index that is a comma expression is one argument of the function that reads the row or the buffer.
// RUN: %clipc -T vs_5_1 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_1 --target=vulkan --validate %s -o %t.vert
// RUN: %draw compare %s -T vs_5_1 --target=glsl450,vulkan
struct Frame { float4 color; float4 plane; };
ConstantBuffer<Frame> frames[2];
int1x2 rows[2];
Buffer<float4> list;
float4 main(float4 p : POSITION) : SV_Position {
  int i = 0;
  uint j = 1;
  // CHECK: rows((i++, 1))
  p += rows[i++, 1][0].x;
  // CHECK: rows(int((j--, 0u)))
  p += rows[j--, 0u][0].x;
  // CHECK: frames_value((i++, 0))
  Frame frame = frames[i++, 0];
  // CHECK: texelFetch(list, (i++, 3))
  p += list[i++, 3];
  return p + frame.plane + i + j;
}
