// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "study/scene.h"

namespace clipc::study {

// Reads a glTF 2.0 scene from the text of a .gltf file or the bytes of a .glb one; its buffers are
// files in `folder`. docs/scene.md says which parts of it are read, and how planes are marked.
// Throws DrawError with the place and the reason where the file is wrong; it may hold anything.
//
// glTF's space is right-handed and its cameras look along -z; the scene's space is left-handed. So
// the world is mirrored: its z is glTF's -z. Boxes stay in the space of their own mesh.
Scene GltfScene(const std::string& bytes, const std::string& folder);

}  // namespace clipc::study
