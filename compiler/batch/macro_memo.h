// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace clipc {

// A memory that finds, among permutations of the same macros for the same shader, those that cannot
// differ in their result: a compile that asked only for the macros A and B is right for every
// permutation that has the same A and B.
class MacroMemo {
 public:
  // The names of the macros, "A", or for one that takes arguments "A(x)", which always counts as
  // asked for. All permutations define the same of them.
  explicit MacroMemo(std::vector<std::string> names) : names_(std::move(names)) {}

  // Returns a job that has the same values of all macros that it asked for; none if there is no
  // such job. `values` has a value for each name.
  std::optional<std::size_t> Find(const std::vector<std::string_view>& values) const;
  // Remembers that `job` was compiled with these values and asked for `used`, which is sorted.
  void Add(const std::vector<std::string_view>& values, const std::vector<std::string>& used,
           std::size_t job);

 private:
  // The jobs that asked for the same macros.
  struct Question {
    std::vector<std::size_t> asked;                     // indices of names
    std::unordered_map<std::string, std::size_t> jobs;  // by the values of `asked`
  };
  static constexpr std::size_t kMaxQuestions = 256;

  std::vector<std::string> names_;
  std::vector<Question> questions_;
};

}  // namespace clipc
