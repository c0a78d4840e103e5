// glslang wants an extension for what GLSL 1.20 has in vertex shaders anyway.
// RUN: %clipc -T vs_3_0 --target=glsl120 --validate %s -o - | FileCheck %s
// CHECK: #extension GL_ARB_shader_texture_lod : enable
// CHECK: texture2DLod(t, in_POSITION0.xy, in_POSITION0.w) + textureCubeLod(c, in_POSITION0.xyz, in_POSITION0.w)
sampler2D t;
samplerCUBE c;
float4 main(float4 p : POSITION) : POSITION { return p + tex2Dlod(t, p) + texCUBElod(c, p); }
