// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <array>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "ir/evaluate.h"
#include "tools/draw/build.h"
#include "tools/draw/random_inputs.h"

// Functions of waves that no software driver has, and waves of another size.
namespace clipc::draw {
namespace {

using Four = std::array<std::uint32_t, 4>;

// What the threads of a group store in the only buffer of the shader, four words each. A wave has
// so many lanes.
std::vector<Four> Stored(const std::string& text, std::uint32_t lanes) {
  const std::string path = testing::TempDir() + "/waves.hlsl";
  std::ofstream(path) << text;
  BuildOptions options;
  options.path = path;
  options.profile = "cs_6_5";
  const CheckedShader shader(options);
  const ir::Program& program = shader.typed();
  const RandomInputs inputs = MakeRandomInputs(program, {});
  Buffers buffers = inputs.buffers;
  ir::EvalInputs of_thread;
  of_thread.read_object = [&](const ir::ObjectRequest& request, std::span<std::uint64_t> result) {
    inputs.UseObject(program, buffers, request, 0, result);
  };
  const ir::GroupResult result = ir::RunGroup(program, of_thread, {.lanes = lanes});
  EXPECT_TRUE(result) << result.error;
  const auto& size = program.group_size;
  std::vector<Four> stored(std::size_t{size[0]} * size[1] * size[2]);
  std::memcpy(stored.data(), buffers.begin()->second.at(0).data(), stored.size() * sizeof(Four));
  return stored;
}

TEST(Waves, LanesOfEqualValuesAreSummedApart) {
  const std::vector<Four> stored = Stored(R"(
RWStructuredBuffer<uint4> words;
[numthreads(6, 1, 1)]
void main(uint i : SV_GroupIndex) {
  const uint4 same = WaveMatch(i % 2);
  words[i] = uint4(same.x, WaveMultiPrefixSum(i + 1, same), WaveMultiPrefixCountBits(i != 1, same),
                   WaveGetLaneIndex() + 10 * WaveGetLaneCount());
}
)",
                                          4);
  const std::vector<Four> expected = {{5, 0, 0, 40},  {10, 0, 0, 41}, {5, 1, 1, 42},
                                      {10, 2, 0, 43}, {1, 0, 0, 40},  {2, 0, 0, 41}};
  EXPECT_EQ(stored, expected);
}

TEST(Waves, NoLaneBeforeTheFirstGivesTheNeutralValue) {
  const std::vector<Four> stored = Stored(R"(
RWStructuredBuffer<uint4> words;
[numthreads(2, 1, 1)]
void main(uint i : SV_GroupIndex) {
  const uint4 all = WaveActiveBallot(true);
  words[i] = uint4(WaveMultiPrefixBitAnd(i + 6, all), WaveMultiPrefixBitOr(i + 6, all), WaveMultiPrefixBitXor(i + 6, all),
                   WaveMultiPrefixProduct(i + 6, all));
}
)",
                                          64);
  const std::vector<Four> expected = {{~0u, 0, 0, 1}, {6, 6, 6, 6}};
  EXPECT_EQ(stored, expected);
}

}  // namespace
}  // namespace clipc::draw
