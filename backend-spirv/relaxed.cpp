// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Values and variables that may have 16 bits.
#include "backend-spirv/writer.h"

namespace clipc::spirv {

using namespace ir;

void Writer::Relax(Ref of, TypeId type) {
  if (types_.IsRelaxed(type)) module_.Decorate(of, spv::Decoration::RelaxedPrecision);
}

// Relaxes the value of an expression. The value of an operand, which a conversion between kinds
// that are one in the module gives as it is, keeps the precision of the operand.
void Writer::RelaxResult(Ref value, TypeId type) {
  if (value == last_ && value != judged_) Relax(value, type);
  judged_ = value;
}

}  // namespace clipc::spirv
