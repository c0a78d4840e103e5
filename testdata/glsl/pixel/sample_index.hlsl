// texture.sample[number][position] is Load(position, number) of a multisampled texture; a field of that name is a field. Oracle:
// Microsoft's page "sample.Operator[][]", and fxc's listing of such a shader in ANGLE.
// RUN: %clipc -T ps_5_0 %s -o - | FileCheck %s
// RUN: %clipc -T ps_6_0 %s -o - | FileCheck %s
Texture2DMS<float4> colors;
Texture2DMSArray<float4> layers;
struct Field { float4 sample[2]; };
Field field;
uint number;

float4 main(float4 place : SV_Position) : SV_Target {
  // CHECK: texelFetch(colors, {{.*}}gl_FragCoord.xy{{.*}}, int(globals.number))
  float4 sum = colors.sample[number][uint2(place.xy)];
  // CHECK: texelFetch(layers, ivec3(1, 2, 3), 1)
  sum += layers.sample[1][int3(1, 2, 3)];
  // CHECK: globals.field.sample_[1].x
  return sum + field.sample[1][0];
}
