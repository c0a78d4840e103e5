// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The compiler as a library: the variants of a compile, the key of a cache, and preprocessed text.
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include <clipc/clipc.hpp>

namespace {

int Fail(const char* what) {
  std::printf("%s\n", what);
  return 1;
}

bool Has(std::string_view text, std::string_view words) {
  return text.find(words) != std::string_view::npos;
}

}  // namespace

int main() {
  clipc::library::Compiler compiler;
  clipc::library::Request request;
  request.path = "water.hlsl";
  request.text =
      "#include \"planes.hlsli\"\n"
      "[clipplanes(water)] float4 main(float4 p : POSITION) : SV_Position { return p + SHIFT; }";
  request.read_include = [](const std::string&) {
    return "cbuffer Clip { float4 water; };\n#define SHIFT 0\n";
  };
  request.options = {"--variants"};
  const clipc::library::Result result = compiler.Compile(request);
  const auto without = result.GetVariant(0, CLIPC_PART_GLSL);
  const auto with = result.GetVariant(1, CLIPC_PART_GLSL);
  if (!without || Has(*without, "gl_ClipDistance") || !with || !Has(*with, "gl_ClipDistance"))
    return Fail("other variants");
  if (result.GetVariant(2, CLIPC_PART_GLSL)) return Fail("a variant too many");

  std::vector<std::string> keys;
  request.options.clear();
  request.is_known = [&](const std::string& key) {
    keys.push_back(key);
    return keys.size() > 1;
  };
  if (!compiler.Compile(request).ok()) return Fail("not compiled");
  if (compiler.Compile(request).status() != CLIPC_KNOWN) return Fail("not known");
  if (keys.size() != 2 || keys[0] != keys[1]) return Fail("another key");

  request.options = {"-P"};
  const clipc::library::Result text = compiler.Compile(request);
  if (!Has(text.Get(CLIPC_PART_PREPROCESSED), "p + 0")) return Fail("another text");
  std::printf("the library: passed\n");
  return 0;
}
