// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/clipc_effect.h"

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

constexpr std::string_view kEffect = R"(float4x4 World <string UIName = "world";>;
float4 Tint : COLOR = {1, 0, 0.5, 1};
texture Map;
sampler Maps = sampler_state { Texture = <Map>; MinFilter = Linear; };
int i;
#include "lights.fxh"
VertexShader VS[2] = { compile vs_3_0 Plain(), compile vs_3_0 Lit(2) };
technique Draw <string Script = "x";> {
  pass First { VertexShader = compile vs_3_0 Plain(); PixelShader = compile ps_3_0 Color(); CullMode = None; }
  pass Same { VertexShader = compile vs_3_0 Plain(); PixelShader = compile ps_3_0 Color(); }
  pass Chosen { VertexShader = (VS[i]); }
}
)";
constexpr std::string_view kLights =
    R"(float4 Plain(float4 p : POSITION, inout float2 uv : TEXCOORD0) : POSITION { return mul(p, World); }
float4 Lit(float4 p : POSITION, uniform float scale) : POSITION { return p * scale; }
float4 Color(float2 uv : TEXCOORD0) : COLOR { return tex2D(Maps, uv) * Tint; }
)";

class EffectInterface : public testing::Test {
 protected:
  clipc_status Compile(std::vector<const char*> options, std::string_view text) {
    options.insert(options.begin(), {"--effect", "--target=glsl330"});
    clipc_request request{};
    request.size = sizeof request;
    request.path = "effects/water.fx";
    request.text = text.data();
    request.text_size = text.size();
    request.options = options.data();
    request.option_count = options.size();
    request.read_include_context = &includes_;
    request.read_include = [](void* context, const char* path, clipc_bytes* bytes) {
      const auto& includes = *static_cast<std::map<std::string, std::string>*>(context);
      const auto found = includes.find(path);
      if (found == includes.end()) return 0;
      *bytes = {found->second.data(), found->second.size()};
      return 1;
    };
    if (is_cancelled_) request.is_cancelled = [](void*) { return 1; };
    clipc_result* made = nullptr;
    const clipc_status status = clipc_compile(compiler_.get(), &request, &made);
    result_.reset(made);
    effect_ = made ? clipc_result_effect(made) : nullptr;
    return status;
  }

  std::string_view Get(clipc_part part) const { return PartOf(result_.get(), part); }
  static std::string_view PartOf(const clipc_result* result, clipc_part part) {
    const clipc_bytes bytes = clipc_result_get(result, part);
    return {bytes.data, bytes.size};
  }

  std::map<std::string, std::string> includes_ = {{"effects/lights.fxh", std::string(kLights)}};
  bool is_cancelled_ = false;
  std::unique_ptr<clipc_compiler, decltype(&clipc_compiler_free)> compiler_{clipc_compiler_create(),
                                                                            &clipc_compiler_free};
  std::unique_ptr<clipc_result, decltype(&clipc_result_free)> result_{nullptr, &clipc_result_free};
  const clipc_effect* effect_ = nullptr;
};

TEST_F(EffectInterface, CompilesFromMemory) {
  ASSERT_EQ(Compile({}, kEffect), CLIPC_COMPILED) << Get(CLIPC_PART_MESSAGES);
  EXPECT_EQ(Get(CLIPC_PART_DEPENDENCIES), "effects/lights.fxh\n");
  EXPECT_THAT(Get(CLIPC_PART_GLSL), IsEmpty());
  ASSERT_NE(effect_, nullptr);
  EXPECT_EQ(effect_, clipc_result_effect(result_.get()));
  ASSERT_EQ(effect_->technique_count, 1U);
  const clipc_effect_technique& technique = *effect_->techniques[0];
  EXPECT_STREQ(technique.kind, "technique");
  EXPECT_STREQ(technique.name, "Draw");
  ASSERT_EQ(technique.annotation_count, 1U);
  EXPECT_STREQ(technique.annotations[0]->value, "\"x\"");
  ASSERT_EQ(technique.pass_count, 3U);
}

TEST_F(EffectInterface, GivesThePrograms) {
  ASSERT_EQ(Compile({}, kEffect), CLIPC_COMPILED) << Get(CLIPC_PART_MESSAGES);
  const clipc_effect_pass* const* passes = effect_->techniques[0]->passes;
  ASSERT_EQ(passes[0]->program_count, 1U);
  const clipc_effect_program& first = *passes[0]->programs[0];
  ASSERT_EQ(first.shader_count, 2U);
  EXPECT_STREQ(first.shaders[0]->stage, "vertex");
  EXPECT_STREQ(first.shaders[0]->profile, "vs_3_0");
  EXPECT_STREQ(first.shaders[1]->entry, "Color");
  EXPECT_EQ(first.shaders[1]->element, -1);
  EXPECT_THAT(PartOf(first.result, CLIPC_PART_GLSL), HasSubstr("gl_Position"));
  EXPECT_THAT(PartOf(first.result, CLIPC_PART_PIXEL), HasSubstr("uniform sampler2D Maps"));
  const clipc_reflection* const reflection = clipc_result_reflection(first.result);
  ASSERT_NE(reflection, nullptr);
  ASSERT_NE(reflection->pixel_shader, nullptr);
  EXPECT_EQ(passes[1]->programs[0]->result, first.result);  // they are alike
  EXPECT_EQ(passes[1]->programs[0]->number, first.number);
  ASSERT_EQ(passes[0]->state_count, 1U);
  EXPECT_STREQ(passes[0]->states[0]->name, "CullMode");
  EXPECT_STREQ(passes[0]->states[0]->value, "None");
}

TEST_F(EffectInterface, GivesTheProgramOfEachIndex) {
  ASSERT_EQ(Compile({"--pass=Chosen"}, kEffect), CLIPC_COMPILED) << Get(CLIPC_PART_MESSAGES);
  ASSERT_EQ(effect_->techniques[0]->pass_count, 1U);
  const clipc_effect_pass& pass = *effect_->techniques[0]->passes[0];
  ASSERT_EQ(pass.choice_count, 1U);
  const clipc_effect_choice& choice = *pass.choices[0];
  ASSERT_EQ(choice.value_count, 1U);
  EXPECT_STREQ(choice.values[0]->text, "i");
  EXPECT_EQ(choice.values[0]->count, 2U);
  ASSERT_EQ(choice.program_count, 2U);
  EXPECT_EQ(choice.programs[1], 1);
  EXPECT_STREQ(pass.programs[1]->shaders[0]->call, "Lit(2)");
  EXPECT_EQ(pass.programs[1]->shaders[0]->element, 1);
}

TEST_F(EffectInterface, GivesTheParameters) {
  ASSERT_EQ(Compile({}, kEffect), CLIPC_COMPILED) << Get(CLIPC_PART_MESSAGES);
  std::map<std::string, const clipc_effect_parameter*> parameters;
  for (std::size_t i = 0; i < effect_->parameter_count; ++i)
    parameters.emplace(effect_->parameters[i]->name, effect_->parameters[i]);
  const clipc_effect_parameter* const tint = parameters["Tint"];
  ASSERT_NE(tint, nullptr);
  EXPECT_STREQ(tint->semantic, "COLOR");
  EXPECT_STREQ(tint->value, "{1, 0, 0.5, 1}");
  EXPECT_EQ(tint->bytes.size, 16U);
  EXPECT_EQ(std::string_view(tint->bytes.data + 8, 4), std::string_view("\0\0\0\x3F", 4));
  EXPECT_STREQ(parameters["World"]->annotations[0]->name, "UIName");
  ASSERT_EQ(parameters["Maps"]->state_count, 2U);
  EXPECT_STREQ(parameters["Maps"]->states[1]->value, "Linear");
}

TEST_F(EffectInterface, GivesTheJsonAndTheHeader) {
  ASSERT_EQ(Compile({"-Fh", ".h"}, kEffect), CLIPC_COMPILED) << Get(CLIPC_PART_MESSAGES);
  EXPECT_THAT(Get(CLIPC_PART_EFFECT), HasSubstr("\"number\": 0"));
  EXPECT_THAT(Get(CLIPC_PART_EFFECT), Not(HasSubstr("\"files\"")));
  EXPECT_THAT(Get(CLIPC_PART_EFFECT_HEADER),
              HasSubstr("static const clipc_gl_effect_table water_effect = {"));
  ASSERT_EQ(Compile({}, kEffect), CLIPC_COMPILED);
  EXPECT_THAT(Get(CLIPC_PART_EFFECT_HEADER), IsEmpty());
  EXPECT_EQ(Compile({"-Fh", "water.h"}, kEffect), CLIPC_BAD_REQUEST);
}

TEST_F(EffectInterface, GivesTheProgramsWithoutErrors) {
  includes_["effects/lights.fxh"] += "float4 Wrong() : COLOR { return missing; }\n";
  const std::string text = std::string(kEffect) +
                           "technique T { pass Wrong { PixelShader = compile ps_3_0 Wrong(); }\n"
                           "  pass Out { VertexShader = compile vs_3_0 Absent(); } }\n";
  EXPECT_EQ(Compile({}, text), CLIPC_HAS_ERRORS);
  EXPECT_THAT(Get(CLIPC_PART_MESSAGES), HasSubstr("effects/lights.fxh:4:33: error: `missing`"));
  EXPECT_THAT(Get(CLIPC_PART_MESSAGES), HasSubstr("`Absent` was not found"));
  ASSERT_NE(effect_, nullptr);
  EXPECT_NE(effect_->techniques[0]->passes[0]->programs[0]->result, nullptr);
  EXPECT_EQ(effect_->techniques[1]->passes[0]->programs[0]->result, nullptr);
  EXPECT_EQ(effect_->techniques[1]->passes[1]->is_left_out, 1);
}

TEST_F(EffectInterface, RefusesWhatIsNoEffect) {
  EXPECT_EQ(Compile({}, "float4 x;"), CLIPC_BAD_REQUEST);
  EXPECT_EQ(Get(CLIPC_PART_MESSAGES),
            "clipc: error: `effects/water.fx`: it has no technique; `-T` and `-E` compile one of "
            "its functions\n");
  EXPECT_EQ(effect_, nullptr);
  EXPECT_EQ(Compile({"--technique=Drow"}, kEffect), CLIPC_BAD_REQUEST);
  EXPECT_THAT(Get(CLIPC_PART_MESSAGES), HasSubstr("did you mean `Draw`?"));
  EXPECT_EQ(Compile({"-E", "Plain"}, kEffect), CLIPC_BAD_REQUEST);
  includes_.clear();
  EXPECT_EQ(Compile({}, kEffect), CLIPC_HAS_ERRORS);
  EXPECT_THAT(Get(CLIPC_PART_MESSAGES), HasSubstr("[missing-include, X1507]"));
  EXPECT_EQ(effect_, nullptr);
}

TEST_F(EffectInterface, IsCancelled) {
  is_cancelled_ = true;
  EXPECT_EQ(Compile({}, kEffect), CLIPC_CANCELLED);
}

TEST_F(EffectInterface, GivesTheGeometryShaderOfAPass) {
  ASSERT_EQ(Compile({"--target=glsl330"},
                    "struct V { float4 p : SV_Position; };\n"
                    "V vs(float4 p : POSITION) { V v = {p}; return v; }\n"
                    "[maxvertexcount(1)] void gs(point V v[1], inout PointStream<V> s) {\n"
                    "  s.Append(v[0]); }\n"
                    "float4 ps() : SV_Target { return 0.5; }\n"
                    "technique11 T { pass P { SetVertexShader(CompileShader(vs_5_0, vs()));\n"
                    "  SetGeometryShader(CompileShader(gs_5_0, gs()));\n"
                    "  SetPixelShader(CompileShader(ps_5_0, ps())); } }"),
            CLIPC_COMPILED)
      << Get(CLIPC_PART_MESSAGES);
  const clipc_result* const program = effect_->techniques[0]->passes[0]->programs[0]->result;
  EXPECT_THAT(PartOf(program, CLIPC_PART_PIXEL), HasSubstr("vec4(0.5)"));
  ASSERT_NE(clipc_result_shader(program, 1), nullptr);
  EXPECT_STREQ(clipc_result_shader(program, 1)->stage, "geometry");
  EXPECT_THAT(clipc_result_shader(program, 1)->text.data, HasSubstr("EmitVertex()"));
}

TEST_F(EffectInterface, CompilesAsAProgramWould) {
  ASSERT_EQ(Compile({"-D", "FOG=1", "--reflect=.h"},
                    "float4 V(float4 p : POSITION) : POSITION { return p * FOG; }\n"
                    "technique T { pass P { VertexShader = compile vs_2_0 V(); } }"),
            CLIPC_COMPILED)
      << Get(CLIPC_PART_MESSAGES);
  const clipc_result* const program = effect_->techniques[0]->passes[0]->programs[0]->result;
  EXPECT_THAT(PartOf(program, CLIPC_PART_GLSL), StartsWith("#version 330"));
  EXPECT_THAT(PartOf(program, CLIPC_PART_PIXEL), IsEmpty());
  EXPECT_THAT(PartOf(program, CLIPC_PART_REFLECTION), HasSubstr("\"vs_2_0\""));
}

}  // namespace
