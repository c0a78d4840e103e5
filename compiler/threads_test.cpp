// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Every shader of this repository on eight threads at once. The preset `tsan` runs it under
// ThreadSanitizer. The tests run in the repository's root.
#include <algorithm>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "compiler/compile/compile.h"
#include "compiler/compile/facts_json.h"

namespace clipc {
namespace {

constexpr std::size_t kThreads = 8;

std::vector<std::string> Corpus() {
  std::vector<std::string> paths;
  for (const char* folder : {"examples", "testdata"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension == ".hlsl" || extension == ".fx") paths.push_back(entry.path().string());
    }
  }
  std::ranges::sort(paths);
  return paths;
}

// The outputs and messages of one compile as one text. Every eighth compile calls glslang, whose
// tables the threads share.
std::string Said(Compiler& compiler, const std::string& path, std::size_t number) {
  ProgramRequest request;
  request.first().path = path;
  request.outputs.validate = number % 8 == 0;
  request.target = *glsl::Target::Parse(number % 3 == 0   ? "vulkan"
                                        : number % 3 == 1 ? "essl310"
                                                          : "glsl450");
  if (number % 9 == 0) request.outputs.spirv.emplace();
  request.outputs.facts = true;
  const CompileResult result = compiler.Compile(request);
  if (!result.outputs) return result.text;
  const ShaderOutput& shader = result.outputs->shaders[0];
  return result.text + shader.text + FactsJson(*result.outputs->facts) +
         std::to_string(shader.spirv.size());
}

TEST(Threads, EightCompileTheCorpus) {
  const std::vector<std::string> corpus = Corpus();
  ASSERT_GT(corpus.size(), 200u);
  std::vector<std::vector<std::string>> said(kThreads, std::vector<std::string>(corpus.size()));
  std::vector<std::thread> threads;
  for (std::size_t thread = 0; thread < kThreads; ++thread) {
    threads.emplace_back([&, thread] {
      Compiler compiler;
      // Two threads start at the same shader, the others elsewhere.
      for (std::size_t i = 0; i < corpus.size(); ++i) {
        const std::size_t at = (i + thread / 2 * corpus.size() / 4) % corpus.size();
        said[thread][at] = Said(compiler, corpus[at], at);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < corpus.size(); ++i) {
    for (const auto& other : said) EXPECT_EQ(other[i], said[0][i]) << corpus[i];
  }
}

}  // namespace
}  // namespace clipc
