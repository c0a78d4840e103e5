// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The functions that the npm package calls: those of compiler/clipc.h with arguments that
// JavaScript can make.
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string_view>
#include <vector>

#include "compiler/clipc.h"
#include "compiler/clipc_effect.h"
#include "web/module/strings.h"

#define CLIPC_EXPORT(name) __attribute__((export_name(#name)))

extern "C" {

// Sets `text` to bytes from clipc_module_allocate, which the module frees. Returns 0 if there is no
// such file.
__attribute__((import_module("clipc"), import_name("read_include"))) int clipc_module_read_include(
    const char* path, clipc_bytes* text);

CLIPC_EXPORT(clipc_module_allocate) void* clipc_module_allocate(std::size_t size) {
  return std::malloc(size);
}
CLIPC_EXPORT(clipc_module_free) void clipc_module_free(void* bytes) { std::free(bytes); }

}  // extern "C"

namespace {

// The bytes of the last include, until they are copied.
std::unique_ptr<const char, decltype([](const char* bytes) {
                  std::free(const_cast<char*>(bytes));  // NOLINT: it was made as char*
                })>
    include_bytes;

int ReadInclude(void*, const char* path, clipc_bytes* text) {
  include_bytes.reset();
  const int found = clipc_module_read_include(path, text);
  if (found) include_bytes.reset(text->data);
  return found;
}

std::unique_ptr<clipc_result, decltype(&clipc_result_free)> last(nullptr, &clipc_result_free);

// The program of this number; null: there is none, or it has errors.
const clipc_result* ProgramOf(const clipc_result& result, std::size_t number) {
  const clipc_effect* const effect = clipc_result_effect(&result);
  for (std::size_t i = 0; effect && i < effect->technique_count; ++i) {
    const clipc_effect_technique& technique = *effect->techniques[i];
    for (std::size_t k = 0; k < technique.pass_count; ++k) {
      const clipc_effect_pass& pass = *technique.passes[k];
      for (std::size_t n = 0; n < pass.program_count; ++n) {
        if (pass.programs[n]->number == number) return pass.programs[n]->result;
      }
    }
  }
  return nullptr;
}

}  // namespace

extern "C" {

// Compiles a shader. `strings` are its name and the options. Returns a clipc_status; the result is
// kept until the next call.
CLIPC_EXPORT(clipc_module_compile)
int clipc_module_compile(const char* strings, std::size_t size, const char* text,
                         std::size_t text_size) {
  static clipc_compiler* const compiler = clipc_compiler_create();
  const std::vector<const char*> words = clipc::StringsIn({strings, size});
  clipc_request request{};
  request.size = sizeof request;
  request.path = words[0];
  request.text = text;
  request.text_size = text_size;
  request.options = words.data() + 1;
  request.option_count = words.size() - 1;
  request.read_include = ReadInclude;
  last.reset();
  clipc_result* result = nullptr;
  const clipc_status status =
      compiler ? clipc_compile(compiler, &request, &result) : CLIPC_NO_MEMORY;
  last.reset(result);
  include_bytes.reset();
  return status;
}

// A part of the last result, which lives as long as that result.
CLIPC_EXPORT(clipc_module_part) const clipc_bytes* clipc_module_part(int part) {
  static clipc_bytes bytes;
  bytes = last ? clipc_result_get(last.get(), static_cast<clipc_part>(part)) : clipc_bytes{"", 0};
  return &bytes;
}

// A part of a program of the last result, which is an effect's; `number` is
// clipc_effect_program::number.
CLIPC_EXPORT(clipc_module_program_part)
const clipc_bytes* clipc_module_program_part(std::size_t number, int part) {
  static clipc_bytes bytes;
  const clipc_result* const program = last ? ProgramOf(*last, number) : nullptr;
  bytes = program ? clipc_result_get(program, static_cast<clipc_part>(part)) : clipc_bytes{"", 0};
  return &bytes;
}

// What shader `index` of the last result, or of its program of that number, is: 0 its stage, 1 its
// text, 2 its SPIR-V. `program` is -1 where the result is not an effect's. Empty past the last.
CLIPC_EXPORT(clipc_module_shader)
const clipc_bytes* clipc_module_shader(int program, std::size_t index, int what) {
  static clipc_bytes bytes;
  const clipc_result* const result = !last ? nullptr
                                     : program < 0
                                         ? last.get()
                                         : ProgramOf(*last, static_cast<std::size_t>(program));
  const clipc_shader* const shader = result ? clipc_result_shader(result, index) : nullptr;
  bytes = !shader     ? clipc_bytes{"", 0}
          : what == 0 ? clipc_bytes{shader->stage, std::strlen(shader->stage)}
          : what == 1 ? shader->text
                      : shader->spirv;
  return &bytes;
}

CLIPC_EXPORT(clipc_module_version) const char* clipc_module_version() { return clipc_version(); }

}  // extern "C"
