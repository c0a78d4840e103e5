// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "base/diagnostics.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace clipc {
namespace {

constexpr std::array<DiagInfo, kDiagCount> kInfos = {{
#define DIAG(Name, SeverityName, FxcCode, Format, ...) \
  {#Name, Severity::SeverityName, FxcCode, Format},
#include "base/diagnostic_kinds.def"
#undef DIAG
}};

}  // namespace

const DiagInfo& InfoOf(DiagId id) { return kInfos[static_cast<std::size_t>(id)]; }

std::string PrintedName(DiagId id) {
  std::string printed;
  for (char c : InfoOf(id).camel_name) {
    if (std::isupper(static_cast<unsigned char>(c)) && !printed.empty()) printed += '-';
    printed += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return printed;
}

std::optional<DiagId> DiagIdOf(std::string_view printed_name) {
  for (std::size_t i = 0; i < kDiagCount; ++i) {
    if (PrintedName(static_cast<DiagId>(i)) == printed_name) return static_cast<DiagId>(i);
  }
  return std::nullopt;
}

std::string MessageSuffix(const Diagnostic& diagnostic) {
  const DiagInfo& info = InfoOf(diagnostic.id);
  if (diagnostic.severity == Severity::kNote) return {};
  if (info.severity == Severity::kWarning) {
    const char* promoted = diagnostic.severity == Severity::kError ? "-Werror," : "";
    return fmt::format(" [{}-W{}]", promoted, PrintedName(diagnostic.id));
  }
  const char* separator = info.fxc_code.empty() ? "" : ", ";
  return fmt::format(" [{}{}{}]", PrintedName(diagnostic.id), separator, info.fxc_code);
}

void Diagnostics::SetWarning(std::string_view fxc_code, WarningState state) {
  for (std::size_t i = 0; i < kDiagCount; ++i) {
    if (kInfos[i].fxc_code != fxc_code || kInfos[i].severity != Severity::kWarning) continue;
    pragma_off_[i] = state == WarningState::kOff;
    pragma_error_[i] = state == WarningState::kError;
  }
}

Diagnostic& Diagnostics::Add(Span where, DiagId id, std::string message) {
  const auto index = static_cast<std::size_t>(id);
  Severity severity = InfoOf(id).severity;
  bool dropped = false;
  if (severity == Severity::kWarning) {
    dropped = options_.off[index] || options_.no_warnings || pragma_off_[index];
    if (options_.warnings_are_errors || options_.as_error[index] || pragma_error_[index])
      severity = Severity::kError;
  }
  if (!dropped) {
    int& count = severity == Severity::kError ? error_count_ : warning_count_;
    dropped = count >= (severity == Severity::kError ? kMaxErrors : kMaxWarnings);
    if (!dropped) ++count;
    dropped =
        dropped || (where && std::ranges::any_of(list_, [&](const Diagnostic& other) {
                      return other.id == id && other.span == where && other.message == message;
                    }));
  }
  if (dropped) {
    dropped_ = Diagnostic{id, severity, where, {}, {}, {}, {}};
    return dropped_;
  }
  return list_.emplace_back(Diagnostic{id, severity, where, std::move(message), {}, {}, {}});
}

void Diagnostics::Append(const Diagnostics& other) {
  for (const Diagnostic& diagnostic : other.list_) {
    Diagnostic& added = Add(diagnostic.span, diagnostic.id, diagnostic.message);
    added.also = diagnostic.also;
    added.fix_its = diagnostic.fix_its;
    added.notes = diagnostic.notes;
  }
}

}  // namespace clipc
