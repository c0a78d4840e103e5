// Declarations of GLSL: the first word is named, and no `;` is missed.
// RUN: not %clipc %s -fsyntax-only 2>&1 | FileCheck %s --implicit-check-not=error:
// RUN: not %clipc %s -fsyntax-only --diagnostics=json 2>&1 | FileCheck %s --check-prefix=NAMES
// NAMES: "name": "layout-of-glsl"
// CHECK: [[#@LINE+1]]:1: error: `attribute` is as in GLSL, and clipc reads HLSL; an input is a parameter of the entry function, with a semantic [glsl-word, X3000]
attribute vec3 place;
// CHECK: [[#@LINE+1]]:1: error: `precision` is as in GLSL, and clipc reads HLSL; remove it, or declare `min16float` [glsl-word, X3000]
precision mediump float;
// CHECK: [[#@LINE+1]]:9: error: `highp` is as in GLSL, and clipc reads HLSL; remove it, or declare `min16float` [glsl-word, X3000]
uniform highp vec4 tint;
// CHECK: [[#@LINE+2]]:1: warning: attribute `layout` has no effect; clipc does not translate it [-Wattribute-without-effect]
// CHECK: note: `layout` is as in GLSL; in HLSL a binding is `: register(t0)`
layout(binding = 0) Texture2D map;
float4 main(float4 p : POSITION) : SV_Position { return p; }
