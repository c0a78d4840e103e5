// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/status.h"

#include <cstring>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace clipc::runtime {
namespace {

TEST(Status, SuccessSaysNothing) {
  const Status status;
  EXPECT_TRUE(status.ok());
  EXPECT_EQ(status.error(), Error::kNone);
  EXPECT_STREQ(status.message(), "");
}

TEST(Status, FailureSaysWhat) {
  const Status status = Status::Failure(Error::kShortBuffer, "%d of %s", 3, "four");
  EXPECT_FALSE(status.ok());
  EXPECT_EQ(status.error(), Error::kShortBuffer);
  EXPECT_STREQ(status.message(), "3 of four");
}

TEST(Status, LongMessagesAreCut) {
  const std::string text(1000, 'x');
  const Status status = Status::Failure(Error::kDamagedTable, "%s", text.c_str());
  EXPECT_EQ(std::strlen(status.message()), 199u);
}

TEST(Status, EveryErrorHasANameOfItsOwn) {
  std::set<std::string> names;
  for (int i = 0; i <= static_cast<int>(Error::kLooksTransposed); ++i)
    names.insert(NameOf(static_cast<Error>(i)));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(Error::kLooksTransposed) + 1);
  EXPECT_EQ(names.count("unknown error"), 0u);
}

TEST(Status, HresultsAreDirect3Ds) {
  EXPECT_EQ(HresultOf(Error::kNone), 0);
  EXPECT_EQ(static_cast<std::uint32_t>(HresultOf(Error::kInvalidCall)),
            0x8876086Cu);  // MAKE_D3DHRESULT(2156)
  EXPECT_EQ(HresultOf(Error::kNotFinite), kD3dErrInvalidCall);
  EXPECT_EQ(HresultOf(Error::kOutOfMemory), kEOutOfMemory);
}

}  // namespace
}  // namespace clipc::runtime
