// RUN: %clipc --dump=tokens -T vs_5_0 %s | FileCheck %s --check-prefix=FXC
// RUN: %clipc --dump=tokens -T vs_6_3 %s | FileCheck %s --check-prefixes=DXC,DEFAULT
// RUN: %clipc --dump=tokens -T vs_6_3 -HV 2018 %s | FileCheck %s --check-prefixes=DXC,OLD
// RUN: %clipc --dump=tokens -T vs_6_3 --target=vulkan %s | FileCheck %s --check-prefix=SPIRV -DMINOR=3
// RUN: %clipc --dump=tokens -T vs_6_3 -spirv -fspv-target-env=vulkan1.2 %s | FileCheck %s --check-prefix=SPIRV -DMINOR=5
// RUN: %clipc --dump=tokens -T vs_6_3 -G %s | FileCheck %s --check-prefix=SPIRV -DMINOR=0
// RUN: %clipc --dump=tokens -T vs_5_0 -spirv %s | FileCheck %s --check-prefix=FXC
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
// DXC's macros for SPIR-V ("Macros for SPIR-V" of its SPIR-V.rst), from 6.0 on as its others.
#ifdef __spirv__
spirv __SPIRV_MAJOR_VERSION__ __SPIRV_MINOR_VERSION__
#endif
// FXC-NOT: identifier spirv
// DXC-NOT: identifier spirv
// SPIRV: identifier spirv
// SPIRV-NEXT: int 1
// SPIRV-NEXT: int [[MINOR]]
