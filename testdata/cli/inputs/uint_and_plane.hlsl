cbuffer Clip { float4 plane; };

[clipplanes(plane)]
float4 main(float4 position : POSITION, uint bone : BLENDINDICES) : SV_Position {
  return position + float(bone);
}
