// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/job.h"

#include <utility>

#include <fmt/format.h>

namespace clipc {

Job::Job(const Shared& shared, const ProgramRequest& of, std::size_t number, Watch* stop)
    : request(of),
      path(of.FileOf(number).path),
      diagnostics(of.warnings),
      plan(Resolve(of, number, diagnostics)),
      watch(stop),
      valid(shared.valid) {
  SourceInput input = InputOf(request, number, plan, diagnostics);
  if (!watch && diagnostics.all().empty())
    known_ = shared.texts.Get(shared.context, request, plan, input);
  if (known_) {
    diagnostics = known_->messages;
  } else {
    if (request.includes.read)
      own_context_ = std::make_unique<FrontendContext>(FrontendContext::Files::kNone);
    source_ =
        std::make_unique<Source>(own_context_ ? *own_context_ : shared.context, std::move(input));
  }
  diagnostics.SetWatch(watch);
}

std::string Job::PlaceOf(Span span) {
  const Place place = source().Resolve(span);
  return place.file.empty() ? path : fmt::format("{}:{}:{}", place.file, place.line, place.column);
}

}  // namespace clipc
