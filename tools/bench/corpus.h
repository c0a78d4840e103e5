// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

namespace clipc::bench {

// Compiles every shader of a list on two threads, with clipc and then with glslang and SPIRV-Cross,
// and prints files a second, the ratio and the ten that took clipc longest. The list has a line per
// shader, separated by tabs: path, entry, profile, include folders (a;b), defines (A=1;B).
void BenchCorpus(const std::string& list);

}  // namespace clipc::bench
