// What a target lacks is an error that names it, each at its place; nothing is left out silently.
// RUN: not %clipc -T vs_5_1 --target=glsl120 %s -o %t 2>&1 | FileCheck %s --check-prefix=GL120
// RUN: not %clipc -T vs_5_1 --target=essl300 %s -o %t 2>&1 | FileCheck %s --check-prefix=ES300
// RUN: not %clipc -T vs_5_1 --target=glsl330 %s -o %t 2>&1 | FileCheck %s --check-prefix=GL330
// AUTOUPDATE
// ES300: fail_features.hlsl:[[#@LINE+4]]:19: error: `line_map` is a one-dimensional texture; target `essl300` has none [target-texture1-d]
// ES300-NEXT:    [[#@LINE+3]] | Texture1D<float4> line_map;
// ES300-NEXT:       |                   ^~~~~~~~
// ES300-NEXT: clipc: note: target `glsl120` can
Texture1D<float4> line_map;
Texture2D<float4> map;
// GL120: fail_features.hlsl:[[#@LINE+4]]:17: error: `integers` holds integers; textures of target `glsl120` cannot [target-integer-texture]
// GL120-NEXT:    [[#@LINE+3]] | Texture2D<int4> integers;
// GL120-NEXT:       |                 ^~~~~~~~
// GL120-NEXT: clipc: note: target `glsl130` can
Texture2D<int4> integers;
// GL120-NEXT: fail_features.hlsl:[[#@LINE+4]]:16: error: `layers` is an array texture; target `glsl120` has none [target-texture-array]
// GL120-NEXT:    [[#@LINE+3]] | Texture2DArray layers;
// GL120-NEXT:       |                ^~~~~~
// GL120-NEXT: clipc: note: target `glsl130` can
Texture2DArray layers;
// GL120-NEXT: fail_features.hlsl:[[#@LINE+8]]:21: error: `samples` is a multisampled texture; target `glsl120` has none [target-multisample]
// GL120-NEXT:    [[#@LINE+7]] | Texture2DMS<float4> samples;
// GL120-NEXT:       |                     ^~~~~~~
// GL120-NEXT: clipc: note: target `glsl150` can
// ES300-NEXT: fail_features.hlsl:[[#@LINE+4]]:21: error: `samples` is a multisampled texture; target `essl300` has none [target-multisample]
// ES300-NEXT:    [[#@LINE+3]] | Texture2DMS<float4> samples;
// ES300-NEXT:       |                     ^~~~~~~
// ES300-NEXT: clipc: note: target `essl310` can
Texture2DMS<float4> samples;
// GL120-NEXT: fail_features.hlsl:[[#@LINE+8]]:18: error: `cubes` is an array of cube maps; target `glsl120` has none [target-cube-array]
// GL120-NEXT:    [[#@LINE+7]] | TextureCubeArray cubes;
// GL120-NEXT:       |                  ^~~~~
// GL120-NEXT: clipc: note: target `glsl130` can
// ES300-NEXT: fail_features.hlsl:[[#@LINE+4]]:18: error: `cubes` is an array of cube maps; target `essl300` has none [target-cube-array]
// ES300-NEXT:    [[#@LINE+3]] | TextureCubeArray cubes;
// ES300-NEXT:       |                  ^~~~~
// ES300-NEXT: clipc: note: target `essl310` can
TextureCubeArray cubes;
// GL120-NEXT: fail_features.hlsl:[[#@LINE+8]]:16: error: `typed` is a typed buffer; target `glsl120` has none [target-texture-buffer]
// GL120-NEXT:    [[#@LINE+7]] | Buffer<float4> typed;
// GL120-NEXT:       |                ^~~~~
// GL120-NEXT: clipc: note: target `glsl140` can
// ES300-NEXT: fail_features.hlsl:[[#@LINE+4]]:16: error: `typed` is a typed buffer; target `essl300` has none [target-texture-buffer]
// ES300-NEXT:    [[#@LINE+3]] | Buffer<float4> typed;
// ES300-NEXT:       |                ^~~~~
// ES300-NEXT: clipc: note: target `essl310` can
Buffer<float4> typed;
// GL120-NEXT: fail_features.hlsl:[[#@LINE+12]]:26: error: `structured` is a buffer of any layout; target `glsl120` has no storage buffers [target-storage-buffer]
// GL120-NEXT:    [[#@LINE+11]] | StructuredBuffer<float4> structured;
// GL120-NEXT:       |                          ^~~~~~~~~~
// GL120-NEXT: clipc: note: target `glsl430` can
// ES300-NEXT: fail_features.hlsl:[[#@LINE+8]]:26: error: `structured` is a buffer of any layout; target `essl300` has no storage buffers [target-storage-buffer]
// ES300-NEXT:    [[#@LINE+7]] | StructuredBuffer<float4> structured;
// ES300-NEXT:       |                          ^~~~~~~~~~
// ES300-NEXT: clipc: note: target `essl310` can
// GL330: fail_features.hlsl:[[#@LINE+4]]:26: error: `structured` is a buffer of any layout; target `glsl330` has no storage buffers [target-storage-buffer]
// GL330-NEXT:    [[#@LINE+3]] | StructuredBuffer<float4> structured;
// GL330-NEXT:       |                          ^~~~~~~~~~
// GL330-NEXT: clipc: note: target `glsl430` can
StructuredBuffer<float4> structured;
SamplerState linear_clamp;
SamplerComparisonState compare;
Texture2D maps[2][2];
SamplerState samplers[2];
uint mask;
// GL120-NEXT: fail_features.hlsl:[[#@LINE+8]]:8: error: the shader computes in `double`; target `glsl120` has no such type [target-double]
// GL120-NEXT:    [[#@LINE+7]] | double wide;
// GL120-NEXT:       |        ^~~~
// GL120-NEXT: clipc: note: target `glsl150` can
// ES300-NEXT: fail_features.hlsl:[[#@LINE+4]]:8: error: the shader computes in `double`; target `essl300` has no such type [target-double]
// ES300-NEXT:    [[#@LINE+3]] | double wide;
// ES300-NEXT:       |        ^~~~
// ES300-NEXT: clipc: note: target `glsl150` can
double wide;
int choose;

struct Result {
  float4 position : SV_Position;
// GL120-NEXT: fail_features.hlsl:[[#@LINE+12]]:16: error: the shader writes `SV_RenderTargetArrayIndex`; vertex and domain shaders of target `glsl120` cannot [target-layer]
// GL120-NEXT:    [[#@LINE+11]] |   uint layer : SV_RenderTargetArrayIndex;
// GL120-NEXT:       |                ^~~~~~~~~~~~~~~~~~~~~~~~~
// GL120-NEXT: clipc: note: target `glsl410` can
// ES300-NEXT: fail_features.hlsl:[[#@LINE+8]]:16: error: the shader writes `SV_RenderTargetArrayIndex`; vertex and domain shaders of target `essl300` cannot [target-layer]
// ES300-NEXT:    [[#@LINE+7]] |   uint layer : SV_RenderTargetArrayIndex;
// ES300-NEXT:       |                ^~~~~~~~~~~~~~~~~~~~~~~~~
// ES300-NEXT: clipc: note: target `glsl410` can
// GL330-NEXT: fail_features.hlsl:[[#@LINE+4]]:16: error: the shader writes `SV_RenderTargetArrayIndex`; vertex and domain shaders of target `glsl330` cannot [target-layer]
// GL330-NEXT:    [[#@LINE+3]] |   uint layer : SV_RenderTargetArrayIndex;
// GL330-NEXT:       |                ^~~~~~~~~~~~~~~~~~~~~~~~~
// GL330-NEXT: clipc: note: target `glsl410` can
  uint layer : SV_RenderTargetArrayIndex;
// GL120-NEXT: fail_features.hlsl:[[#@LINE+4]]:16: error: `NUMBER0` is an integer output; outputs of target `glsl120` are floats [target-integer-varying]
// GL120-NEXT:    [[#@LINE+3]] |   int number : NUMBER;
// GL120-NEXT:       |                ^~~~~~
// GL120-NEXT: clipc: note: target `glsl130` can
  int number : NUMBER;
// GL120-NEXT: fail_features.hlsl:[[#@LINE+12]]:26: error: `WIDE0` is a `double`; inputs and outputs of target `glsl120` cannot be [target-double-varying]
// GL120-NEXT:   [[#@LINE+11]] |   double precise_value : WIDE;
// GL120-NEXT:       |                          ^~~~
// GL120-NEXT: clipc: note: target `glsl410` can
// ES300-NEXT: fail_features.hlsl:[[#@LINE+8]]:26: error: `WIDE0` is a `double`; inputs and outputs of target `essl300` cannot be [target-double-varying]
// ES300-NEXT:   [[#@LINE+7]] |   double precise_value : WIDE;
// ES300-NEXT:       |                          ^~~~
// ES300-NEXT: clipc: note: target `glsl410` can
// GL330-NEXT: fail_features.hlsl:[[#@LINE+4]]:26: error: `WIDE0` is a `double`; inputs and outputs of target `glsl330` cannot be [target-double-varying]
// GL330-NEXT:   [[#@LINE+3]] |   double precise_value : WIDE;
// GL330-NEXT:       |                          ^~~~
// GL330-NEXT: clipc: note: target `glsl410` can
  double precise_value : WIDE;
// GL120-NEXT: fail_features.hlsl:[[#@LINE+8]]:27: error: `A0` is interpolated without perspective; target `glsl120` cannot do that [target-no-perspective]
// GL120-NEXT:   [[#@LINE+7]] |   noperspective float a : A;
// GL120-NEXT:       |                           ^
// GL120-NEXT: clipc: note: target `glsl130` can
// ES300-NEXT: fail_features.hlsl:[[#@LINE+4]]:27: error: `A0` is interpolated without perspective; target `essl300` cannot do that [target-no-perspective]
// ES300-NEXT:   [[#@LINE+3]] |   noperspective float a : A;
// ES300-NEXT:       |                           ^
// ES300-NEXT: clipc: note: target `glsl130` can
  noperspective float a : A;
// GL120-NEXT: fail_features.hlsl:[[#@LINE+4]]:29: error: `B0` is not interpolated; outputs of target `glsl120` always are [target-flat]
// GL120-NEXT:   [[#@LINE+3]] |   nointerpolation float b : B;
// GL120-NEXT:       |                             ^
// GL120-NEXT: clipc: note: target `glsl130` can
  nointerpolation float b : B;
// GL120-NEXT: fail_features.hlsl:[[#@LINE+8]]:20: error: `C0` is interpolated per sample; target `glsl120` cannot do that [target-per-sample]
// GL120-NEXT:   [[#@LINE+7]] |   sample float c : C;
// GL120-NEXT:       |                    ^
// GL120-NEXT: clipc: note: target `glsl400` can
// GL330-NEXT: fail_features.hlsl:[[#@LINE+4]]:20: error: `C0` is interpolated per sample; target `glsl330` cannot do that [target-per-sample]
// GL330-NEXT:   [[#@LINE+3]] |   sample float c : C;
// GL330-NEXT:       |                    ^
// GL330-NEXT: clipc: note: target `glsl400` can
  sample float c : C;
// GL120-NEXT: fail_features.hlsl:[[#@LINE+8]]:16: error: the shader writes cull distances; target `glsl120` has no `gl_CullDistance` [target-cull-distance]
// GL120-NEXT:   [[#@LINE+7]] |   float cull : SV_CullDistance;
// GL120-NEXT:       |                ^~~~~~~~~~~~~~~
// GL120-NEXT: clipc: note: target `glsl450` can
// GL330-NEXT: fail_features.hlsl:[[#@LINE+4]]:16: error: the shader writes cull distances; target `glsl330` has no `gl_CullDistance` [target-cull-distance]
// GL330-NEXT:   [[#@LINE+3]] |   float cull : SV_CullDistance;
// GL330-NEXT:       |                ^~~~~~~~~~~~~~~
// GL330-NEXT: clipc: note: target `glsl450` can
  float cull : SV_CullDistance;
};

// GL120-NEXT: fail_features.hlsl:[[#@LINE+4]]:48: error: the shader reads `SV_VertexID`; target `glsl120` has no such input [target-vertex-id]
// GL120-NEXT:   [[#@LINE+3]] | Result main(float4 p : POSITION, uint vertex : SV_VertexID) {
// GL120-NEXT:       |                                                ^~~~~~~~~~~
// GL120-NEXT: clipc: note: target `glsl130` can
Result main(float4 p : POSITION, uint vertex : SV_VertexID) {
  Result r = (Result)0;
// GL120-NEXT: fail_features.hlsl:[[#@LINE+3]]:20: warning: target `glsl120` has no `uint`; `int` replaces it, and values from 2147483648 on are negative [-Wtarget-uint-as-int]
// GL120-NEXT:   [[#@LINE+2]] |   r.position = p + vertex;
// GL120-NEXT:       |                    ^~~~~~
  r.position = p + vertex;
// GL120-NEXT: fail_features.hlsl:[[#@LINE+8]]:62: error: a texture is read by `Gather`; target `glsl120` has no function for that [target-gather]
// GL120-NEXT:   [[#@LINE+7]] |   r.position += line_map.SampleLevel(linear_clamp, p.x, 0) + map.Gather(linear_clamp, p.xy);
// GL120-NEXT:       |                                                              ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
// GL120-NEXT: clipc: note: target `glsl130` can
// ES300-NEXT: fail_features.hlsl:[[#@LINE+4]]:62: error: a texture is read by `Gather`; target `essl300` has no function for that [target-gather]
// ES300-NEXT:   [[#@LINE+3]] |   r.position += line_map.SampleLevel(linear_clamp, p.x, 0) + map.Gather(linear_clamp, p.xy);
// ES300-NEXT:       |                                                              ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
// ES300-NEXT: clipc: note: target `essl310` can
  r.position += line_map.SampleLevel(linear_clamp, p.x, 0) + map.Gather(linear_clamp, p.xy);
// GL120-NEXT: fail_features.hlsl:[[#@LINE+8]]:17: error: a texture is read by `SampleGrad`; target `glsl120` has no function for that [target-sample-gradient]
// GL120-NEXT:   [[#@LINE+7]] |   r.position += map.SampleGrad(linear_clamp, p.xy, p.zw, p.xy) + map.SampleCmpLevelZero(compare, p.xy, p.z).x;
// GL120-NEXT:       |                 ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
// GL120-NEXT: clipc: note: target `glsl130` can
// GL120-NEXT: fail_features.hlsl:[[#@LINE+4]]:66: error: a texture is compared by this method; target `glsl120` has no function for that [target-sample-compare]
// GL120-NEXT:   [[#@LINE+3]] |   r.position += map.SampleGrad(linear_clamp, p.xy, p.zw, p.xy) + map.SampleCmpLevelZero(compare, p.xy, p.z).x;
// GL120-NEXT:       |                                                                  ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
// GL120-NEXT: clipc: note: target `glsl130` can
  r.position += map.SampleGrad(linear_clamp, p.xy, p.zw, p.xy) + map.SampleCmpLevelZero(compare, p.xy, p.z).x;
// GL120-NEXT: fail_features.hlsl:[[#@LINE+4]]:17: error: a texel is read by `Load` or `[]`; target `glsl120` can only sample [target-texture-load]
// GL120-NEXT:   [[#@LINE+3]] |   r.position += integers.Load(int3(1, 2, 0)) + layers.SampleLevel(linear_clamp, p.xyz, 0);
// GL120-NEXT:       |                 ^~~~~~~~~~~~~~~~~~~~~~~~~~~~
// GL120-NEXT: clipc: note: target `glsl130` can
  r.position += integers.Load(int3(1, 2, 0)) + layers.SampleLevel(linear_clamp, p.xyz, 0);
// GL120-NEXT: fail_features.hlsl:[[#@LINE+4]]:17: error: a texel is read by `Load` or `[]`; target `glsl120` can only sample [target-texture-load]
// GL120-NEXT:   [[#@LINE+3]] |   r.position += samples.Load(int2(1, 2), 3) + cubes.SampleLevel(linear_clamp, p, 0);
// GL120-NEXT:       |                 ^~~~~~~~~~~~~~~~~~~~~~~~~~~
// GL120-NEXT: clipc: note: target `glsl130` can
  r.position += samples.Load(int2(1, 2), 3) + cubes.SampleLevel(linear_clamp, p, 0);
  r.position += typed[vertex] + structured[vertex];
// GL120-NEXT: fail_features.hlsl:[[#@LINE+27]]:40: error: the sampler `samplers` is an element of an array, and its index is not constant; target `glsl120` combines each texture with one named sampler [target-sampler-array]
// GL120-NEXT:   [[#@LINE+26]] |   r.position += maps[1][0].SampleLevel(samplers[vertex], p.xy, 0);
// GL120-NEXT:       |                                        ^~~~~~~~~~~~~~~~
// GL120-NEXT: fail_features.hlsl:[[#@LINE+24]]:40: error: the index of `samplers` is not constant; target `glsl120` accepts only constant indices of arrays of buffers, textures and samplers [target-buffer-index-not-constant]
// GL120-NEXT:   [[#@LINE+23]] |   r.position += maps[1][0].SampleLevel(samplers[vertex], p.xy, 0);
// GL120-NEXT:       |                                        ^~~~~~~~~~~~~~~~
// GL120-NEXT: fail_features.hlsl:[[#@LINE+21]]:49: warning: the index of `samplers` may differ between the vertices of a draw call, where the result is undefined; `NonUniformResourceIndex` says that this is meant [-Wobject-index-varies]
// GL120-NEXT:   [[#@LINE+20]] |   r.position += maps[1][0].SampleLevel(samplers[vertex], p.xy, 0);
// GL120-NEXT:       |                                                 ^~~~~~
// ES300-NEXT: fail_features.hlsl:[[#@LINE+18]]:40: error: the sampler `samplers` is an element of an array, and its index is not constant; target `essl300` combines each texture with one named sampler [target-sampler-array]
// ES300-NEXT:   [[#@LINE+17]] |   r.position += maps[1][0].SampleLevel(samplers[vertex], p.xy, 0);
// ES300-NEXT:       |                                        ^~~~~~~~~~~~~~~~
// ES300-NEXT: fail_features.hlsl:[[#@LINE+15]]:40: error: the index of `samplers` is not constant; target `essl300` accepts only constant indices of arrays of buffers, textures and samplers [target-buffer-index-not-constant]
// ES300-NEXT:   [[#@LINE+14]] |   r.position += maps[1][0].SampleLevel(samplers[vertex], p.xy, 0);
// ES300-NEXT:       |                                        ^~~~~~~~~~~~~~~~
// ES300-NEXT: fail_features.hlsl:[[#@LINE+12]]:49: warning: the index of `samplers` may differ between the vertices of a draw call, where the result is undefined; `NonUniformResourceIndex` says that this is meant [-Wobject-index-varies]
// ES300-NEXT:   [[#@LINE+11]] |   r.position += maps[1][0].SampleLevel(samplers[vertex], p.xy, 0);
// ES300-NEXT:       |                                                 ^~~~~~
// GL330-NEXT: fail_features.hlsl:[[#@LINE+9]]:40: error: the sampler `samplers` is an element of an array, and its index is not constant; target `glsl330` combines each texture with one named sampler [target-sampler-array]
// GL330-NEXT:   [[#@LINE+8]] |   r.position += maps[1][0].SampleLevel(samplers[vertex], p.xy, 0);
// GL330-NEXT:       |                                        ^~~~~~~~~~~~~~~~
// GL330-NEXT: fail_features.hlsl:[[#@LINE+6]]:40: error: the index of `samplers` is not constant; target `glsl330` accepts only constant indices of arrays of buffers, textures and samplers [target-buffer-index-not-constant]
// GL330-NEXT:   [[#@LINE+5]] |   r.position += maps[1][0].SampleLevel(samplers[vertex], p.xy, 0);
// GL330-NEXT:       |                                        ^~~~~~~~~~~~~~~~
// GL330-NEXT: fail_features.hlsl:[[#@LINE+3]]:49: warning: the index of `samplers` may differ between the vertices of a draw call, where the result is undefined; `NonUniformResourceIndex` says that this is meant [-Wobject-index-varies]
// GL330-NEXT:   [[#@LINE+2]] |   r.position += maps[1][0].SampleLevel(samplers[vertex], p.xy, 0);
// GL330-NEXT:       |                                                 ^~~~~~
  r.position += maps[1][0].SampleLevel(samplers[vertex], p.xy, 0);
  float2 size;
  float levels;
// GL120-NEXT: fail_features.hlsl:[[#@LINE+16]]:3: error: the shader queries the size of a texture; target `glsl120` cannot answer that [target-texture-query]
// GL120-NEXT:   [[#@LINE+15]] |   map.GetDimensions(0, size.x, size.y, levels);
// GL120-NEXT:       |   ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
// GL120-NEXT: clipc: note: target `glsl130` can
// GL120-NEXT: fail_features.hlsl:[[#@LINE+12]]:3: error: the shader queries the number of levels of a texture; target `glsl120` cannot answer that [target-texture-query]
// GL120-NEXT:   [[#@LINE+11]] |   map.GetDimensions(0, size.x, size.y, levels);
// GL120-NEXT:       |   ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
// GL120-NEXT: clipc: note: target `glsl430` can
// ES300-NEXT: fail_features.hlsl:[[#@LINE+8]]:3: error: the shader queries the number of levels of a texture; target `essl300` cannot answer that [target-texture-query]
// ES300-NEXT:   [[#@LINE+7]] |   map.GetDimensions(0, size.x, size.y, levels);
// ES300-NEXT:       |   ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
// ES300-NEXT: clipc: note: target `glsl430` can
// GL330-NEXT: fail_features.hlsl:[[#@LINE+4]]:3: error: the shader queries the number of levels of a texture; target `glsl330` cannot answer that [target-texture-query]
// GL330-NEXT:   [[#@LINE+3]] |   map.GetDimensions(0, size.x, size.y, levels);
// GL330-NEXT:       |   ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
// GL330-NEXT: clipc: note: target `glsl430` can
  map.GetDimensions(0, size.x, size.y, levels);
  r.position.xy += size * levels;
// GL120-NEXT: fail_features.hlsl:[[#@LINE+10]]:19: error: `&` works on bits; target `glsl120` has no such operator [target-bit-operator]
// GL120-NEXT:   [[#@LINE+9]] |   r.position.x += (mask & 3) + asfloat(mask) + (float)wide + min(mask, 4000000000u);
// GL120-NEXT:       |                   ^~~~~~~~~~
// GL120-NEXT: fail_features.hlsl:[[#@LINE+7]]:32: error: `asfloat` reads the bits of a number; target `glsl120` has no function for that [target-bit-cast]
// GL120-NEXT:   [[#@LINE+6]] |   r.position.x += (mask & 3) + asfloat(mask) + (float)wide + min(mask, 4000000000u);
// GL120-NEXT:       |                                ^~~~~~~~~~~~~
// GL120-NEXT: clipc: note: target `glsl150` can
// GL120-NEXT: fail_features.hlsl:[[#@LINE+3]]:72: error: `4000000000` does not fit an `int`; target `glsl120` has no `uint` [target-uint-too-large]
// GL120-NEXT:   [[#@LINE+2]] |   r.position.x += (mask & 3) + asfloat(mask) + (float)wide + min(mask, 4000000000u);
// GL120-NEXT:       |                                                                        ^~~~~~~~~~~
  r.position.x += (mask & 3) + asfloat(mask) + (float)wide + min(mask, 4000000000u);
// GL120-NEXT: fail_features.hlsl:[[#@LINE+9]]:3: error: target `glsl120` has no `switch` [target-switch]
// GL120-NEXT:   [[#@LINE+8]] |   switch (choose) {
// GL120-NEXT:       |   ^~~~~~~~~~~~~~~~~
// GL120-NEXT:   [[#@LINE+7]] |     case 1: r.position.y = 2; break;
// GL120-NEXT:       |     ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
// GL120-NEXT:   [[#@LINE+6]] |     default: break;
// GL120-NEXT:       |     ~~~~~~~~~~~~~~~
// GL120-NEXT:   [[#@LINE+5]] |   }
// GL120-NEXT:       |   ~
  switch (choose) {
    case 1: r.position.y = 2; break;
    default: break;
  }
  return r;
}
