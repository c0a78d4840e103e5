// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/random/loops.h"

#include <algorithm>
#include <vector>

#include "backend-glsl/target.h"

namespace clipc::random {
namespace {

constexpr int kElements = 8;  // of the array that counters index
constexpr int kMostRuns = 96;

// A program grows from statements on floats, on integers whose values are known at compile time and
// on integers whose values are not. Only the known ones are in the heads of loops, in the indices
// and under conditions that change known ones.
class LoopMaker {
 public:
  LoopMaker(Choices& choices, bool draws_pixels) : choices_(choices), draws_pixels_(draws_pixels) {}

  std::string Make() {
    std::string text = "float4 k[8];\n";
    for (int i = 0; i < 2; ++i) text += MakeFunction(i);
    text += draws_pixels_ ? "float4 main(float4 p : PLACE0) : SV_Target {\n"
                          : "float4 main(float4 p : POSITION0) : SV_Position {\n";
    text += "  float4 c = p;\n  int u = 0;\n";
    calls_ = true;
    known_ = {};
    text += MakeStatements(6, 3, true);
    return text + "  return c + u;\n}\n";
  }

 private:
  std::string Line(const std::string& text) {
    return std::string(static_cast<std::size_t>(indent_), ' ') + text + "\n";
  }

  std::string MakeFunction(int number) {
    known_ = {"n"};
    runs_ = 8;
    std::string text = "float4 F" + std::to_string(number) + "(float4 p, " +
                       (choices_.Chance(50) ? "uniform " : "") +
                       "int n) {\n  float4 c = p;\n  int u = n;\n";
    text += MakeStatements(4, 2, true);
    if (choices_.Chance(30)) text += "  if (p.x > 1) return c;\n" + MakeStatements(2, 2, false);
    runs_ = 1;
    return text + "  return c + u;\n}\n";
  }

  // A known whole number, between -100 and 100 or so.
  std::string Known() {
    const std::string literal = std::to_string(choices_.Below(5));
    if (known_.empty()) return literal;
    const std::string name = choices_.OneOf(known_);
    switch (choices_.Pick({3, 1, 1, 1, 1})) {
      case 0: return name;
      case 1: return name + " + " + literal;
      case 2: return literal + " - " + name;
      case 3: return name + " * 2 + " + choices_.OneOf(known_);
      default: return "(" + name + " > " + literal + " ? " + name + " : " + literal + ")";
    }
  }
  std::string Element() {
    return "k[min(max(" + Known() + ", 0), " + std::to_string(kElements - 1) + ")]";
  }
  std::string KnownCondition() {
    constexpr const char* kOperators[] = {" > ", " < ", " == ", " != ", " >= "};
    const std::string left = Known(), op = choices_.OneOf(kOperators);
    return left + op + Known();
  }
  std::string Unknown() {
    constexpr const char* kParts[] = {"c.x > ", "p.y < ", "c.w <= ", "p.z > 0 && c.y > "};
    const std::string part = choices_.OneOf(kParts);
    return choices_.Chance(20) ? "u > " + Known() : part + "(" + Known() + ")";
  }

  std::string MakeBlock(int most, int depth, bool may_change) {
    const std::size_t known = known_.size();
    indent_ += 2;
    const std::string inner = MakeStatements(most, depth, may_change);
    indent_ -= 2;
    known_.resize(std::min(known, known_.size()));
    return inner;
  }

  std::string MakeStatements(int most, int depth, bool may_change) {
    std::string text;
    Repeat(choices_, most, 85, [&](int) { text += MakeStatement(depth, may_change); });
    return text;
  }

  // `may_change`: the known variables that are in scope may be given other known values.
  std::string MakeStatement(int depth, bool may_change) {
    const std::uint32_t nest = depth > 0 ? 2 : 0,
                        loop = depth > 0 && runs_ <= kMostRuns / 4 ? 5 : 0;
    switch (choices_.Pick({4, 2, 2, 2, nest, nest, loop, calls_ ? 1u : 0u})) {
      case 0: {
        constexpr const char* kParts[] = {"", ".x", ".wz", ".xyz"};
        const std::string part = choices_.OneOf(kParts);
        return Line("c" + part + (choices_.Chance(50) ? " += " : " -= ") + Element() + part + ";");
      }
      case 1: return Line("u += " + Known() + ";");
      case 2: return Line("c.y += " + Known() + ";");
      case 3: return MakeKnown(may_change);
      case 4: {
        std::string text =
            Line("if (" + KnownCondition() + ") {") + MakeBlock(3, depth - 1, may_change);
        if (choices_.Chance(40)) text += Line("} else {") + MakeBlock(2, depth - 1, may_change);
        return text + Line("}");
      }
      case 5: return Line("if (" + Unknown() + ") {") + MakeBlock(3, depth - 1, false) + Line("}");
      case 6: return MakeLoop(depth, may_change);
      default:
        return Line("c += F" + std::to_string(choices_.Below(2)) + "(p, " + "min(max(" + Known() +
                    ", 0), 4));");
    }
  }

  std::string MakeKnown(bool may_change) {
    if (may_change && !known_.empty() && choices_.Chance(50)) {
      const std::string name = choices_.OneOf(known_);
      const bool is_counter = std::ranges::count(counters_, name) > 0;
      if (!is_counter) {
        switch (choices_.Pick({1, 1, 1, 1})) {
          case 0: return Line(name + "++;");
          case 1: return Line("c.z += " + name + "--;");
          case 2: return Line(name + " += " + std::to_string(choices_.Below(4)) + ";");
          default: return Line(name + " = min(" + Known() + ", 40);");
        }
      }
    }
    const std::string name = "v" + std::to_string(names_++);
    const std::string text = Line("int " + name + " = " + Known() + ";");
    known_.push_back(name);
    return text;
  }

  // A loop whose iterations are known but for exits under conditions that are not.
  std::string MakeLoop(int depth, bool may_change) {
    const int count = choices_.Between(1, 4);
    const std::string i = "i" + std::to_string(names_++), most = std::to_string(count);
    const bool has_exits = choices_.Chance(35);
    const bool inside = may_change && !has_exits;
    const std::size_t known = known_.size();
    const int runs = runs_;
    runs_ *= count;
    std::string text;
    const auto body = [&] { return MakeBody(depth, inside, has_exits); };
    known_.push_back(i);
    counters_.push_back(i);
    const std::string j = i + "j";
    bool stays = false;  // whether the counter is in scope after the loop
    switch (choices_.Pick({2, 2, 2, 2, 2, 2, 2, 1})) {
      case 0:
        text = Line("for (int " + i + " = 0; " + i + " < " + most + "; ++" + i + ") {");
        break;
      case 1:
        text = Line("for (int " + i + " = 0, " + j + " = " + most + "; " + i + " < " + j + "; ++" +
                    i + ", " + j + " += 0) {");
        break;
      case 2: text = Line("for (int " + i + " = " + most + "; " + i + "-- > 0;) {"); break;
      case 3: {
        text = Line("int " + i + " = " + most + ";") + Line("while (" + i + "-- > 0) {");
        stays = true;
        break;
      }
      case 4:
        text = Line("int " + i + ";") +
               Line("for (" + i + " = 0; " + i + " < " + most + "; " + i + "++) {");
        stays = true;
        break;
      case 5: {
        text = Line("int " + i + " = 0;") + Line("while (" + i + " < " + most + ") {");
        indent_ += 2;
        text += Line(i + "++;");
        indent_ -= 2;
        stays = true;
        break;
      }
      case 6: {
        text = Line("int " + i + " = 0;") + Line("do {") + body() +
               Line("} while (++" + i + " < " + most + ");");
        stays = true;
        break;
      }
      default:
        text = Line("int " + i + " = 0;") + Line("for (;;) {");
        indent_ += 2;
        text += Line("if (" + i + "++ >= " + most + ") break;");
        indent_ -= 2;
        stays = true;
    }
    if (!text.ends_with(");\n")) text += body() + Line("}");
    counters_.pop_back();
    known_.resize(known);
    runs_ = runs;
    // What exits leave behind is not known: it may be read.
    if (stays && has_exits) text += Line("u += " + i + ";");
    if (stays && !has_exits) known_.push_back(i);
    return text;
  }

  std::string MakeBody(int depth, bool may_change, bool has_exits) {
    std::string text = MakeBlock(3, depth - 1, may_change);
    if (!has_exits) return text;
    indent_ += 2;
    text += Line("if (" + Unknown() + ") " + (choices_.Chance(50) ? "break;" : "continue;"));
    indent_ -= 2;
    return text + MakeBlock(2, depth - 1, false);
  }

  Choices& choices_;
  const bool draws_pixels_;
  bool calls_ = false;
  std::vector<std::string> known_, counters_;
  int names_ = 0, runs_ = 1, indent_ = 2;
};

}  // namespace

Program MakeLoops(Choices& choices, const Features& features) {
  Program program;
  const bool draws_pixels = features.Has(Feature::kPixels);
  program.stage = draws_pixels ? Stage::kPixel : Stage::kVertex;
  program.profile = draws_pixels ? "ps_4_0" : "vs_4_0";
  program.lowering = "none";
  program.inputs = choices.Below(1000);
  const auto names = glsl::Target::Names();
  program.target = static_cast<std::uint32_t>(std::ranges::find(names, "essl100") - names.begin());
  program.buffers = {{"$Globals", {{"k", {Kind::kFloat, {0, 4}, -1, {kElements}}}}}};
  program.text = LoopMaker(choices, draws_pixels).Make();
  return program;
}

}  // namespace clipc::random
