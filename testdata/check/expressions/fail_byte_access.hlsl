// RUN: not %clipc -T vs_6_2 -E main %s 2>&1 | grep -v '^ ' | FileCheck %s
// RUN: not %clipc -T vs_6_2 -E main -Zpr %s 2>&1 | FileCheck %s --check-prefix=ROWS
struct Turned { row_major float2x3 turn; };
struct Empty {};
struct Holds { float a; Texture2D b; };
ByteAddressBuffer bytes;
RWByteAddressBuffer written;
Texture2D picture;
float4 main(float4 p : POSITION) : SV_Position {
  // CHECK: [[#@LINE+1]]:9: error: `Load` of a row-major matrix is not supported [unsupported]
  bytes.Load<Turned>(0);
  // ROWS: [[#@LINE+1]]:9: error: `Load` of a row-major matrix is not supported [unsupported]
  bytes.Load<float2x2>(0);
  // CHECK-NEXT: [[#@LINE+1]]:9: error: `Load` with the type argument `Holds` is not supported [unsupported]
  bytes.Load<Holds>(0);
  // CHECK-NEXT: [[#@LINE+1]]:9: error: `Load` with the type argument `Empty` is not supported
  bytes.Load<Empty>(0);
  // CHECK-NEXT: [[#@LINE+1]]:9: error: `Load2` with the type argument `float` is not supported
  bytes.Load2<float>(0);
  // CHECK-NEXT: [[#@LINE+1]]:11: error: `Load` with the type argument `float` is not supported
  picture.Load<float>(0);
  uint status;
  Turned turned = (Turned)0;
  // CHECK-NEXT: [[#@LINE+1]]:9: error: `Load` has a status of tiled resources; no target has one for a buffer [method-status]
  bytes.Load<float4>(0, status);
  // CHECK-NEXT: [[#@LINE+1]]:9: error: `ByteAddressBuffer` has no method `Store` [method-unknown, X3018]
  bytes.Store(0, p);
  // CHECK-NEXT: [[#@LINE+1]]:11: error: `Store` takes 2 arguments; 1 given [intrinsic-argument-count, X3013]
  written.Store(0);
  // CHECK-NEXT: [[#@LINE+1]]:28: error: cannot convert `float2` to `float4` [cannot-convert, X3017]
  written.Store<float4>(0, p.xy);
  // CHECK-NEXT: [[#@LINE+1]]:17: error: cannot convert `Turned` to `uint` [cannot-convert, X3017]
  written.Store(turned, p);
  return p;
}
