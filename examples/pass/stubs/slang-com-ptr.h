// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// NOT Slang: see slang.h beside this file.
#pragma once

// NOLINTBEGIN: names of Slang.
namespace Slang {

template <typename T>
class ComPtr {
 public:
  ComPtr() = default;
  ComPtr(const ComPtr&) = delete;
  ComPtr& operator=(const ComPtr&) = delete;
  ~ComPtr() { writeRef(); }

  T* get() const { return pointer_; }
  T* operator->() const { return pointer_; }
  T** writeRef() {
    if (pointer_) pointer_->release();
    pointer_ = nullptr;
    return &pointer_;
  }

 private:
  T* pointer_ = nullptr;
};

}  // namespace Slang
// NOLINTEND
