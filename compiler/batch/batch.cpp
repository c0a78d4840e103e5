// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/batch/batch.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include <fmt/format.h>

#include "base/file_set.h"
#include "base/path.h"
#include "base/sha256.h"
#include "base/spelling.h"
#include "base/system.h"
#include "compiler/batch/batch_errors.h"
#include "compiler/batch/batch_index.h"
#include "compiler/batch/batch_journal.h"
#include "compiler/batch/macro_memo.h"
#include "compiler/batch/manifest.h"
#include "compiler/batch/shared_files.h"
#include "compiler/command/collect_outputs.h"
#include "compiler/command/depfile.h"
#include "compiler/command/exit_code.h"
#include "compiler/command/in_order.h"
#include "compiler/command/output_files.h"
#include "compiler/command/place_outputs.h"
#include "compiler/command/show_messages.h"
#include "compiler/command/usage.h"
#include "compiler/compile/token_digest.h"
#include "frontend/lex/source_text.h"

namespace clipc {
namespace {

Problem SamePath(const std::string& path) {
  return {
      fmt::format("two outputs would go to `{}`; give them different names or extensions", path)};
}
Problem Overwrites(const std::string& path) {
  return {fmt::format("the output `{}` would overwrite a file that is read", path)};
}

// The permutations of one group that were compiled, and the jobs that have their results.
struct GroupMemory {
  // The key says which of the axes' macros are defined: "101".
  std::map<std::string, MacroMemo> by_macros;
  std::map<TokenDigest, std::size_t> by_digest;
};

class Batch {
 public:
  explicit Batch(CommandLine command)
      : command_(std::move(command)),
        printer_(command_.format, command_.messages),
        progress_(command_.format == MessageFormat::kText) {}

  RunResult Run(BatchOfGroups batch);

 private:
  struct Job {
    std::size_t group = 0, number = 0;
  };

  int RunAll(BatchOfGroups batch);
  Result<> CheckUsage() const;
  Result<> Prepare();
  Result<> Plan();
  CompileResult Work(std::size_t at, Compiler& compiler);
  bool Finish(std::size_t at, CompileResult result);
  Result<> WriteFiles(std::size_t at, CompileResult& result);
  std::string PathOf(const std::string& file) const;
  void Resume();
  bool HasFiles(BatchJournal::Done& done);
  Result<> WriteIndex();
  // An effect may be a header alone.
  bool HasFolder() const { return !command_.effect || !command_.output.empty(); }
  bool HasIndex() const { return HasFolder() || !command_.index.empty(); }
  std::string IndexPath() const;
  std::string JournalPath() const;
  void Summarise();

  MacroMemo& MemoOf(const Job& job, std::vector<std::string_view>& values);
  std::optional<std::size_t> FindAlike(std::size_t at, const CompileResult* result);
  void Remember(std::size_t at, const CompileResult& result, std::size_t alike);

  const ShaderGroup& GroupOf(const Job& job) const { return batch_.groups[job.group]; }
  void AddDependencies(const std::vector<std::string>& files);

  CommandLine command_;
  BatchOfGroups batch_;
  std::vector<Job> jobs_;
  std::vector<BatchEntry> entries_;  // by job
  std::size_t all_jobs_ = 0;         // the number of jobs of all shards
  std::size_t finished_ = 0, failed_ = 0;
  int exit_code_ = kExitOk;

  std::mutex mutex_;  // guards memories_
  std::vector<GroupMemory> memories_;

  SharedFiles shared_{PathOf("")};
  std::unordered_map<std::string, std::size_t> written_;  // the paths, with a hash of the contents
  std::map<std::size_t, std::vector<std::string>> read_by_;  // the files that a compiled job read
  std::vector<std::string> dependencies_;
  std::unordered_set<std::string> dependency_set_;
  std::vector<std::string> named_;  // the files to read that the command and the manifest name
  FileSet read_;                    // these
  std::unique_ptr<BatchJournal> journal_;                  // null: nothing can be resumed
  std::map<std::size_t, BatchJournal::Done> done_before_;  // by job
  BatchErrors errors_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  MessagePrinter printer_;
  Progress progress_;
};

bool IsOnlyExtension(const std::string& value) {
  return value.empty() || (value.starts_with('.') && !HasSlash(value));
}

Result<> Batch::CheckUsage() const {
  if (HasFolder() && !IsDirectory(command_.output)) {
    return Problem{
        "permutations write several files and an index of them; give an existing folder with "
        "-o"};
  }
  if (HasIndex() && read_.Has(IndexPath())) return Overwrites(IndexPath());
  for (const ShaderGroup& group : batch_.groups) {
    const CommandLine& command = group.command;
    if (Result<> done = CheckCommand(command); !done) return done;
    if (command.request.debug.changes_result() || command.only_dependencies)
      return Problem{
          "--dump, --stop-after and -M are for one permutation of a shader, and there are "
          "several"};
    std::vector<std::pair<std::string, std::string>> files = {
        {"--pixel-output", command.pixel_output},
        {"-Fh", command.header},
        {"-Fc", command.listing},
        {"-P", command.preprocessed}};
    for (std::size_t i = 0; i < command.middle.size(); ++i)
      files.emplace_back(fmt::format("--{}-output", InfoOf(kMiddleStages[i]).name),
                         command.middle[i].output);
    for (const std::string& table : command.tables) files.emplace_back("--table", table);
    for (const std::string& file : command.reflections) files.emplace_back("--reflect", file);
    for (const auto& [option, value] : files) {
      if (!IsOnlyExtension(value)) {
        return Problem{
            fmt::format("there are several shaders, each with files of its own; {} takes an "
                        "extension, such as `{}`",
                        option, value.substr(std::min(value.rfind('.'), value.size())))};
      }
    }
  }
  return {};
}

// Names the files of every permutation, those of the other shards too, and chooses the jobs of this
// shard.
Result<> Batch::Plan() {
  for (const ShaderGroup& group : batch_.groups) {
    const std::size_t count = group.Count();
    if (count > kMaxPermutations || all_jobs_ + count > kMaxPermutations)
      return Problem{fmt::format("more than {} permutations", kMaxPermutations)};
    all_jobs_ += count;
  }
  std::unordered_map<std::string, int> uses;
  std::size_t position = 0;
  for (std::size_t group = 0; group < batch_.groups.size(); ++group) {
    for (std::size_t number = 0; number < batch_.groups[group].Count(); ++number) {
      std::string name = FileNameOf(batch_.groups[group], number);
      for (int use = uses[name]++; use > 0; use = uses[name]++) name += fmt::format("-{}", use + 1);
      if (position++ % command_.shards + 1 != command_.shard) continue;
      jobs_.push_back({group, number});
      BatchEntry& entry = entries_.emplace_back();
      entry.name = std::move(name);
    }
  }
  memories_.resize(batch_.groups.size());
  return {};
}

// ---- permutations that are like others

MacroMemo& Batch::MemoOf(const Job& job, std::vector<std::string_view>& values) {
  const ShaderGroup& group = GroupOf(job);
  const std::vector<std::size_t> choices = ChoicesOf(group, job.number);
  std::string defined;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const auto& value = group.axes[i].values[choices[i]];
    defined += value ? '1' : '0';
    if (!value) continue;
    names.push_back(group.axes[i].macro);
    values.push_back(*value);
  }
  return memories_[job.group].by_macros.try_emplace(defined, std::move(names)).first->second;
}

// Returns an earlier job with the same result; none if there is none. It has the same values of the
// macros that it asked for, or the text after preprocessing whose digest `result`, if given, has.
std::optional<std::size_t> Batch::FindAlike(std::size_t at, const CompileResult* result) {
  const Job& job = jobs_[at];
  // What the program is linked with reads the macros too.
  if (GroupOf(job).command.request.is_linked()) return std::nullopt;
  const std::lock_guard lock(mutex_);
  std::vector<std::string_view> values;
  if (const auto alike = MemoOf(job, values).Find(values)) return alike;
  if (!result || !result->digest) return std::nullopt;
  const auto& by_digest = memories_[job.group].by_digest;
  const auto found = by_digest.find(*result->digest);
  return found == by_digest.end() ? std::nullopt : std::optional(found->second);
}

void Batch::Remember(std::size_t at, const CompileResult& result, std::size_t alike) {
  const std::lock_guard lock(mutex_);
  std::vector<std::string_view> values;
  MemoOf(jobs_[at], values).Add(values, result.macros_used, alike);
  if (result.digest) memories_[jobs_[at].group].by_digest.emplace(*result.digest, alike);
}

// ---- one job

// Compiles a job, on any thread. Returns an empty result for a job that is like another.
CompileResult Batch::Work(std::size_t at, Compiler& compiler) {
  if (done_before_.contains(at) || FindAlike(at, nullptr)) return {};
  const Job& job = jobs_[at];
  const ShaderGroup& group = GroupOf(job);
  ProgramRequest request = group.command.request;
  request.first().path = group.source;
  for (std::string& define : DefinesOf(group, job.number))
    request.defines.push_back(std::move(define));
  request.record_macros = true;
  request.is_known = [&](const TokenDigest& digest) {
    const std::lock_guard lock(mutex_);
    return memories_[job.group].by_digest.contains(digest);
  };
  return compiler.Compile(request);
}

// Writes and shows the result of a job. Called in the order of the jobs, so that files and messages
// do not depend on the threads.
bool Batch::Finish(std::size_t at, CompileResult result) {
  BatchEntry& entry = entries_[at];
  const std::string title = TitleOf(GroupOf(jobs_[at]), jobs_[at].number);
  progress_.Say(++finished_, jobs_.size(), title);
  int code = kExitOk;
  BatchJournal::Done done;
  if (const auto before = done_before_.find(at); before != done_before_.end()) {
    done = std::move(before->second);
    entry.status = BatchStatus::kCompiled;
    entry.files = done.files;
    entry.digests = std::move(done.digests);
  } else if (const auto alike = FindAlike(at, &result)) {
    entry.status = entries_[*alike].status;
    entry.files = entries_[*alike].files;
    entry.digests = entries_[*alike].digests;
    entry.exit_code = code = entries_[*alike].exit_code;
    entry.errors = entries_[*alike].errors;
    if (!result.macros_used.empty() || result.digest) Remember(at, result, *alike);
    done.dependencies = read_by_.at(*alike);
  } else {
    Remember(at, result, at);
    // Each pass of an effect, which has no journal, has its own messages.
    if (journal_ ? errors_.AreNew(result.messages) : !result.messages.empty()) {
      progress_.Clear();
      printer_.Say(title);
      printer_.Show(result);
    }
    done.dependencies = result.dependencies;
    read_by_.emplace(at, result.dependencies);
    code = result.ok() ? kExitOk : result.status == Status::kErrors ? kExitErrors : kExitUsage;
    if (batch_.keep) batch_.keep(at, result);
    if (const Result<> written = WriteFiles(at, result); !written) {
      progress_.Clear();
      exit_code_ = printer_.Fail(written.problem());
      return false;
    }
    entry.status = result.ok() ? BatchStatus::kCompiled : BatchStatus::kFailed;
    entry.exit_code = code;
    std::erase_if(result.messages,
                  [](const Message& message) { return message.severity != Severity::kError; });
    if (!result.messages.empty())
      entry.errors = std::make_shared<const std::vector<Message>>(std::move(result.messages));
  }
  if (journal_ && entry.errors) errors_.Count(*entry.errors);
  AddDependencies(done.dependencies);
  done.files = entry.files;
  Result<> noted;
  if (journal_ && code == kExitOk) noted = journal_->Add(entry.name, done);
  if (!noted) exit_code_ = printer_.Fail(noted.problem());
  failed_ += code == kExitOk ? 0 : 1;
  exit_code_ = std::max(exit_code_, code);
  return noted && (code == kExitOk || command_.keep_going);
}

void Batch::AddDependencies(const std::vector<std::string>& files) {
  for (const std::string& file : files) {
    if (dependency_set_.insert(file).second) dependencies_.push_back(file);
  }
}

std::string Batch::PathOf(const std::string& file) const {
  return command_.output + (EndsWithSlash(command_.output) ? "" : "/") + file;
}

// Writes the files of a job. Contents that an earlier file has are not written again.
Result<> Batch::WriteFiles(std::size_t at, CompileResult& result) {
  if (!HasFolder()) return {};
  BatchEntry& entry = entries_[at];
  CommandLine command = GroupOf(jobs_[at]).command;
  command.output = PathOf(fmt::format("{}{}", entry.name, ExtensionOf(command.request)));
  command.write_dependencies = false;
  const OutputPaths outputs = PlaceOutputs(command, GroupOf(jobs_[at]).source);
  Result<std::vector<OutputPiece>> pieces = CollectOutputs(command, outputs, result);
  if (!pieces) return Problem{pieces.problem()};
  OutputFiles files(OutputFiles::Unchanged::kKept);
  std::unordered_set<std::string> paths = {IndexPath(), JournalPath(), command_.messages};
  for (std::size_t i = 0; i < pieces->size(); ++i) {
    const OutputPiece& piece = (*pieces)[i];
    if (!paths.insert(piece.path).second) return SamePath(piece.path);
    const std::string file = piece.path.substr(NameBegin(piece.path));
    // Those of this job are not written yet.
    std::size_t same = 0;
    while (same < i && ((*pieces)[same].contents != piece.contents ||
                        ExtensionIn((*pieces)[same].path) != ExtensionIn(file)))
      ++same;
    const std::string name =
        same < i ? entry.files[same].second : shared_.Share(file, piece.contents);
    entry.files.emplace_back(piece.kind, name);
    if (command_.shards != 1) entry.digests.push_back(Sha256(piece.contents));
    if (name != file) continue;
    if (read_.Has(piece.path)) return Overwrites(piece.path);
    const std::size_t hash = std::hash<std::string>()(piece.contents);
    if (written_.try_emplace(piece.path, hash).first->second != hash) return SamePath(piece.path);
    files.Add(piece.path, piece.contents);
  }
  return files.Commit();
}

// ---- what an earlier run did

// Whether the outputs are still there. If so, their contents are known to the jobs that follow.
bool Batch::HasFiles(BatchJournal::Done& done) {
  std::vector<std::string> contents;
  for (const auto& [kind, file] : done.files) {
    Result<std::string> text = ReadText(PathOf(file));
    if (!text) return false;
    if (command_.shards != 1) done.digests.push_back(Sha256(*text));
    contents.push_back(std::move(*text));
  }
  for (std::size_t i = 0; i < contents.size(); ++i)
    shared_.Share(done.files[i].second, contents[i]);
  return true;
}

void Batch::Resume() {
  std::map<std::string, BatchJournal::Done> before = journal_->Read();
  for (std::size_t at = 0; at < jobs_.size(); ++at) {
    const auto found = before.find(entries_[at].name);
    if (found != before.end() && HasFiles(found->second))
      done_before_.emplace(at, std::move(found->second));
  }
}

// ---- the end

std::string Batch::IndexPath() const {
  if (!command_.index.empty()) return command_.index;
  const char* slash = EndsWithSlash(command_.output) ? "" : "/";
  const std::string shard = command_.shards == 1
                                ? std::string()
                                : fmt::format(".{}-of-{}", command_.shard, command_.shards);
  return fmt::format("{}{}index{}.json", command_.output, slash, shard);
}

std::string Batch::JournalPath() const { return IndexPath() + kJournalSuffix; }

Result<> Batch::WriteIndex() {
  for (std::size_t at = 0; at < jobs_.size(); ++at)
    Describe(GroupOf(jobs_[at]), jobs_[at].number, entries_[at]);
  BatchEnd end = batch_.end(entries_);
  printer_.Show(end.messages);
  if (!end.messages.ok()) exit_code_ = std::max<int>(exit_code_, kExitErrors);
  if (HasIndex()) end.files.insert(end.files.begin(), {"index", IndexPath(), std::move(end.index)});
  OutputFiles files;
  for (const std::string& source : dependencies_) read_.Add(source);
  for (OutputPiece& file : end.files) {
    if (read_.Has(file.path)) return Overwrites(file.path);
    files.Add(file.path, std::move(file.contents));
  }
  if (command_.write_dependencies && !end.files.empty()) {
    const std::string& path = end.files.front().path;
    const std::string rule =
        command_.dependency_file.empty() ? WithoutExtension(path) + ".d" : command_.dependency_file;
    if (read_.Has(rule)) return Overwrites(rule);
    if (!command_.batch.empty()) dependencies_.insert(dependencies_.begin(), command_.batch);
    files.Add(rule, DependencyRule(RuleTargets(command_, end.files, entries_), dependencies_));
  }
  return files.Commit();
}

void Batch::Summarise() {
  for (const std::string& line : errors_.Shared()) printer_.Say(line);
  const std::size_t left = jobs_.size() - finished_;
  if (exit_code_ == kExitOk && system::ErrorsAreOnTerminal()) {
    std::unordered_set<std::string> files;
    for (const BatchEntry& entry : entries_) {
      for (const auto& [kind, file] : entry.files) files.insert(file);
    }
    const std::chrono::duration<double> lasted = std::chrono::steady_clock::now() - begin_;
    printer_.Say(fmt::format("{} compiled, {}, {:.1f} s", jobs_.size(),
                             WithCount(files.size(), "file"), lasted.count()));
  }
  if (failed_ == 0) return;
  printer_.Say(
      fmt::format("{} of {} failed{}", failed_, jobs_.size(),
                  left == 0 ? "" : fmt::format("; {} were not compiled, -k goes on", left)));
}

// Prepares the request of every group, and shows each warning about the options once.
Result<> Batch::Prepare() {
  std::unordered_set<std::string> said;
  for (ShaderGroup& group : batch_.groups) {
    if (Result<> done = PrepareRequest(group.command); !done) return done;
    group.command.request.limits.is_cancelled = command_.request.limits.is_cancelled;
    const CompileResult notices = NoticesOf(group.command);
    if (!notices.messages.empty() && said.insert(notices.messages.front().text).second)
      printer_.Show(notices);
  }
  return {};
}

int Batch::RunAll(BatchOfGroups batch) {
  batch_ = std::move(batch);
  named_ = FilesRead(command_);
  for (const ShaderGroup& group : batch_.groups)
    std::ranges::copy(group.command.response_files, std::back_inserter(named_));
  for (const std::string& file : named_) read_.Add(file);
  Result<> ready = CheckUsage();
  if (ready) ready = Prepare();
  if (ready) ready = Plan();
  if (!ready) return printer_.Fail(ready.problem());
  AddDependencies(batch_.first.dependencies);
  printer_.Show(batch_.first);
  if (command_.resume && batch_.identity.empty())
    return printer_.Fail("--resume is for permutations and manifests, and this is an effect");
  if (!batch_.identity.empty()) {
    journal_ = std::make_unique<BatchJournal>(JournalPath(), batch_.identity);
    if (command_.resume) Resume();
    if (const Result<> begun = journal_->Begin(); !begun) return printer_.Fail(begun.problem());
  }
  CompileInOrder(
      jobs_.size(), command_.jobs,
      [this](std::size_t at, Compiler& compiler) { return Work(at, compiler); },
      [this](std::size_t at, CompileResult result) { return Finish(at, std::move(result)); });
  progress_.Clear();
  if (exit_code_ != kExitUsage || failed_ > 0) {
    if (const Result<> written = WriteIndex(); !written)
      exit_code_ = printer_.Fail(written.problem());
  }
  if (journal_ && exit_code_ == kExitOk) journal_->Remove();
  Summarise();
  return exit_code_;
}

RunResult Batch::Run(BatchOfGroups batch) {
  const int code = RunAll(std::move(batch));
  named_.insert(named_.end(), dependencies_.begin(), dependencies_.end());
  return {printer_.End(code, named_), {std::move(dependencies_)}};
}

}  // namespace

RunResult RunBatch(CommandLine command, BatchOfGroups batch) {
  return Batch(std::move(command)).Run(std::move(batch));
}

}  // namespace clipc
