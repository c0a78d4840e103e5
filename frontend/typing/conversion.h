// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "frontend/typing/names.h"
#include "ir/builder.h"

// HLSL's conversions. Source: Microsoft's "Casting and conversion" and the X3017, X3020, X3206
// error pages; DXC's overload ranking where fxc's is not documented.
namespace clipc::typing {

// The rank of the conversion of an argument of one type to a parameter of another; smaller is
// better, compared member by member. The order of the members and of the kinds is DXC's
// (HLSLExternalSource::ScoreCast), which follows fxc.
struct ConversionRank {
  // 1 if components are dropped, otherwise 0.
  std::uint8_t truncation = 0;
  // The difference of the component kinds:
  //   0  not at all
  //   1  a promotion: half to float
  //   2  uint to int
  //   3  int to uint
  //   4  values may be lost: to int, to bool, double to float
  //   5  int or bool to float, bool to int
  std::uint8_t kind = 0;
  // 1 if a scalar fills a vector or a matrix, otherwise 0.
  std::uint8_t splat = 0;
  // 1 if one shape has two spellings, float1 and float or float4 and float2x2, otherwise 0.
  std::uint8_t form = 0;
  friend constexpr auto operator<=>(const ConversionRank&, const ConversionRank&) = default;
};

// The cost of passing one argument. The overload with the smallest sum over its arguments wins; two
// with the same sum are ambiguous. A difference in an earlier member of the rank outweighs those in
// later members of up to 127 arguments.
constexpr std::uint64_t CostOf(const ConversionRank& rank) {
  constexpr int kLevel = 7;
  const std::uint64_t kind = rank.kind == 0 ? 0 : std::uint64_t{1} << (kLevel * (rank.kind + 1));
  return rank.form + (std::uint64_t{rank.splat} << kLevel) + kind +
         (std::uint64_t{rank.truncation} << (kLevel * 7));
}

// The rank of the conversion of a value of `from` to `to` without a cast; nullopt if there is none.
std::optional<ConversionRank> RankImplicit(const TypeTable& types, TypeId from, TypeId to);
// Whether a cast (to)e is allowed.
bool IsExplicitlyConvertible(const TypeTable& types, TypeId from, TypeId to);

// A maker of local variables for values that must be read several times.
class TemporaryMaker {
 public:
  struct Temporary {
    VarId var;        // each use is a new VarRef to it
    ExprId prologue;  // `var = value`, to be evaluated before any use
  };
  // Makes a local variable that holds `value`, evaluated once.
  virtual Temporary Make(ExprId value) = 0;

 protected:
  ~TemporaryMaker() = default;
};

// The value converted to `to`, with every step explicit in the IR. Warns of an implicit truncation
// (X3206). Requires that RankImplicit gives a rank. Some conversions read their value several
// times: one struct to another with the same leaves, float4 to float2x2. Such a value is kept in
// one of `temporaries`; without them it must be a plain path (reread.h), and anything else is
// reported as an error.
ExprId ConvertImplicit(Program& program, ExprId value, TypeId to, Diagnostics& diagnostics,
                       TemporaryMaker* temporaries = nullptr);
// The value cast to `to`. A cast does what ConvertImplicit does, fills a struct or an array with a
// scalar, and makes a struct or an array of the first leaves of a vector, a struct or an array.
// Requires IsExplicitlyConvertible.
ExprId ConvertExplicit(Program& program, ExprId value, TypeId to, TemporaryMaker& temporaries);

// Gives this use of a Direct3D 9 `sampler` the kind of sampler that it needs; SettleSamplers makes
// the variables that the uses need. A sampler that has a kind keeps it.
void SetSamplerKind(Program& program, ExprId object, ObjectKind kind);

// The component kind that an operator with two operands computes in.
Scalar CommonKind(Scalar left, Scalar right);
// The common type of two operands of a component-wise operator: the larger vector is truncated, a
// scalar is splatted, kinds promote bool < int < uint < half < float < double. Two bools stay bool:
// arithmetic operators make them int. Returns nullopt for operands without a common type: different
// structs, objects, a matrix and a vector that do not fit.
std::optional<TypeId> CommonType(TypeTable& types, TypeId left, TypeId right);

inline constexpr std::size_t kMaxLeaves = 4096;
// The kinds of the scalars that a type is made of, in order, for casts, initialisers and the
// equality of structures; nullopt for a type that holds objects or has more than kMaxLeaves.
std::optional<std::vector<Scalar>> Flatten(const TypeTable& types, TypeId type);

}  // namespace clipc::typing
