// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The C++ library's streams take 44,000 instructions to make, at the start of every process in
// which some file includes <iostream>; here those are glslang's alone. A program that is linked
// with --wrap for their constructor makes them when glslang starts.
#define CLIPC_STREAMS "_ZNSt8ios_base4InitC1Ev"

void MakeStreams(void* object) __asm__("__real_" CLIPC_STREAMS);
void MakeStreamsLater(void* object) __asm__("__wrap_" CLIPC_STREAMS);

void MakeStreamsLater(void*) {}

extern "C" void clipc_prepare_glslang() {
  char object = 0;  // of an empty class
  MakeStreams(&object);
}
