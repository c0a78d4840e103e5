// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/helper.h"

#include "backend-glsl/text.h"

namespace clipc::glsl {

std::string Fresh(WriterContext& context, std::string_view wanted) {
  context.namer.OpenScope();
  std::string name = context.namer.Local(wanted);
  context.namer.CloseScope();
  return name;
}

bool HasHelper(const WriterContext& context, std::string_view name, std::string_view key) {
  return context.helper_keys.contains(Concat(name, "|", key));
}

std::string Helper(WriterContext& context, std::string_view name, const std::string& key,
                   const DefineHelper& define) {
  const auto [found, is_new] = context.helper_names.try_emplace(std::string(name));
  if (is_new) found->second = context.namer.Global(name, "helper");
  std::string glsl_name = found->second;
  if (context.helper_keys.insert(Concat(name, "|", key)).second) {
    // Helpers that the definition needs are appended before it.
    const std::string definition = define(glsl_name);
    Append(context.helpers, definition, "\n");
  }
  return glsl_name;
}

}  // namespace clipc::glsl
