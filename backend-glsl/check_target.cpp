// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/check_target.h"

#include <algorithm>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "backend-glsl/block_layout.h"
#include "backend-glsl/check_bindings.h"
#include "backend-glsl/check_expression.h"
#include "backend-glsl/images.h"
#include "backend-glsl/reach.h"
#include "backend-glsl/requirements.h"
#include "backend-glsl/write.h"
#include "ir/access.h"
#include "ir/scalar.h"
#include "ir/walk.h"
#include "legalize/es100/loops.h"
#include "legalize/split_arrays.h"

namespace clipc::glsl {

using namespace ir;

namespace {

// The most fields of a struct in place of an array; each is an `if` where the index is not
// constant.
constexpr std::uint32_t kMaxElements = 256;

class TargetCheck : ExpressionCheck {
 public:
  TargetCheck(const Program& program, const Target& target, BlockStyle blocks,
              std::span<const legalize::LongLoop> long_loops, Diagnostics& diagnostics)
      : ExpressionCheck(program, target,
                        target.Has(Feature::kUniformBlocks) && blocks != BlockStyle::kFlat,
                        diagnostics),
        blocks_(blocks),
        long_loops_(long_loops),
        reached_(Reach(program, target.KeepsBindings())),
        images_(UsesOfImages(program, reached_, target)) {}

  void Run() {
    const ir::Function& entry = program_.functions[program_.entry];
    const StageInfo& stage = clipc::InfoOf(program_.stage);
    if (stage.runs_in_groups && !target_.Has(Feature::kComputeShaders))
      return Lack(Feature::kComputeShaders, entry.span, diag::TargetComputeShader, entry.name);
    if (stage.emits_vertices && !target_.Has(Feature::kGeometryShaders))
      return Lack(Feature::kGeometryShaders, entry.span, diag::TargetGeometryShader, entry.name);
    if ((stage.makes_patches || stage.reads_patches) && !target_.Has(Feature::kTessellation))
      return Lack(Feature::kTessellation, entry.span, diag::TargetTessellation, entry.name,
                  stage.name);
    if (program_.emission.instances > 1)
      Check(Feature::kEmitters, diag::TargetEmission, entry.span, "instance");
    if (const auto& streams = program_.emission.streams; streams.size() > 1)
      Check(Feature::kStreams, diag::TargetEmission, program_.vars[streams[1].object].span,
            program_.vars[streams[1].object].name);
    for (const IoVar& input : program_.inputs) Input(input);
    for (const IoVar& output : program_.outputs) Output(output);
    if (program_.tests_early) Check(Feature::kEarlyTests, diag::TargetEarlyTests, entry.span);
    for (CbufferId id : program_.cbuffers.ids()) {
      if (reached_.Has(id)) Cbuffer(program_.cbuffers[id]);
    }
    for (const Resource& resource : program_.resources) {
      if (!reached_.Has(resource.var)) continue;
      // What a target lacks for a counter, it lacks for the buffer.
      if (resource.counter_of && reached_.Has(resource.counter_of)) continue;
      Object(program_.vars[resource.var]);
      if (IsOrdered(Innermost(program_.vars[resource.var].type).object))
        Check(Feature::kInterlocks, diag::TargetOrder, program_.vars[resource.var].span,
              program_.vars[resource.var].name);
      if (IsImage(Innermost(program_.vars[resource.var].type).object)) Image(resource);
      if (!target_.IsVulkan()) TextureUnit(resource);
      SubpassInput(resource);
    }
    if (target_.IsVulkan()) CheckBindings(program_, reached_, target_, diagnostics_);
    if (target_.IsVulkan() && target_.bindings.splits_arrays) WholeArrays();
    ConstantIds();
    if (!target_.Has(Feature::kPrecise)) Precise();
    for (VarId global : reached_.globals) {
      Type(program_.vars[global].type, program_.vars[global].span);
      Value(program_.vars[global]);
      if (program_.vars[global].init) {
        ForEachExpr(program_, program_.vars[global].init, [&](ExprId expr) { Expression(expr); });
      }
    }
    for (FunctionId id : reached_.functions) Function(program_.functions[id]);
    if (!looks_at_all_) {
      for (const ExprId expr : reached_.asked) Expression(expr);
    }
  }

 private:
  // Reports the arrays that BindingRules::splits_arrays leaves whole.
  void WholeArrays() {
    const auto report = [&](Span span, const std::string& name) {
      diagnostics_.Report(span, diag::OptionWithoutEffect, "-fspv-flatten-resource-arrays",
                          "the array `" + name + "` keeps its one binding");
    };
    for (const Resource& resource : program_.resources) {
      const Var& var = program_.vars[resource.var];
      const bool is_array =
          program_.types[var.type].kind == TypeKind::kArray && !resource.counter_of;
      if (is_array && reached_.Has(resource.var) &&
          legalize::SplitCount(program_, split_, resource.var) == 0)
        report(var.span, var.name);
    }
    for (const CbufferId id : program_.cbuffers.ids()) {
      const ir::Cbuffer& buffer = program_.cbuffers[id];
      if (buffer.count > 1 && reached_.Has(id)) report(buffer.span, buffer.name);
    }
  }

  // ---- inputs and outputs
  void Input(const IoVar& input) {
    if (!reached_.Has(input.var)) return;
    const Var& var = program_.vars[input.var];
    if (input.builtin == Builtin::kUntranslated) return UntranslatedInput(input, var.span);
    if (input.builtin == Builtin::kPixelPosition) return PixelPosition(input);
    if (input.builtin == Builtin::kNone && clipc::InfoOf(program_.stage).has_stage_before)
      return Varying(input);
    // OVR_multiview has no geometry shaders, and no tessellation.
    if (input.builtin == Builtin::kViewId && clipc::InfoOf(program_.stage).reads_vertices &&
        !target_.IsVulkan())
      diagnostics_.Report(var.span, diag::TargetPixelValue, input.semantic, target_.name());
    Check(RequirementOf(input.builtin, clipc::InfoOf(program_.stage)), var.span, input.semantic);
    DoubleVarying(input);
  }

  void UntranslatedInput(const IoVar& input, Span span) {
    const ir::Profile& profile = program_.profile;
    if (profile.IsDirect3D9() || profile.level9 != ir::Level9::kNone) {
      diagnostics_.Report(span, diag::ProfileInput, input.semantic, profile.name);
    } else {
      diagnostics_.Report(span, diag::SemanticNotForStage, input.semantic, "input",
                          clipc::InfoOf(program_.stage).name, "");
    }
  }

  void PixelPosition(const IoVar& input) {
    if (NeedsFramebufferHeight(program_, target_, input))
      Report(program_.vars[input.var].span, diag::TargetOrigin, input.semantic);
  }

  bool IsFloating(const IoVar& io) const {
    return IsFloat(program_.types[program_.vars[io.var].type].scalar);
  }

  // Checks the feature that the input or output needs if `needs_it`.
  void CheckIo(bool needs_it, Feature feature, const Requirement::Named& message, const IoVar& io) {
    if (needs_it)
      Check(feature, message, program_.vars[io.var].span, io.semantic + std::to_string(io.index));
  }

  // Checks an output to a render target.
  void RenderTarget(const IoVar& output) {
    CheckIo(output.blend_index > 0, Feature::kBlendIndices, diag::TargetPixelValue, output);
    const bool is_varying = !target_.Has(Feature::kInAndOut);
    CheckIo(is_varying && !IsFloating(output), Feature::kIntegerVaryings,
            diag::TargetIntegerVarying, output);
  }

  void Output(const IoVar& output) {
    if (output.builtin == Builtin::kNone && !clipc::InfoOf(program_.stage).has_stage_after)
      return RenderTarget(output);
    if (output.builtin == Builtin::kNone) return Varying(output);
    Check(RequirementOf(output.builtin, clipc::InfoOf(program_.stage)), PlaceOf(output),
          output.semantic);
  }

  // The place of an output in the source. A lowered output has none of its own: it gets that of the
  // first clip plane, or of the entry point.
  Span PlaceOf(const IoVar& output) const {
    if (program_.vars[output.var].span) return program_.vars[output.var].span;
    if (!program_.clip_planes.empty()) return program_.clip_planes.front().span;
    return program_.functions[program_.entry].span;
  }

  // Control points and constants of the patch share the locations.
  void CheckLocations(const IoVar& io) {
    constexpr std::uint32_t kLast = 31;
    const StageInfo& stage = clipc::InfoOf(program_.stage);
    const Var& var = program_.vars[io.var];
    const bool is_of_patches =
        var.storage == ir::Storage::kInput ? stage.reads_patches : stage.makes_patches;
    const std::uint32_t end = io.location + ir::LocationCount(program_.types[var.type]);
    if (is_of_patches && !target_.IsVulkan() && end > kLast + 1)
      diagnostics_.Report(var.span, diag::TargetLocations, io.semantic + std::to_string(io.index),
                          end - 1, target_.name(), kLast);
  }

  void Varying(const IoVar& output) {
    CheckLocations(output);
    const bool is_floating = IsFloating(output);
    const bool is_flat = output.interpolation == Interpolation::kNoInterpolation;
    CheckIo(!is_floating, Feature::kIntegerVaryings, diag::TargetIntegerVarying, output);
    CheckIo(is_flat && is_floating, Feature::kInAndOut, diag::TargetFlat, output);
    CheckIo(output.interpolation == Interpolation::kNoPerspective, Feature::kNoPerspective,
            diag::TargetNoPerspective, output);
    CheckIo(output.centroid, Feature::kCentroid, diag::TargetCentroid, output);
    CheckIo(output.sample, Feature::kPerSample, diag::TargetPerSample, output);
    DoubleVarying(output);
  }

  void DoubleVarying(const IoVar& io) {
    const ir::Type& type = program_.types[program_.vars[io.var].type];
    CheckIo(type.IsNumeric() && BaseOf(type.scalar) == Scalar::kDouble, Feature::kDoubleVaryings,
            diag::TargetDoubleVarying, io);
  }

  // ---- buffers and textures
  void Cbuffer(const ir::Cbuffer& cbuffer) {
    if (target_.IsVulkan() && !has_blocks_) {
      Report(cbuffer.span, diag::TargetFlatUniforms, cbuffer.name);
    }
    BufferSize(cbuffer);
    if (cbuffer.count == 0 && !target_.IsVulkan())
      return Report(cbuffer.span, diag::TargetArrayWithoutSize, cbuffer.name);
    for (const CbufferMember& member : cbuffer.members) {
      const Var& var = program_.vars[member.var];
      if (reached_.Has(member.var) || has_blocks_) Type(var.type, var.span);
    }
    if (cbuffer.kind != CbufferKind::kConstantBuffer || !has_blocks_) return;
    const ir::Type& type = TypeOf(cbuffer.members[0].var);
    if (type.kind != TypeKind::kArray) return;
    const bool is_nested = IsArray(type.element);
    const bool in_rows =
        LayOutBlock(program_, cbuffer, target_, blocks_, reached_.vars).form == BlockForm::kRows;
    const bool fits =
        in_rows ? target_.Has(Feature::kDynamicBlockIndex) && !is_nested
                : !is_nested || (target_.Has(Feature::kArraysOfArrays) && !target_.IsEs());
    if (!fits || !target_.Has(Feature::kBlockInstances)) {
      Report(cbuffer.span, diag::TargetConstantBufferArray, cbuffer.name);
    }
  }

  // Reports a constant buffer of more than Direct3D's 4096 registers, to which OpenGL's drivers
  // keep too. dxc reports it for Direct3D only (DXC's HLSLFileCheck,
  // CbufferLegacy/cbufferSize1.hlsl); a device of Vulkan has a limit of its own.
  void BufferSize(const ir::Cbuffer& cbuffer) {
    constexpr std::uint32_t kMaxBufferBytes = 65536;
    const ir::Profile& profile = program_.profile;
    const bool is_bound = cbuffer.kind != ir::CbufferKind::kTbuffer && !cbuffer.is_push_constant;
    const bool is_of_device = target_.IsVulkan() && profile.IsAtLeast(6, 0);
    if (!is_bound || is_of_device || profile.IsDirect3D9() || cbuffer.size <= kMaxBufferBytes)
      return;
    diagnostics_.Report(cbuffer.span, diag::ConstantBufferTooLarge, cbuffer.name, cbuffer.size,
                        kMaxBufferBytes);
  }

  // Reports what OpenGL ES lacks of an image, beside images as such.
  void Image(const Resource& resource) {
    const Var& var = program_.vars[resource.var];
    if (!target_.Has(Feature::kImages)) return;
    const ObjectInfo& info = InfoOf(Innermost(var.type).object);
    if (target_.IsEs() && info.axes == 1)
      return Check(RequirementOf(ObjectKind::kTexture1D), var.span, var.name);
    if (info.category == ObjectCategory::kTypedBuffer)
      Check(RequirementOf(ObjectKind::kBuffer), var.span, var.name);
    const std::string problem = ImageProblem(program_, images_, target_, resource);
    if (!problem.empty())
      Lack(Feature::kImageFormats, var.span, diag::TargetImageFormat, var.name, problem);
  }
  void Object(const Var& var) {
    const ir::Type& type = Innermost(var.type);
    const bool is_array = IsArray(var.type);
    if (type.object == ObjectKind::kTexture1DArray) {
      Check(RequirementOf(ObjectKind::kTexture1D), var.span, var.name);
    }
    Check(RequirementOf(type.object), var.span, var.name);
    if (is_array && IsStorageBuffer(type.object) && !target_.IsVulkan()) {
      Report(var.span, diag::TargetArrayOfBuffers, var.name);
    } else if (is_array && program_.types[var.type].count == 0 && !target_.IsVulkan()) {
      Report(var.span, diag::TargetArrayWithoutSize, var.name);
    }
    if (!type.element) return;
    if (program_.types[type.element].IsNumeric() && !IsFloat(program_.types[type.element].scalar)) {
      Check(Feature::kTextureFunctions, diag::TargetIntegerTexture, var.span, var.name);
    }
    Type(type.element, var.span);
  }

  // Reports the first precise variable, in place of all.
  void Precise() {
    for (const VarId id : program_.vars.ids()) {
      const Var& var = program_.vars[id];
      if (var.precise && reached_.Has(id)) return Report(var.span, diag::TargetPrecise);
    }
  }

  void ConstantIds() {
    std::map<std::uint32_t, const Var*> taken;
    for (const VarId size : program_.group_size_constants) {
      if (size && !reached_.Has(size) && !target_.IsVulkan())
        Report(program_.vars[size].span, diag::TargetConstantId, program_.vars[size].name);
    }
    for (const VarId global : reached_.globals) {
      const Var& constant = program_.vars[global];
      if (!constant.constant_id) continue;
      const auto [found, is_free] = taken.try_emplace(*constant.constant_id, &constant);
      if (!target_.IsVulkan())
        Report(constant.span, diag::TargetConstantId, constant.name);
      else if (!is_free)
        diagnostics_
            .Report(constant.span, diag::TargetConstantIdTwice, found->second->name, constant.name,
                    *constant.constant_id)
            .Note(found->second->span, diag::DeclaredHere, found->second->name);
    }
  }

  // Reports a [[vk::binding]] that OpenGL does not have for a texture.
  void TextureUnit(const Resource& resource) {
    const Var& var = program_.vars[resource.var];
    const ObjectKind kind = Innermost(var.type).object;
    const bool is_texture = !IsStorageBuffer(kind) && !IsImage(kind) &&
                            InfoOf(kind).category != ObjectCategory::kSampler;
    if (is_texture && target_.Has(Feature::kBindings) && resource.reg.descriptor &&
        resource.reg.descriptor->binding >= target_.TextureUnits())
      diagnostics_.Report(var.span, diag::TargetTextureUnit, var.name,
                          resource.reg.descriptor->binding, target_.name(), target_.TextureUnits());
  }

  // Reports a subpass input without the number of its attachment, which Vulkan's GLSL asks for.
  void SubpassInput(const Resource& resource) {
    const Var& var = program_.vars[resource.var];
    if (InfoOf(Innermost(var.type).object).category == ObjectCategory::kSubpass &&
        target_.IsVulkan() && !resource.input_attachment)
      Report(var.span, diag::TargetSubpassInput, var.name);
  }

  // Reports an array that is too long for the struct that takes its place where arrays are not
  // values.
  void Value(const Var& var) {
    if (target_.Has(Feature::kArrayValues)) return;
    if (const std::uint32_t count = LongestArray(var.type); count > kMaxElements)
      diagnostics_.Report(var.span, diag::TargetLongArray, var.name, count, target_.name(),
                          kMaxElements);
  }
  std::uint32_t LongestArray(TypeId id) const {
    const ir::Type& type = program_.types[id];
    if (type.kind == TypeKind::kArray) return std::max(type.count, LongestArray(type.element));
    std::uint32_t longest = 0;
    if (type.kind != TypeKind::kStruct) return longest;
    for (const Field& field : program_.types.StructOf(id).fields)
      longest = std::max(longest, LongestArray(field.type));
    return longest;
  }

  // ---- code
  void Function(const ir::Function& function) {
    for (VarId parameter : function.parameters) {
      Type(program_.vars[parameter].type, program_.vars[parameter].span);
      Value(program_.vars[parameter]);
    }
    std::vector<RefusedLoop> refused;
    if (!target_.Has(Feature::kFreeLoops)) refused = FindLoops(function.body);
    Statement(function.body);
    for (const auto& [span, why] : refused) Loop(span, why);
  }

  void Loop(Span span, std::string_view why) {
    const auto is_there = [&](const legalize::LongLoop& loop) { return loop.span == span; };
    const auto found = std::ranges::find_if(long_loops_, is_there);
    if (found == long_loops_.end())
      Report(span, diag::TargetLoop, why);
    else
      Report(span, diag::TargetLongLoop, found->limit, found->of);
  }

  // The loops that the target lacks. Keeps the indices of the others.
  struct RefusedLoop {
    Span span;
    std::string_view why;
  };
  std::vector<RefusedLoop> FindLoops(StmtId body) {
    loop_indices_.resize(program_.vars.size());
    std::vector<RefusedLoop> refused;
    const legalize::CountedLoops loops(program_, body);
    ForEachStmt(program_, body, [&](StmtId stmt) {
      CountedLoop loop;
      const std::string_view why = loops.WhyNot(stmt, loop);
      if (!why.empty())
        refused.push_back({program_.stmts[stmt].span, why});
      else if (loop.counter)
        loop_indices_[loop.counter.index] = 1;
    });
    return refused;
  }

  void Statement(StmtId id) {
    const ir::Stmt& stmt = program_.stmts[id];
    if (As<Switch>(id) && !target_.Has(Feature::kSwitch)) {
      Report(stmt.span, diag::TargetSwitch);
    }
    if (const auto* declare = As<Declare>(id)) {
      Type(program_.vars[declare->var].type, stmt.span);
      Value(program_.vars[declare->var]);
    }
    ForEachPart(
        program_, id,
        [&](ExprId expr) {
          if (looks_at_all_) ForEachExpr(program_, expr, [&](ExprId part) { Expression(part); });
        },
        [&](StmtId part) { Statement(part); });
  }

  const BlockStyle blocks_;
  const std::span<const legalize::LongLoop> long_loops_;
  const Reached reached_;
  const std::vector<ir::ObjectUse> images_;
  const bool looks_at_all_ = MayReportAll();
};

}  // namespace

void CheckTarget(const Program& program, const Target& target, BlockStyle blocks,
                 std::span<const legalize::LongLoop> long_loops, Diagnostics& diagnostics) {
  TargetCheck(program, target, blocks, long_loops, diagnostics).Run();
}

}  // namespace clipc::glsl
