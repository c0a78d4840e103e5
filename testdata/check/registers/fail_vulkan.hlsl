// RUN: not %clipc -T vs_5_0 -E partial %s 2>&1 | FileCheck %s --check-prefix=PARTIAL
// RUN: not %clipc -T vs_5_0 -E twice %s 2>&1 | FileCheck %s --check-prefix=TWICE
// RUN: not %clipc -T vs_5_0 -E arguments %s 2>&1 | FileCheck %s --check-prefix=ARGUMENTS
// RUN: not %clipc -T vs_5_0 -E builtin %s 2>&1 | FileCheck %s --check-prefix=BUILTIN
// RUN: not %clipc -T vs_5_0 -E misfit %s 2>&1 | FileCheck %s --check-prefix=MISFIT
// RUN: not %clipc -T vs_5_0 -E moved %s 2>&1 | FileCheck %s --check-prefix=MOVED
// RUN: not %clipc -T vs_5_0 -E number %s 2>&1 | FileCheck %s --check-prefix=NUMBER
// RUN: not %clipc -T vs_5_0 -E two %s 2>&1 | FileCheck %s --check-prefix=TWO
// RUN: not %clipc -T vs_5_0 -E constant %s 2>&1 | FileCheck %s --check-prefix=CONSTANT
// RUN: not %clipc -T vs_5_0 -E image %s 2>&1 | FileCheck %s --check-prefix=IMAGE
// RUN: not %clipc -T vs_5_0 -E high %s 2>&1 | FileCheck %s --check-prefix=HIGH
// RUN: not %clipc -T vs_5_1 -E far %s --target=vulkan 2>&1 | FileCheck %s --check-prefix=FAR
// RUN: not %clipc -T vs_5_1 -E same %s --target=vulkan 2>&1 | FileCheck %s --check-prefix=SAME
// RUN: %clipc -T vs_5_1 -E units %s --validate -o - 2>&1 | FileCheck %s --check-prefix=UNITS
// RUN: %clipc -T vs_5_0 -E misplaced %s -o /dev/null 2>&1 | FileCheck %s --check-prefix=MISPLACED

// PARTIAL: error: `b` has no location, unlike other inputs; give a location to all of them or to none [location-partial]
float4 partial([[vk::location(1)]] float4 a : A, float4 b : B) : SV_Position { return a + b; }

// TWICE: error: location 2 of `b` is that of `a[1]` too [location-twice]
float4 twice([[vk::location(1)]] float4 a[2] : A, [[vk::location(2)]] float4 b : B) : SV_Position { return a[0] + b; }

// ARGUMENTS: error: `vk::binding` takes a binding and a set from 0 to 65534 [vulkan-argument]
// ARGUMENTS: error: `vk::location` takes a location from 0 to 4094 [vulkan-argument]
[[vk::binding(1, 2, 3)]] cbuffer Wrong { float4 wrong; };
float4 arguments([[vk::location(-1)]] float4 a : A) : SV_Position { return a + wrong; }

// BUILTIN: error: `vk::HelperInvocation` is not an input of a vertex shader [semantic-not-for-stage, X4502]
float4 builtin(float4 a : A, [[vk::builtin("HelperInvocation")]] bool b : B) : SV_Position { return a * b; }

struct Weights { float4 a; float weights[3]; };
// MISFIT: error: `weights.weights[1]` is 16 bytes on by Direct3D's packing and 4 by Vulkan's; reorder or pad the push constants so that both agree [push-constant-misfit]
[[vk::push_constant]] Weights weights;
float4 misfit(float4 p : POSITION) : SV_Position { return p * weights.weights[1]; }

// MOVED: error: `b` of type `float3` cannot be at byte 8; fields follow each other, a scalar or vector lies within 16 bytes, and everything else starts at a multiple of 16 [offset-misfit]
// MOVED: error: `c` of type `float` cannot be at byte 4
struct Moved { float a; [[vk::offset(8)]] float3 b; [[vk::offset(4)]] float c; };
[[vk::push_constant]] Moved moved_;
float4 moved(float4 p : POSITION) : SV_Position { return p * moved_.b.x; }

// NUMBER: error: push constant `number_` has type `float4`; it must be a struct [push-constant-not-struct]
[[vk::push_constant]] float4 number_;
float4 number(float4 p : POSITION) : SV_Position { return p * number_; }

struct One { float4 a; };
// TWO: error: `one` and `other` are both push constants; a shader has one block of them [push-constant-twice]
// TWO: note: `one` is declared here
[[vk::push_constant]] One one;
[[vk::push_constant]] ConstantBuffer<One> other;
float4 two(float4 p : POSITION) : SV_Position { return one.a + other.a; }

// CONSTANT: error: `vector_` has a `vk::constant_id`; it must be a scalar with a constant value [constant-id-not-scalar]
[[vk::constant_id(1)]] const float2 vector_ = float2(1, 2);
float4 constant(float4 p : POSITION) : SV_Position { return p * vector_.x; }

// IMAGE: error: `vk::image_format` takes a format of uints, such as "r32ui" [vulkan-argument]
[[vk::image_format("rgba8")]] RWBuffer<uint> numbers;
float4 image(float4 p : POSITION) : SV_Position { return p * numbers[3]; }

// MISPLACED: warning: attribute `vk::location` has no effect on a variable [-Wattribute-misplaced]
// MISPLACED: warning: attribute `vk::push_constant` has no effect on a field [-Wattribute-misplaced]
// MISPLACED: warning: attribute `vk::binding` has no effect on a statement [-Wattribute-misplaced]
[[vk::location(1)]] float4 placed;
struct Field { [[vk::push_constant]] float4 a; };
float4 misplaced(float4 p : POSITION) : SV_Position {
  [[vk::binding(1)]] p += placed;
  return p;
}

// HIGH: error: location 4095 of `a[1]` is too high; the highest is 4094 [location-too-high]
float4 high([[vk::location(4093)]] float4x2 a[2] : A) : SV_Position { return a[0][0].xyxy + a[1][1].xyxy; }

// FAR: error: `space` becomes binding 3 of set 900; the highest binding is 65534 and the highest set 62 [target-binding-too-high]
[[vk::binding(3, 900)]] cbuffer space : register(b3) { float4 in_space; };
// RUN: not %clipc -T vs_5_1 -E ruled %s --target=vulkan --bindings=dxc 2>&1 | FileCheck %s --check-prefix=RULED
// RULED: error: `other` becomes binding 4 of set 901; the highest binding is 65534 and the highest set 62 [target-binding-too-high]
cbuffer other : register(b4, space901) { float4 in_other; };
float4 ruled(float4 p : POSITION) : SV_Position { return p * in_other; }
float4 far(float4 p : POSITION) : SV_Position { return p * in_space; }

// SAME: error: `first` and `second` both have the `vk::constant_id` 3 [target-constant-id-twice]
// SAME: note: `first` is declared here
[[vk::constant_id(3)]] const float first = 1;
[[vk::constant_id(3)]] const float second = 2;
float4 same(float4 p : POSITION) : SV_Position { return p * first * second; }

// UNITS: warning: `above` is not bound at 120, as its `vk::binding` says; target `glsl450` has 80 texture units for certain; `--reflect` tells the binding [-Wtarget-texture-unit]
// UNITS: layout(binding = 0) uniform sampler2D high_register;
// UNITS: layout(binding = 1) uniform sampler2D above;
Texture2D high_register : register(t100);
[[vk::binding(120)]] Texture2D above;
SamplerState point_sampler : register(s0);
float4 units(float4 p : POSITION) : SV_Position {
  return high_register.SampleLevel(point_sampler, p.xy, 0) + above.SampleLevel(point_sampler, p.xy, 0);
}
