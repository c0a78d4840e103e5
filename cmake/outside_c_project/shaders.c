/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Says where the plane of a shader goes that the build compiled. */
#include <clipc/runtime/clipc_runtime.h>
#include <stdio.h>
#include <string.h>

#include "variants.shader.h"
#include "water.clip.h"
#include "water.reflect.h"
#include "water.shader.h"
#include "water.spv.h"

int main(void) {
  char message[CLIPC_MESSAGE_SIZE];
  clipc_table* table = NULL;
  clipc_plane_place place;
  clipc_error error =
      clipc_table_read(water_clip_table, sizeof water_clip_table - 1, &table, message);
  if (error == CLIPC_OK) error = clipc_table_get_plane(table, 0, &place, message);
  if (error != CLIPC_OK) return printf("%s\n", message);
  clipc_table_free(table);
  if (place.byte_offset != offsetof(struct GpuClip, water)) return printf("another byte\n");
  if (water_spv[0] != 0x07230203 || strstr(water_vert, "gl_ClipDistance[0] =") == NULL)
    return printf("another shader\n");
  if (strstr(variants_vert[0], "gl_ClipDistance[0] =") != NULL) return printf("a plane\n");
  printf("plane %s: byte %u of b%u\n", place.text, (unsigned)place.byte_offset,
         (unsigned)place.register_number);
  return 0;
}
