// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <clang/Basic/Diagnostic.h>
#include <clang/Basic/DiagnosticOptions.h>
#include <clang/Basic/FileManager.h>
#include <clang/Basic/LangOptions.h>
#include <clang/Basic/SourceManager.h>
#include <clang/Basic/TargetBuiltins.h>
#include <clang/Basic/TargetInfo.h>
#include <clang/Basic/Version.inc>
#include <clang/Lex/HeaderSearchOptions.h>
#include <clang/Lex/PreprocessorOptions.h>
#include <llvm/Support/VirtualFileSystem.h>

#include "base/kept_object.h"
#include "frontend/lex/bodies_clang.h"
#include "frontend/lex/clang_bridge.h"
#include "frontend/lex/files_clang.h"
#include "frontend/lex/include_search.h"
#include "frontend/lex/plain_text_clang.h"
#include "frontend/lex/preprocess_guard.h"
#include "frontend/lex/source.h"

// The world as Clang sees it, and what is known of one source.
namespace clipc {

// Options as the constructors of this version of Clang take them.
template <typename Options>
decltype(auto) ForClang(const std::shared_ptr<Options>& options) {
#if CLANG_VERSION_MAJOR >= 21
  return (*options);
#else
  return options;
#endif
}

// A target that the preprocessor asks only for the widths of integers and characters.
class ShaderTarget : public clang::TargetInfo {
 public:
  ShaderTarget() : TargetInfo(llvm::Triple("dxil-pc-shadermodel6.0-vertex")) {
    NoAsmVariants = true;
    PointerWidth = PointerAlign = 32;
    LongWidth = LongAlign = 64;
#if CLANG_VERSION_MAJOR >= 22
    resetDataLayout("e-m:e-p:32:32");
#else
    resetDataLayout("e-m:e-p:32:32", "");
#endif
  }
  void getTargetDefines(const clang::LangOptions&, clang::MacroBuilder&) const override {}
#if CLANG_VERSION_MAJOR >= 20
  llvm::SmallVector<clang::Builtin::InfosShard> getTargetBuiltins() const override { return {}; }
#else
  clang::ArrayRef<clang::Builtin::Info> getTargetBuiltins() const override { return {}; }
#endif
  BuiltinVaListKind getBuiltinVaListKind() const override { return VoidPtrBuiltinVaList; }
  bool validateAsmConstraint(const char*&, TargetInfo::ConstraintInfo&) const override {
    return false;
  }
  std::string_view getClobbers() const override { return ""; }
  clang::ArrayRef<const char*> getGCCRegNames() const override { return {}; }
  clang::ArrayRef<TargetInfo::GCCRegAlias> getGCCRegAliases() const override { return {}; }
};

struct FrontendContext::State {
  llvm::IntrusiveRefCntPtr<clang::FileManager> files;
  llvm::IntrusiveRefCntPtr<clang::DiagnosticIDs> ids{new clang::DiagnosticIDs};
#if CLANG_VERSION_MAJOR >= 21
  clang::DiagnosticOptions options;
  clang::DiagnosticOptions& Options() { return options; }
#else
  llvm::IntrusiveRefCntPtr<clang::DiagnosticOptions> options{new clang::DiagnosticOptions};
  clang::DiagnosticOptions& Options() { return *options; }
#endif
  clang::LangOptions language;
  ShaderTarget target;
  std::shared_ptr<clang::HeaderSearchOptions> search_options =
      std::make_shared<clang::HeaderSearchOptions>();
  std::shared_ptr<clang::PreprocessorOptions> preprocessor_options =
      std::make_shared<clang::PreprocessorOptions>();

  std::string sandbox;

  State(Files on_disk, std::string only_folder) : sandbox(std::move(only_folder)) {
    llvm::IntrusiveRefCntPtr<llvm::vfs::FileSystem> system;
    if (on_disk == Files::kNone) {
      system = new llvm::vfs::InMemoryFileSystem;
    } else {
      system = RegularFilesIn(sandbox);
    }
    files = new clang::FileManager(clang::FileSystemOptions(), system);
    language.HLSL = 1;
    language.C99 = 1;
    language.LineComment = 1;
    language.Half = 1;
    language.CPlusPlus = 0;
    language.GNUMode = 0;
    language.DollarIdents = 0;
    preprocessor_options->SourceDateEpoch = 0;  // __DATE__ and __TIME__: same input, same output
  }
};

struct Source::State : KeptObject {
  FrontendContext::State& shared;
  SourceInput input;
  std::string main_text;
  bool main_file_read = false;
  Diagnostics* diagnostics = nullptr;
  PreprocessGuard guard;
  MacroNames macro_names;
  std::unique_ptr<clang::DiagnosticConsumer> consumer;
  clang::DiagnosticsEngine engine;
  clang::SourceManager sources;
  std::vector<EnteredFile> include_stack;
  std::vector<std::string> dependencies;
  std::vector<Include> includes;
  std::set<std::string> macros_used;
  TextLine line;                 // the line that LineOf was asked for last
  LazyBodies* bodies = nullptr;  // of the run of the preprocessor; null: all bodies are read

  State(FrontendContext::State& context, SourceInput what)
      : shared(context),
        input(std::move(what)),
        consumer(ReportInto(&diagnostics, guard, [this] { StopInclude(); })),
        engine(shared.ids, shared.options, consumer.get(), /*ShouldOwnClient=*/false),
        // Volatile files are never mapped: a file may shrink while it is read.
        sources(engine, *shared.files, /*UserFilesAreVolatile=*/true) {}

  ClangText Text() { return {sources, shared.language, shared.Options()}; }
  bool MainFileIsOnDisk() const { return !input.text && input.path != "-"; }
  bool EnterMainFile();
  EnteredFile Describe(clang::FileID file) const;
  void StopInclude() {
    ReportIncludeTooDeep(include_stack, *diagnostics);
    guard.Stop(PreprocessGuard::Limit::kReported, 0);
  }
};

}  // namespace clipc
