// dxc's -fspv-use-legacy-buffer-matrix-order: matrices lie row by row in byte address buffers. The oracle is DXC's RawBufferMethods.cpp:
// element (row, column) of a matrix is word `row * columns + column` with the option, `column * rows + row` without it.
// RUN: %clipc -T ps_6_0 %s --target=vulkan -o - | FileCheck %s --check-prefix=COLUMNS
// RUN: %clipc -T ps_6_0 %s --target=vulkan -fspv-use-legacy-buffer-matrix-order -o - | FileCheck %s --check-prefix=ROWS
// COLUMNS: transpose(mat3x2(uintBitsToFloat(from_load2(16u)), uintBitsToFloat(from_load2(24u)), uintBitsToFloat(from_load2(32u))))
// COLUMNS: to_store2(0u, floatBitsToUint(vec2(m[0][0], m[1][0])));
// ROWS: m = mat2x3(uintBitsToFloat(from_load3(16u)), uintBitsToFloat(from_load3(28u)));
// ROWS: to_store3(0u, floatBitsToUint(m[0]));
// ROWS: to_store3(12u, floatBitsToUint(m[1]));
ByteAddressBuffer from : register(t0);
RWByteAddressBuffer to : register(u1);
float4 main(float2 uv : UV) : SV_Target {
  float2x3 m = from.Load<float2x3>(16);
  to.Store(0, m);
  return float4(mul(uv, m), 1);
}
