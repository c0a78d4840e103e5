// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "legalize/legalize.h"

namespace clipc::legalize {

using ir::Form;

namespace {

// The first pass sees the order of the operands before others move them into helper functions. Each
// pass leaves nodes that the later ones take apart: rows are vectors, components are scalars.
constexpr ir::Pass<Legalizer> kPasses[] = {
    {"lower-operand-order", LowerOperandOrder, Form::kInlined},
    {"split-arrays", SplitArrays, Form::kInlined},
    {"flatten-arrays", FlattenArrays, Form::kInlined},
    {"lower-indices", LowerIndices, Form::kInlined},
    {"lower-to-es100", LowerToEs100, Form::kInlined},
    {"lower-assignments", LowerAssignments, Form::kInlined},
    {"lower-matrix-operators", LowerMatrixOperators, Form::kInlined},
    {"lower-matrix-functions", LowerMatrixFunctions, Form::kInlined},
    {"lower-written-arguments", LowerWrittenArguments, Form::kInlined},
    {"lower-conversions", LowerConversions, Form::kInlined},
    {"lower-divisions", LowerDivisions, Form::kInlined},
    {"lower-choices", LowerChoices, Form::kInlined},
    {"lower-sample-operands", LowerSampleOperands, Form::kInlined},
    {"lower-arithmetic", LowerArithmetic, Form::kInlined},
    {"lower-components", LowerComponents, Form::kInlined},
    {"lower-functions", LowerFunctions, Form::kLegalized},
    {"lower-shared-floats", LowerSharedFloats, Form::kLegalized},
    // A store in a function of its own has an effect that the passes before do not look for there.
    {"lower-structured-buffers", LowerStructuredBuffers, Form::kLegalized},
    {"lower-byte-buffers", LowerByteBuffers, Form::kAddressed},
};

}  // namespace

std::span<const ir::Pass<Legalizer>> LegalizePasses() { return kPasses; }

bool Legalize(ir::Program& program, const Needs& needs, const ir::PassOptions& options) {
  Legalizer legalizer(program, needs);
  return ir::RunPasses(program, LegalizePasses(), legalizer, options);
}

}  // namespace clipc::legalize
