// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/hull.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/spelling.h"
#include "frontend/check/body.h"
#include "frontend/check/entry.h"
#include "frontend/check/entry_signature.h"
#include "frontend/check/expr.h"
#include "frontend/check/function.h"
#include "frontend/check/tessellation.h"
#include "frontend/check/type.h"
#include "frontend/check/value.h"
#include "frontend/typing/constant.h"
#include "ir/access.h"
#include "ir/builder.h"

namespace clipc::check {
namespace {

constexpr double kMostFactor = 64;

// An attribute that a hull shader must have.
struct Wanted {
  std::string_view name, example, says;
};
constexpr Wanted kWanted[] = {
    {"partitioning", "partitioning(\"fractional_odd\")", "says how edges are cut"},
    {"outputtopology", "outputtopology(\"triangle_cw\")", "says what the patch is cut into"},
    {"outputcontrolpoints", "outputcontrolpoints(3)", "says how many control points it gives"},
    {"patchconstantfunc", "patchconstantfunc(\"Constants\")",
     "names the function that computes the tessellation factors"},
};

void ReportMissing(Context& context, const AttributeLists& attributes) {
  const Function& function = context.program.functions[context.program.entry];
  for (const Wanted& wanted : kWanted) {
    if (!HasAttribute(context, attributes, wanted.name))
      context.Report(function.span, diag::HullAttributeMissing, function.name, wanted.name,
                     wanted.example, wanted.says);
  }
}

// The factor that [maxtessfactor(..)] gives; nullopt after an error, and without the attribute.
std::optional<float> MostFactor(Context& context, const AttributeLists& attributes) {
  const ast::Attr* attribute = FindAttribute(context, attributes, "maxtessfactor");
  if (!attribute) return std::nullopt;
  const auto arguments = context[attribute->arguments];
  if (arguments.size() == 1) {
    const ExprId value = CheckExpr(context, arguments[0]);
    if (context.IsError(value)) return std::nullopt;
    const auto constant = EvaluateConstant(context.program, value);
    if (constant && constant->components.size() == 1 && constant->components[0] >= 1 &&
        constant->components[0] <= kMostFactor)
      return static_cast<float>(constant->components[0]);
  }
  context.Report(attribute->span, diag::MostFactorRange, kMostFactor);
  return std::nullopt;
}

// Reports a topology that the domain is not cut into, which fxc and dxc refuse (vkd3d's
// hull-shader-attributes.shader_test).
void CheckTopology(Context& context, const AttributeLists& attributes) {
  const Tessellation& tessellation = context.program.tessellation;
  if (!tessellation.domain || !tessellation.topology) return;
  const OutputTopology topology = *tessellation.topology;
  const bool is_line = topology == OutputTopology::kLine;
  const bool is_isoline = *tessellation.domain == Domain::kIsoline;
  if (topology == OutputTopology::kPoint || is_line == is_isoline) return;
  context.Report(FindAttribute(context, attributes, "outputtopology")->span, diag::TopologyOfDomain,
                 InfoOf(*tessellation.domain).name,
                 kOutputTopologies[static_cast<std::size_t>(topology)],
                 is_isoline ? "`point` and `line`" : "`point`, `triangle_cw` and `triangle_ccw`");
}

void ReadPartition(Context& context, const AttributeLists& attributes) {
  Tessellation& tessellation = context.program.tessellation;
  if (const auto word = WordIn(context, attributes, "partitioning", kPartitionings))
    tessellation.partitioning = static_cast<Partitioning>(*word);
  if (const auto word = WordIn(context, attributes, "outputtopology", kOutputTopologies))
    tessellation.topology = static_cast<OutputTopology>(*word);
  // fxc takes 0, for a patch of constants only (a test of DXC's dxilconv); GLSL has one at least.
  const std::int64_t least = context.program.profile.IsAtLeast(6, 0) ? 1 : 0;
  if (const auto count =
          NumberIn(context, attributes, "outputcontrolpoints", kMostControlPoints, least))
    tessellation.output_points = std::max(*count, 1u);
  tessellation.max_factor = MostFactor(context, attributes);
  CheckTopology(context, attributes);
}

// ---- the function of the constants

// The symbol of the last function of that name with a body, as fxc takes it of several; none if
// there is none. `names` gets the names of all functions.
SymbolId PatchFunctionOf(const Context& context, std::string_view name,
                         std::vector<std::string>& names) {
  SymbolId found;
  for (const SymbolId id : context.names.symbol_ids()) {
    if (context[id].kind != SymbolKind::kFunction) continue;
    const ast::FunctionDecl& decl = DeclOf(context, id);
    if (!decl.body || decl.is_template) continue;
    names.push_back(ScopedName(context, id));
    if (names.back() == name || context[context[id].name] == name) found = id;
  }
  return found;
}

void ReportNoFunction(Context& context, Span span, std::string_view name,
                      const std::vector<std::string>& names) {
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  const std::vector<std::string_view> near = NearNames(name, candidates);
  Diagnostic& report =
      context.Report(span, diag::PatchFunctionMissing, name,
                     near.empty() ? "" : fmt::format("; did you mean `{}`?", near.front()));
  if (!near.empty()) report.Fix(span, fmt::format("\"{}\"", near.front()));
}

// Reads a parameter of the function of the constants.
EntryParameter ReadParameter(Context& context, const Parameter& parameter) {
  const auto& var = context.Get<ast::VarDecl>(parameter.decl);
  EntryParameter into = Described(context, var);
  if (!IsPatch(context, var) || context.IsError(parameter.type)) return into;
  const Tessellation& tessellation = context.program.tessellation;
  const std::uint32_t count = context[parameter.type].count;
  into.is_of_points = PatchName(context, var) == "OutputPatch";
  into.is_of_vertices = !into.is_of_points;
  const std::uint32_t known =
      into.is_of_points ? tessellation.output_points : tessellation.input_points;
  if (known != 0 && count != known)
    context.Report(var.name_span, diag::PatchSizesDiffer, context[var.name],
                   WithCount(count, "control point"), known,
                   into.is_of_points ? "`outputcontrolpoints`" : "the `InputPatch` of the entry");
  if (into.is_of_vertices && known == 0) {
    context.program.tessellation.input_points = count;
    if (count > kMostControlPoints)
      context.Report(var.name_span, diag::PatchPoints, context[var.name],
                     WithCount(count, "control point"), kMostControlPoints);
  }
  return into;
}

EntrySignature ReadFunction(Context& context, const AttributeLists& attributes) {
  EntrySignature signature;
  const ast::Attr* attribute = FindAttribute(context, attributes, "patchconstantfunc");
  if (!attribute) return signature;
  const auto arguments = context[attribute->arguments];
  const auto name = arguments.size() == 1 ? StringOf(context, arguments[0]) : std::nullopt;
  if (!name) {
    context.Report(attribute->span, diag::PatchFunctionUnnamed);
    return signature;
  }
  std::vector<std::string> names;
  const SymbolId symbol = PatchFunctionOf(context, *name, names);
  if (!symbol) {
    ReportNoFunction(context, context[arguments[0]].span, *name, names);
    return signature;
  }
  FunctionInfoId function;
  for (const FunctionInfoId id : OverloadsOf(context, symbol, {}))
    if (context[id].decl == context[symbol].decl) function = id;
  if (!function || context[function].is_broken) return signature;
  context.program.tessellation.patch_function = Reach(context, function);
  const FunctionInfo& info = context[function];
  const std::vector<Parameter> parameters(context[info.parameters].begin(),
                                          context[info.parameters].end());
  for (const Parameter& parameter : parameters) {
    const EntryParameter read = ReadParameter(context, parameter);
    const bool is_second = std::ranges::any_of(signature.parameters, [&](const auto& other) {
      return (read.is_of_points && other.is_of_points) ||
             (read.is_of_vertices && other.is_of_vertices);
    });
    if (is_second)
      ReportSecondPatch(context, context.Get<ast::VarDecl>(parameter.decl),
                        context.program.tessellation.patch_function);
    signature.parameters.push_back(read);
  }
  signature.result = DescribedResult(context, DeclOf(context, context[function]));
  return signature;
}

// The functions that the statements call, and all that these call.
std::vector<FunctionId> CalledIn(const Program& program, std::span<const StmtId> stmts) {
  std::vector<FunctionId> reached;
  const auto add = [&](ExprId id) {
    const auto* call = As<Call>(program, id);
    if (call && std::ranges::find(reached, call->function) == reached.end())
      reached.push_back(call->function);
  };
  for (const StmtId stmt : stmts) ForEachExpr(program, stmt, add);
  for (std::size_t i = 0; i < reached.size(); ++i)
    ForEachExpr(program, program.functions[reached[i]].body, add);
  return reached;
}

// The statements, or the body of a function, and the bodies of all that it calls.
std::vector<StmtId> AllOf(const Program& program, std::vector<StmtId> stmts) {
  for (const FunctionId function : CalledIn(program, stmts))
    stmts.push_back(program.functions[function].body);
  return stmts;
}

// A mark for each VarId that the statements name.
std::vector<bool> NamedIn(const Program& program, std::span<const StmtId> stmts) {
  std::vector<bool> is_named(program.vars.size());
  for (const StmtId stmt : stmts) {
    ForEachExpr(program, stmt, [&](ExprId id) {
      if (const auto* ref = As<VarRef>(program, id)) is_named[ref->var.index] = true;
    });
  }
  return is_named;
}

}  // namespace

EntrySignature ReadHull(Context& context, FunctionInfoId entry, const AttributeLists& attributes) {
  if (!InfoOf(context.program.stage).makes_patches) return {};
  const ViewSwitch in(context, {.scope = context[entry].scope, .order = context[entry].order});
  ReportMissing(context, attributes);
  ReadPartition(context, attributes);
  return ReadFunction(context, attributes);
}

void CheckHull(Context& context) {
  const Program& program = context.program;
  const FunctionId first = program.tessellation.patch_function;
  if (!first) return;
  const StmtId body = program.functions[first].body;
  const std::vector<FunctionId> called = CalledIn(program, {&body, 1});
  const bool calls = std::ranges::find(called, program.entry) != called.end();
  if (!calls && first != program.entry) return;
  context.Report(program.functions[first].span, diag::PatchFunctionCalls,
                 program.functions[first].name, program.functions[program.entry].name);
}

void ResetStatics(Context& context) {
  Program& program = context.program;
  const StmtId block = PatchBlock(program);
  if (!block || context.diagnostics.has_errors()) return;
  const auto of = [&](FunctionId function) {
    return AllOf(program, {program.functions[function].body});
  };
  std::vector<StmtId> before = of(program.entry);
  std::vector<StmtId> after = of(program.tessellation.patch_function);
  const auto is_reset = [&](const std::vector<bool>& is_changed,
                            const std::vector<bool>& is_named) {
    return [&](VarId id) {
      return program.vars[id].storage == Storage::kStatic && is_changed[id.index] &&
             is_named[id.index];
    };
  };
  if (std::ranges::none_of(program.globals,
                           is_reset(AssignedIn(program, before), NamedIn(program, after))))
    return;
  // First values that are computed are computed again, from those that are not.
  const std::vector<StmtId>& first_values = context.globals.first_values;
  for (const StmtId stmt : AllOf(program, first_values))
    before.push_back(stmt), after.push_back(stmt);
  std::vector<bool> is_changed = AssignedIn(program, before);
  for (const StmtId stmt : first_values) {
    const Assign* first = AsAssignment(program, stmt);
    const auto* whole = first ? As<VarRef>(program, first->target) : nullptr;
    if (whole) is_changed[whole->var.index] = false;
  }
  const std::vector<bool> is_named = NamedIn(program, after);
  Builder builder(program);
  std::vector<StmtId> body;
  for (const VarId id : program.globals) {
    if (!is_reset(is_changed, is_named)(id)) continue;
    const Var var = program.vars[id];
    const ExprId value = var.init ? Clone(program, var.init) : builder.ZeroOf(var.type);
    body.push_back(builder.Eval(builder.AssignTo(builder.Ref(id), value)));
  }
  for (const StmtId stmt : first_values)
    body.push_back(builder.Eval(Clone(program, As<Evaluate>(program, stmt)->expr)));
  const auto rest = program.stmt_lists[As<Block>(program, block)->body];
  body.insert(body.end(), rest.begin(), rest.end());
  program.stmts[block].node = Block{program.stmt_lists.Add(std::span<const StmtId>(body))};
}

}  // namespace clipc::check
