// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Gives any options and any text to the C interface: no crash, no hang, and every part is there or
// empty as the status says. The lines of an input up to an empty one are options, or the name of
// the text after `path=`; the rest is the shader, which every include gives once more. Options that
// name files to read are left out.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/clipc_effect.h"

namespace {

struct Input {
  std::string path = "fuzz.hlsl";
  std::vector<std::string> options;
  std::string_view text;
  int calls = 0;
};

bool NamesFile(std::string_view option) {
  return option.starts_with('@') || option.find("pixel") != std::string_view::npos ||
         option.find("fragment") != std::string_view::npos ||
         option.find("sandbox") != std::string_view::npos;
}

Input Read(std::string_view bytes) {
  Input input;
  while (!bytes.empty() && bytes[0] != '\n') {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    const std::string_view line = bytes.substr(0, end);
    if (line.starts_with("path="))
      input.path = line.substr(5);
    else if (!NamesFile(line) && line.find('\0') == std::string_view::npos)
      input.options.emplace_back(line);
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
  }
  input.text = bytes;
  return input;
}

int ReadInclude(void* context, const char*, clipc_bytes* text) {
  const auto& input = *static_cast<const Input*>(context);
  *text = {input.text.data(), input.text.size()};
  return 1;
}

int IsCancelled(void* context) { return ++static_cast<Input*>(context)->calls > 1000 ? 1 : 0; }

// Reads what an effect leads to: each text is there, and each choice is of a program.
std::size_t Read(const clipc_effect& effect) {
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < effect.technique_count; ++i) {
    const clipc_effect_technique& technique = *effect.techniques[i];
    bytes += std::strlen(technique.name) + std::strlen(technique.kind);
    for (std::size_t k = 0; k < technique.pass_count; ++k) {
      const clipc_effect_pass& pass = *technique.passes[k];
      for (std::size_t n = 0; n < pass.state_count; ++n)
        bytes += std::strlen(pass.states[n]->name) + std::strlen(pass.states[n]->value);
      for (std::size_t n = 0; n < pass.program_count; ++n) {
        const clipc_result* const program = pass.programs[n]->result;
        if (program) bytes += clipc_result_get(program, CLIPC_PART_REFLECTION).size;
        if (pass.programs[n]->shader_count == 0) std::abort();
      }
      for (std::size_t n = 0; n < pass.choice_count; ++n) {
        const clipc_effect_choice& choice = *pass.choices[n];
        for (std::size_t m = 0; m < choice.program_count; ++m) {
          if (choice.programs[m] >= static_cast<int>(pass.program_count)) std::abort();
        }
      }
    }
  }
  for (std::size_t i = 0; i < effect.parameter_count; ++i)
    bytes += std::strlen(effect.parameters[i]->type) + effect.parameters[i]->bytes.size;
  return bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static clipc_compiler* const compiler = clipc_compiler_create();
  Input input = Read({reinterpret_cast<const char*>(data), size});
  std::vector<const char*> options = {"--max-seconds=5", "--max-bytes=1000000",
                                      "--max-tokens=100000"};
  for (const std::string& option : input.options) options.push_back(option.c_str());
  clipc_request request{};
  request.size = sizeof request;
  request.path = input.path.c_str();
  request.text = input.text.data() ? input.text.data() : "";
  request.text_size = input.text.size();
  request.options = options.data();
  request.option_count = options.size();
  request.read_include = ReadInclude;
  request.read_include_context = &input;
  request.is_cancelled = IsCancelled;
  request.is_cancelled_context = &input;
  clipc_result* result = nullptr;
  const clipc_status status = clipc_compile(compiler, &request, &result);
  if (!result) std::abort();
  for (int part = 0; part <= CLIPC_PART_HLSL; ++part) {
    const clipc_bytes bytes = clipc_result_get(result, static_cast<clipc_part>(part));
    if (!bytes.data || bytes.data[bytes.size] != '\0') std::abort();
    const bool is_output = part >= CLIPC_PART_GLSL;
    if (status != CLIPC_COMPILED && is_output && bytes.size != 0) std::abort();
  }
  if (status != CLIPC_COMPILED && clipc_result_get(result, CLIPC_PART_MESSAGES).size == 0 &&
      clipc_result_get(result, CLIPC_PART_MESSAGES_JSON).size == 0)
    std::abort();
  std::size_t shaders = 0;
  while (const clipc_shader* const shader = clipc_result_shader(result, shaders)) {
    if (!shader->text.data || shader->text.data[shader->text.size] != '\0') std::abort();
    ++shaders;
  }
  if (status != CLIPC_COMPILED && shaders > 0) std::abort();
  const clipc_effect* const effect = clipc_result_effect(result);
  if (effect && Read(*effect) > size * 1000 + 1000000) std::abort();
  clipc_result_free(result);
  return 0;
}
