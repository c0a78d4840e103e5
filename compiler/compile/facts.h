// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "clip-table/clip_table.h"
#include "clip-table/vocabulary.h"
#include "ir/type.h"

// Everything that the host needs to feed a program, as values: the JSON of --reflect
// (docs/reflection.md), its structs of C, the structs of the C interface and the table of an effect
// are ways to print them. Offsets and sizes are in bytes of the buffer as Direct3D lays it out.
namespace clipc {

struct RegisterFact {
  std::string name = {};  // "t3"
  std::uint32_t number = 0, space = 0;
  bool is_explicit = false;  // the text names it
  friend bool operator==(const RegisterFact&, const RegisterFact&) = default;
};

// The input of the next stage that reads an output.
struct ReaderFact {
  std::string stage = {};  // "pixel"
  std::string name = {};
  std::optional<std::uint32_t> element = {};  // of an array; none: the whole variable
  friend bool operator==(const ReaderFact&, const ReaderFact&) = default;
};

// An input or an output of the signature.
struct VariableFact {
  std::string semantic = {};
  std::uint32_t index = 0;
  std::string type = {}, name = {};  // the type of HLSL, the name of the GLSL
  std::optional<std::uint32_t> location = {}, render_target = {};
  std::uint32_t blend_index = 0;
  bool needs_base_vertex_zero = false, needs_base_instance_zero = false;
  bool integer_as_float = false;
  bool is_builtin = false;
  bool is_of_patch = false;  // a constant of a patch
  ir::Interpolation interpolation = ir::Interpolation::kDefault;
  bool centroid = false, sample = false;
  std::optional<ReaderFact> reader = {};     // of an output
  std::optional<std::uint32_t> stream = {};  // of an output where there are several
  bool is_used = true;                       // of an input
  friend bool operator==(const VariableFact&, const VariableFact&) = default;
};

// Where the GLSL has a constant.
struct GlslPlace {
  std::string glsl = {};      // the name at the host's interface
  std::string function = {};  // that reads it, where the GLSL has one
  bool is_row = false;        // it is in an array of rows
  bool is_uniform = false, transpose = false;
  friend bool operator==(const GlslPlace&, const GlslPlace&) = default;
};

// How a value lies in a buffer.
struct ShapeFact {
  struct Dimension {
    std::uint32_t count = 0;
    std::uint32_t stride = 0;  // from an element to the next
    std::uint32_t size = 0;    // of the whole array
    friend bool operator==(const Dimension&, const Dimension&) = default;
  };

  std::vector<Dimension> dimensions = {};  // of an array, the outermost first
  // Of an element, as all that follows.
  std::uint32_t size = 0;
  ir::TypeKind kind = ir::TypeKind::kError;
  ir::Scalar scalar = ir::Scalar::kFloat;
  std::uint32_t rows = 1, columns = 1;        // a vector is a row
  std::optional<std::size_t> structure = {};  // in StageFacts::structs
  friend bool operator==(const ShapeFact&, const ShapeFact&) = default;

  // The size of what is left after so many subscripts.
  std::uint32_t SizeAfter(std::size_t subscripts) const {
    return subscripts < dimensions.size() ? dimensions[subscripts].size : size;
  }
};

struct FieldFact {
  std::string name = {}, type = {};  // the type of HLSL
  ShapeFact shape = {};
  std::uint32_t offset = 0, size = 0;
  bool row_major = false;  // how its matrices lie, but for those in a struct
  std::optional<GlslPlace> place = {};
  friend bool operator==(const FieldFact&, const FieldFact&) = default;
};

struct MemberFact : FieldFact {
  std::vector<std::uint8_t> initial = {};  // the bytes of its value; empty: none
  std::vector<FieldFact> fields = {};  // of a ConstantBuffer, whose members they are in the GLSL

  bool IsRowMajor() const { return row_major && !shape.structure; }
  friend bool operator==(const MemberFact&, const MemberFact&) = default;
};

struct BufferFact {
  struct Block {
    std::string layout = {};  // "std140", "rows" or "uniforms"
    std::string name = {}, instance = {}, rows = {};
    std::optional<std::uint32_t> set = {}, binding = {};
    bool is_push_constant = false;
    bool is_shared = false;  // with another stage
    friend bool operator==(const Block&, const Block&) = default;
  };

  std::string name = {}, kind = {};
  RegisterFact reg = {};
  std::uint32_t size = 0;
  std::uint32_t count = 1;          // of an array of buffers; 0: unbounded
  std::optional<Block> block = {};  // none: the shader does not use the buffer
  std::vector<MemberFact> members = {};
  friend bool operator==(const BufferFact&, const BufferFact&) = default;
};

struct StructFact {
  std::string name = {};  // empty: it has none
  std::uint32_t size = 0;
  std::vector<FieldFact> fields = {};
  friend bool operator==(const StructFact&, const StructFact&) = default;
};

// A texture, a sampler, a buffer or an image; of OpenGL, a texture together with its sampler.
struct ResourceFact {
  struct Part {
    std::string name = {}, type = {};
    bool is_unbounded = false;
    // The sizes of an array, that of the outermost dimension first; none if it has none.
    std::vector<std::uint32_t> dimensions = {};
    // The array that it is an element of to the shader, not to the target, and its number in it.
    std::string element_of = {};
    std::uint32_t element = 0;
    std::optional<RegisterFact> reg = {};
    std::string counter_of = {};  // the buffer whose counter it is
    friend bool operator==(const Part&, const Part&) = default;
  };

  std::string glsl = {};
  ir::ObjectKind kind = ir::ObjectKind::kOther;  // of the texture; of the sampler if there is none
  std::optional<std::uint32_t> set = {}, binding = {};
  std::optional<Part> texture = {}, sampler = {};
  // What a stage that runs in groups does with an object that it may write: "read", "write",
  // "read-write"; empty otherwise.
  std::string access = {};
  friend bool operator==(const ResourceFact&, const ResourceFact&) = default;
};

// What the host sets so that a stage that draws pixels gets Direct3D's values.
struct HostFact {
  std::string framebuffer_height = {};
  std::string front_face = {};  // "clockwise", "counterclockwise"; empty: the shader does not ask
  bool first_vertex_provokes = false;
  friend bool operator==(const HostFact&, const HostFact&) = default;
};

// A stage that runs in groups.
struct GroupFact {
  std::array<std::uint32_t, 3> size = {};  // its threads in x, y and z
  std::uint64_t shared_bytes = 0;          // of the memory that they share
  friend bool operator==(const GroupFact&, const GroupFact&) = default;
};

// A stage that emits vertices.
struct EmissionFact {
  std::string input;                 // the primitive that it takes: "triangle"
  std::string output;                // "point", "line_strip" or "triangle_strip"
  std::uint32_t input_vertices = 0;  // of the primitive
  std::uint32_t max_vertices = 0;    // that it emits
  std::uint32_t instances = 1;
  std::uint32_t streams = 1;
  friend bool operator==(const EmissionFact&, const EmissionFact&) = default;
};

// A stage that makes or reads patches. The words are HLSL's.
struct TessellationFact {
  std::string domain;                  // "tri"
  std::string partitioning, topology;  // "integer", "triangle_cw"
  std::uint32_t input_points = 0;      // the control points that it reads
  std::uint32_t output_points = 0;     // and those that it writes
  std::optional<float> max_factor;
  friend bool operator==(const TessellationFact&, const TessellationFact&) = default;
};

struct StageFacts {
  std::string entry = {}, profile = {};
  std::string stage = {};  // "pixel"
  bool draws_pixels = false;
  bool is_named = false;  // the JSON says which stage it is: a vertex shader is the usual one
  std::vector<VariableFact> inputs = {}, outputs = {};
  std::vector<BufferFact> buffers = {};
  std::vector<StructFact> structs = {};  // inner before outer
  std::vector<ResourceFact> resources = {};
  HostFact host = {};
  std::optional<GroupFact> group = {};
  std::optional<EmissionFact> emission = {};
  std::optional<TessellationFact> tessellation = {};
  bool tests_early = false;
  friend bool operator==(const StageFacts&, const StageFacts&) = default;
};

// The clip planes and the position, of a stage with a stage after it.
struct PlaneFacts {
  Lowering lowering = Lowering::kNone;
  PlaneSpace space = PlaneSpace::kClip;
  std::optional<int> position_matrices = {};         // PositionMatrices
  std::optional<std::string> position_product = {};  // likewise
  std::vector<clip_table::Plane> planes;
  std::uint32_t enable_mask = 0, clip_distance_mask = 0, cull_distance_mask = 0;
  friend bool operator==(const PlaneFacts&, const PlaneFacts&) = default;
};

struct Facts {
  std::string target = {};
  std::vector<StageFacts> stages = {};  // the shader, and the pixel shader of a pair
  std::optional<PlaneFacts> planes = {};
  friend bool operator==(const Facts&, const Facts&) = default;
};

}  // namespace clipc
