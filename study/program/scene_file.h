// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <string>

#include "study/scene.h"

namespace clipc::study {

// The order that `one_matrix` of a scene names in words; none for other words.
std::optional<runtime::MatrixOrder> OrderNamed(const std::string& name);
inline constexpr char kUnknownOrder[] =
    "is neither true, false, \"world-view\", \"three\", \"float\" nor \"float-world-view\"";

// Reads a scene, JSON or glTF 2.0, as docs/scene.md describes it. Throws DrawError with the file
// and the reason where it is wrong.
Scene ReadScene(const std::string& path);

}  // namespace clipc::study
