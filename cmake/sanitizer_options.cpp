// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Linked into every program of a sanitizer build, so that it behaves the same under ctest, lit and
// a debugger.

// LLVM's BumpPtrAllocator poisons memory in its headers, which are compiled here with ASan, and
// expects its archives, which are not, to unpoison it.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() { return "allow_user_poisoning=0"; }

extern "C" const char* __ubsan_default_options();
extern "C" const char* __ubsan_default_options() { return "print_stacktrace=1"; }

// Mesa's Vulkan driver forgets some of the machine code that it made of loops.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libvulkan_lvp.so\nleak:libLLVM\n";
}

extern "C" const char* __lsan_default_options();
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }
