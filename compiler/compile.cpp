// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <new>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "compiler/back_end.h"
#include "compiler/collect_messages.h"
#include "compiler/dump_tokens.h"
#include "compiler/job.h"
#include "compiler/known_texts.h"
#include "compiler/pixel_half.h"
#include "compiler/plan.h"
#include "compiler/rewrite_hlsl.h"
#include "compiler/stages.h"
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

// What the compiles of one Compiler share.
struct Shared {
  FrontendContext& context;
  KnownTexts& texts;
  ValidTexts& valid;
};

// A job with everything that it refers to but its request.
class JobHolder {
 public:
  JobHolder(const Shared& shared, const CompileRequest& request, Watch* watch,
            Plan (*resolve)(const CompileRequest&, Diagnostics&) = Resolve)
      : diagnostics_(request.warnings),
        plan_(resolve(request, diagnostics_)),
        own_context_(request.includes.read
                         ? std::make_unique<FrontendContext>(FrontendContext::Files::kNone)
                         : nullptr),
        known_(watch || !diagnostics_.all().empty()
                   ? nullptr
                   : shared.texts.Get(shared.context, request, plan_)),
        source_(known_ ? nullptr
                       : std::make_unique<Source>(own_context_ ? *own_context_ : shared.context,
                                                  plan_.input)),
        job{request,      plan_,       known_ ? known_->source : *source_, diagnostics_, watch,
            shared.valid, known_.get()} {
    if (known_) diagnostics_ = known_->messages;
    diagnostics_.SetWatch(watch);
  }
  JobHolder(const JobHolder&) = delete;
  JobHolder& operator=(const JobHolder&) = delete;

 private:
  Diagnostics diagnostics_;
  Plan plan_;
  // Of the files that the caller's function gives, which Clang would find in the other shader's
  // context, without their texts.
  std::unique_ptr<FrontendContext> own_context_;
  std::shared_ptr<KnownText> known_;
  std::unique_ptr<Source> source_;  // of a text that is not known

 public:
  const Job job;
};

// Whether the request ends the passes before the program of a shader is complete.
bool StopsInFront(const DebugOptions& debug) {
  const auto names = resolve::ResolvePasses();
  return !debug.stop_after.empty() && std::ranges::find(names, debug.stop_after) != names.end();
}

// `pixel` is the job of the pixel shader of CompileRequest::reads_pixel_half, or null.
void RunStages(const Job& job, const Job* pixel, CompileResult& result) {
  Source& source = job.source;
  Diagnostics& diagnostics = job.diagnostics;
  const CompileRequest& request = job.request;
  if (request.outputs.preprocess) {
    result.preprocessed = Preprocess(source, diagnostics);
    return;
  }
  if (job.IsDump(DumpStage::kTokens)) {
    result.dump = DumpTokens(Lex(source, diagnostics), source);
    return;
  }
  if (job.IsDump(DumpStage::kAst)) {
    result.dump = PrintAst(ReadFile(source, diagnostics));
    return;
  }
  if (request.hlsl.wanted) {
    RewriteHlsl(job, pixel, result);
    return;
  }
  const auto is_new = [&](const Tokens& tokens) {
    // The tokens alone do not decide the result where lines of the source or words of the
    // preprocessor are a part of it.
    if (!request.is_known || request.outputs.source_lines || request.outputs.listing ||
        request.link.has_pixel_shader() || diagnostics.has_pragmas() || !diagnostics.all().empty())
      return true;
    result.digest = DigestOf(tokens);
    result.is_repeated = request.is_known(*result.digest);
    return !result.is_repeated;
  };
  const auto program_of = [&](const Job& of, const std::function<bool(const Tokens&)>& wants) {
    const ir::PassOptions passes = PassesOf(of, result.dump);
    return of.known ? of.known->Check(of.plan.check, of.diagnostics)
                    : Front(of.source, of.plan.check, of.diagnostics, passes, wants);
  };
  ir::Program program = program_of(job, is_new);
  ir::Program pixel_program;
  if (pixel) pixel_program = program_of(*pixel, {});
  const bool has_errors = diagnostics.has_errors() || (pixel && pixel->diagnostics.has_errors());
  if (has_errors || result.is_repeated || job.IsStopped()) return;
  const bool is_stopped = StopsInFront(request.debug);
  if (job.IsDump(DumpStage::kIr) || (is_stopped && request.debug.dump_after.empty())) {
    result.dump = ir::Print(program);
  } else if (is_stopped) {
    return;
  } else if (pixel) {
    const PixelHalf half{*pixel, pixel_program};
    RunBackEnd(job, &half, std::move(program), result);
  } else {
    RunBackEnd(job, nullptr, std::move(program), result);
  }
}

// Adds the files that a source read and the macros that it asked for.
void AddUses(const Job& job, CompileResult& result) {
  const auto add = [](std::vector<std::string> from, std::vector<std::string>& to) {
    if (to.empty()) to.swap(from);
    for (std::string& text : from) {
      if (std::ranges::find(to, text) == to.end()) to.push_back(std::move(text));
    }
  };
  add(job.source.Dependencies(), result.dependencies);
  if (job.request.record_macros) add(job.source.MacrosUsed(), result.macros_used);
  for (Include& include : job.source.Includes()) result.includes.push_back(std::move(include));
}

// Takes the sources through the stages. The result has everything but the messages.
CompileResult Run(const Job& job, const Job* pixel) {
  CompileResult result;
  RunStages(job, pixel, result);
  if (job.IsStopped()) result.dump.clear();
  const std::vector<std::string> others = std::move(result.dependencies);
  result.dependencies.clear();
  AddUses(job, result);
  if (pixel) AddUses(*pixel, result);
  for (const std::string& path : others) {
    if (std::ranges::find(result.dependencies, path) == result.dependencies.end())
      result.dependencies.push_back(path);
  }
  return result;
}

// Adds the messages to the result of Run. After errors, the outputs are removed.
CompileResult Deliver(CompileResult result, const Job& job, const Job* pixel) {
  CollectMessages(job, pixel, result);
  if (!result.ok()) result.outputs.reset();
  return result;
}

CompileResult CompileIn(const Shared& shared, const CompileRequest& request) {
  Stop stop(request.limits);
  const JobHolder shader(shared, request, stop.watch());
  std::optional<CompileRequest> pixel_request;
  std::optional<JobHolder> half;
  if (request.reads_pixel_half()) {
    pixel_request = PixelRequest(request);
    half.emplace(shared, *pixel_request, stop.watch(), ResolvePixelHalf);
    const std::string& path = request.link.pixel_shader.path;
    // The caller who gives the includes gives this text too: no file is read for it.
    if (request.includes.read && !pixel_request->text && !path.empty())
      half->job.diagnostics.Report({}, diag::PixelShader,
                                   fmt::format("{}: there is no such file", path));
  }
  const Job* const pixel = half ? &half->job : nullptr;
  const auto is_wrong = [](const Job& job) { return job.diagnostics.has_errors(); };
  CompileResult result;
  if (is_wrong(shader.job) || (pixel && is_wrong(*pixel))) {
    result.status = Status::kBadRequest;
  } else {
    result = Run(shader.job, pixel);
    result.status = stop.Report(shader.job.diagnostics);
    const auto is_read = [](const Job& job) { return job.source.main_file_read(); };
    if (!is_read(shader.job) || (pixel && !is_read(*pixel))) result.status = Status::kBadRequest;
  }
  return Deliver(std::move(result), shader.job, pixel);
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

FrontendContext& Compiler::ContextFor(const CompileRequest& request) {
  if (request.includes.sandbox.empty() || request.includes.read) return context_;
  if (!sandboxed_ || sandbox_ != request.includes.sandbox) {
    memory_->texts.Clear();
    sandboxed_ = std::make_unique<FrontendContext>(FrontendContext::Files::kOnDisk,
                                                   request.includes.sandbox);
    sandbox_ = request.includes.sandbox;
  }
  return *sandboxed_;
}

CompileResult Compiler::Compile(const CompileRequest& request) {
  try {
    return CompileIn({ContextFor(request), memory_->texts, memory_->valid}, request);
  } catch (const std::bad_alloc&) {
    return Failure("out of memory");
  } catch (const std::exception& problem) {
    return Failure(problem.what());
  }
}

CompileResult Compile(const CompileRequest& request) { return Compiler().Compile(request); }

}  // namespace clipc
