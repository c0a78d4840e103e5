// Styles that a target or nobody knows.
// RUN: not %clipc -T vs_5_0 --target=vulkan --blocks=flat %s -o - 2>&1 | FileCheck %s --check-prefix=FLAT
// RUN: not %clipc -T vs_5_0 --blocks=round %s -o - 2>&1 | FileCheck %s --check-prefix=BLOCKS
// RUN: not %clipc -T vs_5_0 --names=dcx %s -o - 2>&1 | FileCheck %s --check-prefix=NAMES
// RUN: not %clipc -T vs_5_0 --names='v_{index}' %s -o - 2>&1 | FileCheck %s --check-prefix=PATTERN
// RUN: not %clipc -T vs_5_0 --names='v_{semantics}{name}' %s -o - 2>&1 | FileCheck %s --check-prefix=PLACE
// AUTOUPDATE
// FLAT: fail_styles.hlsl:[[#@LINE+3]]:9: error: `--blocks=flat` makes uniform variables of `Frame`; target `vulkan` has uniforms in blocks only [target-flat-uniforms]
// FLAT-NEXT:    [[#@LINE+2]] | cbuffer Frame { float4x4 view; };
// FLAT-NEXT:       |         ^~~~~
cbuffer Frame { float4x4 view; };
float4 main(float4 p : POSITION) : SV_Position { return mul(p, view); }

// BLOCKS: clipc: error: unknown value `round` of --blocks; there is `named`, `plain` or `flat`

// NAMES: clipc: error: unknown names `dcx`; did you mean `dxc`?; a pattern contains `{semantic}`, `{written}` or `{name}` [unknown-names]

// PATTERN: clipc: error: unknown names `v_{index}`; there is `hlslcc`, `dxc` or `spirv-cross`; a pattern contains `{semantic}`, `{written}` or `{name}` [unknown-names]

// PLACE: clipc: error: unknown names `v_{semantics}{name}`; there is `hlslcc`, `dxc` or `spirv-cross`; a pattern contains `{semantic}`, `{written}` or `{name}` [unknown-names]
