// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/write.h"

#include <utility>

#include "backend-glsl/writer/bindings.h"
#include "backend-glsl/writer/blocks.h"
#include "backend-glsl/writer/code.h"
#include "backend-glsl/writer/expr.h"
#include "backend-glsl/writer/interface.h"
#include "backend-glsl/writer/naming.h"
#include "backend-glsl/writer/objects.h"
#include "backend-glsl/writer/stmt.h"
#include "backend-glsl/writer/types.h"

namespace clipc::glsl {

using namespace ir;

namespace {

void WriteGlobals(Code& code) {
  for (const VarId id : code.reached.globals) {
    const Var& var = code[id];
    // HLSL's static variables start as zero.
    std::string value = var.init ? Argument(code, var.init) : ZeroText(code, var.type);
    const bool is_specialized = var.constant_id && code.target.IsVulkan();
    const bool is_const = is_specialized || code.constants.Has(id);
    const bool is_late = !code.Has(Feature::kGlobalInitializers) && !code.constants.HasValueOf(id);
    if (is_specialized) {
      code.sections.globals +=
          LayoutText({Concat("constant_id = ", std::to_string(*var.constant_id))});
    }
    Append(code.sections.globals, is_const ? "const " : "",
           Declaration(code, var.type, code.NameOf(id)), is_late ? "" : " = ", is_late ? "" : value,
           ";\n");
    // glslang 12 takes `precise vec4 a;` for a variable of `main`.
    const std::string_view precise = PreciseText(code, var.precise && !is_const);
    if (!precise.empty()) Append(code.sections.globals, precise, code.NameOf(id), ";\n");
    if (is_late) code.late_globals.emplace_back(code.NameOf(id), std::move(value));
  }
}

std::string Header(const Context& context) {
  std::string text = context.target.VersionLine() + "\n";
  for (const std::string& extension : context.extensions)
    Append(text, "#extension ", extension, " : require\n");
  for (const std::string& extension : context.enabled)
    Append(text, "#extension ", extension, " : enable\n");
  return text + "\n";
}

}  // namespace

std::string WriteGlsl(const Program& program, const Target& target, const WriteOptions& options,
                      GlslInfo* info) {
  GlslInfo unwanted;
  GlslInfo& chosen = info ? *info : unwanted;
  chosen = {};
  Code code(program, target, options, chosen);
  NameEverything(code);
  FindTextureUses(code);
  WriteBlocks(code);
  WriteObjects(code);
  WriteInputs(code);
  WriteOutputs(code);
  WriteGlobals(code);
  WriteFunctions(code);

  Sections& parts = code.sections;
  for (std::string* part : {&parts.objects, &parts.inputs, &parts.outputs, &parts.globals}) {
    if (!part->empty()) *part += "\n";
  }
  return Concat(Header(code), parts.structs, parts.blocks, parts.objects, parts.inputs,
                parts.outputs, parts.helpers, parts.globals, parts.functions);
}

}  // namespace clipc::glsl
