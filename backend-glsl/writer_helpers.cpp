// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <utility>

#include "backend-glsl/reserved_words.h"
#include "backend-glsl/snippets.h"
#include "backend-glsl/writer.h"
#include "base/invariant.h"

namespace clipc::glsl {

using namespace ir;

std::string Writer::Helper(std::string_view name, const std::string& key,
                           const std::function<std::string(const std::string&)>& define) {
  NotConstant();
  auto found = helper_names_.find(std::string(name));
  if (found == helper_names_.end()) {
    found = helper_names_.emplace(std::string(name), namer_.Global(name, "helper")).first;
  }
  const std::string glsl_name = found->second;
  if (helper_keys_.insert(std::string(name) + "|" + key).second) {
    // What the definition itself needs is appended first.
    const std::string definition = define(glsl_name);
    helpers_ += definition + "\n";
  }
  return glsl_name;
}

std::string Writer::Fresh(std::string_view wanted) {
  namer_.OpenScope();
  std::string name = namer_.Local(wanted);
  namer_.CloseScope();
  return name;
}

Text Writer::CallOn(std::string_view function, std::span<const Operand> operands) {
  return CallOn(function, operands, 0);
}

// Bit i of `scalars`: argument i may be a scalar beside vectors; all such arguments must be.
Text Writer::CallOn(std::string_view function, std::span<const Operand> operands,
                    unsigned scalars) {
  bool all_scalar = true;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    if ((scalars >> i & 1) != 0 && !operands[i].scalar) all_scalar = false;
    if ((scalars >> i & 1) == 0 && operands[i].scalar && scalars != 0) all_scalar = false;
  }
  std::string text;
  text.reserve(64);
  text.append(function) += '(';
  for (std::size_t i = 0; i < operands.size(); ++i) {
    if (i > 0) text += ", ";
    const bool as_scalar = all_scalar && (scalars >> i & 1) != 0;
    const Operand& operand = operands[i];
    if (operand.scalar && !as_scalar) {
      text += Argument(Full(operand));
    } else {
      const Text& plain = as_scalar ? *operand.scalar : operand.text;
      const bool is_comma = plain.binding < Binding::kAssignment;
      Append(text, is_comma ? "(" : "", plain.text, is_comma ? ")" : "");
    }
  }
  text += ')';
  return {std::move(text)};
}

Text Writer::SnippetCall(std::string_view name, std::span<const Operand> operands) {
  const SnippetText* snippet = FindSnippet(name, operands[0].shape);
  CLIPC_CHECK(snippet != nullptr);
  return CallOn(SnippetName(*snippet, operands[0].shape), operands);
}

std::string Writer::SnippetName(const SnippetText& snippet, const Shape& shape) {
  return Helper(snippet.name, TypeName(shape), [&](const std::string& function) {
    return Expand(snippet, function, shape, target_.Has(Feature::kUnsigned),
                  [&](std::string_view other) {
                    if (target_.Has(Feature::kRounding) && IsBuiltinFunction(other)) {
                      return std::string(other);
                    }
                    const SnippetText* found = FindSnippet(other, shape);
                    CLIPC_CHECK(found != nullptr);
                    return SnippetName(*found, shape);
                  });
  });
}

// Types that differ in HLSL, as half and float, are the same here: the first such function is it.
std::string Writer::HelperFunction(FunctionId id) {
  const Function& function = program_.functions[id];
  std::string key;
  for (VarId parameter : function.parameters) key += TypeName(program_.vars[parameter].type) + " ";
  return Helper(function.name, key, [&](const std::string& name) {
    function_names_[id.index] = name;
    std::string text;
    std::string* const out = std::exchange(out_, &text);
    const int indent = std::exchange(indent_, 0);
    const bool is_constant = constant_;
    in_helper_ = true;
    OneFunction(id);
    in_helper_ = false;
    constant_ = is_constant;
    indent_ = indent;
    out_ = out;
    return text;
  });
}

}  // namespace clipc::glsl
