// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/usage.h"

#include <fmt/format.h>

#include "compiler/message.h"
#include "compiler/show_messages.h"
#include "frontend/lex/source.h"
#include "frontend/lex/source_text.h"

namespace clipc {

std::string CheckCommand(const CommandLine& command) {
  const CompileRequest& request = command.request;
  if (!command.table.empty() && !clip_table::FormatOf(command.table)) {
    return fmt::format("`{}` names no clip table; it ends in .json, .bin or .h", command.table);
  }
  if (request.variants && (!command.header.empty() || request.spirv))
    return "-Fh and -spirv write one shader; with --variants there are several";
  if (!command.variable.empty() && command.header.empty())
    return "-Vn names what -Fh writes; give that option too";
  if (!command.fragment.empty() && request.lowering != Lowering::kDiscard) {
    return "--fragment is for --lower=discard; with the other lowerings the fragment shader stays "
           "as it is";
  }
  if (!request.position_input.empty() && request.plane_space != PlaneSpace::kObject) {
    return "--position-input is for --plane-space=object; other spaces take the position that the "
           "shader computes";
  }
  if (request.pixel_shader.path.empty() && request.keep_outputs) {
    return "--keep-outputs is for --pixel-shader; without it every output is kept";
  }
  if (request.pixel_shader.path.empty() && request.zero_unwritten) {
    return "--zero-unwritten is for --pixel-shader, which says what is read";
  }
  return {};
}

CompileResult NoticesOf(const CommandLine& command) {
  CompileResult result;
  if (command.notices.all().empty()) return result;
  FrontendContext context;
  const Source nowhere(context, {});
  result.text = nowhere.RenderText(command.notices, command.request.colour);
  for (const Diagnostic& notice : command.notices.all())
    result.messages.push_back(ToMessage(notice, nowhere));
  return result;
}

std::string PrepareRequest(CommandLine& command) {
  CompileRequest& request = command.request;
  if (!command.fragment.empty()) {
    const std::string problem = ReadText(command.fragment, request.fragment.emplace());
    if (!problem.empty()) return fmt::format("cannot read `{}`: {}", command.fragment, problem);
  }
  request.structs = command.reflection.ends_with(".h");
  request.reflect = !command.reflection.empty() && !request.structs;
  request.list = !command.listing.empty();
  request.preprocess = !command.preprocessed.empty() || command.only_dependencies;
  request.gives_planes_to_device = !command.table.empty() || request.reflect;
  request.draw_text = command.format == MessageFormat::kText;
  request.colour = request.draw_text && command.colour.value_or(TerminalHasColour());
  return {};
}

}  // namespace clipc
