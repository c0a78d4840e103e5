// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory_resource>
#include <string>
#include <string_view>
#include <utility>

#include "frontend/signature/semantics.h"
#include "frontend/signature/signature_leaves.h"

namespace clipc::signature {

// The rules about the semantics of a shader's inputs and outputs. What breaks one is reported.
class SemanticCheck {
 public:
  SemanticCheck(const Program& program, PositionName position, Diagnostics& diagnostics)
      : program_(program), position_(position), diagnostics_(diagnostics) {}

  // The meaning of the leaf's semantic on one side of the stage.
  SystemValue LookUp(const Carrier& leaf, Direction direction);
  // The next outputs are those of another stream, which may have the same semantics.
  void NextStream() { seen_[static_cast<std::size_t>(Direction::kOutput)].clear(); }
  // The next inputs are those of another function, which may have the same semantics.
  void NextFunction() { seen_[static_cast<std::size_t>(Direction::kInput)].clear(); }
  // Whether the leaf may be an input or output beside those that were asked about before.
  bool MayAdd(const Carrier& leaf, Direction direction, const SystemValue& value);
  // Whether the profile lacks the input of a pixel shader, which may be declared and is not read.
  // Level 9 has no system values, and ps_2_0 to ps_2_b neither VPOS nor VFACE.
  bool Lacks(const Cursor& cursor, const SystemValue& value) const;
  // Whether a pixel can go to the render target of the semantic's index.
  bool IsTarget(const Carrier& leaf);
  // Reports a leaf that is not of the wanted type.
  void Refuse(const Carrier& leaf, std::string_view wanted);
  // Reports an output POSITION from 4.0 on, which is most likely meant to be the position.
  // Where the file has a hull or geometry shader too, that may write the position.
  void CheckPosition(bool has_later_stage);
  // Reports an interpolation that the leaf's type or the profile does not have.
  void CheckInterpolation(const Carrier& leaf);

 private:
  // A pixel has one depth, whatever the names of its outputs are.
  bool IsFirstDepth(const Carrier& leaf);
  const Program& program_;
  PositionName position_;
  Diagnostics& diagnostics_;
  // A signature has a few semantics; nodes for those lie here.
  std::array<std::byte, 2048> first_memory_;
  std::pmr::monotonic_buffer_resource memory_{first_memory_.data(), first_memory_.size()};
  struct First {
    Span span;
    TypeId type;
  };
  using Seen = std::pmr::map<std::pair<std::string, std::uint32_t>, First>;  // by name and index
  Seen seen_[3] = {Seen(&memory_), Seen(&memory_), Seen(&memory_)};          // by Direction
};

}  // namespace clipc::signature
