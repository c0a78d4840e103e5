// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-spirv/emitter.h"

namespace clipc::spirv {

using ir::Scalar;

Emitter::Emitter(const ir::Program& program, const Options& options)
    : program_(program),
      options_(options),
      module_(options.minor_version),
      types_(program, module_, options.relaxed_precision),
      lines_(module_, types_, options.debug ? &*options.debug : nullptr) {
  code_.reserve(1024);
  locals_.reserve(128);
}

Ref Emitter::Emit(spv::Op op, Ref type, std::span<const std::uint32_t> operands) {
  if (lines_.has_any() && lines_.MayPrecede(op)) lines_.Put(code_);
  const Ref result = last_ = module_.NewRef();
  code_.push_back(static_cast<std::uint32_t>(operands.size() + 3) << 16 | NumberOf(op));
  code_.push_back(type);
  code_.push_back(result);
  code_.insert(code_.end(), operands.begin(), operands.end());
  return result;
}

Ref Emitter::Emit(spv::Op op, Ref type, std::initializer_list<std::uint32_t> operands) {
  return Emit(op, type, std::span(operands.begin(), operands.size()));
}

Ref Emitter::Compute(spv::Op op, Ref type, std::initializer_list<std::uint32_t> operands) {
  const Ref result = Emit(op, type, operands);
  if (is_precise_) module_.Decorate(result, spv::Decoration::NoContraction);
  return result;
}

Ref Emitter::Compose(Ref type, std::span<const Ref> parts) {
  if (parts.empty()) return module_.Constant(spv::Op::OpConstantNull, type);  // an empty struct
  return Emit(spv::Op::OpCompositeConstruct, type, parts);
}

Ref Emitter::Part(Ref type, Ref of, std::uint32_t number) {
  return Emit(spv::Op::OpCompositeExtract, type, {of, number});
}

Ref Emitter::Lack(std::string_view what) {
  if (lacks_.empty()) lacks_ = what;
  return module_.NewRef();
}

void Emitter::Label(Ref label) {
  Do(spv::Op::OpLabel, {label});
  block_ = label;
  is_open_ = true;
  lines_.EndBlock();
}

void Emitter::Branch(Ref label) {
  if (is_open_) Do(spv::Op::OpBranch, {label});
  is_open_ = false;
}

void Emitter::Branch(Ref condition, Ref when_true, Ref when_false) {
  Do(spv::Op::OpBranchConditional, {condition, when_true, when_false});
  is_open_ = false;
}

void Emitter::Repeat(std::uint32_t count, const std::function<void(Ref)>& body) {
  const Ref header = module_.NewRef(), start = module_.NewRef(), next = module_.NewRef(),
            merge = module_.NewRef(), number = module_.NewRef(), following = module_.NewRef();
  const Ref type = types_.Of(Scalar::kInt);
  const Ref before = block_;
  Branch(header);
  Label(header);
  Put(code_, spv::Op::OpPhi, {type, number, types_.Int(0), before, following, next});
  const Ref goes_on = Emit(spv::Op::OpSLessThan, types_.Of(Scalar::kBool),
                           {number, types_.Int(static_cast<std::int32_t>(count))});
  Do(spv::Op::OpLoopMerge, {merge, next, 0});
  Branch(goes_on, start, merge);
  Label(start);
  body(number);
  Branch(next);
  Label(next);
  Put(code_, spv::Op::OpIAdd, {type, following, number, types_.Int(1)});
  Branch(header);
  Label(merge);
}

}  // namespace clipc::spirv
