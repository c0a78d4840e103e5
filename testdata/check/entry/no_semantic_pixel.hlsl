// A pixel's result without a semantic can only be its colour: fxc refuses it (X3502), clipc warns.
// RUN: %clipc -T ps_5_0 --validate %s -o - 2>&1 | FileCheck %s
// CHECK: [[#@LINE+2]]:8: warning: `main` has no semantic; clipc assumes `SV_Target`, fxc reports an error [-Wsemantic-missing]
// CHECK: layout(location = 0) out vec4 SV_Target0;
float4 main(float4 c : COLOR) { return c; }
