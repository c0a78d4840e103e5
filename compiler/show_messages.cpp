// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/show_messages.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>

#include "base/system.h"
#include "compiler/driver.h"

namespace clipc {
namespace {

void Print(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }

}  // namespace

int Fail(std::string_view what) {
  Print(fmt::format("clipc: error: {}\n", what));
  return kExitUsage;
}

bool TerminalHasColour() { return system::ErrorsAreOnTerminal() && !std::getenv("NO_COLOR"); }

void MessagePrinter::Show(const CompileResult& result) {
  switch (format_) {
    case MessageFormat::kText: return Print(result.text);
    case MessageFormat::kMsvc: return Print(RenderMsvc(result.messages));
    case MessageFormat::kJson:
    case MessageFormat::kSarif:
      messages_.insert(messages_.end(), result.messages.begin(), result.messages.end());
      return;
  }
}

void MessagePrinter::Say(std::string_view line) const {
  if (IsLines()) Print(fmt::format("clipc: {}\n", line));
}

void MessagePrinter::End() const {
  if (IsLines()) return;
  Print(format_ == MessageFormat::kJson ? RenderJson(messages_) : RenderSarif(messages_));
}

Progress::Progress(bool is_wanted) : is_on_(is_wanted && system::ErrorsAreOnTerminal()) {}

void Progress::Say(std::size_t done, std::size_t count, std::string_view name) {
  if (!is_on_) return;
  using std::chrono::duration_cast, std::chrono::milliseconds, std::chrono::steady_clock;
  const auto now = duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count();
  if (is_shown_ && now - last_ < 100) return;
  last_ = now;
  is_shown_ = true;
  Print(fmt::format("\r\x1b[K[{}/{}] {}", done, count, name.substr(0, 60)));
}

void Progress::Clear() {
  if (is_shown_) Print("\r\x1b[K");
  is_shown_ = false;
}

}  // namespace clipc
