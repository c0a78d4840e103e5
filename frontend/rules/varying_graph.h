// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace clipc::rules {

// A graph of what follows from what: variables, results of functions, and places in the flow. A
// node varies if it follows from the node kVarying.
class VaryingGraph {
 public:
  using Node = std::uint32_t;
  static constexpr Node kUniform = 0, kVarying = 1;

  // `named` nodes of the caller's own come after these two.
  explicit VaryingGraph(std::size_t named) : edges_(2 + named) {}

  Node Add() {
    edges_.emplace_back();
    return static_cast<Node>(edges_.size() - 1);
  }
  void Follow(Node from, Node to) {
    if (from != kUniform && to != kUniform && from != to) edges_[from].push_back(to);
  }
  // A node that follows from both.
  Node Join(Node a, Node b) {
    if (a == kUniform || b == kUniform || a == b) return a == kUniform ? b : a;
    const Node both = Add();
    Follow(a, both);
    Follow(b, both);
    return both;
  }
  // By node: whether it varies.
  std::vector<bool> Varying() const {
    std::vector<bool> varies(edges_.size());
    std::vector<Node> open = {kVarying};
    varies[kVarying] = true;
    while (!open.empty()) {
      const Node from = open.back();
      open.pop_back();
      for (const Node to : edges_[from]) {
        if (!varies[to]) open.push_back(to);
        varies[to] = true;
      }
    }
    return varies;
  }

 private:
  std::vector<std::vector<Node>> edges_;  // by node: those that follow from it
};

}  // namespace clipc::rules
