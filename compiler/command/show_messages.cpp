// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/command/show_messages.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <fmt/format.h>

#include "base/file_set.h"
#include "base/spelling.h"
#include "base/system.h"
#include "compiler/command/exit_code.h"
#include "compiler/command/output_files.h"

namespace clipc {
namespace {

void PrintError(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }

// The error of a run, as one whole text.
std::string ErrorText(std::string_view what, MessageFormat format) {
  switch (format) {
    case MessageFormat::kJson: return RenderJson({UsageMessage(what)});
    case MessageFormat::kSarif: return RenderSarif({UsageMessage(what)});
    default: return fmt::format("clipc: error: {}\n", what);
  }
}

}  // namespace

int Fail(std::string_view what, MessageFormat format) {
  PrintError(ErrorText(what, format));
  return kExitUsage;
}

bool WantsColour(const CommandLine& command) {
  return command.colour.value_or(command.messages.empty() && system::ErrorsAreOnTerminal() &&
                                 !std::getenv("NO_COLOR"));
}

void MessagePrinter::Print(std::string_view text) {
  if (file_.empty())
    PrintError(text);
  else
    text_ += text;
}

void MessagePrinter::Show(const CompileResult& result) {
  switch (format_) {
    case MessageFormat::kText:
      for (const Message& message : result.messages) {
        error_count_ += message.severity == Severity::kError ? 1 : 0;
        warning_count_ += message.severity == Severity::kWarning ? 1 : 0;
      }
      return Print(result.text);
    case MessageFormat::kMsvc: return Print(RenderMsvc(result.messages));
    case MessageFormat::kJson:
    case MessageFormat::kSarif:
      messages_.insert(messages_.end(), result.messages.begin(), result.messages.end());
      return;
  }
}

int MessagePrinter::Fail(std::string_view what) {
  if (IsLines())
    Print(ErrorText(what, format_));
  else
    messages_.push_back(UsageMessage(what));
  return kExitUsage;
}

void MessagePrinter::Say(std::string_view line) {
  if (IsLines()) Print(fmt::format("clipc: {}\n", line));
}

std::string MessagePrinter::Document() const {
  return format_ == MessageFormat::kJson ? RenderJson(messages_) : RenderSarif(messages_);
}

Result<> MessagePrinter::WriteFile(const std::vector<std::string>& read) const {
  FileSet sources;
  for (const std::string& source : read) sources.Add(source);
  if (sources.Has(file_))
    return Problem{fmt::format("the messages in `{}` would overwrite a file that is read", file_)};
  OutputFiles files;
  files.Add(file_, text_);
  return files.Commit();
}

int MessagePrinter::End(int code, const std::vector<std::string>& read) {
  if (format_ == MessageFormat::kText && file_.empty() && system::ErrorsAreOnTerminal()) {
    std::string counts = error_count_ ? WithCount(error_count_, "error") : "";
    if (error_count_ && warning_count_) counts += " and ";
    if (warning_count_) counts += WithCount(warning_count_, "warning");
    if (!counts.empty()) Print(counts + " generated.\n");
  }
  if (!IsLines()) Print(Document());
  if (file_.empty()) return code;
  const Result<> written = WriteFile(read);
  if (written) return code;
  file_.clear();
  if (IsLines()) Print(text_);
  Fail(written.problem());
  if (!IsLines()) Print(Document());
  return kExitUsage;
}

Progress::Progress(bool is_wanted) : is_on_(is_wanted && system::ErrorsAreOnTerminal()) {}

void Progress::Say(std::size_t done, std::size_t count, std::string_view name) {
  if (!is_on_) return;
  using std::chrono::duration_cast, std::chrono::milliseconds, std::chrono::steady_clock;
  const auto now = duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count();
  if (is_shown_ && now - last_ < 100) return;
  last_ = now;
  is_shown_ = true;
  PrintError(fmt::format("\r\x1b[K[{}/{}] {}", done, count, name.substr(0, 60)));
}

void Progress::Clear() {
  if (is_shown_) PrintError("\r\x1b[K");
  is_shown_ = false;
}

}  // namespace clipc
