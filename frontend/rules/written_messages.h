// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>

#include "frontend/rules/names.h"
#include "frontend/rules/written.h"

// The messages about what a shader does not write.
namespace clipc::rules {

// Reports a read of a local variable that nothing has written.
void ReportRead(Span read, const Var& var, Diagnostics& diagnostics);
// Reports a read of a local variable that some path to it has not written.
void ReportPartlyRead(Span read, const Var& var, Diagnostics& diagnostics);
// Reports an out parameter that some path through its function does not write.
void ReportPartly(const Var& parameter, Diagnostics& diagnostics);
// Reports an out parameter that is not written, or not completely if `is_any` part of it is.
void ReportParameter(const Program& program, const Var& parameter, bool is_any,
                     Diagnostics& diagnostics);
// An output, or the element of an array of distances or factors.
struct OutputPart {
  const IoVar& output;
  std::optional<std::int64_t> element;
};
// What is written of a part, and the components that it has.
struct PartlyWritten {
  WrittenComponents written;
  std::uint16_t mask;
};
// Reports an output whose components in `mask` are not written on every path.
void ReportOutput(const Program& program, const OutputPart& part, const PartlyWritten& known,
                  Diagnostics& diagnostics);

}  // namespace clipc::rules
