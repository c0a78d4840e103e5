// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/clip_planes.h"

#include <algorithm>
#include <array>
#include <optional>

#include "base/overloaded.h"
#include "base/spelling.h"
#include "clip-table/vocabulary.h"
#include "frontend/rules/constant.h"
#include "ir/packing.h"

namespace clipc {
namespace {

constexpr std::string_view kAttribute = "clipplanes";

// Where one float of a plane lies: a byte of a cbuffer, or of one element of an array of
// ConstantBuffers.
struct Address {
  ir::CbufferId cbuffer;
  std::uint32_t element = 0;
  std::uint32_t byte = 0;
  friend bool operator==(const Address&, const Address&) = default;
};

// A path through a cbuffer so far: its start and how its matrices lie.
struct Place {
  Address at;
  bool row_major = false;
  bool of_constant_buffer_array = false;  // the next index chooses a buffer, not a byte
};

std::string_view NameOf(const ast::File& file, const ast::Attr& attr) {
  return file.names[attr.name];
}

// Follows one operand through the IR and says which constant each of its four components is.
class Operand {
 public:
  Operand(const ir::Program& program, std::string_view text, Diagnostics& diagnostics)
      : program_(program), text_(text), diagnostics_(diagnostics) {}

  // Nothing after an error, which was reported.
  std::optional<std::vector<Address>> Components(ir::ExprId id) {
    const ir::Expr& expr = program_.exprs[id];
    if (const auto* swizzle = std::get_if<ir::Swizzle>(&expr.node)) {
      auto base = Components(swizzle->base);
      if (!base) return std::nullopt;
      std::vector<Address> chosen;
      for (int i = 0; i < swizzle->count; ++i) chosen.push_back((*base)[swizzle->components[i]]);
      return chosen;
    }
    if (const auto* construct = std::get_if<ir::Construct>(&expr.node)) {
      std::vector<Address> all;
      for (ir::ExprId argument : program_.expr_lists[construct->arguments]) {
        auto part = Components(argument);
        if (!part) return std::nullopt;
        all.insert(all.end(), part->begin(), part->end());
      }
      return all;
    }
    if (const auto* splat = std::get_if<ir::Splat>(&expr.node)) {
      const auto one = Components(splat->operand);
      if (!one) return std::nullopt;
      return std::vector<Address>(program_.types[expr.type].columns, one->front());
    }
    if (const auto* matrix = std::get_if<ir::MatrixSwizzle>(&expr.node)) return OfMatrix(*matrix);
    auto place = Follow(id);
    if (!place) return std::nullopt;
    return ComponentsAt(*place, expr.type);
  }

 private:
  template <typename... Args>
  std::nullopt_t Refuse(Span span, const diag::Kind<Args...>& kind,
                        const std::type_identity_t<Args>&... args) {
    diagnostics_.Report(span, kind, args...);
    return std::nullopt;
  }

  std::vector<Address> ComponentsAt(const Place& place, ir::TypeId type_id) const {
    const ir::Type& type = program_.types[type_id];
    std::vector<Address> all;
    for (std::uint32_t i = 0; i < std::max<std::uint32_t>(type.columns, 1); ++i) {
      Address address = place.at;
      address.byte += i * column_step_;
      all.push_back(address);
    }
    return all;
  }

  std::optional<std::vector<Address>> OfMatrix(const ir::MatrixSwizzle& swizzle) {
    auto place = Follow(swizzle.base);
    if (!place) return std::nullopt;
    std::vector<Address> all;
    for (int i = 0; i < swizzle.count; ++i) {
      Address address = place->at;
      address.byte += MatrixByte(*place, swizzle.rows[i], swizzle.columns[i]);
      all.push_back(address);
    }
    return all;
  }

  static std::uint32_t MatrixByte(const Place& place, std::uint32_t row, std::uint32_t column) {
    return place.row_major ? 16 * row + 4 * column : 16 * column + 4 * row;
  }

  std::optional<Place> Follow(ir::ExprId id) {
    const ir::Expr& expr = program_.exprs[id];
    column_step_ = 4;
    return std::visit(
        Overloaded{[&](const ir::VarRef& ref) { return OfVariable(ref.var, expr.span); },
                   [&](const ir::FieldRef& field) { return OfField(field); },
                   [&](const ir::Index& index) { return OfIndex(index); },
                   [&](const auto&) -> std::optional<Place> {
                     return Refuse(expr.span, diag::ClipPlaneNotConstantBufferMember, text_);
                   }},
        expr.node);
  }

  std::optional<Place> OfVariable(ir::VarId id, Span span) {
    const ir::Var& var = program_.vars[id];
    if (var.storage == ir::Storage::kConstant)
      return Refuse(span, diag::ClipPlaneNotConstantBufferMember, text_);
    if (var.storage != ir::Storage::kUniform)
      return RefuseStorage(var, span, "is not a member of a cbuffer");
    const ir::Cbuffer& buffer = program_.cbuffers[var.cbuffer];
    if (buffer.kind == ir::CbufferKind::kTbuffer)
      return RefuseStorage(var, span, "is a member of a tbuffer");
    for (const ir::CbufferMember& member : buffer.members) {
      if (member.var == id)
        return Place{{var.cbuffer, 0, member.offset}, var.row_major, buffer.count > 1};
    }
    return RefuseStorage(var, span, "is not a member of a cbuffer");
  }

  std::nullopt_t RefuseStorage(const ir::Var& var, Span span, std::string_view what) {
    auto& report = diagnostics_.Report(span, diag::ClipPlaneInNoCbuffer, var.name, what);
    report.Note(var.span, diag::DeclaredHere, var.name);
    return std::nullopt;
  }

  std::optional<Place> OfField(const ir::FieldRef& field) {
    auto place = Follow(field.base);
    if (!place) return std::nullopt;
    const ir::StructId structure = program_.types[program_.exprs[field.base].type].structure;
    place->at.byte += ir::FieldOffset(program_.types, structure, field.field);
    place->row_major = program_.types[structure].fields[field.field].row_major;
    return place;
  }

  // In bounds: CheckExpr saw to it (X3504).
  std::optional<Place> OfIndex(const ir::Index& index) {
    auto place = Follow(index.base);
    if (!place) return std::nullopt;
    const ir::TypeId base_type = program_.exprs[index.base].type;
    const ir::Type& type = program_.types[base_type];
    const auto value = EvaluateInteger(program_, index.index);
    if (!value)
      return Refuse(program_.exprs[index.index].span, diag::ClipPlaneIndexNotConstant, text_);
    const auto position = static_cast<std::uint32_t>(*value);
    if (type.kind == ir::TypeKind::kArray && place->of_constant_buffer_array) {
      place->at.element = position;
      place->of_constant_buffer_array = false;
    } else if (type.kind == ir::TypeKind::kArray) {
      place->at.byte += position * ir::ArrayStride(program_.types, base_type, place->row_major);
    } else if (type.kind == ir::TypeKind::kMatrix) {
      place->at.byte += MatrixByte(*place, position, 0);
      column_step_ = place->row_major ? 4 : 16;
    } else {
      place->at.byte += position * column_step_;
    }
    return place;
  }

  const ir::Program& program_;
  std::string_view text_;
  Diagnostics& diagnostics_;
  std::uint32_t column_step_ = 4;  // bytes between the components of the vector followed last
};

bool IsWholeRegister(const std::vector<Address>& components) {
  if (components.front().byte % 16 != 0) return false;
  for (std::uint32_t i = 0; i < components.size(); ++i) {
    Address expected = components.front();
    expected.byte += 4 * i;
    if (!(components[i] == expected)) return false;
  }
  return true;
}

class ClipPlaneChecker {
 public:
  ClipPlaneChecker(ir::Program& program, const ClipPlaneContext& context, Diagnostics& diagnostics)
      : program_(program), context_(context), diagnostics_(diagnostics) {}

  void Run() {
    const ast::Attr* attribute = TheAttribute();
    if (!attribute) return;
    if (!CheckSurroundings(*attribute)) return;
    for (ast::ExprId operand : context_.file.expr_lists[attribute->arguments])
      CheckOperand(operand);
  }

 private:
  // The one attribute that counts, or null: none, or an error.
  const ast::Attr* TheAttribute() {
    const ast::Attr* first = nullptr;
    for (const ast::Attr& attr : context_.attributes) {
      if (!IsClipPlanes(attr)) continue;
      if (first) {
        diagnostics_.Report(attr.span, diag::ClipPlanesTwice)
            .Note(first->span, diag::FirstGivenHere);
        return nullptr;
      }
      first = &attr;
    }
    for (std::span<const ast::Attr> attributes : context_.prototypes) {
      for (const ast::Attr& attr : attributes) {
        if (!IsClipPlanes(attr)) continue;
        if (first && Written(*first) != Written(attr)) {
          diagnostics_.Report(first->span, diag::ClipPlanesDisagree)
              .Note(attr.span, diag::FirstGivenHere);
          return nullptr;
        }
        if (!first) first = &attr;
      }
    }
    return first;
  }

  bool IsClipPlanes(const ast::Attr& attr) {
    return SpellsClipPlanes(NameOf(context_.file, attr)) == ClipPlaneSpelling::kExact;
  }

  std::string Written(const ast::Attr& attr) {
    std::string all;
    for (ast::ExprId operand : context_.file.expr_lists[attr.arguments])
      all += context_.text(operand) + ',';
    return all;
  }

  // What the rest of the shader must be like for any clip plane to make sense.
  bool CheckSurroundings(const ast::Attr& attribute) {
    const std::size_t count = attribute.arguments.size;
    if (!program_.profile.IsVertex() || program_.profile.IsDirect3D9()) {
      diagnostics_.Report(attribute.span, diag::ClipPlanesProfile, program_.profile.name);
      return false;
    }
    if (count == 0 || count > kMaxClipPlanes) {
      const Span where =
          count == 0
              ? attribute.span
              : context_.file.exprs[context_.file.expr_lists[attribute.arguments][kMaxClipPlanes]]
                    .span;
      diagnostics_.Report(where, diag::ClipPlaneCount, count, kMaxClipPlanes);
      return false;
    }
    bool has_position = false;
    for (const ir::IoVar& output : program_.outputs) {
      if (output.builtin == ir::Builtin::kPosition) has_position = true;
      if (output.builtin != ir::Builtin::kClipDistance) continue;
      diagnostics_.Report(attribute.span, diag::ClipPlanesWithClipDistance)
          .Note(program_.vars[output.var].span, diag::ClipDistanceWrittenHere);
      return false;
    }
    if (!has_position) diagnostics_.Report(attribute.span, diag::ClipPlanesWithoutPosition);
    return has_position;
  }

  // Forms that no cbuffer could make right get their message from the text, before names are looked
  // up.
  bool IsAllowedForm(ast::ExprId id) {
    const ast::Expr& expr = context_.file.exprs[id];
    return std::visit(
        Overloaded{
            [&](const ast::NameExpr&) { return true; },
            [&](const ast::MemberExpr& member) { return IsAllowedForm(member.base); },
            [&](const ast::IndexExpr& index) { return IsAllowedForm(index.base); },
            [&](const ast::ErrorExpr&) { return false; },
            [&](const ast::CallExpr& call) {
              if (!std::holds_alternative<ast::TypeExpr>(context_.file.exprs[call.callee].node)) {
                diagnostics_.Report(expr.span, diag::ClipPlaneFunctionCall);
                return false;
              }
              for (ast::ExprId argument : context_.file.expr_lists[call.arguments]) {
                if (!IsAllowedForm(argument)) return false;
              }
              return true;
            },
            [&](const auto&) {
              diagnostics_.Report(expr.span, diag::ClipPlaneNotConstantBufferMember,
                                  context_.text(id));
              return false;
            }},
        expr.node);
  }

  void CheckOperand(ast::ExprId operand) {
    if (!IsAllowedForm(operand)) return;
    const ir::ExprId value = context_.check(operand);
    if (!value) return;
    const Span span = context_.file.exprs[operand].span;
    const std::string text = context_.text(operand);
    const ir::TypeId type = program_.exprs[value].type;
    if (type == program_.types.Error()) return;
    if (type != program_.types.Vector(ir::Scalar::kFloat, 4)) {
      diagnostics_.Report(span, diag::ClipPlaneNotFloat4, text, program_.types.Name(type));
      return;
    }
    const auto components = Operand(program_, text, diagnostics_).Components(value);
    if (!components) return;
    AddPlane(value, span, text, *components);
  }

  void AddPlane(ir::ExprId value, Span span, const std::string& text,
                const std::vector<Address>& components) {
    ir::ClipPlane plane{value, span, text, {}, 0, 0, IsWholeRegister(components)};
    if (plane.whole_register) {
      plane.cbuffer = components.front().cbuffer;
      plane.offset = components.front().byte;
      plane.element = components.front().element;
    } else if (context_.whole_registers_only) {
      diagnostics_.Report(span, diag::ClipPlaneNotWholeRegister, text);
      return;
    }
    if (auto same = std::find(seen_.begin(), seen_.end(), components); same != seen_.end()) {
      const ir::ClipPlane& first =
          program_.clip_planes[static_cast<std::size_t>(same - seen_.begin())];
      diagnostics_.Report(span, diag::ClipPlaneRepeated, text)
          .Note(first.span, diag::FirstGivenHere);
    }
    seen_.push_back(components);
    program_.clip_planes.push_back(std::move(plane));
  }

  ir::Program& program_;
  const ClipPlaneContext& context_;
  Diagnostics& diagnostics_;
  std::vector<std::vector<Address>> seen_;
};

void ReportMisspelling(const ast::File& file, const ast::Attr& attr, Diagnostics& diagnostics) {
  diagnostics.Report(attr.name_span, diag::ClipPlanesMisspelt, NameOf(file, attr))
      .Fix(attr.name_span, std::string(kAttribute));
}

}  // namespace

ClipPlaneSpelling SpellsClipPlanes(std::string_view attribute_name) {
  if (EqualIgnoringCase(attribute_name, kAttribute)) return ClipPlaneSpelling::kExact;
  std::string bare;
  std::copy_if(attribute_name.begin(), attribute_name.end(), std::back_inserter(bare),
               [](char c) { return c != '_'; });
  return EditDistance(bare, kAttribute, 2) <= 2 ? ClipPlaneSpelling::kMisspelt
                                                : ClipPlaneSpelling::kNo;
}

void CheckClipPlanes(ir::Program& program, const ClipPlaneContext& context,
                     Diagnostics& diagnostics) {
  const auto report_misspellings = [&](std::span<const ast::Attr> attributes) {
    for (const ast::Attr& attr : attributes) {
      if (SpellsClipPlanes(NameOf(context.file, attr)) == ClipPlaneSpelling::kMisspelt) {
        ReportMisspelling(context.file, attr, diagnostics);
      }
    }
  };
  report_misspellings(context.attributes);
  for (std::span<const ast::Attr> attributes : context.prototypes) report_misspellings(attributes);
  ClipPlaneChecker(program, context, diagnostics).Run();
}

void CheckUnusedClipPlanes(const ast::File& file, const ast::FunctionDecl& function,
                           Diagnostics& diagnostics) {
  for (const ast::Attr& attr : file.attrs[function.attributes]) {
    switch (SpellsClipPlanes(NameOf(file, attr))) {
      case ClipPlaneSpelling::kNo: break;
      case ClipPlaneSpelling::kMisspelt: ReportMisspelling(file, attr, diagnostics); break;
      case ClipPlaneSpelling::kExact:
        diagnostics.Report(attr.span, diag::ClipPlanesNotOnEntry, file.names[function.name]);
        break;
    }
  }
}

}  // namespace clipc
