// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/resolve/lower_streams.h"

#include <algorithm>
#include <cstdint>

#include "frontend/resolve/names.h"
#include "ir/access.h"
#include "ir/builder.h"

namespace clipc::resolve {
namespace {

void Lower(Program& program, ExprId id, Diagnostics& diagnostics) {
  const auto* found = As<ObjectCall>(program, id);
  if (!found || (found->op != ObjectOp::kAppend && found->op != ObjectOp::kRestartStrip)) return;
  const ObjectCall call = *found;
  const ExprId object = OperandOf(program, call, OperandKind::kObject);
  const auto& streams = program.emission.streams;
  const auto stream = std::ranges::find(streams, RootOf(program, object), &Stream::object);
  if (stream == streams.end()) {
    diagnostics.Report(program.exprs[object].span, diag::StreamUnknown);
    return;
  }
  Builder builder(program, program.exprs[id].span);
  if (call.op == ObjectOp::kAppend) {
    const ExprId vertex[] = {OperandOf(program, call, OperandKind::kValue)};
    program.exprs[id].node = Call{stream->emit, program.expr_lists.Add(vertex)};
    return;
  }
  const ExprId number[] = {builder.Uint(static_cast<std::uint32_t>(stream - streams.begin()))};
  program.exprs[id].node =
      IntrinsicCall{CommonIntrinsic::kEndPrimitive, program.expr_lists.Add(number)};
}

}  // namespace

void LowerStreams(Program& program, Diagnostics& diagnostics) {
  if (!InfoOf(program.stage).emits_vertices) return;
  for (const FunctionId function : program.functions.ids()) {
    std::vector<ExprId> calls;
    ForEachExpr(program, program.functions[function].body, [&](ExprId id) { calls.push_back(id); });
    for (const ExprId id : calls) Lower(program, id, diagnostics);
  }
}

}  // namespace clipc::resolve
