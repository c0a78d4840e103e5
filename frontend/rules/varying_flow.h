// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <vector>

#include "frontend/rules/names.h"

namespace clipc::rules {

// What is asked of a program's calls of objects and of built-in functions: about the invocations
// that should run some of them together, the pixels of a quad or the threads of a group.
struct FlowQuestion {
  // Whether an input may have several values in them.
  bool (*differs)(const Program& program, const IoVar& input);
  // Whether what a node itself gives may differ, whatever its operands are.
  bool (*may_give_several)(const Program& program, ExprId expr);
  // Whether they should run the node together.
  bool (*is_asked)(const Program& program, ExprId expr);
};

// A node that is asked about.
struct AskedNode {
  ExprId expr;
  bool flow_varies = false;   // it runs in flow that some of them may not come to
  bool loop_varies = false;   // in a loop whose iterations may differ
  bool value_varies = false;  // its operands may have several values
};

// Finds the nodes that are asked about, in the order of the text. Flow varies where a condition
// follows from something that may differ, and after a `return` in such flow. What a group shares is
// the same for its threads, wherever they wrote it. Needs time linear in the program.
std::vector<AskedNode> FollowFlow(const Program& program, const FlowQuestion& question);

}  // namespace clipc::rules
