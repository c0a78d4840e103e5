// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// What the pixel shaders of this folder share. Each reads a part of it; clipc writes that part alone.
#ifndef LIGHTING_HLSLI
#define LIGHTING_HLSLI

static const float kPi = 3.14159265;

struct Light {
  float3 position;
  float range;
  float3 colour;
  float cone;
  float3 direction;
  uint kind;
};

struct Surface {
  float3 albedo;
  float roughness;
  float3 normal;
  float metalness;
  float3 position;
  float occlusion;
};

#define LIGHT_POINT 0
#define LIGHT_SPOT 1
#define LIGHT_DIRECTIONAL 2

float Square(float x) { return x * x; }
float3 Square(float3 x) { return x * x; }
float Luminance(float3 colour) { return dot(colour, float3(0.2126, 0.7152, 0.0722)); }

float3 ToLinear(float3 srgb) {
  return srgb <= 0.04045 ? srgb / 12.92 : pow((abs(srgb) + 0.055) / 1.055, 2.4);
}

float3 ToSrgb(float3 colour) {
  return colour <= 0.0031308 ? colour * 12.92 : 1.055 * pow(abs(colour), 1 / 2.4) - 0.055;
}

float DistributionGgx(float n_dot_h, float roughness) {
  float a = Square(roughness);
  float d = Square(n_dot_h) * (Square(a) - 1) + 1;
  return Square(a) / max(kPi * Square(d), 1e-6);
}

float VisibilitySmith(float n_dot_l, float n_dot_v, float roughness) {
  float a = Square(roughness);
  float l = n_dot_v * (n_dot_l * (1 - a) + a);
  float v = n_dot_l * (n_dot_v * (1 - a) + a);
  return 0.5 / max(l + v, 1e-5);
}

float3 FresnelSchlick(float3 f0, float v_dot_h) { return f0 + (1 - f0) * pow(1 - v_dot_h, 5); }

float Attenuation(Light light, float3 to_light) {
  float distance2 = dot(to_light, to_light);
  float window = saturate(1 - Square(distance2 / Square(light.range)));
  float attenuation = Square(window) / max(distance2, 1e-4);
  if (light.kind == LIGHT_SPOT) {
    float angle = dot(normalize(-to_light), light.direction);
    attenuation *= smoothstep(light.cone, lerp(light.cone, 1, 0.25), angle);
  }
  return attenuation;
}

float3 Shade(Surface surface, Light light, float3 view) {
  float3 to_light = light.position - surface.position;
  float attenuation = 1;
  if (light.kind == LIGHT_DIRECTIONAL) {
    to_light = -light.direction;
  } else {
    attenuation = Attenuation(light, to_light);
  }
  float3 l = normalize(to_light);
  float3 h = normalize(l + view);
  float n_dot_l = saturate(dot(surface.normal, l));
  float n_dot_v = abs(dot(surface.normal, view)) + 1e-5;
  float n_dot_h = saturate(dot(surface.normal, h));
  float3 f0 = lerp(0.04, surface.albedo, surface.metalness);
  float3 fresnel = FresnelSchlick(f0, saturate(dot(view, h)));
  float3 specular = fresnel * DistributionGgx(n_dot_h, surface.roughness) *
                    VisibilitySmith(n_dot_l, n_dot_v, surface.roughness);
  float3 diffuse = (1 - fresnel) * (1 - surface.metalness) * surface.albedo / kPi;
  return (diffuse + specular) * light.colour * (attenuation * n_dot_l);
}

// Light from all around, of nine coefficients of spherical harmonics.
float3 Ambient(float4 coefficients[9], float3 n) {
  float3 light = coefficients[0].rgb;
  light += coefficients[1].rgb * n.y + coefficients[2].rgb * n.z + coefficients[3].rgb * n.x;
  light += coefficients[4].rgb * (n.x * n.y) + coefficients[5].rgb * (n.y * n.z);
  light += coefficients[6].rgb * (3 * n.z * n.z - 1) + coefficients[7].rgb * (n.x * n.z);
  return max(light + coefficients[8].rgb * (n.x * n.x - n.y * n.y), 0);
}

float2 EncodeNormal(float3 n) {
  n /= abs(n.x) + abs(n.y) + abs(n.z);
  float2 folded = (1 - abs(n.yx)) * (n.xy >= 0 ? 1.0 : -1.0);
  return (n.z >= 0 ? n.xy : folded) * 0.5 + 0.5;
}

float3 DecodeNormal(float2 encoded) {
  float2 f = encoded * 2 - 1;
  float3 n = float3(f, 1 - abs(f.x) - abs(f.y));
  float t = saturate(-n.z);
  n.xy += n.xy >= 0 ? -t : t;
  return normalize(n);
}

float3 BlinnPhong(float3 normal, float3 to_light, float3 view, float3 colour, float power) {
  float3 h = normalize(to_light + view);
  float diffuse = saturate(dot(normal, to_light));
  float specular = pow(saturate(dot(normal, h)), power);
  return colour * diffuse + specular * (diffuse > 0);
}

float3 Fog(float3 colour, float3 fog, float distance, float density) {
  return lerp(fog, colour, saturate(exp2(-distance * density)));
}

#endif
