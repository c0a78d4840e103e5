// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "base/not_copied.h"
#include "tools/random/program.h"

// The judgement of one program.
namespace clipc::random {

enum class Fault : std::uint8_t {
  kNone,
  kRefused,    // clipc or the evaluator refuses the program
  kLayout,     // a constant lies elsewhere than Direct3D's rules say
  kUndefined,  // the evaluator takes a value for undefined
  kInvalid,    // glslang refuses the GLSL, or spirv-val its SPIR-V
  kWrong,      // a driver's values are not the evaluator's
  kDriver,     // a driver refuses the GLSL
  kCrash,      // the process ended
  kHang,       // the process did not end in time
};
std::string_view NameOf(Fault fault);

struct Verdict {
  Fault fault = Fault::kNone;
  std::string target;  // "glsl330"; empty where the fault is not about a target
  std::string what;    // in words

  // A text that is equal for two verdicts that are likely the same mistake.
  std::string Key() const;
};

struct JudgeOptions {
  std::string scratch;  // a folder to write the program into
  bool draws = true;    // whether programs are drawn; else the GLSL is only validated
  // Called before each step, with its name.
  std::function<void(const std::string& step)> before_step;
};

// Compiles and runs programs in this process, which a wrong program may end.
class Judge : NotCopied {
 public:
  explicit Judge(JudgeOptions options);
  ~Judge();

  // Judges a program. With `only`, looks for a fault like that one and no other.
  Verdict operator()(const Program& program, const std::optional<Verdict>& only = {});

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace clipc::random
