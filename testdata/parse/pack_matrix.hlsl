// RUN: %clipc --dump=ast %s | FileCheck %s
// AUTOUPDATE
float4x4 first;
#pragma pack_matrix(row_major)
float4x4 second;
cbuffer C {
  float4x4 third;
#pragma pack_matrix(column_major)
  float4x4 fourth;
  row_major float4x4 fifth;
}

// CHECK: variable first : float4x4
// CHECK-NEXT: variable second : float4x4 pack_row_major
// CHECK-NEXT: cbuffer C
// CHECK-NEXT:   member third : float4x4 pack_row_major
// CHECK-NEXT:   member fourth : float4x4 pack_column_major
// CHECK-NEXT:   member fifth : float4x4 row_major pack_column_major
