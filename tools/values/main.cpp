// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tools/harness/options.h"
#include "tools/values/run.h"

namespace clipc::values {
namespace {

constexpr char kUsage[] =
    R"(clipc-values PATH... [--list]
  Runs vkd3d's shader_test files, or those of a folder, at shader models 2.0, 4.0 and 6.0 or the
  nearest ones that a test allows: compiles their shaders by clipc, draws or dispatches on Mesa's
  software OpenGL, and compares with the values in the files.
    --list   prints each value that differs or was not drawn, and each shader that clipc and the
             file do not both accept or refuse
Exit: 0 if no value differs, 1 if one does, 2 if nothing can be drawn.
)";

std::vector<std::string> FilesOf(const std::vector<std::string>& paths) {
  std::vector<std::string> files;
  for (const std::string& path : paths) {
    if (!std::filesystem::is_directory(path)) {
      files.push_back(path);
      continue;
    }
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path)) {
      if (entry.path().extension() == ".shader_test") files.push_back(entry.path().string());
    }
  }
  std::ranges::sort(files);
  return files;
}

struct Counts {
  std::map<Verdict, int> probes;
  int files = 0;
  std::map<std::pair<bool, bool>, int> shaders;  // by what the file expects, and by what clipc does
};

void Report(const Counts& counts, const Family& family) {
  const auto of = [&](Verdict verdict) {
    const auto found = counts.probes.find(verdict);
    return found == counts.probes.end() ? 0 : found->second;
  };
  const auto both = [&](bool expected, bool accepted) {
    const auto found = counts.shaders.find({expected, accepted});
    return found == counts.shaders.end() ? 0 : found->second;
  };
  std::printf("%-5s %6d %6d %9d %8d %9d %11d | %8d %8d %8d %8d\n", std::string(family.name).c_str(),
              counts.files, of(Verdict::kEqual), of(Verdict::kDifferent), of(Verdict::kRefused),
              of(Verdict::kNotDrawn), of(Verdict::kNotOffered), both(true, true),
              both(false, false), both(true, false), both(false, true));
}

int Main(int argc, char** argv) {
  bool lists = false;
  const std::vector<std::string> arguments(argv, argv + argc);
  const std::vector<std::string> files =
      FilesOf(harness::options::Parse(arguments, {{"list", harness::options::On(lists)}}));
  if (files.empty()) {
    std::fputs(kUsage, stderr);
    return 2;
  }
  std::map<std::string_view, Counts> counts;
  for (const std::string& path : files) {
    const std::string text = harness::ReadFile(path);
    const std::string name = std::filesystem::path(path).filename().string();
    for (const Family& family : kFamilies) {
      const FileResult result = RunIsolated(text, family);
      Counts& sum = counts[family.name];
      sum.files += result.probes.empty() && result.shaders.empty() ? 0 : 1;
      constexpr const char* kWords[] = {"equal", "different", "refused", "not-drawn",
                                        "not-offered"};
      for (const Probe& probe : result.probes) {
        ++sum.probes[probe.verdict];
        if (!lists || probe.verdict == Verdict::kEqual || probe.verdict == Verdict::kNotOffered)
          continue;
        std::printf("%s:%d %s %s: %s\n", name.c_str(), probe.line, std::string(family.name).c_str(),
                    kWords[static_cast<int>(probe.verdict)], probe.why.c_str());
      }
      for (const Acceptance& shader : result.shaders) {
        ++sum.shaders[{shader.is_expected, shader.is_accepted}];
        if (!lists || shader.is_expected == shader.is_accepted) continue;
        std::printf(
            "%s:%d %s %s %s\n", name.c_str(), shader.line,
            std::string(kModels[shader.model]).c_str(),
            shader.is_accepted ? "only clipc accepts" : "only clipc refuses:", shader.why.c_str());
      }
    }
    std::fflush(stdout);
  }
  std::printf("%-5s %6s %6s %9s %8s %9s %11s | %8s %8s %8s %8s\n", "model", "files", "equal",
              "different", "refused", "not drawn", "not offered", "accepted", "refused", "refuses",
              "accepts");
  int different = 0;
  for (const Family& family : kFamilies) {
    Report(counts[family.name], family);
    different += counts[family.name].probes[Verdict::kDifferent];
  }
  return different == 0 ? 0 : 1;
}

}  // namespace
}  // namespace clipc::values

int main(int argc, char** argv) {
  try {
    return clipc::values::Main(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "clipc-values: %s\n", error.what());
    return 2;
  }
}
