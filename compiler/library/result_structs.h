// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include "compiler/clipc.h"
#include "compiler/compile/facts.h"
#include "compiler/compile/message.h"

// What a result of the C interface says, as the structs of compiler/clipc.h.
namespace clipc {

// The messages, each before its notes. Refers to texts of `messages`.
std::vector<clipc_diagnostic> ToDiagnostics(const std::vector<Message>& messages);

// The structs of a reflection, which refer to each other and to the texts of the facts.
class ReflectionStructs {
 public:
  explicit ReflectionStructs(const Facts& facts);
  ReflectionStructs(const ReflectionStructs&) = delete;
  ReflectionStructs& operator=(const ReflectionStructs&) = delete;

  // Of a stage of the facts.
  const clipc_reflection& shader(std::size_t number) const { return shaders_[number]; }

 private:
  class Printer;

  // A deque keeps its elements where they are.
  std::deque<clipc_variable> variables_;
  std::deque<clipc_member> members_;
  std::deque<clipc_buffer> buffers_;
  std::deque<clipc_resource> resources_;
  std::deque<clipc_reflection> shaders_;
  std::deque<std::vector<const clipc_variable*>> variable_lists_;
  std::deque<std::vector<const clipc_member*>> member_lists_;
  std::deque<std::vector<const clipc_buffer*>> buffer_lists_;
  std::deque<std::vector<const clipc_resource*>> resource_lists_;
};

}  // namespace clipc
