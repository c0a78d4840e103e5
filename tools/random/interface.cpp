// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/random/interface.h"

#include <algorithm>

namespace clipc::random {
namespace {

constexpr int kMostInputs = 12;   // vectors
constexpr int kMostOutputs = 12;  // vectors

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

// A field as if it were a variable of its own.
Variable FieldOf(const Context& context, const Variable& variable, std::size_t index) {
  const Field& field = context.structs[variable.type.structure].fields[index];
  Variable part = variable;
  part.name += "." + field.name;
  part.type = field.type;
  return part;
}

}  // namespace

EntryInputs MakeInputs(Context& context, bool keeps) {
  EntryInputs inputs;
  std::string fields;
  const auto add = [&](const std::string& text) {
    inputs.parameters += (inputs.parameters.empty() ? "" : ", ") + text;
  };
  add("float4 position : POSITION0");
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
    const std::string text =
        Declaration(context.structs, type, name) + " : " + static_cast<char>('A' + i) + "IN0";
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

EntryOutputs MakeOutputs(Context& context, bool soft) {
  EntryOutputs outputs;
  context.EndExpression();
  int number = 0;
  const auto add = [&](const Type& type, const std::string& value) {
    const std::string name = "out" + std::to_string(number);
    outputs.fields +=
        "  " + Declaration(context.structs, type, name) + " : OUT" + std::to_string(number) + ";\n";
    outputs.statements += "  result." + name + " = " + value + ";\n";
    ++number;
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
    for (std::size_t i = 0; i < fields && number < kMostOutputs; ++i) {
      const Expr leaf = LeafOf(context, has_fields ? FieldOf(context, *variable, i) : *variable);
      const Type type{leaf.kind == Kind::kBool ? Kind::kInt : leaf.kind, leaf.shape};
      add(type, Argument(Convert(context, leaf, type.kind)));
    }
  }
  return outputs;
}

}  // namespace clipc::random
