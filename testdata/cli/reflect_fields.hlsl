// --reflect=FILE.json has the fields of structs in constant buffers, each struct once and inner before outer.
// RUN: %clipc -T vs_5_0 %s -o %t.vert --reflect=%t.json && FileCheck %s --match-full-lines < %t.json
// RUN: %python -m json.tool < %t.json
struct Inner { float3 a; float b; row_major float2x3 m; };
struct Light { float4 colour; Inner inner[2]; float range; };
struct Unused { float a; };
cbuffer C { Light lights[4]; Inner one; };
float4 main(float4 p : POSITION) : SV_Position { return p * lights[1].inner[1].b; }
// CHECK:        "structs": [
// CHECK-NEXT:     {
// CHECK-NEXT:       "name": "Inner",
// CHECK-NEXT:       "size": 44,
// CHECK-NEXT:       "fields": [
// CHECK-NEXT:         {
// CHECK-NEXT:           "name": "a",
// CHECK-NEXT:           "type": "float3",
// CHECK-NEXT:           "offset": 0,
// CHECK-NEXT:           "size": 12
// CHECK-NEXT:         },
// CHECK:                "name": "b",
// CHECK-NEXT:           "type": "float",
// CHECK-NEXT:           "offset": 12,
// CHECK:                "name": "m",
// CHECK-NEXT:           "type": "float2x3",
// CHECK-NEXT:           "offset": 16,
// CHECK-NEXT:           "size": 28,
// CHECK-NEXT:           "rowMajor": true
// CHECK:              "name": "Light",
// CHECK-NEXT:         "size": 112,
// CHECK:                "name": "inner",
// CHECK-NEXT:           "type": "Inner[2]",
// CHECK-NEXT:           "offset": 16,
// CHECK-NEXT:           "size": 92
// CHECK:                "name": "range",
// CHECK-NEXT:           "type": "float",
// CHECK-NEXT:           "offset": 108,
// CHECK-NOT:            "name":
// CHECK:        "resources": [],
