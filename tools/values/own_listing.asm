//
// Input signature:
//
// Name                 Index   Mask Register SysValue  Format   Used
// -------------------- ----- ------ -------- -------- ------- ------
// SV_Position              0   xyzw        0      POS   float   x
// COLOR                    0   xyz         1     NONE   float   xyz
// PICK                     0   xy          2     NONE    uint   x
//
//
// Output signature:
//
// Name                 Index   Mask Register SysValue  Format   Used
// -------------------- ----- ------ -------- -------- ------- ------
// SV_Target                0   xyzw        0   TARGET   float   xyzw
//
ps_5_0
dcl_globalFlags refactoringAllowed
dcl_constantbuffer CB0[2], immediateIndexed
dcl_sampler s0, mode_default
dcl_resource_texture2d (float,float,float,float) t0
dcl_input_ps_siv linear noperspective v0.x, position
dcl_input_ps linear v1.xyz
dcl_input_ps constant v2.x
dcl_output o0.xyzw
dcl_temps 3
mov r0.xyzw, cb0[0].xyzw
mov r1.x, l(0)
loop
  ige r1.y, r1.x, l(3)
  breakc_nz r1.y
  itof r1.y, r1.x
  mul r1.yz, r1.yyyy, v1.yyxy
  sample_l_indexable(texture2d)(float,float,float,float) r2.xyzw, r1.yzyy, t0.xyzw, s0, l(0.000000)
  add r0.xyzw, r0.xyzw, r2.xyzw
  iadd r1.x, r1.x, l(1)
endloop
lt r1.x, v1.z, l(0.250000)
if_nz r1.x
  frc r1.y, v1.x
  deriv_rty r1.z, v1.y
  add r0.x, r1.z, r1.y
endif
and r1.x, v2.x, l(3)
ieq r1.x, r1.x, l(1)
itof r1.y, cb0[1].x
mul r1.y, r0.w, r1.y
movc_sat r0.w, r1.x, v0.x, r1.y
mov_sat r0.xyz, r0.xyzx
mov o0.xyzw, r0.xyzw
ret
// Approximately 24 instruction slots used
