// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/random/emitter.h"

#include <vector>

namespace clipc::random {
namespace {

constexpr int kMostVertices = 5;  // with twelve outputs of a matrix each, 1024 scalars at most

std::string EmitterLine(const std::string& text) { return "  " + text + ";\n"; }

struct TakenPrimitive {
  const char* name;
  int vertices;
};
constexpr TakenPrimitive kTakenPrimitives[] = {
    {"triangle", 3}, {"point", 1}, {"line", 2}, {"lineadj", 4}, {"triangleadj", 6}};
constexpr const char* kStreams[] = {"TriangleStream", "LineStream", "PointStream"};

// Statements that write the vertex and append it, perhaps under a condition.
std::string MakeAppend(Context& context, const std::string& writes, bool may_restart) {
  context.EndExpression();
  std::string text = EmitterLine("result.position = " +
                                 Argument(MakeIn(context, Kind::kFloat, {0, 4}, {-64, 64, 2}, 2)));
  text += writes;
  context.EndExpression();
  const bool is_chosen = context.Chance(25);
  const std::string condition =
      is_chosen ? "if (" + MakeExpr(context, Kind::kBool, kScalar, 2).text + ") " : "";
  text += EmitterLine(condition + "stream.Append(result)");
  if (may_restart && context.Chance(25)) text += EmitterLine("stream.RestartStrip()");
  return text;
}

}  // namespace

std::string MakeEmitterEntry(Context& context, const std::string& planes) {
  std::string structs;
  const int corner = MakeGivenStruct(context, structs, true);
  const std::string corner_name = context.structs[static_cast<std::size_t>(corner)].name;
  const ScopeOf scope(context);
  const TakenPrimitive& primitive = context.OneOf(kTakenPrimitives);
  const std::string stream = context.OneOf(kStreams);
  std::string parameters = std::string(primitive.name) + " " + corner_name + " t_corners[" +
                           std::to_string(primitive.vertices) + "]";
  std::vector<std::string> indices;
  for (int i = 0; i < primitive.vertices; ++i) indices.push_back(std::to_string(i));
  std::string body = MakeCopies(context, corner, "t_corners", indices);
  int instances = 1;
  if (context.model >= 50 && context.Chance(30)) {
    instances = context.Between(1, 3);
    parameters += ", uint t_instance : SV_GSInstanceID";
    context.Add({"t_instance", {Kind::kUint, kScalar}, false, Holds::kCounter, instances - 1.0});
  }
  body += MakeStatements(context, 8, 3);
  const EntryOutputs outputs = MakeOutputs(context, false);
  std::string appends;
  const int count = context.Between(1, kMostVertices + 1);
  for (int i = 0; i < count; ++i) {
    if (i > 0) appends += MakeStatements(context, 2, 2);
    appends += MakeAppend(context, outputs.statements, stream != "PointStream");
  }
  const std::string most = std::to_string(context.Between(1, kMostVertices));
  std::string attributes = "[maxvertexcount(" + most + ")]\n";
  if (instances > 1) attributes += "[instance(" + std::to_string(instances) + ")]\n";
  return structs + "struct Outputs {\n  float4 position : SV_Position;\n" + outputs.fields +
         "};\n" + planes + attributes + "void main(" + parameters + ", inout " + stream +
         "<Outputs> stream) {\n" + body + "  Outputs result = (Outputs)0;\n" + appends + "}\n";
}

}  // namespace clipc::random
