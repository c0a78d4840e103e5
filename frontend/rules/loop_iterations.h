// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>

#include "frontend/rules/names.h"

// The number of iterations of a loop, as far as its own text gives it.
namespace clipc::rules {

// Whether the loop ends within `limit` iterations. Returns nullopt for loops of another form than
// `for (int i = 0; i < 4; ++i)` with constants, for loops whose body changes the counter, and for
// longer loops whose body may end them.
std::optional<bool> EndsWithin(const Program& program, const For& loop, std::int64_t limit);

// Whether the head of the loop says that its condition is always true: its counter is a uint, which
// is never below 0, or is changed nowhere.
bool NeverLeaves(const Program& program, const For& loop);

// Whether the numbers in the head of the loop say that it has at most one iteration.
bool RunsAtMostOnce(const Program& program, const For& loop);

}  // namespace clipc::rules
