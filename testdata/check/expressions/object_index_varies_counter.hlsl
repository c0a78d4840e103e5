// The index of a structured buffer whose counter changes: the message names the buffer, once, and not the counter's own one (DXC's
// CodeGenSPIRV/type.rwstructured-buffer.array.multidim.counter.error.hlsl).
// RUN: %clipc -T ps_6_0 --target=vulkan -fsyntax-only %s 2>&1 | FileCheck %s --implicit-check-not=warning:
RWStructuredBuffer<uint> lists[2][3];
float4 main(nointerpolation uint i : I) : SV_Target {
  // CHECK: [[#@LINE+1]]:12: warning: the index of `lists` may differ between the pixels of a draw call, {{.*}} [-Wobject-index-varies]
  lists[1][i].IncrementCounter();
  return lists[i][i][0];
}
