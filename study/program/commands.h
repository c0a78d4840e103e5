// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

namespace clipc::study {

inline constexpr char kUsage[] =
    R"(clipc-study [--quick] [--out FOLDER] [--no-report]
  Measures every way to clip on Mesa's software OpenGL and writes tables (CSV), images and
  report.html into FOLDER (default: study-report).
    --quick                 takes fewer points, edges and rounds
    --no-report             writes no report, which needs Python

clipc-study scene FILE [--costs speed.csv] [--variants FILE] [--json FILE]
  Prints what a scene needs: for each object whether a plane takes it away, the planes that may cut
  it, the best method with its error, whether that is within the tolerance, and its cost; and the
  shader variants to build. --json writes the same for programs. FILE is JSON or glTF 2.0: see
  docs/scene.md.
Exit: 0 done, 1 the tolerance is not met for some object, 2 failed.
)";

// The commands of clipc-study: arguments[0] is the name of the program or command. They return the
// exit code, and throw DrawError with the reason where they fail.
int RunStudy(const std::vector<std::string>& arguments);
int RunScene(const std::vector<std::string>& arguments);

}  // namespace clipc::study
