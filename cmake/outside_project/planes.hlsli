// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
cbuffer Clip : register(b3) {
  float4 first;
  float4 second;
};
