// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/clip_planes.h"

#include <algorithm>
#include <optional>

#include "base/overloaded.h"
#include "base/spelling.h"
#include "clip-table/vocabulary.h"
#include "frontend/check/entry.h"
#include "frontend/check/expr.h"
#include "frontend/check/function.h"
#include "frontend/check/global.h"
#include "frontend/check/scope.h"
#include "frontend/check/text.h"
#include "frontend/parse/attributes.h"
#include "frontend/signature/build_main.h"
#include "frontend/typing/constant.h"
#include "ir/packing.h"

namespace clipc::check {
namespace {

// The place of one float of a plane: a byte of a cbuffer, or of one element of an array of
// ConstantBuffers.
struct Address {
  CbufferId cbuffer;
  std::uint32_t element = 0;
  std::uint32_t byte = 0;
  friend bool operator==(const Address&, const Address&) = default;
};
using Addresses = std::vector<Address>;

// A path through a cbuffer.
struct Path {
  Address at;              // the address of its first component
  bool row_major = false;  // whether matrices at its end lie row by row
  // Whether the next index chooses one of an array of buffers.
  bool of_constant_buffer_array = false;
  std::uint32_t column_step = 4;  // bytes between the components of a vector at its end

  Address Component(std::uint32_t row, std::uint32_t column) const {
    Address address = at;
    address.byte += row_major ? 16 * row + 4 * column : 16 * column + 4 * row;
    return address;
  }
};

// One operand of the attribute, followed through the IR to the constants that its four components
// are.
class Operand {
 public:
  Operand(Context& context, std::string_view text) : context_(context), text_(text) {}

  // Returns the addresses of the components; nullopt after an error, which was reported.
  std::optional<Addresses> Components(ExprId id) {
    if (const auto* swizzle = context_.GetIf<Swizzle>(id)) {
      const auto base = Components(swizzle->base);
      if (!base) return std::nullopt;
      Addresses chosen;
      for (int i = 0; i < swizzle->count; ++i) chosen.push_back((*base)[swizzle->components[i]]);
      return chosen;
    }
    if (const auto* construct = context_.GetIf<Construct>(id)) {
      Addresses all;
      for (ExprId argument : context_[construct->arguments]) {
        const auto part = Components(argument);
        if (!part) return std::nullopt;
        all.insert(all.end(), part->begin(), part->end());
      }
      return all;
    }
    const std::uint32_t columns = std::max<std::uint32_t>(context_.TypeOf(id).columns, 1);
    if (const auto* splat = context_.GetIf<Splat>(id)) {
      const auto one = Components(splat->operand);
      return one ? std::optional(Addresses(columns, one->front())) : std::nullopt;
    }
    const auto* matrix = context_.GetIf<MatrixSwizzle>(id);
    const auto path = Follow(matrix ? matrix->base : id);
    if (!path) return std::nullopt;
    Addresses all;
    all.reserve(columns);
    for (std::uint32_t i = 0; i < columns; ++i) {
      all.push_back(matrix ? path->Component(matrix->rows[i], matrix->columns[i]) : path->at);
      if (!matrix) all.back().byte += i * path->column_step;
    }
    return all;
  }

 private:
  std::nullopt_t Refuse(Span span, const diag::Kind<std::string_view>& kind) {
    context_.Report(span, kind, text_);
    return std::nullopt;
  }

  std::optional<Path> Follow(ExprId id) {
    const Expr& expr = context_[id];
    return Visit(Overloaded{
                     [&](const VarRef& ref) { return OfVariable(ref.var, expr.span); },
                     [&](const FieldRef& field) { return OfField(field); },
                     [&](const Index& index) { return OfIndex(index); },
                     [&](const auto&) -> std::optional<Path> {
                       return Refuse(expr.span, diag::ClipPlaneNotConstantBufferMember);
                     },
                 },
                 expr.node);
  }

  std::optional<Path> OfVariable(VarId id, Span span) {
    const Var& var = context_[id];
    if (var.storage == Storage::kConstant)
      return Refuse(span, diag::ClipPlaneNotConstantBufferMember);
    std::string_view reason = "is not a member of a cbuffer";
    if (var.storage == Storage::kUniform) {
      const Cbuffer& buffer = context_[var.cbuffer];
      const auto member = std::ranges::find(buffer.members, id, &CbufferMember::var);
      if (buffer.kind == CbufferKind::kTbuffer)
        reason = "is a member of a tbuffer";
      else if (member != buffer.members.end())
        return Path{{var.cbuffer, 0, member->offset}, var.row_major, buffer.count != 1};
    }
    context_.Report(span, diag::ClipPlaneNotInCbuffer, var.name, reason)
        .Note(var.span, diag::DeclaredHere, var.name);
    return std::nullopt;
  }

  std::optional<Path> OfField(const FieldRef& field) {
    auto path = Follow(field.base);
    if (!path) return std::nullopt;
    const StructId structure = context_.TypeOf(field.base).structure;
    path->at.byte += FieldOffset(context_.program.types, structure, field.field);
    path->row_major = context_[structure].fields[field.field].row_major;
    return path;
  }

  // Returns the path to an element. The index is in bounds: CheckExpr reports others (X3504).
  std::optional<Path> OfIndex(const Index& index) {
    auto path = Follow(index.base);
    if (!path) return std::nullopt;
    const TypeId base_type = context_.TypeIdOf(index.base);
    const auto value = EvaluateInteger(context_.program, index.index);
    if (!value) return Refuse(context_[index.index].span, diag::ClipPlaneIndexNotConstant);
    const auto position = static_cast<std::uint32_t>(*value);
    switch (context_[base_type].kind) {
      case TypeKind::kArray:
        if (std::exchange(path->of_constant_buffer_array, false))
          path->at.element = position;
        else
          path->at.byte +=
              position * ArrayStride(context_.program.types, base_type, path->row_major);
        break;
      case TypeKind::kMatrix:
        path->at = path->Component(position, 0);
        path->column_step = path->row_major ? 4 : 16;
        break;
      default: path->at.byte += position * path->column_step;
    }
    return path;
  }

  Context& context_;
  std::string_view text_;
};

bool IsWholeRegister(const Addresses& components) {
  if (components.front().byte % 16 != 0) return false;
  for (std::uint32_t i = 0; i < components.size(); ++i) {
    Address expected = components.front();
    expected.byte += 4 * i;
    if (components[i] != expected) return false;
  }
  return true;
}

bool IsClipPlanes(const Context& context, const ast::Attr& attr) {
  return MeaningOfAttribute(context[attr.name]) == AttributeMeaning::kClipPlanes;
}

bool ReportIfMisspelt(Context& context, const ast::Attr& attr) {
  if (MeaningOfAttribute(context[attr.name]) != AttributeMeaning::kLikeClipPlanes) return false;
  context.Report(attr.name_span, diag::ClipPlanesMisspelt, context[attr.name])
      .Fix(attr.name_span, std::string(kClipPlanesAttribute));
  return true;
}

void ReachNames(Context& context, ast::ExprId id) {
  Visit(Overloaded{
            [&](const ast::NameExpr& e) {
              const SymbolId symbol = Find(context, e.name);
              if (symbol && context[symbol].kind == SymbolKind::kVariable)
                ResolveVar(context, symbol);
            },
            [&](const ast::MemberExpr& e) { ReachNames(context, e.base); },
            [&](const ast::IndexExpr& e) { ReachNames(context, e.base); },
            [&](const ast::CallExpr& e) {
              for (ast::ExprId argument : context[e.arguments]) ReachNames(context, argument);
            },
            [](const auto&) {},
        },
        context[id].node);
}

// The `[clipplanes]` that is in effect; null for a function without one, and after an error, which
// was reported.
const ast::Attr* TheAttribute(Context& context, const AttributeLists& lists) {
  const ast::Attr* first = nullptr;
  for (const std::span<const ast::Attr>& attributes : lists) {
    const bool is_prototype = &attributes != &lists.front();
    for (const ast::Attr& attr : attributes) {
      if (!IsClipPlanes(context, attr)) continue;
      if (!first) {
        first = &attr;
      } else if (!is_prototype) {
        context.Report(attr.span, diag::ClipPlanesTwice).Note(first->span, diag::FirstGivenHere);
        return nullptr;
      } else if (OperandsAsText(context, *first) != OperandsAsText(context, attr)) {
        context.Report(first->span, diag::ClipPlanesDisagree).Note(attr.span, diag::FirstGivenHere);
        return nullptr;
      }
    }
  }
  return first;
}

// Checks the demands of clip planes on the rest of the shader. Returns false after an error.
bool CheckSurroundings(Context& context, const ast::Attr& attribute) {
  const Program& program = context.program;
  const std::span<const ast::ExprId> operands = context[attribute.arguments];
  const StageInfo& stage = InfoOf(program.stage);
  if (!stage.has_stage_after || stage.makes_patches || program.profile.IsDirect3D9()) {
    const bool is_direct3d9 = program.stage == Stage::kVertex;
    context.Report(attribute.span, diag::ClipPlanesProfile, program.profile.name,
                   is_direct3d9 ? "; `-T vs_4_0_level_9_1` is for the same hardware" : "");
    return false;
  }
  if (operands.empty() || operands.size() > kMaxClipPlanes) {
    const Span where = operands.empty() ? attribute.span : context[operands[kMaxClipPlanes]].span;
    context.Report(where, diag::ClipPlaneCount, operands.size(), kMaxClipPlanes);
    return false;
  }
  bool has_position = false;
  for (const IoVar& output : program.outputs) {
    if (output.builtin == Builtin::kPosition) has_position = true;
    if (output.builtin != Builtin::kClipDistance) continue;
    context.Report(attribute.span, diag::ClipPlanesWithClipDistance)
        .Note(context[output.var].span, diag::ClipDistanceWrittenHere);
    return false;
  }
  if (has_position) return true;
  Diagnostic& report = context.Report(attribute.span, diag::ClipPlanesWithoutPosition);
  if (const IoVar* position = FindPlainPosition(program)) {
    const Span span = context[position->var].span;
    report.Note(span, diag::PositionWrittenHere, position->semantic).Fix(span, "SV_Position");
  }
  return false;
}

// Whether the form of an operand is allowed. A form that no cbuffer could make right is reported
// from the text, before names are looked up.
bool IsAllowedForm(Context& context, ast::ExprId id) {
  const Span span = context[id].span;
  return Visit(Overloaded{
                   [&](const ast::NameExpr& e) {
                     const bool is_known =
                         e.name.from_global || !e.name.scopes.empty() || Find(context, e.name);
                     if (!is_known) ReportUndeclared(context, span, e.name, NameUse::kClipPlane);
                     return is_known;
                   },
                   [&](const ast::MemberExpr& e) { return IsAllowedForm(context, e.base); },
                   [&](const ast::IndexExpr& e) { return IsAllowedForm(context, e.base); },
                   [&](const ast::ErrorExpr&) { return false; },
                   [&](const ast::CallExpr& e) {
                     if (!context.Is<ast::TypeExpr>(e.callee)) {
                       context.Report(span, diag::ClipPlaneFunctionCall);
                       return false;
                     }
                     return std::ranges::all_of(context[e.arguments], [&](ast::ExprId argument) {
                       return IsAllowedForm(context, argument);
                     });
                   },
                   [&](const auto&) {
                     context.Report(span, diag::ClipPlaneNotConstantBufferMember,
                                    TextOf(context, id));
                     return false;
                   },
               },
               context[id].node);
}

void CheckOperand(Context& context, ast::ExprId operand, std::vector<Addresses>& seen) {
  if (!IsAllowedForm(context, operand)) return;
  const ExprId value = CheckExpr(context, operand);
  if (context.IsError(value)) return;
  Program& program = context.program;
  const Span span = context[operand].span;
  const std::string text = TextOf(context, operand);
  if (context.TypeIdOf(value) != program.types.Vector(Scalar::kFloat, 4)) {
    context.Report(span, diag::ClipPlaneNotFloat4, text, context.TypeName(value));
    return;
  }
  const auto components = Operand(context, text).Components(value);
  if (!components) return;
  ClipPlane plane{value, span, text, {}, 0, 0, IsWholeRegister(*components)};
  if (plane.whole_register) {
    plane.cbuffer = components->front().cbuffer;
    plane.offset = components->front().byte;
    plane.element = components->front().element;
  } else if (context.options.whole_register_planes || program.profile.level9 != Level9::kNone) {
    context.Report(span, diag::ClipPlaneNotWholeRegister, text);
    return;
  }
  if (const auto same = std::ranges::find(seen, *components); same != seen.end()) {
    const ClipPlane& first = program.clip_planes[static_cast<std::size_t>(same - seen.begin())];
    context.Report(span, diag::ClipPlaneRepeated, text).Note(first.span, diag::FirstGivenHere);
  }
  seen.push_back(*components);
  program.clip_planes.push_back(std::move(plane));
}

}  // namespace

AttributeLists AttributesOf(const Context& context, FunctionInfoId function) {
  const FunctionInfo& info = context[function];
  AttributeLists attributes{context[DeclOf(context, info).attributes]};
  for (SymbolId id = context.names.NewestIn(info.scope, DeclOf(context, info).name); id;
       id = context[id].older) {
    if (context[id].kind != SymbolKind::kFunction || context[id].decl == info.decl) continue;
    const FunctionInfoId other = context.functions.Known(id, {});
    if (other && SameParameters(context, info, context[other]))
      attributes.push_back(context[DeclOf(context, id).attributes]);
  }
  return attributes;
}

std::string OperandsAsText(const Context& context, const ast::Attr& attr) {
  std::string all;
  for (ast::ExprId operand : context[attr.arguments]) all += TextOf(context, operand) + ',';
  return all;
}

const ast::Attr* FindAttribute(const Context& context, const AttributeLists& attributes,
                               std::string_view name) {
  for (const std::span<const ast::Attr> list : attributes) {
    const auto found = std::ranges::find_if(list, [&](const ast::Attr& attribute) {
      return EqualIgnoringCase(context[attribute.name], name);
    });
    if (found != list.end()) return &*found;
  }
  return nullptr;
}

bool HasAttribute(const Context& context, const AttributeLists& attributes, std::string_view name) {
  return FindAttribute(context, attributes, name) != nullptr;
}

void ReachClipPlanes(Context& context, FunctionInfoId entry, const AttributeLists& attributes) {
  const ViewSwitch in(context, {.scope = context[entry].scope, .order = context[entry].order});
  for (std::span<const ast::Attr> list : attributes) {
    for (const ast::Attr& attr : list) {
      if (!IsClipPlanes(context, attr)) continue;
      for (ast::ExprId operand : context[attr.arguments]) ReachNames(context, operand);
    }
  }
}

void CheckClipPlanes(Context& context, FunctionInfoId entry, const AttributeLists& attributes) {
  const ViewSwitch in(context, {.scope = context[entry].scope, .order = context[entry].order});
  for (std::span<const ast::Attr> list : attributes) {
    for (const ast::Attr& attr : list) ReportIfMisspelt(context, attr);
  }
  const ast::Attr* attribute = TheAttribute(context, attributes);
  if (!attribute || !CheckSurroundings(context, *attribute)) return;
  std::vector<Addresses> seen;
  for (ast::ExprId operand : context[attribute->arguments]) CheckOperand(context, operand, seen);
}

namespace {

bool IsReached(const Context& context, ast::DeclId definition) {
  for (const FunctionInfoId id : context.functions.infos.ids()) {
    if (context[id].decl == definition && context[id].function) return true;
  }
  return false;
}

}  // namespace

void CheckUnusedClipPlanes(Context& context, const AttributeLists& of_entry) {
  for (const ast::DeclId id : context.file.decls.ids()) {
    const auto* function = context.GetIf<ast::FunctionDecl>(id);
    if (!function || function->attributes.empty()) continue;
    const std::span<const ast::Attr> attributes = context[function->attributes];
    const bool is_entry = std::ranges::any_of(of_entry, [&](std::span<const ast::Attr> list) {
      return !list.empty() && list.data() == attributes.data();
    });
    if (is_entry) continue;
    const bool has_own_shader = !IsReached(context, id) && MayBeEntry(context, *function);
    for (const ast::Attr& attr : attributes) {
      if (!ReportIfMisspelt(context, attr) && !has_own_shader && IsClipPlanes(context, attr))
        context.Report(attr.span, diag::ClipPlanesNotOnEntry, context[function->name]);
    }
  }
}

}  // namespace clipc::check
