// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/random/reduce.h"

#include <algorithm>
#include <set>

namespace clipc::random {
namespace {

bool IsSimpler(const ChoiceList& a, const ChoiceList& b) {
  return a.size() != b.size() ? a.size() < b.size() : a < b;
}

class Reducer {
 public:
  Reducer(const ChoiceList& list, const Reduction& reduction)
      : reduction_(reduction), made_(reduction.make(list)) {}

  ChoiceList Run() {
    for (bool shrinks = true; shrinks && !IsOver();) {
      const ChoiceList before = made_.drawn;
      CutSpans();
      for (const std::size_t size : {32, 8, 4, 2, 1}) CutRuns(size);
      Lower();
      shrinks = made_.drawn != before;
    }
    return made_.drawn;
  }

 private:
  bool IsOver() const { return tries_ >= reduction_.most_tries; }

  // Takes `list` if it is simpler and fails.
  bool Try(const ChoiceList& list) {
    if (IsOver()) return false;
    Made made = reduction_.make(list);
    if (!IsSimpler(made.drawn, made_.drawn) || !seen_.insert(made.drawn).second) return false;
    ++tries_;
    if (!reduction_.fails(made.drawn)) return false;
    made_ = std::move(made);
    return true;
  }

  ChoiceList With(const Span& span, const ChoiceList& instead) const {
    const ChoiceList& all = made_.drawn;
    ChoiceList list(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(span.begin));
    list.insert(list.end(), instead.begin(), instead.end());
    list.insert(list.end(), all.begin() + static_cast<std::ptrdiff_t>(span.end), all.end());
    return list;
  }

  ChoiceList Part(const Span& span) const {
    return {made_.drawn.begin() + static_cast<std::ptrdiff_t>(span.begin),
            made_.drawn.begin() + static_cast<std::ptrdiff_t>(span.end)};
  }

  // Cuts the spans, the longest first. The spans change with each success.
  void CutSpans() {
    for (std::size_t i = 0; i < made_.spans.size() && !IsOver();) {
      std::vector<Span> spans = made_.spans;
      std::ranges::stable_sort(spans, std::ranges::greater{},
                               [](const Span& span) { return span.end - span.begin; });
      if (i >= spans.size() || !CutSpan(spans[i], spans)) ++i;
    }
  }

  bool CutSpan(const Span& span, const std::vector<Span>& spans) {
    if (Try(With(span, {})) || Try(With(span, {0}))) return true;
    if (Try(With(span, ChoiceList(span.end - span.begin, 0)))) return true;
    int inner = 0;
    for (const Span& part : spans) {
      const bool is_inside = part.begin >= span.begin && part.end <= span.end &&
                             part.end - part.begin < span.end - span.begin;
      if (is_inside && ++inner <= 6 && Try(With(span, Part(part)))) return true;
    }
    return false;
  }

  void CutRuns(std::size_t size) {
    for (std::size_t at = 0; at + size <= made_.drawn.size() && !IsOver();) {
      if (!Try(With({at, at + size}, {}))) at += std::max<std::size_t>(size / 2, 1);
    }
  }

  void Lower() {
    for (std::size_t at = 0; at < made_.drawn.size() && !IsOver(); ++at) {
      const std::uint32_t now = made_.drawn[at];
      for (const std::uint32_t lower : {0u, now / 2, now - 1}) {
        if (lower < now && at < made_.drawn.size() && Try(With({at, at + 1}, {lower}))) break;
      }
    }
  }

  const Reduction& reduction_;
  Made made_;
  std::set<ChoiceList> seen_;
  int tries_ = 0;
};

}  // namespace

ChoiceList Reduce(const ChoiceList& list, const Reduction& reduction) {
  return Reducer(list, reduction).Run();
}

}  // namespace clipc::random
