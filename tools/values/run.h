// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/values/script.h"

// Runs a shader_test file and says for each value in it whether clipc's shaders give it.
namespace clipc::values {

enum class Verdict {
  kEqual,
  kDifferent,
  kRefused,    // by clipc or by OpenGL, though Microsoft's compiler accepts the shader
  kNotDrawn,   // this tool does not do what the test needs
  kNotOffered  // Microsoft's compiler refuses the shader at this model, so that there is no value
};
struct Probe {
  Verdict verdict = Verdict::kEqual;
  int line = 0;
  std::string why;
};
// A shader whose acceptance the file says.
struct Acceptance {
  int line = 0;
  Model model = 0;
  bool is_expected = true, is_accepted = true;
  std::string why;  // clipc's messages
};
// Called as soon as each is known, since a driver may end the process at the next shader.
struct Listener {
  std::function<void(const Probe&)> on_probe;
  std::function<void(const Acceptance&)> on_shader;
};

// Runs the text of a file at the models of `family`. An OpenGL context must be current.
void RunFile(const std::string& text, const Family& family, const Listener& listener);

struct FileResult {
  std::vector<Probe> probes;
  std::vector<Acceptance> shaders;
};

// The same in a process and with an OpenGL context of its own. Where that process dies, the last
// probe says so.
FileResult RunIsolated(const std::string& text, const Family& family);

}  // namespace clipc::values
