// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <filesystem>
#include <fstream>

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include "clip-table/read.h"
#include "clip-table/test_tables.h"
#include "clip-table/write.h"

// The header that WriteHeader writes is C++17 that compiles alone, without a warning, and means the
// table it was written from.
namespace clipc::clip_table {
namespace {

class HeaderCompile : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = std::filesystem::temp_directory_path() / "clip-table-XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  int Compile() const {
    const std::string at = "cd '" + folder_.string() + "' && ";
    return std::system(
        (at +
         "c++ -std=c++17 -Wall -Wextra -Wpedantic -Werror -shared -fPIC tables.cpp -o tables.so")
            .c_str());
  }

  std::filesystem::path folder_;
};

TEST_F(HeaderCompile, MeansItsTable) {
  constexpr int kTables = 24;
  RandomTable random(3);
  std::vector<ClipTable> tables;
  std::string list;
  std::ofstream source(folder_ / "tables.cpp");
  for (int i = 0; i < kTables; ++i) {
    const std::string name = "table" + std::to_string(i);
    tables.push_back(random.Next());
    std::ofstream(folder_ / (name + ".h")) << *WriteHeader(tables.back(), name);
    source << "#include \"" << name << ".h\"\n";
    list += "&" + name + ", ";
  }
  source << "extern \"C\" const clipc::StaticClipTable* const tables[] = {" << list << "};\n";
  source.close();
  ASSERT_EQ(Compile(), 0);

  void* const library = dlopen((folder_ / "tables.so").c_str(), RTLD_NOW);
  ASSERT_NE(library, nullptr) << dlerror();
  const auto* const compiled = static_cast<const StaticClipTable* const*>(dlsym(library, "tables"));
  ASSERT_NE(compiled, nullptr);
  for (int i = 0; i < kTables; ++i) EXPECT_EQ(*FromStatic(*compiled[i]), tables[i]) << i;
  dlclose(library);
}

}  // namespace
}  // namespace clipc::clip_table
