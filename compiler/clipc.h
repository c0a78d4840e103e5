/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef CLIPC_H
#define CLIPC_H 1

#include <stddef.h>
#include <stdint.h>

/** clipc as a library for C99 and for other languages: one HLSL shader in; GLSL, SPIR-V, HLSL, the
 * clip table and the reflection out, all of it in memory. clipc.hpp is the same for C++, and
 * clipc_effect.h is what an effect gives.
 *
 * ABI: what this header declares is never changed or removed while CLIPC_ABI stays. New members of
 * clipc_request come at its end, and `size` says which of them the caller knows; new parts get new
 * numbers.
 * Errors: no function throws, exits, prints or changes the state of the process.
 * Limits: the options --max-seconds, --max-bytes and --max-tokens; --sandbox-includes says where
 * includes may lie.
 * Threads: a clipc_compiler serves one thread at a time; several may work at once. */

/** The mark of the functions that the shared library exports; on Windows a list names them. */
#if defined(__GNUC__) && !defined(_WIN32)
#define CLIPC_API __attribute__((visibility("default")))
#else
#define CLIPC_API
#endif

/* NOLINTBEGIN(readability-identifier-naming,modernize-*): names and types as usual in C. */
#ifdef __cplusplus
extern "C" {
#endif

#define CLIPC_ABI 1
/** The CLIPC_ABI of the library; the caller compares it with its own. */
CLIPC_API uint32_t clipc_abi(void);
/** The version of the library: "0.1.0". */
CLIPC_API const char* clipc_version(void);

/** Keeps the data that shaders share. clipc_compiler_create: NULL if there is no memory. */
typedef struct clipc_compiler clipc_compiler;
CLIPC_API clipc_compiler* clipc_compiler_create(void);
CLIPC_API void clipc_compiler_free(clipc_compiler* compiler); /**< NULL is allowed */

/** Bytes, and a zero after them that `size` does not count. */
typedef struct clipc_bytes {
  const char* data;
  size_t size;
} clipc_bytes;

/** The text of the include file at `path`, which is a folder of -I or of the including file, a
 * slash, and the name as the shader has it. Returns 0 if there is no such file. The bytes are
 * copied before the next call. */
typedef int (*clipc_read_include)(void* context, const char* path, clipc_bytes* text);

typedef struct clipc_request {
  size_t size; /**< sizeof(clipc_request) */
  /** The name in messages, and where its includes are looked up. UTF-8, like all texts. */
  const char* path;
  /** The text of the shader; NULL for the file at `path`. */
  const char* text;
  size_t text_size;
  /** The options, as on the command line: {"-T", "vs_5_0", "--target=vulkan"}. Options that name
   * outputs or inputs are errors, but for --pixel-shader=NAME, and --pixel-output=.frag and
   * --geometry-output=.geom, which request these shaders too. */
  const char* const* options;
  size_t option_count;
  /** If not NULL, includes come from this function, and no file is read for them. */
  clipc_read_include read_include;
  void* read_include_context;
  /** If not NULL, asked on the thread that compiles, often except while glslang works; the compile
   * ends when it returns other than 0. */
  int (*is_cancelled)(void* context);
  void* is_cancelled_context;
  /** Of the pixel shader that --pixel-shader names; NULL: read_include or else its file has it. */
  const char* pixel_text;
  size_t pixel_text_size;
  /** If not NULL, asked after the preprocessor has run, with the key of a cache: 32 letters that
   * stand for the text without comments, the options but for macros and folders, and the version.
   * Requests with one key have the same result but for the dependencies. When it returns other than
   * 0 the compile ends with CLIPC_KNOWN. It is not asked where more decides: for a pair, an effect
   * or HLSL, with -Zi, `#pragma` or options from a file, and where there are messages. */
  int (*is_known)(void* context, const char* key);
  void* is_known_context;
} clipc_request;

/** The last member of each enumeration fixes its size, and makes every number a value of it: the
 * number of a newer or older header is well defined. */
typedef enum clipc_status {
  CLIPC_COMPILED = 0,
  CLIPC_HAS_ERRORS,  /**< the shader has errors */
  CLIPC_BAD_REQUEST, /**< an option is wrong, or the shader cannot be read */
  CLIPC_NO_MEMORY,   /**< *result is NULL */
  CLIPC_CANCELLED,   /**< clipc_request::is_cancelled */
  CLIPC_KNOWN,       /**< clipc_request::is_known */
  CLIPC_STATUS_MAX = 0x7fffffff
} clipc_status;

/** The parts of a result. All but the messages, the dependencies and CLIPC_PART_EFFECT are empty
 * after an error. */
typedef enum clipc_part {
  CLIPC_PART_MESSAGES = 0,  /**< as a terminal shows them, with the lines of the source */
  CLIPC_PART_MESSAGES_JSON, /**< {"version": 1, "diagnostics": [...]} */
  CLIPC_PART_DEPENDENCIES,  /**< the files that were read, each followed by a newline */
  CLIPC_PART_GLSL,          /**< of the shader; empty with --target=hlsl */
  /** With --lower=discard: GLSL that discards, for the fragment shader. With --pixel-output: the
   * GLSL of the pixel shader, whatever the lowering. */
  CLIPC_PART_DISCARD,
  CLIPC_PART_PIXEL = CLIPC_PART_DISCARD,
  CLIPC_PART_SPIRV,      /**< with -spirv: 32-bit words in the machine's order */
  CLIPC_PART_REFLECTION, /**< JSON: docs/reflection.md */
  CLIPC_PART_TABLE_JSON,
  CLIPC_PART_TABLE_BINARY,  /**< Direct3D's record; empty for planes that it cannot say */
  CLIPC_PART_TABLE_HEADER,  /**< a header of C and C++ with `clip_table` */
  CLIPC_PART_PIXEL_SPIRV,   /**< with -spirv and --pixel-output: of the pixel shader */
  CLIPC_PART_HLSL,          /**< with --target=hlsl: the same HLSL with clip distances */
  CLIPC_PART_PREPROCESSED,  /**< with -P: the text after the preprocessor, and nothing else */
  CLIPC_PART_STRUCTS,       /**< with --reflect=.h: the buffers as structs of C and C++ */
  CLIPC_PART_EFFECT,        /**< with --effect: JSON; clipc_effect.h */
  CLIPC_PART_EFFECT_HEADER, /**< with --effect and -Fh .h: a header for effect-runtime/effect.h */
  CLIPC_PART_MAX = 0x7fffffff
} clipc_part;

/** Compiles a shader. Always sets *result, which the caller frees, except after CLIPC_NO_MEMORY.
 * The same request gives the same bytes. */
typedef struct clipc_result clipc_result;
CLIPC_API clipc_status clipc_compile(clipc_compiler* compiler, const clipc_request* request,
                                     clipc_result** result);
CLIPC_API void clipc_result_free(clipc_result* result); /**< NULL is allowed */
/** A part of a result, for as long as that lives; empty, not NULL, where it has no such part. */
CLIPC_API clipc_bytes clipc_result_get(const clipc_result* result, clipc_part part);

/** With --variants: the result of the variant with the first `planes` planes, which has the parts
 * that differ, CLIPC_PART_GLSL and CLIPC_PART_DISCARD; NULL past the last. It lives as long as
 * `result`. */
CLIPC_API const clipc_result* clipc_result_variant(const clipc_result* result, size_t planes);

/* Structs below have more members at their end in newer versions, so they are read by the pointers
 * that the library gives, and live as long as the result. Text is never NULL; it is empty where
 * there is none. */

typedef enum clipc_severity {
  CLIPC_ERROR = 0,
  CLIPC_WARNING,
  CLIPC_NOTE, /**< of the message before it */
  CLIPC_SEVERITY_MAX = 0x7fffffff
} clipc_severity;

typedef struct clipc_diagnostic {
  clipc_severity severity;
  const char* name; /**< "clip-plane-not-float4", as in -Wno-NAME and --explain */
  const char* code; /**< fxc's: "X3084" */
  const char* text;
  const char* file;                            /**< empty: of no place in particular */
  uint32_t line, column, end_line, end_column; /**< from 1, in bytes; the end is one past */
} clipc_diagnostic;
/** The messages as in CLIPC_PART_MESSAGES_JSON; NULL past the last, or if there is no memory. */
CLIPC_API const clipc_diagnostic* clipc_result_diagnostic(const clipc_result* result, size_t index);

/** An input or an output. */
typedef struct clipc_variable {
  const char* semantic; /**< "TEXCOORD" */
  uint32_t index;
  const char* type; /**< "float2" */
  const char* name; /**< in the GLSL */
  int32_t location; /**< -1: none */
  int is_builtin;   /**< a variable of GLSL's own */
  int is_used;      /**< of an input: the shader reads it; of an output: 1 */
  uint32_t stream;  /**< of an output of a geometry shader with several streams */
  int is_of_patch;  /**< a constant of a patch, of a hull or domain shader */
} clipc_variable;

/** A member of a constant buffer. */
typedef struct clipc_member {
  const char* name;
  const char* type;
  uint32_t offset, size; /**< in bytes of the HLSL's buffer */
  const char* glsl; /**< the name to query, "PerFrame.view"; empty: the shader does not have it */
} clipc_member;

/** A constant buffer of the file. */
typedef struct clipc_buffer {
  const char* name;
  const char* hlsl_register; /**< "b0" */
  uint32_t space;
  uint32_t size;        /**< in bytes */
  int is_used;          /**< the rest is empty or -1 if not */
  const char* block;    /**< of the GLSL */
  int32_t set, binding; /**< -1: none */
  const clipc_member* const* members;
  size_t member_count;
} clipc_buffer;

/** A texture, a sampler, both in one, or a buffer with a view. */
typedef struct clipc_resource {
  const char* glsl;
  int32_t set, binding;         /**< -1: none */
  const char* texture;          /**< its name in the HLSL, also of a buffer */
  const char* texture_type;     /**< "Texture2D<float4>" */
  const char* texture_register; /**< "t0" */
  const char* sampler;
  const char* sampler_type;
  const char* sampler_register;
  const char* access; /**< of a compute shader: "read", "write", "read-write", or "" */
} clipc_resource;

/** CLIPC_PART_REFLECTION as structs: what binds a shader. The JSON says more. */
typedef struct clipc_reflection clipc_reflection;
struct clipc_reflection {
  const char* entry;
  const char* profile;
  const clipc_variable* const* inputs;
  size_t input_count;
  const clipc_variable* const* outputs;
  size_t output_count;
  const clipc_buffer* const* buffers;
  size_t buffer_count;
  const clipc_resource* const* resources;
  size_t resource_count;
  const clipc_reflection* pixel_shader; /**< of a pair; else NULL */
  uint32_t group_size[3];               /**< of a compute shader, in x, y and z; else 0 */
  uint64_t shared_bytes;                /**< of the memory that the threads of a group share */
  const char* input_primitive;          /**< of a geometry shader: "triangle"; else "" */
  const char* output_primitive;         /**< "point", "line_strip", "triangle_strip" or "" */
  uint32_t input_vertices;              /**< of the primitive that a geometry shader takes */
  uint32_t max_vertices;                /**< that it emits */
  uint32_t instances;                   /**< how often it runs for a primitive; else 0 */
  const char* domain;                   /**< of a hull or domain shader: "tri"; else "" */
  const char* partitioning;             /**< "integer", "fractional_odd" or the like, or "" */
  const char* topology;                 /**< "triangle_cw" or the like, or "" */
  uint32_t input_points, output_points; /**< control points that it reads and, a hull, writes */
  float max_factor;                     /**< the most a factor may be; 0: the device's */
};
/** NULL where the result has no reflection, or if there is no memory. */
CLIPC_API const clipc_reflection* clipc_result_reflection(const clipc_result* result);

/** A shader of a result. */
typedef struct clipc_shader {
  const char* stage;                  /**< "vertex", "hull", .., "pixel" or "compute" */
  clipc_bytes text;                   /**< GLSL, or with --target=hlsl HLSL */
  clipc_bytes spirv;                  /**< as CLIPC_PART_SPIRV */
  const clipc_reflection* reflection; /**< its own; NULL where the result has none */
} clipc_shader;
/** The shaders in the order of the pipeline; NULL past the last, or if there is no memory. */
CLIPC_API const clipc_shader* clipc_result_shader(const clipc_result* result, size_t index);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(readability-identifier-naming,modernize-*) */

#endif
