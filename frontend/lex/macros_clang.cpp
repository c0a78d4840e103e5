// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The recording of the macros that a text asks for.
#include <clang/Basic/IdentifierTable.h>
#include <clang/Basic/SourceManager.h>
#include <clang/Lex/PPCallbacks.h>
#include <clang/Lex/Token.h>

#include "frontend/lex/clang_bridge.h"

namespace clipc {
namespace {

using clang::MacroDefinition;
using clang::SourceLocation;
using clang::SourceRange;

class MacroRecorder : public clang::PPCallbacks {
 public:
  MacroRecorder(const clang::SourceManager& sources, std::set<std::string>& used)
      : sources_(sources), used_(used) {}

  void MacroExpands(const clang::Token& name, const MacroDefinition&, SourceRange,
                    const clang::MacroArgs*) override {
    Add(name);
  }
  void Defined(const clang::Token& name, const MacroDefinition&, SourceRange) override {
    Add(name);
  }
  void Ifdef(SourceLocation, const clang::Token& name, const MacroDefinition&) override {
    Add(name);
  }
  void Ifndef(SourceLocation, const clang::Token& name, const MacroDefinition&) override {
    Add(name);
  }
  using PPCallbacks::Elifdef;
  void Elifdef(SourceLocation, const clang::Token& name, const MacroDefinition&) override {
    Add(name);
  }
  using PPCallbacks::Elifndef;
  void Elifndef(SourceLocation, const clang::Token& name, const MacroDefinition&) override {
    Add(name);
  }
  void MacroUndefined(const clang::Token& name, const MacroDefinition&,
                      const clang::MacroDirective*) override {
    Add(name);
  }
  void MacroDefined(const clang::Token& name, const clang::MacroDirective*) override {
    const SourceLocation where = name.getLocation();
    if (!sources_.isWrittenInCommandLineFile(where) && !sources_.isWrittenInBuiltinFile(where))
      Add(name);
  }

 private:
  void Add(const clang::Token& name) {
    if (const clang::IdentifierInfo* identifier = name.getIdentifierInfo())
      used_.insert(identifier->getName().str());
  }

  const clang::SourceManager& sources_;
  std::set<std::string>& used_;
};

}  // namespace

std::unique_ptr<clang::PPCallbacks> RecordMacros(const clang::SourceManager& sources,
                                                 std::set<std::string>& used) {
  return std::make_unique<MacroRecorder>(sources, used);
}

}  // namespace clipc
