// A member that std140 would move is left out if nothing reads it; what is read is a scalar for each component of a vector, and
// rows for whatever shares bytes with its neighbour. Everything else is a member with its name. A block of more than 16 KB ends
// after the last member that is read.
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=glsl330 --validate %s -o - | FileCheck %s --check-prefix=OLD
// RUN: %clipc -T vs_5_0 --target=essl300 --blocks=plain --validate %s -o - | FileCheck %s --check-prefix=PLAIN
// RUN: %clipc -T vs_5_0 --validate --reflect=%t.json %s -o %t.vert
// RUN: FileCheck %s --check-prefix=REFLECT --input-file=%t.json
// RUN: %clipc -T vs_5_0 --dump=table %s | FileCheck %s --check-prefix=TABLE
// RUN: %draw compare %s -T vs_5_0 --lower none
struct Odd {
  float at;
  float3 pad;
  float4 plane;
};
cbuffer Left : register(b0) {
  float speed;
  float3 pad;       // left out
  float4 tint;
  float weights[3];
  float after;      // left out: in the last row of `weights`
  float unread[2];  // left out: what is read has the room
  float read;
};
cbuffer Read : register(b1) {
  bool flag;
  bool3 flags;
  float flags_x;  // a name that a component would have
  int2 pair;
  Odd odd[2];
  float last;
};
cbuffer Large : register(b2) {
  float4 first;
  float4 bones[1100];
};

[clipplanes(odd[1].plane)]
float4 main(float4 p : POSITION) : SV_Position {
  float4 r = p * speed + tint + weights[1] + read + first;
  if (flag && flags.y) r.xy += pair + flags_x;
  return r + odd[0].at + last;
}

// CHECK: uniform Left {  // b0
// CHECK-NEXT:     float speed;
// CHECK-NEXT:     vec4 tint;
// CHECK-NEXT:     float weights[3];
// CHECK-NEXT:     layout(offset = 100) float read;
// CHECK-NEXT: } left;
// CHECK: uniform Read {  // b1
// CHECK-NEXT:     uint flag;
// CHECK-NEXT:     uint flags_x_2;
// CHECK-NEXT:     uint flags_y;
// CHECK-NEXT:     uint flags_z;
// CHECK-NEXT:     float flags_x;
// CHECK-NEXT:     int pair_x;
// CHECK-NEXT:     int pair_y;
// CHECK-NEXT:     vec4 odd_rows[4];
// CHECK-NEXT:     float last;
// CHECK-NEXT: } read;
// CHECK: uniform Large {  // b2
// CHECK-NEXT:     vec4 first;
// CHECK-NEXT: } large;
// CHECK: bvec3 flags() {  // offset 4
// CHECK-NEXT:     return bvec3(uvec3(read.flags_x_2, read.flags_y, read.flags_z));
// CHECK: ivec2 pair() {  // offset 20
// CHECK-NEXT:     return ivec2(read.pair_x, read.pair_y);

// OLD: uniform Left {  // b0
// OLD-NEXT:     float speed;
// OLD-NEXT:     vec4 tint;
// OLD-NEXT:     float weights[3];
// OLD-NEXT:     vec4 padding_80;
// OLD-NEXT:     float padding_96;
// OLD-NEXT:     float read;

// PLAIN: uniform Read {  // b1
// PLAIN-NEXT:     bool flag;
// PLAIN-NEXT:     uint flags_x_2;
// PLAIN: bvec3 flags() {  // offset 4
// PLAIN-NEXT:     return bvec3(uvec3(flags_x_2, flags_y, flags_z));

// REFLECT: "name": "pad",
// REFLECT-NEXT: "type": "float3",
// REFLECT-NEXT: "offset": 4,
// REFLECT-NEXT: "size": 12
// REFLECT-NEXT: }
// REFLECT: "name": "flags",
// REFLECT: "glsl": "Read.flags_x_2",
// REFLECT-NEXT: "function": "flags"
// REFLECT: "name": "odd",
// REFLECT: "glsl": "Read.odd_rows[0]",
// REFLECT-NEXT: "function": "odd"
// REFLECT: "name": "last",
// REFLECT: "glsl": "Read.last"

// TABLE: "byte_offset":{{ *}}80
// TABLE: "glsl_member":{{ *}}"Read.odd_rows[3]"
