// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "base/kept_blocks.h"
#include "frontend/signature/names.h"
#include "frontend/signature/semantics.h"
#include "ir/builder.h"

namespace clipc::signature {

// A local variable or a part of one: a field or an element of another.
using PartNumber = std::size_t;
constexpr PartNumber kNoPart = ~PartNumber{0};
struct Part {
  std::uint32_t number = 0;    // the number of the field, element or column
  PartNumber whole = kNoPart;  // the part or variable that this is a part of
  VarId variable = {};         // none for a part
  std::uint8_t columns = 0;    // the number of columns of the matrix if this is one; else 0
};

// The semantic in force for a part of a parameter. Indices count on through arrays, matrices and
// overridden structs.
struct Cursor {
  SemanticName semantic;
  bool given = false;
  bool assumed = false;  // made of the name, since none is written
  Span span;
  Interpolation interpolation = Interpolation::kDefault;
  bool centroid = false;
  bool sample = false;
  std::optional<std::uint32_t> location, blend_index;
  bool precise = false;
};

// The cursor of a parameter, the result or a field, whose members have the same names.
template <typename Declared>
Cursor CursorOf(const Declared& declared) {
  return {SplitSemantic(declared.semantic),
          !declared.semantic.empty(),
          false,
          declared.semantic_span,
          declared.interpolation,
          declared.centroid,
          declared.sample,
          declared.location,
          declared.blend_index,
          declared.precise};
}

// A parameter, the result or something inside of one, with its place and its semantic.
struct Carrier {
  PartNumber part = kNoPart;
  TypeId type;
  std::string name;  // for messages: "input.position"
  Span span;         // of a leaf: where its semantic is written
  Cursor cursor;
  bool row_major = false;     // whether the matrices in it are taken apart by row
  std::string elements = {};  // "[1][2]" where arrays were taken apart
};

// The parts of the entry function's parameters and result, taken apart into the scalars and vectors
// that have a semantic each.
class SignatureLeaves {
 public:
  SignatureLeaves(Program& program, Builder& builder, Diagnostics& diagnostics);

  // Sets whether textures and samplers are leaves; else they are reported.
  void SetTakesObjects(bool takes_objects) { takes_objects_ = takes_objects; }
  // Sets whether all matrices are taken apart by row, row_major or not.
  void SetByRow(bool by_row) { by_row_ = by_row; }

  // The leaves of a parameter or the result, at most kMaxLeaves; reports if there are more. The
  // span is valid until the next call.
  std::span<const Carrier> Of(const Carrier& whole);
  std::size_t size() const { return leaves_.size(); }  // the size of that span
  // Reports the leaves without a semantic, in one warning.
  void ReportMissing() const;

  PartNumber Whole(VarId variable);
  // A field or an element of a part; where `columns` is not 0, a column of a matrix with so many.
  PartNumber Inside(PartNumber whole, std::uint32_t number, std::uint8_t columns = 0);
  const Part& operator[](PartNumber number) const { return parts_[number]; }
  // Returns the value of a part, a new expression in each call.
  ExprId ValueOf(PartNumber number);
  ExprId Transposed(ExprId matrix);

 private:
  void Collect(const Carrier& piece, Cursor& cursor);
  void CollectField(Carrier& piece, const Field& field, Cursor& cursor);
  void Override(Cursor& field, const Cursor& whole, const std::string& name);
  void CollectLeaf(const Carrier& piece, Cursor& cursor);

  static constexpr std::size_t kMaxLeaves = 256;

  Program& program_;
  Builder& builder_;
  Diagnostics& diagnostics_;
  KeptVector<Part> parts_;
  KeptVector<Carrier> leaves_;
  KeptVector<Carrier> without_semantic_;  // with that which is assumed
  bool by_row_ = false;
  bool takes_objects_ = false;
  bool is_too_large_ = false;  // the argument of Of has more than kMaxLeaves
};

}  // namespace clipc::signature
