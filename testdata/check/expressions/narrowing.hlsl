// fxc's X3205 and X3206: what a conversion loses.
// RUN: %clipc -T vs_5_0 %s -o %t 2>&1 | FileCheck %s
// AUTOUPDATE
double wide;
float4 main(float4 p : POSITION) : SV_Position {
// CHECK: narrowing.hlsl:[[#@LINE+3]]:18: warning: conversion from larger type `double` to smaller type `float`, possible loss of data [-Wimplicit-narrowing]
// CHECK-NEXT:     [[#@LINE+2]] |   float narrow = wide;
// CHECK-NEXT:       |                  ^~~~
  float narrow = wide;
// CHECK-NEXT: narrowing.hlsl:[[#@LINE+3]]:16: warning: implicit truncation of vector type `float4` to `float2` [-Wimplicit-truncation]
// CHECK-NEXT:    [[#@LINE+2]] |   float2 two = p;
// CHECK-NEXT:       |                ^
  float2 two = p;
  return float4(two, narrow, 1);
}
