/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef CLIPC_EFFECT_H
#define CLIPC_EFFECT_H 1

#include "clipc.h"

/** Effects in the library: with the option --effect, clipc_compile compiles every pass of an
 * effect, or those of --technique=NAME and --pass=NAME. docs/effects.md says what is read.
 *
 * CLIPC_PART_EFFECT is its JSON, and clipc_result_effect has the same as structs. With {"-Fh",
 * ".h"}, CLIPC_PART_EFFECT_HEADER is the header for effect-runtime/effect.h. The other parts but
 * the messages and the dependencies are those of the programs, each a result of its own.
 *
 * A pass with errors does not keep the others from being compiled: after CLIPC_HAS_ERRORS the
 * effect is there if it could be read, and the programs that have errors are NULL.
 *
 * The rules of clipc.h hold, also that structs are read by the pointers that the library gives. */

/* NOLINTBEGIN(readability-identifier-naming,modernize-*): names and types as usual in C. */
#ifdef __cplusplus
extern "C" {
#endif

/** <string UIName = "Height";>: {"string", "UIName", "\"Height\""} */
typedef struct clipc_effect_annotation {
  const char *type, *name, *value;
} clipc_effect_annotation;

/** A state of a pass, or of a parameter that is a sampler or a block of states, as the effect has
 * it: {"CullMode", "None"}. */
typedef struct clipc_effect_state {
  const char *name, *value;
} clipc_effect_state;

typedef struct clipc_effect_shader {
  const char* stage; /**< "vertex", "geometry", "pixel" or "compute" */
  const char* entry;
  const char* profile; /**< "vs_3_0" */
  const char* call;    /**< with arguments, "Main(true, 4)"; empty: it has none */
  int32_t element;     /**< of the array that the pass takes it from; -1: of none */
} clipc_effect_shader;

typedef struct clipc_effect_program {
  const clipc_effect_shader* const* shaders; /**< by stage, at least one */
  size_t shader_count;
  /** CLIPC_PART_GLSL is its first shader, CLIPC_PART_PIXEL the pixel shader after it;
   * clipc_result_shader gives all. Programs that are alike share one. NULL: it has errors. */
  const clipc_result* result;
  size_t number; /**< the same for programs that are alike */
} clipc_effect_program;

/** A value that chooses the program of a pass, VertexShader = (VS[i]); it is less than `count`. */
typedef struct clipc_effect_value {
  const char* text; /**< "i" */
  size_t count;
} clipc_effect_value;

typedef struct clipc_effect_choice {
  const clipc_effect_value* const* values;
  size_t value_count;
  /** The program of each combination of values, of which the last varies first; -1: it has none. */
  const int32_t* programs;
  size_t program_count;
} clipc_effect_choice;

typedef struct clipc_effect_pass {
  const char* name;
  int is_left_out; /**< it has a shader that clipc does not compile */
  const clipc_effect_annotation* const* annotations;
  size_t annotation_count;
  const clipc_effect_program* const* programs; /**< several where it takes shaders from an array */
  size_t program_count;
  const clipc_effect_choice* const* choices; /**< none where nothing chooses */
  size_t choice_count;
  const clipc_effect_state* const* states;
  size_t state_count;
} clipc_effect_pass;

typedef struct clipc_effect_technique {
  const char* kind;  /**< "technique", "technique10", "technique11" */
  const char* group; /**< the name of its fxgroup; empty: of none */
  const char* name;
  const clipc_effect_annotation* const* annotations;
  size_t annotation_count;
  const clipc_effect_pass* const* passes;
  size_t pass_count;
} clipc_effect_technique;

typedef struct clipc_effect_parameter {
  const char *name, *type, *semantic;
  const char* value; /**< the default value as the effect has it */
  /** The default value as it lies in its buffer; empty where no program reads it. */
  clipc_bytes bytes;
  const clipc_effect_annotation* const* annotations;
  size_t annotation_count;
  const clipc_effect_state* const* states;
  size_t state_count;
} clipc_effect_parameter;

typedef struct clipc_effect {
  const clipc_effect_technique* const* techniques;
  size_t technique_count;
  const clipc_effect_parameter* const* parameters;
  size_t parameter_count;
} clipc_effect;

/** NULL without --effect, where the effect cannot be read, or if there is no memory. */
CLIPC_API const clipc_effect* clipc_result_effect(const clipc_result* result);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(readability-identifier-naming,modernize-*) */

#endif
