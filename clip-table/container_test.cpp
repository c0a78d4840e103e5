// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <cstdint>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "clip-table/read.h"
#include "clip-table/test_tables.h"
#include "clip-table/write.h"

// Clip plane blocks inside compiled shaders.
namespace clipc::clip_table {
namespace {

using ::testing::HasSubstr;
using Dwords = std::vector<std::uint32_t>;

std::string Bytes(const Dwords& dwords) {
  std::string bytes;
  for (const std::uint32_t value : dwords) {
    for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<char>(value >> 8 * i));
  }
  return bytes;
}

void Append(Dwords& to, const Dwords& more) { to.insert(to.end(), more.begin(), more.end()); }

constexpr std::uint32_t kShdr = 0x52444853, kShex = 0x58454853, kIsgn = 0x4e475349;
const Dwords kClipPlanes = {0x2835, 7, 2, 0x0000'0001, 1, 0x0003'0001, 1};

// A program with instructions around the block: a declaration, another custom-data block, a return.
Dwords Program(const Dwords& block) {
  Dwords program = {0x0001'0040, 0};
  Append(program, {4u << 24 | 0x59, 0x0020'8e46, 1, 4});  // dcl_constantbuffer cb1[4]
  Append(program, {3u << 11 | 0x35, 6, 1, 2, 3, 4});      // an immediate constant buffer
  Append(program, block);
  Append(program, {1u << 24 | 0x3e});  // ret
  program[1] = static_cast<std::uint32_t>(program.size());
  return program;
}

std::string Container(std::uint32_t code, const Dwords& program) {
  const auto size = static_cast<std::uint32_t>(4 * program.size());
  Dwords file = {0x43425844, 1, 2, 3, 4, 1, 0, 2, 40, 52};
  Append(file, {kIsgn, 4, 0, code, size});
  Append(file, program);
  file[6] = static_cast<std::uint32_t>(4 * file.size());
  return Bytes(file);
}

ClipTable Expected() {
  ClipTable table;
  table.lowering = Lowering::kLevel9;
  table.enable_mask = 3;
  table.planes = {{0, "", Constant{"", 0, 1, 0, 0, 0, "", ""}},
                  {1, "", Constant{"", 0, 1, 0, 3, 48, "", ""}}};
  return table;
}

TEST(ClipTableContainer, FindsTheBlock) {
  for (const std::uint32_t code : {kShdr, kShex}) {
    const Result<ClipTable> read = Read(Container(code, Program(kClipPlanes)));
    ASSERT_TRUE(read) << read.error;
    EXPECT_EQ(*read, Expected());
  }
}

TEST(ClipTableContainer, ARecordMayMapSeveralRegisters) {
  const Result<ClipTable> read = ReadBinary(Bytes({0x2835, 7, 2, 5u << 16 | 2, 3, 9u << 16, 1}));
  ASSERT_TRUE(read) << read.error;
  ASSERT_EQ(read->planes.size(), 4u);
  EXPECT_EQ(read->planes[2].constant->float4_register, 7u);
  EXPECT_EQ(read->planes[2].constant->register_number, 2u);
  EXPECT_EQ(read->planes[3].constant->float4_register, 9u);
  EXPECT_EQ(read->enable_mask, 15u);
}

TEST(ClipTableContainer, RecordsThatCannotBe) {
  EXPECT_THAT(ReadBinary(Bytes({0x2835, 5, 1, 0, 0})).error,
              HasSubstr("record 0 at byte 12 maps 0 registers"));
  EXPECT_THAT(ReadBinary(Bytes({0x2835, 5, 1, 0, 7})).error, HasSubstr("maps 7 registers"));
  EXPECT_THAT(ReadBinary(Bytes({0x2835, 7, 2, 0, 6, 0, 1})).error,
              HasSubstr("record 1 at byte 20"));
  EXPECT_THAT(ReadBinary(Bytes({0x2835, 5, 1, 0, 0x0001'0001})).error, HasSubstr("reserved WORD"));
  EXPECT_THAT(ReadBinary(Bytes({0x2835, 5, 2, 0, 1})).error,
              HasSubstr("claims to hold 2 clip planes"));
  EXPECT_THAT(ReadBinary(Bytes({0x2835, 6, 1, 0, 1})).error,
              HasSubstr("says that it has 6 DWORDs; the file has 5"));
  EXPECT_THAT(ReadBinary(Bytes({0x2035, 5, 1, 0, 1})).error, HasSubstr("no clip plane block"));
}

TEST(ClipTableContainer, ShadersWithoutABlock) {
  EXPECT_THAT(ReadBinary(Container(kShdr, Program({}))).error,
              HasSubstr("compiled without [clipplanes]"));
  EXPECT_THAT(ReadBinary(Container(kIsgn, Program({}))).error,
              HasSubstr("neither an SHDR nor an SHEX"));
}

TEST(ClipTableContainer, BrokenContainers) {
  const std::string good = Container(kShdr, Program(kClipPlanes));
  EXPECT_THAT(ReadBinary(good.substr(0, 20)).error, HasSubstr("cut off"));
  const auto with = [&](std::size_t dword, char value) {
    std::string bytes = good;
    bytes[4 * dword] = value;
    return ReadBinary(bytes).error;
  };
  EXPECT_THAT(with(6, 4), HasSubstr("its size at byte 24 is wrong"));
  EXPECT_THAT(with(7, 99), HasSubstr("claims 99 chunks at byte 28"));
  EXPECT_THAT(with(9, 53), HasSubstr("chunk 1 of the DXBC container does not lie inside it"));
  EXPECT_THAT(with(9, 127), HasSubstr("chunk 1"));
  EXPECT_THAT(with(16, 1), HasSubstr("the shader's length at byte 64"));
  EXPECT_THAT(with(22, 99), HasSubstr("the instruction at byte 84 is longer"));
}

TEST(ClipTableContainer, DamageIsNeverACrash) {
  RandomTable random(4);
  const std::string good = Container(kShdr, Program(kClipPlanes));
  for (int i = 0; i < 50000; ++i) {
    std::string bytes = Damaged(good, random);
    if (random.Below(2) && bytes.size() > 28) {  // so that more than the size check is reached
      for (int k = 0; k < 4; ++k) bytes[24 + k] = static_cast<char>(bytes.size() >> 8 * k);
    }
    const Result<ClipTable> read = ReadBinary(bytes);
    EXPECT_TRUE(read ? ProblemOf(*read).empty() : !read.error.empty());
  }
}

}  // namespace
}  // namespace clipc::clip_table
