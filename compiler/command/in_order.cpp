// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/command/in_order.h"

#include <algorithm>
#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace clipc {
namespace {

#ifdef __wasm__
constexpr bool kHasThreads = false;
#else
constexpr bool kHasThreads = true;
#endif

using Work = std::function<CompileResult(std::size_t index, Compiler& compiler)>;

// The threads, and the results that wait.
class Workers {
 public:
  Workers(std::size_t count, unsigned jobs, const Work& work)
      : count_(count), ahead_(std::size_t{4} * jobs), work_(work) {
    for (unsigned i = 0; i < jobs; ++i) threads_.emplace_back([this] { Run(); });
  }
  ~Workers() {
    const std::lock_guard lock(mutex_);
    next_ = count_;  // no thread begins another
    moved_.notify_all();
  }
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  CompileResult Take(std::size_t index) {
    std::unique_lock lock(mutex_);
    moved_.wait(lock, [&] { return results_.contains(index); });
    CompileResult result = std::move(results_.extract(index).mapped());
    taken_ = index + 1;
    moved_.notify_all();
    return result;
  }

 private:
  void Run() {
    Compiler compiler;
    std::unique_lock lock(mutex_);
    while (true) {
      moved_.wait(lock, [&] { return next_ >= count_ || next_ < taken_ + ahead_; });
      if (next_ >= count_) return;
      const std::size_t index = next_++;
      lock.unlock();
      CompileResult result = work_(index, compiler);
      lock.lock();
      results_.emplace(index, std::move(result));
      moved_.notify_all();
    }
  }

  const std::size_t count_, ahead_;
  const Work& work_;
  std::mutex mutex_;
  std::condition_variable moved_;
  std::size_t next_ = 0, taken_ = 0;
  std::map<std::size_t, CompileResult> results_;
  std::vector<std::jthread> threads_;  // the last member: joined while the others live
};

}  // namespace

void CompileInOrder(std::size_t count, unsigned jobs, const Work& work,
                    const std::function<bool(std::size_t index, CompileResult result)>& finish) {
  const auto threads = static_cast<unsigned>(std::min<std::size_t>(jobs, count));
  if (threads <= 1 || !kHasThreads) {
    Compiler compiler;
    for (std::size_t index = 0; index < count; ++index) {
      if (!finish(index, work(index, compiler))) return;
    }
    return;
  }
  Workers workers(count, threads, work);
  for (std::size_t index = 0; index < count; ++index) {
    if (!finish(index, workers.Take(index))) return;
  }
}

}  // namespace clipc
