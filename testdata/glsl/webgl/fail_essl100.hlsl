// What GLSL ES 1.00 cannot say is an error at its place, which names the target.
// RUN: not %clipc -T vs_5_0 --target=essl100 --lower=none %s -o %t 2>&1 | FileCheck %s
// RUN: not %clipc -T vs_5_0 --target=webgl1 %s -DPLANES -o %t 2>&1 | FileCheck %s --check-prefix=PLANES
// AUTOUPDATE
#ifdef PLANES
float4 plane;
// PLANES: fail_essl100.hlsl:[[#@LINE+4]]:13: error: the shader writes clip distances; target `webgl1` has no `gl_ClipDistance`; `[clipplanes]` does not need it under `--lower=discard` [target-clip-distance]
// PLANES-NEXT:    [[#@LINE+3]] | [clipplanes(plane)] float4 main(float4 p : POSITION) : SV_Position { return p; }
// PLANES-NEXT:       |             ^~~~~
// PLANES-NEXT: clipc: note: target `webgl2` can
[clipplanes(plane)] float4 main(float4 p : POSITION) : SV_Position { return p; }
#else
// CHECK: fail_essl100.hlsl:[[#@LINE+4]]:19: error: `volume` is a three-dimensional texture; target `essl100` has none [target-texture3-d]
// CHECK-NEXT:    [[#@LINE+3]] | Texture3D<float4> volume;
// CHECK-NEXT:       |                   ^~~~~~
// CHECK-NEXT: clipc: note: target `essl300` can
Texture3D<float4> volume;
Texture2D<float4> map;
SamplerState s;
int count;
float4 many[300];

struct Output {
  float4 position : SV_Position;
// CHECK-NEXT: fail_essl100.hlsl:[[#@LINE+4]]:24: error: `TEXCOORD0` is interpolated at the centroid; target `essl100` cannot do that [target-centroid]
// CHECK-NEXT:    [[#@LINE+3]] |   centroid float2 uv : TEXCOORD;
// CHECK-NEXT:       |                        ^~~~~~~~
// CHECK-NEXT: clipc: note: target `essl300` can
  centroid float2 uv : TEXCOORD;
};
// CHECK-NEXT: fail_essl100.hlsl:[[#@LINE+3]]:19: error: `values` has 300 elements; target `essl100` has no arrays of values but structs of at most 256 fields [target-long-array]
// CHECK-NEXT:    [[#@LINE+2]] | float4 Sum(float4 values[300]) { return values[0]; }
// CHECK-NEXT:       |                   ^~~~~~
float4 Sum(float4 values[300]) { return values[0]; }

// CHECK-NEXT: fail_essl100.hlsl:[[#@LINE+4]]:50: error: the shader reads `SV_InstanceID`; target `essl100` has no such input; an attribute of the instance can have the number [target-instance-id]
// CHECK-NEXT:    [[#@LINE+3]] | Output main(float4 p : POSITION, uint instance : SV_InstanceID) {
// CHECK-NEXT:       |                                                  ^~~~~~~~~~~~~
// CHECK-NEXT: clipc: note: target `essl300` can
Output main(float4 p : POSITION, uint instance : SV_InstanceID) {
  Output o;
// CHECK-NEXT: fail_essl100.hlsl:[[#@LINE+4]]:47: error: a texture is read at an offset; target `essl100` has no function for that [target-sample-offset]
// CHECK-NEXT:    [[#@LINE+3]] |   o.uv = volume.SampleLevel(s, p.xyz, 0).xy + map.SampleLevel(s, p.xy, 0, int2(1, 1)).xy;
// CHECK-NEXT:       |                                               ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
// CHECK-NEXT: clipc: note: target `essl300` can
  o.uv = volume.SampleLevel(s, p.xyz, 0).xy + map.SampleLevel(s, p.xy, 0, int2(1, 1)).xy;
// CHECK-NEXT: fail_essl100.hlsl:[[#@LINE+3]]:20: warning: target `essl100` has no `uint`; `int` replaces it, and values from 2147483648 on are negative [-Wtarget-uint-as-int]
// CHECK-NEXT:    [[#@LINE+2]] |   o.position = p + instance + Sum(many);
// CHECK-NEXT:       |                    ^~~~~~~~
  o.position = p + instance + Sum(many);
// CHECK-NEXT: fail_essl100.hlsl:[[#@LINE+3]]:3: error: this loop does not end at a constant, and its iterations are not known; target `essl100` has only loops like `for (int i = 0; i < 8; ++i)`, from constant to constant (GLSL ES 1.00, appendix A), and those that can be unrolled [target-loop]
// CHECK-NEXT:    [[#@LINE+2]] |   for (int i = 0; i < (count > 3 ? 7 : 4); i++) o.position.x += i;
// CHECK-NEXT:       |   ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
  for (int i = 0; i < (count > 3 ? 7 : 4); i++) o.position.x += i;
// CHECK-NEXT: fail_essl100.hlsl:[[#@LINE+3]]:3: error: this loop does not begin at a constant, and its iterations are not known; target `essl100` has only loops like `for (int i = 0; i < 8; ++i)`, from constant to constant (GLSL ES 1.00, appendix A), and those that can be unrolled [target-loop]
// CHECK-NEXT:    [[#@LINE+2]] |   for (int j = count > 3 ? 7 : 4; j < 8; j++) o.position.x += j;
// CHECK-NEXT:       |   ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
  for (int j = count > 3 ? 7 : 4; j < 8; j++) o.position.x += j;
// CHECK-NEXT: fail_essl100.hlsl:[[#@LINE+3]]:3: error: this loop does not step by a constant, and its iterations are not known; target `essl100` has only loops like `for (int i = 0; i < 8; ++i)`, from constant to constant (GLSL ES 1.00, appendix A), and those that can be unrolled [target-loop]
// CHECK-NEXT:    [[#@LINE+2]] |   for (int k = 1; k < 8; k += count) o.position.x += k;
// CHECK-NEXT:       |   ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
  for (int k = 1; k < 8; k += count) o.position.x += k;
// CHECK-NEXT: fail_essl100.hlsl:[[#@LINE+3]]:3: error: this loop changes its index, and its iterations are not known; target `essl100` has only loops like `for (int i = 0; i < 8; ++i)`, from constant to constant (GLSL ES 1.00, appendix A), and those that can be unrolled [target-loop]
// CHECK-NEXT:    [[#@LINE+2]] |   for (int l = 0; l < 8; l++) if (count > l) o.position.x += ++l;
// CHECK-NEXT:       |   ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
  for (int l = 0; l < 8; l++) if (count > l) o.position.x += ++l;
  int m = count;
// CHECK-NEXT: fail_essl100.hlsl:[[#@LINE+3]]:3: error: this loop does not begin with a value of its index, and its iterations are not known; target `essl100` has only loops like `for (int i = 0; i < 8; ++i)`, from constant to constant (GLSL ES 1.00, appendix A), and those that can be unrolled [target-loop]
// CHECK-NEXT:    [[#@LINE+2]] |   for (;;) if (o.position.x++ > m) break;
// CHECK-NEXT:       |   ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
  for (;;) if (o.position.x++ > m) break;
// CHECK-NEXT: fail_essl100.hlsl:[[#@LINE+3]]:3: error: this loop is a `while`, and its iterations are not known; target `essl100` has only loops like `for (int i = 0; i < 8; ++i)`, from constant to constant (GLSL ES 1.00, appendix A), and those that can be unrolled [target-loop]
// CHECK-NEXT:    [[#@LINE+2]] |   while (o.position.x < m) o.position.x = m;
// CHECK-NEXT:       |   ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
  while (o.position.x < m) o.position.x = m;
// CHECK-NEXT: fail_essl100.hlsl:[[#@LINE+5]]:3: error: this loop is a `do`, and its iterations are not known; target `essl100` has only loops like `for (int i = 0; i < 8; ++i)`, from constant to constant (GLSL ES 1.00, appendix A), and those that can be unrolled [target-loop]
// CHECK-NEXT:    [[#@LINE+4]] |   do o.position.x = m;
// CHECK-NEXT:       |   ^~~~~~~~~~~~~~~~~~~~
// CHECK-NEXT:    [[#@LINE+3]] |   while (o.position.x < m);
// CHECK-NEXT:       |   ~~~~~~~~~~~~~~~~~~~~~~~~~
  do o.position.x = m;
  while (o.position.x < m);
  return o;
}
#endif
