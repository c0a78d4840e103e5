// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/random/report.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tools/harness/options.h"

namespace clipc::random {
namespace {

std::string CommandOf(const Program& program, const Verdict& verdict) {
  const std::string target = verdict.target.empty() ? "all" : verdict.target;
  return "clipc-draw compare reduced.hlsl " + program.Options() + " --target " + target;
}

}  // namespace

std::string WriteFailure(const std::string& folder, const std::string& name,
                         const Program& original, const Program& reduced, const Verdict& verdict,
                         const ChoiceList& choices, const std::string& features) {
  const std::filesystem::path path =
      std::filesystem::path(folder) / (std::string(NameOf(verdict.fault)) + "-" + name);
  std::filesystem::create_directories(path);
  std::ofstream(path / "original.hlsl") << original.text;
  std::ofstream(path / "reduced.hlsl") << reduced.text;
  std::ofstream list(path / "choices.txt");
  for (const std::uint32_t choice : choices) list << choice << "\n";
  std::ofstream report(path / "report.txt");
  report << NameOf(verdict.fault) << " " << verdict.target << "\n\n  "
         << CommandOf(reduced, verdict) << "\n  clipc-random --repeat choices.txt" << features
         << "\n\n"
         << verdict.what << "\n";
  return path.string();
}

ChoiceList ReadChoices(const std::string& path) {
  std::istringstream text(harness::ReadFile(path));
  ChoiceList choices;
  for (std::uint32_t choice = 0; text >> choice;) choices.push_back(choice);
  return choices;
}

}  // namespace clipc::random
