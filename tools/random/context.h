// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <set>
#include <string>
#include <vector>

#include "base/not_copied.h"
#include "base/stage.h"
#include "tools/random/choices.h"
#include "tools/random/features.h"
#include "tools/random/range.h"
#include "tools/random/type.h"

// The state that the makers of expressions, statements and declarations share while a program
// grows.
namespace clipc::random {

enum class Holds : std::uint8_t { kVariable, kInput, kWild, kCounter };

struct Variable {
  std::string name;
  Type type;
  bool writable = true;
  Holds holds = Holds::kVariable;
  double greatest = 0;  // the greatest value of a kCounter, which counts from 0
};

// The indices that a place may have; kWriting has effects wherever expressions may have them.
enum class Indices : std::uint8_t { kConstant, kAny, kWriting };

enum class Direction : std::uint8_t { kIn, kOut, kInOut };
struct Parameter {
  std::string name;
  Type type;
  Direction direction = Direction::kIn;
};
struct Function {
  std::string name;
  Type result;
  bool is_void = false;
  std::vector<Parameter> parameters;
  bool writes = false;          // whether it writes parameters or static variables
  bool writes_statics = false;  // whether it, or a function that it calls, writes static variables
  int cost = 1;                 // the statements that one call runs, about
};

// The largest number of statements that one call of a function may run, about.
inline constexpr int kMostCost = 2000;

struct Context {
  Context(Choices& choices_in, const Features& features_in)
      : choices(choices_in), features(features_in) {}

  Choices& choices;
  const Features& features;
  int model = 50;  // the shader model, 51 for 5.1
  Stage stage = Stage::kVertex;

  Structs structs;
  std::vector<Function> functions;            // the functions that may be called, in order
  std::vector<std::vector<Variable>> scopes;  // the outermost first
  bool effects = true;                        // whether expressions may write
  Indices indices = Indices::kAny;            // the indices that places may have
  bool only_literals = false;                 // whether all expressions are literals
  const Function* function = nullptr;         // the function whose body is made
  int iterations = 1, cost = 0;               // the runs of a statement here; the sum of all runs
  int loops = 0;                              // loops around a statement here
  bool has_continue = true;                   // whether `continue` may be written in such a loop
  bool has_exit = true;                       // whether a statement here may end the loop it is in
  bool writes_globals = false;                // whether something here may write a global
  std::vector<std::string> taken;             // variables that may not be written a second time
  // Variables that the expression reads and writes: their order counts.
  std::set<std::string> read, written;
  int names = 0;
  int indent = 2;  // spaces before a statement here

  bool Has(Feature feature) const { return features.Has(feature); }
  // The functions below draw from the choices.
  std::uint32_t Below(std::size_t limit) { return choices.Below(limit); }
  int Between(int least, int greatest) { return choices.Between(least, greatest); }
  bool Chance(std::uint32_t percent) { return choices.Chance(percent); }
  bool Chance(Feature feature, std::uint32_t percent) { return Has(feature) && Chance(percent); }
  std::size_t Pick(std::initializer_list<std::uint32_t> weights) { return choices.Pick(weights); }
  template <typename List>
  const auto& OneOf(const List& list) {
    return choices.OneOf(list);
  }
  // A name that no other variable has; now and then a word that means something in GLSL.
  std::string FreshName(const char* prefix);
  void Add(Variable variable) { scopes.back().push_back(std::move(variable)); }
  // MayUse says whether an expression may read or write a variable, or all static ones; Use notes
  // that it does.
  bool MayUse(const Variable& variable, bool writes) const;
  void Use(const Variable& variable, bool writes);
  bool MayUseStatics(bool writes) const;
  void UseStatics(bool writes);
  void EndExpression() { read.clear(), written.clear(); }
  // The variables that are visible here, without those that others hide.
  std::vector<const Variable*> Visible() const;
};

// The range of a component of that kind in the variable.
Range RangeOf(const Variable& variable, Kind kind);

// A scope, after which the variables that are declared in it are removed.
class ScopeOf : NotCopied {
 public:
  explicit ScopeOf(Context& context) : context_(context) { context.scopes.emplace_back(); }
  ~ScopeOf() { context_.scopes.pop_back(); }

 private:
  Context& context_;
};

// A scope in which a variable has another value.
template <typename T>
class Temporarily : NotCopied {
 public:
  Temporarily(T& variable, T value) : variable_(variable), before_(variable) { variable = value; }
  ~Temporarily() { variable_ = before_; }

 private:
  T& variable_;
  T before_;
};

}  // namespace clipc::random
