// RUN: %clipc -T vs_5_0 -E main --dump=ir %s | FileCheck %s --check-prefix=MAIN
// RUN: %clipc -T vs_5_0 -E a::main --dump=ir %s | FileCheck %s --check-prefix=QUALIFIED
// RUN: %clipc -T vs_5_0 -E only_here --dump=ir %s | FileCheck %s --check-prefix=ONLY
float4 main(float4 v : POSITION) : SV_Position;
namespace a {
float4 main(float4 v : POSITION) : SV_Position { return v * 2; }
float4 only_here(float4 v : POSITION) : SV_Position { return v * 3; }
}
float4 main(float4 v : POSITION) : SV_Position { return v; }
// MAIN: return v{{$}}
// QUALIFIED: return v * splat<float4>(2.0)
// ONLY: return v * splat<float4>(3.0)
