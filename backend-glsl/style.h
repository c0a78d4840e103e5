// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "ir/interface.h"

// The forms and names of constant buffers and outputs, chosen so that the next stage's shader,
// which another tool wrote, links with this one. GLSL compares blocks of two stages by name and by
// members with their matrix layouts, and both blocks have an instance name or neither has one;
// outputs that have no location match inputs by name.
namespace clipc::glsl {

// The form of a constant buffer where the target has uniform blocks.
enum class BlockStyle : std::uint8_t {
  kNamed,  // a block with an instance name; its members have the matrix layouts
  kPlain,  // a block whose members are global names; the block has the matrix layout
  kFlat,   // uniform variables outside blocks
};

// Patterns that names are made from. A pattern has places for parts of a name:
//   of outputs: {semantic}, in capitals; {index} of the semantic; {written}: the semantic as it is
//   written, with its index if that is written; {name} of the field or parameter;
//   of blocks: {name} of the buffer; {type}: T of ConstantBuffer<T>.
struct NameStyle {
  std::string output = "vs_{semantic}{index}";
  std::string block = "{name}";
  std::string globals = "Globals";  // the block of $Globals
  std::string constant_buffer = "{name}_block";

  // Returns the style called "hlslcc" (HLSLcc's and clipc's own), "dxc" (DXC to SPIR-V, then
  // SPIRV-Cross) or "spirv-cross" (glslang to SPIR-V, then SPIRV-Cross), or clipc's own with the
  // text as the pattern for outputs, which needs a place for the semantic or the name; none for
  // other texts.
  static std::optional<NameStyle> Parse(std::string_view text);
  static std::span<const std::string_view> Names();
};

// The name that the style gives an output of the stage, or an input of the stage after it. Those of
// a stage that emits vertices differ from the names of its inputs by "gs_".
std::string InterfaceName(const ir::IoVar& output, const NameStyle& style, const StageInfo& writer);

// The pattern with its places filled; a place that `values` lacks is kept.
std::string FillPattern(
    std::string_view pattern,
    std::initializer_list<std::pair<std::string_view, std::string_view>> values);

// A name for an instance of the block that differs from the block's: "PerFrame" is called
// "perFrame", "cbScene" "scene", "UBOScene" "uboScene", and "light" "light_data".
std::string InstanceName(std::string_view block);

}  // namespace clipc::glsl
