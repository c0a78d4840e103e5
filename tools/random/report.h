// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "tools/random/judge.h"
#include "tools/random/program.h"

namespace clipc::random {

// Writes a failing program to FOLDER/<fault>-<name>/: original.hlsl, reduced.hlsl, choices.txt and
// report.txt, which has the command that repeats it. Returns that folder.
std::string WriteFailure(const std::string& folder, const std::string& name,
                         const Program& original, const Program& reduced, const Verdict& verdict,
                         const ChoiceList& choices, const std::string& features);

// The choices in a choices.txt. Throws DrawError.
ChoiceList ReadChoices(const std::string& path);

}  // namespace clipc::random
