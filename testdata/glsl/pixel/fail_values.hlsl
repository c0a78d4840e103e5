// Inputs and attributes that a target lacks.
// RUN: not %clipc -T ps_5_0 --target=essl300 %s -o - 2>&1 | FileCheck %s --check-prefix=ES
[earlydepthstencil]
float4 main(uint primitive : SV_PrimitiveID) : SV_Target { return primitive; }
// ES-DAG: error: `SV_PrimitiveID` is an input or output that target `essl300` lacks [target-pixel-value]
// ES-DAG: error: `earlydepthstencil` is given; target `essl300` has no early tests [target-early-tests]
