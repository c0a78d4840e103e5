// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <span>
#include <string_view>

#include "backend-spirv/lines.h"
#include "backend-spirv/module.h"
#include "backend-spirv/types.h"
#include "backend-spirv/write.h"

namespace clipc::spirv {

// The function that is being written: its instructions go to the end of the current block.
class Emitter {
 protected:
  Emitter(const ir::Program& program, const Options& options);

  Ref Emit(spv::Op op, Ref type, std::initializer_list<std::uint32_t> operands);
  Ref Emit(spv::Op op, Ref type, std::span<const std::uint32_t> operands);
  // The same for an instruction that computes with floats: NoContraction for a precise value.
  Ref Compute(spv::Op op, Ref type, std::initializer_list<std::uint32_t> operands);
  void Do(spv::Op op, std::initializer_list<std::uint32_t> operands) {
    if (lines_.has_any() && op != spv::Op::OpLabel) lines_.Put(code_);
    Put(code_, op, operands);
  }
  Ref Compose(Ref type, std::span<const Ref> parts);
  Ref Part(Ref type, Ref of, std::uint32_t number);

  // ---- control flow
  void Label(Ref label);
  void Branch(Ref label);
  void Branch(Ref condition, Ref when_true, Ref when_false);
  // Writes a loop. The body gets the number of the iteration, an int.
  void Repeat(std::uint32_t count, const std::function<void(Ref)>& body);

  // Says what the writer lacks; the module is not finished then. Returns a result to go on with.
  Ref Lack(std::string_view what);

  const ir::Program& program_;
  const Options& options_;
  Module module_;
  Types types_;
  Lines lines_;
  std::string_view lacks_;
  Words code_, locals_;   // of the current function, as what follows
  Ref block_ = 0;         // the label of the current block
  bool is_open_ = false;  // the current block has no end yet
  bool is_precise_ = false;
  Ref last_ = 0;  // the result of the last instruction
};

}  // namespace clipc::spirv
