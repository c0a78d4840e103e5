// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "frontend/lex/source.h"

namespace clipc {

// A diagnostic whose places are files and lines, so that it outlives its Source.
struct Message {
  struct Fix {
    Place place;  // for an insertion, the end is the beginning
    std::string text;
  };

  Severity severity = Severity::kError;
  std::string name;  // the kind's: "clip-plane-not-float4"
  std::string code;  // fxc's: "X3084"; may be empty
  std::string text;
  Place place;  // place.file is empty for a message about no place in particular
  std::vector<Fix> fixes;
  std::vector<Message> notes;
};

Message ToMessage(const Diagnostic& diagnostic, const Source& source);
// The error of a command line that is wrong.
Message UsageMessage(std::string_view what);

// A line for each message, as fxc and cl print: `file(line,col-endcol): error X3084: text [name]`,
// or, where fxc has no code, `file(line,col-endcol): error name: text`.
std::string RenderMsvc(const std::vector<Message>& messages);

// A JSON document: {"version": 1, "diagnostics": [{severity, name, code, message, file, line,
// column, endLine, endColumn, fixes, notes}]}. Lines and columns are 1-based, columns count bytes,
// the end is one past the last byte.
std::string RenderJson(const std::vector<Message>& messages);

// A SARIF 2.1.0 document with one run.
std::string RenderSarif(const std::vector<Message>& messages);

}  // namespace clipc
