// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <utility>

#include "backend-glsl/reserved_words.h"
#include "backend-glsl/snippets.h"
#include "backend-glsl/writer_state.h"
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

namespace {

constexpr std::string_view kParameters[] = {"a", "b", "c", "d"};

}  // namespace

Text Writer::ByRows(std::string_view name, std::span<const Operand> operands, const Shape& result,
                    const Apply& apply) {
  std::string key, parameters;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    key += TypeName(operands[i].shape) + " ";
    parameters += (i > 0 ? ", " : "") + Declaration(operands[i].shape, kParameters[i]);
  }
  const std::string helper = Helper(name, key, [&](const std::string& function) {
    std::string rows;
    for (int row = 0; row < result.rows; ++row) {
      std::vector<Operand> parts;
      for (std::size_t i = 0; i < operands.size(); ++i) {
        const std::string text = std::string(kParameters[i]) + "[" + std::to_string(row) + "]";
        parts.push_back({{text}, operands[i].shape.Row(), std::nullopt, true});
      }
      rows += (row > 0 ? ", " : "") + Argument(apply(parts));
    }
    return TypeName(result) + " " + function + "(" + parameters + ") {\n    return " +
           TypeName(result) + "(" + rows + ");\n}\n";
  });
  return CallOn(helper, operands);
}

Text Writer::ByComponents(std::string_view name, std::span<const Operand> operands,
                          const Shape& result, const Apply& apply) {
  std::string key, parameters;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    key += TypeName(operands[i].shape) + " ";
    parameters += (i > 0 ? ", " : "") + Declaration(operands[i].shape, kParameters[i]);
  }
  const std::string helper = Helper(name, key, [&](const std::string& function) {
    std::string components;
    for (int c = 0; c < result.size; ++c) {
      std::vector<Operand> parts;
      for (std::size_t i = 0; i < operands.size(); ++i) {
        const std::string text = std::string(kParameters[i]) + "." + "xyzw"[c];
        parts.push_back({{text}, operands[i].shape.Component(), std::nullopt, true});
      }
      components += (c > 0 ? ", " : "") + Argument(apply(parts));
    }
    return TypeName(result) + " " + function + "(" + parameters + ") {\n    return " +
           TypeName(result) + "(" + components + ");\n}\n";
  });
  return CallOn(helper, operands);
}

Text Writer::Snippet(std::string_view name, std::span<const Operand> operands,
                     const Shape& result) {
  const SnippetText* snippet = FindSnippet(name, operands[0].shape);
  CLIPC_CHECK(snippet != nullptr);
  if (snippet->scalar_only && operands[0].shape.IsVector()) {
    return ByComponents(name, operands, result, [&](std::span<const Operand> parts) {
      return Snippet(name, parts, result.Component());
    });
  }
  const Shape& shape = operands[0].shape;
  const std::string helper = Helper(name, TypeName(shape), [&](const std::string& function) {
    return Expand(*snippet, function, shape, target_.HasUnsigned(), [&](std::string_view other) {
      if (target_.HasRounding() && IsBuiltinFunction(other)) return std::string(other);
      const Operand argument{{"x"}, shape, std::nullopt, true};
      const std::string call = Snippet(other, {&argument, 1}, shape).text;
      return call.substr(0, call.find('('));
    });
  });
  return CallOn(helper, operands);
}

}  // namespace clipc::glsl
