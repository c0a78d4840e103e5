// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer.h"

#include <utility>
#include <variant>

#include "backend-glsl/write.h"
#include "base/invariant.h"

namespace clipc::glsl {

using namespace ir;

Writer::Writer(const Program& program, const Target& target, const WriteOptions& options,
               GlslInfo& info, Reached reached)
    : program_(program),
      target_(target),
      options_(options),
      info_(info),
      reached_(std::move(reached)) {
  for (std::string* part : {&structs_, &blocks_, &inputs_, &outputs_, &functions_})
    part->reserve(1024);
  struct_used_.resize(program.types.structs().size());
  layouts_.resize(program.cbuffers.size());
  for (CbufferId id : program.cbuffers.ids()) {
    if (reached_.Has(id)) layouts_[id.index] = LayOutBlock(program, program.cbuffers[id], target);
  }
}

std::string Writer::Write() {
  NameEverything();
  FindTextureUses();
  Blocks();
  Objects();
  Inputs();
  Outputs();
  Globals();
  Functions();

  if (!objects_.empty()) objects_ += "\n";
  if (!inputs_.empty()) inputs_ += "\n";
  if (!outputs_.empty()) outputs_ += "\n";
  if (!globals_.empty()) globals_ += "\n";
  return Concat(Header(), structs_, blocks_, objects_, inputs_, outputs_, helpers_, globals_,
                functions_);
}

std::string Writer::Header() const {
  std::string text = target_.VersionLine() + "\n";
  for (const std::string& extension : extensions_)
    text += "#extension " + extension + " : require\n";
  return text + "\n";
}

void Writer::Globals() {
  for (VarId id : reached_.globals) {
    const Var& var = program_.vars[id];
    const std::string& name = var_names_[id.index];
    constant_ = true;
    // HLSL's static variables start as zero.
    const std::string value = var.init ? ArgumentOf(var.init) : ZeroText(var.type);
    const bool is_const = var.storage == Storage::kConstant && constant_;
    const std::string qualifier = is_const                                        ? "const "
                                  : var.precise && target_.Has(Feature::kPrecise) ? "precise "
                                                                                  : "";
    if (constant_ || target_.Has(Feature::kGlobalInitializers)) {
      globals_ += qualifier + Declaration(var.type, name) + " = " + value + ";\n";
    } else {
      globals_ += qualifier + Declaration(var.type, name) + ";\n";
      late_globals_.emplace_back(name, value);
    }
    if (!is_const) mutable_globals_.insert(id);
  }
}

void Writer::Functions() {
  out_ = &functions_;
  for (FunctionId id : reached_.functions) {
    if (id == program_.main) {
      Main();
    } else {
      OneFunction(id);
      functions_ += '\n';
    }
  }
}

void Writer::OneFunction(FunctionId id) {
  namer_.OpenScope();
  Line(Signature(id) + " {");
  ++indent_;
  Statements(BodyOf(program_, id));
  --indent_;
  Line("}");
  namer_.CloseScope();
}

std::string Writer::Signature(FunctionId id) {
  const Function& function = program_.functions[id];
  std::string parameters;
  for (VarId parameter : function.parameters) {
    const Var& var = program_.vars[parameter];
    std::string& name = var_names_[parameter.index];
    name = LocalName(var.name, "unused");
    if (!parameters.empty()) parameters += ", ";
    if (var.storage == Storage::kOut) parameters += "out ";
    if (var.storage == Storage::kInOut) parameters += "inout ";
    parameters += Declaration(var.type, name);
  }
  return TypeName(function.return_type) + " " + function_names_[id.index] + "(" + parameters + ")";
}

void Writer::Main() {
  namer_.OpenScope();
  Line("void main() {");
  ++indent_;
  for (const auto& [name, value] : late_globals_) Line(name + " = " + value + ";");
  // uint in HLSL, int in GLSL: the shader's own variable first, converted at the end.
  std::vector<std::pair<std::string, std::string>> conversions;
  for (VarId id : integer_outputs_) {
    std::string& name = var_names_[id.index];
    const std::string builtin = std::exchange(name, namer_.Local(program_.vars[id].name));
    Line(Declaration(program_.vars[id].type, name) + ";");
    conversions.emplace_back(builtin, name);
  }
  Statements(MainBody(program_));
  for (const auto& [builtin, name] : conversions) Line(builtin + " = int(" + name + ");");
  --indent_;
  Line("}");
  namer_.CloseScope();
}

std::string WriteGlsl(const Program& program, Reached reached, const Target& target,
                      const WriteOptions& options, GlslInfo* info) {
  GlslInfo unwanted;
  GlslInfo& chosen = info ? *info : unwanted;
  chosen = {};
  return Writer(program, target, options, chosen, std::move(reached)).Write();
}

}  // namespace clipc::glsl
