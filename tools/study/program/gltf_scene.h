// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "tools/study/scene.h"

namespace clipc::study {

// A glTF 2.0 scene, from the text of a .gltf file or the bytes of a .glb one; buffers beside it lie
// in `folder`. docs/study.md says what of it is taken, and how planes are marked. The file may hold
// anything: throws DrawError with the place and what is wrong there.
//
// glTF's space is right-handed and its cameras look along -z; the scene's is left-handed. So the
// world is mirrored: its z is glTF's -z. Boxes stay in the space of their own mesh.
Scene GltfScene(const std::string& bytes, const std::string& folder);

}  // namespace clipc::study
