// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/reference-compiler/compare.h"

#include <algorithm>
#include <regex>

#include "tools/draw/feed.h"
#include "tools/draw/vulkan/bind.h"
#include "tools/harness/options.h"
#include "tools/reference-compiler/glslang.h"
#include "tools/reference-compiler/interface.h"
#include "tools/reference-compiler/known_bugs.h"
#include "tools/reference-compiler/plain_text.h"

namespace clipc::draw::reference_compiler {
namespace {

// Removes the attributes for Vulkan, which mean nothing to Direct3D compilers.
std::string WithoutVulkanAttributes(const std::string& hlsl) {
  return std::regex_replace(hlsl, std::regex(R"(\[\[vk::[^\]]*\]\])"), "");
}

Module Compile(const BuildOptions& options) {
  Module module;
  module.hlsl = WithoutVulkanAttributes(harness::ReadFile(options.path));
  HlslSource source{options.path, module.hlsl, options.entry, options.defines,
                    options.include_dirs};
  source.row_major = options.packing == MatrixPacking::kRowMajor;
  try {
    module.declared = SpirvOfHlsl(source, false);
  } catch (const DrawError&) {
    module.hlsl = source.text =
        WithoutVulkanAttributes(PlainText(Preprocess(options), options.entry));
    module.declared = SpirvOfHlsl(source, false);
  }
  module.run = SpirvOfHlsl(source, true);
  module.blocks = BlocksOf(module.declared);
  module.elements = ElementsOf(module.declared);
  module.inputs = InputsOf(module.declared);
  module.outputs = OutputsOf(module.declared);
  return module;
}

// Runs the reference compiler's shader. Returns its outputs in the order of program.outputs; an
// output that it does not write has no words.
std::vector<Captured> Run(const Runner& runner, const Module& module, const ir::Program& program,
                          const RandomInputs& random, const RandomOptions& draw) {
  const std::vector<Output> outputs = vulkan::OutputsOf(module.run);
  const auto writes = [&](const char* name) {
    return std::ranges::find(outputs, name, &Output::name) != outputs.end();
  };
  if (writes("gl_ClipDistance") && writes("gl_CullDistance"))
    throw DrawError("clip and cull distances at once, which lavapipe does not capture");
  const DrawCall call = MakeDrawCall(program, module, random, draw);
  return PickOutputs(program, module, outputs, runner.Capture(module.run, outputs, call));
}

Comparison Compare(const Shader& shader, const BuildOptions& options, const RandomInputs& random,
                   const std::vector<Captured>& captured, const Tolerance& tolerance) {
  const std::vector<Expected> expected = MakeExpected(shader, options, random);
  const std::vector<const Expected*> defined = Defined(expected);
  std::vector<Captured> matching;
  for (const Expected* output : defined) matching.push_back(captured[output - expected.data()]);
  return CompareOutputs(defined, matching, tolerance);
}

// Returns the bugs of the reference compiler that no rewriting shows and that the shader's text
// invites.
std::set<std::string> BugsInText(const std::string& hlsl, const Comparison& found) {
  if (found.missing == 0 && std::regex_search(hlsl, std::regex(R"(\[\s*\]\s*=\s*\{)")))
    return {"unsized-initializer"};
  return {};
}

// Whether a signature has a matrix that is taken apart by column.
bool HasColumns(const ir::TypeTable& types, ir::TypeId id, bool row_major) {
  const ir::TypeId inner = types.Innermost(id);
  if (types[inner].kind == ir::TypeKind::kMatrix) return !row_major;
  return types[inner].kind == ir::TypeKind::kStruct &&
         std::ranges::any_of(types.StructOf(inner).fields, [&](const ir::Field& field) {
           return HasColumns(types, field.type, field.row_major);
         });
}
bool EntryHasColumns(const ir::Program& program, bool row_major) {
  const ir::Function& entry = program.functions[program.entry];
  return HasColumns(program.types, entry.return_type, row_major) ||
         std::ranges::any_of(entry.parameters, [&](ir::VarId parameter) {
           return HasColumns(program.types, program.vars[parameter].type, row_major);
         });
}

// Whether two members of a block share bytes: then no values can be right.
bool HasOverlap(const std::vector<ReferenceBlock>& blocks) {
  for (const ReferenceBlock& block : blocks) {
    Offsets bytes;
    for (const auto& [name, places] : block.members)
      bytes.insert(bytes.end(), places.begin(), places.end());
    std::ranges::sort(bytes);
    if (std::ranges::adjacent_find(bytes) != bytes.end()) return true;
  }
  return false;
}

bool TakesSystemValues(const ir::IoVars& list, const std::vector<Vector>& vectors) {
  const std::vector<const Vector*> matches = Match(list, vectors);
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (matches[i] && list[i].builtin != ir::Builtin::kNone) return true;
  }
  return false;
}

}  // namespace

ReferenceComparison CompareWithGlslang(const Runner& runner, const Shader& shader,
                                       const BuildOptions& options, const RandomOptions& draw,
                                       const Tolerance& tolerance) {
  const Module module = Compile(options);
  RandomInputs random = MakeRandomInputs(shader.typed, draw);
  ReferenceComparison result;
  const std::vector<Captured> captured = Run(runner, module, shader.lowered, random, draw);
  result.values = Compare(shader, options, random, captured, tolerance);
  if (result.values.wrong > 0) {
    Shader mistaken = shader;
    std::set<std::string> bugs = ApplyValueBugs(mistaken.typed);
    Comparison again = Compare(mistaken, options, random, captured, tolerance);
    if (again.wrong > 0 && GiveInitialValues(shader.lowered, module.blocks, module.hlsl, random)) {
      bugs.insert("global-initializer");
      again = Compare(mistaken, options, random, captured, tolerance);
    }
    if (again.wrong == 0) {
      result.values = again;
    } else {
      const bool row_major = options.packing == MatrixPacking::kRowMajor;
      bugs = HasOverlap(module.blocks)                  ? std::set<std::string>{"register-c"}
             : EntryHasColumns(shader.typed, row_major) ? std::set<std::string>{"matrix-signature"}
                                                        : BugsInText(module.hlsl, again);
      if (!bugs.empty()) result.values.wrong = 0;
    }
    result.known_bugs.merge(bugs);
  }
  if (!shader.typed.clip_planes.empty()) result.known_bugs.insert("clip-planes");
  if (TakesSystemValues(shader.lowered.inputs, module.inputs) ||
      TakesSystemValues(shader.lowered.outputs, module.outputs)) {
    result.known_bugs.insert("system-values");
  }
  return result;
}

}  // namespace clipc::draw::reference_compiler
