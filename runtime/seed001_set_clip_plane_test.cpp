// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// "IDirect3DDevice9::SetClipPlane" (Microsoft), section by section.
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/clip_status.h"
#include "runtime/level9_binder.h"

namespace clipc::runtime {
namespace {

using ::testing::ElementsAre;

class RecordingDevice final : public ClipDevice {
 public:
  bool SetClipPlane(std::uint32_t index, const float plane[4]) noexcept override {
    calls.push_back("SetClipPlane(" + std::to_string(index) + ", " +
                    std::to_string(static_cast<int>(plane[0])) + ")");
    return true;
  }
  bool SetClipPlaneEnable(std::uint32_t mask) noexcept override {
    calls.push_back("D3DRS_CLIPPLANEENABLE = " + std::to_string(mask));
    return true;
  }
  std::vector<std::string> calls;
};

Table OnePlane(std::uint32_t count = 1) {
  Table table;
  table.enable_mask = (1u << count) - 1;
  table.planes.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) table.planes[i].byte_offset = 16 * i;
  return table;
}

TEST(Seed001Returns, AnIndexBeyondTheDevicesMaximumIsInvalidCall) {
  RecordingDevice device;
  const float constants[6][4] = {};
  const BoundBuffer buffer = {0, 0, constants, sizeof constants};
  for (std::uint32_t maximum = 0; maximum <= 6; ++maximum) {
    for (std::uint32_t count = 1; count <= 6; ++count) {
      Level9Binder binder(device, maximum);
      const Status status = binder.Bind(OnePlane(count), &buffer, 1);
      EXPECT_EQ(HresultOf(status.error()), count > maximum ? kD3dErrInvalidCall : kD3dOk);
    }
  }
}

// The document: also where the array is not large enough. No function can see that through a
// pointer to const float; the binder, which knows the buffer's size, can.
TEST(Seed001Returns, AnArrayOfLessThanFourFloatsIsInvalidCall) {
  RecordingDevice device;
  Level9Binder binder(device, 6);
  const float constants[4] = {};
  for (std::size_t floats = 0; floats < 4; ++floats) {
    const BoundBuffer buffer = {0, 0, constants, 4 * floats};
    EXPECT_EQ(HresultOf(binder.Bind(OnePlane(), &buffer, 1).error()), kD3dErrInvalidCall);
  }
  EXPECT_TRUE(device.calls.empty());
}

TEST(Seed001Remarks, VisibleIsGreaterOrEqualZero) {
  const UserClipPlanes user = {{{1, 2, 3, 4}}, 1};
  const auto is_visible = [&](float x, float y, float z, float w) {
    return (ClipCode({x, y, z, w}, user) & kClipPlane0) == 0;
  };
  EXPECT_TRUE(is_visible(1, 1, 1, 1));
  EXPECT_TRUE(is_visible(-6, 1, 0, 1)) << "-6 + 2 + 0 + 4 is 0: on the plane";
  EXPECT_FALSE(is_visible(-6.5f, 1, 0, 1));
}

TEST(Seed001Remarks, TheFourthCoefficientIsTimesW) {
  const UserClipPlanes user = {{{1, 0, 0, -1}}, 1};
  EXPECT_EQ(ClipCode({1.5f, 0, 0, 1.4f}, user) & kClipPlane0, 0u);
  EXPECT_NE(ClipCode({1.5f, 0, 0, 1.6f}, user) & kClipPlane0, 0u)
      << "homogeneous coordinates, not (x, y, z, 1)";
}

TEST(Seed001Remarks, SettingDoesNotEnable) {
  const UserClipPlanes set_only = {{{0, 0, 0, -1}}, 0};
  EXPECT_EQ(ClipCode({0, 0, 0.5f, 1}, set_only), 0u);

  RecordingDevice device;
  Level9Binder binder(device, 6);
  const float constants[4] = {7, 0, 0, 0};
  const BoundBuffer buffer = {0, 0, constants, sizeof constants};
  ASSERT_TRUE(binder.Bind(OnePlane(), &buffer, 1).ok());
  EXPECT_THAT(device.calls, ElementsAre("SetClipPlane(0, 7)", "D3DRS_CLIPPLANEENABLE = 1"));
}

}  // namespace
}  // namespace clipc::runtime
