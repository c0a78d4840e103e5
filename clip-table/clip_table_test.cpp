// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "clip-table/clip_table.h"

#include <fstream>
#include <iterator>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "clip-table/read.h"
#include "clip-table/test_tables.h"
#include "clip-table/write.h"
#include "testdata/table/inputs/two_planes.clip.h"

namespace clipc::clip_table {
namespace {

using ::testing::HasSubstr;

std::string FileText(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  return {std::istreambuf_iterator<char>(file), {}};
}

// The feature-level-9 document's own case: two planes in a cbuffer.
ClipTable TwoPlanes() {
  ClipTable table;
  table.entry = "main";
  table.profile = "vs_4_0_level_9_1";
  table.lowering = Lowering::kLevel9;
  table.enable_mask = 3;
  table.planes = {
      {0, "water_plane", Constant{"ClipPlanes", 0, 1, 0, 0, 0, "ClipPlanes", "water_plane"}},
      {1, "planes[2]", Constant{"ClipPlanes", 0, 1, 0, 3, 48, "ClipPlanes", "planes[2]"}},
  };
  return table;
}

TEST(ClipTable, WritesJson) {
  EXPECT_EQ(*WriteJson(TwoPlanes()), FileText("testdata/table/inputs/two_planes.json"));
}

void ExpectKeys(const nlohmann::json& json, const nlohmann::json& schema) {
  std::set<std::string> written, required;
  for (const auto& [key, value] : json.items()) written.insert(key);
  for (const auto& key : schema["required"]) required.insert(key.get<std::string>());
  EXPECT_EQ(written, required);
  EXPECT_EQ(written.size(), schema["properties"].size());
}

TEST(ClipTable, SchemaListsWhatIsWritten) {
  const auto schema = nlohmann::json::parse(FileText("docs/clip-table.schema.json"));
  const auto json = nlohmann::json::parse(*WriteJson(TwoPlanes()));
  ExpectKeys(json, schema);
  ExpectKeys(json["planes"][0], schema["$defs"]["plane"]);
  ExpectKeys(json["planes"][0]["constant"], schema["$defs"]["constant"]);
  EXPECT_EQ(schema["properties"]["schema"]["const"], json["schema"]);
  EXPECT_EQ(schema["properties"]["version"]["const"], json["version"]);
}

TEST(ClipTable, WritesDirect3DsRecord) {
  const unsigned char expected[] = {
      0x35, 0x28, 0, 0, 7, 0, 0, 0, 2, 0, 0, 0,  // opcode and class, length, planes
      1,    0,    0, 0, 1, 0, 0, 0,              // cb1[0]
      1,    0,    3, 0, 1, 0, 0, 0,              // cb1[3]
  };
  EXPECT_EQ(*WriteBinary(TwoPlanes()), std::string(std::begin(expected), std::end(expected)));
}

TEST(ClipTable, WritesHeader) {
  EXPECT_EQ(*WriteHeader(TwoPlanes(), "two_planes_clip_table"),
            FileText("testdata/table/inputs/two_planes.clip.h"));
}

TEST(ClipTable, HeaderHoldsTheTable) {
  static_assert(two_planes_clip_table.enable_mask == 3 && two_planes_clip_table.plane_count == 2);
  static_assert(two_planes_clip_table.planes[1].byte_offset == 48);
  EXPECT_EQ(*FromStatic(two_planes_clip_table), TwoPlanes());
}

TEST(ClipTable, HeaderBringsTheRuntimesTypes) {
  const std::string types = FileText("clip-table/static_table.h");
  const std::size_t begin = types.find("#ifndef CLIPC"), end = types.find("// clang-format on");
  EXPECT_THAT(*WriteHeader(TwoPlanes(), "x"), HasSubstr(types.substr(begin, end - begin)));
}

TEST(ClipTable, HeaderNames) {
  EXPECT_EQ(HeaderNameOf("out/water.clip.h"), "water_clip_table");
  EXPECT_EQ(HeaderNameOf("C:\\out\\9-lives.h"), "table_9_lives_clip_table");
  EXPECT_EQ(HeaderNameOf("a--b_.hpp"), "a_b_clip_table");
  EXPECT_EQ(HeaderNameOf("__x.h"), "table_x_clip_table");
  EXPECT_FALSE(WriteHeader(TwoPlanes(), "a b"));
  EXPECT_FALSE(WriteHeader(TwoPlanes(), ""));
  EXPECT_FALSE(WriteHeader(TwoPlanes(), "7"));
}

TEST(ClipTable, FormatByExtension) {
  EXPECT_EQ(FormatOf("a.json"), Format::kJson);
  EXPECT_EQ(FormatOf("a.bin"), Format::kBinary);
  EXPECT_EQ(FormatOf("a.clip.h"), Format::kHeader);
  EXPECT_EQ(FormatOf("a.glsl"), std::nullopt);
}

TEST(ClipTable, EveryFormReadsBack) {
  RandomTable random(1);
  for (int i = 0; i < 600; ++i) {
    const ClipTable table = random.Next();
    ASSERT_EQ(ProblemOf(table), "");
    const Result<ClipTable> json = Read(*WriteJson(table));
    ASSERT_TRUE(json) << json.error;
    EXPECT_EQ(*json, table);
    if (const Result<std::string> bytes = WriteBinary(table)) {
      const Result<ClipTable> binary = Read(*bytes);
      ASSERT_TRUE(binary) << binary.error;
      EXPECT_EQ(*binary, Direct3DPart(table));
    }
  }
}

TEST(ClipTable, TextThatIsNoUtf8IsReplaced) {
  ClipTable table = TwoPlanes();
  table.planes[0].text = "p\xff";
  EXPECT_EQ(ReadJson(*WriteJson(table))->planes[0].text, "p\xef\xbf\xbd");
  EXPECT_THAT(*WriteHeader(table, "t"), HasSubstr(R"({0u, "p\357\277\275", true,)"));
}

TEST(ClipTable, BinaryRefusesWhatItCannotSay) {
  ClipTable space = TwoPlanes();
  space.planes[0].constant->register_space = 1;
  EXPECT_THAT(WriteBinary(space).error, HasSubstr("plane 0 lies in a register"));
  ClipTable composed = TwoPlanes();
  composed.lowering = Lowering::kClipDistance;
  composed.planes[1].constant.reset();
  EXPECT_THAT(WriteBinary(composed).error, HasSubstr("plane 1 is not one whole register"));
}

TEST(ClipTable, SpacesOtherThanClip) {
  ClipTable table = TwoPlanes();
  table.lowering = Lowering::kClipDistance;
  for (const PlaneSpace space : {PlaneSpace::kXyw1, PlaneSpace::kObject}) {
    table.plane_space = space;
    EXPECT_EQ(ReadJson(*WriteJson(table))->plane_space, space);
    EXPECT_THAT(*WriteHeader(table, "t"), HasSubstr(TableNameOf(space)));
    EXPECT_THAT(WriteBinary(table).error, HasSubstr("holds planes in clip space only"));
  }
  table.lowering = Lowering::kLevel9;
  EXPECT_EQ(ProblemOf(table),
            "planes in space object with lowering level9, which supports planes in clip space "
            "only");
  EXPECT_FALSE(WriteJson(table));
}

TEST(ClipTable, WritersRefuseContradictions) {
  ClipTable table = TwoPlanes();
  table.enable_mask = 1;
  EXPECT_THAT(WriteJson(table).error, HasSubstr("enable mask 1"));
  table = TwoPlanes();
  table.planes[1].index = 0;
  EXPECT_THAT(WriteHeader(table, "t").error, HasSubstr("plane 1 says that it is operand 0"));
  table = TwoPlanes();
  table.planes[1].constant->byte_offset = 47;
  EXPECT_THAT(WriteBinary(table).error, HasSubstr("byte offset 47"));
}

// ---- damaged files

// A damaged text may still be a good table (a letter of a name changed); then it must say exactly
// what it reads.
TEST(ClipTable, DamageIsNeverACrash) {
  RandomTable random(2);
  int errors = 0;
  for (int i = 0; i < 6000; ++i) {
    const ClipTable table = random.Next();
    const Format format = static_cast<Format>(random.Below(3));
    const Result<std::string> bytes = Write(table, format, "t.h");
    if (!bytes) continue;
    const Result<ClipTable> read = Read(Damaged(*bytes, random));
    EXPECT_NE(read.value.has_value(), !read.error.empty());
    if (!read) {
      ++errors;
      continue;
    }
    EXPECT_EQ(ProblemOf(*read), "");
    EXPECT_TRUE(format != Format::kHeader || *read == table) << "a changed header was believed";
  }
  EXPECT_GT(errors, 2400);
}

TEST(ClipTable, EveryTruncationOfTheBinaryIsAnError) {
  const std::string bytes = *WriteBinary(TwoPlanes());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(ReadBinary(bytes.substr(0, size))) << size;
  }
}

std::string JsonError(const char* pointer, const nlohmann::json& value) {
  nlohmann::json json = nlohmann::json::parse(*WriteJson(TwoPlanes()));
  json[nlohmann::json::json_pointer(pointer)] = value;
  return ReadJson(json.dump()).error;
}

TEST(ClipTable, JsonErrorsNameThePlace) {
  EXPECT_EQ(JsonError("/schema", "other"), "`schema` is \"other\"; this is not a clip table");
  EXPECT_EQ(JsonError("/version", 2), "`version` is 2; this clipc reads version 1");
  EXPECT_EQ(JsonError("/lowering", "magic"),
            "`lowering` is \"magic\", which this clipc does not know");
  EXPECT_EQ(JsonError("/planes/1/constant/register", -1),
            "`planes[1].constant.register` is not an integer from 0 to 4294967295");
  EXPECT_EQ(JsonError("/planes/1/constant/register", 1.5),
            "`planes[1].constant.register` is not an integer from 0 to 4294967295");
  EXPECT_EQ(JsonError("/planes/0/text", 5), "`planes[0].text` is not a string");
  EXPECT_EQ(JsonError("/planes/0", 5), "`planes[0]` is not an object");
  EXPECT_EQ(JsonError("/planes", 5), "`planes` is not an array");
  EXPECT_EQ(JsonError("/planes/0/more", 5), "`planes[0]` has a key that this clipc does not know");
  EXPECT_EQ(JsonError("/enable_mask", 7), "enable mask 7 for 2 planes; it must be 3");
  EXPECT_EQ(JsonError("/planes/0/constant", nullptr),
            "plane 0 is not one whole register; Direct3D 9 accepts only whole registers");
  EXPECT_EQ(ReadJson("{}").error, "`schema` is missing");
  EXPECT_EQ(ReadJson("[]").error, "the table is not an object");
  EXPECT_EQ(ReadJson("{\"schema\": ").error, "the JSON is cut off: it ends after 11 bytes");
  EXPECT_EQ(ReadJson("").error, "there is no JSON: the text is empty");
  EXPECT_EQ(ReadJson("{\"schema\" 1").error, "no JSON: byte 11 cannot stand there");
  std::string repeated = *WriteJson(TwoPlanes());
  repeated.insert(1, "\"entry\": \"x\",");
  EXPECT_EQ(ReadJson(repeated).error, "a key occurs twice in one object");
}

TEST(ClipTable, DeepOrLongJsonIsAnError) {
  EXPECT_FALSE(ReadJson(std::string(1 << 17, '[')));
  EXPECT_FALSE(ReadJson(std::string(1 << 17, '[') + std::string(1 << 17, ']')));
  std::string keys = "{\"schema\":1";
  for (int i = 0; i < 100000; ++i) keys += ",\"" + std::to_string(i) + "\":0";
  EXPECT_FALSE(ReadJson(keys + "}"));
}

}  // namespace
}  // namespace clipc::clip_table
