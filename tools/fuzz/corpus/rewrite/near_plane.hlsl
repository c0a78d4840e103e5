//1
float4 plane;
[ ClipPlanes (plane) /**/ ] float4 main(float4 p : POSITION) : SV_Position { return p; }
