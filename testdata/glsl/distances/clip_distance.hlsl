// One redeclaration with the size that is written, in the form of the target. glslang 12 knows no clip distances in OpenGL ES.
// RUN: %clipc -T vs_5_0 --target=glsl130 --validate %s -o - | FileCheck %s --check-prefix=GL130
// RUN: %clipc -T vs_5_0 --target=glsl450 --validate %s -o - | FileCheck %s --check-prefix=GL450
// RUN: %clipc -T vs_5_0 --target=glsl450 --separable --validate %s -o - | FileCheck %s --check-prefix=SEPARABLE
// RUN: %clipc -T vs_5_0 --target=vulkan --validate %s -o - | FileCheck %s --check-prefix=VULKAN
// RUN: %clipc -T vs_5_0 --target=essl300 %s -o - | FileCheck %s --check-prefix=ES
// AUTOUPDATE
float4 water, portal;
[clipplanes(water, portal)]
float4 main(float4 p : POSITION) : SV_Position { return p; }

// GL130: #version 130
// GL130-EMPTY:
// GL130-NEXT: // $Globals, b0
// GL130-NEXT: uniform vec4 water;
// GL130-NEXT: uniform vec4 portal;
// GL130-EMPTY:
// GL130-NEXT: in vec4 in_POSITION0;  // p : POSITION0
// GL130-EMPTY:
// GL130-NEXT: // clip distances written: 0x3
// GL130-NEXT: out float gl_ClipDistance[2];
// GL130-EMPTY:
// GL130-NEXT: void main() {
// GL130-NEXT:     gl_Position = in_POSITION0;
// GL130-NEXT:     gl_ClipDistance[0] = dot(in_POSITION0, water);
// GL130-NEXT:     gl_ClipDistance[1] = dot(in_POSITION0, portal);
// GL130-NEXT: }

// GL450: #version 450
// GL450-EMPTY:
// GL450-NEXT: layout(std140, binding = 0) uniform Globals {  // b0
// GL450-NEXT:     vec4 water;
// GL450-NEXT:     vec4 portal;
// GL450-NEXT: } globals;
// GL450-EMPTY:
// GL450-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// GL450-EMPTY:
// GL450-NEXT: // clip distances written: 0x3
// GL450-NEXT: out float gl_ClipDistance[2];
// GL450-EMPTY:
// GL450-NEXT: void main() {
// GL450-NEXT:     gl_Position = in_POSITION0;
// GL450-NEXT:     gl_ClipDistance[0] = dot(in_POSITION0, globals.water);
// GL450-NEXT:     gl_ClipDistance[1] = dot(in_POSITION0, globals.portal);
// GL450-NEXT: }

// SEPARABLE: #version 450
// SEPARABLE-EMPTY:
// SEPARABLE-NEXT: layout(std140, binding = 0) uniform Globals {  // b0
// SEPARABLE-NEXT:     vec4 water;
// SEPARABLE-NEXT:     vec4 portal;
// SEPARABLE-NEXT: } globals;
// SEPARABLE-EMPTY:
// SEPARABLE-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// SEPARABLE-EMPTY:
// SEPARABLE-NEXT: // clip distances written: 0x3
// SEPARABLE-NEXT: out gl_PerVertex {
// SEPARABLE-NEXT:     vec4 gl_Position;
// SEPARABLE-NEXT:     float gl_PointSize;
// SEPARABLE-NEXT:     float gl_ClipDistance[2];
// SEPARABLE-NEXT: };
// SEPARABLE-EMPTY:
// SEPARABLE-NEXT: void main() {
// SEPARABLE-NEXT:     gl_Position = in_POSITION0;
// SEPARABLE-NEXT:     gl_ClipDistance[0] = dot(in_POSITION0, globals.water);
// SEPARABLE-NEXT:     gl_ClipDistance[1] = dot(in_POSITION0, globals.portal);
// SEPARABLE-NEXT: }

// VULKAN: #version 460
// VULKAN-EMPTY:
// VULKAN-NEXT: layout(std140, set = 0, binding = 0) uniform Globals {  // b0
// VULKAN-NEXT:     vec4 water;
// VULKAN-NEXT:     vec4 portal;
// VULKAN-NEXT: } globals;
// VULKAN-EMPTY:
// VULKAN-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// VULKAN-EMPTY:
// VULKAN-NEXT: // clip distances written: 0x3
// VULKAN-NEXT: out gl_PerVertex {
// VULKAN-NEXT:     vec4 gl_Position;
// VULKAN-NEXT:     float gl_PointSize;
// VULKAN-NEXT:     float gl_ClipDistance[2];
// VULKAN-NEXT: };
// VULKAN-EMPTY:
// VULKAN-NEXT: void main() {
// VULKAN-NEXT:     gl_Position = in_POSITION0;
// VULKAN-NEXT:     gl_ClipDistance[0] = dot(in_POSITION0, globals.water);
// VULKAN-NEXT:     gl_ClipDistance[1] = dot(in_POSITION0, globals.portal);
// VULKAN-NEXT: }

// ES: #version 300 es
// ES-NEXT: #extension GL_EXT_clip_cull_distance : require
// ES-EMPTY:
// ES-NEXT: layout(std140) uniform Globals {  // b0
// ES-NEXT:     vec4 water;
// ES-NEXT:     vec4 portal;
// ES-NEXT: } globals;
// ES-EMPTY:
// ES-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// ES-EMPTY:
// ES-NEXT: // clip distances written: 0x3
// ES-NEXT: out highp float gl_ClipDistance[2];
// ES-EMPTY:
// ES-NEXT: void main() {
// ES-NEXT:     gl_Position = in_POSITION0;
// ES-NEXT:     gl_ClipDistance[0] = dot(in_POSITION0, globals.water);
// ES-NEXT:     gl_ClipDistance[1] = dot(in_POSITION0, globals.portal);
// ES-NEXT: }
