// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/signature/distances.h"

#include <algorithm>

namespace clipc::signature {

std::vector<ExprId> Distances::Packed(bool has_gaps) {
  std::ranges::stable_sort(pieces_, {}, &Piece::index);
  std::vector<ExprId> elements;
  for (const Piece& piece : pieces_) {
    while (has_gaps && elements.size() % 4 + piece.components.size() > 4) elements.emplace_back();
    elements.insert(elements.end(), piece.components.begin(), piece.components.end());
  }
  return elements;
}

bool FitWithGaps(Distances& clip, Distances& cull) {
  return clip.Packed(true).size() + cull.Packed(true).size() <= kMaxDistances;
}

}  // namespace clipc::signature
