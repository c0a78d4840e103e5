// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/written_messages.h"

#include <string>

#include <fmt/format.h>

namespace clipc::rules {
namespace {

const char* HowMuch(bool is_any) {
  return is_any ? "is not written completely" : "is never written";
}

// The path in the signature as the shader's statements may write it, without the function's name;
// the semantic for the result itself.
std::string PathOf(const Program& program, const OutputPart& part) {
  const IoVar& output = part.output;
  if (part.element) return fmt::format("{}[{}]", output.semantic, *part.element);
  const FunctionId writer = output.is_of_patch && clipc::InfoOf(program.stage).makes_patches
                                ? program.tessellation.patch_function
                                : program.entry;
  const std::string& function = program.functions[writer].name;
  if (output.path.empty() || output.path == function) return output.semantic;
  return output.path.starts_with(function + ".") ? output.path.substr(function.size() + 1)
                                                 : output.path;
}

}  // namespace

void ReportRead(Span read, const Var& var, Diagnostics& diagnostics) {
  diagnostics.Report(read, diag::VariableNotWritten, var.name)
      .Note(var.span, diag::DeclaredHere, var.name);
}

void ReportPartlyRead(Span read, const Var& var, Diagnostics& diagnostics) {
  diagnostics.Report(read, diag::VariableNotAlwaysWritten, var.name)
      .Note(var.span, diag::DeclaredHere, var.name);
}

void ReportPartly(const Var& parameter, Diagnostics& diagnostics) {
  diagnostics.Report(parameter.span, diag::OutParameterNotAlwaysWritten, parameter.name);
}

void ReportParameter(const Program& program, const Var& parameter, bool is_any,
                     Diagnostics& diagnostics) {
  if (program.profile.IsAtLeast(6, 0)) {
    diagnostics.Report(parameter.span, diag::OutParameterUndefined, parameter.name,
                       HowMuch(is_any));
  } else {
    diagnostics.Report(parameter.span, diag::OutParameterNotWritten, parameter.name,
                       HowMuch(is_any));
  }
}

void ReportOutput(const Program& program, const OutputPart& part, const PartlyWritten& known,
                  Diagnostics& diagnostics) {
  const auto& [written, mask] = known;
  const IoVar& output = part.output;
  const Span span = program.vars[output.var].span;
  const std::string path = PathOf(program, part);
  // X4580 is of vertex shaders; the position of a stage after that is an output like any other.
  const bool is_position =
      output.builtin == Builtin::kPosition && !clipc::InfoOf(program.stage).has_stage_before;
  const std::string how = HowMuch((written.may & mask) != 0);
  if ((written.may & mask) == mask) {
    if (is_position)
      diagnostics.Report(span, diag::PositionNotAlwaysWritten, path);
    else
      diagnostics.Report(span, diag::OutputNotAlwaysWritten, path);
  } else if (is_position) {
    diagnostics.Report(span, diag::PositionNotWritten, path, how);
  } else {
    diagnostics.Report(span, diag::OutputNotWritten, path, how);
  }
}

}  // namespace clipc::rules
