// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/bench/corpus.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <fstream>
#include <functional>
#include <sstream>
#include <thread>
#include <vector>

#include "compiler/compile/compile.h"
#include "tools/bench/reference_compilers.h"
#include "tools/harness/timing.h"

namespace clipc::bench {
namespace {

using harness::ProcessSeconds;
using harness::ThreadSeconds;

constexpr int kThreads = 2;

std::vector<std::string> Split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::stringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) {
    if (!part.empty() || separator == '\t') parts.push_back(part);
  }
  return parts;
}

std::vector<ProgramRequest> ReadList(const std::string& path) {
  std::vector<ProgramRequest> requests;
  std::ifstream list(path);
  for (std::string line; std::getline(list, line);) {
    std::vector<std::string> parts = Split(line, '\t');
    if (parts.size() < 3) continue;
    parts.resize(5);
    ProgramRequest request;
    request.first().path = parts[0];
    request.first().entry = parts[1];
    request.first().profile = parts[2];
    request.includes.dirs = Split(parts[3], ';');
    request.defines = Split(parts[4], ';');
    requests.push_back(std::move(request));
  }
  return requests;
}

// Calls work(thread, index) for every index. Returns the processor seconds that a thread took.
double OnThreads(std::size_t count, const std::function<void(int, std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  const double start = ProcessSeconds();
  std::vector<std::jthread> threads;
  for (int thread = 0; thread < kThreads; ++thread) {
    threads.emplace_back([&, thread] {
      for (std::size_t index = next++; index < count; index = next++) work(thread, index);
    });
  }
  threads.clear();
  return (ProcessSeconds() - start) / kThreads;
}

void Say(const char* who, const std::vector<char>& accepted, double seconds) {
  const auto count = static_cast<double>(accepted.size());
  std::printf("%s: %td of %zu shaders in %.2f s, %.0f a second\n", who,
              std::ranges::count(accepted, 1), accepted.size(), seconds, count / seconds);
}

}  // namespace

void BenchCorpus(const std::string& list) {
  const std::vector<ProgramRequest> requests = ReadList(list);
  std::vector<std::pair<double, std::size_t>> times(requests.size());
  std::vector<char> accepted(requests.size()), accepted_by_reference(requests.size());
  Compiler compilers[kThreads];
  const double ours = OnThreads(requests.size(), [&](int thread, std::size_t index) {
    const double start = ThreadSeconds();
    accepted[index] = compilers[thread].Compile(requests[index]).ok();
    times[index] = {ThreadSeconds() - start, index};
  });
  StartReferenceCompilers();
  const double theirs = OnThreads(requests.size(), [&](int, std::size_t index) {
    accepted_by_reference[index] = CompileFileWithReferenceCompilers(requests[index]).has_value();
  });
  Say("clipc", accepted, ours);
  Say("glslang and SPIRV-Cross", accepted_by_reference, theirs);
  // Shaders that the reference compilers refuse cost them little: measures again with those that
  // both accept.
  std::vector<std::size_t> both;
  for (std::size_t i = 0; i < requests.size(); ++i) {
    if (accepted[i] && accepted_by_reference[i]) both.push_back(i);
  }
  const double our_both = OnThreads(both.size(), [&](int thread, std::size_t i) {
    compilers[thread].Compile(requests[both[i]]);
  });
  const double their_both = OnThreads(both.size(), [&](int, std::size_t i) {
    CompileFileWithReferenceCompilers(requests[both[i]]);
  });
  StopReferenceCompilers();
  const double ratio = their_both / our_both;
  std::printf(
      "the %zu that both accept: clipc %.2f s, the others %.2f s: %.1f times as fast (at least 10: "
      "%s)\n",
      both.size(), our_both, their_both, ratio, ratio >= 10 ? "holds" : "missed");
  std::printf("the slowest ten:\n");
  std::ranges::sort(times, std::greater{});
  for (std::size_t i = 0; i < std::min<std::size_t>(times.size(), 10); ++i) {
    const ProgramRequest& request = requests[times[i].second];
    std::printf("%8.2f ms  %s %s\n", 1000 * times[i].first, request.first().path.c_str(),
                request.first().entry.c_str());
  }
}

}  // namespace clipc::bench
