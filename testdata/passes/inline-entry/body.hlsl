// The body of the entry point takes the place of its call. The structs of its signature are still there: split-variables is
// next.
// RUN: %clipc -T vs_5_0 -E structs --dump-after=inline-entry %s | FileCheck %s --check-prefix=STRUCTS
// RUN: %clipc -T vs_5_0 -E plain --dump-after=inline-entry %s | FileCheck %s --check-prefix=PLAIN
// RUN: %clipc -T vs_5_0 -E early --dump-after=inline-entry %s | FileCheck %s --check-prefix=EARLY
// RUN: %draw compare -T vs_5_0 -E structs %s
// RUN: %draw compare -T vs_5_0 -E plain %s
// RUN: %draw compare -T vs_5_0 -E early %s
// AUTOUPDATE
struct Vertex {
  float4 position : POSITION;
  float4 color : COLOR;
};
struct Varyings {
  float4 position : SV_Position;
  float4 color : COLOR;
};

Varyings structs(Vertex v) {
  Varyings o;
  v.color *= 2;
  o.position = v.position;
  o.color = v.color;
  return o;
}

// A parameter that the shader does not change is its input; one that it changes is a variable.
float4 plain(float4 position : POSITION, float4 offset : OFFSET) : SV_Position {
  position += offset;
  return position;
}

// A function that returns early stays, and its call too.
Varyings early(Vertex v) {
  Varyings o = {v.position, v.position};
  if (v.color.x > 0) return o;
  o.color = v.color;
  return o;
}

// STRUCTS: program vs_5_0 form inlined
// STRUCTS-NEXT: struct Varyings {
// STRUCTS-NEXT:   float4 position : SV_Position
// STRUCTS-NEXT:   float4 color : COLOR
// STRUCTS-NEXT: }
// STRUCTS-NEXT: struct Vertex {
// STRUCTS-NEXT:   float4 position : POSITION
// STRUCTS-NEXT:   float4 color : COLOR
// STRUCTS-NEXT: }
// STRUCTS-NEXT: input float4 in_POSITION0 : POSITION0 location 0
// STRUCTS-NEXT: input float4 in_COLOR0 : COLOR0 location 1
// STRUCTS-NEXT: output float4 vs_SV_POSITION0 : SV_Position0 builtin position
// STRUCTS-NEXT: output float4 vs_COLOR0 : COLOR0 location 0
// STRUCTS-NEXT: entry void structs() {
// STRUCTS-NEXT: }
// STRUCTS-NEXT: main void main() {
// STRUCTS-NEXT:   Vertex v.1
// STRUCTS-NEXT:   v.1.position = in_POSITION0
// STRUCTS-NEXT:   v.1.color = in_COLOR0
// STRUCTS-NEXT:   Varyings o
// STRUCTS-NEXT:   v.1.color *= splat<float4>(2.0)
// STRUCTS-NEXT:   o.position = v.1.position
// STRUCTS-NEXT:   o.color = v.1.color
// STRUCTS-NEXT:   vs_SV_POSITION0 = o.position
// STRUCTS-NEXT:   vs_COLOR0 = o.color
// STRUCTS-NEXT: }

// PLAIN: program vs_5_0 form inlined
// PLAIN-NEXT: input float4 in_POSITION0 : POSITION0 location 0
// PLAIN-NEXT: input float4 in_OFFSET0 : OFFSET0 location 1
// PLAIN-NEXT: output float4 vs_SV_POSITION0 : SV_Position0 builtin position
// PLAIN-NEXT: entry void plain() {
// PLAIN-NEXT: }
// PLAIN-NEXT: main void main() {
// PLAIN-NEXT:   float4 position = in_POSITION0
// PLAIN-NEXT:   position += in_OFFSET0
// PLAIN-NEXT:   vs_SV_POSITION0 = position
// PLAIN-NEXT: }

// EARLY: program vs_5_0 form inlined
// EARLY-NEXT: struct Varyings {
// EARLY-NEXT:   float4 position : SV_Position
// EARLY-NEXT:   float4 color : COLOR
// EARLY-NEXT: }
// EARLY-NEXT: struct Vertex {
// EARLY-NEXT:   float4 position : POSITION
// EARLY-NEXT:   float4 color : COLOR
// EARLY-NEXT: }
// EARLY-NEXT: input float4 in_POSITION0 : POSITION0 location 0
// EARLY-NEXT: input float4 in_COLOR0 : COLOR0 location 1
// EARLY-NEXT: output float4 vs_SV_POSITION0 : SV_Position0 builtin position
// EARLY-NEXT: output float4 vs_COLOR0 : COLOR0 location 0
// EARLY-NEXT: entry Varyings early(Vertex v) {
// EARLY-NEXT:   Varyings o = Varyings{v.position, v.position}
// EARLY-NEXT:   if (v.color.x > 0.0) {
// EARLY-NEXT:     return o
// EARLY-NEXT:   }
// EARLY-NEXT:   o.color = v.color
// EARLY-NEXT:   return o
// EARLY-NEXT: }
// EARLY-NEXT: main void main() {
// EARLY-NEXT:   Vertex v.1
// EARLY-NEXT:   v.1.position = in_POSITION0
// EARLY-NEXT:   v.1.color = in_COLOR0
// EARLY-NEXT:   Varyings result = early(v.1)
// EARLY-NEXT:   vs_SV_POSITION0 = result.position
// EARLY-NEXT:   vs_COLOR0 = result.color
// EARLY-NEXT: }
