// RUN: not %clipc -T ps_5_0 %s 2>&1 | FileCheck %s
// RUN: not %clipc -T ps_6_0 %s -DDXIL 2>&1 | FileCheck %s --check-prefix=DXIL
struct Data { float4 value : VALUE; };
float data[2];
#ifdef DXIL
float4 main() : SV_Target {
  // DXIL: [[#@LINE+1]]:32: error: cannot convert `float[2]` to `InputPatch` [cannot-convert, X3017]
  InputPatch<float, 2> patch = data;
  return patch[0];
}
#else
// CHECK: [[#@LINE+1]]:33: error: `ends` of type `InputPatch` cannot be an input or output of the entry point; `-T hs_5_0` compiles a hull shader [semantic-on-object, X3530]
float4 main(InputPatch<Data, 2> ends) : SV_Target {
  OutputPatch<float, 2> patch = data;
  // CHECK: [[#@LINE+1]]:3: error: `patch` is constant; it cannot be assigned to [const-assigned, X3025]
  patch[0] = 3;
  // CHECK: [[#@LINE+1]]:24: error: `none` is `const` and has no value; {{.*}} [const-without-value, X3012]
  InputPatch<float, 2> none;
  // CHECK: [[#@LINE+1]]:21: error: the array has 0 elements; {{.*}} [bad-array-size, X3058]
  InputPatch<float, 0> empty = data;
  return patch[0];
}
#endif
