// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/signature/signature_leaves.h"

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/spelling.h"

namespace clipc::signature {

namespace {

constexpr std::string_view kCentroidSuffix = "_centroid";

std::string Spelled(const SemanticName& semantic) {
  return fmt::format("{}{}", semantic.name, semantic.index);
}

// The interpolation of a field of a struct: `nointerpolation` on either comes first, as in vkd3d's
// nointerpolation.shader_test, which passes on Microsoft's compiler.
Interpolation Joined(Interpolation whole, Interpolation field) {
  for (const auto kind : {Interpolation::kNoInterpolation, Interpolation::kNoPerspective}) {
    if (whole == kind || field == kind) return kind;
  }
  return field == Interpolation::kDefault ? whole : field;
}

}  // namespace

SignatureLeaves::SignatureLeaves(Program& program, Builder& builder, Diagnostics& diagnostics)
    : program_(program), builder_(builder), diagnostics_(diagnostics) {
  leaves_.reserve(16);
  parts_.reserve(16);
}

std::span<const Carrier> SignatureLeaves::Of(const Carrier& whole) {
  leaves_.clear();
  Cursor cursor = whole.cursor;
  is_too_large_ = false;
  Collect(whole, cursor);
  if (is_too_large_)
    diagnostics_.Report(whole.span, diag::SignatureTooLarge, whole.name, kMaxLeaves);
  return leaves_;
}

// Adds the leaves of the piece, with the semantics that `cursor` gives them and moves past.
void SignatureLeaves::Collect(const Carrier& piece, Cursor& cursor) {
  const Type type = program_.types[piece.type];
  switch (type.kind) {
    case TypeKind::kError: return;
    case TypeKind::kScalar:
    case TypeKind::kVector: CollectLeaf(piece, cursor); return;
    case TypeKind::kMatrix:
    case TypeKind::kArray:
    case TypeKind::kStruct: break;
    default:
      if (takes_objects_ && type.kind == TypeKind::kObject) return leaves_.push_back(piece);
      diagnostics_.Report(
          piece.span, diag::SemanticOnObject, piece.name, program_.types.Name(piece.type),
          AdviceForObject(program_.types.Name(piece.type), program_.stage, program_.profile));
      return;
  }
  // A matrix takes a register for each column, or for each row if it is `row_major`, in fxc, as
  // in vkd3d's test of matrix semantics, which passes on Microsoft's compiler.
  const bool by_column = type.kind == TypeKind::kMatrix && !piece.row_major && !by_row_;
  const std::uint32_t count = by_column ? type.columns : program_.types.PartCount(piece.type);
  for (std::uint32_t i = 0; i < count && !is_too_large_; ++i) {
    Carrier inner = piece;
    inner.type = by_column ? program_.types.Vector(type.scalar, type.rows)
                           : program_.types.PartType(piece.type, i);
    inner.part = Inside(piece.part, i, by_column ? type.columns : std::uint8_t{0});
    if (type.kind == TypeKind::kArray) inner.elements += fmt::format("[{}]", i);
    if (type.kind == TypeKind::kStruct)
      CollectField(inner, program_.types[type.structure].fields[i], cursor);
    else
      Collect(inner, cursor);
  }
}

PartNumber SignatureLeaves::Whole(VarId variable) {
  parts_.push_back({0, kNoPart, variable});
  return parts_.size() - 1;
}

PartNumber SignatureLeaves::Inside(PartNumber whole, std::uint32_t number, std::uint8_t columns) {
  parts_.push_back({number, whole, {}, columns});
  return parts_.size() - 1;
}

ExprId SignatureLeaves::ValueOf(PartNumber number) {
  const Part part = parts_[number];
  if (part.variable) return builder_.Ref(part.variable);
  const ExprId whole = ValueOf(part.whole);
  return part.columns > 0 ? builder_.At(Transposed(whole), part.number)
                          : builder_.Part(whole, part.number);
}

void SignatureLeaves::CollectField(Carrier& piece, const Field& field, Cursor& cursor) {
  piece.name += "." + field.name;
  piece.span = field.span;
  piece.row_major = field.row_major;
  Cursor own = CursorOf(field);
  own.precise |= cursor.precise;
  // dxc takes the words of the field alone where it has some. Those of the whole say nothing about
  // integers in it.
  const bool has_own = own.interpolation != Interpolation::kDefault || own.sample || own.centroid;
  const Type& innermost = program_.types[program_.types.Innermost(field.type)];
  const bool holds_integers = innermost.IsNumeric() && !IsFloat(innermost.scalar);
  if (!holds_integers && (!has_own || !program_.profile.IsAtLeast(6, 0))) {
    own.interpolation = Joined(cursor.interpolation, own.interpolation);
    own.sample |= cursor.sample;
    own.centroid |= cursor.centroid;
  }
  own.centroid &= !own.sample && own.interpolation != Interpolation::kNoInterpolation;
  if (!own.location) own.location = cursor.location;
  if (!own.blend_index) own.blend_index = cursor.blend_index;
  if (cursor.given) Override(own, cursor, piece.name);
  Collect(piece, own);
  if (cursor.given) cursor.semantic = own.semantic;
  if (cursor.location) cursor.location = own.location;
}

// Overrides the semantic of a field by the semantic on the struct as a whole (DXC: "semantic
// override"). This does not change the interpolation of the field.
void SignatureLeaves::Override(Cursor& field, const Cursor& whole, const std::string& name) {
  const bool differs = !EqualIgnoringCase(field.semantic.name, whole.semantic.name) ||
                       field.semantic.index != whole.semantic.index;
  if (field.given && differs)
    diagnostics_.Report(field.span, diag::SemanticOverridden, name, Spelled(whole.semantic),
                        Spelled(field.semantic));
  field.semantic = whole.semantic;
  field.span = whole.span;
  field.given = true;
}

void SignatureLeaves::CollectLeaf(const Carrier& piece, Cursor& cursor) {
  is_too_large_ = leaves_.size() == kMaxLeaves;
  if (is_too_large_) return;
  // fxc refuses an input or output without a semantic (X3502); Slang names it after itself, and
  // nothing wrong can come of it.
  if (!cursor.given) {
    cursor.semantic = SplitSemantic(piece.name.substr(piece.name.rfind('.') + 1));
    cursor.given = cursor.assumed = true;
    without_semantic_.push_back(piece);
    without_semantic_.back().cursor = cursor;
  }
  // Direct3D 9's `TEXCOORD3_centroid` is TEXCOORD3 at the centroid ("Semantics" of Microsoft's HLSL
  // reference).
  const std::string& name = cursor.semantic.name;
  if (program_.profile.IsDirect3D9() && ToLower(name).ends_with(kCentroidSuffix)) {
    cursor.semantic = SplitSemantic(name.substr(0, name.size() - kCentroidSuffix.size()));
    cursor.centroid = true;
  }
  Carrier& leaf = leaves_.emplace_back(piece);
  leaf.cursor = cursor;
  leaf.cursor.sample &= cursor.interpolation != Interpolation::kNoInterpolation;
  if (cursor.span) leaf.span = cursor.span;
  ++cursor.semantic.index;
  if (cursor.location) ++*cursor.location;
}

void SignatureLeaves::ReportMissing() const {
  if (without_semantic_.empty()) return;
  const Carrier& first = without_semantic_.front();
  Diagnostic& report = diagnostics_.Report(first.span, diag::SemanticMissing, first.name,
                                           Spelled(first.cursor.semantic));
  for (const Carrier& other : std::span(without_semantic_).subspan(1))
    report.Note(other.span, diag::PlainNote,
                fmt::format("`{}` has none either; clipc assumes `{}`", other.name,
                            Spelled(other.cursor.semantic)));
}

ExprId SignatureLeaves::Transposed(ExprId matrix) {
  const Type type = program_.types[builder_.TypeOf(matrix)];
  return builder_.IntrinsicOf(CommonIntrinsic::kTranspose,
                              program_.types.Matrix(type.scalar, type.columns, type.rows),
                              {matrix});
}

}  // namespace clipc::signature
