// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <string>
#include <vector>

#include "tools/draw/inputs.h"

// Parsers of values on clipc-draw's command line. All throw DrawError for text that they do not
// understand.
namespace clipc::draw {

// "a,b" => "a", "b"
std::vector<std::string> Split(const std::string& text, char separator);

// Parses numbers, "1,-0.5,3i,7u,0x7fc00000": floats, ints, uints, raw bits; "identity" is a
// float4x4.
Words ParseWords(const std::string& text);

// Parses a plane, "1,0,0,-0.5".
std::array<double, 4> ParsePlane(const std::string& text);

// Adds an attribute, "in_POSITION0=1,2,3/4,5,6": the values of the vertices, separated by slashes.
// All attributes have the same number of vertices.
void AddAttribute(const std::string& text, Inputs& inputs);

// Adds bytes of a uniform block, "Transform@64=1,0,0,0": those from offset 64 on. The same block
// may be written several times.
void AddBlock(const std::string& text, Inputs& inputs);

// Adds a uniform outside of blocks, "tint=1,0,0,0"; matrices column by column.
void AddUniform(const std::string& text, Inputs& inputs);

}  // namespace clipc::draw
