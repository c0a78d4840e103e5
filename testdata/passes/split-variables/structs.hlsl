// The structs of a signature become the inputs and outputs themselves; what is more than that stays.
// RUN: %clipc -T vs_5_0 -E parameter --dump-after=split-variables %s | FileCheck %s --check-prefix=PARAMETER
// RUN: %draw compare -T vs_5_0 -E parameter %s
// RUN: %draw compare -T vs_5_0 -E itself %s
// RUN: %clipc -T vs_5_0 -E plain --dump-after=split-variables %s | FileCheck %s --check-prefix=PLAIN
// RUN: %clipc -T vs_5_0 -E changed --dump-after=split-variables %s | FileCheck %s --check-prefix=CHANGED
// RUN: %clipc -T vs_5_0 -E zero --dump-after=split-variables %s | FileCheck %s --check-prefix=ZERO
// RUN: %clipc -T vs_5_0 -E built --dump-after=split-variables %s | FileCheck %s --check-prefix=BUILT
// RUN: %clipc -T vs_5_0 -E whole --dump-after=split-variables %s | FileCheck %s --check-prefix=WHOLE
// RUN: %clipc -T vs_5_0 -E early --dump-after=split-variables %s | FileCheck %s --check-prefix=EARLY
// RUN: %clipc -T vs_5_0 -E exact --dump-after=split-variables %s | FileCheck %s --check-prefix=EXACT
// RUN: %clipc -T vs_5_0 -E back_and_forth --dump-after=split-variables %s | FileCheck %s --check-prefix=BACK
// RUN: %draw compare -T vs_5_0 -E plain %s
// RUN: %draw compare -T vs_5_0 -E changed %s
// RUN: %draw compare -T vs_5_0 -E zero %s
// RUN: %draw compare -T vs_5_0 -E built %s
// RUN: %draw compare -T vs_5_0 -E whole %s
// RUN: %draw compare -T vs_5_0 -E early %s
// RUN: %draw compare -T vs_5_0 -E exact %s
// RUN: %draw compare -T vs_5_0 -E back_and_forth %s
struct Vertex {
  float4 position : POSITION;
  float3 normal : NORMAL;
  bool lit : LIT;
};
struct Varyings {
  float4 position : SV_Position;
  float4 color : COLOR;
};

// PLAIN: entry void plain() {
// PLAIN-NEXT: }
// PLAIN: main void main() {
// PLAIN-NEXT: vs_SV_POSITION0 = in_POSITION0
// PLAIN-NEXT: vs_COLOR0 = float4(in_NORMAL0, 1.0)
// PLAIN-NEXT: vs_COLOR0.w = vs_SV_POSITION0.w
// PLAIN-NEXT: }
Varyings plain(Vertex v) {
  Varyings o;
  o.position = v.position;
  o.color = float4(v.normal, 1);
  o.color.w = o.position.w;
  return o;
}

// An input that the shader changes is a variable, and so is one that has to be converted.
// CHANGED: main void main() {
// CHANGED-NEXT: float3 normal = in_NORMAL0
// CHANGED-NEXT: bool lit = convert<bool>(in_LIT0)
// CHANGED-NEXT: normal *= splat<float3>(2.0)
// CHANGED-NEXT: vs_SV_POSITION0 = in_POSITION0
// CHANGED-NEXT: vs_COLOR0 = lit ? float4(normal, 1.0) : splat<float4>(0.0)
Varyings changed(Vertex v) {
  Varyings o;
  v.normal *= 2;
  o.position = v.position;
  o.color = v.lit ? float4(v.normal, 1) : 0;
  return o;
}

// A zero that is overwritten anyway is not written.
// ZERO: main void main() {
// ZERO-NEXT: vs_COLOR0 = zero<float4>
// ZERO-NEXT: vs_SV_POSITION0 = in_POSITION0
// ZERO-NEXT: if (in_NORMAL0.x > 0.0) {
// ZERO-NEXT: vs_COLOR0 = in_POSITION0
Varyings zero(Vertex v) {
  Varyings o = (Varyings)0;
  o.position = v.position;
  if (v.normal.x > 0) o.color = v.position;
  return o;
}

// BUILT: main void main() {
// BUILT-NEXT: vs_SV_POSITION0 = in_POSITION0
// BUILT-NEXT: vs_COLOR0 = float4(in_NORMAL0, 0.5)
// BUILT-NEXT: }
Varyings built(Vertex v) {
  Varyings o = {v.position, float4(v.normal, 0.5)};
  return o;
}

// WHOLE: main void main() {
// WHOLE: Varyings o
// WHOLE: shade(o, in_NORMAL0)
// WHOLE-NEXT: vs_SV_POSITION0 = o.position
// WHOLE-NEXT: vs_COLOR0 = o.color
void shade(inout Varyings o, float3 n) { o.color = float4(n, o.position.x); }
Varyings whole(Vertex v) {
  Varyings o;
  o.position = v.position;
  o.color = 0;
  shade(o, v.normal);
  return o;
}

// EARLY: entry Varyings early(Vertex v) {
// EARLY: main void main() {
// EARLY-NEXT: Vertex v.1 = Vertex{in_POSITION0, in_NORMAL0, convert<bool>(in_LIT0)}
// EARLY: Varyings result = early(v.1)
// EARLY: vs_COLOR0 = result.color
Varyings early(Vertex v) {
  Varyings o = {v.position, v.position};
  if (v.lit) return o;
  o.color = v.normal.xyzz;
  return o;
}

// `precise` is the variable's; it is not lost.
// EXACT: main void main() {
// EXACT: precise Varyings o
// EXACT: vs_COLOR0 = o.color
Varyings exact(Vertex v) {
  precise Varyings o;
  o.position = v.position;
  o.color = v.position * v.normal.xyzx + v.normal.zzzz;
  return o;
}

// BACK: main void main() {
// BACK-NEXT: vs_POSITION0 = in_POSITION0
// BACK-NEXT: vs_COLOR0 = in_COLOR0
// BACK-NEXT: vs_POSITION0 += vs_COLOR0
// BACK-NEXT: vs_SV_POSITION0 = vs_POSITION0
// BACK-NEXT: }
void back_and_forth(inout float4 position : POSITION, inout float4 color : COLOR, out float4 clip : SV_Position) {
  position += color;
  clip = position;
}

// A parameter's `precise` holds for the output that it becomes.
// PARAMETER: main void main() {
// PARAMETER-NEXT: precise float4 position.1
// PARAMETER-NEXT: position.1 = in_POSITION0
// PARAMETER-NEXT: vs_SV_POSITION0 = position.1
// PARAMETER-NEXT: }
void parameter(float4 p : POSITION, out precise float4 position : SV_Position) { position = p; }

// What a struct is made of may be itself.
Varyings itself(Vertex v) {
  Varyings o = {v.position, v.position};
  o = (Varyings)(o.position.y * 2);
  return o;
}
