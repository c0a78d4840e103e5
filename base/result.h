// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <string>
#include <utility>

namespace clipc {

// What keeps a call from doing its work, in words for the user: "cannot write `a.vert`: no space".
struct Problem {
  std::string text;
};

// The value of a call, or the problem that keeps it from having one, as std::expected of C++23.
// The shader's own errors are diagnostics instead (base/diagnostics.h).
template <typename Value = void>
class [[nodiscard]] Result {
 public:
  Result(Value value) : value_(std::move(value)) {}
  Result(Problem problem) : problem_(std::move(problem.text)) {}

  explicit operator bool() const { return value_.has_value(); }
  // The value; undefined where there is a problem.
  Value& operator*() { return *value_; }
  const Value& operator*() const { return *value_; }
  Value* operator->() { return &*value_; }
  const Value* operator->() const { return &*value_; }
  // Empty where there is a value.
  const std::string& problem() const { return problem_; }

 private:
  std::optional<Value> value_;
  std::string problem_;
};

// Whether a call did its work, and what kept it from that.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Problem problem) : problem_(std::move(problem.text)) {}

  explicit operator bool() const { return !problem_.has_value(); }
  // Only where there is a problem.
  const std::string& problem() const { return *problem_; }

 private:
  std::optional<std::string> problem_;
};

}  // namespace clipc
