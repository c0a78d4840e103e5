//
// Parameters:
//
//   bool bright;
//   int count;
//   sampler2D picture;
//   float2 shift;
//   samplerCUBE sky;
//   float4 tint;
//   float3x3 turn;
//
//
// Registers:
//
//   Name         Reg   Size
//   ------------ ----- ----
//   bright       b0       1
//   shift        c0       1
//   tint         c1       1
//   count        c2       1
//   turn         c3       3
//   picture      s0       1
//   sky          s1       1
//

    ps_3_0
    def c8, 0, 1, 2, 0.25
    def c9, 2.5, 0.5, -0.25, -1
    defi i0, 6, 0, 1, 0
    dcl_texcoord v0.xy
    dcl_texcoord1 v1.xyz
    dcl_color_pp v2
    dcl vPos.xy
    dcl vFace
    dcl_2d s0
    dcl_cube s1
    nrm r0.xyz, v1
    mov r1, c8.x
    mov r2.x, c8.x
    loop aL, i0
      break_ge r2.x, c2.x
      add r2.x, r2.x, c8.y
      mul r3.xy, r2.x, v0
      mov r3.zw, c8.xyxy
      texldl r3, r3, s0
      add r1, r1, r3
    endloop
    if_lt r0.x, c0.y
      lrp r1, r0.z, c1, r1
    else
      pow r1.x, r0.y, c9.x
      rsq r1.y, r0_abs.y
      log r2.w, r0.z
      dp2add r2.w, v0, c0, r2.w
      frc r1.w, r2.w
    endif
    if b0
      mul r3.xyz, r1.y, c4
      mad r3.xyz, r1.x, c3, r3
      mad r3.xyz, r1.z, c5, r3
      m3x3 r1.xyz, r3, c3
    endif
    mov r2, v2
    add r3, r2.w, -c8.w
    texkill r3
    sincos r4.xy, v0.x
    dsx r4.z, v0.x
    dsy r4.w, v0.y
    add oC0, r1, r4
    mov r5.xy, v0
    mov r5.zw, c8.xyyz
    texldp r6, r5, s0
    texldd_pp r7, v0, s0, c0, c1
    add r6, r6, r7
    texldb r7, r5, s0
    add r6, r6, r7
    texld r7, r0, s1
    mad r6, r7, c9.y, r6
    crs r7.xyz, r6, r0
    add_sat r8.xyz, r6, c9.z
    setp_gt p0.xyz, r0, r2
    mov r6.xyz, r8
    (p0) mov r6.xyz, r7
    mov r6.w, vPos.y
    cmp r6.w, -vFace.x, r6.w, vPos.x
    mov oC1, r6
    add r9.x, v0.y, -c9.w
    rcp oDepth, r9.x

// approximately 56 instruction slots used (7 texture, 49 arithmetic)
