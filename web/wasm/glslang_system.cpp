// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// glslang's functions for threads (glslang/OSDependent/osinclude.h), on a system with one thread.
#include <glslang/OSDependent/osinclude.h>

namespace glslang {

OS_TLSIndex OS_AllocTLSIndex() { return new void*(nullptr); }
bool OS_SetTLSValue(OS_TLSIndex index, void* value) {
  *static_cast<void**>(index) = value;
  return true;
}
bool OS_FreeTLSIndex(OS_TLSIndex index) {
  delete static_cast<void**>(index);
  return true;
}
void* OS_GetTLSValue(OS_TLSIndex index) { return *static_cast<void**>(index); }

void InitGlobalLock() {}
void GetGlobalLock() {}
void ReleaseGlobalLock() {}
void OS_DumpMemoryCounters() {}

}  // namespace glslang
