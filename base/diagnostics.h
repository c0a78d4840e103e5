// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <bitset>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/span.h"

namespace clipc {

enum class Severity : std::uint8_t { kNote, kWarning, kError };

// One enumerator per line of the catalogue (diagnostic_kinds.def).
enum class DiagId : std::uint16_t {
#define DIAG(Name, Severity, FxcCode, Format, ...) k##Name,
#include "base/diagnostic_kinds.def"
#undef DIAG
  kCount,
};
inline constexpr std::size_t kDiagCount = static_cast<std::size_t>(DiagId::kCount);

struct DiagInfo {
  std::string_view camel_name;  // "ClipPlaneNotFloat4"; Printed() gives "clip-plane-not-float4"
  Severity severity;
  std::string_view fxc_code;  // "X3084", or empty where fxc has none
  std::string_view format;
};
const DiagInfo& InfoOf(DiagId id);
// The name users write in -W<name>, -Wno-<name>, and see in brackets after a message:
// "clip-plane-not-float4".
std::string PrintedName(DiagId id);
// The inverse of PrintedName.
std::optional<DiagId> DiagIdOf(std::string_view printed_name);

namespace diag {
// A kind of diagnostic with the types of its arguments: a wrong number or type of arguments does
// not compile.
template <typename... Args>
struct Kind {
  DiagId id;
  fmt::format_string<const Args&...> format;
};
#define DIAG(Name, Severity, FxcCode, Format, ...) \
  inline constexpr Kind<__VA_ARGS__> Name{DiagId::k##Name, Format};
#include "base/diagnostic_kinds.def"
#undef DIAG
}  // namespace diag

// Replaces the text of `span` by `text`; inserts before `span` when `insert` is set.
struct FixIt {
  Span span;
  std::string text;
  bool insert = false;
};

struct Diagnostic {
  DiagId id;
  Severity severity;
  Span span;
  std::string message;
  std::vector<Span> also;  // further places to underline in the same line
  std::vector<FixIt> fix_its;
  std::vector<Diagnostic> notes;

  template <typename... Args>
  Diagnostic& Note(Span where, const diag::Kind<Args...>& kind,
                   const std::type_identity_t<Args>&... args) {
    notes.push_back(
        {kind.id, Severity::kNote, where, fmt::format(kind.format, args...), {}, {}, {}});
    return *this;
  }
  Diagnostic& Fix(Span where, std::string text) {
    fix_its.push_back({where, std::move(text), false});
    return *this;
  }
};

// What stands in brackets after the message: the option that switches a warning off, fxc's code of
// an error. Starts with a space; empty for a note and for an error that fxc does not number.
std::string MessageSuffix(const Diagnostic& diagnostic);

// What -Werror, -W<name> and -Wno-<name> ask for. All warnings are on unless switched off.
struct WarningOptions {
  bool warnings_are_errors = false;
  bool no_warnings = false;
  std::bitset<kDiagCount> off;
  std::bitset<kDiagCount> as_error;
};

// Collects what one compile has to say, in the order of discovery. Past kMaxErrors errors nothing
// more is kept, so that hostile input cannot make the list large.
class Diagnostics {
 public:
  static constexpr int kMaxErrors = 50;
  static constexpr int kMaxWarnings = 200;

  explicit Diagnostics(WarningOptions options = {}) : options_(options) {}

  // The returned reference takes notes and fix-its; it is valid until the next Report.
  template <typename... Args>
  Diagnostic& Report(Span where, const diag::Kind<Args...>& kind,
                     const std::type_identity_t<Args>&... args) {
    return Add(where, kind.id, fmt::format(kind.format, args...));
  }

  // `#pragma warning(disable: 3206)`: from here on, what the shader itself asks for every warning
  // with that fxc code. The command line has the last word on warnings it switches off.
  enum class WarningState : std::uint8_t { kOn, kOff, kError };
  void SetWarning(std::string_view fxc_code, WarningState state);

  bool has_errors() const { return error_count_ > 0; }
  int error_count() const { return error_count_; }
  int warning_count() const { return warning_count_; }
  bool TooManyErrors() const { return error_count_ >= kMaxErrors; }
  const std::vector<Diagnostic>& all() const { return list_; }

 private:
  Diagnostic& Add(Span where, DiagId id, std::string message);

  WarningOptions options_;
  std::bitset<kDiagCount> pragma_off_;
  std::bitset<kDiagCount> pragma_error_;
  std::vector<Diagnostic> list_;
  Diagnostic dropped_{};
  int error_count_ = 0;
  int warning_count_ = 0;
};

}  // namespace clipc
