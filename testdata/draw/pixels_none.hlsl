// Asked to ignore the planes: the whole target, also where a plane would cut it away.
// RUN: %clipc -T vs_5_0 -E main --lower=none %s -o %t.vert
// RUN: %draw pixels %t.vert --zero-to-one --enable 0

cbuffer Planes {
  float4 first;
};

[clipplanes(first)]
float4 main(float4 position : POSITION) : SV_Position { return position; }
