// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/random/interface.h"

#include <algorithm>

namespace clipc::random {
namespace {

constexpr int kMostInputs = 12;   // vectors
constexpr int kMostOutputs = 12;  // vectors
constexpr int kMostTargets = 8;

// Returns the number of vectors of a signature that a value of the type takes.
int VectorsOf(const Type& type) {
  int vectors =
      std::max(1, std::max(type.shape.rows, type.shape.IsMatrix() ? type.shape.columns : 1));
  for (const int size : type.sizes) vectors *= size;
  return vectors;
}

// One component, vector or row that a variable holds.
Expr LeafOf(Context& context, const Variable& variable) {
  Type type = variable.type;
  std::string text = variable.name;
  while (!type.IsNumeric()) {
    if (type.IsArray()) {
      text += "[" + std::to_string(context.Between(0, type.sizes[0] - 1)) + "]";
      type = type.Element();
    } else {
      const Field& field = context.OneOf(context.structs[type.structure].fields);
      text += "." + field.name;
      type = field.type;
    }
  }
  const Expr leaf{text, Level::kPostfix, type.kind, type.shape, RangeOf(variable, type.kind)};
  return type.shape.IsMatrix() ? Reshape(context, leaf, {0, std::min(type.shape.Components(), 4)})
                               : leaf;
}

// A modifier of interpolation that an input of that type may have, or nothing.
std::string MakeModifier(Context& context, const Type& type) {
  constexpr const char* kModifiers[] = {"nointerpolation ", "linear ", "centroid "};
  if (type.kind != Kind::kFloat || !context.Chance(30)) return "";
  return context.OneOf(kModifiers);
}

// A variable, whose value a function of HLSL takes from the neighbours.
std::string MakeDerivative(Context& context) {
  struct Derivative {
    const char* name;
    int model;
    double greatest;  // of an operand, so that the result is one that variables may have
  };
  constexpr Derivative kDerivatives[] = {{"ddx", 40, 64},        {"ddy", 40, 64},
                                         {"fwidth", 40, 32},     {"ddx_fine", 50, 64},
                                         {"ddy_coarse", 50, 64}, {"ddy_fine", 50, 64}};
  const Derivative& derivative = context.OneOf(kDerivatives);
  const Type type{Kind::kFloat, {0, context.Between(1, 4)}};
  const double greatest = derivative.greatest;
  const Expr operand = MakeIn(context, type.kind, type.shape, {-greatest, greatest, 2}, 3);
  const std::string name = context.FreshName("v");
  context.Add({name, type});
  return "  " + Declaration(context.structs, type, name) + " = " +
         (derivative.model <= context.model ? derivative.name : "ddy") + "(" + Argument(operand) +
         ");\n";
}

// A variable with a texel.
std::string MakeSample(Context& context) {
  const Type type{Kind::kFloat, {0, 4}};
  const auto coordinate = [&] {
    return Argument(MakeIn(context, Kind::kFloat, {0, 2}, {-16, 16, 2}, 2));
  };
  const std::string map = "map" + std::to_string(context.Between(0, 1)), state = "linearly";
  std::string call = ".Sample(" + state + ", " + coordinate();
  switch (context.Pick({4, 1, 1})) {
    case 1: call = ".SampleBias(" + state + ", " + coordinate() + ", 0.5"; break;
    case 2: call += ", int2(1, -1)"; break;
    default: break;
  }
  const std::string name = context.FreshName("v");
  context.Add({name, type});
  return "  float4 " + name + " = " + map + call + ");\n";
}

std::string MakeDiscard(Context& context) {
  if (context.Chance(50))
    return "  clip(" + Argument(MakeIn(context, Kind::kFloat, {0, 2}, {-16, 16, 2}, 2)) +
           " + 4);\n";
  return "  if (" + MakeExpr(context, Kind::kBool, kScalar, 2).text + ") discard;\n";
}

// A field as if it were a variable of its own.
Variable FieldOf(const Context& context, const Variable& variable, std::size_t index) {
  const Field& field = context.structs[variable.type.structure].fields[index];
  Variable part = variable;
  part.name += "." + field.name;
  part.type = field.type;
  return part;
}

}  // namespace

std::string MakeNeighbourStatements(Context& context, int most) {
  std::string text;
  Repeat(context.choices, most, 75, [&](int) {
    const SpanOf span(context.choices);
    context.EndExpression();
    switch (context.Pick({4, 3, 2})) {
      case 0: text += MakeDerivative(context); break;
      case 1: text += MakeSample(context); break;
      default: text += MakeDiscard(context);
    }
  });
  return text;
}

EntryInputs MakeInputs(Context& context, bool keeps) {
  EntryInputs inputs;
  std::string fields;
  const auto add = [&](const std::string& text) {
    inputs.parameters += (inputs.parameters.empty() ? "" : ", ") + text;
  };
  const bool draws_pixels = clipc::InfoOf(context.stage).draws_pixels;
  add(std::string("float4 position : ") + (draws_pixels ? "PLACE0" : "POSITION0"));
  context.Add({"position", {Kind::kFloat, {0, 4}}, !keeps, Holds::kInput});
  int left = kMostInputs;
  Struct structure{"Inputs" + std::to_string(context.names++), {}};
  // The chance of an input to be a field: a struct with many may have some that nothing reads.
  const std::uint32_t fields_percent = context.Chance(50) ? 90 : 40;
  Repeat(context.choices, 5, 70, [&](int i) {
    Type type{static_cast<Kind>(context.Pick({4, 3, 2, 1})), {0, 4}};
    type.shape = MakeShape(context);
    if (context.Chance(15)) type.sizes.push_back(context.Between(1, 3));
    if (VectorsOf(type) > left) return;
    left -= VectorsOf(type);
    const std::string name = "in" + std::to_string(context.names++);
    const std::string text = (draws_pixels ? MakeModifier(context, type) : "") +
                             Declaration(context.structs, type, name) + " : " +
                             static_cast<char>('A' + i) + "IN0";
    if (context.Chance(Feature::kStructs, fields_percent)) {
      fields += "  " + text + ";\n";
      structure.fields.push_back({name, type});
    } else {
      add(text);
      context.Add({name, type, true, Holds::kInput});
    }
  });
  if (!fields.empty()) {
    Type type;
    type.structure = static_cast<int>(context.structs.size());
    context.structs.push_back(structure);
    inputs.structs = "struct " + structure.name + " {\n" + fields + "};\n";
    add(structure.name + " inputs");
    context.Add({"inputs", type, true, Holds::kInput});
  }
  if (draws_pixels) {
    if (context.Chance(20)) {
      add("bool front : SV_IsFrontFace");
      context.Add({"front", {Kind::kBool, kScalar}, false, Holds::kInput});
    }
    if (context.Chance(10)) {
      add("uint primitive : SV_PrimitiveID");
      // The number of the cell, which all pixels of a quad have in common.
      inputs.statements += "  primitive /= 2;\n";
      context.Add({"primitive", {Kind::kUint, kScalar}, false, Holds::kCounter, 7});
    }
    if (context.Chance(30)) {
      add("float4 place : SV_Position");
      inputs.statements += "  float3 pixel = place.xyw;\n";
      context.Add({"pixel", {Kind::kFloat, {0, 3}}});
    }
    return inputs;
  }
  if (context.Chance(20)) {
    add("uint vertex : SV_VertexID");
    context.Add({"vertex", {Kind::kUint, kScalar}, false, Holds::kCounter, 15});
  }
  if (context.Chance(10)) {
    add("uint instance : SV_InstanceID");
    context.Add({"instance", {Kind::kUint, kScalar}, false, Holds::kCounter, 2});
  }
  return inputs;
}

int MakeGivenStruct(Context& context, std::string& text, bool has_position) {
  Struct given{"Corner" + std::to_string(context.names++), {}};
  std::string fields;
  if (has_position) {
    fields = "  float4 place : SV_Position;\n";
    given.fields.push_back({"place", {Kind::kFloat, {0, 4}}});
  }
  Repeat(context.choices, 4, 75, [&](int i) {
    Type type{static_cast<Kind>(context.Pick({4, 3, 2})), {0, context.Between(1, 4)}};
    if (context.Chance(15)) type.sizes.push_back(context.Between(1, 3));
    const std::string name = "in" + std::to_string(context.names++);
    const char* const modifier = type.kind == Kind::kFloat && context.Chance(20) ? "centroid " : "";
    fields += std::string("  ") + modifier + Declaration(context.structs, type, name) + " : " +
              static_cast<char>('A' + i) + "IN0;\n";
    given.fields.push_back({name, type});
  });
  text += "struct " + given.name + " {\n" + fields + "};\n";
  context.structs.push_back(std::move(given));
  return static_cast<int>(context.structs.size()) - 1;
}

std::string MakeCopies(Context& context, int structure, const std::string& from,
                       const std::vector<std::string>& indices) {
  std::string text;
  Repeat(context.choices, 3, 80, [&](int i) {
    const std::string name = "corner" + std::to_string(i);
    text += "  " + context.structs[static_cast<std::size_t>(structure)].name + " " + name + " = " +
            from + "[" + context.OneOf(indices) + "];\n";
    Type type;
    type.structure = structure;
    context.Add({name, type, true, Holds::kInput});
  });
  return text;
}

EntryOutputs MakeOutputs(Context& context, bool soft) {
  const bool draws_pixels = clipc::InfoOf(context.stage).draws_pixels;
  const std::string semantic = draws_pixels ? "SV_Target" : "OUT";
  const int most = draws_pixels ? kMostTargets : kMostOutputs;
  EntryOutputs outputs;
  context.EndExpression();
  int number = 0;
  const auto add = [&](const Type& type, const std::string& value) {
    const std::string name = "out" + std::to_string(number);
    outputs.fields += "  " + Declaration(context.structs, type, name) + " : " + semantic +
                      std::to_string(number) + ";\n";
    outputs.statements += "  result." + name + " = " + value + ";\n";
    outputs.made.push_back({name, type});
    ++number;
    if (type.shape.IsMatrix() || type.shape.IsScalar() || !context.Chance(20)) return;
    context.EndExpression();
    const Expr made = MakeIndex(context, type.shape.columns, 2);
    std::string index = made.text;
    if (clipc::InfoOf(context.stage).makes_patches) {
      // Mesa 22.3 writes another component of such an output where the index reads an array.
      outputs.statements += "  int t_" + name + " = " + Argument(made) + ";\n";
      index = "t_" + name;
    }
    const bool is_compound = type.kind == Kind::kFloat && context.Chance(50);
    outputs.statements += "  result." + name + "[" + index + "]" + (is_compound ? " += " : " = ") +
                          Argument(MakeIn(context, type.kind, kScalar, {0, 16, 2}, 1)) + ";\n";
  };
  if (soft) {
    for (int i = 0; i < 2; ++i) add({Kind::kFloat, {0, 4}}, MakeSoft(context, 4, 2));
  }
  const std::vector<const Variable*> visible = context.Visible();
  for (const Variable* variable : visible) {
    // The compiler may leave out a variable on which no output depends.
    if (context.Chance(15)) continue;
    const bool has_fields = variable->type.IsStruct();
    const std::size_t fields =
        has_fields ? context.structs[variable->type.structure].fields.size() : 1;
    for (std::size_t i = 0; i < fields && number < most; ++i) {
      const Expr leaf = LeafOf(context, has_fields ? FieldOf(context, *variable, i) : *variable);
      const Type type{leaf.kind == Kind::kBool ? Kind::kInt : leaf.kind, leaf.shape};
      add(type, Argument(Convert(context, leaf, type.kind)));
    }
  }
  if (draws_pixels && number == 0) add({Kind::kFloat, {0, 4}}, "position");
  return outputs;
}

}  // namespace clipc::random
