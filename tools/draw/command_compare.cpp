// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <cstdio>
#include <optional>
#include <set>

#include "compiler/command/options.h"
#include "tools/draw/arguments.h"
#include "tools/draw/commands.h"
#include "tools/draw/compare_flags.h"
#include "tools/draw/draw_call.h"
#include "tools/draw/opengl/compare.h"
#include "tools/draw/opengl/domain.h"
#include "tools/draw/vulkan/compare.h"
#include "tools/harness/options.h"

namespace clipc::draw {
namespace {

using namespace ir;
using namespace harness::options;

struct CompareOptions {
  BuildOptions build;
  std::vector<std::string> targets = {"glsl450", "glsl330", "glsl130", "essl300", "vulkan"};
  std::vector<std::string> lowerings = {"clip-distance", "level9", "none"};
  RandomOptions random;
  Tolerance tolerance;
  bool all_targets = false;  // every target that can express the shader
  bool verbose = false;
  bool direct3d = false;  // only Direct3D's depth range, and not flipped
};

std::string NameOf(const std::string& lowering, const passes::ClipSpaceOptions& space) {
  return lowering + (space.negative_one_to_one ? " negative-one-to-one" : " zero-to-one") +
         (space.flip_y ? " flip-y" : "");
}

Flags FlagsOf(CompareOptions& options) {
  Flags flags = ComparisonFlags(options.build, options.random, options.tolerance);
  flags.insert({
      {"HV", With([&](auto& value) {
         options.build.language =
             Known(EnumeratorOf(value, kLanguageNames), "language version", value);
       })},
      {"target", With([&](auto& value) { options.targets = Split(value, ','); })},
      {"lower", With([&](auto& value) { options.lowerings = Split(value, ','); })},
      {"plane-space", With([&](auto& value) {
         options.build.plane_space = Known(ParsePlaneSpace(value), "plane space", value);
       })},
      {"position-input", Text(options.build.position_input)},
      {"verbose", On(options.verbose)},
      {"direct3d", On(options.direct3d)},
  });
  return flags;
}

// Adds up the comparisons of one shader.
class Runner {
 public:
  explicit Runner(CompareOptions options) : options_(std::move(options)) {}

  int Run() {
    // There is no position to lower or to move to another clip space.
    if (!Stage().has_stage_after || Stage().makes_patches) options_.lowerings = {"none"};
    if (Stage().runs_in_groups && options_.targets == CompareOptions().targets)
      options_.targets = {"glsl430", "glsl450", "essl310", "vulkan"};
    if (Stage().emits_vertices && options_.targets == CompareOptions().targets)
      options_.targets = {"glsl150", "glsl410", "glsl450", "essl320", "vulkan"};
    if ((Stage().makes_patches || Stage().reads_patches) &&
        options_.targets == CompareOptions().targets)
      options_.targets = {"glsl400", "glsl410", "glsl450", "essl310", "essl320", "vulkan"};
    for (const std::string& target : options_.targets) {
      for (const std::string& lowering : options_.lowerings) RunLowering(target, lowering);
    }
    std::printf(
        "%d comparisons of %d values each at most: %ld wrong, %ld of %ld equal to the bit, worst "
        "%.1f units\n",
        comparisons_, most_values_, sum_.wrong, sum_.equal, sum_.values - sum_.undefined,
        sum_.worst);
    for (const std::string& name : left_out_) std::printf("left out: %s\n", name.c_str());
    if (comparisons_ == 0 || (sum_.equal == 0 && sum_.wrong == 0))
      throw DrawError("nothing was compared");
    return sum_.wrong == 0 ? 0 : 1;
  }

 private:
  const StageInfo& Stage() const {
    const auto profile = ParseProfile(options_.build.profile);
    return clipc::InfoOf(profile && profile->stage ? *profile->stage : clipc::Stage::kVertex);
  }

  void RunLowering(const std::string& target, const std::string& lowering) {
    BuildOptions build = options_.build;
    build.target = target;
    build.lowering = Known(ParseLowering(lowering), "lowering", lowering);
    const std::string name = target + " " + lowering;
    for (const bool negative_one_to_one : {false, true}) {
      for (const bool flip_y : {false, true}) {
        if (options_.direct3d && (negative_one_to_one || flip_y)) continue;
        if (!Stage().has_stage_after && negative_one_to_one) continue;
        if (Stage().runs_in_groups && flip_y) continue;
        if (Stage().makes_patches && (flip_y || negative_one_to_one)) continue;
        build.clip_space = {negative_one_to_one, flip_y};
        try {
          RunOne(build, NameOf(name, build.clip_space));
        } catch (const NotForTarget& reason) {
          if (!options_.all_targets) throw;
          left_out_.insert(name);
          if (options_.verbose) std::printf("%s: %s\n", name.c_str(), reason.what());
        }
      }
    }
  }

  void RunOne(const BuildOptions& build, const std::string& name) {
    const Shader shader = Build(build);
    RandomOptions random = options_.random;
    ChooseDraw(shader, random);
    Compare(shader, build, random, name);
    random.constant_textures = true;
    if (!shader.typed.resources.empty())
      Compare(shader, build, random, name + " constant textures");
  }

  void Compare(const Shader& shader, const BuildOptions& build, const RandomOptions& random,
               const std::string& name) {
    RandomInputs inputs = MakeRandomInputs(shader.typed, random);
    if (build.target == "vulkan") inputs.lanes = Vulkan().lanes();
    if (Stage().reads_patches) inputs.points = PointsOf(OpenGl(), shader, inputs);
    const std::vector<Expected> expected = MakeExpected(shader, build, inputs);
    const Comparison found =
        Run(build.target, {shader, expected, inputs, random, options_.tolerance});
    if (options_.verbose || found.wrong > 0) {
      std::printf("%s: %ld of %ld values wrong, worst %.1f units\n", name.c_str(), found.wrong,
                  found.values, found.worst);
    }
    for (const std::string& mistake : found.mistakes) std::printf("  %s\n", mistake.c_str());
    if (options_.verbose && found.wrong > 0) std::printf("%s\n", shader.glsl.c_str());
    Add(found);
  }

  Comparison Run(const std::string& target, const Trial& trial) {
    return target == "vulkan" ? vulkan::CompareWithVulkan(Vulkan(), trial)
                              : CompareWithOpenGl(OpenGl(), trial);
  }

  vulkan::Runner& Vulkan() {
    if (!vulkan_) vulkan_.emplace();
    return *vulkan_;
  }

  harness::OpenGl& OpenGl() {
    if (!opengl_) opengl_.emplace();
    return *opengl_;
  }

  void Add(const Comparison& found) {
    ++comparisons_;
    most_values_ = std::max(most_values_, static_cast<int>(found.values));
    sum_.values += found.values;
    sum_.equal += found.equal;
    sum_.undefined += found.undefined;
    sum_.wrong += found.wrong;
    sum_.worst = std::max(sum_.worst, found.worst);
  }

  CompareOptions options_;
  std::optional<harness::OpenGl> opengl_;
  std::optional<vulkan::Runner> vulkan_;
  Comparison sum_;
  std::set<std::string> left_out_;
  int comparisons_ = 0, most_values_ = 0;
};

}  // namespace

int RunCompare(const Arguments& arguments) {
  CompareOptions options;
  options.build.path = ParseOnlyPath(arguments, FlagsOf(options));
  options.all_targets = options.targets == std::vector<std::string>{"all"};
  if (options.all_targets) {
    const auto names = glsl::Target::Names();
    options.targets.assign(names.begin(), names.end());
    // The webgl targets are for browsers; their languages are those of essl100 and essl300.
    std::erase_if(options.targets,
                  [](const std::string& target) { return target.starts_with("webgl"); });
  }
  return Runner(std::move(options)).Run();
}

}  // namespace clipc::draw
