// The shader of object_fields.hlsl where the entry point takes no objects: fxc before 5.0, and dxc.
// RUN: not %clipc -T vs_4_0 -fsyntax-only %S/object_fields.hlsl 2>&1 | FileCheck %s
// RUN: not %clipc -T vs_6_0 -fsyntax-only %S/object_fields.hlsl 2>&1 | FileCheck %s
// CHECK: object_fields.hlsl:7:13: error: `first.colors` of type `Texture2D<float4>` cannot be an input or output of the entry point [semantic-on-object, X3530]
