// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Speed and memory as ratios against named reference compilers, all taken in one run, each beside
// its limit.
//   clipc-bench [--slack=N] CLIPC HELLO GLSLANG_VALIDATOR [SCRATCH_FOLDER]
//                                   with --slack, each limit is N times as large: for another build
//                                   than the packaged one, on a machine that does other things too
//   clipc-bench shaders             compiles a hundred shaders, for a tool that counts instructions
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/compile/compile.h"
#include "tools/bench/corpus.h"
#include "tools/bench/generate.h"
#include "tools/bench/process.h"
#include "tools/bench/reference_compilers.h"
#include "tools/bench/report.h"
#include "tools/harness/timing.h"

namespace clipc::bench {
namespace {

void Write(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

// A copy of a program, as an installation has it: a file that a linker wrote lies in the page cache
// in smaller pieces, so that its start costs more.
std::string Installed(const std::string& program, const std::string& folder) {
  const std::string copy = folder + "/" + std::filesystem::path(program).filename().string();
  std::filesystem::copy_file(program, copy, std::filesystem::copy_options::overwrite_existing);
  return copy;
}

// Measures cold starts of whole processes.
void BenchCold(const std::string& linked_clipc, const std::string& linked_hello,
               const std::string& glslang, const std::string& folder) {
  const std::string clipc = Installed(linked_clipc, folder);
  const std::string hello = Installed(linked_hello, folder);
  const std::string hlsl = folder + "/shader.vert.hlsl", glsl = folder + "/shader.vert";
  Write(hlsl, SixtyLineShader(1));
  const std::vector<std::string> compile = {clipc, "-T", "vs_5_0", "-E", "main", hlsl, "-o", glsl};
  std::vector<std::string> validate = compile;
  validate.push_back("--validate");
  const auto cold = RunInTurn(
      {compile,
       {hello},
       {glslang, "-D", "-V", "-e", "main", "-S", "vert", hlsl, "-o", folder + "/reference.spv"}},
      100);
  std::printf(
      "| cold start: hello world %.2f ms, clipc %.2f ms, glslangValidator -D -V %.2f ms | | | |\n",
      MedianOf(cold[1], &Run::wall_ms), MedianOf(cold[0], &Run::wall_ms),
      MedianOf(cold[2], &Run::wall_ms));
  Report("cold, to a static hello world",
         MedianOf(cold[0], &Run::cpu_ms) / MedianOf(cold[1], &Run::cpu_ms), "x", 3);
  Report("cold, to glslangValidator -D -V",
         MedianOf(cold[0], &Run::wall_ms) / MedianOf(cold[2], &Run::wall_ms), "x", 0.2);
  const auto checked = RunInTurn({validate, {glslang, "-S", "vert", glsl}}, 40);
  Report("cold with --validate, to glslangValidator on the GLSL",
         MedianOf(checked[0], &Run::cpu_ms) / MedianOf(checked[1], &Run::cpu_ms), "x", 1.1);
}

constexpr unsigned kWarmShaders = 100;  // of the measurements in one process

// The requests for a hundred shaders. `text_of` gives one for each seed.
std::vector<ProgramRequest> Shaders(const char* profile, const char* entry,
                                    std::string (*text_of)(unsigned seed)) {
  std::vector<ProgramRequest> requests(kWarmShaders);
  for (unsigned i = 0; i < kWarmShaders; ++i) {
    requests[i].first().path = "shader.hlsl";
    requests[i].first().text = text_of(i);
    requests[i].first().profile = profile;
    requests[i].first().entry = entry;
  }
  return requests;
}

void CompileAll(Compiler& compiler, const std::vector<ProgramRequest>& requests) {
  for (const ProgramRequest& request : requests) {
    if (!compiler.Compile(request).ok()) std::exit(1);
  }
}

// Measures a hundred shaders in this process, with clipc and with the reference compilers in turn,
// and returns the ratio.
double WarmRatio(const char* profile, const std::vector<ProgramRequest>& requests) {
  constexpr int kRounds = 7;
  StartReferenceCompilers();
  Compiler compiler;
  std::vector<double> ours, theirs;
  for (int round = 0; round < kRounds; ++round) {
    double start = harness::ProcessSeconds();
    CompileAll(compiler, requests);
    ours.push_back(1e3 * (harness::ProcessSeconds() - start) / kWarmShaders);
    start = harness::ProcessSeconds();
    for (const ProgramRequest& request : requests) {
      if (!CompileWithReferenceCompilers(request)) std::exit(1);
    }
    theirs.push_back(1e3 * (harness::ProcessSeconds() - start) / kWarmShaders);
  }
  StopReferenceCompilers();
  std::printf(
      "| in one process, a shader of %s: clipc %.4f ms, glslang and SPIRV-Cross %.4f ms | | | |\n",
      profile, harness::Median(ours), harness::Median(theirs));
  return harness::Median(ours) / harness::Median(theirs);
}

void BenchWarm() {
  Report("in one process, to glslang + SPIRV-Cross",
         WarmRatio("vs_5_0", Shaders("vs_5_0", "main", SixtyLineShader)), "x", 1.0 / 20);
  Report("a pixel shader in one process, to glslang + SPIRV-Cross",
         WarmRatio("ps_5_0", Shaders("ps_5_0", "pixel", SixtyLinePair)), "x", 1.0 / 20);
  Report("a compute shader in one process, to glslang + SPIRV-Cross",
         WarmRatio("cs_5_0", Shaders("cs_5_0", "sum", SixtyLineGroup)), "x", 1.0 / 20);
}

// Measures a vertex shader that is written to fit a pixel shader of the same file, against the
// vertex shader alone.
void BenchPixelShader() {
  constexpr unsigned kShaders = 200;
  std::vector<double> alone, fitted;
  Compiler compiler;
  for (unsigned i = 0; i < kShaders; ++i) {
    ProgramRequest request;
    request.first().path = "shader.hlsl";
    request.first().text = SixtyLinePair(i);
    for (std::vector<double>* times : {&alone, &fitted}) {
      if (times == &fitted)
        request.neighbour = {request.first().path, request.first().text, "pixel"};
      const double start = harness::ProcessSeconds();
      if (!compiler.Compile(request).ok()) std::exit(1);
      times->push_back(harness::ProcessSeconds() - start);
    }
  }
  Report("with a pixel shader in HLSL, to without",
         harness::Median(fitted) / harness::Median(alone), "x", 2);
}

// Measures HLSL with clip distances against the GLSL of the same shader.
void BenchRewrite() {
  constexpr unsigned kShaders = 200;
  std::vector<double> glsl, hlsl;
  Compiler compiler;
  for (unsigned i = 0; i < kShaders; ++i) {
    ProgramRequest request;
    request.first().path = "shader.hlsl";
    request.first().text = SixtyLineShader(i);
    for (std::vector<double>* times : {&glsl, &hlsl}) {
      request.hlsl.wanted = times == &hlsl;
      const double start = harness::ProcessSeconds();
      if (!compiler.Compile(request).ok()) std::exit(1);
      times->push_back(harness::ProcessSeconds() - start);
    }
  }
  Report("--target=hlsl, to GLSL of the same shader", harness::Median(hlsl) / harness::Median(glsl),
         "x", 1.2);
}

// Measures an effect against its different shaders, each compiled once, in one process too.
void BenchEffect(const std::string& clipc, const std::string& folder) {
  const std::string effect = folder + "/fifty.fx", manifest = folder + "/shaders.json";
  Write(effect, FiftyPasses());
  const auto shaders = [&](const std::string& name, const std::string& profile, int count) {
    std::string entries;
    for (int i = 0; i < count; ++i)
      entries += (i == 0 ? "\"" : ", \"") + name + std::to_string(i) + "\"";
    return "{\"source\": \"" + effect + "\", \"name\": \"" + name + "\", \"profile\": \"" +
           profile + "\", \"entry\": [" + entries + "]}";
  };
  Write(manifest, "{\"version\": 1, \"shaders\": [" +
                      shaders("VS", "vs_3_0", kEffectVertexShaders) + ", " +
                      shaders("PS", "ps_3_0", kEffectPixelShaders) + "]}");
  const auto runs =
      RunInTurn({{clipc, "--effect", effect, "-o", folder, "--target=glsl330", "-j", "1"},
                 {clipc, "--batch=" + manifest, "-o", folder, "--target=glsl330", "-j", "1"}},
                20);
  Report("an effect with 50 passes, to its 15 shaders",
         MedianOf(runs[0], &Run::cpu_ms) / MedianOf(runs[1], &Run::cpu_ms), "x", 1.2);
}

void BenchBatchValidation() {
  std::vector<double> plain, validated;
  Compiler compiler;
  for (unsigned i = 0; i < kWarmShaders + 1; ++i) {
    ProgramRequest request;
    request.first().path = "shader.hlsl";
    request.first().text = SixtyLineShader(i);
    for (std::vector<double>* times : {&plain, &validated}) {
      request.outputs.validate = times == &validated;
      const double start = harness::ProcessSeconds();
      if (!compiler.Compile(request).ok()) std::exit(1);
      // The first shader builds glslang's symbol tables.
      if (i > 0) times->push_back(1e3 * (harness::ProcessSeconds() - start));
    }
  }
  Report("validation of one shader in a batch", harness::Median(validated) - harness::Median(plain),
         "ms", 2);
}

// Measures text that makes the parser look far ahead, as the end of each statement decides its
// meaning.
void BenchLookahead(const std::string& clipc, const std::string& folder) {
  for (const char* statement : {"x = a < b < c; ", "f(a < b, c > (d)); ", "x = (y)(z); ",
                                "a::b::c::d e; ", "A<B<C<D>>> e; ", "if (a) b = 1; else c = 2; "}) {
    const auto per_byte = [&](std::size_t bytes) {
      std::string text = "void f() {";
      while (text.size() < bytes) text += statement;
      Write(folder + "/ahead.hlsl", text + "}");
      const auto runs = RunInTurn({{clipc, "--dump=ast", folder + "/ahead.hlsl"}}, 5)[0];
      return MedianOf(runs, &Run::cpu_ms) / static_cast<double>(bytes);
    };
    const double small = per_byte(200'000);
    const std::string what =
        std::string("parsing `") + statement + "`, a byte at 2 MB to one at 200 kB";
    Report(what.c_str(), per_byte(2'000'000) / small, "x", 1.5);
  }
}

// Measures texts that repeat one thing. A search for each among all the others would cost ten times
// as much a byte where the text is ten times as long. `@` stands for the number of the repetition.
void BenchMany(const std::string& clipc, const std::string& folder) {
  struct Kind {
    const char *what, *declaration, *statement;
  };
  for (const Kind& kind : {
           Kind{"constant buffers", "cbuffer B@ { float c@; };\n", "a += c@;\n"},
           Kind{"textures", "Texture2D t@;\n", "a += t@.Load(0).x;\n"},
           Kind{"padded members", "cbuffer P@ { float c@ : packoffset(c1.y); };\n", "a += c@;\n"},
           Kind{"methods outside of structs",
                "struct S@ { float f(float x); };\nfloat S@::f(float x) { return x; }\n",
                "S@ s@; a = s@.f(a);\n"},
           Kind{"temporaries", "", "a = Next(a) > 1 && Next(a) > 2 ? a : Next(a);\n"},
       }) {
    const auto per_byte = [&](std::size_t bytes) {
      std::string declarations, statements;
      for (int i = 0; declarations.size() + statements.size() < bytes; ++i) {
        declarations += Numbered(kind.declaration, i);
        statements += Numbered(kind.statement, i);
      }
      std::string text = "float Next(inout float x) { return x += 1; }\n";
      text += declarations;
      text += "float4 main(float4 p : POSITION) : SV_Position {\nfloat a = p.x;\n";
      text += statements;
      text += "return p * a;\n}\n";
      Write(folder + "/many.hlsl", text);
      const auto runs = RunInTurn({{clipc, "-T", "vs_5_1", "--target=glsl330", "--no-validate",
                                    folder + "/many.hlsl", "-o", folder + "/many.vert"}},
                                  5)[0];
      return MedianOf(runs, &Run::cpu_ms) / static_cast<double>(bytes);
    };
    const double small = per_byte(200'000);
    const std::string what = std::string("many ") + kind.what + ", a byte at 2 MB to one at 200 kB";
    Report(what.c_str(), per_byte(2'000'000) / small, "x", 3);
  }
}

// Measures 10 kB to 10 MB of the same kind of text: processor time and peak memory of a whole
// process. It must run first, with the small texts before the large ones: Linux starts a process
// with the peak memory of the one that starts it.
void BenchScaling(const std::string& clipc, const std::string& folder) {
  const std::size_t sizes[] = {10'000, 100'000, 1'000'000, 10'000'000};
  std::vector<double> per_byte;
  double worst_memory = 0;
  for (std::size_t size : sizes) {
    const std::string hlsl = folder + "/large.hlsl";
    const std::string text = LargeShader(size);
    Write(hlsl, text);
    const auto bytes = static_cast<double>(text.size());
    const auto runs = RunInTurn({{clipc, "-T", "vs_5_0", hlsl, "-o", folder + "/large.vert"}},
                                size > 5'000'000 ? 3 : 9)[0];
    const double peak = 1024.0 * static_cast<double>(runs[0].peak_kib);
    per_byte.push_back(MedianOf(runs, &Run::cpu_ms) / bytes);
    worst_memory = std::max(worst_memory, (peak - 8.0 * 1024 * 1024) / bytes);
    std::printf("| %.0f bytes: %.2f ms, %.1f ns a byte, peak %.1f MiB | | | |\n", bytes,
                MedianOf(runs, &Run::cpu_ms), 1e6 * MedianOf(runs, &Run::cpu_ms) / bytes,
                peak / 1024 / 1024);
  }
  // The smallest size is all start-up; the others show the growth.
  Report("cost a byte at 10 MB, to that at 100 kB", per_byte[3] / per_byte[1], "x", 1.5);
  Report("cost a byte at 10 MB, to that at 1 MB", per_byte[3] / per_byte[2], "x", 1.5);
  Report("peak memory beyond 8 MiB", worst_memory, "bytes a byte", 40);
}

}  // namespace
}  // namespace clipc::bench

int main(int argc, char** argv) {
  if (argc == 3 && std::string_view(argv[1]) == "corpus") {
    clipc::bench::BenchCorpus(argv[2]);
    return 0;
  }
  if (argc == 2 && std::string_view(argv[1]) == "shaders") {
    using namespace clipc::bench;
    clipc::Compiler compiler;
    CompileAll(compiler, Shaders("vs_5_0", "main", SixtyLineShader));
    return 0;
  }
  if (argc > 1 && std::sscanf(argv[1], "--slack=%lf", &clipc::bench::g_slack) == 1) --argc, ++argv;
  if (argc < 4) {
    std::fprintf(
        stderr,
        "usage: clipc-bench [--slack=N] CLIPC HELLO GLSLANG_VALIDATOR [SCRATCH_FOLDER]\n       "
        "clipc-bench corpus LIST\n       clipc-bench shaders\n");
    return 2;
  }
  const std::string folder = argc > 4 ? argv[4] : "/tmp";
  std::printf("| what | measured | limit | |\n|---|---|---|---|\n");
  clipc::bench::BenchScaling(argv[1], folder);
  clipc::bench::BenchLookahead(argv[1], folder);
  clipc::bench::BenchMany(argv[1], folder);
  clipc::bench::BenchCold(argv[1], argv[2], argv[3], folder);
  clipc::bench::BenchWarm();
  clipc::bench::BenchPixelShader();
  clipc::bench::BenchRewrite();
  clipc::bench::BenchEffect(argv[1], folder);
  clipc::bench::BenchBatchValidation();
  std::printf("\nlimits missed: %d\n", clipc::bench::g_missed);
  return clipc::bench::g_missed != 0;
}
