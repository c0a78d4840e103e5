// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>

#include "frontend/check/checker.h"
#include "frontend/check/clip_planes.h"

// Functions: their signatures, overload sets and bodies.
namespace clipc {
namespace {

std::uint64_t KeyOf(SymbolId symbol, ir::TypeId self) {
  return std::uint64_t{symbol.index} << 32 | self.index;
}

}  // namespace

const ast::FunctionDecl& Checker::DeclOf(const FunctionInfo& info) const {
  return std::get<ast::FunctionDecl>(file_.decls[info.decl].node);
}

// A function, or a method for objects of type `self`.
FunctionInfoId Checker::InfoOfFunction(SymbolId id, ir::TypeId self) {
  // A static method is the same one for all that derive from its struct.
  const auto& written = std::get<ast::FunctionDecl>(file_.decls[symbols_[id].decl].node);
  if (written.qualifiers & ast::kStatic) self = {};
  const auto [slot, is_new] = function_of_.try_emplace(KeyOf(id, self));
  if (!is_new) return slot->second;
  const FunctionInfoId result{static_cast<std::uint32_t>(functions_.size())};
  slot->second = result;
  const Symbol& symbol = symbols_[id];
  const Scope& scope = scopes_[symbol.scope];
  FunctionInfo info;
  info.decl = symbol.decl;
  info.scope = symbol.scope;
  const bool is_method = scope.kind == ScopeKind::kStruct;
  info.order = is_method ? scope.order : id.index + 1;
  info.declared = is_method ? 0 : id.index;
  if (is_method && !(DeclOf(info).qualifiers & ast::kStatic)) info.self = self ? self : scope.self;
  functions_.push_back(info);
  return result;
}

void Checker::ResolveSignature(FunctionInfoId id) {
  FunctionInfo& info = Info(id);
  if (info.is_resolved) return;
  info.is_resolved = true;
  const ContextSwitch in(
      *this, {.scope = info.scope, .order = info.order, .local_floor = symbols_.size()});
  const ast::FunctionDecl& decl = DeclOf(info);
  info.return_type = ArrayOf(ResolveType(decl.return_type), decl.return_dimensions, decl.name_span);
  if (info.return_type == program_.types.Error()) info.is_broken = true;
  std::vector<Parameter> parameters;
  for (std::uint32_t i = 0; i < decl.parameters.size; ++i) {
    const ast::DeclId parameter = file_.decl_lists[decl.parameters][i];
    AddParameter(std::get<ast::VarDecl>(file_.decls[parameter].node), parameter, info, parameters);
  }
  info.parameters = parameters_.Add(std::span<const Parameter>(parameters));
  if (info.self && !decl.body) FindOutOfLine(info);
  if (info.self) info.changes_self = MayChangeSelf(DeclOf(info), info.scope);
}

void Checker::AddParameter(const ast::VarDecl& var, ast::DeclId id, FunctionInfo& info,
                           std::vector<Parameter>& parameters) {
  Parameter parameter;
  parameter.decl = id;
  parameter.type = ResolveVarType(var);
  const bool out = (var.qualifiers & ast::kOut) != 0;
  const bool in = (var.qualifiers & ast::kIn) != 0;
  parameter.storage = !out ? ir::Storage::kIn : in ? ir::Storage::kInOut : ir::Storage::kOut;
  if (parameter.type == program_.types.Error()) info.is_broken = true;
  if (var.init) {
    parameter.with_default = id;
  } else {
    info.required = static_cast<std::uint32_t>(parameters.size()) + 1;
  }
  parameters.push_back(parameter);
}

// The definition of a method that its struct only declares: `float S::f() {...}`.
void Checker::FindOutOfLine(FunctionInfo& info) {
  const auto found = out_of_line_.find(DeclOf(info).name.index);
  if (found == out_of_line_.end()) return;
  for (ast::DeclId id : found->second) {
    const auto& decl = std::get<ast::FunctionDecl>(file_.decls[id].node);
    if (decl.parameters.size != info.parameters.size || !decl.body) continue;
    const ContextSwitch in(*this, {.scope = global_scope_});
    const SymbolId owner = Find(decl.out_of_line_of, true);
    if (!owner || ScopeOf(owner) != info.scope) continue;
    bool same = true;
    std::vector<Parameter> parameters(parameters_[info.parameters].begin(),
                                      parameters_[info.parameters].end());
    const ContextSwitch in_struct(
        *this, {.scope = info.scope, .order = info.order, .local_floor = symbols_.size()});
    for (std::uint32_t i = 0; i < decl.parameters.size && same; ++i) {
      parameters[i].decl = file_.decl_lists[decl.parameters][i];
      same = ResolveVarType(std::get<ast::VarDecl>(file_.decls[parameters[i].decl].node)) ==
             parameters[i].type;
    }
    if (!same) continue;
    info.decl = id;
    info.order = ~0u;  // its body stands later than the struct
    info.parameters = parameters_.Add(std::span<const Parameter>(parameters));
    return;
  }
}

bool Checker::SameParameters(const FunctionInfo& a, const FunctionInfo& b) const {
  return std::ranges::equal(parameters_[a.parameters], parameters_[b.parameters],
                            [](const Parameter& x, const Parameter& y) {
                              return x.type == y.type && x.storage == y.storage;
                            });
}

// The parameters, so that equal ones have equal keys.
std::string Checker::ParameterKey(const FunctionInfo& info) const {
  std::string key;
  for (const Parameter& parameter : parameters_[info.parameters]) {
    key += fmt::format("{}:{},", static_cast<int>(parameter.storage), parameter.type.index);
  }
  return key;
}

// Prototypes and their definition are one overload: the one with the body, which learns what the
// other says.
FunctionInfoId Checker::MergeOverloads(FunctionInfoId known, FunctionInfoId added) {
  FunctionInfo& info = Info(added);
  FunctionInfo& other = Info(known);
  const ast::FunctionDecl& decl = DeclOf(info);
  const ast::FunctionDecl& other_decl = DeclOf(other);
  if (decl.body && other_decl.body) {
    diagnostics_.Report(decl.name_span, diag::FunctionRedefinition, SignatureText(info))
        .Note(other_decl.name_span, diag::DeclaredHere, Text(decl.name));
  } else if (info.return_type != other.return_type) {
    diagnostics_
        .Report(decl.name_span, diag::ReturnTypeDiffers, SignatureText(info),
                TypeName(info.return_type), TypeName(other.return_type))
        .Note(other_decl.name_span, diag::DeclaredHere, Text(decl.name));
  }
  FunctionInfo& kept = decl.body ? info : other;
  const FunctionInfo& dropped = decl.body ? other : info;
  for (std::uint32_t i = 0; i < kept.parameters.size; ++i) {
    Parameter& parameter = parameters_[kept.parameters][i];
    if (!parameter.with_default)
      parameter.with_default = parameters_[dropped.parameters][i].with_default;
  }
  kept.required = std::min(kept.required, dropped.required);
  kept.declared = std::min(kept.declared, dropped.declared);
  return decl.body ? added : known;
}

// All functions of the name and scope of `first`, declared so far or not; templates are not among
// them.
std::vector<FunctionInfoId> Checker::OverloadsOf(SymbolId first, ir::TypeId self) {
  const Symbol& symbol = symbols_[first];
  const SymbolId newest =
      by_scope_and_name_.at(std::uint64_t{symbol.scope.index} << 32 | symbol.name.index);
  const std::uint64_t key = KeyOf(newest, self);
  if (const auto known = overloads_.find(key); known != overloads_.end()) return known->second;
  std::vector<SymbolId> symbols;
  for (SymbolId id = newest; id; id = symbols_[id].older) {
    if (symbols_[id].kind != SymbolKind::kFunction) continue;
    if (std::get<ast::FunctionDecl>(file_.decls[symbols_[id].decl].node).is_template) continue;
    symbols.push_back(id);
  }
  std::vector<FunctionInfoId> overloads;
  std::unordered_map<std::string, std::size_t> by_parameters;
  for (auto id = symbols.rbegin(); id != symbols.rend(); ++id) {
    const FunctionInfoId added = InfoOfFunction(*id, self);
    ResolveSignature(added);
    if (symbols.size() == 1) {
      overloads.push_back(added);
      break;
    }
    const std::string parameters =
        Info(added).is_broken ? fmt::format("broken {}", added.index) : ParameterKey(Info(added));
    const auto [slot, is_new] = by_parameters.emplace(parameters, overloads.size());
    if (is_new)
      overloads.push_back(added);
    else
      overloads[slot->second] = MergeOverloads(overloads[slot->second], added);
  }
  overloads_.emplace(key, overloads);
  return overloads;
}

std::string Checker::SignatureText(const FunctionInfo& info) const {
  std::string text(Text(DeclOf(info).name));
  text += '(';
  bool first = true;
  for (const Parameter& parameter : parameters_[info.parameters]) {
    if (!first) text += ", ";
    first = false;
    if (parameter.storage == ir::Storage::kOut) text += "out ";
    if (parameter.storage == ir::Storage::kInOut) text += "inout ";
    text += TypeName(parameter.type);
  }
  return text + ')';
}

// The function in the program; its body waits to be checked.
ir::FunctionId Checker::Reach(FunctionInfoId id) {
  FunctionInfo& info = Info(id);
  if (info.function) return info.function;
  const ast::FunctionDecl& decl = DeclOf(info);
  ir::Function function;
  function.name = Text(decl.name);
  function.return_type = info.return_type;
  function.span = decl.name_span;
  if (info.self) {
    const ir::Storage storage = info.changes_self ? ir::Storage::kInOut : ir::Storage::kIn;
    ir::Var self;
    self.name = "self";
    self.type = info.self;
    self.storage = storage;
    self.span = decl.name_span;
    function.parameters.push_back(program_.vars.Add(std::move(self)));
    if (!info.changes_self) MarkConst(function.parameters.back());
  }
  for (const Parameter& parameter : parameters_[info.parameters]) {
    const auto& var = std::get<ast::VarDecl>(file_.decls[parameter.decl].node);
    const Span span = var.name ? var.name_span : file_.decls[parameter.decl].span;
    const ir::VarId added =
        AddVar(var.name ? var.name : Name{}, parameter.type, parameter.storage, span);
    if (!var.name) program_.vars[added].name = "unused";
    program_.vars[added].precise = (var.qualifiers & ast::kPrecise) != 0;
    if ((var.qualifiers & ast::kConst) && parameter.storage == ir::Storage::kIn) MarkConst(added);
    function.parameters.push_back(added);
  }
  function.body = At(decl.name_span).BlockOf({});
  info.function = program_.functions.Add(std::move(function));
  if (decl.body) waiting_.push_back(id);
  return info.function;
}

void Checker::CheckBodies() {
  for (std::size_t i = 0; i < waiting_.size() && !diagnostics_.TooManyErrors(); ++i)
    CheckBody(waiting_[i]);
}

void Checker::CheckBody(FunctionInfoId id) {
  const FunctionInfo info = Info(id);
  const ast::FunctionDecl& decl = DeclOf(info);
  const ir::Function& function = program_.functions[info.function];
  const std::vector<ir::VarId> vars = function.parameters;
  Body body;
  body.function = info.function;
  body.return_type = info.return_type;
  const ContextSwitch in(
      *this,
      {.scope = info.scope, .order = info.order, .local_floor = symbols_.size(), .body = &body});
  const int errors_before = diagnostics_.error_count();
  if (info.function != program_.entry) CheckUnusedClipPlanes(file_, decl, diagnostics_);
  const LocalScope parameter_scope(*this);
  std::size_t next = 0;
  if (info.self) body.self = vars[next++];
  for (const Parameter& parameter : std::vector<Parameter>(parameters_[info.parameters].begin(),
                                                           parameters_[info.parameters].end())) {
    const auto& var = std::get<ast::VarDecl>(file_.decls[parameter.decl].node);
    const SymbolId symbol =
        DeclareLocal(SymbolKind::kVariable, var.name, parameter.decl, var.name_span);
    symbols_[symbol].value = vars[next++].index;
    symbols_[symbol].resolution = Resolution::kDone;
  }
  const std::size_t mark = stmts_.size();
  {
    const LocalScope body_scope(*this);
    CheckStmts(std::get<ast::BlockStmt>(file_.stmts[decl.body].node).body);
  }
  std::vector<ir::StmtId> stmts = std::move(body.hoisted);
  stmts.insert(stmts.end(), stmts_.begin() + static_cast<std::ptrdiff_t>(mark), stmts_.end());
  stmts_.resize(mark);
  const ir::StmtId block = At(file_.stmts[decl.body].span).BlockOf(stmts);
  program_.functions[info.function].body = block;
  const bool is_whole = diagnostics_.error_count() == errors_before;
  if (is_whole && info.return_type != program_.types.Void() && FallsThrough(block)) {
    diagnostics_.Report(decl.name_span, diag::NotAllPathsReturn, Text(decl.name),
                        TypeName(info.return_type));
  }
}

// Functions may not call themselves, through others either.
void Checker::CheckRecursion() {
  std::vector<std::vector<CallEdge>> calls(program_.functions.size());
  for (const CallEdge& edge : calls_) calls[edge.caller.index].push_back(edge);
  enum : std::uint8_t { kNew, kOpen, kDone };
  std::vector<std::uint8_t> state(program_.functions.size(), kNew);
  struct Step {
    std::uint32_t function;
    std::size_t next;
  };
  std::vector<Step> path;
  for (std::uint32_t start = 0; start < calls.size(); ++start) {
    if (state[start] != kNew) continue;
    path.push_back({start, 0});
    state[start] = kOpen;
    while (!path.empty()) {
      Step& step = path.back();
      if (step.next == calls[step.function].size()) {
        state[step.function] = kDone;
        path.pop_back();
        continue;
      }
      const CallEdge& edge = calls[step.function][step.next++];
      if (state[edge.callee.index] == kOpen) {
        const ir::Function& callee = program_.functions[edge.callee];
        diagnostics_.Report(edge.span, diag::Recursion, callee.name)
            .Note(callee.span, diag::DeclaredHere, callee.name);
      } else if (state[edge.callee.index] == kNew) {
        state[edge.callee.index] = kOpen;
        path.push_back({edge.callee.index, 0});
      }
    }
  }
}

}  // namespace clipc
