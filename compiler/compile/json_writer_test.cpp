// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/json_writer.h"

#include <random>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace clipc {
namespace {

using Json = nlohmann::ordered_json;

std::string Dump(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string WithText(const std::string& text) {
  JsonWriter json;
  json.Object([&] { json.Member("text", text); });
  return std::move(json).Finish();
}

TEST(JsonWriter, WritesAsNlohmannDoes) {
  JsonWriter json;
  json.Object([&] {
    json.Member("text", "water");
    json.Member("flag", true);
    json.Member("number", std::uint32_t{4294967295});
    json.Member("less", -7);
    json.Null("nothing");
    json.List("none", [] {});
    json.Object("empty", [] {});
    json.List("texts", [&] {
      json.Text("a");
      json.Text("b");
    });
    json.ListOf("objects", std::vector<int>{1, 2}, [&](int number) {
      json.Member("number", number);
      json.Object("inner", [&] { json.Member("twice", 2 * number); });
    });
  });
  const Json expected = {
      {"text", "water"},
      {"flag", true},
      {"number", 4294967295},
      {"less", -7},
      {"nothing", nullptr},
      {"none", Json::array()},
      {"empty", Json::object()},
      {"texts", {"a", "b"}},
      {"objects",
       {{{"number", 1}, {"inner", {{"twice", 2}}}}, {{"number", 2}, {"inner", {{"twice", 4}}}}}}};
  EXPECT_EQ(std::move(json).Finish(), Dump(expected));
}

// Lines longer than the blanks that are copied at once, in a document longer than the first memory.
TEST(JsonWriter, WritesDeepAndLongDocuments) {
  constexpr int kDepth = 40;
  JsonWriter json;
  Json expected = {{"text", std::string(1000, 'x')}};
  const auto nest = [&](auto& self, int depth) -> void {
    json.Member("text", std::string(1000, 'x'));
    if (depth > 0) json.Object("inner", [&] { self(self, depth - 1); });
  };
  json.Object([&] { nest(nest, kDepth); });
  for (int i = 0; i < kDepth; ++i) {
    Json outer = {{"text", std::string(1000, 'x')}};
    outer["inner"] = std::move(expected);
    expected = std::move(outer);
  }
  EXPECT_EQ(std::move(json).Finish(), Dump(expected));
}

TEST(JsonWriter, EscapesAsNlohmannDoes) {
  for (int first = 0; first < 256; ++first) {
    for (int second = 0; second < 256; ++second) {
      const std::string text = {'x', static_cast<char>(first), static_cast<char>(second), 'y'};
      ASSERT_EQ(WithText(text), Dump({{"text", text}})) << first << " " << second;
    }
  }
  // Beginnings of characters of three and four bytes, whole and broken off.
  std::mt19937 random(1);
  const unsigned char bytes[] = {0xE0, 0xED, 0xEF, 0xF0, 0xF1, 0xF4, 0xC2, 0x80, 0x90,
                                 0x9F, 0xA0, 0xBF, 0xC1, 0xF5, 'a',  '"',  '\n'};
  for (int i = 0; i < 20000; ++i) {
    std::string text;
    for (unsigned length = random() % 8; length > 0; --length)
      text += static_cast<char>(bytes[random() % std::size(bytes)]);
    ASSERT_EQ(WithText(text), Dump({{"text", text}}));
  }
}

}  // namespace
}  // namespace clipc
