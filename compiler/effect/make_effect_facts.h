// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <memory>
#include <vector>

#include "compiler/batch/batch_index.h"
#include "compiler/command/command_line.h"
#include "compiler/effect/effect_facts.h"
#include "compiler/effect/effect_passes.h"

namespace clipc {

// Describes an effect. `entries` and `code` are those of the groups of its programs; the code of
// one that has errors is null.
EffectFacts MakeEffectFacts(const ast::Effect& effect, const EffectPrograms& programs,
                            const CommandLine& command, const std::vector<BatchEntry>& entries,
                            const std::vector<std::shared_ptr<const EffectCode>>& code);

}  // namespace clipc
