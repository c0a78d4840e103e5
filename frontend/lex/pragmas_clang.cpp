// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// HLSL's pragmas, as handlers of Clang's preprocessor.
#include <memory>
#include <string>
#include <vector>

#include <clang/Lex/Pragma.h>
#include <clang/Lex/Preprocessor.h>
#include <fmt/format.h>

#include "frontend/lex/clang_bridge.h"

namespace clipc {
namespace {

namespace tok = clang::tok;

struct Directive {
  Diagnostics& diagnostics;
  clang::Preprocessor& preprocessor;
  const clang::Token& name;
  std::vector<std::string> words = {};  // the words and punctuators that follow the name

  Span span() const { return SpanAt(name.getLocation()); }
};

// A handler that passes the directive with its words to `handle`: all words as they are written, or
// the first few, in which dxc expands macros and fxc does not.
class Pragma : public clang::PragmaHandler {
 public:
  using Handle = void (*)(const Directive&);
  enum class Words { kWritten, kExpandedByDxc };
  Pragma(llvm::StringRef name, Diagnostics& diagnostics, Handle handle,
         Words words = Words::kWritten)
      : PragmaHandler(name), diagnostics_(diagnostics), handle_(handle), words_(words) {}

  void HandlePragma(clang::Preprocessor& preprocessor, clang::PragmaIntroducer,
                    clang::Token& name) override {
    if (name.isOneOf(tok::eod, tok::eof)) return;  // `#pragma` alone: the line has been read
    Directive directive{diagnostics_, preprocessor, name};
    const bool expands =
        words_ == Words::kExpandedByDxc && preprocessor.isMacroDefined("__hlsl_dx_compiler");
    // A macro may stand for any number of words.
    constexpr std::size_t kMostExpanded = 16;
    clang::Token token;
    const auto next = [&] {
      if (expands && directive.words.size() < kMostExpanded)
        preprocessor.Lex(token);
      else
        preprocessor.LexUnexpandedToken(token);
      return !token.isOneOf(tok::eod, tok::eof);
    };
    while (next()) {
      if (!expands || directive.words.size() < kMostExpanded)
        directive.words.push_back(preprocessor.getSpelling(token));
    }
    handle_(directive);
  }

 private:
  Diagnostics& diagnostics_;
  Handle handle_;
  Words words_;
};

void HandleUnknown(const Directive& of) {
  of.diagnostics.Report(of.span(), diag::UnknownPragma, of.preprocessor.getSpelling(of.name));
}

void HandlePackMatrix(const Directive& of) {
  const bool row_major = of.words == std::vector<std::string>{"(", "row_major", ")"};
  if (!row_major && of.words != std::vector<std::string>{"(", "column_major", ")"}) {
    of.diagnostics.Report(of.span(), diag::MalformedPragma, "pack_matrix",
                          "it takes (row_major) or (column_major)");
    return;
  }
  auto token = std::make_unique<clang::Token[]>(1);
  token[0].startToken();
  token[0].setKind(tok::annot_pragma_pack);
  token[0].setLocation(of.name.getLocation());
  token[0].setAnnotationEndLoc(of.name.getLocation());
  token[0].setAnnotationValue(row_major ? &of.diagnostics : nullptr);
  of.preprocessor.EnterTokenStream(std::move(token), 1, /*DisableMacroExpansion=*/true,
                                   /*IsReinject=*/false);
}

// Applies `#pragma warning (disable: 3206 3571; error: 4000)`, which has fxc's numbers.
void HandleWarning(const Directive& of) {
  const std::string first = of.words.size() > 1 ? of.words[1] : "";
  if (first == "push" || first == "pop") {
    of.diagnostics.Report(of.span(), diag::MalformedPragma, fmt::format("warning({})", first),
                          "HLSL has (disable: 3206), (error: 3206) and (default: 3206)");
    return;
  }
  auto state = Diagnostics::WarningState::kOn;
  for (const std::string& word : of.words) {
    if (word == "disable") state = Diagnostics::WarningState::kOff;
    if (word == "error") state = Diagnostics::WarningState::kError;
    if (word == "default" || word == "once" || word == "enable")
      state = Diagnostics::WarningState::kOn;
    if (word[0] >= '1' && word[0] <= '9') of.diagnostics.SetWarning("X" + word, state);
  }
}

void HandleMessage(const Directive& of) {
  std::string message;
  for (const std::string& word : of.words) {
    if (word.size() >= 2 && word.front() == '"') message += word.substr(1, word.size() - 2);
  }
  of.diagnostics.Report(of.span(), diag::PragmaMessage, message);
}

// A handler for a pragma that Clang's preprocessor implements.
template <void (clang::Preprocessor::*handle)(clang::Token&)>
class ClangPragma : public clang::PragmaHandler {
 public:
  using PragmaHandler::PragmaHandler;
  void HandlePragma(clang::Preprocessor& preprocessor, clang::PragmaIntroducer,
                    clang::Token& name) override {
    (preprocessor.*handle)(name);
  }
};

}  // namespace

void AddPragmas(clang::Preprocessor& preprocessor, Diagnostics& diagnostics) {
  using clang::EmptyPragmaHandler;
  for (clang::PragmaHandler* handler : std::initializer_list<clang::PragmaHandler*>{
           new ClangPragma<&clang::Preprocessor::HandlePragmaOnce>("once"),
           new ClangPragma<&clang::Preprocessor::HandlePragmaPushMacro>("push_macro"),
           new ClangPragma<&clang::Preprocessor::HandlePragmaPopMacro>("pop_macro"),
           new Pragma("message", diagnostics, HandleMessage),
           new Pragma("pack_matrix", diagnostics, HandlePackMatrix, Pragma::Words::kExpandedByDxc),
           new Pragma("warning", diagnostics, HandleWarning),
           new EmptyPragmaHandler("region"),  // for editors
           new EmptyPragmaHandler("endregion"),
           new EmptyPragmaHandler("def"),  // fxc: constants for the Direct3D runtime
           new Pragma("", diagnostics, HandleUnknown),
       }) {
    preprocessor.AddPragmaHandler(handler);
  }
}

}  // namespace clipc
