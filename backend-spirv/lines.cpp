// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The lines of the source, for debuggers: those of the core of SPIR-V, or the instructions of the
// set NonSemantic.Shader.DebugInfo.100.
#include "backend-spirv/lines.h"

#include <spirv/unified1/NonSemanticShaderDebugInfo100.h>

namespace clipc::spirv {

using namespace ir;

namespace {

constexpr std::uint32_t kHlsl = 5;  // the language in DebugCompilationUnit, section 4.11 of the set
constexpr std::uint32_t kSetVersion = 1, kDwarfVersion = 4;

}  // namespace

// The string of a file, and the source that the set has of it. The main file has its text.
const Lines::File& Lines::FileOf(std::string_view name) {
  File& file = files_[std::string(name)];
  if (file.name != 0) return file;
  const bool is_main = name == debug_->file;
  file.name = module_.String(name);
  const std::string_view text =
      is_main && debug_->has_text ? std::string_view(debug_->text) : std::string_view();
  if (HasSet()) {
    Words operands{file.name};
    if (!text.empty()) operands.push_back(module_.String(text));
    file.source =
        module_.DebugGlobal(NonSemanticShaderDebugInfo100DebugSource, types_.Void(), operands);
  }
  if (is_main) module_.Source(file.name, HasSet() ? std::string_view() : text);
  return file;
}

void Lines::Start() {
  if (!debug_) return;
  if (debug_->has_tool) module_.Processed(debug_->tool);
  const Ref source = FileOf(debug_->file).source;
  if (!HasSet()) return;
  if (module_.minor_version() < 6) module_.Require("SPV_KHR_non_semantic_info");
  const auto set = [&](std::uint32_t instruction, const Words& operands) {
    return module_.DebugGlobal(instruction, types_.Void(), operands);
  };
  unit_ = set(NonSemanticShaderDebugInfo100DebugCompilationUnit,
              {types_.Uint(kSetVersion), types_.Uint(kDwarfVersion), source, types_.Uint(kHlsl)});
  type_ = set(NonSemanticShaderDebugInfo100DebugTypeFunction, {types_.Uint(0), types_.Void()});
}

// A function's line is that before its definition, or a scope of the set.
void Lines::StartFunction(const Function& function, Ref definition, Words& code) {
  scope_ = 0;
  line_ = wanted_ = {};
  if (!debug_ || !debug_->has_lines || !function.span) return;
  wanted_ = debug_->place(function.span);
  if (wanted_.line == 0) return;
  const File& file = FileOf(wanted_.file);
  if (!HasSet()) {
    spirv::Put(module_.functions, spv::Op::OpLine, {file.name, wanted_.line, wanted_.column});
    return;
  }
  const Ref name = module_.String(function.name), line = types_.Uint(wanted_.line);
  scope_ = module_.DebugGlobal(NonSemanticShaderDebugInfo100DebugFunction, types_.Void(),
                               Words{name, type_, file.source, line, types_.Uint(wanted_.column),
                                     unit_, name, types_.Uint(0), line});
  PutInSet(code, NonSemanticShaderDebugInfo100DebugFunctionDefinition, {scope_, definition});
}

void Lines::PutInSet(Words& code, std::uint32_t instruction, std::initializer_list<Ref> operands) {
  Words all{types_.Void(), module_.NewRef(), module_.DebugSet(), instruction};
  all.insert(all.end(), operands);
  spirv::Put(code, spv::Op::OpExtInst, all);
}

void Lines::Want(Span span) {
  if (!debug_ || !debug_->has_lines || !span) return;
  const SourcePlace place = debug_->place(span);
  if (place.line != 0 && (place.line != wanted_.line || place.file != wanted_.file))
    wanted_ = place;
}

void Lines::Put(Words& code) {
  if (wanted_.line == 0 || (line_.line == wanted_.line && line_.file == wanted_.file)) return;
  if (HasSet() && scope_ == 0) return;
  if (HasSet() && line_.line == 0)
    PutInSet(code, NonSemanticShaderDebugInfo100DebugScope, {scope_});
  line_ = wanted_;
  const File& file = FileOf(wanted_.file);
  if (!HasSet()) {
    spirv::Put(code, spv::Op::OpLine, {file.name, wanted_.line, wanted_.column});
    return;
  }
  const Ref line = types_.Uint(wanted_.line), column = types_.Uint(wanted_.column);
  PutInSet(code, NonSemanticShaderDebugInfo100DebugLine, {file.source, line, line, column, column});
}

}  // namespace clipc::spirv
