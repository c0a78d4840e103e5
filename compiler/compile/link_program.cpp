// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/link_program.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "compiler/compile/neighbour.h"
#include "ir/access.h"
#include "ir/intrinsic.h"
#include "ir/walk.h"
#include "link/match.h"
#include "link/read.h"

namespace clipc {
namespace {

// Forgets names that the request knows better: those of HLSL and SPIR-V depend on what is made of
// them.
void ForgetNames(link::Interface& neighbour, bool is_glsl) {
  for (link::Input& input : neighbour.inputs) {
    if (!input.group && (input.location || !is_glsl)) input.name.clear();
  }
  for (link::UniformBlock& block : neighbour.blocks) {
    if (!is_glsl) block.name.clear();
  }
}

// Makes what the rasteriser alone reads a value like any other, before a stage that reads it from
// vertices: there Direct3D passes it on ("Signature Points" of DXC's DXIL.rst: SV of VSOut, HSIn
// and GSVIn), and GLSL does not.
void PassToNext(ir::Program& program) {
  for (ir::IoVar& output : program.outputs) {
    if (output.builtin == ir::Builtin::kLayer || output.builtin == ir::Builtin::kViewportIndex)
      output.builtin = ir::Builtin::kNone;
  }
}

// An output that GLSL has a variable for, and the input that it becomes.
struct PassedOn {
  ir::Builtin output, input;
};
constexpr PassedOn kPassedOn[] = {{ir::Builtin::kPosition, ir::Builtin::kPositionInput},
                                  {ir::Builtin::kPointSize, ir::Builtin::kPointSizeInput},
                                  {ir::Builtin::kClipDistance, ir::Builtin::kClipDistanceInput},
                                  {ir::Builtin::kCullDistance, ir::Builtin::kCullDistanceInput},
                                  {ir::Builtin::kPrimitiveIdOutput, ir::Builtin::kPrimitiveId}};

const ir::IoVar* Find(const ir::IoVars& list, ir::Builtin builtin) {
  const auto found = std::ranges::find(list, builtin, &ir::IoVar::builtin);
  return found == list.end() ? nullptr : &*found;
}

// The number of distances; 1 of another variable.
std::uint32_t CountOf(const ir::Program& program, const ir::IoVar& io) {
  const ir::Type& type = program.types[program.vars[io.var].type];
  return type.kind == ir::TypeKind::kArray ? type.count : 1;
}

// The number of distances that the lowering makes of the clip planes, in every variant.
std::size_t PlaneDistances(const Job& job, const ir::Program& program) {
  const bool are_written =
      job.plan.lowering.lowering == Lowering::kClipDistance && !job.request.planes.variants;
  return are_written ? program.clip_planes.size() : 0;
}

// What a message says of an input of which `count` components are written.
std::string Unwritten(const ir::Program& program, const ir::IoVar& read, std::uint32_t count) {
  std::string name = read.semantic;
  std::uint32_t component = count;
  for (const ir::DistancePiece& piece : program.distances) {
    if (piece.array != read.var || piece.first + piece.count <= count) continue;
    if (piece.index > 0) name += std::to_string(piece.index);
    component = piece.component + std::max(piece.first, count) - piece.first;
    break;
  }
  return component == 0 ? fmt::format("`{}`", name)
                        : fmt::format("component {} of `{}`", component, name);
}

// The tools below match variables by semantic, location or name, which these do not have in GLSL.
void CheckBuiltins(Job& job, const ir::Program& program, const ir::Program& next) {
  for (const auto& [output, input] : kPassedOn) {
    const ir::IoVar* read = Find(next.inputs, input);
    // Only a stage that emits primitives gives them numbers.
    const bool is_given =
        input == ir::Builtin::kPrimitiveId && !InfoOf(program.stage).emits_vertices;
    if (!read || is_given) continue;
    const ir::IoVar* written = Find(program.outputs, output);
    std::size_t count = written ? CountOf(program, *written) : 0;
    if (output == ir::Builtin::kClipDistance) count = std::max(count, PlaneDistances(job, program));
    if (count >= CountOf(next, *read)) continue;
    job.diagnostics.Report(
        program.functions[program.entry].span, diag::BuiltinUnwritten, InfoOf(program.stage).name,
        Unwritten(next, *read, static_cast<std::uint32_t>(count)), InfoOf(next.stage).name);
  }
}

// Calls visit(ExprId) for each expression that is the array, or what it is at a vertex.
template <typename Visit>
void ForEachRead(const ir::Program& program, ir::VarId input, Visit&& visit) {
  const auto is_input = [&](ir::ExprId expr) {
    const auto* ref = ir::As<ir::VarRef>(program, expr);
    return ref && ref->var == input;
  };
  ir::ForEachLiveExpr(program, [&](ir::ExprId id) {
    const auto* call = ir::As<ir::IntrinsicCall>(program, id);
    const bool is_read = call && call->op == ir::CommonIntrinsic::kInputOfVertex &&
                         is_input(program.expr_lists[call->arguments][0]);
    if (is_read || is_input(id)) visit(id);
  });
}

// Gives an array another number of elements.
void Resize(ir::Program& program, ir::VarId input, std::uint32_t count) {
  const ir::TypeId type =
      program.types.Array(program.types[program.vars[input].type].element, count);
  program.vars[input].type = type;
  ForEachRead(program, input, [&](ir::ExprId id) { program.exprs[id].type = type; });
}

// The distances that a stage writes: by hand, or as the lowering makes them of the clip planes,
// which are the components of the first two indices in order.
struct WrittenDistances {
  std::vector<ir::DistancePiece> pieces;
  std::uint32_t count = 0;  // of the elements of the array
};

WrittenDistances DistancesOf(const ir::Program& program, ir::Builtin output) {
  WrittenDistances written;
  if (const ir::IoVar* array = Find(program.outputs, output)) {
    written.count = CountOf(program, *array);
    std::ranges::copy_if(program.distances, std::back_inserter(written.pieces),
                         [&](const ir::DistancePiece& piece) { return piece.array == array->var; });
  } else if (output == ir::Builtin::kClipDistance) {
    written.count = static_cast<std::uint32_t>(program.clip_planes.size());
    for (std::uint32_t first = 0; first < written.count; first += 4)
      written.pieces.push_back({{}, first / 4, first, std::min(written.count - first, 4u)});
  }
  return written;
}

// Returns for each element of an array of distances that a stage reads where the stage before has
// the component of the same semantic, and after all that it writes those that it does not write.
// Makes the pieces of the array those, one for each element.
std::vector<std::uint32_t> MovePieces(ir::Program& program, ir::VarId input,
                                      const WrittenDistances& written) {
  std::vector<std::uint32_t> places(program.types[program.vars[input].type].count);
  std::iota(places.begin(), places.end(), 0u);
  std::vector<ir::DistancePiece> pieces;
  std::uint32_t end = written.count;
  for (const ir::DistancePiece& read : program.distances) {
    if (read.array != input) pieces.push_back(read);
    for (std::uint32_t i = 0; read.array == input && i < read.count; ++i) {
      const auto same = std::ranges::find_if(written.pieces, [&](const ir::DistancePiece& piece) {
        return piece.index == read.index && i < piece.count;
      });
      const std::uint32_t place = same == written.pieces.end() ? end++ : same->first + i;
      places[read.first + i] = place;
      pieces.push_back({input, read.index, place, 1, i});
    }
  }
  program.distances = std::move(pieces);
  return places;
}

// Makes the reads of an array those of the elements `places[i]`; elements in gaps have no read.
void MoveReads(ir::Program& program, ir::VarId input, const std::vector<std::uint32_t>& places) {
  std::vector<ir::ExprId> arrays;
  ForEachRead(program, input, [&](ir::ExprId id) { arrays.push_back(id); });
  std::ranges::sort(arrays);
  ir::ForEachLiveExpr(program, [&](ir::ExprId id) {
    const auto* at = ir::As<ir::Index>(program, id);
    if (!at || !std::ranges::binary_search(arrays, at->base)) return;
    auto& element = std::get<ir::Literal>(program.exprs[at->index].node);
    element.bits = places[element.bits];
  });
}

}  // namespace

bool ReadsBuiltins(const ir::Program& program) {
  return std::ranges::any_of(
      kPassedOn, [&](const PassedOn& pair) { return Find(program.inputs, pair.input) != nullptr; });
}

bool FitDistances(const ir::Program& before, ir::Program& program) {
  bool is_any_wider = false;
  for (const auto& [output, input] : kPassedOn) {
    if (InfoOf(input).components != 0) continue;
    const ir::IoVar* read = Find(program.inputs, input);
    const WrittenDistances written = DistancesOf(before, output);
    if (!read || written.count == 0) continue;
    const ir::VarId array = read->var;
    const std::uint32_t now = CountOf(program, *read);
    const std::vector<std::uint32_t> places = MovePieces(program, array, written);
    std::uint32_t count = 0;
    bool is_moved = false;
    for (const ir::DistancePiece& piece : program.distances) {
      if (piece.array == array) count = std::max(count, piece.first + 1);
    }
    for (std::uint32_t i = 0; i < now; ++i) is_moved |= places[i] != i;
    if (is_moved) MoveReads(program, array, places);
    const bool is_wider = InfoOf(program.stage).reads_vertices && written.count > now;
    if (InfoOf(program.stage).reads_vertices) count = std::max(count, written.count);
    if (count != now) Resize(program, array, count);
    is_any_wider |= is_wider;
  }
  return is_any_wider;
}

void LinkWithNeighbour(Job& job, ir::Program& program, std::vector<std::string>& dependencies) {
  const ProgramRequest& request = job.request;
  const glsl::Target& target = request.target;
  link::ReadResult neighbour = ReadNeighbour(request, dependencies);
  if (!neighbour.problems.empty()) {
    const std::vector<std::string>& problems = neighbour.problems;
    Diagnostic& report = job.diagnostics.Report({}, diag::PixelShader, problems.front());
    for (std::size_t i = 1; i < problems.size(); ++i) report.Note({}, diag::PlainNote, problems[i]);
    return;
  }
  // Drivers of desktop OpenGL link a program by name whose pixel shader reads what nothing writes.
  const bool links_by_name = !target.IsEs() && target.Has(glsl::Feature::kInAndOut) &&
                             !target.Has(glsl::Feature::kOutputLocations);
  const link::MatchOptions options{request.link.keep_outputs, target.IsVulkan(),
                                   request.link.zero_unwritten || links_by_name, target.IsEs()};
  const link::Matches matches = link::Match(program, neighbour.interface, options, job.diagnostics);
  if (job.diagnostics.has_errors()) return;
  if (!request.style.names.empty()) ForgetNames(neighbour.interface, neighbour.is_glsl);
  link::Apply(program, neighbour.interface, matches, options);
}

void LinkWithNext(Job& job, Job& next_job, const Lowered& next, ir::Program& program) {
  const LinkOptions& link = job.request.link;
  if (InfoOf(next.program.stage).has_stage_after) PassToNext(program);
  const link::Interface reader =
      link::ReadInputs(next.program, [&](Span span) { return next_job.PlaceOf(span); });
  // The next stage declares what it reads and nothing else, for Vulkan too.
  const link::MatchOptions options{.keep_outputs = link.keep_outputs,
                                   .zero_unwritten = link.zero_unwritten,
                                   .is_es = job.request.target.IsEs()};
  const link::Matches matches = link::Match(program, reader, options, job.diagnostics);
  CheckBuiltins(job, program, next.program);
  if (!job.diagnostics.has_errors()) link::Apply(program, reader, matches, options);
}

}  // namespace clipc
