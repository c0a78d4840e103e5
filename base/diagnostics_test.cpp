// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "base/diagnostics.h"

#include <set>

#include <gtest/gtest.h>

namespace clipc {
namespace {

TEST(Catalogue, PrintedNamesAreUniqueAndReadBack) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < kDiagCount; ++i) {
    const auto id = static_cast<DiagId>(i);
    const std::string name = PrintedName(id);
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_EQ(DiagIdOf(name), id) << name;
  }
  EXPECT_EQ(PrintedName(DiagId::kMacroRedefined), "macro-redefined");
  EXPECT_EQ(DiagIdOf("no-such-thing"), std::nullopt);
}

// A text does not end in a full stop; a code looks like X3084.
TEST(Catalogue, WordingAndCodes) {
  for (std::size_t i = 0; i < kDiagCount; ++i) {
    const DiagInfo& info = InfoOf(static_cast<DiagId>(i));
    ASSERT_FALSE(info.format.empty()) << info.camel_name;
    EXPECT_NE(info.format.back(), '.') << info.camel_name;
    if (info.fxc_code.empty()) continue;
    EXPECT_EQ(info.fxc_code.size(), 5u) << info.camel_name;
    EXPECT_EQ(info.fxc_code[0], 'X') << info.camel_name;
  }
}

TEST(Diagnostics, WarningOptions) {
  WarningOptions options;
  options.off[static_cast<std::size_t>(DiagId::kMacroRedefined)] = true;
  options.as_error[static_cast<std::size_t>(DiagId::kUnknownPragma)] = true;
  Diagnostics diagnostics(options);
  diagnostics.Report({}, diag::MacroRedefined, "quiet");
  EXPECT_TRUE(diagnostics.all().empty());
  diagnostics.Report({}, diag::UnknownPragma, "loud");
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(diagnostics.all()[0].severity, Severity::kError);
  EXPECT_EQ(MessageSuffix(diagnostics.all()[0]), " [-Werror,-Wunknown-pragma]");
  EXPECT_TRUE(diagnostics.has_errors());
}

TEST(Diagnostics, SuffixesNameTheirKind) {
  Diagnostics diagnostics;
  diagnostics.Report({}, diag::ClipPlaneNotFloat4, "p", "half4").Note({}, diag::FirstGivenHere);
  diagnostics.Report({}, diag::IncludeTooDeep, 200);
  diagnostics.Report({}, diag::ClipPlaneRepeated, "p");
  EXPECT_EQ(MessageSuffix(diagnostics.all()[0]), " [clip-plane-not-float4, X3084]");
  EXPECT_EQ(MessageSuffix(diagnostics.all()[0].notes[0]), "");
  EXPECT_EQ(MessageSuffix(diagnostics.all()[1]), " [include-too-deep]");
  EXPECT_EQ(MessageSuffix(diagnostics.all()[2]), " [-Wclip-plane-repeated]");
}

TEST(Diagnostics, PragmaWarningTakesFxcCodes) {
  Diagnostics diagnostics;
  diagnostics.SetWarning("X1519", Diagnostics::WarningState::kOff);
  diagnostics.Report({}, diag::MacroRedefined, "quiet");
  EXPECT_TRUE(diagnostics.all().empty());
  diagnostics.SetWarning("X1519", Diagnostics::WarningState::kError);
  diagnostics.Report({}, diag::MacroRedefined, "loud");
  EXPECT_EQ(diagnostics.error_count(), 1);
  diagnostics.SetWarning("X1519", Diagnostics::WarningState::kOn);
  diagnostics.Report({}, diag::MacroRedefined, "plain");
  EXPECT_EQ(diagnostics.all().size(), 2u);
  diagnostics.SetWarning("X3000", Diagnostics::WarningState::kOff);  // of an error: no effect
  diagnostics.Report({}, diag::InvalidNumber, "1x", "");
  EXPECT_EQ(diagnostics.error_count(), 2);
}

TEST(Diagnostics, CountsARepeatedErrorAndKeepsOne) {
  Diagnostics diagnostics;
  for (int i = 0; i < 2; ++i) diagnostics.Report(Span{1, 2}, diag::InvalidNumber, "1x", "");
  EXPECT_EQ(diagnostics.error_count(), 2);
  EXPECT_EQ(diagnostics.all().size(), 1u);
}

TEST(Diagnostics, KeepsABoundedNumber) {
  Diagnostics diagnostics;
  for (int i = 0; i < 10 * Diagnostics::kMaxWarnings; ++i) {
    diagnostics.Report({}, diag::InvalidNumber, "1x", "")
        .Note({}, diag::PlainNote, "note")
        .Fix({}, "1");
    diagnostics.Report({}, diag::UnknownPragma, "x");
  }
  EXPECT_TRUE(diagnostics.TooManyErrors());
  EXPECT_EQ(diagnostics.error_count(), Diagnostics::kMaxErrors);
  EXPECT_EQ(diagnostics.all().size(),
            static_cast<std::size_t>(Diagnostics::kMaxErrors + Diagnostics::kMaxWarnings));
}

}  // namespace
}  // namespace clipc
