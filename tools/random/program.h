// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/stage.h"
#include "tools/random/choices.h"
#include "tools/random/features.h"
#include "tools/random/type.h"

namespace clipc::random {

// The error allowed in programs with functions that round, in units of 2^-24 of an output's size:
// 2^-10. Vulkan's "Precision and Operation of SPIR-V Instructions" allows sin and cos an error of
// 2^-11 and atan one of 4096 units, and an output adds two functions at most (soft.cpp).
inline constexpr int kSoftUlps = 1 << 14;

// A member of a constant buffer as the program declares it.
struct Member {
  std::string name;
  Type type;
  bool row_major = false;
  int packoffset = -1;  // bytes; -1: where the rules put it
};
struct ConstantBuffer {
  std::string name;
  std::vector<Member> members;
};

// An HLSL shader without errors and without undefined values, and how it is to be compiled.
struct Program {
  std::string text;
  Stage stage = Stage::kVertex;
  std::string profile = "vs_5_0";
  std::string lowering = "clip-distance", plane_space = "clip", position_input = "POSITION0";
  bool row_major = false;  // -Zpr
  bool negative_one_to_one = false, flip_y = false;
  bool is_soft = false;      // has functions that round
  std::uint32_t inputs = 1;  // the seed of its inputs
  std::uint32_t target = 0;  // the number of the target that is drawn
  int vertices = 16;         // of a vertex shader
  Structs structs;
  std::vector<ConstantBuffer> buffers;

  // The options that clipc-draw compare needs for the program.
  std::string Options() const;
};

Program MakeProgram(Choices& choices, const Features& features);

}  // namespace clipc::random
