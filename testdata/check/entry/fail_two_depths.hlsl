// A pixel has one depth (google/DXC's issue 7547 and Slang's 11855 are about shaders that write two).
// RUN: not %clipc -T ps_5_0 -E parts -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=PARTS
// RUN: not %clipc -T ps_6_0 -E names -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=NAMES
// RUN: not %clipc -T ps_5_0 -E elements -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=ELEMENTS
// RUN: %clipc -T ps_5_0 -E one -fsyntax-only %s
struct D { float a, b; };
// PARTS: [[#@LINE+1]]:35: error: `SV_Depth1` writes the depth of the pixel more than once; a pixel shader writes one depth, of one component [depth-twice, X4571]
D parts(float4 p : SV_Position) : SV_Depth { D d = {p.x, p.y}; return d; }
// NAMES: [[#@LINE+1]]:101: error: `SV_Depth` writes the depth
float names(float4 p : SV_Position, out float4 c : SV_Target, out float d : SV_DepthGreaterEqual) : SV_Depth { d = c = p; return 0; }
// ELEMENTS: error: `SV_Depth1` writes the depth
void elements(float4 p : SV_Position, out float d[2] : SV_Depth) { d[0] = d[1] = p.x; }
struct One { float4 c : SV_Target; float d : SV_DepthLessEqual; };
One one(float4 p : SV_Position) { One o = {p, p.z}; return o; }
