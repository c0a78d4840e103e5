// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/random/group.h"

#include <array>
#include <vector>

#include "tools/random/interface.h"

namespace clipc::random {
namespace {

// The threads of a group. tools/draw dispatches three groups in x and two in y, and its buffers
// have 192 elements at least: four for each thread.
constexpr int kThreads = 8, kAllThreads = 48, kSlots = 4;

std::string GroupLine(const std::string& text) { return "  " + text + ";\n"; }
std::string GroupWait() { return GroupLine("GroupMemoryBarrierWithGroupSync()"); }

// Inputs of every kind, from buffers.
std::string MakeGiven(Context& context) {
  std::string text;
  Repeat(context.choices, 4, 80, [&](int i) {
    const Kind kind = static_cast<Kind>(context.Pick({4, 3, 2}));
    const Type type{kind, {0, context.Between(1, 4)}};
    const std::string name = "given" + std::to_string(i);
    const std::string components = std::string("xyzw").substr(0, type.shape.columns);
    text += GroupLine(Declaration(context.structs, type, name) + " = " + NameOf(kind) +
                      "s_in[t_slot + " + std::to_string(kAllThreads * (i % kSlots)) + "]." +
                      components);
    context.Add({name, type, true, Holds::kInput});
  });
  text += GroupLine("uint t_number = t_index");
  context.Add({"t_number", {Kind::kUint, kScalar}, false, Holds::kCounter, kThreads - 1.0});
  return text;
}

// A variable with the value that another thread's variable has.
std::string MakeExchange(Context& context, std::string& shared) {
  constexpr const char* kPartners[] = {"7 - t_index", "t_index ^ 1", "t_index ^ 4",
                                       "(t_index + 3) % 8", "2"};
  std::vector<Variable> candidates;
  for (const Variable* variable : context.Visible()) {
    if (variable->holds != Holds::kCounter) candidates.push_back(*variable);
  }
  if (candidates.empty()) return "";
  context.EndExpression();
  const Variable from = context.OneOf(candidates);
  const std::string place = "shared" + std::to_string(context.names++);
  Type all = from.type;
  all.sizes.insert(all.sizes.begin(), kThreads);
  shared += "groupshared " + Declaration(context.structs, all, place) + ";\n";
  std::string text = GroupLine(place + "[t_index] = " + from.name) + GroupWait();
  if (from.type.IsNumeric() && context.Chance(30)) {
    // Half of the threads write what the other half has read.
    const std::string name = context.FreshName("v");
    text +=
        GroupLine(Declaration(context.structs, from.type, name) + " = " + place + "[t_index ^ 4]") +
        GroupWait() + "  if (t_index < 4) " + place + "[t_index] = " + name + ";\n" + GroupWait();
    context.Add({name, from.type, true, from.holds});
  }
  const std::string name = context.FreshName("v");
  text += GroupLine(Declaration(context.structs, from.type, name) + " = " + place + "[" +
                    context.OneOf(kPartners) + "]");
  context.Add({name, from.type, true, from.holds});
  return text;
}

// A variable with what atomic operations of all threads made.
std::string MakeCount(Context& context, std::string& shared) {
  constexpr const char* kOperations[] = {"Add", "Min", "Max", "And", "Or", "Xor"};
  if (context.model < 50 || !context.Has(Feature::kWildInts)) return "";
  const Kind kind = context.Chance(50) ? Kind::kInt : Kind::kUint;
  const std::string place = "count" + std::to_string(context.names++);
  shared += "groupshared " + NameOf(kind) + " " + place + "[2];\n";
  std::string text = "  if (t_index < 2) " + place +
                     "[t_index] = " + std::to_string(context.Below(100)) + ";\n" + GroupWait();
  context.EndExpression();
  text += GroupLine(std::string("Interlocked") + context.OneOf(kOperations) + "(" + place +
                    "[t_index & 1], " + Argument(MakeExpr(context, kind, kScalar, 2)) + ")") +
          GroupWait();
  const std::string name = context.FreshName("v");
  text += GroupLine(NameOf(kind) + " " + name + " = " + place + "[t_index >> 2]");
  context.Add({name, {kind, kScalar}, true, Holds::kWild});
  return text;
}

// The row of a buffer that the value fills up to four components.
std::string RowOf(Kind kind, int columns, const std::string& value) {
  std::string text = NameOf(kind) + "4(" + value;
  for (int i = columns; i < 4; ++i) text += ", 0";
  return text + ")";
}

// Stores of the fields of `result`, lines such as "  float2x3 out1 : OUT1;". Rows for which a
// buffer has no place are not stored.
std::string MakeStores(const std::string& fields) {
  std::array<int, 3> rows{};
  std::string text;
  for (std::size_t at = 0; at < fields.size(); at = fields.find('\n', at) + 1) {
    const std::string line = fields.substr(at + 2, fields.find('\n', at) - at - 2);
    const std::string type = line.substr(0, line.find(' '));
    const std::string name =
        line.substr(type.size() + 1, line.find(' ', type.size() + 1) - type.size() - 1);
    const std::size_t end = type.find_first_of("1234");
    const Kind kind = type.starts_with("float") ? Kind::kFloat
                      : type.starts_with("int") ? Kind::kInt
                                                : Kind::kUint;
    const int columns = end == type.npos ? 1 : type.back() - '0';
    const int count = type.find('x') == type.npos ? 1 : type[end] - '0';
    int& taken = rows[static_cast<std::size_t>(kind)];
    for (int row = 0; row < count && taken < kSlots; ++row, ++taken) {
      const std::string value =
          "result." + name + (count > 1 ? "[" + std::to_string(row) + "]" : "");
      text += GroupLine(NameOf(kind) + "s[t_slot + " + std::to_string(kAllThreads * taken) +
                        "] = " + RowOf(kind, columns, value));
    }
  }
  return text;
}

}  // namespace

std::string MakeGroupEntry(Context& context) {
  const ScopeOf scope(context);
  std::string shared;
  std::string body = MakeGiven(context);
  body += MakeStatements(context, 5, 3);
  Repeat(context.choices, 4, 75, [&](int) {
    body += context.Chance(70) ? MakeExchange(context, shared) : MakeCount(context, shared);
    body += MakeStatements(context, 3, 3);
  });
  const EntryOutputs outputs = MakeOutputs(context, false);
  std::string text = "struct Outputs {\n" + outputs.fields + "};\n" + shared;
  for (const char* kind : {"float", "int", "uint"}) {
    text += std::string("StructuredBuffer<") + kind + "4> " + kind + "s_in;\n";
    text += std::string("RWStructuredBuffer<") + kind + "4> " + kind + "s;\n";
  }
  return text + "[numthreads(8, 1, 1)]\nvoid main(uint3 t_id : SV_DispatchThreadID, " +
         "uint t_index : SV_GroupIndex) {\n  const uint t_slot = t_id.x + 24 * t_id.y;\n" + body +
         "  Outputs result = (Outputs)0;\n" + outputs.statements + MakeStores(outputs.fields) +
         "}\n";
}

}  // namespace clipc::random
