// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "ir/evaluate.h"
#include "ir/evaluate_machine.h"
#include "ir/intrinsic.h"

namespace clipc::ir {
namespace {

// The most phases of a group: each runs all phases before it again.
constexpr std::size_t kMaxPhases = 1024;
// The most runs of the threads of a wave in a phase: one for each call that depends on others.
constexpr int kMaxRuns = 1024;

// The inputs of thread number `index` of the group.
std::vector<IoBits> InputsOf(const Program& program, const GroupRun& run, std::uint32_t index) {
  const auto& size = program.group_size;
  const std::uint32_t within[] = {index % size[0], index / size[0] % size[1],
                                  index / (size[0] * size[1])};
  std::vector<IoBits> inputs;
  for (const IoVar& input : program.inputs) {
    IoBits& bits = inputs.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      if (input.builtin == Builtin::kThreadId) bits[i] = run.group[i] * size[i] + within[i];
      if (input.builtin == Builtin::kGroupId) bits[i] = run.group[i];
      if (input.builtin == Builtin::kGroupThreadId) bits[i] = within[i];
    }
    if (input.builtin == Builtin::kGroupIndex) bits[0] = index;
    if (input.builtin == Builtin::kLaneIndex) bits[0] = index % run.lanes;
    if (input.builtin == Builtin::kLaneCount) bits[0] = run.lanes;
  }
  return inputs;
}

// Whether threads ask the other lanes of their wave.
bool AsksLanes(const Program& program) {
  for (const ExprId id : program.exprs.ids()) {
    const auto* call = std::get_if<IntrinsicCall>(&program.exprs[id].node);
    if (call && (CategoryOf(call->op) == IntrinsicCategory::kWave ||
                 CategoryOf(call->op) == IntrinsicCategory::kQuad))
      return true;
  }
  return false;
}

// Whether the wait orders what the group shares, so that a new phase begins for that.
bool OrdersShared(const Program& program, ExprId call) {
  return BarrierOf(std::get<IntrinsicCall>(program.exprs[call].node).op).orders_shared;
}

// A group that runs, phase by phase.
class RunningGroup {
 public:
  RunningGroup(const Program& program, const EvalInputs& inputs, const GroupRun& run,
               const EvalOptions& options)
      : program_(program), inputs_(inputs), run_(run), options_(options) {
    const auto& [x, y, z] = program.group_size;
    threads_.assign(std::size_t{x} * y * z, inputs);
    pasts_.resize(threads_.size());
    for (std::uint32_t i = 0; i < threads_.size(); ++i)
      threads_[i].values = InputsOf(program, run, i);
    waves_.resize((threads_.size() + run.lanes - 1) / run.lanes, LaneNotes(run.lanes));
  }

  GroupResult Run() {
    const bool asks_lanes = AsksLanes(program_);
    for (std::size_t phase = 0; phase < kMaxPhases; ++phase) {
      for (std::size_t i = 0; i < waves_.size(); ++i) {
        const std::size_t wave = run_.is_reversed ? waves_.size() - 1 - i : i;
        const std::string error = asks_lanes ? Settle(wave, phase) : RunOnce(wave, phase, {});
        if (!error.empty()) return {error};
      }
      if (shared_.has_race()) return {"threads of a group race for the memory that they share"};
      const ExprId at = pasts_.front().waits_at;
      if (!std::ranges::all_of(pasts_, [&](const ThreadPast& past) { return past.waits_at == at; }))
        return {"some threads of a group wait where others do not"};
      if (!at) return {};
      if (OrdersShared(program_, at)) shared_.BeginPhase();
    }
    return {"the threads of a group wait for each other too often to evaluate"};
  }

 private:
  // Runs the threads of a wave in a phase, which know what lanes noted before, and returns the
  // error that ends one.
  std::string RunOnce(std::size_t wave, std::size_t phase, const LaneNotes& before) {
    const auto first = static_cast<std::uint32_t>(wave) * run_.lanes;
    const std::uint32_t count =
        std::min(run_.lanes, static_cast<std::uint32_t>(threads_.size()) - first);
    std::string error;
    for (std::uint32_t i = 0; i < count && error.empty(); ++i) {
      const std::uint32_t lane = run_.is_reversed ? count - 1 - i : i;
      Lanes lanes(lane, before, waves_[wave]);
      GroupThread thread(first + lane, phase, shared_, pasts_[first + lane], lanes);
      error = Machine(program_, threads_[first + lane], options_, nullptr, &thread).Run().error;
    }
    return error;
  }

  // The same until what lanes note stays as it is.
  std::string Settle(std::size_t wave, std::size_t phase) {
    const SharedWords shared = shared_;
    const std::vector<ThreadPast> pasts = pasts_;
    const std::function<void()> restore = inputs_.remember ? inputs_.remember() : [] {};
    for (int runs = 0; runs < kMaxRuns; ++runs) {
      if (runs > 0) restore(), shared_ = shared, pasts_ = pasts;
      const LaneNotes before = std::exchange(waves_[wave], LaneNotes(run_.lanes));
      const std::string error = RunOnce(wave, phase, before);
      if (waves_[wave] == before) return error;
    }
    return "the lanes of a wave ask each other too often to evaluate";
  }

  const Program& program_;
  const EvalInputs& inputs_;
  const GroupRun& run_;
  const EvalOptions& options_;
  std::vector<EvalInputs> threads_;
  std::vector<ThreadPast> pasts_;
  std::vector<LaneNotes> waves_;
  SharedWords shared_;
};

}  // namespace

GroupResult RunGroup(const Program& program, const EvalInputs& inputs, const GroupRun& run,
                     const EvalOptions& options) {
  return RunningGroup(program, inputs, run, options).Run();
}

}  // namespace clipc::ir
