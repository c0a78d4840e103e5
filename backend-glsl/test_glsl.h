// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <string_view>
#include <utility>

#include "backend-glsl/target.h"
#include "backend-glsl/write.h"
#include "base/invariant.h"
#include "ir/program.h"
#include "legalize/legalize.h"

namespace clipc::glsl {

// A shader for tests (legalize/test_shader.h), as the writer takes it.
inline ir::Program LegalizedFor(ir::Program program, const Target& target) {
  program.form = ir::Form::kInlined;
  ir::PassOptions options;
  options.verify = true;
  legalize::Legalize(program, target.Needs(), options);
  return program;
}

// Its GLSL.
inline std::string GlslFor(ir::Program program, const Target& target) {
  return WriteGlsl(LegalizedFor(std::move(program), target), target).glsl;
}

// Returns the output of `glslangValidator options` for the shader, and its exit status in `status`.
inline std::string Glslang(const std::string& glsl, const std::string& options, int& status) {
  const auto folder = std::filesystem::temp_directory_path() /
                      ("clipc_glsl_" + std::to_string(std::random_device{}()));
  std::filesystem::create_directory(folder);
  const auto shader = folder / "shader.vert";
  std::ofstream(shader) << glsl;
  const std::string command = "glslangValidator " + options + " " + shader.string() + " 2>&1";
  std::string output;
  FILE* pipe = popen(command.c_str(), "r");
  CLIPC_CHECK(pipe != nullptr);
  for (char buffer[4096]; std::fgets(buffer, sizeof buffer, pipe);) output += buffer;
  status = pclose(pipe);
  std::filesystem::remove_all(folder);
  return output;
}

}  // namespace clipc::glsl
