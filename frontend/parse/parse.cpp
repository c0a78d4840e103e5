// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/parse/parse.h"

#include <utility>

#include "frontend/parse/parser.h"

namespace clipc {

ast::File Parse(Tokens tokens, Diagnostics& diagnostics, FunctionBodies bodies,
                const EffectParts& effect) {
  return ast::Parser(std::move(tokens), diagnostics, bodies, effect).Run();
}

}  // namespace clipc
