// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Functions of Clang that the linker's --wrap (frontend/CMakeLists.txt) sends through here: every
// token that the preprocessor reads is counted, and its set-up, which is made for large C++ files
// and would be a fifth of a small shader's time, is cut down to what a shader needs.
#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include <clang/Basic/IdentifierTable.h>
#include <clang/Basic/SourceManager.h>
#include <clang/Lex/Lexer.h>
#include <clang/Lex/LiteralSupport.h>
#include <clang/Lex/Preprocessor.h>
#include <llvm/ADT/STLExtras.h>
#include <llvm/ADT/StringMap.h>
#include <llvm/Support/Unicode.h>

#include "base/kept_blocks.h"
#include "frontend/lex/clang_bridge.h"
#include "frontend/lex/plain_text_clang.h"

namespace clipc {
namespace {

namespace tok = clang::tok;
using Limit = PreprocessGuard::Limit;

thread_local const GuardScope* current_run = nullptr;

// What happens seldom is in functions of its own, so that reading a token needs no stack frame.
[[gnu::noinline]] void StopHere(PreprocessGuard& guard, Limit limit,
                                const clang::Preprocessor& preprocessor) {
  auto* file = static_cast<clang::Lexer*>(preprocessor.getCurrentFileLexer());
  guard.Stop(limit, file ? file->getSourceLocation().getRawEncoding() : 0);
}

// Makes the token that ends what Clang reads. Some of its loops wait for the end of a line, some
// for the end of the file: both come by turns.
[[gnu::noinline]] void MakeEnd(clang::Token& token) {
  thread_local bool end_of_line = false;
  token.startToken();
  token.setKind(end_of_line ? tok::eod : tok::eof);
  end_of_line = !end_of_line;
}

// Whether the preprocessor may read one more token, which `kCount` counts.
template <Limit (PreprocessGuard::*kCount)()>
bool MayRead(PreprocessGuard& guard, const clang::Preprocessor& preprocessor) {
  if (guard.stopped()) return false;
  const Limit limit = (guard.*kCount)();
  if (limit != Limit::kNone) StopHere(guard, limit, preprocessor);
  return limit == Limit::kNone;
}

// Whether the token stands in `#line 1 "x"` or `# 1 "x"`.
bool IsInLineDirective(const clang::Token& token, const clang::SourceManager& sources) {
  const auto [file, offset] = sources.getDecomposedExpansionLoc(token.getLocation());
  llvm::StringRef line = sources.getBufferData(file).take_front(offset);
  line = line.drop_front(line.find_last_of("\r\n") + 1).ltrim();  // npos + 1 is 0
  if (!line.consume_front("#")) return false;
  line = line.ltrim();
  return line.starts_with("line") || (!line.empty() && line[0] >= '0' && line[0] <= '9');
}

#define CLIPC_STRING_LITERAL                                                         \
  "_ZN5clang19StringLiteralParserC1EN4llvm8ArrayRefINS_5TokenEEERNS_12PreprocessorE" \
  "NS_23StringLiteralEvalMethodE"

}  // namespace

GuardScope::GuardScope(PreprocessGuard& guard)
    : guard(guard), outer_(std::exchange(current_run, this)) {}
GuardScope::~GuardScope() { current_run = outer_; }

// NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming): the linker's names.
extern "C" {
void __real__ZN5clang12Preprocessor3LexERNS_5TokenE(clang::Preprocessor*, clang::Token&)
    __attribute__((weak));
void __wrap__ZN5clang12Preprocessor3LexERNS_5TokenE(clang::Preprocessor*, clang::Token&);

// clang::Preprocessor::Lex, which Clang itself calls too.
void __wrap__ZN5clang12Preprocessor3LexERNS_5TokenE(clang::Preprocessor* preprocessor,
                                                    clang::Token& token) {
  const GuardScope* scope = current_run;
  if (!scope || MayRead<&PreprocessGuard::CountInnerToken>(scope->guard, *preprocessor)) {
    return __real__ZN5clang12Preprocessor3LexERNS_5TokenE(preprocessor, token);
  }
  MakeEnd(token);
}

// IdentifierTable::AddKeywords: to clipc all words are identifiers, so C's keywords are not
// entered.
void __wrap__ZN5clang15IdentifierTable11AddKeywordsERKNS_11LangOptionsE(clang::IdentifierTable*,
                                                                        const clang::LangOptions&) {
}

// llvm::allocate_buffer and deallocate_buffer, which tables and arenas of LLVM's call: a thread
// keeps their memory. On Windows they have other names, since std::size_t is another type.
#ifndef _WIN32
void* __real__ZN4llvm15allocate_bufferEmm(std::size_t, std::size_t) __attribute__((weak));
void* __wrap__ZN4llvm15allocate_bufferEmm(std::size_t size, std::size_t alignment) {
  return alignment <= alignof(std::max_align_t)
             ? TakeBlock(size)
             : __real__ZN4llvm15allocate_bufferEmm(size, alignment);
}
void __real__ZN4llvm17deallocate_bufferEPvmm(void*, std::size_t, std::size_t) __attribute__((weak));
void __wrap__ZN4llvm17deallocate_bufferEPvmm(void* block, std::size_t size, std::size_t alignment) {
  alignment <= alignof(std::max_align_t)
      ? DropBlock(block, size)
      : __real__ZN4llvm17deallocate_bufferEPvmm(block, size, alignment);
}
#endif

// StringMapImpl's constructor: the table of identifiers, the one map that Clang makes this large,
// grows from fewer buckets.
#ifdef __wasm__
using Constructed = void*;  // a constructor returns `this` there
#else
using Constructed = void;
#endif
Constructed __real__ZN4llvm13StringMapImplC2Ejj(llvm::StringMapImpl*, unsigned, unsigned)
    __attribute__((weak));
Constructed __wrap__ZN4llvm13StringMapImplC2Ejj(llvm::StringMapImpl* map, unsigned buckets,
                                                unsigned item_size) {
  return __real__ZN4llvm13StringMapImplC2Ejj(map, std::min(buckets, 32u), item_size);
}

// IdentifierTable's constructor, of a table with C's keywords: a message with a fix makes one.
#define CLIPC_IDENTIFIER_TABLE \
  "_ZN5clang15IdentifierTableC1ERKNS_11LangOptionsEPNS_20IdentifierInfoLookupE"
Constructed WrapIdentifierTable(
    clang::IdentifierTable*, const clang::LangOptions&,
    clang::IdentifierInfoLookup*) __asm__("__wrap_" CLIPC_IDENTIFIER_TABLE);
Constructed WrapIdentifierTable(clang::IdentifierTable* table, const clang::LangOptions&,
                                clang::IdentifierInfoLookup* look_up) {
  return Constructed(new (table) clang::IdentifierTable(look_up));
}

// StringLiteralParser's constructor: a file name has no escapes in `#line 1 "shaders\new.hlsl"`.
// Generated shaders have the names of Windows so.
Constructed RealStringLiteral(
    clang::StringLiteralParser*, llvm::ArrayRef<clang::Token>, clang::Preprocessor&,
    clang::StringLiteralEvalMethod) __asm__("__real_" CLIPC_STRING_LITERAL) __attribute__((weak));
Constructed WrapStringLiteral(
    clang::StringLiteralParser*, llvm::ArrayRef<clang::Token>, clang::Preprocessor&,
    clang::StringLiteralEvalMethod) __asm__("__wrap_" CLIPC_STRING_LITERAL);
Constructed WrapStringLiteral(clang::StringLiteralParser* parser,
                              llvm::ArrayRef<clang::Token> tokens,
                              clang::Preprocessor& preprocessor,
                              clang::StringLiteralEvalMethod how) {
  if (tokens.size() != 1 || !IsInLineDirective(tokens[0], preprocessor.getSourceManager()))
    return RealStringLiteral(parser, tokens, preprocessor, how);
  std::string text;
  for (const char c : preprocessor.getSpelling(tokens[0])) text.append(c == '\\' ? 2 : 1, c);
  clang::Token plain = tokens[0];
  plain.setLiteralData(text.data());
  plain.setLength(static_cast<unsigned>(text.size()));
  return RealStringLiteral(parser, plain, preprocessor, how);
}

// llvm::sys::locale::isPrint: messages ask it for each letter of the lines that they show.
bool __real__ZN4llvm3sys6locale7isPrintEi(int) __attribute__((weak));
bool __wrap__ZN4llvm3sys6locale7isPrintEi(int letter);
bool __wrap__ZN4llvm3sys6locale7isPrintEi(int letter) {
  if (letter >= ' ' && letter <= '~') return true;
  // A weak name does not bring what it names into a program; columnWidth of the same file does.
  const auto real = __real__ZN4llvm3sys6locale7isPrintEi;
  return real && real(letter);
}

// Preprocessor::RegisterBuiltinPragmas: the thirty pragmas of C++ are left out; AddPragmas adds
// those of HLSL.
void __wrap__ZN5clang12Preprocessor22RegisterBuiltinPragmasEv(clang::Preprocessor*) {}

// Preprocessor::RegisterBuiltinMacros: __LINE__ and the twenty-nine others are added when a shader
// names one (FirstUse).
void __real__ZN5clang12Preprocessor21RegisterBuiltinMacrosEv(clang::Preprocessor*)
    __attribute__((weak));
void __wrap__ZN5clang12Preprocessor21RegisterBuiltinMacrosEv(clang::Preprocessor*) {}
}
// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)

void GuardScope::Read(clang::Preprocessor& preprocessor, clang::Token& token) const {
  if (!MayRead<&PreprocessGuard::CountToken>(guard, preprocessor)) return MakeEnd(token);
  // Most tokens stand in a file. Its lexer returns false where the next token is not its own: at
  // the end of the file, after a directive and at a macro.
  while (auto* file = static_cast<clang::Lexer*>(preprocessor.getCurrentLexer())) {
    PlainText::SkipLines(*file);
    if (file->Lex(token)) return;
  }
  __real__ZN5clang12Preprocessor3LexERNS_5TokenE(&preprocessor, token);
}

namespace {

// A look-up that Clang asks for every identifier that is new to the preprocessor.
class FirstUse : public clang::IdentifierInfoLookup {
 public:
  FirstUse(clang::Preprocessor* const& preprocessor, Diagnostics& diagnostics)
      : preprocessor_(preprocessor), diagnostics_(diagnostics) {}

  clang::IdentifierInfo* get(llvm::StringRef name) override {
    const bool is_wanted = name == "pragma" || IsOfClang(name);
    if (!preprocessor_ || !is_wanted || std::exchange(is_done_, true)) return nullptr;
    __real__ZN5clang12Preprocessor21RegisterBuiltinMacrosEv(preprocessor_);
    preprocessor_->getIdentifierInfo("__has_embed")->setHasMacroDefinition(false);
    AddPragmas(*preprocessor_, diagnostics_);
    return &preprocessor_->getIdentifierTable().get(name);
  }

 private:
  // Whether Clang may have a macro or an operator of that name. The guards of includes begin with
  // `_` as well, and cost nothing so.
  static bool IsOfClang(llvm::StringRef name) {
    constexpr llvm::StringLiteral kWords[] = {
        "_Pragma",       "__pragma",          "__identifier",  "__building_module",
        "__LINE__",      "__FILE__",          "__DATE__",      "__TIME__",
        "__BASE_FILE__", "__INCLUDE_LEVEL__", "__TIMESTAMP__", "__FLT_EVAL_METHOD__",
        "__FILE_NAME__", "__COUNTER__",       "__MODULE__"};
    return name.starts_with("_") && (name.starts_with("__has_") || name.starts_with("__is_") ||
                                     llvm::is_contained(kWords, name));
  }

  clang::Preprocessor* const& preprocessor_;
  Diagnostics& diagnostics_;
  bool is_done_ = false;
};

}  // namespace

std::unique_ptr<clang::IdentifierInfoLookup> AddMacrosAndPragmasOnFirstUse(
    clang::Preprocessor* const& preprocessor, Diagnostics& diagnostics) {
  return std::make_unique<FirstUse>(preprocessor, diagnostics);
}

}  // namespace clipc

// Named characters, `\N{LATIN SMALL LETTER A}`, which Clang takes in names and HLSL does not: no
// character has a name here. The linker takes these definitions in place of those in LLVM's
// archive, which would bring the names of all characters into the program.
namespace llvm::sys::unicode {

std::optional<char32_t> nameToCodepointStrict(StringRef) { return std::nullopt; }
std::optional<LooseMatchingResult> nameToCodepointLooseMatching(StringRef) { return std::nullopt; }
SmallVector<MatchForCodepointName> nearestMatchesForCodepointName(StringRef, std::size_t) {
  return {};
}

}  // namespace llvm::sys::unicode
