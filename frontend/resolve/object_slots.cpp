// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/resolve/object_slots.h"

#include <algorithm>

#include "ir/access.h"

namespace clipc::resolve {

Slots Inside(const Slots& slots, std::uint32_t part) {
  Slots inner;
  for (const auto& [path, object] : slots) {
    if (path.empty()) {
      ObjectPath element = object;
      element.indices.push_back({part, {}, {}});
      inner[{}] = std::move(element);
    } else if (path.front() == part) {
      inner[SlotPath(path.begin() + 1, path.end())] = object;
    }
  }
  return inner;
}

void AddUnder(Slots& slots, std::uint32_t part, const Slots& inner) {
  for (const auto& [path, object] : inner) {
    SlotPath whole{part};
    whole.insert(whole.end(), path.begin(), path.end());
    slots[whole] = object;
  }
}

Slots InsideAny(const Slots& slots, std::uint32_t count) {
  Slots shared = Inside(slots, 0);
  for (std::uint32_t i = 1; i < count && !shared.empty(); ++i) {
    const Slots other = Inside(slots, i);
    std::erase_if(shared, [&](const auto& slot) {
      const auto found = other.find(slot.first);
      return found == other.end() || found->second != slot.second;
    });
  }
  return shared;
}

bool StartsWith(const SlotPath& path, const SlotPath& prefix) {
  return path.size() >= prefix.size() && std::equal(prefix.begin(), prefix.end(), path.begin());
}

bool IsObjectType(const TypeTable& types, TypeId type) {
  return types[types.Innermost(type)].kind == TypeKind::kObject;
}

}  // namespace clipc::resolve
