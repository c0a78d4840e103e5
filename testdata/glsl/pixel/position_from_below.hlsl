// OpenGL ES counts a pixel's y from the lower edge (OpenGL ES 3.2, 15.1.2), Direct3D from the upper one. The host gives the height.
// RUN: %clipc -T ps_5_0 --target=essl310 --validate --verify --reflect=%t.json %s -o - 2>%t.txt | FileCheck %s
// RUN: FileCheck %s --check-prefix=WARNING < %t.txt
// RUN: FileCheck %s --check-prefix=REFLECTED < %t.json
// RUN: %clipc -T ps_5_0 --target=webgl1 -E corner -w --validate --verify %s -o - | FileCheck %s --check-prefix=OLD
// RUN: %clipc -T ps_5_0 --target=glsl130 -E corner -w --validate --verify %s -o - | FileCheck %s --check-prefix=DESKTOP
// RUN: %clipc -T ps_5_0 --target=essl310 -E parts -w --validate --verify %s -o - | FileCheck %s --check-prefix=PARTS
float4 main(float4 position : SV_Position) : SV_Target { return position; }
// WARNING: [[#@LINE-1]]:31: warning: `SV_Position.y` counts from the upper edge, and target `essl310` from the lower one; the application sets the uniform `framebuffer_height`, which `--reflect` names, to the height in pixels; `--flip-y`, under which the image is upside down, needs none [-Wtarget-origin]
// CHECK: uniform highp float framebuffer_height;  // of the framebuffer, in pixels
// CHECK: SV_Target0 = vec4(gl_FragCoord.x, framebuffer_height - gl_FragCoord.y, gl_FragCoord.z, 1.0 / gl_FragCoord.w);
// REFLECTED: "host": {
// REFLECTED-NEXT: "framebufferHeight": "framebuffer_height"

float4 corner(float2 pixel : VPOS) : SV_Target { return pixel.xyxy; }
// OLD: uniform highp float framebuffer_height;
// OLD: vec2(gl_FragCoord.x, framebuffer_height - gl_FragCoord.y) - 0.5
// DESKTOP: uniform float framebuffer_height;
// DESKTOP: vec2(gl_FragCoord.x, framebuffer_height - gl_FragCoord.y) - 0.5

float4 parts(float4 p : SV_Position) : SV_Target {
  float3 c = p.xyz * p.y + ddy(p.y);
  c.xy += p.yx;
  return float4(c, p.x);
}
// PARTS: uniform highp float framebuffer_height;
// PARTS: vec3(gl_FragCoord.x, framebuffer_height - gl_FragCoord.y, gl_FragCoord.z) * (framebuffer_height - gl_FragCoord.y) + -dFdy(framebuffer_height - gl_FragCoord.y)
// PARTS: vec4(gl_FragCoord.x, framebuffer_height - gl_FragCoord.y, gl_FragCoord.z, 1.0 / gl_FragCoord.w).yx
// PARTS: gl_FragCoord.x
