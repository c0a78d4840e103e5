// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <random>
#include <string>
#include <vector>

#include "tools/harness/offscreen.h"
#include "tools/harness/options.h"
#include "tools/random/run.h"

using namespace clipc;
using namespace clipc::random;

namespace {

constexpr char kUsage[] =
    R"(clipc-random [options]
  Generates random HLSL shaders without errors and undefined values, and holds what clipc makes of
  each against the reference evaluator: every target's GLSL is valid for glslang, one of OpenGL and
  the one for Vulkan are drawn by Mesa, constants lie where Direct3D's rules say.
  A failing program is made small and written to a folder with the command that repeats it.
    --seconds N             stops after that time
    --count N               stops after so many programs; default 100 where neither is given
    --seed S                of the first program; the next has the next. Default: a new one, printed
    --out FOLDER            where failures go, default random-failures
    --repeat CHOICES        judges the program of a choices.txt
    --print                 prints each program
    --stop                  stops at the first failure
    --no-draw               compiles and validates only
    --no-reduce             writes failing programs as they are
    --with A,B --without C  features of the programs:
)";

harness::options::Flags FlagsOf(RunOptions& options, bool& has_seed) {
  using namespace harness::options;
  const auto off = [](bool& flag) {
    return Flag{false, [&](const std::string&) { flag = false; }};
  };
  const auto set = [&options](const char* flag, bool on) {
    return With([&options, flag, on](const std::string& names) {
      options.features.Set(names, on);
      options.feature_flags += std::string(" ") + flag + " " + names;
    });
  };
  return {
      {"seconds",
       With([&](auto& value) { options.seconds = std::strtod(value.c_str(), nullptr); })},
      {"count", Number(options.count)},
      {"seed", With([&](auto& value) {
         options.seed = std::strtoull(value.c_str(), nullptr, 0);
         has_seed = true;
       })},
      {"out", Text(options.out)},
      {"repeat", Text(options.repeat)},
      {"print", On(options.prints)},
      {"stop", On(options.stops)},
      {"no-draw", off(options.draws)},
      {"no-reduce", off(options.reduces)},
      {"with", set("--with", true)},
      {"without", set("--without", false)},
  };
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> arguments(argv, argv + argc);
  if (arguments.size() > 1 && (arguments[1] == "--help" || arguments[1] == "-h")) {
    std::printf("%s%s", kUsage, Features::List().c_str());
    return 0;
  }
  try {
    RunOptions options;
    bool has_seed = false;
    if (!harness::options::Parse(arguments, FlagsOf(options, has_seed)).empty())
      throw harness::DrawError("clipc-random takes options alone; see --help");
    if (!has_seed) {
      options.seed = std::random_device()() % 1'000'000'000;
      std::printf("seed %llu\n", static_cast<unsigned long long>(options.seed));
      std::fflush(stdout);
    }
    if (options.count == 0 && options.seconds == 0) options.count = 100;
    return RunPrograms(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "clipc-random: %s\n", error.what());
    return 2;
  }
}
