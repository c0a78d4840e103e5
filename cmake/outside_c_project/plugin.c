/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include <clipc/runtime/gl/clipc_runtime_gl.h>

__attribute__((visibility("default"))) int plugin_start(clipc_gl_loader loader);

int plugin_start(clipc_gl_loader loader) {
  clipc_gl_switches* switches = NULL;
  const clipc_error error = clipc_gl_switches_create(loader, &switches, NULL);
  clipc_gl_switches_free(switches);
  return (int)error;
}
