// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/values/run.h"

#include <algorithm>
#include <bit>
#include <iterator>
#include <optional>

#include "base/stage.h"
#include "tools/values/draw.h"
#include "tools/values/probe.h"

namespace clipc::values {
namespace {

// The stages between the vertex shader and the pixel shader.
constexpr const char* kBetween[] = {"hull", "domain", "geometry"};
constexpr char kQuadShader[] = "float4 main(float4 pos : POSITION) : SV_Position { return pos; }\n";

// What a shader section says of its shader, with its text.
struct StagedShader {
  std::string text;
  int line = 0;
  ModelMask refused = 0;  // the models at which Microsoft's compiler refuses it
  bool is_hlsl = true;
};

class Session {
 public:
  Session(const Family& family, const Listener& listener) : family_(family), listener_(listener) {
    Allow();
  }

  void Run(const std::string& text) {
    for (const Section& section : ReadSections(text)) {
      try {
        RunSection(section);
      } catch (const std::runtime_error& error) {
        listener_.on_probe({Verdict::kNotDrawn, section.header.number, error.what()});
      }
    }
  }

 private:
  // Every model of the family, until a [require] says less.
  void Allow() {
    least_ = family_.least;
    greatest_ = family_.greatest;
    options_.clear();
    missing_.clear();
  }

  void RunSection(const Section& section) {
    Scanner header(section.header.text);
    for (const char* stage : {"pixel", "vertex", "compute", "geometry", "hull", "domain"}) {
      if (!header.Take(stage)) continue;
      if (header.Take("shader")) ReadShader(stage, header, section);
      return;
    }
    if (header.Take("require")) return Require(section);
    if (header.Take("sampler")) {
      scene_.samplers[header.TakeCount()] = ReadSampler(section);
    } else if (header.Take("input")) {
      ReadLayout(section);
    } else if (header.Take("test")) {
      for (const Line& line : section.lines) {
        try {
          RunLine(line);
        } catch (const std::runtime_error& error) {
          listener_.on_probe({Verdict::kNotDrawn, line.number, error.what()});
        }
      }
    } else if (!header.Take("effect") && !header.Take("preproc") &&
               !header.Take("preproc-invalid")) {
      Set(ReadResource(section));
    }
  }

  void Require(const Section& section) {
    Allow();
    for (const Line& each : section.lines) {
      Scanner line(each.text);
      if (line.at_end()) continue;
      if (line.Take("shader")) {
        if (!line.Take("model")) throw std::runtime_error("no `model`");
        const bool is_least = line.TakeName() == ">=";
        const std::string name = line.TakeName();
        const auto* found = std::ranges::find(kModels, name);
        const auto model = static_cast<Model>(found - kModels.begin());
        is_least ? least_ = std::max(least_, model) : greatest_ = std::min(greatest_, model - 1);
      } else if (line.Take("options:")) {
        if (line.Take("row-major")) options_.push_back("-Zpr");
        if (line.Take("column-major")) options_.push_back("-Zpc");
      } else if (!line.Take("format")) {
        // A capability of the device; OpenGL on Mesa has these.
        if (!line.Take("float64") && !line.Take("int64") && !line.Take("rt-vp-array-index") &&
            !line.Take("geometry-shader") && !line.Take("tessellation-shader"))
          missing_ = "needs " + line.TakeName();
      }
    }
  }

  void ReadLayout(const Section& section) {
    scene_.elements.clear();
    for (const Line& each : section.lines) {
      Scanner line(each.text);
      if (line.at_end()) continue;
      Element& element = scene_.elements.emplace_back();
      element.slot = line.TakeCount();
      element.format = TakeFormat(line);
      element.semantic = line.TakeName();
      if (!line.at_end()) element.index = line.TakeCount();
    }
  }

  void Set(ResourceText text) {
    const std::pair key{text.role, text.slot};
    scene_.resources[key] = std::make_unique<Resource>(std::move(text));
  }

  void ReadShader(const std::string& stage, Scanner& header, const Section& section) {
    StagedShader shader{section.Text(), section.header.number};
    while (!header.at_end()) {
      // `todo` and `notimpl` are about vkd3d's compiler.
      const bool fails = header.Take("fail");
      if (!fails && !header.Take("todo") && !header.Take("notimpl")) {
        shader.is_hlsl = false;  // byte code
        break;
      }
      const Qualifier qualifier = header.TakeQualifier(least_);
      if (fails) shader.refused |= qualifier.models;
    }
    const auto* known = std::ranges::find(kStages, stage, &StageInfo::name);
    if (known != std::end(kStages)) CheckAcceptance(std::string(known->prefix), shader);
    shaders_[stage] = std::move(shader);
  }

  // Compiles the shader alone at the least model, and on both sides of each change of acceptance.
  void CheckAcceptance(const std::string& stage, const StagedShader& shader) {
    if (!shader.is_hlsl || !missing_.empty()) return;
    const auto is_refused = [&](Model model) { return (shader.refused >> model & 1) != 0; };
    for (Model model = least_; model <= greatest_; ++model) {
      const bool changes = model == least_ || is_refused(model) != is_refused(model - 1) ||
                           (model < greatest_ && is_refused(model) != is_refused(model + 1));
      if (!changes) continue;
      std::string why = compiler_.WhyRefused(shader.text, stage, model, options_);
      const bool is_accepted = why.empty();
      listener_.on_shader({shader.line, model, !is_refused(model), is_accepted, std::move(why)});
    }
  }

  void RunLine(const Line& each) {
    Scanner line(each.text);
    if (line.at_end() || least_ > greatest_) return;
    for (bool again = true; again;) {
      again = line.Take("todo") || line.Take("bug");
      if (again) line.TakeQualifier(least_);
      if (!line.Take("if")) continue;
      if (!line.TakeQualifier(least_).holds) return;
      again = true;
    }
    if (line.Take("probe")) {
      Probe probe = ProbeLine(line);
      probe.line = each.number;
      listener_.on_probe(probe);
    } else if (line.Take("draw")) {
      DrawLine(line);
    } else if (line.Take("dispatch")) {
      DispatchLine(line);
    } else if (line.Take("uniform")) {
      SetUniform(line);
    } else if (line.Take("clear rtv")) {
      SetDefaultTarget();
      const std::uint32_t slot = line.TakeCount();
      std::array<float, 4> color{};
      for (float& part : color) part = static_cast<float>(line.TakeNumber());
      if (const Resource* target = scene_.Find(Role::kTarget, slot)) target->Clear(color);
    } else if (line.Take("clear dsv")) {
      if (const Resource* target = scene_.Find(Role::kDepth, 0))
        target->Clear({static_cast<float>(line.TakeNumber())});
    } else if (line.Take("copy")) {
      const ResourceText from = TakeReference(line), to = TakeReference(line);
      Resource* source = scene_.Find(from.role, from.slot);
      Resource* target = scene_.Find(to.role, to.slot);
      if (source && target) target->CopyFrom(*source);
    } else if (line.Take("depth")) {
      scene_.depth_test = TakeComparison(line);
    } else if (line.Take("sample mask")) {
      scene_.sample_mask = line.TakeCount();
    } else if (line.Take("viewport")) {
      std::array<float, 4>& view = scene_.viewports[line.TakeCount()];
      const std::vector<double> list = line.TakeList();
      for (std::size_t i = 0; i < view.size(); ++i) view[i] = static_cast<float>(list.at(i));
    } else {
      // States of the fixed pipeline hold for the rest of the file.
      missing_ = "needs `" + each.text + "`";
    }
  }

  void SetDefaultTarget() {
    if (scene_.Find(Role::kTarget, 0) || scene_.Find(Role::kDepth, 0)) return;
    ResourceText text;
    text.role = Role::kTarget;
    text.format = FloatFormat();
    Set(std::move(text));
  }

  void SetUniform(Scanner& line) {
    const std::uint32_t first = line.TakeCount();
    const std::string type = line.TakeName();
    const bool is_float = type.starts_with("float"), is_double = type.starts_with("double");
    const bool is_long = type.find("64") != type.npos;
    std::vector<std::uint32_t> words;
    while (!line.at_end()) {
      if (is_float) {
        words.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(line.TakeNumber())));
        continue;
      }
      const std::uint64_t bits =
          is_double ? std::bit_cast<std::uint64_t>(line.TakeNumber()) : line.TakeInteger();
      words.push_back(static_cast<std::uint32_t>(bits));
      if (is_double || is_long) words.push_back(static_cast<std::uint32_t>(bits >> 32));
    }
    const std::size_t size = std::max(scene_.uniforms.size(), (first + words.size() + 3) / 4 * 4);
    scene_.uniforms.resize(size, 0x7f7f7f7f);
    std::ranges::copy(words, scene_.uniforms.begin() + first);
  }

  // Says why the next probes have no value, or runs the compute shader.
  void DispatchLine(Scanner& line) {
    no_value_ = Probe{Verdict::kNotDrawn, 0, missing_};
    const StagedShader& shader = shaders_["compute"];
    if (!shader.is_hlsl) no_value_->why = "byte code";
    if (!no_value_->why.empty()) return;
    no_value_->verdict = Verdict::kNotOffered;
    if ((shader.refused >> least_ & 1) != 0) return;
    const CompiledPair compiled = compiler_.CompileCompute(shader.text, least_, options_);
    DrawCall call;
    for (std::uint32_t& groups : call.groups) groups = line.TakeCount();
    Do(compiled, call);
  }

  // Says why the next probes have no value, or draws.
  void DrawLine(Scanner& line) {
    no_value_ = Probe{Verdict::kNotDrawn, 0, missing_};
    if (!no_value_->why.empty()) return;
    SetDefaultTarget();
    DrawCall call;
    call.is_direct3d9 = least_ < kModel4;
    if (line.Take("quad")) {
      call.half_pixel = 0.5f;
      SetQuad();
    } else {
      if (line.Take("triangle strip")) {
        call.topology = GL_TRIANGLE_STRIP;
      } else if (line.Take("point list")) {
        call.topology = GL_POINTS;
      } else if (line.Take("line list")) {
        call.topology = GL_LINES;
      } else if (!line.Take("triangle list")) {
        call.topology = GL_PATCHES;
        call.control_points = line.TakeCount();
        if (!line.Take("control point patch list")) {
          no_value_->why = "another topology";
          return;
        }
      }
      call.vertices = line.TakeCount();
      if (!line.at_end()) call.instances = line.TakeCount();
    }
    std::vector<const char*> stages = {"vertex", "pixel"};
    std::ranges::copy_if(kBetween, std::back_inserter(stages),
                         [&](const char* stage) { return !shaders_[stage].text.empty(); });
    for (const char* stage : stages) {
      const StagedShader& shader = shaders_[stage];
      if (!shader.is_hlsl) no_value_->why = "byte code";
      if ((shader.refused >> least_ & 1) != 0) no_value_->verdict = Verdict::kNotOffered;
    }
    if (!no_value_->why.empty() || no_value_->verdict == Verdict::kNotOffered) return;
    ShaderTexts texts{
        .vertex = shaders_["vertex"].text, .pixel = shaders_["pixel"].text, .options = options_};
    for (std::size_t i = 2; i < stages.size(); ++i)
      texts.between[stages[i]] = shaders_[stages[i]].text;
    if (scene_.IsMultisampled()) texts.options.push_back("--flip-y");
    if (texts != texts_ || model_ != least_) {
      pair_ = compiler_.Compile(texts, least_);
      texts_ = texts;
      model_ = least_;
    }
    Do(pair_, call);
  }

  void Do(const CompiledPair& compiled, const DrawCall& call) {
    no_value_ = Probe{Verdict::kRefused, 0, compiled.refusal};
    if (!compiled.refusal.empty()) return;
    try {
      Draw(compiled, scene_, call);
      no_value_.reset();
    } catch (const NotDrawn& error) {
      no_value_ = Probe{Verdict::kNotDrawn, 0, error.what()};
    } catch (const std::runtime_error& error) {
      no_value_->why = error.what();
    }
  }

  // A triangle that covers the target.
  void SetQuad() {
    ResourceText vertices;
    vertices.role = Role::kVertices;
    vertices.dimension = Dimension::kBuffer;
    for (const float part : {-2.0f, -2.0f, -2.0f, 4.0f, 4.0f, -2.0f})
      vertices.words.push_back(std::bit_cast<std::uint32_t>(part));
    vertices.width = 24;
    Set(std::move(vertices));
    Scanner format("r32g32-float");
    scene_.elements = {{0, TakeFormat(format), "POSITION", 0}};
    if (shaders_["vertex"].text.empty()) shaders_["vertex"].text = kQuadShader;
  }

  Probe ProbeLine(Scanner& line) {
    ResourceText place;
    place.role = Role::kTarget;
    if (line.rest().starts_with("uav") || line.rest().starts_with("rtv") ||
        line.rest().starts_with("dsv"))
      place = TakeReference(line);
    if (no_value_) return *no_value_;
    const Resource* resource = scene_.Find(place.role, place.slot);
    if (!resource) return {Verdict::kNotDrawn, 0, "no resource"};
    const std::string difference = DifferenceOf(*resource, line);
    return {difference.empty() ? Verdict::kEqual : Verdict::kDifferent, 0, difference};
  }

  const Family& family_;
  const Listener& listener_;
  Model least_ = 0, greatest_ = 0;
  std::vector<std::string> options_;
  std::string missing_;  // what the test needs and this tool does not do
  std::map<std::string, StagedShader> shaders_;
  Scene scene_;
  PairCompiler compiler_;
  ShaderTexts texts_;
  Model model_ = ~0u;
  CompiledPair pair_;
  // The verdict of probes after a draw that did not happen.
  std::optional<Probe> no_value_;
};

}  // namespace

void RunFile(const std::string& text, const Family& family, const Listener& listener) {
  Session(family, listener).Run(text);
}

}  // namespace clipc::values
