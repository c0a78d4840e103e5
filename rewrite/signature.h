// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "frontend/check/entry_point.h"

namespace clipc::rewrite {

// The signature of a wrapper: that of its entry function and more parameters. The wrapper calls the
// entry function with its own parameters, and returns what that returns.
class Signature {
 public:
  explicit Signature(const EntryPoint& entry);

  // The result becomes an out parameter, which follows those of the entry function.
  void ReturnByParameter();
  // Adds a parameter after all others but those with a default value, which none without one may
  // follow (fxc X3044).
  void Add(std::string parameter) { added_.push_back(std::move(parameter)); }

  const EntryPoint& entry() const { return entry_; }
  // The value, or the part of it, in the wrapper after the call; of an input also before it.
  std::string ValueOf(const EntryAccess& access) const;
  // The function `name` with the lines `before` and `after` the call of `inner`.
  std::string Write(const std::string& name, const std::string& inner, const std::string& before,
                    const std::string& after) const;

 private:
  bool returns() const { return has_result_ && !by_parameter_; }
  std::string NameOf(std::size_t parameter) const;
  std::string Call(const std::string& inner) const;

  const EntryPoint& entry_;
  bool has_result_;
  bool by_parameter_ = false;
  std::string result_;
  std::vector<std::string> names_;  // of the entry function's parameters
  std::vector<std::string> added_;
};

}  // namespace clipc::rewrite
