// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/entry_signature.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/spelling.h"
#include "base/stage.h"
#include "frontend/check/assign.h"
#include "frontend/check/expr.h"
#include "frontend/check/function.h"
#include "frontend/check/global.h"
#include "frontend/check/init.h"
#include "frontend/check/tessellation.h"
#include "frontend/check/type.h"
#include "frontend/check/value.h"
#include "frontend/check/vulkan.h"
#include "frontend/signature/semantics.h"

namespace clipc::check {
namespace {

constexpr std::uint32_t kAfterAll = std::numeric_limits<std::uint32_t>::max();

// Gives a `uniform` parameter the value `argument` of a technique: the object itself, which
// ResolveObjects follows, or a variable that is added.
void AddArgument(Context& context, const ast::VarDecl& var, const Parameter& parameter,
                 ast::ExprId argument, EntryParameter& into) {
  const ViewSwitch outside(context, context.ViewFrom(context.names.global(), kAfterAll));
  const ExprId value = CheckInit(context, argument, parameter.type);
  into.is_uniform = true;
  if (HoldsObjects(context, parameter.type)) {
    into.object = value;
    if (!context.IsError(value) && !RootOf(context.program, value))
      context.Report(context[argument].span, diag::ObjectNotGlobal, context[var.name],
                     context.TypeName(parameter.type));
    return;
  }
  const bool is_constant = !context.IsError(value) && IsConstantExpr(context, value);
  const VarId added = AddVar(context, var.name, parameter.type,
                             is_constant ? Storage::kConstant : Storage::kStatic, var.name_span);
  context[added].init = value;
  context[added].row_major = IsRowMajor(context, QualifiersOf(context, var));
  MarkConst(context, added);
  context.globals.reached.push_back({kAfterAll, added});
  into.uniform_var = added;
}

// Adds the variable of a `uniform` parameter of the entry point, a member of $Params or a resource.
VarId AddUniformParameter(Context& context, const ast::VarDecl& var, const Parameter& parameter) {
  const SymbolId symbol = context.names.Declare(SymbolKind::kVariable, context.names.global(), {},
                                                parameter.decl, var.name_span);
  context[symbol].resolution = Resolution::kDone;
  if (HoldsObjects(context, parameter.type)) {
    ResolveObject(context, symbol, var, parameter.type);
    return VarId{context[symbol].value};
  }
  const VarId added = AddVar(context, var.name, parameter.type, Storage::kUniform, var.name_span);
  context[added].row_major = IsRowMajor(context, QualifiersOf(context, var));
  MarkConst(context, added);
  context[symbol].value = added.index;
  if (!context.globals.params_buffer) {
    context.globals.params_buffer = context.globals.buffers.Add({.kind = CbufferKind::kParams,
                                                                 .scope = context.names.global(),
                                                                 .order = kAfterAll,
                                                                 .resolution = Resolution::kDone});
  }
  context[context.globals.params_buffer].members.push_back(symbol);
  return added;
}

bool HasObjectField(const Context& context, TypeId id) {
  if (HoldsObjects(context, id)) return true;
  const Type& type = context[context.types.Innermost(id)];
  return type.kind == TypeKind::kStruct &&
         std::ranges::any_of(context.types[type.structure].fields, [&](const Field& field) {
           return HasObjectField(context, field.type);
         });
}

// Whether the parameter is a struct whose textures and samplers are those of the shader, as if it
// were uniform. fxc takes them in 5.0 and 5.1 (a test of vkd3d's, checked against native); DXC
// refuses an object in the parameters of an entry function.
bool TakesObjects(const Context& context, const Parameter& parameter) {
  const Profile& profile = context.program.profile;
  return parameter.storage == Storage::kIn && profile.IsAtLeast(5, 0) && !profile.IsAtLeast(6, 0) &&
         context[parameter.type].kind == TypeKind::kStruct &&
         HasObjectField(context, parameter.type);
}

// Whether the parameter is a texture or sampler of the shader without a semantic, as if it were
// uniform, by the same rule.
bool IsBareObject(const Context& context, const ast::VarDecl& var, const Parameter& parameter) {
  const Profile& profile = context.program.profile;
  return parameter.storage == Storage::kIn && !var.semantic.name && profile.IsAtLeast(5, 0) &&
         !profile.IsAtLeast(6, 0) && HoldsObjects(context, parameter.type);
}

// The limits of the profile: of a group's threads in each direction, and of all of them.
struct GroupLimits {
  std::array<std::int64_t, 3> most;
  std::int64_t threads;
};
GroupLimits LimitsOf(const Profile& profile) {
  if (profile.IsAtLeast(5, 0)) return {{1024, 1024, 64}, 1024};
  return {{768, 768, 1}, 768};
}

// The constant with a [[vk::constant_id]] that an argument of [numthreads] names; none without one.
// Reports one that the argument computes with: a group has the number of one constant.
VarId GroupSizeConstant(Context& context, ast::ExprId argument) {
  const auto used = std::exchange(context.globals.used_as_constants, {});
  for (const SymbolId id : used) {
    const auto& var = context.Get<ast::VarDecl>(context[id].decl);
    if (!ConstantIdOf(context, var.attributes)) continue;
    if (!context.Is<ast::NameExpr>(argument)) {
      context.Report(context[argument].span, diag::GroupSizeComputed, context[var.name]);
    } else if (const auto* ref = context.GetIf<VarRef>(CheckExpr(context, argument))) {
      return ref->var;
    }
  }
  return {};
}

void ReadGroupSize(Context& context, const ast::Attr& attribute) {
  Program& program = context.program;
  const auto arguments = context[attribute.arguments];
  if (arguments.size() != program.group_size.size()) {
    context.Report(attribute.span, diag::GroupSizeCount, arguments.size());
    return;
  }
  const auto [most, threads] = LimitsOf(program.profile);
  std::int64_t product = 1;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    context.globals.used_as_constants.clear();
    const auto number = ConstantInteger(context, arguments[i]);
    if (!number) return;
    if (*number < 1 || *number > most[i]) {
      context.Report(context[arguments[i]].span, diag::GroupSizeRange, *number,
                     std::string_view("xyz").substr(i, 1), program.profile.name, most[i]);
      return;
    }
    program.group_size[i] = static_cast<std::uint32_t>(*number);
    program.group_size_constants[i] = GroupSizeConstant(context, arguments[i]);
    product *= *number;
  }
  if (product > threads)
    context.Report(attribute.span, diag::GroupTooLarge, product, program.profile.name, threads);
}

// ---- the stage that emits vertices

// By Primitive.
constexpr ast::Qualifiers kQualifiers[] = {ast::kPoint, ast::kLine, ast::kTriangle,
                                           ast::kLineAdjacent, ast::kTriangleAdjacent};
static_assert(std::size(kQualifiers) == std::size(kPrimitives));

constexpr std::int64_t kMostInstances = 32;
constexpr std::size_t kMostStreams = 4;

std::optional<Primitive> PrimitiveOf(ast::Qualifiers qualifiers) {
  for (std::size_t i = 0; i < std::size(kQualifiers); ++i) {
    if (qualifiers & kQualifiers[i]) return static_cast<Primitive>(i);
  }
  return std::nullopt;
}

std::string VerticesText(const PrimitiveInfo& primitive) {
  return fmt::format("{} vert{}", primitive.vertices, primitive.vertices == 1 ? "ex" : "ices");
}

// What the vertices of such a stream are joined to.
Primitive OutputOf(ObjectKind stream) {
  if (stream == ObjectKind::kLineStream) return Primitive::kLine;
  return stream == ObjectKind::kTriangleStream ? Primitive::kTriangle : Primitive::kPoint;
}

// Reads the stream, a variable that no resource is. LowerStreams asks for it.
void ReadStream(Context& context, const ast::VarDecl& var, const Parameter& parameter,
                EntryParameter& into) {
  if (parameter.storage != Storage::kInOut)
    context.Report(var.name_span, diag::StreamNotInout, context[var.name],
                   context.TypeName(parameter.type));
  into.is_uniform = into.is_stream = true;
  into.uniform_var = AddVar(context, var.name, parameter.type, Storage::kResource, var.name_span);
  context.program.emission.output = OutputOf(context[parameter.type].object);
}

void ReadVertices(Context& context, const ast::VarDecl& var, const Parameter& parameter,
                  std::optional<Primitive> written, EntryParameter& into) {
  const Type& type = context[parameter.type];
  Emission& emission = context.program.emission;
  into.is_of_vertices = true;
  if (!written) {
    context.Report(var.name_span, diag::PrimitiveMissing, context[var.name]);
    return;
  }
  const PrimitiveInfo& info = InfoOf(*written);
  if (parameter.storage != Storage::kIn)
    context.Report(var.name_span, diag::OutputNotStream, context[var.name]);
  if (type.count != info.vertices)
    context.Report(var.name_span, diag::PrimitiveVertices, context[var.name],
                   WithCount(type.count, "element"), info.name, VerticesText(info));
  // The first parameter with vertices has the primitive of all.
  if (emission.takes_primitive && emission.input != *written)
    context.Report(var.name_span, diag::PrimitiveTwice, context[var.name], info.name,
                   InfoOf(emission.input).name);
  emission.input = *written;
  emission.takes_primitive = true;
}

// Reports a stream that may not be one of several, which are of points ("Stream-Output Object" of
// Microsoft's HLSL reference).
void CheckStream(Context& context, const Stream& stream) {
  const Program& program = context.program;
  const auto& streams = program.emission.streams;
  const Var& var = program.vars[stream.object];
  const auto number = static_cast<std::size_t>(&stream - streams.data());
  const bool is_of_points = program.types[var.type].object == ObjectKind::kPointStream;
  const bool has_model = program.profile.IsAtLeast(5, 0);
  if (streams.size() > 1 && (!is_of_points || !has_model || number >= kMostStreams))
    context.Report(var.span, diag::StreamNotOfSeveral, var.name, streams.size(), kMostStreams);
}

void CheckCounts(Context& context, const AttributeLists& attributes) {
  Program& program = context.program;
  const ast::Attr* attribute = FindAttribute(context, attributes, "maxvertexcount");
  if (!attribute) {
    const Function& function = program.functions[program.entry];
    context.Report(function.span, diag::EmissionCountMissing, function.name);
    return;
  }
  const auto count = NumberIn(context, attributes, "maxvertexcount", kMostScalarsEmitted);
  if (!count) return;
  program.emission.max_vertices = *count;
  const std::int64_t scalars = ScalarsOfVertex(program);
  if (scalars * *count > kMostScalarsEmitted)
    context.Report(attribute->span, diag::EmissionTooLarge, *count, scalars, scalars * *count,
                   kMostScalarsEmitted);
}

// Reads what only such a stage has at a parameter: a stream, or the primitive whose vertices an
// array has. Reports what is wrong with it. Returns whether the parameter is a stream, which is
// read completely then.
bool ReadEmission(Context& context, const ast::VarDecl& var, const Parameter& parameter,
                  EntryParameter& into) {
  const auto written = PrimitiveOf(var.qualifiers);
  const StageInfo& stage = InfoOf(context.program.stage);
  if (written && !stage.emits_vertices)
    context.Report(var.name_span, diag::QualifierWithoutEffect, InfoOf(*written).name,
                   fmt::format("a parameter of a {} shader; fxc reports an error", stage.name));
  if (!stage.emits_vertices || context.IsError(parameter.type)) return false;
  const Type& type = context[parameter.type];
  if (type.kind == TypeKind::kObject && IsStream(type.object)) {
    ReadStream(context, var, parameter, into);
    return true;
  }
  if (type.kind == TypeKind::kArray && !(var.qualifiers & ast::kUniform)) {
    ReadVertices(context, var, parameter, written, into);
  } else if (written) {
    context.Report(var.name_span, diag::PrimitiveVertices, context[var.name], "no elements",
                   InfoOf(*written).name, VerticesText(InfoOf(*written)));
  }
  return false;
}

}  // namespace

std::optional<std::uint32_t> NumberIn(Context& context, const AttributeLists& attributes,
                                      std::string_view name, std::int64_t most,
                                      std::int64_t least) {
  const ast::Attr* attribute = FindAttribute(context, attributes, name);
  if (!attribute) return std::nullopt;
  const auto arguments = context[attribute->arguments];
  if (arguments.size() != 1) {
    context.Report(attribute->span, diag::EmissionArguments, name, arguments.size());
    return std::nullopt;
  }
  const auto number = ConstantInteger(context, arguments[0]);
  if (!number) return std::nullopt;
  if (*number >= least && *number <= most) return static_cast<std::uint32_t>(*number);
  context.Report(context[arguments[0]].span, diag::EmissionRange, name, *number, most);
  return std::nullopt;
}

EntryParameter Described(Context& context, const ast::VarDecl& var) {
  EntryParameter parameter;
  parameter.semantic = context[var.semantic.name];
  parameter.semantic_span = var.semantic.span;
  ReadInterpolation(var.qualifiers, parameter);
  ReadVulkan(context, var.attributes, parameter);
  parameter.precise = (var.qualifiers & ast::kPrecise) != 0;
  parameter.row_major = IsRowMajor(context, QualifiersOf(context, var));
  return parameter;
}

EntryParameter DescribedResult(Context& context, const ast::FunctionDecl& decl) {
  EntryParameter result;
  result.semantic = context[decl.return_semantic.name];
  result.semantic_span = decl.return_semantic.span;
  ReadInterpolation(decl.qualifiers, result);
  ReadVulkan(context, decl.attributes, result);
  result.precise = (decl.qualifiers & ast::kPrecise) != 0;
  result.row_major = IsRowMajor(context, decl.qualifiers);
  return result;
}

EntrySignature SignatureOf(Context& context, FunctionInfoId entry) {
  const FunctionInfo& info = context[entry];
  const ast::FunctionDecl& decl = DeclOf(context, info);
  EntrySignature signature;
  signature.has_later_stage = context.file.has_later_stage;
  const std::span<const ast::ExprId> arguments = context[context.file.entry_arguments];
  std::size_t uniforms = 0;
  for (const Parameter& parameter :
       std::vector<Parameter>(context[info.parameters].begin(), context[info.parameters].end())) {
    const auto& var = context.Get<ast::VarDecl>(parameter.decl);
    EntryParameter entry_parameter = Described(context, var);
    if (!(var.qualifiers & ast::kUniform) && IsPatch(context, var)) {
      entry_parameter.is_of_vertices = ReadPatch(context, var, parameter);
    } else if (ReadEmission(context, var, parameter, entry_parameter)) {
      signature.parameters.push_back(std::move(entry_parameter));
      continue;
    }
    const std::size_t place = signature.parameters.size();
    const bool is_given = context.options.call_names_parameters && place < arguments.size() &&
                          !var.semantic.name && context[parameter.type].kind != TypeKind::kStruct;
    if (is_given) {
      AddArgument(context, var, parameter, arguments[place], entry_parameter);
    } else if ((var.qualifiers & ast::kUniform) || IsBareObject(context, var, parameter)) {
      entry_parameter.is_uniform = true;
      const std::size_t number = uniforms++;
      if (number < arguments.size()) {
        AddArgument(context, var, parameter, arguments[number], entry_parameter);
      } else {
        entry_parameter.uniform_var = AddUniformParameter(context, var, parameter);
      }
    } else if (TakesObjects(context, parameter)) {
      entry_parameter.objects = AddUniformParameter(context, var, parameter);
    }
    signature.parameters.push_back(std::move(entry_parameter));
  }
  const bool names_all = context.options.call_names_parameters;
  const std::size_t wanted = names_all ? signature.parameters.size() : uniforms;
  if (!context.options.entry_call.empty() && arguments.size() != wanted)
    context.Report(decl.name_span, diag::EntryArguments, context.options.entry_call,
                   WithCount(arguments.size(), "argument"), context[decl.name],
                   WithCount(wanted, names_all ? "parameter" : "`uniform` parameter"));
  signature.result = DescribedResult(context, decl);
  signature.stages_match_by_row = context.options.stages_match_by_row;
  return signature;
}

void CheckGroupSize(Context& context, FunctionInfoId entry, const AttributeLists& attributes) {
  Program& program = context.program;
  const StageInfo& stage = InfoOf(program.stage);
  if (!stage.runs_in_groups) {
    // A parameter with the number of a thread has a message of its own.
    const bool has_inputs = !program.functions[program.entry].parameters.empty();
    const ast::Attr* attribute = FindAttribute(context, attributes, "numthreads");
    if (attribute && !has_inputs)
      context.Report(attribute->span, diag::AttributeMisplaced, "numthreads",
                     fmt::format("a {} shader{}", stage.name,
                                 signature::CompiledBy(InfoOf(Stage::kCompute), program.profile)));
    return;
  }
  const ViewSwitch in(context, {.scope = context[entry].scope, .order = context[entry].order});
  // A target has no way to ask for so many lanes.
  for (const std::span<const ast::Attr> list : attributes) {
    for (const ast::Attr& attribute : list) {
      if (EqualIgnoringCase(context[attribute.name], "wavesize"))
        context.Report(attribute.span, diag::AttributeWithoutEffect, context[attribute.name]);
    }
  }
  if (const ast::Attr* attribute = FindAttribute(context, attributes, "numthreads")) {
    ReadGroupSize(context, *attribute);
  } else {
    const Function& function = program.functions[program.entry];
    context.Report(function.span, diag::GroupSizeMissing, function.name);
  }
}

void LeaveOutStreams(Context& context, EntrySignature& signature) {
  const Program& program = context.program;
  const auto is_stream = [](const EntryParameter& parameter) { return parameter.is_stream; };
  auto left = std::ranges::count_if(signature.parameters, is_stream);
  if (left < 2) return;
  std::vector<bool> is_named(program.vars.size());
  for (const ExprId expr : program.exprs.ids()) {
    if (const auto* ref = context.GetIf<VarRef>(expr)) is_named[ref->var.index] = true;
  }
  const std::vector<VarId>& own = program.functions[program.entry].parameters;
  for (std::size_t i = std::min(own.size(), signature.parameters.size()); i-- > 0;) {
    EntryParameter& parameter = signature.parameters[i];
    if (!parameter.is_stream) continue;
    const Type& type = program.types[program.vars[parameter.uniform_var].type];
    context.program.emission.output = OutputOf(type.object);
    if (left == 1 || is_named[own[i].index]) return;
    parameter.is_stream = false;
    --left;
  }
}

void CheckEmission(Context& context, FunctionInfoId entry, const AttributeLists& attributes) {
  Program& program = context.program;
  if (!InfoOf(program.stage).emits_vertices || context.diagnostics.has_errors()) return;
  const ViewSwitch in(context, {.scope = context[entry].scope, .order = context[entry].order});
  const Function& function = program.functions[program.entry];
  Emission& emission = program.emission;
  if (!emission.takes_primitive)
    context.Report(function.span, diag::PrimitiveOfNone, function.name);
  if (emission.streams.empty()) context.Report(function.span, diag::StreamMissing, function.name);
  for (const Stream& stream : emission.streams) CheckStream(context, stream);
  CheckCounts(context, attributes);
  const ast::Attr* attribute = FindAttribute(context, attributes, "instance");
  if (!attribute) return;
  if (!program.profile.IsAtLeast(5, 0)) {
    context.Report(attribute->span, diag::QualifierProfile, "instance", "gs_5_0",
                   program.profile.name);
  } else if (const auto count = NumberIn(context, attributes, "instance", kMostInstances)) {
    emission.instances = *count;
  }
}

}  // namespace clipc::check
