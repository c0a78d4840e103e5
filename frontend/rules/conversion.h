// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/diagnostics.h"
#include "ir/builder.h"
#include "ir/program.h"

// HLSL's conversions. Source: Microsoft's "Casting and conversion" and the X3017, X3020, X3206
// error pages; DXC's overload ranking where fxc's is not documented.
namespace clipc {

// How well an argument of one type fits a parameter of another; smaller is better, compared member
// by member. The order of the members and of the kinds is DXC's (HLSLExternalSource::ScoreCast),
// which took it over from fxc.
struct ConversionRank {
  std::uint8_t truncation = 0;  // 1: components are dropped
  std::uint8_t kind =
      0;  // 0 same, 1 promotion (half to float), 2 uint to int, 3 int to uint, 4 lossy (to int, to
          // bool, double to float), 5 int or bool to float, bool to int
  std::uint8_t splat = 0;  // 1: a scalar fills a vector or a matrix
  std::uint8_t form =
      0;  // 1: another spelling of the same shape (float1 and float, float4 and float2x2)
  friend constexpr auto operator<=>(const ConversionRank&, const ConversionRank&) = default;
};

// The cost of passing one argument. The overload with the smallest sum over its arguments wins; two
// with the same sum are ambiguous. Sums of up to 127 arguments do not mix levels.
constexpr std::uint64_t CostOf(const ConversionRank& rank) {
  constexpr int kLevel = 7;
  const std::uint64_t kind = rank.kind == 0 ? 0 : std::uint64_t{1} << (kLevel * (rank.kind + 1));
  return rank.form + (std::uint64_t{rank.splat} << kLevel) + kind +
         (std::uint64_t{rank.truncation} << (kLevel * 7));
}

// Whether a value of `from` converts to `to` without a cast, and how well; nothing when it does
// not.
std::optional<ConversionRank> RankImplicit(const ir::TypeTable& types, ir::TypeId from,
                                           ir::TypeId to);
// Whether a cast (to)e is allowed.
bool IsExplicitlyConvertible(const ir::TypeTable& types, ir::TypeId from, ir::TypeId to);

// Makes local variables, for values that must be read several times; a use is a fresh reference to
// `var`.
class TemporaryMaker {
 public:
  // Evaluates `value` once into a new local variable. `prologue` is an expression to be evaluated
  // before any use.
  struct Temporary {
    ir::VarId var;
    ir::ExprId prologue;  // var = value
  };
  virtual Temporary Make(ir::ExprId value) = 0;

 protected:
  ~TemporaryMaker() = default;
};

// The expression converted, with every step explicit in the IR; warns of implicit truncation
// (X3206). Requires that RankImplicit succeeds. A value that must be read several times (one struct
// to another of the same members, float4 to float2x2) goes through `temporaries`; without them such
// a value must be a plain path of variables, fields and indices, anything else is reported as an
// error.
ir::ExprId ConvertImplicit(ir::Program& program, ir::ExprId value, ir::TypeId to,
                           Diagnostics& diagnostics, TemporaryMaker* temporaries = nullptr);
// As a cast: also scalar or vector to struct or array of no more components, struct to struct or
// array, flattening. Requires IsExplicitlyConvertible.
ir::ExprId ConvertExplicit(ir::Program& program, ir::ExprId value, ir::TypeId to,
                           TemporaryMaker& temporaries);

// A Direct3D 9 `sampler` learns from its first use which dimension it has: gives the variable that
// `object` names (and this use of it) that kind of sampler. Nothing happens to one that has a kind
// already.
void SetSamplerKind(ir::Program& program, ir::ExprId object, ir::ObjectKind kind);

// The kind that two operands compute in.
ir::Scalar CommonKind(ir::Scalar left, ir::Scalar right);
// The common type of two operands of a component-wise operator: the smaller vector wins (with
// truncation), a scalar is splatted, kinds promote bool < int < uint < half < float < double. Two
// bools stay bool: arithmetic operators make them int. Nothing when there is none (different
// structs, objects, or matrices and vectors that do not fit).
std::optional<ir::TypeId> CommonType(ir::TypeTable& types, ir::TypeId left, ir::TypeId right);

// The leaves of a type in order: (float4)s, float4 x[2] = {a, b, ...}, and structural equality use
// this. Fails (nothing) for types holding objects and for those of more than kMaxLeaves leaves.
inline constexpr std::size_t kMaxLeaves = 4096;
std::optional<std::vector<ir::Scalar>> Flatten(const ir::TypeTable& types, ir::TypeId type);

}  // namespace clipc
