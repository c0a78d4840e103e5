// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Reads any text as an effect: no crash, no hang, and JSON of whatever is read. The first shaders
// of its passes are compiled, with their arguments: either there is an error, or GLSL.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "compiler/compile/compile.h"
#include "compiler/effect/effect.h"
#include "compiler/effect/effect_json.h"
#include "compiler/effect/gl_effect.h"
#include "compiler/effect/gl_effect_header.h"
#include "compiler/effect/make_effect_facts.h"

namespace {

constexpr std::size_t kMostPrograms = 4;

// Compiles each shader of a program alone, as an entry of the text.
void Compile(clipc::Compiler& compiler, clipc::ProgramRequest request, const std::string& text) {
  request.debug.verify = true;
  request.outputs.facts = true;
  for (const clipc::ShaderSource& shader : std::exchange(request.shaders, {})) {
    request.shaders = {shader};
    request.first().path = "fuzz.fx";
    request.first().text = text;
    const clipc::CompileResult result = compiler.Compile(request);
    if (result.ok() != result.outputs.has_value()) std::abort();
    if (!result.ok() && result.messages.empty()) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static clipc::Compiler compiler;
  const std::string text(reinterpret_cast<const char*>(data), size);
  clipc::CommandLine command;
  command.inputs = {"fuzz.fx"};
  command.request.first().text = text;
  const clipc::LoadedEffect loaded = clipc::LoadEffect(command);
  if (!loaded.is_read) {
    if (loaded.messages.messages.empty()) std::abort();
    return 0;
  }
  const std::vector<clipc::ShaderGroup>& groups = loaded.programs.groups;
  clipc::EffectFacts facts = clipc::MakeEffectFacts(
      loaded.effect, loaded.programs, loaded.command, std::vector<clipc::BatchEntry>(groups.size()),
      std::vector<std::shared_ptr<const clipc::EffectCode>>(groups.size()));
  for (const bool is_for_vulkan : {false, true}) {
    facts.is_for_vulkan = is_for_vulkan;
    if (clipc::EffectJson(facts).empty()) std::abort();
  }
  clipc::Diagnostics diagnostics;
  if (clipc::GlEffectHeader(clipc::MakeGlEffect(facts, false, diagnostics), "fuzz").empty())
    std::abort();
  for (std::size_t i = 0; i < std::min(groups.size(), kMostPrograms); ++i)
    Compile(compiler, groups[i].command.request, text);
  return 0;
}
