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
