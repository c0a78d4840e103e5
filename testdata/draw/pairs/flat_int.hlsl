// Integers go over unchanged.
// RUN: %python %S/../inputs/pair.py --clipc %clipc --draw %draw %s %t
struct Varyings { float4 position : SV_Position; nointerpolation uint material : MATERIAL; nointerpolation int2 offset : OFFSET; float4 color : COLOR; };
Varyings vs(float4 p : POSITION, uint m : MATERIAL, int2 o : OFFSET, float4 c : COLOR) {
  Varyings v;
  v.position = p;
  v.material = m * 7;
  v.offset = o - 2;
  v.color = c;
  return v;
}
float4 ps(Varyings v) : SV_Target { return v.color * (v.material + 1) + v.offset.xyxy; }
