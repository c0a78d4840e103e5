// Arguments are evaluated from left to right, `out` arguments as the places that they name: DXC's CodeGenFunction::EmitCallArgs.
// RUN: %clipc -T cs_6_0 %s | FileCheck %s
RWBuffer<uint> b;
RWStructuredBuffer<uint> s;
groupshared uint g[8];
uint Write(uint value, out uint place) { return place = value; }
uint Next(inout uint n) { return ++n; }
[numthreads(1, 1, 1)]
void main() {
  uint n = 0, places[8];
  // CHECK: uint [[VALUE:temporary[_0-9]*]] = n++;
  // CHECK: [[PLACE:temporary[_0-9]*]] = int(n);
  // CHECK: Write([[VALUE]], [[ELEMENT:temporary[_0-9]*]]);
  // CHECK: imageStore(b, [[PLACE]], uvec4([[ELEMENT]], 0u, 0u, 0u));
  Write(n++, b[n]);
  // CHECK: [[VALUE:temporary[_0-9]*]] = n++;
  // CHECK: [[PLACE:temporary[_0-9]*]] = n++;
  // CHECK: Write([[VALUE]], [[ELEMENT:temporary[_0-9]*]]);
  // CHECK: s[[[PLACE]]] = [[ELEMENT]];
  Write(n++, s[n++]);
  // CHECK: [[SUM:temporary[_0-9]*]] = Next(n);
  // CHECK-NEXT: [[VALUE:temporary[_0-9]*]] = n;
  // CHECK-NEXT: [[PLACE:temporary[_0-9]*]] = n;
  // CHECK-NEXT: places[[[PLACE]]] = atomicAdd(g[[[SUM]]], [[VALUE]]);
  InterlockedAdd(g[Next(n)], n, places[n]);
  // CHECK: [[VALUE:temporary[_0-9]*]] = n++;
  // CHECK-NEXT: [[PLACE:temporary[_0-9]*]] = n;
  // CHECK: [[ELEMENT:temporary[_0-9]*]] = atomicAdd(s[0], [[VALUE]]);
  // CHECK-NEXT: s[[[PLACE]]] = [[ELEMENT]];
  InterlockedAdd(s[0], n++, s[n]);
  b[0] = places[1];
}
