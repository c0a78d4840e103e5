// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <limits>

#include "base/overloaded.h"
#include "base/spelling.h"
#include "frontend/check/checker.h"
#include "frontend/check/clip_planes.h"

// The entry point: finding it, its signature, its clip planes.
namespace clipc {
namespace {

// "NS::main" => {"NS", "main"}
std::vector<std::string_view> SplitQualified(std::string_view text) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t colons = text.find("::");
    if (colons != 0) parts.push_back(text.substr(0, colons));
    if (colons == std::string_view::npos) return parts;
    text.remove_prefix(colons + 2);
  }
}

}  // namespace

std::optional<Name> Checker::NameOf(std::string_view text) const {
  for (std::uint32_t i = 0; i < file_.names.size(); ++i) {
    if (file_.names[Name{i}] == text) return Name{i};
  }
  return std::nullopt;
}

// The one function that the options name: as written from global scope; a simple name that global
// scope lacks, too, when one namespace alone has it. Prototypes do not count. None after an error.
FunctionInfoId Checker::FindEntry() {
  std::vector<std::string_view> parts = SplitQualified(options_.entry);
  const auto name = NameOf(parts.back());
  std::vector<SymbolId> found;
  ScopeId scope = global_scope_;
  for (std::size_t i = 0; i + 1 < parts.size() && scope; ++i) {
    const auto part = NameOf(parts[i]);
    const SymbolId symbol = part ? FindIn(scope, *part) : SymbolId{};
    scope = symbol ? ScopeOf(symbol) : ScopeId{};
  }
  if (name && scope) found = EntriesIn(scope, *name);
  if (name && found.empty() && parts.size() == 1) {
    for (ScopeId id : scopes_.ids()) {
      if (scopes_[id].kind != ScopeKind::kNamespace) continue;
      const std::vector<SymbolId> more = EntriesIn(id, *name);
      found.insert(found.end(), more.begin(), more.end());
    }
  }
  if (found.empty()) {
    ReportNoEntry();
    return {};
  }
  if (found.size() > 1) {
    Diagnostic& report = diagnostics_.Report(symbols_[found[0]].span, diag::EntryAmbiguous,
                                             options_.entry, found.size());
    for (SymbolId id : found) report.Note(symbols_[id].span, diag::Candidate, ScopedName(id));
    return {};
  }
  // Its prototypes' default arguments and attributes belong to it.
  FunctionInfoId entry;
  for (FunctionInfoId id : OverloadsOf(found[0], {})) {
    if (Info(id).decl == symbols_[found[0]].decl) entry = id;
  }
  return entry;
}

// The functions of that name in the scope that have a body and are no template.
std::vector<SymbolId> Checker::EntriesIn(ScopeId scope, Name name) const {
  std::vector<SymbolId> found;
  for (SymbolId id = FindIn(scope, name); id; id = symbols_[id].older) {
    if (symbols_[id].kind != SymbolKind::kFunction) continue;
    const auto& decl = std::get<ast::FunctionDecl>(file_.decls[symbols_[id].decl].node);
    if (decl.body && !decl.is_template) found.push_back(id);
  }
  std::ranges::reverse(found);
  return found;
}

// "NS::main"
std::string Checker::ScopedName(SymbolId id) const {
  std::string text(Text(symbols_[id].name));
  for (ScopeId scope = symbols_[id].scope; scope && scope != global_scope_;
       scope = scopes_[scope].parent) {
    text = fmt::format("{}::{}", Text(scopes_[scope].name), text);
  }
  return text;
}

void Checker::ReportNoEntry() {
  std::vector<std::string> names;
  std::vector<Span> places;
  for (SymbolId id : symbols_.ids()) {
    if (symbols_[id].kind != SymbolKind::kFunction) continue;
    names.push_back(ScopedName(id));
    places.push_back(std::get<ast::FunctionDecl>(file_.decls[symbols_[id].decl].node).name_span);
  }
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  std::vector<std::string_view> near = NearNames(options_.entry, candidates);
  const bool has_hints = near.empty() && !file_.technique_vertex_shaders.empty();
  constexpr std::size_t kMaxHints = 5;
  for (std::size_t i = 0;
       has_hints && i < file_.technique_vertex_shaders.size() && near.size() < kMaxHints; ++i) {
    const std::string_view hint = Text(file_.technique_vertex_shaders[i]);
    if (std::ranges::find(near, hint) == near.end()) near.push_back(hint);
  }
  std::string text;
  for (std::string_view candidate : near)
    text += fmt::format("{}`{}`", text.empty() ? "" : ", ", candidate);
  const std::string tail = text.empty() ? ""
                           : has_hints  ? fmt::format("; its techniques compile {}", text)
                                        : fmt::format("; did you mean {}?", text);
  // The place of what was probably meant, or where the file's last declaration starts.
  Span where = file_.top_level.empty() ? Span{} : file_.decls[file_.top_level.back()].span;
  where.end = where.begin;
  if (!near.empty() && !has_hints)
    where = places[static_cast<std::size_t>(std::ranges::find(names, near[0]) - names.begin())];
  diagnostics_.Report(where, diag::EntryNotFound, options_.entry, tail);
}

EntrySignature Checker::SignatureOf(FunctionInfoId entry) {
  const FunctionInfo& info = Info(entry);
  const ast::FunctionDecl& decl = DeclOf(info);
  EntrySignature signature;
  for (const Parameter& parameter : std::vector<Parameter>(parameters_[info.parameters].begin(),
                                                           parameters_[info.parameters].end())) {
    const auto& var = std::get<ast::VarDecl>(file_.decls[parameter.decl].node);
    EntryParameter entry_parameter;
    entry_parameter.semantic = Text(var.semantic.name);
    entry_parameter.semantic_span = var.semantic.span;
    ReadInterpolation(var.qualifiers, entry_parameter.interpolation, entry_parameter.centroid,
                      entry_parameter.sample);
    if (var.qualifiers & ast::kUniform) {
      entry_parameter.is_uniform = true;
      entry_parameter.uniform_var = AddUniformParameter(var, parameter);
    }
    signature.parameters.push_back(std::move(entry_parameter));
  }
  signature.result.semantic = Text(decl.return_semantic.name);
  signature.result.semantic_span = decl.return_semantic.span;
  ReadInterpolation(decl.qualifiers, signature.result.interpolation, signature.result.centroid,
                    signature.result.sample);
  return signature;
}

// A `uniform` parameter of the entry point is a member of $Params, or a resource.
ir::VarId Checker::AddUniformParameter(const ast::VarDecl& var, const Parameter& parameter) {
  const SymbolId symbol =
      Declare(SymbolKind::kVariable, global_scope_, {}, parameter.decl, var.name_span);
  symbols_[symbol].resolution = Resolution::kDone;
  if (HoldsObjects(parameter.type)) {
    ResolveObject(symbol, var, parameter.type);
    return ir::VarId{symbols_[symbol].value};
  }
  const ir::VarId added = AddVar(var.name, parameter.type, ir::Storage::kUniform, var.name_span);
  program_.vars[added].row_major = IsRowMajor(QualifiersOf(var));
  MarkConst(added);
  symbols_[symbol].value = added.index;
  if (!params_buffer_) {
    Buffer buffer;
    buffer.kind = ir::CbufferKind::kParams;
    buffer.scope = global_scope_;
    buffer.order = std::numeric_limits<std::uint32_t>::max();
    buffer.resolution = Resolution::kDone;
    params_buffer_ = buffers_.Add(std::move(buffer));
  }
  buffers_[params_buffer_].members.push_back(symbol);
  return added;
}

// ---- clip planes

std::vector<std::span<const ast::Attr>> Checker::PrototypeAttributes(FunctionInfoId entry) const {
  std::vector<std::span<const ast::Attr>> attributes;
  const FunctionInfo& info = Info(entry);
  const Name name = DeclOf(info).name;
  const auto newest = by_scope_and_name_.find(std::uint64_t{info.scope.index} << 32 | name.index);
  if (newest == by_scope_and_name_.end()) return attributes;
  for (SymbolId id = newest->second; id; id = symbols_[id].older) {
    if (symbols_[id].kind != SymbolKind::kFunction || symbols_[id].decl == info.decl) continue;
    const auto other = function_of_.find(std::uint64_t{id.index} << 32 | ir::TypeId{}.index);
    if (other == function_of_.end() || !SameParameters(info, Info(other->second))) continue;
    attributes.push_back(
        file_.attrs[std::get<ast::FunctionDecl>(file_.decls[symbols_[id].decl].node).attributes]);
  }
  return attributes;
}

// The buffers that clip planes lie in are reached, whether the code reads them or not.
void Checker::ReachClipPlanes(FunctionInfoId entry) {
  std::vector<std::span<const ast::Attr>> all = PrototypeAttributes(entry);
  all.push_back(file_.attrs[DeclOf(Info(entry)).attributes]);
  const ContextSwitch in(*this, {.scope = Info(entry).scope, .order = Info(entry).order});
  for (std::span<const ast::Attr> attributes : all) {
    for (const ast::Attr& attr : attributes) {
      if (SpellsClipPlanes(Text(attr.name)) != ClipPlaneSpelling::kExact) continue;
      for (std::uint32_t i = 0; i < attr.arguments.size; ++i)
        ReachNames(file_.expr_lists[attr.arguments][i]);
    }
  }
}

void Checker::ReachNames(ast::ExprId id) {
  std::visit(Overloaded{
                 [&](const ast::NameExpr& e) {
                   const SymbolId symbol = Find(e.name);
                   if (symbol && symbols_[symbol].kind == SymbolKind::kVariable) ResolveVar(symbol);
                 },
                 [&](const ast::MemberExpr& e) { ReachNames(e.base); },
                 [&](const ast::IndexExpr& e) { ReachNames(e.base); },
                 [&](const ast::CallExpr& e) {
                   for (std::uint32_t i = 0; i < e.arguments.size; ++i)
                     ReachNames(file_.expr_lists[e.arguments][i]);
                 },
                 [](const auto&) {},
             },
             file_.exprs[id].node);
}

void Checker::CheckPlanes(FunctionInfoId entry) {
  const ContextSwitch in(*this, {.scope = Info(entry).scope, .order = Info(entry).order});
  ClipPlaneContext context{
      .file = file_,
      .attributes = file_.attrs[DeclOf(Info(entry)).attributes],
      .prototypes = PrototypeAttributes(entry),
      .check =
          [this](ast::ExprId operand) {
            const ir::ExprId value = CheckExpr(operand);
            return IsError(value) ? ir::ExprId{} : value;
          },
      .text = [this](ast::ExprId operand) { return TextOf(operand); },
      .whole_registers_only =
          options_.whole_register_planes || program_.profile.level9 != ir::Level9::kNone,
  };
  CheckClipPlanes(program_, context, diagnostics_);
}

// An expression nearly as it was written, for messages and tables.
std::string Checker::TextOf(ast::ExprId id) const {
  const auto list = [&](List<ast::ExprId> expressions) {
    std::string text;
    for (ast::ExprId expr : file_.expr_lists[expressions])
      text += (text.empty() ? "" : ", ") + TextOf(expr);
    return text;
  };
  return std::visit(
      Overloaded{
          [&](const ast::Literal& e) -> std::string {
            switch (e.kind) {
              case LiteralKind::kBool: return e.bits ? "true" : "false";
              case LiteralKind::kString:
                return fmt::format("\"{}\"", Text(Name{static_cast<std::uint32_t>(e.bits)}));
              case LiteralKind::kHalf:
              case LiteralKind::kFloat:
              case LiteralKind::kDouble: return fmt::format("{}", std::bit_cast<double>(e.bits));
              default: return fmt::format("{}", e.bits);
            }
          },
          [&](const ast::NameExpr& e) { return QualifiedText(e.name); },
          [&](const ast::TypeExpr& e) { return QualifiedText(file_.types[e.type].name); },
          [&](const ast::CallExpr& e) {
            return fmt::format("{}({})", TextOf(e.callee), list(e.arguments));
          },
          [&](const ast::IndexExpr& e) {
            return fmt::format("{}[{}]", TextOf(e.base), TextOf(e.index));
          },
          [&](const ast::MemberExpr& e) {
            return fmt::format("{}.{}", TextOf(e.base), Text(e.name));
          },
          [](const auto&) -> std::string { return "..."; },
      },
      file_.exprs[id].node);
}

}  // namespace clipc
