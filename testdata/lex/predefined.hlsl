// RUN: %clipc --dump=tokens -T vs_5_0 %s | FileCheck %s --check-prefix=FXC
// RUN: %clipc --dump=tokens -T vs_6_3 %s | FileCheck %s --check-prefixes=DXC,DEFAULT
// RUN: %clipc --dump=tokens -T vs_6_3 -HV 2018 %s | FileCheck %s --check-prefixes=DXC,OLD
__CLIPC__ __HLSL_VERSION __SHADER_TARGET_MAJOR __SHADER_TARGET_MINOR
// FXC: int 1
// FXC-NEXT: identifier __HLSL_VERSION
// FXC-NEXT: identifier __SHADER_TARGET_MAJOR
// DXC: int 1
// DEFAULT-NEXT: int 2021
// OLD-NEXT: int 2018
// DXC-NEXT: int 6
// DXC-NEXT: int 3
#if __SHADER_TARGET_STAGE == __SHADER_STAGE_VERTEX && defined(__hlsl_dx_compiler)
vertex
#endif
// FXC-NOT: identifier vertex
// DXC: identifier vertex
#if defined(__clang__) || defined(__x86_64__) || defined(__GNUC__) || defined(__STDC__)
leaked
#endif
// FXC-NOT: leaked
// DXC-NOT: leaked
