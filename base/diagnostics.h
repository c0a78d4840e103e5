// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <bitset>
#include <cstdint>
#include <functional>
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

// One enumerator for each row of base/diagnostic_kinds.def.
enum class DiagId : std::uint16_t {
#define DIAG(Name, Severity, FxcCode, Format, ...) k##Name,
#include "base/diagnostic_kinds.def"
#undef DIAG
  kCount,
};
inline constexpr std::size_t kDiagCount = static_cast<std::size_t>(DiagId::kCount);

struct DiagInfo {
  std::string_view camel_name;  // "ClipPlaneNotFloat4"; PrintedName gives "clip-plane-not-float4"
  Severity severity;
  std::string_view fxc_code;  // "X3084", or empty where fxc has none
  std::string_view format;
};
const DiagInfo& InfoOf(DiagId id);
// The kind's name as users see it, "clip-plane-not-float4": in brackets after every warning and
// error, in docs/diagnostics.md, and for warnings in -W<name> and -Wno-<name>.
std::string PrintedName(DiagId id);
// The inverse of PrintedName.
std::optional<DiagId> DiagIdOf(std::string_view printed_name);

namespace diag {
// The types that the rows of the catalogue name.
using Text = std::string_view;
using std::int64_t, std::size_t, std::uint32_t, std::uint64_t;

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

// A change of the user's text: `text` replaces that of `span`, or, if `insert` is set, is inserted
// before it.
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
  std::vector<Span> also;  // further places of the same line, underlined too
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

// The bracket after a message, with a space before it. A warning's names the option that switches
// it off, " [-Wclip-plane-repeated]"; an error's has the kind's name and, where there is one, fxc's
// code, " [clip-plane-not-float4, X3084]". Empty for a note.
std::string MessageSuffix(const Diagnostic& diagnostic);

// The command line's -Werror, -w, -W<name>, -Werror=<name> and -Wno-<name>. A warning is on unless
// it is switched off.
struct WarningOptions {
  bool warnings_are_errors = false;
  bool no_warnings = false;
  std::bitset<kDiagCount> off;
  std::bitset<kDiagCount> as_error;
};

// A means to end a compile early. The stages ask it wherever they ask for TooManyErrors.
class Watch {
 public:
  explicit Watch(std::function<bool()> must_stop) : must_stop_(std::move(must_stop)) {}

  // Whether the compile must end. Asks the owner only at every kEvery-th call; after its first yes
  // the answer is always yes.
  bool MustStop() { return stopped_ || (++calls_ % kEvery == 0 && AskNow()); }
  bool AskNow() { return stopped_ = stopped_ || must_stop_(); }
  bool stopped() const { return stopped_; }

 private:
  static constexpr unsigned kEvery = 256;

  std::function<bool()> must_stop_;
  unsigned calls_ = 0;
  bool stopped_ = false;
};

// The messages of one compile, in the order of their discovery, each once for a place. Errors
// past kMaxErrors and warnings past kMaxWarnings are dropped, so that hostile input cannot make the
// list large.
class Diagnostics {
 public:
  static constexpr int kMaxErrors = 50;
  static constexpr int kMaxWarnings = 200;

  explicit Diagnostics(WarningOptions options = {}) : options_(options) {}

  // Reports a message about `where`. The returned reference takes notes and fix-its; it is valid
  // until the next Report.
  template <typename... Args>
  Diagnostic& Report(Span where, const diag::Kind<Args...>& kind,
                     const std::type_identity_t<Args>&... args) {
    return Add(where, kind.id, fmt::format(kind.format, args...));
  }

  // Adds a message of other Diagnostics as it is, whatever the options and the limits are.
  void Add(Diagnostic diagnostic) { list_.push_back(std::move(diagnostic)); }

  // Reports what `other` has, in its order.
  void Append(const Diagnostics& other);

  // `#pragma warning(disable: 3206)`: sets the state of every warning with that fxc code, for the
  // reports that follow. A warning that the command line switches off stays off.
  enum class WarningState : std::uint8_t { kOn, kOff, kError };
  void SetWarning(std::string_view fxc_code, WarningState state);
  // Whether a pragma switches a warning off or makes one an error.
  bool has_pragmas() const { return pragma_off_.any() || pragma_error_.any(); }

  // `watch`, which may be null, must outlive the compile. When it stops, the stages stop as they do
  // after errors, without a message.
  void SetWatch(Watch* watch) { watch_ = watch; }

  bool has_errors() const { return error_count_ > 0 || (watch_ && watch_->stopped()); }
  // Counts every report of an error, also one that `all` has already: a stage that reported an
  // error has raised the count, whatever earlier stages said. At most kMaxErrors.
  int error_count() const { return error_count_; }
  bool TooManyErrors() const {
    return error_count_ >= kMaxErrors || (watch_ && watch_->MustStop());
  }
  const std::vector<Diagnostic>& all() const { return list_; }

 private:
  Diagnostic& Add(Span where, DiagId id, std::string message);

  WarningOptions options_;
  std::bitset<kDiagCount> pragma_off_;
  std::bitset<kDiagCount> pragma_error_;
  std::vector<Diagnostic> list_;
  Diagnostic dropped_{};
  Watch* watch_ = nullptr;
  int error_count_ = 0;
  int warning_count_ = 0;
};

}  // namespace clipc
