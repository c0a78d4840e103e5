// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/tessellation.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/spelling.h"
#include "frontend/check/function.h"
#include "frontend/check/type.h"
#include "frontend/signature/semantics.h"

namespace clipc::check {

std::optional<std::string_view> StringOf(const Context& context, ast::ExprId id) {
  const auto* literal = context.GetIf<ast::Literal>(id);
  if (!literal || literal->kind != LiteralKind::kString) return std::nullopt;
  return context[Name{static_cast<std::uint32_t>(literal->bits)}];
}

std::optional<std::size_t> WordIn(Context& context, const AttributeLists& attributes,
                                  std::string_view name, std::span<const std::string_view> words) {
  const ast::Attr* attribute = FindAttribute(context, attributes, name);
  if (!attribute) return std::nullopt;
  const auto arguments = context[attribute->arguments];
  if (arguments.size() == 1) {
    if (const auto text = StringOf(context, arguments[0])) {
      for (std::size_t i = 0; i < words.size(); ++i) {
        if (EqualIgnoringCase(words[i], *text)) return i;
      }
    }
  }
  std::string list;
  for (const std::string_view word : words)
    list += fmt::format("{}`\"{}\"`", list.empty() ? "" : ", ", word);
  context.Report(attribute->span, diag::TessellationWord, name, list);
  return std::nullopt;
}

static std::vector<std::string_view> DomainWords() {
  std::vector<std::string_view> words;
  for (const DomainInfo& info : kDomains) words.push_back(info.name);
  return words;
}

// The word of the attribute in the list; empty without one that is a string.
static std::string_view PlainWord(const Context& context, List<ast::Attr> attributes,
                                  std::string_view name) {
  for (const ast::Attr& attribute : context[attributes]) {
    if (!EqualIgnoringCase(context[attribute.name], name)) continue;
    const auto arguments = context[attribute.arguments];
    if (arguments.size() == 1) return StringOf(context, arguments[0]).value_or("");
  }
  return {};
}

// The value that the hull shaders of the file with the domain give an attribute; nullopt if there
// are none, or if they differ.
template <typename Value>
static std::optional<Value> OfHullShaders(const Context& context, std::string_view name,
                                          std::span<const std::string_view> words) {
  std::optional<Value> found;
  const std::optional<Domain>& domain = context.program.tessellation.domain;
  for (const ast::DeclId id : context.file.decls.ids()) {
    const auto* function = context.GetIf<ast::FunctionDecl>(id);
    if (!function) continue;
    const std::string_view word = PlainWord(context, function->attributes, name);
    const std::string_view of = PlainWord(context, function->attributes, "domain");
    if (word.empty() || !domain || !EqualIgnoringCase(of, InfoOf(*domain).name)) continue;
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (!EqualIgnoringCase(words[i], word)) continue;
      if (found && *found != static_cast<Value>(i)) return std::nullopt;
      found = static_cast<Value>(i);
    }
  }
  return found;
}

bool ReadPatch(Context& context, const ast::VarDecl& var, const Parameter& parameter) {
  const StageInfo& stage = InfoOf(context.program.stage);
  const std::string_view name = PatchName(context, var);
  const bool is_read = name == "InputPatch" ? stage.makes_patches : stage.reads_patches;
  if (!is_read) {
    context.Report(
        var.name_span, diag::SemanticOnObject, context[var.name], name,
        signature::AdviceForObject(name, context.program.stage, context.program.profile));
    return false;
  }
  if (context.IsError(parameter.type)) return false;
  Tessellation& tessellation = context.program.tessellation;
  const std::uint32_t count = context[parameter.type].count;
  if (count > kMostControlPoints)
    context.Report(var.name_span, diag::PatchPoints, context[var.name],
                   WithCount(count, "control point"), kMostControlPoints);
  std::uint32_t& points =
      stage.makes_patches ? tessellation.input_points : tessellation.output_points;
  if (points > 0) ReportSecondPatch(context, var, context.program.entry);
  points = count;
  return true;
}

void ReportSecondPatch(Context& context, const ast::VarDecl& var, FunctionId function) {
  context.Report(var.name_span, diag::PatchTwice, context[var.name], PatchName(context, var),
                 context.program.functions[function].name);
}

void CheckRepeated(Context& context, const AttributeLists& lists) {
  constexpr std::string_view kSaidOnce[] = {
      "domain",         "instance",     "maxtessfactor",     "maxvertexcount",     "numthreads",
      "outputtopology", "partitioning", "patchconstantfunc", "outputcontrolpoints"};
  std::size_t count = 0;
  for (const std::span<const ast::Attr> list : lists) count += list.size();
  if (count < 2) return;
  for (const std::string_view name : kSaidOnce) {
    const ast::Attr* first = FindAttribute(context, lists, name);
    if (!first) continue;
    const std::string said = OperandsAsText(context, *first);
    for (const std::span<const ast::Attr> list : lists) {
      for (const ast::Attr& attribute : list) {
        const bool differs = EqualIgnoringCase(context[attribute.name], name) &&
                             !EqualIgnoringCase(OperandsAsText(context, attribute), said);
        if (differs)
          context.Report(attribute.span, diag::AttributeTwice, name)
              .Note(first->span, diag::FirstGivenHere);
      }
    }
  }
}

void CheckTessellation(Context& context, FunctionInfoId entry, const AttributeLists& attributes) {
  Program& program = context.program;
  const StageInfo& stage = InfoOf(program.stage);
  if (!stage.makes_patches && !stage.reads_patches) return;
  const ViewSwitch in(context, {.scope = context[entry].scope, .order = context[entry].order});
  const Function& function = program.functions[program.entry];
  if (!FindAttribute(context, attributes, "domain")) {
    context.Report(function.span, diag::DomainMissing, function.name, stage.name);
  } else if (const auto domain = WordIn(context, attributes, "domain", DomainWords())) {
    program.tessellation.domain = static_cast<Domain>(*domain);
  }
  if (!stage.reads_patches) return;
  program.tessellation.partitioning =
      OfHullShaders<Partitioning>(context, "partitioning", kPartitionings);
  program.tessellation.topology =
      OfHullShaders<OutputTopology>(context, "outputtopology", kOutputTopologies);
}

}  // namespace clipc::check
