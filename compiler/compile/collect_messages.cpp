// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/collect_messages.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

#include "compiler/compile/message.h"

namespace clipc {
namespace {

struct Found {
  Job* job;
  const Diagnostic* diagnostic;
  std::vector<std::uint32_t> place;  // Source::PlaceInText
};

std::vector<Found> InOrder(Job& job) {
  std::vector<Found> found;
  for (const Diagnostic& diagnostic : job.diagnostics.all()) {
    Found next{&job, &diagnostic, job.source().PlaceInText(diagnostic.span)};
    if (next.place.empty() && !found.empty()) next.place = found.back().place;
    found.push_back(std::move(next));
  }
  std::ranges::stable_sort(found, {}, &Found::place);
  return found;
}

Message MessageOf(const Found& found) { return ToMessage(*found.diagnostic, found.job->source()); }

bool IsSame(const Message& a, const Message& b) {
  return a.name == b.name && a.text == b.text && a.place.file == b.place.file &&
         a.place.line == b.place.line && a.place.column == b.place.column;
}

// Adds the messages of a further shader that the shaders before it do not have.
void Add(Job& job, std::vector<Found>& found) {
  std::vector<Message> others;
  std::ranges::transform(found, std::back_inserter(others), MessageOf);
  const bool is_mixed =
      !found.empty() && found[0].job->source().MainText() == job.source().MainText();
  const auto first = static_cast<std::ptrdiff_t>(found.size());
  for (Found& message : InOrder(job)) {
    const Message text = MessageOf(message);
    if (std::ranges::none_of(others, [&](const Message& other) { return IsSame(text, other); }))
      found.push_back(std::move(message));
  }
  if (is_mixed) std::ranges::inplace_merge(found, found.begin() + first, {}, &Found::place);
}

}  // namespace

void CollectMessages(std::span<Job> jobs, CompileResult& result) {
  std::vector<Found> found = InOrder(jobs.front());
  for (Job& job : jobs.subspan(1)) Add(job, found);
  for (auto at = found.begin(); at != found.end();) {
    Job& same = *at->job;
    Diagnostics shown;
    for (; at != found.end() && at->job == &same; ++at) {
      shown.Add(*at->diagnostic);
      result.messages.push_back(MessageOf(*at));
    }
    if (same.request.outputs.text)
      result.text += same.source().RenderText(shown, same.request.outputs.colour);
  }
  const bool has_errors =
      std::ranges::any_of(jobs, [](const Job& job) { return job.diagnostics.has_errors(); });
  if (has_errors && result.ok()) result.status = Status::kErrors;
}

}  // namespace clipc
