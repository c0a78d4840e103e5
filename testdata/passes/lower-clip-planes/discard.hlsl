// The distances reach the fragment shader as interpolated vectors; the discard is an include, or is written into a fragment shader.
// RUN: rm -rf %t && mkdir %t
// RUN: %clipc -T vs_5_0 --lower=discard --validate %s -o %t/water.vert
// RUN: FileCheck %s --check-prefix=VERT --input-file %t/water.vert
// RUN: FileCheck %s --check-prefix=INCLUDE --input-file %t/water.discard.glsl
// RUN: %clipc -T vs_5_0 --lower=discard --validate --fragment=%S/inputs/look.frag %s -o %t/water.vert --table=%t/water.json
// RUN: FileCheck %s --check-prefix=FRAG --input-file %t/water.frag
// RUN: FileCheck %s --check-prefix=TABLE --input-file %t/water.json
// RUN: %clipc -T vs_5_0 -DONE --lower=discard --target=glsl120 %s -o %t/old.vert
// RUN: FileCheck %s --check-prefix=OLD --input-file %t/old.discard.glsl
// RUN: %clipc -T vs_5_0 -DONE --lower=discard --target=essl300 --validate %s -o %t/es.vert
// RUN: FileCheck %s --check-prefix=ES --input-file %t/es.discard.glsl
// RUN: %clipc -T vs_5_0 -DONE --lower=discard --target=essl100 --validate --fragment=%S/inputs/look_es2.frag %s -o %t/es2.vert
// RUN: FileCheck %s --check-prefix=ES2 --input-file %t/es2.frag
// RUN: %validate -S frag %t/es2.frag
float4 water, portals[4];

#ifdef ONE
[clipplanes(water)]
#else
[clipplanes(water, portals[0], portals[1], portals[2], portals[3])]
#endif
float4 main(float4 position : POSITION, out float4 color : COLOR) : SV_Position {
  color = position;
  return position;
}

// VERT-NOT: gl_ClipDistance
// VERT: layout(location = 0) out vec4 vs_COLOR0;
// VERT-NEXT: layout(location = 1) out vec4 vs_SV_CLIPPLANEDISTANCE0;
// VERT-NEXT: layout(location = 2) out float vs_SV_CLIPPLANEDISTANCE1;
// VERT: gl_Position = in_POSITION0;
// VERT-NEXT: vs_SV_CLIPPLANEDISTANCE0 = vec4(dot(in_POSITION0, globals.water), dot(in_POSITION0, globals.portals[0]), dot(in_POSITION0, globals.portals[1]), dot(in_POSITION0, globals.portals[2]));
// VERT-NEXT: vs_SV_CLIPPLANEDISTANCE1 = dot(in_POSITION0, globals.portals[3]);

// INCLUDE: layout(location = 1) in vec4 vs_SV_CLIPPLANEDISTANCE0;
// INCLUDE-NEXT: layout(location = 2) in float vs_SV_CLIPPLANEDISTANCE1;
// INCLUDE-EMPTY:
// INCLUDE-NEXT: void clip_planes() {
// INCLUDE-NEXT:     if (any(isnan(vs_SV_CLIPPLANEDISTANCE0)) || any(lessThan(vs_SV_CLIPPLANEDISTANCE0, vec4(0.0))) || isnan(vs_SV_CLIPPLANEDISTANCE1) || vs_SV_CLIPPLANEDISTANCE1 < 0.0) discard;
// INCLUDE-NEXT: }

// FRAG: #version 450
// FRAG-NEXT: #extension GL_ARB_shading_language_packing : enable
// FRAG-EMPTY:
// FRAG-NEXT: layout(location = 1) in vec4 vs_SV_CLIPPLANEDISTANCE0;
// FRAG: void clip_planes_() {
// FRAG: // void main() { in a comment }
// FRAG: void main()
// FRAG-NEXT: {
// FRAG-NEXT:     clip_planes_();
// FRAG-NEXT:     pixel = color * clip_planes;
// FRAG-NEXT: }

// TABLE: "lowering": "discard"
// TABLE: "enable_mask": 0

// OLD: varying float vs_SV_CLIPPLANEDISTANCE0;
// OLD: if (vs_SV_CLIPPLANEDISTANCE0 != vs_SV_CLIPPLANEDISTANCE0 || vs_SV_CLIPPLANEDISTANCE0 < 0.0) discard;
// ES: in highp float vs_SV_CLIPPLANEDISTANCE0;

// ES2: #version 100
// ES2: #ifdef GL_FRAGMENT_PRECISION_HIGH
// ES2-NEXT: varying highp float vs_SV_CLIPPLANEDISTANCE0;
// ES2-NEXT: #else
// ES2-NEXT: varying mediump float vs_SV_CLIPPLANEDISTANCE0;
// ES2-NEXT: #endif
// ES2: clip_planes();
