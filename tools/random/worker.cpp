// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/random/worker.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tools/harness/offscreen.h"
#include "tools/harness/options.h"

namespace clipc::random {
namespace {

constexpr int kRunsOfProcess = 400;
constexpr int kPatience = 30'000;  // milliseconds

// Messages between the processes are a length and that many bytes.
void Send(int file, const std::string& bytes) {
  const auto size = static_cast<std::uint32_t>(bytes.size());
  std::string all(reinterpret_cast<const char*>(&size), sizeof size);
  all += bytes;
  for (std::size_t sent = 0; sent < all.size();) {
    const ssize_t count = write(file, all.data() + sent, all.size() - sent);
    if (count <= 0) return;
    sent += static_cast<std::size_t>(count);
  }
}

enum class Got : std::uint8_t { kMessage, kEnd, kNothing };

Got Receive(int file, std::string& buffer, std::string& bytes, int milliseconds) {
  while (true) {
    std::uint32_t size = 0;
    if (buffer.size() >= sizeof size) {
      std::memcpy(&size, buffer.data(), sizeof size);
      if (buffer.size() >= sizeof size + size) {
        bytes = buffer.substr(sizeof size, size);
        buffer.erase(0, sizeof size + size);
        return Got::kMessage;
      }
    }
    pollfd waiting{file, POLLIN, 0};
    if (poll(&waiting, 1, milliseconds) == 0) return Got::kNothing;
    std::array<char, 4096> some{};
    const ssize_t count = read(file, some.data(), some.size());
    if (count <= 0) return Got::kEnd;
    buffer.append(some.data(), static_cast<std::size_t>(count));
  }
}

// A verdict and a request as lists of strings, each with its length.
std::string Pack(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += std::to_string(part.size()) + " " + part;
  return text;
}
std::vector<std::string> Unpack(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t space = text.find(' ', at);
    const std::size_t size = std::stoul(text.substr(at, space - at));
    parts.push_back(text.substr(space + 1, size));
    at = space + 1 + size;
  }
  return parts;
}

std::vector<std::string> PartsOf(const Verdict& verdict) {
  return {std::to_string(static_cast<int>(verdict.fault)), verdict.target, verdict.what};
}
Verdict VerdictOf(const std::vector<std::string>& parts) {
  return {static_cast<Fault>(std::stoi(parts.at(0))), parts.at(1), parts.at(2)};
}

// Runs the worker's process, which reads requests and writes steps and verdicts.
[[noreturn]] void Serve(int in, int out, JudgeOptions options, const Features& features) {
  options.before_step = [out](const std::string& step) { Send(out, Pack({"step", step})); };
  Judge judge(std::move(options));
  std::string buffer, bytes;
  while (Receive(in, buffer, bytes, -1) == Got::kMessage) {
    const std::vector<std::string> parts = Unpack(bytes);
    ChoiceList list(parts[0].size() / sizeof(std::uint32_t));
    if (!list.empty()) std::memcpy(list.data(), parts[0].data(), parts[0].size());
    std::optional<Verdict> only;
    if (parts.size() > 1) only = VerdictOf({parts.begin() + 1, parts.end()});
    Choices choices(std::move(list));
    const Program program = MakeProgram(choices, features);
    Send(out, Pack(PartsOf(judge(program, only))));
  }
  std::_Exit(0);
}

}  // namespace

Worker::Worker(JudgeOptions options, const Features& features)
    : options_(std::move(options)), features_(features) {
  std::signal(SIGPIPE, SIG_IGN);
}

Worker::~Worker() { Stop(); }

void Worker::Start() {
  int request[2], answer[2];
  if (pipe2(request, O_CLOEXEC) != 0 || pipe2(answer, O_CLOEXEC) != 0)
    throw harness::DrawError("no pipe");
  process_ = fork();
  if (process_ < 0) throw harness::DrawError("no process");
  if (process_ == 0) {
    close(request[1]);
    close(answer[0]);
    const int said = open((options_.scratch + "/stderr.txt").c_str(),
                          O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    if (said >= 0) dup2(said, STDERR_FILENO);
    // No shader is drawn twice, and each for a few vertices: compiling it is what takes time.
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
    setenv("GALLIVM_PERF", "nopt", 0);
    setenv("LP_NATIVE_VECTOR_WIDTH", "128", 0);
    Serve(request[0], answer[1], options_, features_);
  }
  close(request[0]);
  close(answer[1]);
  to_ = request[1];
  from_ = answer[0];
  runs_ = 0;
  buffer_.clear();
}

void Worker::Stop() {
  if (process_ < 0) return;
  close(to_);
  close(from_);
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
  process_ = -1;
}

std::string Worker::SaidOf() const {
  try {
    return harness::ReadFile(options_.scratch + "/stderr.txt");
  } catch (const harness::DrawError&) {
    return {};
  }
}

Verdict Worker::Ended(Fault fault, const std::string& step) {
  Stop();
  std::string what = SaidOf();
  what = (what.empty() ? "" : what.substr(0, what.find('\n')) + " ") + "at step: " + step + "\n" +
         what;
  return {fault, "", what};
}

Verdict Worker::Read() {
  std::string step = "generate", bytes;
  while (true) {
    switch (Receive(from_, buffer_, bytes, kPatience)) {
      case Got::kEnd: return Ended(Fault::kCrash, step);
      case Got::kNothing: return Ended(Fault::kHang, step);
      case Got::kMessage: break;
    }
    const std::vector<std::string> parts = Unpack(bytes);
    if (parts[0] != "step") return VerdictOf(parts);
    step = parts[1];
  }
}

Verdict Worker::Run(const ChoiceList& choices, const std::optional<Verdict>& only) {
  if (runs_++ >= kRunsOfProcess) Stop();
  if (process_ < 0) Start();
  std::vector<std::string> parts = {std::string(reinterpret_cast<const char*>(choices.data()),
                                                choices.size() * sizeof(std::uint32_t))};
  if (only) std::ranges::copy(PartsOf(*only), std::back_inserter(parts));
  Send(to_, Pack(parts));
  return Read();
}

}  // namespace clipc::random
