// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "study/scene.h"

namespace clipc::study {

// Reads a scene, JSON or glTF 2.0, as study/study.md describes it. Throws DrawError with the file
// and the reason where it is wrong.
Scene ReadScene(const std::string& path);

}  // namespace clipc::study
