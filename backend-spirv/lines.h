// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <functional>
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>

#include "backend-spirv/module.h"
#include "backend-spirv/types.h"
#include "backend-spirv/write.h"

namespace clipc::spirv {

// The lines of the source that instructions are of. Nothing happens without a `debug`, which
// outlives it.
class Lines {
 public:
  Lines(Module& module, Types& types, const Debug* debug)
      : module_(module), types_(types), debug_(debug) {}

  bool has_any() const { return debug_ != nullptr; }
  // Names the source and the compiler, before all functions.
  void Start();
  // Begins a function, whose body `code` is to be; before its definition.
  void StartFunction(const ir::Function& function, Ref definition, Words& code);
  // The line of what is written next, and what it was until now.
  void Want(Span span);
  const SourcePlace& wanted() const { return wanted_; }
  void Restore(const SourcePlace& place) { wanted_ = place; }
  // Whether a line may be written before the instruction: OpLine alone may stand before an OpPhi.
  bool MayPrecede(spv::Op op) const { return op != spv::Op::OpPhi || !HasSet(); }
  // Writes the line before an instruction whose line is another than that of the one before it.
  void Put(Words& code);
  // A line holds until the end of the block.
  void EndBlock() { line_ = {}; }

 private:
  struct File {
    Ref name = 0, source = 0;
  };
  bool HasSet() const { return debug_->form == Debug::Form::kSet; }
  const File& FileOf(std::string_view name);
  void PutInSet(Words& code, std::uint32_t instruction, std::initializer_list<Ref> operands);

  Module& module_;
  Types& types_;
  const Debug* debug_;
  std::map<std::string, File, std::less<>> files_;
  Ref unit_ = 0, type_ = 0, scope_ = 0;
  SourcePlace line_, wanted_;  // of the last instruction, and of the next
};

}  // namespace clipc::spirv
