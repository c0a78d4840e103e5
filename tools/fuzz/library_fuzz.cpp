// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Gives any options and any text to the C interface: no crash, no hang, and every part is there or
// empty as the status says. The lines of an input up to an empty one are options, or the name of
// the text after `path=`; the rest is the shader, which every include gives once more. Options that
// name files to read are left out.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/clipc.h"

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
  clipc_result_free(result);
  return 0;
}
