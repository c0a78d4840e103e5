// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "backend-glsl/target.h"
#include "backend-glsl/writer/code.h"

namespace clipc::glsl {

// The feature that a function across the lanes of a wave or a quad needs.
Feature FeatureOfWave(ir::Intrinsic op);

// Writes a call of such a function with GLSL's of subgroups.
Binding WriteWave(Code& code, const ir::IntrinsicCall& node);

}  // namespace clipc::glsl
