cbuffer cbConstants { float4x4 view_projection; };
void main(in float3 position : ATTRIB0, out float4 place : SV_POSITION) {
  place = MATRIX_PRODUCT(view_projection, float4(position, 1));
}
