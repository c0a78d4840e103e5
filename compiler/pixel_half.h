// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "compiler/job.h"
#include "compiler/request.h"
#include "compiler/stages.h"
#include "frontend/lex/source.h"
#include "ir/program.h"

namespace clipc {

// Reads the request's pixel shader and links the vertex shader `program` with it (link/match.h).
// `input` is the vertex shader's: a pixel shader in HLSL has the same include folders and macros.
// Appends the files that were read to `dependencies`. Requires Form::kResolved; after errors the
// program is as it was.
void LinkPixelShader(const CompileRequest& request, SourceInput input, ir::Program& program,
                     std::vector<std::string>& dependencies, Diagnostics& diagnostics);

// The request that compiles the pixel shader of the request's pair by itself.
CompileRequest PixelRequest(const CompileRequest& request);

// Names the inputs of the pixel shader of a pair: the vertex shader's outputs take the names.
void NameInputs(ir::Program& pixel, const glsl::NameStyle& style);

// Links the vertex shader `program` with the lowered pixel shader of its pair, whose job is
// `pixel_job`. Requires Form::kResolved of the program; after errors it is as it was.
void LinkPair(const CompileRequest& request, const Lowered& pixel, const Job& pixel_job,
              ir::Program& program, Diagnostics& diagnostics);

// Gives the distances that the pixel shader of a pair discards by the names and locations that the
// vertex shader's have, which was written with `info`.
void PlaceDistances(const ir::Program& vertex, const glsl::GlslInfo& info, ir::Program& pixel);

}  // namespace clipc
