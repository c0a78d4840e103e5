// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "compiler/plan.h"

namespace clipc {

// Returns the main file with the clip planes of the request's entry points as clip distances; the
// file itself if they have none. Only what the signatures and the planes name is read: elsewhere
// the file may have what clipc does not know. `watch` may be null.
std::string RewriteHlsl(const CompileRequest& request, const Plan& plan, Source& source,
                        Watch* watch, Diagnostics& diagnostics);

}  // namespace clipc
