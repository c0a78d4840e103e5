// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/rewrite_hlsl.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/spelling.h"
#include "frontend/check/entry_point.h"
#include "frontend/parse/attributes.h"
#include "frontend/parse/parse.h"
#include "ir/profile.h"
#include "rewrite/rewrite.h"

namespace clipc {
namespace {

std::vector<std::string> EntriesOf(const ProgramRequest& request) {
  std::vector<std::string> entries = {request.first().entry};
  for (const std::string& entry : request.hlsl.entries) {
    if (std::ranges::find(entries, entry) == entries.end()) entries.push_back(entry);
  }
  return entries;
}

std::string_view LastPart(std::string_view entry) { return entry.substr(entry.rfind(':') + 1); }

// What the name at `at` is. `vs_5_0 main()` and `CompileShader(vs_5_0, main())` of an effect name
// an entry function; and a word before the name is its type.
rewrite::Use::Kind KindOf(const Tokens& tokens, std::size_t at) {
  using enum rewrite::Use::Kind;
  if (tokens.list[at + 1].kind != TokenKind::kLeftParen || at == 0) return kOther;
  const auto word = [&](std::size_t back) {
    const bool is_word = at >= back && tokens.list[at - back].kind == TokenKind::kIdentifier;
    return is_word ? tokens.names[tokens.list[at - back].name()] : std::string_view();
  };
  if (ir::ParseProfile(word(1))) return kOther;
  if (!word(1).empty()) return word(1) == "return" ? kCall : kDeclaration;
  const TokenKind before = tokens.list[at - 1].kind;
  const bool is_other =
      before == TokenKind::kDot || (before == TokenKind::kComma && ir::ParseProfile(word(2)));
  return is_other ? kOther : kCall;
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
        uses[i].push_back({token.span(), KindOf(tokens, at)});
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

// A main file as far as it is understood.
struct MainFile {
  Job& job;
  std::vector<std::string> entries;  // names of functions
  std::vector<std::vector<rewrite::Use>> uses;
  ast::File file;
  Diagnostics of_text;  // what is wrong in it, wherever that is
  bool has_bodies;
};

// Reads the main file of a job. Returns nullopt after an error.
std::optional<MainFile> ReadMainFile(Job& job, std::vector<std::string> entries, bool has_bodies) {
  Tokens tokens = Lex(job.source(), job.diagnostics);
  if (job.diagnostics.has_errors()) return std::nullopt;
  MainFile main{job, std::move(entries), {}, {}, Diagnostics(), has_bodies};
  main.uses = UsesOf(tokens, main.entries);
  const std::size_t attributes = CountAttributes(tokens);
  // What clipc does not know elsewhere is not its business; it is reported only where it may be why
  // an entry point is not understood.
  main.of_text.SetWatch(job.watch);
  main.file = Parse(std::move(tokens), main.of_text,
                    has_bodies ? FunctionBodies::kParse : FunctionBodies::kSkip);
  const bool lost_attribute = main.of_text.has_errors() && CountAttributes(main.file) != attributes;
  if (!lost_attribute) return main;
  job.diagnostics.Append(main.of_text);
  return std::nullopt;
}

// Whether a syntax error may have changed what the planes of the entry are: it is inside of a
// declaration of the function, or may be.
bool IsDoubtful(const EntryPoint& entry, const MainFile& main) {
  for (const Diagnostic& problem : main.of_text.all()) {
    if (problem.severity != Severity::kError) continue;
    for (const Span declaration : entry.declarations) {
      if (!main.job.source().InMainText(declaration) ||
          (problem.span.begin >= declaration.begin && problem.span.begin <= declaration.end))
        return true;
    }
  }
  return false;
}

// Describes the entry of this number. Returns nullopt after an error.
std::optional<rewrite::Entry> ReadEntry(const MainFile& main, std::size_t number) {
  Job& job = main.job;
  CheckOptions options = job.plan.check;
  options.entry = main.entries[number];
  Diagnostics of_entry;
  of_entry.SetWatch(job.watch);
  rewrite::Entry entry;
  entry.source = &job.source();
  entry.diagnostics = &job.diagnostics;
  entry.point = CheckEntryPoint(
      main.file, options, main.has_bodies ? EntryBodies::kCheck : EntryBodies::kLeave, of_entry);
  const bool is_known = !of_entry.has_errors() &&
                        entry.point.planes.size() == entry.point.program.clip_planes.size() &&
                        !IsDoubtful(entry.point, main);
  if (!is_known) job.diagnostics.Append(main.of_text);
  job.diagnostics.Append(of_entry);
  if (!is_known) return std::nullopt;
  entry.planes = entry.point.planes.size();
  entry.uses = main.uses[number];
  return entry;
}

// Reports the names of new functions that the file has already.
void CheckNewNames(const ProgramRequest& request, const ast::File& file,
                   const rewrite::Entry& entry) {
  const std::string& wrapper = entry.pixel ? std::string() : request.hlsl.wrapper_entry;
  std::vector<std::string> names;
  if (!wrapper.empty()) names.push_back(wrapper);
  const std::size_t most = std::min<std::size_t>(entry.planes, request.planes.variants.value_or(0));
  for (std::size_t i = 0; request.planes.variants && i <= most; ++i)
    names.push_back(fmt::format("{}_{}", wrapper.empty() ? entry.point.name : wrapper, i));
  for (const std::string& name : names) {
    if (HasName(file, name))
      entry.diagnostics->Report(entry.point.definition, diag::RewriteNameTaken, name);
  }
}

// Settles how the planes of a vertex shader are written.
void PlanPlanes(Job& job, rewrite::Entry& entry) {
  const LoweringRequest& lowering = job.plan.lowering;
  const ir::Program& program = entry.point.program;
  entry.form = {lowering.lowering, lowering.plane_space,
                FindPositionInput(program, lowering, job.diagnostics), lowering.distances};
  if (lowering.lowering != Lowering::kDiscard) return;
  for (const ir::IoVar& output : program.outputs) {
    if (EqualIgnoringCase(output.semantic, rewrite::kPlaneDistance))
      job.diagnostics.Report(entry.point.definition, diag::RewriteNameTaken, output.semantic);
  }
  if (std::ranges::any_of(program.outputs, &ir::IoVar::is_placed))
    entry.form.location = rewrite::LocationAfterOutputs(program);
}

// Whether the pixel shader may write memory: the file has a type of such an object.
bool MayWriteMemory(const ast::File& file) {
  constexpr std::string_view kWritten[] = {"RW", "Append", "Consume", "RasterizerOrdered"};
  for (std::uint32_t i = 0; i < file.names.size(); ++i) {
    for (const std::string_view begin : kWritten) {
      if (file.names[Name{i}].starts_with(begin)) return true;
    }
  }
  return false;
}

// The pixel shader that discards for the planes of `vertex`, the shader of `request`. Returns
// nullopt after an error.
std::optional<rewrite::Entry> DiscardingEntry(const MainFile& main, const rewrite::Entry& vertex,
                                              const ProgramRequest& request) {
  std::optional<rewrite::Entry> entry = ReadEntry(main, 0);
  if (!entry) return std::nullopt;
  const bool has_locations =
      vertex.form.location ||
      std::ranges::any_of(entry->point.program.inputs, &ir::IoVar::is_placed);
  rewrite::PixelForm form;
  form.planes = vertex.form;
  if (has_locations) form.planes.location = rewrite::LocationAfterOutputs(vertex.point.program);
  form.unread = rewrite::UnreadOutputs(vertex.point, entry->point, has_locations);
  form.discards_first = MayWriteMemory(main.file);
  entry->pixel = std::move(form);
  entry->planes = vertex.planes;
  CheckDiscards(entry->point.program, main.job.diagnostics);
  CheckNewNames(request, main.file, *entry);
  return entry;
}

// The main file of the job with its entries changed. `variants` is that of the vertex shader.
std::string Rewritten(Job& job, std::span<const rewrite::Entry> entries,
                      std::optional<std::uint32_t> variants) {
  const ProgramRequest& request = job.request;
  const std::string& text = job.source().MainText();
  if (entries.empty()) return text;
  return rewrite::Rewrite(
      text, entries,
      {request.hlsl.wrapper_entry, variants, request.outputs.source_lines, job.path});
}

}  // namespace

void RewriteHlsl(std::span<Job> jobs, CompileResult& result) {
  Job& job = jobs.front();
  const ProgramRequest& request = job.request;
  const bool has_bodies = job.plan.lowering.plane_space == PlaneSpace::kObject;
  const std::optional<MainFile> main = ReadMainFile(job, EntriesOf(request), has_bodies);
  if (!main) return;
  std::vector<rewrite::Entry> entries;
  for (std::size_t i = 0; i < main->entries.size(); ++i) {
    if (!MayHaveClipPlanes(main->file, main->entries[i])) continue;
    std::optional<rewrite::Entry> entry = ReadEntry(*main, i);
    if (!entry || entry->planes == 0) continue;
    if (const StageInfo& stage = InfoOf(entry->point.program.stage); stage.emits_vertices) {
      job.diagnostics.Report(
          entry->point.definition, diag::Unsupported,
          fmt::format("`--target=hlsl` for the clip planes of a {} shader", stage.name));
      continue;
    }
    PlanPlanes(job, *entry);
    CheckNewNames(request, main->file, *entry);
    if (job.plan.lowering.lowering == Lowering::kDiscard && jobs.size() == 1) {
      const auto& planes = entry->point.program.clip_planes;
      job.diagnostics.Report(Cover(planes.front().span, planes.back().span), diag::RewriteDiscard,
                             entry->point.name, rewrite::kPlaneDistance);
    }
    entries.push_back(std::move(*entry));
  }
  if (job.diagnostics.has_errors()) return;

  std::vector<rewrite::Entry> discarding;
  for (Job& discards : jobs.subspan(1)) {
    const std::optional<MainFile> other =
        ReadMainFile(discards, {discards.plan.check.entry}, false);
    if (!other) return;
    if (entries.empty()) continue;
    auto entry = DiscardingEntry(*other, entries.front(), request);
    if (!entry) return;
    discarding.push_back(std::move(*entry));
  }
  const bool has_own_file = jobs.size() > 1 && !request.hlsl.in_one_file;
  if (!has_own_file) std::ranges::move(discarding, std::back_inserter(entries));
  std::vector<ShaderOutput>& files = result.outputs.emplace().shaders;
  const auto add = [&](Job& of, std::span<const rewrite::Entry> rewritten) {
    files.push_back(
        {Rewritten(of, rewritten, request.planes.variants), {}, of.plan.check.profile.stage});
  };
  add(job, entries);
  if (has_own_file) add(jobs.back(), discarding);
}

}  // namespace clipc
