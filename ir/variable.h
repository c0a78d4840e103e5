// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/span.h"
#include "ir/ids.h"
#include "ir/type.h"

// Variables and functions.
namespace clipc::ir {

enum class Storage : std::uint8_t {
  kLocal,
  kIn,        // a parameter
  kOut,       // a parameter that is copied out after the call
  kInOut,     // a parameter that is copied in before the call and out after it
  kStatic,    // a global that may change: `static float x = ...;`
  kShared,    // a global that all threads of a group have together: `groupshared`; without init
  kConstant,  // `static const`, or a const local with a constant value: init is constant
  kUniform,   // a member of a Cbuffer
  kResource,  // a texture, sampler or buffer object, or an array of them
  kInput,     // of the whole shader: only `main` reads it, but for IsReadAnywhere and interpolants
  kOutput,    // of the whole shader: only `main` touches it
};

struct Var {
  std::string name;  // as written; the back end makes it legal and unique
  TypeId type = {};
  Storage storage = Storage::kLocal;
  Span span = {};
  ExprId init = {};        // of kStatic and kConstant
  CbufferId cbuffer = {};  // of kUniform
  // The number in [[vk::constant_id(..)]], of a kStatic variable that nothing assigns. Vulkan may
  // give it another value than `init` when it makes a pipeline.
  std::optional<std::uint32_t> constant_id = {};
  bool row_major = false;
  bool precise = false;
  // Of kResource: what one invocation stores in the object, others may read: `globallycoherent`.
  bool coherent = false;
};

struct Function {
  std::string name;
  TypeId return_type;
  std::vector<VarId> parameters;
  StmtId body;  // a Block
  Span span;
  // Whether a pass made the function, which reads and writes nothing but its parameters and its own
  // variables; and a buffer, if it is an accessor.
  bool is_helper = false, is_accessor = false;
  bool precise = false;  // its result is precise; SpreadPrecise makes variables precise instead
  std::string_view remark = {};  // for readers of a helper function, after its last statement
  // Of an accessor that reads a member of a constant buffer: the member's first byte in the buffer.
  std::optional<std::uint32_t> offset = {};
};

}  // namespace clipc::ir
