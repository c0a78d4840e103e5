// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/write_spirv.h"

#include <algorithm>
#include <cctype>
#include <string>

#include "backend-glsl/block_layout.h"
#include "backend-glsl/images.h"
#include "base/path.h"

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

// The minor version of the SPIR-V that a version of Vulkan has.
std::uint32_t MinorVersion(const SpirvRequest& request) {
  constexpr std::uint32_t kMinor[] = {0, 3, 5, 6, 4};  // by VulkanVersion
  return request.version.value_or(kMinor[static_cast<std::size_t>(request.vulkan)]);
}

}  // namespace

spirv::Written WriteSpirv(const ir::Program& program, const glsl::GlslInfo& info,
                          const glsl::Target& target, const glsl::WriteOptions& options,
                          const SpirvRequest& request, const Source* source,
                          std::string_view path) {
  constexpr int kFirstVersion = 420;  // that has bindings
  if (!target.IsVulkan() && (target.IsEs() || target.version() < kFirstVersion))
    return {{}, "GLSL of an older version"};
  spirv::Options made;
  made.minor_version = MinorVersion(request);
  if (!request.entry.empty()) made.entry = request.entry;
  made.nan_clamp = request.nan_clamp;
  made.invariant = options.invariant;
  made.is_opengl = !target.IsVulkan();
  if (made.is_opengl) made.minor_version = 0;
  made.has_upper_left_origin = target.HasUpperLeftOrigin();
  made.has_reflection = request.has_reflection;
  if (request.debug_info && source) made.debug = DebugOf(request, *source, path);
  return spirv::Write(program, InterfaceOf(program, info), made);
}

}  // namespace clipc
