// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/level9_binder.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/allocation_count.h"

namespace clipc::runtime {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// A device that records its calls and refuses planes that it does not have.
class RecordingDevice final : public ClipDevice {
 public:
  bool SetClipPlane(std::uint32_t index, const float plane[4]) noexcept override {
    if (index >= max_planes || refuse_planes) return false;
    calls.push_back("plane " + std::to_string(index));
    std::memcpy(planes[index], plane, sizeof planes[index]);
    return true;
  }
  bool SetClipPlaneEnable(std::uint32_t mask) noexcept override {
    if (refuse_mask) return false;
    calls.push_back("mask " + std::to_string(mask));
    enabled = mask;
    return true;
  }
  std::vector<std::string> Take() { return std::exchange(calls, {}); }

  std::vector<std::string> calls;
  float planes[8][4] = {};
  std::uint32_t enabled = 0;
  std::uint32_t max_planes = 6;
  bool refuse_planes = false;
  bool refuse_mask = false;
};

// `count` planes in b2, the first at register 1.
Table PlanesInB2(std::uint32_t count) {
  Table table;
  table.enable_mask = (1u << count) - 1;
  for (std::uint32_t i = 0; i < count; ++i) {
    TablePlane& plane = table.planes.emplace_back();
    plane.cbuffer = "Clip";
    plane.register_number = 2;
    plane.byte_offset = 16 * (i + 1);
  }
  return table;
}

class Level9BinderTest : public ::testing::Test {
 protected:
  Status Bind(const Table& table, std::uint32_t needed = ~0u) {
    const BoundBuffer buffers[] = {{0, 0, other_, sizeof other_},
                                   {2, 0, constants_, sizeof constants_}};
    return binder_.Bind(table, buffers, 2, needed);
  }

  float other_[4] = {9, 9, 9, 9};
  float constants_[7][4] = {{0, 0, 0, 0}, {1, 0, 0, 1}, {2, 0, 0, 2}, {3, 0, 0, 3},
                            {4, 0, 0, 4}, {5, 0, 0, 5}, {6, 0, 0, 6}};
  RecordingDevice device_;
  Level9Binder binder_{device_, 6};
};

TEST_F(Level9BinderTest, SetsPlanesThenTheMask) {
  ASSERT_TRUE(Bind(PlanesInB2(2)).ok());
  EXPECT_THAT(device_.Take(), ElementsAre("plane 0", "plane 1", "mask 3"));
  EXPECT_THAT(device_.planes[0], ElementsAre(1, 0, 0, 1));
  EXPECT_THAT(device_.planes[1], ElementsAre(2, 0, 0, 2));
}

TEST_F(Level9BinderTest, AllSixPlanes) {
  ASSERT_TRUE(Bind(PlanesInB2(6)).ok());
  EXPECT_EQ(device_.enabled, 63u);
  for (int i = 0; i < 6; ++i) EXPECT_EQ(device_.planes[i][3], static_cast<float>(i + 1));
}

TEST_F(Level9BinderTest, NothingChangedMeansNoCallAndNoAllocation) {
  const Table table = PlanesInB2(6);
  ASSERT_TRUE(Bind(table).ok());
  device_.calls.clear();
  const std::size_t before = AllocationCount();
  for (int i = 0; i < 100; ++i) {
    if (!Bind(table).ok()) break;
  }
  EXPECT_EQ(AllocationCount(), before);
  EXPECT_THAT(device_.Take(), IsEmpty());
}

TEST_F(Level9BinderTest, ErrorsDoNotAllocate) {
  const Table table = PlanesInB2(6);
  constants_[4][2] = std::numeric_limits<float>::quiet_NaN();
  const std::size_t before = AllocationCount();
  const Status status = Bind(table);
  EXPECT_EQ(AllocationCount(), before);
  EXPECT_EQ(status.error(), Error::kNotFinite);
}

TEST_F(Level9BinderTest, SetsOnlyWhatChanged) {
  ASSERT_TRUE(Bind(PlanesInB2(3)).ok());
  device_.calls.clear();
  constants_[2][0] = 7;
  ASSERT_TRUE(Bind(PlanesInB2(3)).ok());
  EXPECT_THAT(device_.Take(), ElementsAre("plane 1"));
  ASSERT_TRUE(Bind(PlanesInB2(2)).ok());
  EXPECT_THAT(device_.Take(), ElementsAre("mask 3"));
  ASSERT_TRUE(Bind(PlanesInB2(3)).ok());
  EXPECT_THAT(device_.Take(), ElementsAre("mask 7"));
}

TEST_F(Level9BinderTest, ComparesBits) {
  ASSERT_TRUE(Bind(PlanesInB2(1)).ok());
  device_.calls.clear();
  constants_[1][1] = -0.0f;
  ASSERT_TRUE(Bind(PlanesInB2(1)).ok());
  EXPECT_THAT(device_.Take(), ElementsAre("plane 0"));
  EXPECT_TRUE(std::signbit(device_.planes[0][1]));
}

TEST_F(Level9BinderTest, TheTableSaysWhereAPlaneLies) {
  Table table = PlanesInB2(1);
  table.planes[0].byte_offset = 96;
  ASSERT_TRUE(Bind(table).ok());
  EXPECT_EQ(device_.planes[0][0], 6.0f);
  table.planes[0].register_number = 0;
  table.planes[0].byte_offset = 0;
  ASSERT_TRUE(Bind(table).ok());
  EXPECT_EQ(device_.planes[0][0], 9.0f);
}

TEST_F(Level9BinderTest, RegisterSpacesAreApart) {
  Table table = PlanesInB2(1);
  table.planes[0].register_space = 1;
  EXPECT_EQ(Bind(table).error(), Error::kMissingBuffer);
  const BoundBuffer buffer = {2, 1, constants_, sizeof constants_};
  EXPECT_TRUE(binder_.Bind(table, &buffer, 1).ok());
}

TEST_F(Level9BinderTest, BytesNeedNoAlignment) {
  unsigned char bytes[1 + sizeof constants_];
  std::memcpy(bytes + 1, constants_, sizeof constants_);
  const BoundBuffer buffer = {2, 0, bytes + 1, sizeof constants_};
  ASSERT_TRUE(binder_.Bind(PlanesInB2(1), &buffer, 1).ok());
  EXPECT_EQ(device_.planes[0][0], 1.0f);
}

TEST_F(Level9BinderTest, OnlyNeededPlanesAreReadSetAndEnabled) {
  constants_[1][0] = std::numeric_limits<float>::infinity();
  ASSERT_TRUE(Bind(PlanesInB2(3), 0b110).ok());
  EXPECT_THAT(device_.Take(), ElementsAre("plane 1", "plane 2", "mask 6"));
  ASSERT_TRUE(Bind(PlanesInB2(3), 0).ok());
  EXPECT_THAT(device_.Take(), ElementsAre("mask 0"));
}

TEST_F(Level9BinderTest, InvalidateSetsEverythingAgain) {
  ASSERT_TRUE(Bind(PlanesInB2(2)).ok());
  device_.calls.clear();
  binder_.Invalidate();
  ASSERT_TRUE(Bind(PlanesInB2(2)).ok());
  EXPECT_THAT(device_.Take(), ElementsAre("plane 0", "plane 1", "mask 3"));
}

TEST_F(Level9BinderTest, ShadersWithoutPlanesDisableAll) {
  ASSERT_TRUE(binder_.BindNone().ok());
  EXPECT_THAT(device_.Take(), ElementsAre("mask 0"));
  ASSERT_TRUE(Bind(PlanesInB2(0)).ok());
  Table ignored = PlanesInB2(2);
  ignored.lowering = Lowering::kNone;
  ignored.enable_mask = 0;
  ASSERT_TRUE(Bind(ignored).ok());
  EXPECT_THAT(device_.Take(), IsEmpty());
}

TEST_F(Level9BinderTest, ZeroPlanesAreSet) {
  std::memset(constants_[1], 0, sizeof constants_[1]);
  ASSERT_TRUE(Bind(PlanesInB2(1)).ok());
  EXPECT_THAT(device_.Take(), ElementsAre("plane 0", "mask 1"));
}

TEST_F(Level9BinderTest, MorePlanesThanTheDevice) {
  Level9Binder small(device_, 2);
  const BoundBuffer buffer = {2, 0, constants_, sizeof constants_};
  const Status status = small.Bind(PlanesInB2(3), &buffer, 1);
  EXPECT_EQ(status.error(), Error::kInvalidCall);
  EXPECT_EQ(HresultOf(status.error()), kD3dErrInvalidCall);
  EXPECT_THAT(status.message(), HasSubstr("clip plane 2; the device has 2"));
  EXPECT_THAT(device_.Take(), IsEmpty());
  EXPECT_TRUE(small.Bind(PlanesInB2(3), &buffer, 1, 0b011).ok());
}

TEST_F(Level9BinderTest, TablesThatLieAboutTheirPlanes) {
  Table table = PlanesInB2(1);
  table.enable_mask = 0b11;
  EXPECT_EQ(Bind(table).error(), Error::kInvalidCall);
  table.enable_mask = 0x8000'0000;
  EXPECT_EQ(Bind(table).error(), Error::kInvalidCall);
  EXPECT_THAT(device_.Take(), IsEmpty());
}

TEST_F(Level9BinderTest, MissingBuffer) {
  const Status none = binder_.Bind(PlanesInB2(1), nullptr, 0);
  EXPECT_EQ(none.error(), Error::kMissingBuffer);
  EXPECT_THAT(none.message(),
              HasSubstr("clip plane 0 lies in constant buffer b2 `Clip`, which is not bound"));
  const BoundBuffer null = {2, 0, nullptr, 64};
  EXPECT_EQ(binder_.Bind(PlanesInB2(1), &null, 1).error(), Error::kMissingBuffer);
}

TEST_F(Level9BinderTest, ShortBuffer) {
  for (const std::size_t size : {0, 15, 31}) {
    const BoundBuffer buffer = {2, 0, constants_, size};
    EXPECT_EQ(binder_.Bind(PlanesInB2(1), &buffer, 1).error(), Error::kShortBuffer) << size;
  }
  const BoundBuffer buffer = {2, 0, constants_, 47};
  const Status status = binder_.Bind(PlanesInB2(2), &buffer, 1);
  EXPECT_THAT(status.message(),
              HasSubstr("clip plane 1 lies at bytes 32 to 47 of b2 `Clip`, which has 47"));
  EXPECT_THAT(device_.Take(), IsEmpty()) << "plane 0 was good, but all or nothing is set";
  const BoundBuffer enough = {2, 0, constants_, 48};
  EXPECT_TRUE(binder_.Bind(PlanesInB2(2), &enough, 1).ok());

  Table far = PlanesInB2(1);
  far.planes[0].byte_offset = 0xFFFF'FFF0u;
  EXPECT_EQ(Bind(far).error(), Error::kShortBuffer);
}

TEST_F(Level9BinderTest, CoefficientsThatAreNotFinite) {
  const Table table = PlanesInB2(2);
  ASSERT_TRUE(Bind(table).ok());
  device_.calls.clear();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), kInfinity, -kInfinity}) {
    for (int i = 0; i < 4; ++i) {
      constants_[2][i] = bad;
      const Status status = Bind(table);
      EXPECT_EQ(status.error(), Error::kNotFinite);
      EXPECT_THAT(status.message(), HasSubstr("clip plane 1"));
      constants_[2][i] = i == 0 || i == 3 ? 2.0f : 0.0f;
    }
  }
  EXPECT_TRUE(Bind(table).ok());
  EXPECT_THAT(device_.Take(), IsEmpty());
}

TEST_F(Level9BinderTest, TablesOfOtherLowerings) {
  Table table = PlanesInB2(1);
  table.lowering = Lowering::kClipDistance;
  EXPECT_EQ(Bind(table).error(), Error::kWrongLowering);
}

TEST_F(Level9BinderTest, ARefusedCallIsRepeated) {
  device_.refuse_planes = true;
  EXPECT_EQ(Bind(PlanesInB2(1)).error(), Error::kDeviceFailed);
  device_.refuse_planes = false;
  device_.refuse_mask = true;
  EXPECT_EQ(Bind(PlanesInB2(1)).error(), Error::kDeviceFailed);
  EXPECT_THAT(device_.Take(), ElementsAre("plane 0"));
  device_.refuse_mask = false;
  EXPECT_TRUE(Bind(PlanesInB2(1)).ok());
  EXPECT_THAT(device_.Take(), ElementsAre("mask 1"));
}

// Whatever is bound, changed, lost or refused: after a Bind that succeeded, the device clips with
// the table's planes.
TEST(Level9BinderProperty, TheDeviceHoldsTheTable) {
  std::mt19937 random(1);
  RecordingDevice device;
  Level9Binder binder(device, 6);
  float constants[7][4] = {};
  const BoundBuffer buffer = {2, 0, constants, sizeof constants};
  int bound = 0;
  for (int step = 0; step < 20000; ++step) {
    constants[1 + random() % 6][random() % 4] =
        random() % 50 == 0 ? NAN : static_cast<float>(random() % 3);
    device.refuse_planes = random() % 20 == 0;
    device.refuse_mask = random() % 20 == 0;
    if (random() % 30 == 0) {
      std::memset(device.planes, 0x7f, sizeof device.planes);
      device.enabled = 0xFFFF;
      binder.Invalidate();
    }
    const std::uint32_t needed = random() % 64;
    const Table table = PlanesInB2(random() % 7);
    if (!binder.Bind(table, &buffer, 1, needed).ok()) continue;
    ++bound;
    ASSERT_EQ(device.enabled, table.enable_mask & needed);
    for (std::uint32_t i = 0; i < 6; ++i) {
      if ((device.enabled >> i & 1) != 0) {
        ASSERT_EQ(std::memcmp(device.planes[i], constants[i + 1], 16), 0);
      }
    }
  }
  EXPECT_GT(bound, 10000);
}

}  // namespace
}  // namespace clipc::runtime
