// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/typing/intrinsic_call.h"

#include <string>
#include <vector>

#include "base/spelling.h"
#include "frontend/typing/reread.h"
#include "ir/access.h"

namespace clipc::typing {
namespace {

std::string CountText(std::size_t least, std::size_t most) {
  const std::string range = least == most ? "" : most == least + 1 ? " or " : " to ";
  return (range.empty() ? "" : std::to_string(least) + range) + WithCount(most, "argument");
}

// The variable at the root of a path that may be assigned to; otherwise none. No component may be
// named twice, nor be chosen at run time among several of a matrix.
VarId TargetRoot(const Program& program, ExprId path) {
  const auto* index = As<Index>(program, path);
  if (index && As<MatrixSwizzle>(program, index->base)) return {};
  for (ExprId part = path; part; part = WholeOf(program, part)) {
    if (RepeatsComponents(program, part)) return {};
  }
  return RootOf(program, path);
}

// The arguments of a vector's constructor that make its components [begin, end); nullopt if some
// argument reaches across an end.
std::optional<std::vector<ExprId>> Cut(const Program& program, List<ExprId> list,
                                       std::uint32_t begin, std::uint32_t end) {
  std::vector<ExprId> found;
  std::uint32_t at = 0;
  for (const ExprId argument : program.expr_lists[list]) {
    const std::uint32_t next = at + TypeOf(program, argument).Components();
    if (at < end && next > begin) {
      if (at < begin || next > end) return std::nullopt;
      found.push_back(argument);
    }
    at = next;
  }
  return found;
}

}  // namespace

bool IntrinsicCheck::HasCount(std::size_t least, std::size_t most) const {
  if (arguments.size() >= least && arguments.size() <= most) return true;
  diagnostics.Report(name_span, diag::IntrinsicArgumentCount, name, CountText(least, most),
                     arguments.size());
  return false;
}

ExprId IntrinsicCheck::BadArgument(std::size_t i, std::string_view expected) const {
  return Fail(SpanOf(arguments[i]), diag::IntrinsicArgumentType, i + 1, name,
              program.types.Name(ArgumentTypeId(i)), expected);
}

std::optional<ExprId> IntrinsicCheck::Converted(std::size_t i, TypeId type) const {
  if (RankImplicit(program.types, ArgumentTypeId(i), type)) return ConvertArgument(i, type);
  BadArgument(i, "`" + program.types.Name(type) + "`");
  return std::nullopt;
}

bool IntrinsicCheck::IsTarget(std::size_t i) const {
  const VarId root = TargetRoot(program, arguments[i]);
  if (root) {
    IndexWholeVector(program, arguments[i]);
    switch (program.vars[root].storage) {
      case Storage::kLocal:
      case Storage::kIn:
      case Storage::kOut:
      case Storage::kInOut:
      case Storage::kStatic:
      case Storage::kShared: return true;
      default: break;
    }
  }
  diagnostics.Report(SpanOf(arguments[i]), diag::IntrinsicOutArgument, i + 1, name);
  return false;
}

bool IntrinsicCheck::IsTargetOf(std::size_t i, TypeId type) const {
  if (!IsTarget(i)) return false;
  if (RankImplicit(program.types, type, ArgumentTypeId(i))) return true;
  BadArgument(i, "`" + program.types.Name(type) + "`");
  return false;
}

IntrinsicCheck::Parts IntrinsicCheck::Split(ExprId vector, int count, int last) const {
  const Scalar kind = TypeOf(vector).scalar;
  const TypeId leading_type = VectorOf(kind, count);
  Builder builder(program, SpanOf(vector));
  // float4(uv, 0, level) needs no temporary: its parts are there.
  const auto* convert = As<ir::Convert>(program, vector);
  const ExprId inner = convert ? convert->operand : vector;
  if (const auto* construct = As<Construct>(program, inner)) {
    const auto list = construct->arguments;
    const auto leading = Cut(program, list, 0, static_cast<std::uint32_t>(count));
    const auto level =
        Cut(program, list, static_cast<std::uint32_t>(last), static_cast<std::uint32_t>(last) + 1);
    if (leading && level && (count == last || IsPure(program, inner))) {
      const TypeId whole = program.types.WithScalar(leading_type, TypeOf(inner).scalar);
      const ExprId joined =
          leading->size() == 1 ? leading->front() : builder.ConstructOf(whole, *leading);
      return {Convert(joined, leading_type), Convert(level->front(), program.types.Make(kind)), {}};
    }
  }
  Reread source(program, inner, &temporaries);
  const ExprId leading = builder.SwizzledRun(source.Read(), 0, static_cast<std::size_t>(count));
  const ExprId lone = builder.Swizzled(source.Read(), {last});
  return {Convert(leading, leading_type), Convert(lone, program.types.Make(kind)),
          source.prologue()};
}

ExprId After(const IntrinsicCheck& call, std::span<const ExprId> steps, ExprId value) {
  for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
    if (*step) value = call.Make().CommaOf(*step, value);
  }
  return value;
}

}  // namespace clipc::typing
