// Bit-fields of one type share 32 bits, from the lowest up; one that does not fit begins the next 32, and so does `: 0`. Oracle: dxc,
// whose SPIR-V back-end merges bit-fields of one type while there is room, and Clang's layout for DXIL, which is the same for these.
// RUN: %clipc -T vs_6_0 --target=glsl450 --validate %s 2>%t.messages -o - | FileCheck %s
// RUN: count 0 < %t.messages
struct Vertex {
  uint kind : 4;
  uint index : 12;
  uint : 3;
  uint rest : 13;
  int low : 5;
  int : 0;
  int high : 20;
  float scale;
};
// CHECK: struct Vertex {
// CHECK-NEXT: uint kind_index_rest;
// CHECK-NEXT: int low;
// CHECK-NEXT: int high;
// CHECK-NEXT: float scale;
struct Derived : Vertex {
  uint flag : 1;
  uint Sum() { return kind + index + flag; }
  void Set(uint value) { index = value; }
};
cbuffer Frame {
  Vertex vertices[4];
}
Vertex Make(uint number) {
  Vertex v;
  v.kind = number * 7;
  v.index = number + 4000;
  v.rest = number;
  v.low = -int(number);
  v.high = int(number) * 100000;
  v.scale = 2;
  return v;
}
void Fill(out Vertex v, int number) {
  v.kind = 31;
  v.index = 3;
  v.rest = 1u << 12;
  v.low = number;
  v.high = -1;
  v.scale = 1;
}
float4 main(uint id : ID) : SV_Position {
  Vertex v = Make(id & 255);
  // CHECK: v.kind_index_rest = (v.kind_index_rest & 4294967280u) | (((v.kind_index_rest & 15u) + 3u) & 15u);
  v.kind += 3;
  uint before = v.index++;
  int after = --v.low;
  Vertex filled;
  Fill(filled, int(id));
  Vertex list = {1, 2, 3, 4, -5, 6};
  v.high = list.low = 11;
  float copy[6] = {list};
  Derived derived = (Derived)0;
  derived.Set(9);
  derived.flag = 3;
  Vertex arrays[2] = {v, filled};
  arrays[id & 1].rest ^= 5;
  // CHECK: float((frame.vertices[{{.*}}].kind_index_rest >> 4) & 4095u)
  float stored = float(vertices[id & 3].index) + vertices[id & 3].low;
  return float4(v.kind + before + v.index, v.low + after + v.high, derived.Sum() + copy[3] + copy[4], arrays[1].rest + filled.low) * v.scale +
         arrays[0].rest + stored + filled.kind + filled.high;
}
// RUN: %draw compare %s -T vs_6_0
