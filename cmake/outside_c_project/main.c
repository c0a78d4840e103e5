/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Compiles a shader from memory, and reads from its clip table where the plane goes. */
#include <clipc/clipc.h>
#include <clipc/runtime/clipc_runtime.h>
#include <stdio.h>
#include <string.h>

static const char kShader[] =
    "#include \"planes.hlsli\"\n"
    "[clipplanes(water)] float4 main(float4 p : POSITION) : SV_Position { return p; }\n";
static const char kInclude[] = "cbuffer Clip : register(b3) { float4 other, water; };\n";

static int ReadInclude(void* context, const char* path, clipc_bytes* text) {
  (void)context;
  if (strcmp(path, "shaders/planes.hlsli") != 0) return 0;
  text->data = kInclude;
  text->size = sizeof kInclude - 1;
  return 1;
}

static int Always(void* context) {
  (void)context;
  return 1;
}

static int Fail(const char* what, const char* why) {
  fprintf(stderr, "%s: %s\n", what, why);
  return 1;
}

static int ShowPlane(clipc_bytes json) {
  char message[CLIPC_MESSAGE_SIZE];
  clipc_table* table = NULL;
  clipc_plane_place place;
  clipc_error error = clipc_table_read(json.data, json.size, &table, message);
  if (error == CLIPC_OK) error = clipc_table_get_plane(table, 0, &place, message);
  if (error == CLIPC_OK) {
    printf("plane %s: byte %u of b%u, lowering %d\n", place.text, (unsigned)place.byte_offset,
           (unsigned)place.register_number, (int)clipc_table_lowering(table));
  }
  clipc_table_free(table);
  return error == CLIPC_OK ? 0 : Fail("table", message);
}

int main(void) {
  static const char* const options[] = {"-T", "vs_5_0", "--target=vulkan", "-spirv"};
  clipc_compiler* compiler = clipc_compiler_create();
  clipc_result* result = NULL;
  clipc_request request = {0};
  const clipc_reflection* shader;
  int status;
  if (clipc_abi() != CLIPC_ABI || compiler == NULL) return Fail("clipc", "another ABI");
  request.size = sizeof request;
  request.path = "shaders/water.hlsl";
  request.text = kShader;
  request.text_size = sizeof kShader - 1;
  request.options = options;
  request.option_count = 4;
  request.read_include = ReadInclude;
  if (clipc_compile(compiler, &request, &result) != CLIPC_COMPILED)
    return Fail("compile", clipc_result_get(result, CLIPC_PART_MESSAGES).data);
  if (strstr(clipc_result_get(result, CLIPC_PART_GLSL).data, "gl_ClipDistance[0] =") == NULL)
    return Fail("GLSL", "without the plane");
  if (clipc_result_get(result, CLIPC_PART_SPIRV).size < 20) return Fail("SPIR-V", "too short");
  shader = clipc_result_reflection(result);
  if (shader == NULL || shader->buffer_count != 1 || shader->buffers[0]->binding != 3)
    return Fail("reflection", "without the buffer");
  if (clipc_result_diagnostic(result, 0) != NULL) return Fail("messages", "there is one");
  status = ShowPlane(clipc_result_get(result, CLIPC_PART_TABLE_JSON));
  clipc_result_free(result);

  request.is_cancelled = Always;
  if (clipc_compile(compiler, &request, &result) != CLIPC_CANCELLED)
    return Fail("cancelled", clipc_result_get(result, CLIPC_PART_MESSAGES).data);
  clipc_result_free(result);
  clipc_compiler_free(compiler);
  return status;
}
