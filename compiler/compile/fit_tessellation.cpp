// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/fit_tessellation.h"

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/spelling.h"

namespace clipc {
namespace {

using ir::OutputTopology;
using ir::Partitioning;

// Takes what the hull shader says, or reports that it makes other patches.
void FitToHull(const ir::Program& hull, ir::Program& domain, Diagnostics& diagnostics) {
  const ir::Tessellation& made = hull.tessellation;
  ir::Tessellation& read = domain.tessellation;
  const ir::Function& reader = domain.functions[domain.entry];
  const ir::Function& maker = hull.functions[hull.entry];
  if (made.domain != read.domain)
    diagnostics.Report(reader.span, diag::DomainDiffers, reader.name, InfoOf(*read.domain).name,
                       maker.name, InfoOf(*made.domain).name);
  if (read.output_points > 0 && read.output_points != made.output_points)
    diagnostics.Report(reader.span, diag::PatchPointsDiffer, reader.name,
                       WithCount(read.output_points, "control point"), maker.name,
                       std::to_string(made.output_points));
  read.partitioning = made.partitioning;
  read.topology = made.topology;
}

// Takes what the request says, and assumes the rest.
void FitAlone(const TessellationOptions& options, ir::Program& domain, Diagnostics& diagnostics) {
  ir::Tessellation& patch = domain.tessellation;
  const ir::Function& entry = domain.functions[domain.entry];
  const bool is_line = patch.domain == ir::Domain::kIsoline;
  if (options.partitioning) patch.partitioning = options.partitioning;
  if (options.topology) patch.topology = options.topology;
  const auto assume = [&](auto& value, auto usual, std::string_view what, std::string_view word) {
    if (value) return;
    value = usual;
    diagnostics.Report(entry.span, diag::TessellationAssumed, entry.name, what, word, word);
  };
  const auto topology = is_line ? OutputTopology::kLine : OutputTopology::kTriangleCw;
  assume(patch.partitioning, Partitioning::kInteger, "`[partitioning(..)]`", ir::kPartitionings[0]);
  assume(patch.topology, topology, "`[outputtopology(..)]`",
         ir::kOutputTopologies[static_cast<std::size_t>(topology)]);
}

// Reports a program with one of a hull and a domain shader, which work together. A program may
// begin with a domain shader or end with a hull shader: the rest is in another command.
void CheckPartners(std::span<Job> jobs, const std::vector<ir::Program>& programs) {
  for (std::size_t i = 0; i < programs.size(); ++i) {
    const StageInfo& stage = InfoOf(programs[i].stage);
    const bool lacks_hull =
        stage.reads_patches && i > 0 && !InfoOf(programs[i - 1].stage).makes_patches;
    const bool lacks_domain = stage.makes_patches && i + 1 < programs.size() &&
                              !InfoOf(programs[i + 1].stage).reads_patches;
    if (!lacks_hull && !lacks_domain) continue;
    const ir::Function& entry = programs[i].functions[programs[i].entry];
    jobs[i].diagnostics.Report(entry.span, diag::StageWithoutPartner, entry.name, stage.name,
                               InfoOf(lacks_hull ? Stage::kHull : Stage::kDomain).name);
  }
}

}  // namespace

void FitTessellation(std::span<Job> jobs, std::vector<ir::Program>& programs) {
  CheckPartners(jobs, programs);
  for (std::size_t i = 0; i < programs.size(); ++i) {
    if (!InfoOf(programs[i].stage).reads_patches) continue;
    if (i > 0 && InfoOf(programs[i - 1].stage).makes_patches)
      FitToHull(programs[i - 1], programs[i], jobs[i].diagnostics);
    else
      FitAlone(jobs[i].request.tessellation, programs[i], jobs[i].diagnostics);
  }
}

}  // namespace clipc
