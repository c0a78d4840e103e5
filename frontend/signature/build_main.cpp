// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/signature/build_main.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

#include "base/spelling.h"
#include "frontend/signature/attribute_reads.h"
#include "frontend/signature/distance_vars.h"
#include "frontend/signature/interface_vars.h"
#include "frontend/signature/patch_inputs.h"
#include "frontend/signature/patch_outputs.h"
#include "frontend/signature/pixel_inputs.h"
#include "frontend/signature/semantic_check.h"
#include "frontend/signature/signature_leaves.h"
#include "frontend/signature/vertex_inputs.h"
#include "ir/access.h"
#include "ir/builder.h"

namespace clipc::signature {
namespace {

class MainBuilder {
 public:
  MainBuilder(Program& program, const EntrySignature& signature, PositionName position,
              Diagnostics& diagnostics)
      : program_(program),
        stage_(InfoOf(program.stage)),
        signature_(signature),
        diagnostics_(diagnostics),
        semantics_(program, position, diagnostics),
        builder_(program, program.functions[program.entry].span),
        leaves_(program, builder_, diagnostics) {}

  void Run() {
    body_.reserve(16);
    const Function& entry = program_.functions[program_.entry];
    leaves_.SetByRow(signature_.stages_match_by_row && stage_.has_stage_before);
    vars_.SetOfPatch(stage_.reads_patches);
    for (std::size_t i = 0; i < entry.parameters.size(); ++i)
      PrepareParameter(entry.parameters[i], signature_.parameters[i]);
    CenterPositions();
    distances_.FinishReads();
    attributes_.Finish();
    CallFunction(program_.entry, signature_);
    vars_.SetOfPatch(false);
    if (stage_.makes_patches && pending_outputs_.empty() && read_patch_.type)
      pending_outputs_ = patch_.PassOn(read_patch_, leaves_, body_);
    leaves_.SetByRow(signature_.stages_match_by_row);
    if (stage_.emits_vertices)
      WriteStreams();
    else
      WriteOutputs();
    if (signature_.patch && program_.tessellation.patch_function) WritePatch(*signature_.patch);
    vertices_.Finish();
    vars_.CheckDistances();
    vars_.PlaceConstants();
    leaves_.ReportMissing();
    semantics_.CheckPosition(signature_.has_later_stage);
    for (auto* list : {&program_.inputs, &program_.outputs}) SortByLocation(*list);
    const StmtId body = builder_.BlockOf(body_);
    program_.main = program_.functions.Add({"main", program_.types.Void(), {}, body, entry.span});
  }

 private:
  // Writes the outputs after the call of the entry, or after what body_ has.
  void WriteOutputs() {
    for (const Carrier& output : pending_outputs_) {
      for (const Carrier& leaf : leaves_.Of(output)) Output(leaf);
    }
    distances_.Write(body_);
  }

  // Writes the constants of the patch in the first control point, from the values that all have.
  void WritePatch(const EntrySignature& signature) {
    const Function function = program_.functions[program_.tessellation.patch_function];
    std::vector<StmtId> main = std::exchange(body_, {});
    arguments_.clear();
    pending_outputs_.clear();
    semantics_.NextFunction();
    vertices_.NextFunction();
    output_side_ = Direction::kPatchConstant;
    for (std::size_t i = 0; i < function.parameters.size(); ++i)
      PrepareParameter(function.parameters[i], signature.parameters[i]);
    CallFunction(program_.tessellation.patch_function, signature);
    vars_.SetOfPatch(true);
    WriteOutputs();
    const std::vector<StmtId> factors = patch_.WriteFactors(function.span);
    vars_.SetOfPatch(false);
    body_.insert(body_.end(), factors.begin(), factors.end());
    const StmtId block = builder_.BlockOf(body_);
    const bool waits = std::ranges::any_of(signature.parameters, &EntryParameter::is_of_points);
    body_ = std::move(main);
    if (waits)
      body_.push_back(builder_.Eval(
          builder_.IntrinsicOf(CommonIntrinsic::kEndPoints, program_.types.Void(), {})));
    const ExprId is_first = builder_.IntrinsicOf(CommonIntrinsic::kIsFirstPoint,
                                                 program_.types.Make(Scalar::kBool), {});
    body_.push_back(builder_.Stmt(If{is_first, block, {}}));
  }

  // Makes the functions that emit the vertices of the streams.
  void WriteStreams() {
    for (const Carrier& output : pending_outputs_)
      diagnostics_.Report(output.span, diag::OutputNotStream, output.name);
    for (const EntryParameter& parameter : signature_.parameters) {
      if (!parameter.is_stream) continue;
      const std::vector<StmtId> main = std::exchange(body_, {});
      const auto number = static_cast<std::uint32_t>(program_.emission.streams.size());
      if (number > 0) semantics_.NextStream();
      const Var object = program_.vars[parameter.uniform_var];
      const TypeId type = program_.types[object.type].element;
      const VarId vertex = program_.vars.Add(
          {.name = "vertex", .type = type, .storage = Storage::kIn, .span = object.span});
      pending_outputs_ = {{leaves_.Whole(vertex), type, object.name, object.span,
                           CursorOf(parameter), parameter.row_major}};
      WriteOutputs();
      body_.push_back(builder_.Eval(builder_.IntrinsicOf(
          CommonIntrinsic::kEmitVertex, program_.types.Void(), {builder_.Uint(number)})));
      const FunctionId emit = program_.functions.Add({"append_" + object.name,
                                                      program_.types.Void(),
                                                      {vertex},
                                                      builder_.BlockOf(body_),
                                                      object.span});
      program_.emission.streams.push_back({parameter.uniform_var, emit});
      body_ = main;
    }
  }

  // ---- parameters

  void PrepareParameter(VarId id, const EntryParameter& parameter) {
    const Var var = program_.vars[id];
    if (parameter.is_uniform) {
      arguments_.push_back(parameter.object ? parameter.object
                                            : builder_.Ref(parameter.uniform_var));
      return;
    }
    const bool reads = var.storage != Storage::kOut;
    const bool writes = var.storage != Storage::kIn;
    Carrier whole{kNoPart, var.type, var.name, var.span, CursorOf(parameter), parameter.row_major};
    if (parameter.is_of_vertices) return ReadElements(id, whole, Source::kVertices);
    if (parameter.is_of_points) return ReadElements(id, whole, Source::kPoints);
    if (!writes && program_.types[var.type].IsScalarOrVector()) {
      const std::span<const Carrier> leaves = leaves_.Of(whole);
      if (!leaves.empty()) arguments_.push_back(Input(leaves.front()));
      return;
    }
    const VarId local = builder_.Local(var.name, var.type);
    whole.part = leaves_.Whole(local);
    body_.push_back(builder_.Stmt(Declare{local, {}}));
    leaves_.SetTakesObjects(bool{parameter.objects});
    if (reads) ReadInto(whole, parameter.objects);
    leaves_.SetTakesObjects(false);
    arguments_.push_back(builder_.Ref(local));
    if (writes) pending_outputs_.push_back(std::move(whole));
  }

  // Where the leaves of a parameter have their values from.
  enum class Source : std::uint8_t { kInputs, kVertices, kPoints };

  // Reads the inputs of each vertex of the primitive, or what the control points wrote. Each is an
  // element of the parameter.
  void ReadElements(VarId id, Carrier whole, Source source) {
    const VarId local = builder_.Local(program_.vars[id].name, whole.type);
    whole.part = leaves_.Whole(local);
    body_.push_back(builder_.Stmt(Declare{local, {}}));
    vars_.SetOfPatch(false);
    const Type type = program_.types[whole.type];
    for (std::uint32_t i = 0; i < type.count; ++i) {
      Carrier vertex = whole;
      vertex.type = type.element;
      vertex.part = leaves_.Inside(whole.part, i);
      number_ = i;
      if (source == Source::kVertices) vertices_.Start(i);
      ReadInto(vertex, {}, source);
    }
    vars_.SetOfPatch(stage_.reads_patches);
    arguments_.push_back(builder_.Ref(local));
    if (!program_.profile.IsAtLeast(6, 0)) read_patch_ = whole;
  }

  // Assigns the inputs to the parts of `whole`, a matrix from all its columns at once, and textures
  // and samplers from those of `objects`.
  void ReadInto(const Carrier& whole, VarId objects, Source source = Source::kInputs) {
    std::vector<ExprId> columns;
    for (const Carrier& leaf : leaves_.Of(whole)) {
      const bool is_object = program_.types[leaf.type].kind == TypeKind::kObject;
      ExprId value = is_object                     ? InVar(leaves_.ValueOf(leaf.part), objects)
                     : source == Source::kVertices ? vertices_.Read(leaf)
                     : source == Source::kPoints   ? patch_.ReadPoint(leaf, number_, distances_)
                                                   : Input(leaf);
      if (!value) continue;
      PartNumber target = leaf.part;
      if (const Part part = leaves_[target]; part.columns > 0) {
        if (part.number == 0) columns.clear();
        columns.push_back(value);
        if (columns.size() < part.columns) continue;
        target = part.whole;
        const Type type = program_.types[leaf.type];
        value = leaves_.Transposed(builder_.ConstructOf(
            program_.types.Matrix(type.scalar, part.columns, type.columns), columns));
      }
      body_.push_back(builder_.Eval(builder_.AssignTo(leaves_.ValueOf(target), value)));
    }
  }

  // The path, into `var` in place of its own variable.
  ExprId InVar(ExprId path, VarId var) {
    ExprId root = path;
    while (const ExprId whole = WholeOf(program_, root)) root = whole;
    program_.exprs[root].node = VarRef{var};
    return path;
  }

  void CallFunction(FunctionId id, const EntrySignature& signature) {
    const Function& function = program_.functions[id];
    if (arguments_.size() != function.parameters.size()) return;  // an error was reported
    const ExprId call = builder_.CallOf(id, arguments_);
    if (function.return_type == program_.types.Void()) {
      body_.push_back(builder_.Eval(call));
      return;
    }
    const VarId result = builder_.Local("result", function.return_type);
    body_.push_back(builder_.Stmt(Declare{result, call}));
    pending_outputs_.push_back({leaves_.Whole(result), function.return_type, function.name,
                                function.span, ResultCursor(function, signature),
                                signature.result.row_major});
  }

  // The cursor of the result. A pixel's result without a semantic can only be its colour.
  Cursor ResultCursor(const Function& entry, const EntrySignature& signature) {
    Cursor cursor = CursorOf(signature.result);
    const bool is_colour = stage_.draws_pixels && !program_.is_interface_only && !cursor.given &&
                           program_.types[entry.return_type].IsScalarOrVector();
    if (!is_colour) return cursor;
    cursor.semantic = {.name = "SV_Target"};
    cursor.given = true;
    diagnostics_.Report(entry.span, diag::SemanticMissing, entry.name, "SV_Target");
    return cursor;
  }

  // ---- inputs

  // The input's value in the leaf's own type; none after an error.
  ExprId Input(const Carrier& leaf) {
    const auto side = stage_.reads_patches ? Direction::kPatchConstant : Direction::kInput;
    const SystemValue value = semantics_.LookUp(leaf, side);
    if (stage_.draws_pixels || stage_.emits_vertices) semantics_.CheckInterpolation(leaf);
    if (stage_.emits_vertices && value.builtin != Builtin::kPrimitiveId &&
        value.builtin != Builtin::kEmitterId && value.builtin != Builtin::kViewId &&
        value.use != SystemValue::Use::kRefused) {
      diagnostics_.Report(leaf.span, diag::InputNotOfVertex, leaf.name);
      return {};
    }
    if (stage_.makes_patches && !IsOfPatch(value)) return NoInputOfPatch(leaf, value);
    using Use = SystemValue::Use;
    // No output of the stage before matches what the rasterizer makes.
    const bool is_made = value.use == Use::kMade || value.use == Use::kBuiltin;
    if (is_made && program_.is_interface_only) return builder_.ZeroOf(leaf.type);
    if (value.use == Use::kPlain) {
      if (const VarId shared = SharedInput(leaf))
        return Fit(program_, builder_, builder_.Ref(shared), leaf.type);
    }
    if (value.use == Use::kRefused || !semantics_.MayAdd(leaf, side, value)) return {};
    const bool is_lacking =
        stage_.draws_pixels && !program_.is_interface_only && semantics_.Lacks(leaf.cursor, value);
    if (value.use == Use::kBuiltin && !is_lacking) return BuiltinInput(leaf, value);
    const bool is_plain = (value.use == Use::kPlain && !is_lacking) || program_.is_interface_only;
    if (is_plain && program_.profile.IsDirect3D9()) return Attribute(leaf);
    const Builtin builtin = is_plain ? Builtin::kNone : Builtin::kUntranslated;
    return Fit(program_, builder_,
               builder_.Ref(vars_.AddInput(leaf, StoredType(program_.types, leaf.type), builtin)),
               leaf.type);
  }

  // Whether a hull shader has the value beside its control points.
  bool IsOfPatch(const SystemValue& value) const {
    const bool is_point = value.builtin == Builtin::kControlPointId;
    return value.use == SystemValue::Use::kRefused || value.builtin == Builtin::kPrimitiveId ||
           value.builtin == Builtin::kViewId || (is_point && output_side_ == Direction::kOutput);
  }

  // A system value that the function does not have may be declared and not read.
  ExprId NoInputOfPatch(const Carrier& leaf, const SystemValue& value) {
    if (value.use != SystemValue::Use::kPlain)
      return Fit(program_, builder_,
                 builder_.Ref(vars_.AddInput(leaf, StoredType(program_.types, leaf.type),
                                             Builtin::kUntranslated)),
                 leaf.type);
    diagnostics_.Report(leaf.span, diag::InputNotOfPatch, leaf.name);
    return {};
  }

  // The input that a pixel shader has already for the same semantic and type; from 4.0 to 5.1 both
  // read it (vkd3d's entry-point-semantics.shader_test, checked against fxc).
  VarId SharedInput(const Carrier& leaf) {
    const bool shares = stage_.draws_pixels && !program_.is_interface_only &&
                        program_.profile.IsAtLeast(4, 0) && !program_.profile.IsAtLeast(6, 0);
    if (!shares) return {};
    const VarId input = attributes_.InputOf(leaf.cursor.semantic);
    return input && program_.vars[input].type == StoredType(program_.types, leaf.type) ? input
                                                                                       : VarId{};
  }

  // The part that this input has of the register that all inputs of its semantic read.
  ExprId Attribute(const Carrier& leaf) {
    VarId input = attributes_.InputOf(leaf.cursor.semantic);
    if (!input) input = vars_.AddInput(leaf, StoredType(program_.types, leaf.type), Builtin::kNone);
    return Fit(program_, builder_, attributes_.Read(input, program_.types[leaf.type].Components()),
               leaf.type);
  }

  // The value of a built-in input; none after an error.
  ExprId BuiltinInput(const Carrier& leaf, const SystemValue& value) {
    const Type type = program_.types[leaf.type];
    const Scalar kind = BaseOf(type.scalar);
    std::string_view wanted = "a `uint`";
    bool fits = IsInteger(kind) && type.Components() == 1;
    Builtin builtin = value.builtin;
    if (builtin == Builtin::kClipDistanceInput || builtin == Builtin::kCullDistanceInput)
      return distances_.Read(leaf, builtin);
    if (IsOfTessellator(builtin)) return tessellator_.Read(leaf, builtin, diagnostics_);
    if (builtin == Builtin::kBarycentrics) {
      if (leaf.cursor.interpolation == Interpolation::kNoPerspective)
        builtin = Builtin::kBarycentricsNoPerspective;
      wanted = "a `float3`";
      fits = kind == Scalar::kFloat && type.Components() == 3;
    } else if (IsNumberOfThread(builtin)) {
      wanted = "a `uint`, `uint2` or `uint3`", fits = IsInteger(kind) && type.Components() <= 3;
    } else if (value.builtin == Builtin::kPixelPosition) {
      wanted = "a `float4`", fits = kind == Scalar::kFloat;
    } else if (value.builtin == Builtin::kFrontFacing) {
      const bool is_sign = value.form == SystemValue::Form::kSign;
      wanted = is_sign ? "a `float`" : "a `bool`";
      fits = type.Components() == 1 &&
             (is_sign ? kind == Scalar::kFloat : kind == Scalar::kBool || IsInteger(kind));
    }
    // fxc's bool is the first sample's bit; DXC has no such bool.
    const bool is_first = builtin == Builtin::kCoverageInput && kind == Scalar::kBool &&
                          type.Components() == 1 && !program_.profile.IsAtLeast(6, 0);
    if (!fits && !is_first) {
      semantics_.Refuse(leaf, wanted);
      return {};
    }
    const auto known = std::ranges::find(program_.inputs, builtin, &IoVar::builtin);
    const VarId input = known != program_.inputs.end()
                            ? known->var
                            : vars_.AddInput(leaf, TypeOf(program_.types, builtin), builtin);
    if (value.builtin == Builtin::kPixelPosition) return PixelPosition(input, leaf, value.form);
    ExprId read = builder_.Ref(input);
    if (IsNumberOfThread(builtin) && type.Components() < 3)
      read = builder_.SwizzledRun(read, 0, type.Components());
    if (value.builtin == Builtin::kFrontFacing)
      return Fit(program_, builder_, FacingOf(builder_, read, kind), leaf.type);
    return Fit(program_, builder_, is_first ? FirstBitOf(program_, read) : read, leaf.type);
  }

  // The leading components of the position that the leaf has. Direct3D 9's pixels have whole
  // numbers, those of later versions their centres.
  ExprId PixelPosition(VarId input, const Carrier& leaf, SystemValue::Form form) {
    const std::uint32_t count = program_.types[leaf.type].Components();
    ExprId value = builder_.Ref(input);
    if (leaf.cursor.sample)
      value = BySample(value, leaf);
    else
      center_reads_.push_back(value);
    if (leaf.cursor.centroid)
      diagnostics_.Report(leaf.span, diag::QualifierWithoutEffect, "centroid",
                          "the position, which GLSL has at the pixel's center");
    if (count < 4) value = builder_.SwizzledRun(value, 0, count);
    if (form == SystemValue::Form::kCorner) value = CornerOf(builder_, value, count);
    return Fit(program_, builder_, value, leaf.type);
  }

  // The position of the sample: GLSL has it where the shader runs for each, which reading the
  // sample's number asks for.
  ExprId BySample(ExprId position, const Carrier& leaf) {
    constexpr auto kNumber = Builtin::kSampleIndex;
    auto number = std::ranges::find(program_.inputs, kNumber, &IoVar::builtin);
    if (number == program_.inputs.end()) {
      vars_.AddInput(leaf, TypeOf(program_.types, kNumber), kNumber);
      number = program_.inputs.end() - 1;
      number->semantic = "SV_SampleIndex", number->index = 0;
    }
    return AfterSampleNumber(builder_, position, builder_.Ref(number->var));
  }

  // Direct3D's position is the center of the pixel also where the shader runs for each sample
  // (vkd3d's eval-attrib.shader_test, checked against native); GLSL's is then the sample's.
  void CenterPositions() {
    const bool is_by_sample = std::ranges::any_of(program_.inputs, [](const IoVar& input) {
      return input.builtin == Builtin::kSampleIndex || input.sample;
    });
    if (!is_by_sample) return;
    for (const ExprId read : center_reads_) {
      const ExprId whole = builder_.CopyOf(builder_.TypeOf(read), program_.exprs[read].node);
      program_.exprs[read].node = program_.exprs[CenterOf(program_, whole)].node;
    }
  }

  // ---- outputs

  void Output(const Carrier& leaf) {
    // The outputs of a shader that is read for its interface match nothing.
    if (program_.is_interface_only)
      return WriteOutput(leaf, StoredType(program_.types, leaf.type), Builtin::kNone);
    const SystemValue value = semantics_.LookUp(leaf, output_side_);
    if (stage_.has_stage_after) semantics_.CheckInterpolation(leaf);
    if (value.use == SystemValue::Use::kRefused || !semantics_.MayAdd(leaf, output_side_, value))
      return;
    if (value.use == SystemValue::Use::kTarget && !semantics_.IsTarget(leaf)) return;
    // The first stream is the one that is drawn. Those after it are captured: all is data there.
    if (!program_.emission.streams.empty())
      return WriteOutput(leaf, StoredType(program_.types, leaf.type), Builtin::kNone);
    switch (value.builtin) {
      case Builtin::kNone:
        WriteOutput(leaf, StoredType(program_.types, leaf.type), value.builtin);
        return;
      case Builtin::kPosition: WriteFloats(leaf, "a `float4`", value.builtin); return;
      case Builtin::kPointSize:
      case Builtin::kDepth:
      case Builtin::kDepthGreaterEqual:
      case Builtin::kDepthLessEqual: WriteFloats(leaf, "a `float`", value.builtin); return;
      case Builtin::kClipDistance:
      case Builtin::kCullDistance:
        distances_.Add(leaf, value.builtin, [&] { return leaves_.ValueOf(leaf.part); });
        return;
      case Builtin::kTessFactor:
      case Builtin::kInsideFactor:
        return patch_.AddFactor(leaf, value.builtin, leaves_.ValueOf(leaf.part));
      default: WriteIndex(leaf, value.builtin); return;
    }
  }

  void WriteFloats(const Carrier& leaf, std::string_view wanted, Builtin builtin) {
    const Type type = program_.types[leaf.type];
    if (static_cast<int>(type.Components()) != InfoOf(builtin).components ||
        BaseOf(type.scalar) != Scalar::kFloat)
      return semantics_.Refuse(leaf, wanted);
    WriteOutput(leaf, TypeOf(program_.types, builtin), builtin);
  }

  void WriteIndex(const Carrier& leaf, Builtin builtin) {
    const Type type = program_.types[leaf.type];
    if (type.Components() != 1 || !IsInteger(type.scalar))
      return semantics_.Refuse(leaf, "a `uint`");
    WriteOutput(leaf, TypeOf(program_.types, builtin), builtin);
  }

  void WriteOutput(const Carrier& leaf, TypeId stored, Builtin builtin) {
    const VarId output = vars_.AddOutput(leaf, stored, builtin);
    ExprId value = Fit(program_, builder_, leaves_.ValueOf(leaf.part), stored);
    if (HasAllBitsForTrue(leaf)) value = builder_.UnaryOf(UnaryOp::kNegate, value);
    if (IsClampedOutput(program_, leaf.cursor.semantic.name, program_.types[stored]))
      value = builder_.IntrinsicOf(CommonIntrinsic::kSaturate, stored, {value});
    body_.push_back(builder_.Eval(builder_.AssignTo(builder_.Ref(output), value)));
  }

  // Whether `true` is all bits of a render target, as from 4.0 to 5.1, and not 1 (vkd3d's
  // arithmetic-float-uniform.shader_test, checked against native).
  bool HasAllBitsForTrue(const Carrier& leaf) const {
    return !stage_.has_stage_after && program_.types[leaf.type].scalar == Scalar::kBool &&
           program_.profile.IsAtLeast(4, 0) && !program_.profile.IsAtLeast(6, 0);
  }

  Program& program_;
  const StageInfo& stage_;
  const EntrySignature& signature_;
  Diagnostics& diagnostics_;
  SemanticCheck semantics_;
  Builder builder_;
  std::vector<StmtId> body_;
  std::vector<ExprId> arguments_;
  SignatureLeaves leaves_;
  std::vector<Carrier> pending_outputs_;
  std::vector<ExprId> center_reads_;  // of the position that is not the sample's
  AttributeReads attributes_{program_, builder_};
  InterfaceVars vars_{program_, diagnostics_};
  DistanceVars distances_{program_, builder_, semantics_, vars_};
  VertexInputs vertices_{program_, builder_, semantics_, vars_};
  PatchInputs tessellator_{program_, builder_, semantics_, vars_};
  Carrier read_patch_;  // the patch that a function of fxc passes on where it gives nothing
  PatchOutputs patch_{program_, builder_, semantics_, vars_, diagnostics_};
  Direction output_side_ = Direction::kOutput;
  std::uint32_t number_ = 0;  // of the element that ReadElements reads
};

}  // namespace

void BuildMain(Program& program, const EntrySignature& signature, PositionName position,
               Diagnostics& diagnostics) {
  MainBuilder(program, signature, position, diagnostics).Run();
}

}  // namespace clipc::signature
