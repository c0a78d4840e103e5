// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "frontend/signature/names.h"

// The semantics of a shader's inputs and outputs. Sources: the Direct3D 11.3 functional
// specification, sections 8 and 9 (system generated and interpreted values); DXC's signature table,
// columns VSIn to CSIn; the Direct3D 9 reference on the inputs and outputs of vertex
// and pixel shaders.
namespace clipc::signature {

// The inputs and outputs of control points and of vertices are apart from the constants of a patch,
// which a hull shader writes, and which a domain shader reads with what it has for itself.
enum class Direction : std::uint8_t { kInput, kOutput, kPatchConstant };
constexpr bool IsInput(Direction direction, Stage stage) {
  return direction == Direction::kPatchConstant ? !InfoOf(stage).makes_patches
                                                : direction == Direction::kInput;
}

// The name of the position among the outputs from profile 4.0 on; before, it is POSITION.
enum class PositionName : std::uint8_t {
  kSystemValue,  // SV_Position; POSITION is a name like any other
  kBoth,         // SV_Position or POSITION: fxc's -Gec
  kStrict,       // SV_Position, and an output POSITION is an error: fxc's -Ges
};

struct SystemValue {
  enum class Use : std::uint8_t {
    kPlain,    // an ordinary input or output of that name
    kBuiltin,  // the built-in variable `builtin`
    kRefused,  // a system value of another stage
    kTarget,   // an output to the render target of the semantic's index
    kMade,     // an input that only other stages have; it may be declared and not read
    kLost,     // an output of the stage before that is not passed on
  };
  // What an input is made of the built-in variable.
  enum class Form : std::uint8_t {
    kItself,
    kCorner,  // the upper left corner of the pixel whose centre it is
    kSign,    // 1 if it is true, else -1
  };
  Use use = Use::kPlain;
  Builtin builtin = Builtin::kNone;
  int major = 0, minor = 0;  // the first profile that has the system value
  Form form = Form::kItself;
};

// The meaning of a semantic on one side of a stage. `name` does not have the index in it. `is_old`:
// the profile is Direct3D 9's.
SystemValue LookUpSemantic(std::string_view name, std::uint32_t index, Stage stage,
                           Direction direction, bool is_old,
                           PositionName position = PositionName::kSystemValue);

// Whether the input is a number of a thread or a group in x, y and z, of which a shader may take
// the leading components.
bool IsNumberOfThread(Builtin builtin);

// The system value that a user who wrote `name` probably meant; empty when none is near.
std::string_view NearSystemValue(std::string_view name, Stage stage, Direction direction);

// The end of a message: "; `-T gs_5_0` compiles a geometry shader", of the profile's model if the
// stage has it.
std::string CompiledBy(const StageInfo& stage, const Profile& profile);
// The same of an entry point of `stage` that takes an object of this type, which only another stage
// does. Empty where no stage that clipc reads takes one.
std::string AdviceForObject(std::string_view type, Stage stage, const Profile& profile);

// A semantic as written, taken apart: "TEXCOORD12" is {"TEXCOORD", 12}. Names compare without case.
struct SemanticName {
  std::string name;
  std::uint32_t index = 0;
  bool has_index = false;
};
SemanticName SplitSemantic(std::string_view written);

// Whether a pixel shader of ps_2_0 to ps_2_b lacks the input: it reads v0 and v1, which are
// colours, and t0 to t7 ("ps_2_0 registers" of the Direct3D 9 reference; fxc X4502, "invalid ps_2_0
// input semantic").
bool LacksInput(const Profile& profile, const SemanticName& semantic);
// The number of render targets of a pixel shader: "Overview of feature levels" of the Direct3D 11
// reference.
std::uint32_t TargetsOf(const Profile& profile);

// The output POSITION if it is not the position; otherwise null.
const IoVar* FindPlainPosition(const Program& program);

}  // namespace clipc::signature
