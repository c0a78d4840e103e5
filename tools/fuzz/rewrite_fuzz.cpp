// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Writes any text as HLSL with clip distances: no crash, no hang, and HLSL exactly when there is no
// error. What is written has no clip planes any more, so a second call leaves it as it is. The
// first line of an input may be `//LOWERING SPACE DISTANCES LINES`, up to four digits; a digit that
// is missing is 0. The entries are `main` and `second`, and `pixel` is what discards; the includes
// are empty.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "compiler/compile/compile.h"

namespace {

// The digit at `position` of the first line.
std::size_t Digit(std::string_view text, std::size_t position) {
  const bool has = text.size() > position && text.starts_with("//");
  const int digit = has ? text[position] - '0' : 0;
  return digit >= 0 && digit <= 9 ? static_cast<std::size_t>(digit) : 0;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr clipc::Lowering kLowerings[] = {clipc::Lowering::kClipDistance,
                                            clipc::Lowering::kNearPlane, clipc::Lowering::kNone,
                                            clipc::Lowering::kDiscard};
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  clipc::ProgramRequest request;
  request.first().path = "fuzz.hlsl";
  request.first().text = std::string(text);
  request.includes.read = [](const std::string&) { return std::string(); };
  request.planes.lowering = kLowerings[Digit(text, 2) % std::size(kLowerings)];
  request.planes.space =
      static_cast<clipc::PlaneSpace>(Digit(text, 3) % std::size(clipc::kPlaneSpaceNames));
  request.hlsl.wanted = true;
  request.hlsl.entries = {"main", "second"};
  if (request.planes.lowering == clipc::Lowering::kDiscard) {
    request.shaders.push_back({.entry = "pixel", .profile = "ps_5_0"});
    request.hlsl.in_one_file = true;
  }
  request.hlsl.plane_distances = static_cast<std::uint32_t>(Digit(text, 4) % 9);
  request.outputs.source_lines = Digit(text, 5) % 2 == 1;
  const clipc::CompileResult result = clipc::Compile(request);
  if (result.ok() != result.outputs.has_value()) std::abort();
  if (!result.ok()) {
    if (result.messages.empty()) std::abort();
    return 0;
  }
  request.first().text = result.outputs->shaders[0].text;
  const clipc::CompileResult again = clipc::Compile(request);
  if (!again.ok() || again.outputs->shaders != result.outputs->shaders) std::abort();
  return 0;
}
