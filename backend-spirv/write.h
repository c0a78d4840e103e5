// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/span.h"
#include "ir/program.h"

// SPIR-V for Vulkan or OpenGL, word by word out of a program.
namespace clipc::spirv {

// Where the interface of the shader lies, which both forms of its output share: the names and
// places that the GLSL has.
struct Interface {
  struct Variable {
    std::string_view name;
    std::optional<std::uint32_t> location;  // none: built in
    bool is_used = true;
    bool keeps_base = false;  // of a number of a vertex or instance: that of the first is a part
  };
  struct Place {
    std::uint32_t set = 0;
    std::optional<std::uint32_t> binding;  // none: the writer lacks it
  };
  struct Block : Place {
    ir::CbufferId cbuffer;
    std::string_view name;
    bool is_push_constant = false;
    std::string user_type = {};  // "constantbuffer:<Frame>"; empty: none
  };
  struct Object : Place {
    ir::VarId var;      // a texture, a sampler, or both in one; a buffer
    ir::VarId sampler;  // the sampler that OpenGL puts together with the texture
    std::string_view name;
    std::string format = {};  // of an image that is written, in GLSL's spelling
    std::optional<std::uint32_t> input_attachment = {};  // of a subpass
    std::string user_type = {};                          // "texture2d:<float4>"
  };
  std::vector<Variable> inputs, outputs;  // beside program.inputs and program.outputs
  std::vector<Block> blocks;
  std::vector<Object> objects;
};

// A place in the source, as #line says; line 0: there is none.
struct SourcePlace {
  std::string file;
  std::uint32_t line = 0, column = 0;
};

// What a debugger is told of the source.
struct Debug {
  enum class Form : std::uint8_t {
    kCore,  // OpSource and OpLine
    kSet,   // the instructions of NonSemantic.Shader.DebugInfo.100
  };
  Form form = Form::kCore;
  bool has_text = true, has_lines = true, has_tool = false;
  std::string file;       // the name of the main file
  std::string_view text;  // that of the main file
  std::string tool;       // the compiler and its version
  std::function<SourcePlace(Span)> place;
};

struct Options {
  std::uint32_t minor_version = 3;    // of SPIR-V 1.x
  std::string entry = "main";         // the name of the entry point
  bool invariant = false;             // the position is invariant
  bool keeps_bindings = false;        // objects and buffers that nothing reads are declared too
  bool relaxed_precision = false;     // of half and of the types of minimum precision
  bool is_opengl = false;             // for OpenGL 4.5 and GL_ARB_gl_spirv, else for Vulkan
  bool has_upper_left_origin = true;  // of pixels; derivatives have the same direction
  bool has_reflection = false;        // variables have their semantics and the names of their types
  std::optional<Debug> debug = {};
};

struct Written {
  std::vector<std::uint32_t> words;  // the module; empty where the writer lacks something
  // What the writer lacks, as the rest of "it has ...". Empty exactly if there are words.
  std::string_view lacks;
};

// Requires Form::kAddressed for Vulkan or for OpenGL from 4.2 on. The result depends on nothing but
// the arguments.
Written Write(const ir::Program& program, const Interface& interface, const Options& options);

}  // namespace clipc::spirv
