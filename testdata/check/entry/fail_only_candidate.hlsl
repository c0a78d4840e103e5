// A name that is far from every function's: those that look like entry points are suggested, or come first.
// RUN: not %clipc -T vs_5_0 %s 2>&1 | FileCheck %s
// RUN: not %clipc -T vs_5_0 -DONE %s 2>&1 | FileCheck %s
// RUN: not %clipc -T vs_5_0 -DTWO %s 2>&1 | FileCheck %s --check-prefix=TWO
// CHECK: error: entry point `main` was not found; did you mean `TransformVertex`? [entry-not-found, X3501]
// TWO: error: entry point `main` was not found; `-E` names one of `TransformNormal`, `TransformVertex`, `Twice` [entry-not-found, X3501]
#ifndef ONE
float4 Twice(float4 v) { return v * 2; }
#endif
#ifdef TWO
float4 TransformNormal(float4 n : NORMAL) : SV_Position { return n; }
#endif
float4 TransformVertex(float4 v : POSITION) : SV_Position { return v; }
