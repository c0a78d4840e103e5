// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/random/patch.h"

#include <algorithm>
#include <vector>

namespace clipc::random {
namespace {

constexpr int kPoints[] = {3, 1, 2, 4, 5, 16};

std::string PatchLine(const std::string& text) { return "  " + text + ";\n"; }

// A domain, as HLSL spells what belongs to it.
struct DomainWords {
  const char* name;
  const char* location;  // the type of SV_DomainLocation
  int edges;
  const char* inside;  // the declarator of SV_InsideTessFactor; empty: none
  int insides;
  const char* topologies[2];  // beside `point`
};
constexpr DomainWords kDomains[] = {
    {"tri", "float3", 3, "t_inside", 1, {"triangle_cw", "triangle_ccw"}},
    {"quad", "float2", 4, "t_inside[2]", 2, {"triangle_cw", "triangle_ccw"}},
    {"isoline", "float2", 2, "", 0, {"line", "line"}},
};
constexpr const char* kPartitionings[] = {"integer", "fractional_odd", "fractional_even", "pow2"};

std::string MakeAttributes(Context& context, const DomainWords& domain, int points,
                           const std::string& function) {
  const std::string topology =
      context.Chance(15) ? "point" : domain.topologies[context.Below(std::size(domain.topologies))];
  std::string text = std::string("[domain(\"") + domain.name + "\")] [partitioning(\"" +
                     context.OneOf(kPartitionings) + "\")] [outputtopology(\"" + topology +
                     "\")]\n[outputcontrolpoints(" + std::to_string(points) +
                     ")] [patchconstantfunc(\"" + function + "\")]";
  if (context.Chance(30))
    text += " [maxtessfactor(" + std::to_string(context.Between(1, 64)) + ")]";
  return text + "\n";
}

std::string FactorFields(const DomainWords& domain) {
  std::string text = "  float t_edges[" + std::to_string(domain.edges) + "] : SV_TessFactor;\n";
  if (domain.insides > 0)
    text += std::string("  float ") + domain.inside + " : SV_InsideTessFactor;\n";
  return text;
}

// Gives each factor a value.
std::string MakeFactors(Context& context, const DomainWords& domain) {
  std::string text;
  const auto add = [&](const std::string& place) {
    context.EndExpression();
    text += PatchLine("result." + place + " = " +
                      Argument(MakeIn(context, Kind::kFloat, kScalar, {0, 64, 2}, 2)));
  };
  for (int i = 0; i < domain.edges; ++i) add("t_edges[" + std::to_string(i) + "]");
  for (int i = 0; i < domain.insides; ++i)
    add(domain.insides == 1 ? "t_inside" : "t_inside[" + std::to_string(i) + "]");
  return text;
}

// Variables with what the control points have after the hull shader.
std::string MakeMade(Context& context, const std::vector<Field>& made, int points) {
  std::string text;
  if (made.empty()) return text;
  Repeat(context.choices, 4, 80, [&](int) {
    const Field& field = context.OneOf(made);
    const Type& type = field.type;
    const std::string place = "t_points[" +
                              std::to_string(context.Below(static_cast<std::size_t>(points))) +
                              "]." + field.name;
    const bool is_float = type.kind == Kind::kFloat;
    // An output may be larger than variables are.
    Expr value{place, Level::kPostfix, type.kind, type.shape, Range{-1024, 1024, 2}};
    if (is_float) value = Fit(context, value, VariableRange(type.kind));
    const std::string name = context.FreshName("v");
    text += PatchLine(Declaration(context.structs, type, name) + " = " + Argument(value));
    context.Add({name, type, true, is_float ? Holds::kVariable : Holds::kWild});
  });
  return text;
}

std::vector<std::string> Numbers(int count) {
  std::vector<std::string> numbers;
  for (int i = 0; i < count; ++i) numbers.push_back(std::to_string(i));
  return numbers;
}

// A parameter with the number of the patch, perhaps.
std::string MakePatchNumber(Context& context) {
  if (!context.Chance(20)) return "";
  context.Add({"t_patch", {Kind::kUint, kScalar}, false, Holds::kCounter, 15});
  return ", uint t_patch : SV_PrimitiveID";
}

// The two functions of a hull shader, which both read the patch of the vertices.
struct HullParts {
  const DomainWords& domain;
  int given = 0;            // the struct of the vertices
  int taken = 0, made = 0;  // control points

  std::string Patch(const Context& context) const {
    return "InputPatch<" + context.structs[static_cast<std::size_t>(given)].name + ", " +
           std::to_string(taken) + "> t_corners";
  }
};

struct PatchFunction {
  std::string fields, text;
  std::vector<Field> made;
};

// The function of the control points.
PatchFunction MakePointFunction(Context& context, const HullParts& hull) {
  const ScopeOf scope(context);
  std::string parameters = hull.Patch(context) + ", uint t_point : SV_OutputControlPointID";
  std::vector<std::string> indices = Numbers(hull.taken);
  const std::string size = std::to_string(hull.taken);
  indices.push_back("t_point % " + size);
  indices.push_back("(t_point + 1) % " + size);
  context.Add({"t_point", {Kind::kUint, kScalar}, false, Holds::kCounter, hull.made - 1.0});
  parameters += MakePatchNumber(context);
  std::string body = PatchLine("Outputs result = (Outputs)0") +
                     MakeCopies(context, hull.given, "t_corners", indices);
  body += MakeStatements(context, 8, 3);
  EntryOutputs outputs = MakeOutputs(context, false);
  context.EndExpression();
  body += PatchLine("result.position = " +
                    Argument(MakeIn(context, Kind::kFloat, {0, 4}, {-64, 64, 2}, 2)));
  outputs.made.push_back({"position", {Kind::kFloat, {0, 4}}});
  return {
      "  float4 position : SV_Position;\n" + outputs.fields,
      "Outputs main(" + parameters + ") {\n" + body + outputs.statements + "  return result;\n}\n",
      outputs.made};
}

// The function of the constants of the patch.
PatchFunction MakeConstantFunction(Context& context, const HullParts& hull,
                                   const std::vector<Field>& made) {
  const ScopeOf scope(context);
  const bool reads_points = context.Chance(75);
  std::string parameters = hull.Patch(context);
  if (reads_points)
    parameters += ", OutputPatch<Outputs, " + std::to_string(hull.made) + "> t_points";
  parameters += MakePatchNumber(context);
  std::string body = PatchLine("Constants result = (Constants)0") +
                     MakeCopies(context, hull.given, "t_corners", Numbers(hull.taken));
  if (reads_points) body += MakeMade(context, made, hull.made);
  body += MakeStatements(context, 8, 3);
  const EntryOutputs outputs = MakeOutputs(context, false);
  body += MakeFactors(context, hull.domain);
  return {FactorFields(hull.domain) + outputs.fields,
          "Constants Constant(" + parameters + ") {\n" + body + outputs.statements +
              "  return result;\n}\n",
          {}};
}

}  // namespace

std::string MakePatchEntry(Context& context) {
  std::string structs;
  const DomainWords& domain = context.OneOf(kDomains);
  const HullParts hull{domain, MakeGivenStruct(context, structs, true), context.OneOf(kPoints),
                       context.OneOf(kPoints)};
  const PatchFunction points = MakePointFunction(context, hull);
  const PatchFunction constants = MakeConstantFunction(context, hull, points.made);
  return structs + "struct Outputs {\n" + points.fields + "};\nstruct Constants {\n" +
         constants.fields + "};\n" + constants.text +
         MakeAttributes(context, domain, hull.made, "Constant") + points.text;
}

std::string MakeDomainEntry(Context& context, const std::string& planes) {
  std::string structs;
  const DomainWords& domain = context.OneOf(kDomains);
  const int points = context.OneOf(kPoints);
  const int corner = MakeGivenStruct(context, structs, true);
  std::string constants_text;
  const int constants = MakeGivenStruct(context, constants_text, false);
  const auto name = [&](int structure) {
    return context.structs[static_cast<std::size_t>(structure)].name;
  };
  const std::string size = std::to_string(points);
  // The hull shader says how the domain is cut.
  const std::string hull =
      "struct Factors {\n" + FactorFields(domain) + "};\nFactors Cut() { return (Factors)0; }\n" +
      MakeAttributes(context, domain, points, "Cut") + name(corner) + " hull(InputPatch<" +
      name(corner) + ", " + size + "> t_corners, uint t_point : SV_OutputControlPointID) {\n" +
      "  return t_corners[t_point];\n}\n";
  const ScopeOf scope(context);
  std::string parameters = "const OutputPatch<" + name(corner) + ", " + size + "> t_corners, " +
                           domain.location + " t_at : SV_DomainLocation";
  std::string body = PatchLine("Outputs result = (Outputs)0") +
                     MakeCopies(context, corner, "t_corners", Numbers(points));
  // A location on a grid of quarters keeps what follows from it exact.
  const Type location{Kind::kFloat, {0, domain.location[5] - '0'}};
  body += PatchLine(std::string(domain.location) + " location = round(t_at * 4) / 4");
  context.Add({"location", location, true, Holds::kInput});
  if (context.structs[static_cast<std::size_t>(constants)].fields.empty()) {
    constants_text.clear();
    context.structs.pop_back();
  } else {
    parameters += ", " + name(constants) + " constants";
    Type type;
    type.structure = constants;
    context.Add({"constants", type, true, Holds::kInput});
  }
  if (context.Chance(30)) {
    parameters += ", float t_edges[" + std::to_string(domain.edges) + "] : SV_TessFactor";
    context.Add({"t_edges", {Kind::kFloat, kScalar, -1, {domain.edges}}, true, Holds::kInput});
    if (domain.insides > 0) {
      parameters += std::string(", float ") + domain.inside + " : SV_InsideTessFactor";
      Type type{Kind::kFloat, kScalar};
      if (domain.insides > 1) type.sizes.push_back(domain.insides);
      context.Add({"t_inside", type, true, Holds::kInput});
    }
  }
  parameters += MakePatchNumber(context);
  body += MakeStatements(context, 10, 3);
  const EntryOutputs outputs = MakeOutputs(context, false);
  context.EndExpression();
  body += PatchLine("result.position = " +
                    Argument(MakeIn(context, Kind::kFloat, {0, 4}, {-64, 64, 2}, 2)));
  return structs + constants_text + hull + "struct Outputs {\n  float4 position : SV_Position;\n" +
         outputs.fields + "};\n" + planes + "[domain(\"" + domain.name + "\")]\nOutputs main(" +
         parameters + ") {\n" + body + outputs.statements + "  return result;\n}\n";
}

}  // namespace clipc::random
