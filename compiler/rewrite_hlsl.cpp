// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/rewrite_hlsl.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "frontend/check/entry_point.h"
#include "frontend/parse/attributes.h"
#include "frontend/parse/parse.h"
#include "rewrite/rewrite.h"

namespace clipc {
namespace {

std::vector<std::string> EntriesOf(const CompileRequest& request) {
  std::vector<std::string> entries = {request.language.entry};
  for (const std::string& entry : request.hlsl.entries) {
    if (std::ranges::find(entries, entry) == entries.end()) entries.push_back(entry);
  }
  return entries;
}

std::string_view LastPart(std::string_view entry) { return entry.substr(entry.rfind(':') + 1); }

// Whether the name at `at` is called: a word before it is a type or a profile.
bool IsCall(const Tokens& tokens, std::size_t at) {
  if (tokens.list[at + 1].kind != TokenKind::kLeftParen || at == 0) return false;
  const Token& before = tokens.list[at - 1];
  return before.kind != TokenKind::kIdentifier || tokens.names[before.name()] == "return";
}

// The tokens that are the last part of the name of an entry, by entry.
std::vector<std::vector<rewrite::Use>> UsesOf(const Tokens& tokens,
                                              const std::vector<std::string>& entries) {
  std::vector<std::vector<rewrite::Use>> uses(entries.size());
  for (std::size_t at = 0; at < tokens.list.size(); ++at) {
    const Token& token = tokens.list[at];
    if (token.kind != TokenKind::kIdentifier) continue;
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (tokens.names[token.name()] == LastPart(entries[i]))
        uses[i].push_back({token.span(), IsCall(tokens, at)});
    }
  }
  return uses;
}

// The number of attributes with clip planes in the text, whether or not they could be parsed.
std::size_t CountAttributes(const Tokens& tokens) {
  std::size_t count = 0;
  for (std::size_t i = 0; i + 1 < tokens.list.size(); ++i) {
    const Token& token = tokens.list[i];
    count += token.kind == TokenKind::kIdentifier &&
             tokens.list[i + 1].kind == TokenKind::kLeftParen &&
             MeaningOfAttribute(tokens.names[token.name()]) == AttributeMeaning::kClipPlanes;
  }
  return count;
}

std::size_t CountAttributes(const ast::File& file) {
  std::size_t count = 0;
  for (const ast::DeclId id : file.decls.ids()) {
    const auto* function = std::get_if<ast::FunctionDecl>(&file.decls[id].node);
    if (!function) continue;
    count += static_cast<std::size_t>(
        std::ranges::count_if(file.attrs[function->attributes], [&](const ast::Attr& attr) {
          return MeaningOfAttribute(file.names[attr.name]) == AttributeMeaning::kClipPlanes;
        }));
  }
  return count;
}

bool HasName(const ast::File& file, std::string_view name) {
  for (std::uint32_t i = 0; i < file.names.size(); ++i) {
    if (file.names[Name{i}] == name) return true;
  }
  return false;
}

// Whether a syntax error may have changed what the planes of the entry are: it is inside of a
// declaration of the function, or may be.
bool IsDoubtful(const EntryPoint& entry, const Source& source, const Diagnostics& of_text) {
  for (const Diagnostic& problem : of_text.all()) {
    if (problem.severity != Severity::kError) continue;
    for (const Span declaration : entry.declarations) {
      if (!source.InMainText(declaration) ||
          (problem.span.begin >= declaration.begin && problem.span.begin <= declaration.end))
        return true;
    }
  }
  return false;
}

// Reports the names of new functions that the file has already.
void CheckNewNames(const CompileRequest& request, const ast::File& file, const EntryPoint& entry,
                   Diagnostics& diagnostics) {
  const std::string& wrapper = request.hlsl.wrapper_entry;
  std::vector<std::string> names;
  if (!wrapper.empty()) names.push_back(wrapper);
  const std::size_t most =
      std::min<std::size_t>(entry.planes.size(), request.planes.variants.value_or(0));
  for (std::size_t i = 0; request.planes.variants && i <= most; ++i)
    names.push_back(fmt::format("{}_{}", wrapper.empty() ? entry.name : wrapper, i));
  for (const std::string& name : names) {
    if (HasName(file, name)) diagnostics.Report(entry.definition, diag::RewriteNameTaken, name);
  }
}

}  // namespace

std::string RewriteHlsl(const CompileRequest& request, const Plan& plan, Source& source,
                        Watch* watch, Diagnostics& diagnostics) {
  Tokens tokens = Lex(source, diagnostics);
  if (diagnostics.has_errors()) return {};
  const std::vector<std::string> names = EntriesOf(request);
  const std::vector<std::vector<rewrite::Use>> uses = UsesOf(tokens, names);
  const std::size_t attributes = CountAttributes(tokens);

  // What clipc does not know elsewhere is not its business; it is reported only where it may be why
  // an entry point is not understood.
  const bool reads_bodies = plan.lowering.plane_space == PlaneSpace::kObject;
  Diagnostics of_text;
  of_text.SetWatch(watch);
  const ast::File file = Parse(std::move(tokens), of_text,
                               reads_bodies ? FunctionBodies::kParse : FunctionBodies::kSkip);
  const bool lost_attribute = of_text.has_errors() && CountAttributes(file) != attributes;
  if (lost_attribute) {
    diagnostics.Append(of_text);
    return {};
  }

  std::vector<rewrite::Entry> entries;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!MayHaveClipPlanes(file, names[i])) continue;
    CheckOptions options = plan.check;
    options.entry = names[i];
    Diagnostics of_entry;
    of_entry.SetWatch(watch);
    rewrite::Entry entry;
    entry.point = CheckEntryPoint(
        file, options, reads_bodies ? EntryBodies::kCheck : EntryBodies::kLeave, of_entry);
    const bool is_known = !of_entry.has_errors() &&
                          entry.point.planes.size() == entry.point.program.clip_planes.size() &&
                          !IsDoubtful(entry.point, source, of_text);
    if (!is_known) diagnostics.Append(of_text);
    diagnostics.Append(of_entry);
    if (!is_known || entry.point.planes.empty()) continue;
    const ir::VarId position = CheckLowering(entry.point.program, plan.lowering, diagnostics);
    entry.form = {plan.lowering.lowering, plan.lowering.plane_space, position,
                  plan.lowering.distances};
    entry.uses = uses[i];
    CheckNewNames(request, file, entry.point, diagnostics);
    entries.push_back(std::move(entry));
  }
  if (diagnostics.has_errors()) return {};
  if (entries.empty()) return source.MainText();
  const rewrite::Options options{request.hlsl.wrapper_entry, request.planes.variants,
                                 request.outputs.source_lines, request.path};
  return Rewrite(source, entries, options, diagnostics);
}

}  // namespace clipc
