// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/check.h"

#include <memory>
#include <utility>

#include "frontend/check/body.h"
#include "frontend/check/buffer.h"
#include "frontend/check/clip_planes.h"
#include "frontend/check/declare.h"
#include "frontend/check/describe_entry.h"
#include "frontend/check/ends.h"
#include "frontend/check/entry.h"
#include "frontend/check/entry_point.h"
#include "frontend/check/entry_signature.h"
#include "frontend/check/global.h"
#include "frontend/check/hull.h"
#include "frontend/check/real_literal.h"
#include "frontend/check/reserved.h"
#include "frontend/check/self.h"
#include "frontend/check/static_effects.h"
#include "frontend/check/static_local.h"
#include "frontend/check/tessellation.h"
#include "frontend/parse/attributes.h"
#include "frontend/resolve/resolve.h"
#include "frontend/signature/build_main.h"
#include "ir/packing.h"

namespace clipc {
namespace check {
namespace {

// The function whose clip planes the shader has, and its attributes: the entry, or where that has
// none, a stage before it that the options name.
std::pair<FunctionInfoId, AttributeLists> PlanesOf(Context& context, FunctionInfoId entry,
                                                   const AttributeLists& attributes) {
  std::pair<FunctionInfoId, AttributeLists> owner{entry, attributes};
  for (const std::string& name : context.options.planes_entries) {
    const FunctionInfoId other = FindEntry(context, name);
    if (!other) continue;
    AttributeLists of_other = AttributesOf(context, other);
    const ast::Attr* second = FindAttribute(context, of_other, kClipPlanesAttribute);
    const ast::Attr* first = FindAttribute(context, owner.second, kClipPlanesAttribute);
    if (first && second)
      context.Report(first->span, diag::ClipPlanesTwice).Note(second->span, diag::FirstGivenHere);
    if (!first) owner = {other, std::move(of_other)};
  }
  return owner;
}

// Checks the entry function and makes `main`; without bodies only what the signature and the clip
// planes name.
void CheckEntry(Context& context, FunctionInfoId entry, const AttributeLists& attributes,
                EntryBodies bodies) {
  Program& program = context.program;
  program.entry = Reach(context, entry);
  CheckRepeated(context, attributes);
  EntrySignature signature = SignatureOf(context, entry);
  CheckTessellation(context, entry, attributes);
  if (InfoOf(program.stage).makes_patches)
    signature.patch = std::make_shared<const EntrySignature>(ReadHull(context, entry, attributes));
  const auto [planes_of, planes] = PlanesOf(context, entry, attributes);
  ReachClipPlanes(context, planes_of, planes);
  if (bodies == EntryBodies::kCheck) {
    CheckBodies(context);
    ReachStaticEffects(context);
    CheckRecursion(context);
    CheckHull(context);
    if (context.options.keeps_bindings) ReachAllBindings(context);
  }
  FinishBuffers(context);
  for (CbufferId id : program.cbuffers.ids())
    LayOut(program.types, program.vars, program.cbuffers[id], program.profile.IsDirect3D9());
  CheckTessellation(context, entry, attributes);
  LeaveOutStreams(context, signature);
  BuildMain(program, signature, context.options.position_name, context.diagnostics);
  if (!context.diagnostics.has_errors()) CheckUniformCalls(context);
  JudgeEnds(context);
  if (InfoOf(program.stage).draws_pixels)
    program.tests_early = HasAttribute(context, attributes, "earlydepthstencil");
  CheckGroupSize(context, entry, attributes);
  CheckEmission(context, entry, attributes);
  CheckClipPlanes(context, planes_of, planes);
}

void Run(Context& context, const ir::PassOptions& passes) {
  DeclareAll(context, context.file.top_level, context.names.global());
  const FunctionInfoId entry = FindEntry(context, context.options.entry);
  if (!entry || context[entry].is_broken) return;
  Program& program = context.program;
  const AttributeLists attributes = AttributesOf(context, entry);
  CheckEntry(context, entry, attributes, EntryBodies::kCheck);
  CheckUnusedClipPlanes(context, attributes);
  FinishGlobals(context);
  if (!context.diagnostics.has_errors()) SettleStaticLocals(context);
  ReportInfinite(context);
  ResetStatics(context);
  resolve::Resolve(program,
                   {.is_specialised = !context.options.entry_call.empty(),
                    .has_preshader = context.options.has_preshader,
                    .shadow_samplers = context.options.shadow_samplers,
                    .struct_registers = context.globals.struct_registers,
                    .registers_of_unused = [&] { return RegistersOfUnused(context); }},
                   passes, context.diagnostics);
}

}  // namespace
}  // namespace check

EntryPoint CheckEntryPoint(const ast::File& file, const CheckOptions& options, EntryBodies bodies,
                           Diagnostics& diagnostics) {
  check::Context context(file, options, diagnostics);
  DeclareAll(context, file.top_level, context.names.global());
  const check::FunctionInfoId entry = FindEntry(context, options.entry);
  if (!entry || context[entry].is_broken) return {};
  const check::AttributeLists attributes = AttributesOf(context, entry);
  check::CheckEntry(context, entry, attributes, bodies);
  if (diagnostics.has_errors()) return {};
  EntryPoint described = Describe(context, entry, attributes);
  described.program = std::move(context.program);
  return described;
}

ir::Program Check(const ast::File& file, const CheckOptions& options, Diagnostics& diagnostics,
                  const ir::PassOptions& passes) {
  check::Context context(file, options, diagnostics);
  check::Run(context, passes);
  return std::move(context.program);
}

}  // namespace clipc
