// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// HLSL's pragmas, as handlers of Clang's preprocessor.
#include <memory>
#include <string>
#include <vector>

#include <clang/Lex/Pragma.h>
#include <clang/Lex/Preprocessor.h>

#include "frontend/lex/clang_bridge.h"

namespace clipc {
namespace {

namespace tok = clang::tok;

// Hands the rest of the directive to `handle` as words and punctuators.
class Pragma : public clang::PragmaHandler {
 public:
  using Handle = void (*)(Diagnostics&, clang::Preprocessor&, const clang::Token& name,
                          const std::vector<std::string>& words);
  Pragma(llvm::StringRef name, Diagnostics& diagnostics, Handle handle)
      : PragmaHandler(name), diagnostics_(diagnostics), handle_(handle) {}

  void HandlePragma(clang::Preprocessor& preprocessor, clang::PragmaIntroducer,
                    clang::Token& name) override {
    if (name.isOneOf(tok::eod, tok::eof)) return;  // `#pragma` alone: the line has been read
    std::vector<std::string> words;
    clang::Token token;
    for (preprocessor.LexUnexpandedToken(token); !token.isOneOf(tok::eod, tok::eof);
         preprocessor.LexUnexpandedToken(token)) {
      words.push_back(preprocessor.getSpelling(token));
    }
    handle_(diagnostics_, preprocessor, name, words);
  }

 private:
  Diagnostics& diagnostics_;
  Handle handle_;
};

void HandleUnknown(Diagnostics& diagnostics, clang::Preprocessor& preprocessor,
                   const clang::Token& name, const std::vector<std::string>&) {
  diagnostics.Report(SpanAt(name.getLocation()), diag::UnknownPragma,
                     preprocessor.getSpelling(name));
}

void HandlePackMatrix(Diagnostics& diagnostics, clang::Preprocessor& preprocessor,
                      const clang::Token& name, const std::vector<std::string>& words) {
  const bool row_major = words == std::vector<std::string>{"(", "row_major", ")"};
  if (!row_major && words != std::vector<std::string>{"(", "column_major", ")"}) {
    diagnostics.Report(SpanAt(name.getLocation()), diag::MalformedPragma, "pack_matrix",
                       "it takes (row_major) or (column_major)");
    return;
  }
  auto token = std::make_unique<clang::Token[]>(1);
  token[0].startToken();
  token[0].setKind(tok::annot_pragma_pack);
  token[0].setLocation(name.getLocation());
  token[0].setAnnotationEndLoc(name.getLocation());
  token[0].setAnnotationValue(row_major ? &diagnostics : nullptr);
  preprocessor.EnterTokenStream(std::move(token), 1, /*DisableMacroExpansion=*/true,
                                /*IsReinject=*/false);
}

// #pragma warning (disable: 3206 3571; error: 4000), with fxc's numbers. Other words, push and pop
// among them, have no effect.
void HandleWarning(Diagnostics& diagnostics, clang::Preprocessor&, const clang::Token&,
                   const std::vector<std::string>& words) {
  auto state = Diagnostics::WarningState::kOn;
  for (const std::string& word : words) {
    if (word == "disable") state = Diagnostics::WarningState::kOff;
    if (word == "error") state = Diagnostics::WarningState::kError;
    if (word == "default" || word == "once" || word == "enable")
      state = Diagnostics::WarningState::kOn;
    if (word[0] >= '1' && word[0] <= '9') diagnostics.SetWarning("X" + word, state);
  }
}

void HandleMessage(Diagnostics& diagnostics, clang::Preprocessor&, const clang::Token& name,
                   const std::vector<std::string>& words) {
  std::string message;
  for (const std::string& word : words) {
    if (word.size() >= 2 && word.front() == '"') message += word.substr(1, word.size() - 2);
  }
  diagnostics.Report(SpanAt(name.getLocation()), diag::PragmaMessage, message);
}

// A pragma that Clang handles.
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
           new Pragma("pack_matrix", diagnostics, HandlePackMatrix),
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
