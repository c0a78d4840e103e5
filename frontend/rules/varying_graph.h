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
  explicit VaryingGraph(std::size_t named) : newest_(2 + named, kNone) {}

  Node Add() {
    newest_.push_back(kNone);
    return static_cast<Node>(newest_.size() - 1);
  }
  void Follow(Node from, Node to) {
    if (from == kUniform || to == kUniform || from == to) return;
    edges_.push_back({to, newest_[from]});
    newest_[from] = static_cast<std::uint32_t>(edges_.size() - 1);
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
    std::vector<bool> varies(newest_.size());
    std::vector<Node> open = {kVarying};
    varies[kVarying] = true;
    while (!open.empty()) {
      const Node from = open.back();
      open.pop_back();
      for (std::uint32_t edge = newest_[from]; edge != kNone; edge = edges_[edge].older) {
        const Node to = edges_[edge].to;
        if (!varies[to]) open.push_back(to);
        varies[to] = true;
      }
    }
    return varies;
  }

 private:
  static constexpr std::uint32_t kNone = UINT32_MAX;
  struct Edge {
    Node to;              // it follows from the node that has the edge
    std::uint32_t older;  // the edge before it of that node
  };

  std::vector<Edge> edges_;
  std::vector<std::uint32_t> newest_;  // by node: its last edge
};

}  // namespace clipc::rules
