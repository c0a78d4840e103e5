// Clip distances and inputs that a target does not have.
// RUN: not %clipc -T vs_5_0 --target=glsl120 --lower=clip-distance %s -o %t 2>&1 | FileCheck %s --check-prefix=GL120
// RUN: not %clipc -T vs_6_8 --target=essl320 -DPARAMETERS %s -o %t 2>&1 | FileCheck %s --check-prefix=ES320
// RUN: not %clipc -T vs_6_1 --target=glsl150 -DVIEW %s -o %t 2>&1 | FileCheck %s --check-prefix=GL150
// RUN: not %clipc -T vs_6_0 --target=essl320 -DWIDE %s -o %t 2>&1 | FileCheck %s --check-prefix=WIDE
// AUTOUPDATE
#if defined(PARAMETERS)
// ES320: fail_clip_outputs.hlsl:[[#@LINE+3]]:46: error: `SV_StartVertexLocation` is a parameter of the draw call; target `essl320` does not pass it to the shader [target-draw-parameter]
// ES320-NEXT:    [[#@LINE+2]] | float4 main(float4 p : POSITION, int first : SV_StartVertexLocation) : SV_Position { return p + first; }
// ES320-NEXT:       |                                              ^~~~~~~~~~~~~~~~~~~~~~
float4 main(float4 p : POSITION, int first : SV_StartVertexLocation) : SV_Position { return p + first; }
#elif defined(VIEW)
// GL150: fail_clip_outputs.hlsl:[[#@LINE+3]]:46: error: the shader reads `SV_ViewID`; target `glsl150` has no such input [target-view-id]
// GL150-NEXT:    [[#@LINE+2]] | float4 main(float4 p : POSITION, uint view : SV_ViewID) : SV_Position { return p + view; }
// GL150-NEXT:       |                                              ^~~~~~~~~
float4 main(float4 p : POSITION, uint view : SV_ViewID) : SV_Position { return p + view; }
#elif defined(WIDE)
// WIDE: fail_clip_outputs.hlsl:[[#@LINE+3]]:9: error: the shader computes with 64-bit integers; target `essl320` has no such type [target-int64]
// WIDE-NEXT:    [[#@LINE+2]] | int64_t wide;
// WIDE-NEXT:       |         ^~~~
int64_t wide;
float4 main(float4 p : POSITION) : SV_Position { return p + (float)wide; }
#else
float4 plane;
// GL120: fail_clip_outputs.hlsl:[[#@LINE+3]]:13: error: the shader writes clip distances; target `glsl120` has no `gl_ClipDistance`; `[clipplanes]` does not need it under `--lower=discard` [target-clip-distance]
// GL120-NEXT:    [[#@LINE+2]] | [clipplanes(plane)]
// GL120-NEXT:       |             ^~~~~
[clipplanes(plane)]
float4 main(float4 p : POSITION) : SV_Position { return p; }
#endif
