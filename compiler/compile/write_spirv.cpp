// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/write_spirv.h"

#include <algorithm>
#include <cctype>
#include <string>

#include <fmt/format.h>

#include "backend-glsl/block_layout.h"
#include "backend-glsl/images.h"
#include "backend-glsl/reach.h"
#include "backend-spirv/needs.h"
#include "base/path.h"
#include "ir/access.h"

namespace clipc {
namespace {

// The type of a variable as SPV_GOOGLE_user_type has it: "texture2d:<float4>".
std::string UserType(const ir::TypeTable& types, ir::TypeId type) {
  std::string name = types.Name(types.Innermost(type));
  const std::size_t begin = std::min(name.find('<'), name.size());
  std::transform(name.data(), name.data() + begin, name.data(), [](char letter) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  });
  if (begin < name.size()) name.insert(begin, ":");
  std::erase(name, ' ');
  return name;
}

std::string UserType(const ir::Program& program, const ir::Cbuffer& cbuffer) {
  switch (cbuffer.kind) {
    case ir::CbufferKind::kCbuffer: return "cbuffer";
    case ir::CbufferKind::kTbuffer: return "tbuffer";
    case ir::CbufferKind::kConstantBuffer:
      return "constantbuffer:<" +
             program.types.Name(
                 program.types.Innermost(program.vars[cbuffer.members[0].var].type)) +
             ">";
    default: return {};
  }
}

// What SPIR-V needs to know of an image, a subpass or a structured buffer.
void Describe(const ir::Program& program, spirv::Interface::Object& object) {
  const ir::Var& var = program.vars[object.var];
  const ir::Type& type = program.types[program.types.Innermost(var.type)];
  const auto resource = std::ranges::find(program.resources, object.var, &ir::Resource::var);
  if (ir::IsImage(type.object)) object.format = glsl::ImageFormat(program, *resource);
  object.user_type =
      UserType(program.types, resource->declared_type ? resource->declared_type : var.type);
  object.input_attachment = resource->input_attachment;
}

spirv::Interface InterfaceOf(const ir::Program& program, const glsl::GlslInfo& info) {
  spirv::Interface interface;
  const auto add = [](std::vector<spirv::Interface::Variable>& to,
                      const std::vector<glsl::GlslInfo::Variable>& variables) {
    for (const auto& variable : variables)
      to.push_back({variable.name, variable.location, variable.is_used,
                    variable.needs_base_vertex_zero || variable.needs_base_instance_zero});
  };
  add(interface.inputs, info.inputs);
  add(interface.outputs, info.outputs);
  for (const glsl::GlslInfo::UniformBlock& block : info.blocks) {
    interface.blocks.push_back({{block.set.value_or(0), block.binding},
                                block.cbuffer,
                                block.name,
                                block.is_push_constant,
                                UserType(program, program.cbuffers[block.cbuffer])});
  }
  for (const glsl::GlslInfo::Object& object : info.objects) {
    interface.objects.push_back({{object.set.value_or(0), object.binding},
                                 object.texture ? object.texture : object.sampler,
                                 object.texture ? object.sampler : ir::VarId{},
                                 object.name});
    Describe(program, interface.objects.back());
  }
  return interface;
}

// The name has no folder, so that it does not matter where a shader is compiled.
spirv::Debug DebugOf(const SpirvRequest& request, const Source& source, std::string_view path) {
  spirv::Debug debug;
  const std::string name(path.substr(NameBegin(path)));
  debug.file = name;
  debug.text = source.MainText();
  debug.tool = "clipc " CLIPC_VERSION;
  debug.has_text = request.debug != SpirvDebug::kFile && request.debug != SpirvDebug::kSet;
  debug.has_lines = request.debug >= SpirvDebug::kLine;
  debug.has_tool = request.debug == SpirvDebug::kTool;
  if (request.debug >= SpirvDebug::kSet) debug.form = spirv::Debug::Form::kSet;
  debug.place = [&source, path, name](Span span) {
    const Place place = source.Resolve(span);
    return spirv::SourcePlace{place.file == path ? name : place.file, place.line, place.column};
  };
  return debug;
}

bool IsOfWave(ir::Builtin input) {
  return input == ir::Builtin::kLaneCount || input == ir::Builtin::kLaneIndex;
}

}  // namespace

legalize::Needs SpirvNeeds(const glsl::Target& target) {
  return spirv::NeedsOf(!target.IsVulkan(), target.Needs().split_arrays);
}

void CheckSpirv(const ir::Program& program, const glsl::Target& target, const SpirvRequest& request,
                Diagnostics& diagnostics) {
  using ir::IntrinsicCategory;
  constexpr std::uint32_t kFirstWithWaves = 3;
  const std::uint32_t minor = request.MinorVersion(target.IsVulkan());
  const bool has_waves = minor >= kFirstWithWaves;
  const auto report = [&](Span span, std::string_view name) -> Diagnostic& {
    return diagnostics.Report(span, diag::NotInSpirv, name, fmt::format("1.{}", minor),
                              target.IsVulkan() ? "Vulkan" : "OpenGL");
  };
  const auto report_wave = [&](Span span, std::string_view name) {
    Diagnostic& of = report(span, name);
    if (target.IsVulkan())
      of.Note({}, diag::PlainNote, "`-fspv-target-env=vulkan1.1` has it");
    else
      of.Note({}, diag::TargetNearest, "vulkan");
  };
  const glsl::Reached reached = glsl::Reach(program);
  for (const ir::IoVar& input : program.inputs) {
    if (!reached.Has(input.var)) continue;
    const Span span = program.vars[input.var].span;
    if (IsOfWave(input.builtin) && !has_waves) report_wave(span, input.semantic);
    if (input.builtin == ir::Builtin::kSampleCount) report(span, input.semantic);
  }
  if (has_waves) return;
  for (const ir::FunctionId function : reached.functions) {
    ir::ForEachExpr(program, program.functions[function].body, [&](ir::ExprId id) {
      const auto* call = ir::As<ir::IntrinsicCall>(program, id);
      if (!call) return;
      const IntrinsicCategory category = ir::CategoryOf(call->op);
      if (category == IntrinsicCategory::kWave || category == IntrinsicCategory::kQuad)
        report_wave(program.exprs[id].span, ir::NameOf(call->op));
    });
  }
}

spirv::Written WriteSpirv(const Lowered& lowered, const glsl::GlslInfo& info,
                          const glsl::WriteOptions& options, const SpirvRequest& request,
                          const DebugText& text) {
  const glsl::Target& target = lowered.target;
  spirv::Options made;
  made.minor_version = request.MinorVersion(target.IsVulkan());
  if (!request.entry.empty()) made.entry = request.entry;
  made.invariant = options.invariant;
  made.keeps_bindings = target.KeepsBindings();
  made.relaxed_precision = options.relaxed_precision;
  made.is_opengl = !target.IsVulkan();
  made.has_upper_left_origin = target.HasUpperLeftOrigin();
  made.has_reflection = request.has_reflection;
  if (request.debug_info && text.source) made.debug = DebugOf(request, *text.source, text.path);
  return spirv::Write(lowered.program, InterfaceOf(lowered.program, info), made);
}

}  // namespace clipc
