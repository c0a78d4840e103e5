// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/table.h"

#include <cstdint>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "clip-table/test_tables.h"
#include "clip-table/write.h"

namespace clipc::runtime {
namespace {

using ::testing::HasSubstr;

Result<Table> Read(const std::string& bytes) { return ReadTable(bytes.data(), bytes.size()); }

// A DXBC container as fxc wraps a shader: it has one SHDR chunk, which holds the block between two
// instructions.
std::string Container(const std::string& block) {
  const auto dword = [](std::uint32_t value) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<char>(value >> 8 * i));
    return bytes;
  };
  const std::string body = dword(4u << 24 | 0x59) + dword(0x208e46) + dword(0) + dword(4) + block +
                           dword(1u << 24 | 0x3e);
  const std::string program =
      dword(0x1'0040) + dword(static_cast<std::uint32_t>(body.size() / 4 + 2)) + body;
  const std::string chunk = "SHDR" + dword(static_cast<std::uint32_t>(program.size())) + program;
  return "DXBC" + std::string(16, '\0') + dword(1) +
         dword(static_cast<std::uint32_t>(36 + chunk.size())) + dword(1) + dword(36) + chunk;
}

// Two planes of feature level 9, the second in another buffer.
clip_table::ClipTable Written() {
  clip_table::ClipTable table;
  table.entry = "main";
  table.profile = "vs_4_0_level_9_1";
  table.lowering = Lowering::kLevel9;
  table.enable_mask = 3;
  table.planes = {
      {0, "water", clip_table::Constant{"Clip", 0, 1, 0, 2, 32, "Clip", "water"}},
      {1, "portal[1]", clip_table::Constant{"$Globals", 0, 0, 0, 5, 80, "", "portal[1]"}}};
  return table;
}

void ExpectRegisters(const Result<Table>& table) {
  ASSERT_TRUE(table.ok()) << table.status.message();
  EXPECT_EQ(table.value.lowering, Lowering::kLevel9);
  EXPECT_EQ(table.value.enable_mask, 3u);
  ASSERT_EQ(table.value.planes.size(), 2u);
  EXPECT_TRUE(table.value.planes[0].in_register);
  EXPECT_EQ(table.value.planes[0].register_number, 1u);
  EXPECT_EQ(table.value.planes[0].byte_offset, 32u);
  EXPECT_EQ(table.value.planes[1].register_number, 0u);
  EXPECT_EQ(table.value.planes[1].byte_offset, 80u);
}

void ExpectNames(const Result<Table>& table) {
  ASSERT_EQ(table.value.planes.size(), 2u);
  EXPECT_EQ(table.value.entry, "main");
  EXPECT_EQ(table.value.profile, "vs_4_0_level_9_1");
  EXPECT_EQ(table.value.planes[1].text, "portal[1]");
  EXPECT_EQ(table.value.planes[1].cbuffer, "$Globals");
  EXPECT_EQ(table.value.planes[0].glsl_block, "Clip");
  EXPECT_EQ(table.value.planes[0].glsl_member, "water");
}

TEST(ReadTableTest, Json) {
  const Result<Table> table = Read(*clip_table::WriteJson(Written()));
  ExpectRegisters(table);
  ExpectNames(table);
}

TEST(ReadTableTest, Binary) { ExpectRegisters(Read(*clip_table::WriteBinary(Written()))); }

TEST(ReadTableTest, InsideACompiledShader) {
  ExpectRegisters(Read(Container(*clip_table::WriteBinary(Written()))));
}

TEST(ReadTableTest, CompiledIntoTheApplication) {
  static constexpr StaticClipTable kTable = {
      "main",
      "vs_4_0_level_9_1",
      "level9",
      "direct3d-clip",
      3,
      2,
      {{0, "water", true, "Clip", 0, 1, 0, 2, 32, "Clip", "water"},
       {1, "portal[1]", true, "$Globals", 0, 0, 0, 5, 80, "", "portal[1]"}}};
  const Result<Table> table = ReadTable(kTable);
  ExpectRegisters(table);
  ExpectNames(table);
}

TEST(ReadTableTest, PlanesThatAreComposed) {
  clip_table::ClipTable written;
  written.enable_mask = 1;
  written.planes = {{0, "float4(a, b)", std::nullopt}};
  const Result<Table> table = Read(*clip_table::WriteJson(written));
  ASSERT_TRUE(table.ok());
  EXPECT_EQ(table.value.lowering, Lowering::kClipDistance);
  EXPECT_FALSE(table.value.planes[0].in_register);
}

TEST(ReadTableTest, PlaneSpaces) {
  EXPECT_EQ(Read(*clip_table::WriteJson(Written())).value.plane_space, PlaneSpace::kClip);
  clip_table::ClipTable written = Written();
  written.lowering = Lowering::kDiscard;
  written.enable_mask = 0;
  for (const PlaneSpace space : {PlaneSpace::kXyw1, PlaneSpace::kObject}) {
    written.plane_space = space;
    EXPECT_EQ(Read(*clip_table::WriteJson(written)).value.plane_space, space);
  }
}

TEST(ReadTableTest, DamageIsNamed) {
  const auto expect = [](const std::string& bytes, const char* what) {
    const Result<Table> table = Read(bytes);
    EXPECT_EQ(table.status.error(), Error::kDamagedTable) << bytes;
    EXPECT_THAT(table.status.message(), HasSubstr(what));
  };
  std::string json = *clip_table::WriteJson(Written());
  expect("", "no JSON");
  expect(json.substr(0, json.size() / 2), "the JSON is cut off");
  expect(json.replace(json.find("level9"), 6, "level8"), "`lowering` is \"level8\"");
  std::string binary = *clip_table::WriteBinary(Written());
  expect(binary.substr(0, 24), "the file has 6");
  expect(Container(""), "no clip plane block");
  expect(Container(binary).substr(0, 60), "cut off");
}

TEST(ReadTableTest, StaticTablesThatNobodyWrote) {
  const StaticClipTable zero = {};
  EXPECT_EQ(ReadTable(zero).status.error(), Error::kDamagedTable);
  const StaticClipTable unnamed = {"", "", "level9", "direct3d-clip", 1, 1, {}};
  EXPECT_THAT(ReadTable(unnamed).status.message(), HasSubstr("null pointer"));
  const StaticClipTable many = {"", "", "level9", "direct3d-clip", 255, 8, {}};
  EXPECT_EQ(ReadTable(many).status.error(), Error::kDamagedTable);
}

TEST(ReadTableTest, NullPointer) {
  EXPECT_EQ(ReadTable(nullptr, 4).status.error(), Error::kInvalidArgument);
}

// Whatever the bytes are: a table that keeps its promises, or a message.
TEST(ReadTableTest, DamageIsNeverACrash) {
  clip_table::RandomTable random(7);
  for (int i = 0; i < 4000; ++i) {
    const std::string forms[] = {
        *clip_table::WriteJson(random.Next()), *clip_table::WriteHeader(random.Next(), "t"),
        *clip_table::WriteBinary(Written()), Container(*clip_table::WriteBinary(Written()))};
    const Result<Table> table = Read(clip_table::Damaged(forms[i % 4], random));
    if (!table.ok()) {
      EXPECT_STRNE(table.status.message(), "");
      continue;
    }
    ASSERT_LE(table.value.planes.size(), kMaxClipPlanes);
    const bool device_clips = table.value.lowering == Lowering::kClipDistance ||
                              table.value.lowering == Lowering::kLevel9;
    const std::uint32_t mask = device_clips ? (1u << table.value.planes.size()) - 1 : 0;
    EXPECT_EQ(table.value.enable_mask, mask);
  }
}

}  // namespace
}  // namespace clipc::runtime
