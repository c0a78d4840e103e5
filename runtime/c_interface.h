// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <initializer_list>

#include "clipc_runtime.h"
#include "status.h"
#include "table.h"

// The declarations that the source files of the C interface share. Not installed.

// NOLINTNEXTLINE(readability-identifier-naming): a name of the C interface.
struct clipc_table {
  clipc::runtime::Table table;
};

namespace clipc::runtime {

// The error of the status as C has it. Copies the message of the status to `message`, which may be
// null.
clipc_error Report(const Status& status, char* message) noexcept;

// Whether one of the arguments is a null pointer, which is then reported.
bool IsMissing(std::initializer_list<const void*> arguments, char* message) noexcept;

}  // namespace clipc::runtime
