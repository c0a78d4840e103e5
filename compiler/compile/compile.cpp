// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/compile.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <functional>
#include <new>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/kept_blocks.h"
#include "compiler/compile/back_end.h"
#include "compiler/compile/collect_messages.h"
#include "compiler/compile/dump_tokens.h"
#include "compiler/compile/job.h"
#include "compiler/compile/known_texts.h"
#include "compiler/compile/lower_program.h"
#include "compiler/compile/rewrite_hlsl.h"
#include "compiler/compile/stages.h"
#include "frontend/parse/ast_print.h"
#include "frontend/resolve/resolve.h"
#include "ir/print.h"

namespace clipc {
namespace {

// The reasons to end a compile before its result: the limit of its time, and its caller.
class Stop {
 public:
  explicit Stop(const Limits& limits) : limits_(limits) {
    if (limits.seconds != Limits().seconds)
      deadline_ = Clock::now() + std::chrono::seconds(limits.seconds);
  }

  // The watch that the stages ask; null if nothing can stop the compile.
  Watch* watch() { return deadline_ || limits_.is_cancelled ? &watch_ : nullptr; }

  // Reports why the compile was stopped, if it was. Returns the status that it has then.
  Status Report(Diagnostics& diagnostics) const {
    if (watch_.stopped() && is_cancelled_) {
      diagnostics.Report({}, diag::Cancelled);
      return Status::kCancelled;
    }
    if (watch_.stopped()) diagnostics.Report({}, diag::TimeLimit, limits_.seconds);
    return Status::kOk;
  }

 private:
  using Clock = std::chrono::steady_clock;

  bool MustStop() {
    is_cancelled_ = limits_.is_cancelled && limits_.is_cancelled();
    return is_cancelled_ || (deadline_ && Clock::now() >= *deadline_);
  }

  const Limits& limits_;
  std::optional<Clock::time_point> deadline_;
  bool is_cancelled_ = false;
  Watch watch_{[this] { return MustStop(); }};
};

// ---- from a request to a result

// Whether the request ends the passes before the program of a shader is complete.
bool StopsInFront(const DebugOptions& debug) {
  if (debug.stop_after.empty()) return false;
  const auto names = resolve::ResolvePasses();
  return std::ranges::find(names, debug.stop_after) != names.end();
}

// The meaning of a job's shader, or an empty program and Job::shader. `wants`, if given, sees the
// tokens: see Front.
ir::Program ProgramOf(Job& job, std::string& dump,
                      const std::function<bool(const Tokens&)>& wants) {
  if (job.known()) {
    job.shader = job.known()->Check(job.plan.check, job.diagnostics);
    return {};
  }
  return Front(job.source(), job.plan.check, job.diagnostics, PassesOf(job, dump), wants);
}

// The meanings of all shaders. The program is not complete after errors, and where the result
// repeats another one.
std::vector<ir::Program> ReadProgram(std::span<Job> jobs, CompileResult& result) {
  Job& first = jobs.front();
  const ProgramRequest& request = first.request;
  const auto is_new = [&](const Tokens& tokens) {
    // The tokens alone do not decide the result where lines of the source or words of the
    // preprocessor are a part of it.
    if (!request.is_known || request.outputs.source_lines || request.outputs.listing ||
        request.is_linked() || first.diagnostics.has_pragmas() || !first.diagnostics.all().empty())
      return true;
    result.digest = DigestOf(tokens);
    result.is_repeated = request.is_known(*result.digest);
    return !result.is_repeated;
  };
  std::vector<ir::Program> programs;
  programs.push_back(ProgramOf(first, result.dump, is_new));
  for (Job& job : jobs.subspan(1)) programs.push_back(ProgramOf(job, result.dump, {}));
  return programs;
}

bool HasErrors(std::span<const Job> jobs) {
  return std::ranges::any_of(jobs, [](const Job& job) { return job.diagnostics.has_errors(); });
}

void RunStages(std::span<Job> jobs, CompileResult& result) {
  Job& first = jobs.front();
  const ProgramRequest& request = first.request;
  if (request.outputs.preprocess) {
    result.preprocessed = Preprocess(first.source(), first.diagnostics);
    // The others are read for what they include.
    for (Job& job : jobs.subspan(1)) Preprocess(job.source(), job.diagnostics);
    return;
  }
  if (first.IsDump(DumpStage::kTokens)) {
    result.dump = DumpTokens(Lex(first.source(), first.diagnostics), first.source());
    return;
  }
  if (first.IsDump(DumpStage::kAst)) {
    result.dump = PrintAst(ReadFile(first.source(), first.diagnostics));
    return;
  }
  if (request.hlsl.wanted) {
    RewriteHlsl(jobs, result);
    return;
  }
  std::vector<ir::Program> programs = ReadProgram(jobs, result);
  if (HasErrors(jobs) || result.is_repeated || first.IsStopped()) return;
  const bool is_stopped = StopsInFront(request.debug);
  if (first.IsDump(DumpStage::kIr) || (is_stopped && request.debug.dump_after.empty())) {
    result.dump = ir::Print(programs.front());
  } else if (!is_stopped) {
    RunBackEnd(jobs, std::move(programs), result);
  }
}

// Adds the files that a source read and the macros that it asked for.
void AddUses(Job& job, CompileResult& result) {
  const auto add = [](std::vector<std::string> from, std::vector<std::string>& to) {
    if (to.empty()) to.swap(from);
    for (std::string& text : from) {
      if (std::ranges::find(to, text) == to.end()) to.push_back(std::move(text));
    }
  };
  add(job.source().Dependencies(), result.dependencies);
  if (job.request.record_macros) add(job.source().MacrosUsed(), result.macros_used);
  for (Include& include : job.source().Includes()) result.includes.push_back(std::move(include));
}

// Takes the sources through the stages. The result has everything but the messages.
CompileResult Run(std::span<Job> jobs) {
  CompileResult result;
  RunStages(jobs, result);
  if (jobs.front().IsStopped()) result.dump.clear();
  const std::vector<std::string> others = std::exchange(result.dependencies, {});
  for (Job& job : jobs) AddUses(job, result);
  for (const std::string& path : others) {
    if (std::ranges::find(result.dependencies, path) == result.dependencies.end())
      result.dependencies.push_back(path);
  }
  return result;
}

CompileResult CompileIn(const Shared& shared, const ProgramRequest& request) {
  Stop stop(request.limits);
  std::vector<Job> jobs;
  jobs.reserve(request.shaders.size());
  for (std::size_t i = 0; i < request.shaders.size(); ++i)
    jobs.emplace_back(shared, request, i, stop.watch());
  CompileResult result;
  if (HasErrors(jobs)) {
    result.status = Status::kBadRequest;
  } else {
    result = Run(jobs);
    result.status = stop.Report(jobs.front().diagnostics);
    const auto is_read = [](Job& job) { return job.source().main_file_read(); };
    if (!std::ranges::all_of(jobs, is_read)) result.status = Status::kBadRequest;
  }
  CollectMessages(jobs, result);
  if (!result.ok()) result.outputs.reset();
  return result;
}

CompileResult Failure(const char* what) {
  CompileResult result;
  result.status = Status::kErrors;
  Message& message = result.messages.emplace_back();
  message.name = PrintedName(DiagId::kInternalError);
  message.text = fmt::format("internal error: {}", what);
  result.text = fmt::format("clipc: error: {}\n", message.text);
  return result;
}

}  // namespace

struct Compiler::Memory {
  KnownTexts texts;
  ValidTexts valid;
};

Compiler::Compiler() : memory_(std::make_unique<Memory>()) {}
Compiler::~Compiler() = default;

FrontendContext& Compiler::ContextFor(const ProgramRequest& request) {
  if (request.includes.sandbox.empty() || request.includes.read) return context_;
  if (!sandboxed_ || sandbox_ != request.includes.sandbox) {
    memory_->texts = {};
    sandboxed_ = std::make_unique<FrontendContext>(FrontendContext::Files::kOnDisk,
                                                   request.includes.sandbox);
    sandbox_ = request.includes.sandbox;
  }
  return *sandboxed_;
}

CompileResult Compiler::Compile(const ProgramRequest& request) {
  KeepBlocks();
  try {
    return CompileIn({ContextFor(request), memory_->texts, memory_->valid}, request);
  } catch (const std::bad_alloc&) {
    return Failure("out of memory");
  } catch (const std::exception& problem) {
    return Failure(problem.what());
  }
}

CompileResult Compile(const ProgramRequest& request) { return Compiler().Compile(request); }

}  // namespace clipc
