// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/clip_status.h"

#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "runtime/allocation_count.h"

namespace clipc::runtime {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

std::uint32_t FrustumCodeOf(float x, float y, float z, float w) {
  return ClipCode({x, y, z, w}, {});
}

TEST(ClipCodeTest, FrustumPlanes) {
  EXPECT_EQ(FrustumCodeOf(0, 0, 0.5f, 1), 0u);
  EXPECT_EQ(FrustumCodeOf(-1.5f, 0, 0.5f, 1), kClipLeft);
  EXPECT_EQ(FrustumCodeOf(1.5f, 0, 0.5f, 1), kClipRight);
  EXPECT_EQ(FrustumCodeOf(0, 1.5f, 0.5f, 1), kClipTop);
  EXPECT_EQ(FrustumCodeOf(0, -1.5f, 0.5f, 1), kClipBottom);
  EXPECT_EQ(FrustumCodeOf(0, 0, -0.5f, 1), kClipFront);
  EXPECT_EQ(FrustumCodeOf(0, 0, 1.5f, 1), kClipBack);
  EXPECT_EQ(FrustumCodeOf(2, 2, 2, 1), kClipRight | kClipTop | kClipBack);
}

TEST(ClipCodeTest, OnAPlaneIsInside) {
  EXPECT_EQ(FrustumCodeOf(-1, 1, 0, 1), 0u);
  EXPECT_EQ(FrustumCodeOf(1, -1, 1, 1), 0u);
  EXPECT_EQ(FrustumCodeOf(0, 0, -0.0f, 1), 0u);
  EXPECT_EQ(FrustumCodeOf(0, 0, 0, 0), 0u);
}

TEST(ClipCodeTest, BehindTheEye) {
  // w < 0: left and right, top and bottom at once.
  EXPECT_EQ(FrustumCodeOf(0, 0, 0, -1),
            kClipLeft | kClipRight | kClipTop | kClipBottom | kClipBack);
}

TEST(ClipCodeTest, UserPlanesAreDottedWithTheWholePosition) {
  UserClipPlanes user;
  const float plane[4] = {1, 2, 3, -10};
  std::memcpy(user.planes[4], plane, sizeof plane);
  user.enable_mask = 0b10000;
  EXPECT_EQ(ClipCode({0, 0, 0.5f, 1}, user), kClipPlane0 << 4);
  EXPECT_EQ(ClipCode({1, 1.5f, 2, 2}, user), kClipPlane0 << 4) << "1 + 3 + 6 - 20";
  EXPECT_EQ(ClipCode({2, 2, 2, 1.2f}, user) & (kClipPlane0 << 4), 0u) << "2 + 4 + 6 - 12";
  user.enable_mask = 0b01111;
  EXPECT_EQ(ClipCode({0, 0, 0.5f, 1}, user), 0u);
  user.enable_mask = ~0u;
  EXPECT_EQ(ClipCode({0, 0, 0.5f, 1}, user), kClipPlane0 << 4)
      << "there are six planes, and zero planes keep everything";
}

TEST(ClipCodeTest, NanIsOutside) {
  EXPECT_EQ(FrustumCodeOf(kNan, 0, 0.5f, 1), kClipLeft | kClipRight);
  EXPECT_EQ(FrustumCodeOf(0, 0, kNan, 1), kClipFront | kClipBack);
  EXPECT_EQ(FrustumCodeOf(0, 0, 0, kNan), 0x02Fu) << "z >= 0 does not ask w";
  UserClipPlanes user;
  user.enable_mask = 1;
  EXPECT_EQ(ClipCode({kInfinity, 0, 0.5f, 1}, user), kClipRight | kClipPlane0) << "0 * infinity";
  user.planes[0][3] = kNan;
  EXPECT_EQ(ClipCode({0, 0, 0.5f, 1}, user), std::uint32_t{kClipPlane0});
}

// Random vertices of numbers that meet planes exactly, and of odd numbers.
class Vertices {
 public:
  explicit Vertices(std::uint32_t seed) : random_(seed) {}
  float Number() {
    constexpr float kOdd[] = {0.0f,   -0.0f,   kNan,  kInfinity, -kInfinity,
                              1e-45f, -1e-45f, 3e38f, -3e38f};
    switch (random_() % 8) {
      case 0: return kOdd[random_() % std::size(kOdd)];
      case 1:
      case 2: return static_cast<float>(static_cast<int>(random_() % 5) - 2);
      default: return static_cast<float>(random_()) * 0x1p-31f - 1;
    }
  }
  UserClipPlanes Planes() {
    UserClipPlanes user;
    for (auto& plane : user.planes) {
      for (float& c : plane) c = Number();
    }
    user.enable_mask = static_cast<std::uint32_t>(random_());
    return user;
  }
  std::vector<float> Positions(std::size_t count) {
    std::vector<float> positions(4 * count);
    for (float& p : positions) p = Number();
    return positions;
  }

 private:
  std::mt19937 random_;
};

TEST(UpdateClipStatusTest, IsExactlyTheScalarResult) {
  Vertices vertices(1);
  for (std::size_t count = 0; count < 300; ++count) {
    const UserClipPlanes user = vertices.Planes();
    const std::vector<float> positions = vertices.Positions(count);
    ClipStatus status, expected;
    std::vector<std::uint16_t> codes(count + 1, 0xABCD);
    UpdateClipStatus(status, positions.data(), count, user, true, codes.data());
    for (std::size_t i = 0; i < count; ++i) {
      const float* p = &positions[4 * i];
      const std::uint32_t code = ClipCode({p[0], p[1], p[2], p[3]}, user);
      EXPECT_EQ(codes[i], code);
      expected.clip_union |= code;
      expected.clip_intersection &= code;
    }
    EXPECT_EQ(codes[count], 0xABCD);
    EXPECT_EQ(status.clip_union, expected.clip_union);
    EXPECT_EQ(status.clip_intersection, expected.clip_intersection);
    ClipStatus without_codes;
    UpdateClipStatus(without_codes, positions.data(), count, user, true);
    EXPECT_EQ(without_codes.clip_intersection, expected.clip_intersection);
  }
}

TEST(UpdateClipStatusTest, PlanesAreDottedFromLeftToRightUnfused) {
  UserClipPlanes user;
  const float plane[4] = {1, -0x1p-24f, -1, 0};
  std::memcpy(user.planes[0], plane, sizeof plane);
  user.enable_mask = 1;
  const float position[4] = {1, 0.5f, 1, 1};
  // 1 - 2^-25 rounds to even, 1; minus 1 is 0: kept. Exactly it is -2^-25.
  EXPECT_EQ(ClipCode(position, user) & kClipPlane0, 0u);
  std::vector<float> many;
  for (int i = 0; i < 64; ++i) many.insert(many.end(), position, position + 4);
  ClipStatus status;
  UpdateClipStatus(status, many.data(), 64, user, true);
  EXPECT_EQ(status.clip_union & kClipPlane0, 0u);
}

TEST(UpdateClipStatusTest, DoesNotAllocate) {
  Vertices vertices(2);
  const UserClipPlanes user = vertices.Planes();
  const std::vector<float> positions = vertices.Positions(1000);
  const std::size_t before = AllocationCount();
  ClipStatus status;
  UpdateClipStatus(status, positions.data(), 1000, user, true);
  EXPECT_EQ(AllocationCount(), before);
}

}  // namespace
}  // namespace clipc::runtime
