// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Clang's preprocessor as clipc's: the include files, and the conversion of each of Clang's tokens
// to one of clipc's.
#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <clang/Lex/HeaderSearch.h>
#include <clang/Lex/ModuleLoader.h>
#include <clang/Lex/Preprocessor.h>
#include <fmt/format.h>
#include <llvm/ADT/StringSet.h>
#include <llvm/Support/MemoryBuffer.h>

#include "base/path.h"
#include "frontend/lex/bodies_clang.h"
#include "frontend/lex/plain_text_clang.h"
#include "frontend/lex/source_state_clang.h"
#include "frontend/lex/source_text.h"
#include "frontend/lex/token_writer.h"

namespace clipc {
namespace {

namespace tok = clang::tok;
using clang::SourceLocation;

using Limit = PreprocessGuard::Limit;

// Whether a file can have this name. clang::FileManager reads freed memory when it is given the
// name of a folder for a file, and systems cut a name off at a NUL.
bool CanNameFile(llvm::StringRef name) {
  return !name.empty() && name.back() != '/' && name.back() != '\\' && !name.contains('\0');
}

// ---- includes

class Callbacks : public clang::PPCallbacks {
 public:
  Callbacks(Source::State& source, clang::Preprocessor& preprocessor, clang::HeaderSearch& search)
      : source_(source), preprocessor_(preprocessor), search_(search) {}

  // `true` lets Clang go on; InclusionDirective, which it calls next, has the place for a message.
  bool FileNotFound(llvm::StringRef) override { return true; }

  void InclusionDirective(SourceLocation, const clang::Token&, llvm::StringRef name, bool,
                          clang::CharSourceRange where, clang::OptionalFileEntryRef file,
                          llvm::StringRef, llvm::StringRef, const clang::Module*, bool,
                          clang::SrcMgr::CharacteristicKind) override {
    if (file || source_.guard.stopped()) return;
    const std::vector<std::string> folders =
        IncludeFolders(source_.include_stack, source_.input.include_dirs);
    const Span span = SpanAt(where.getBegin());
    std::optional<FoundInclude> found;
    if (CanNameFile(name)) {
      if (!source_.input.read_include) {
        found = FindIncludeLikeWindows(folders, name.str());
      } else if (const auto entry = FromMemory(folders, name.str())) {
        return Enter(*entry, where.getBegin());
      }
    }
    auto entry = found ? source_.shared.files->getOptionalFileRef(found->path) : std::nullopt;
    if (!entry) {
      ReportMissingInclude(span, name.str(), folders, source_.shared.sandbox, *source_.diagnostics);
      return source_.guard.Stop(Limit::kReported, span.begin);
    }
    if (found->spelling != name && warned_.insert(name).second) {
      source_.diagnostics->Report(span, diag::IncludeSpelling, name.str(), found->spelling);
    }
    Enter(*entry, where.getBegin());
  }

  void LexedFileChanged(clang::FileID file, LexedFileChangeReason reason,
                        clang::SrcMgr::CharacteristicKind, clang::FileID,
                        SourceLocation where) override {
    auto& stack = source_.include_stack;
    if (source_.bodies && source_.bodies->is_reading()) return;
    if (reason == LexedFileChangeReason::EnterFile) {
      const EnteredFile& entered = stack.emplace_back(source_.Describe(file));
      if (stack.size() > 1 || source_.MainFileIsOnDisk()) AddDependency(entered.name);
      if (stack.size() > 1 && !entered.name.empty())
        source_.includes.push_back({entered.name, stack.size() - 1});
      source_.guard.CountInclude(where.getRawEncoding(), source_.sources.getFileIDSize(file));
    } else {
      while (!stack.empty() && stack.back().id != file.getHashValue()) stack.pop_back();
    }
    if (source_.guard.stopped()) SkipRestOfFile(file);
  }

  void MacroDefined(const clang::Token& name, const clang::MacroDirective*) override {
    const llvm::StringRef word = name.getIdentifierInfo()->getName();
    source_.macro_names.Add({word.data(), word.size()});
  }

  void MacroExpands(const clang::Token& name, const clang::MacroDefinition& macro,
                    clang::SourceRange, const clang::MacroArgs*) override {
    source_.guard.CountExpansion(name.getLocation().getRawEncoding());
    // Clang does not expand a macro that is disabled, as it is during its own expansion.
    if (source_.guard.stopped() && macro.getMacroInfo()->isEnabled())
      macro.getMacroInfo()->DisableMacro();
  }

 private:
  void Enter(clang::FileEntryRef file, SourceLocation where) {
    if (source_.include_stack.size() >= 200) return source_.StopInclude();
    bool is_first = false;
    if (!search_.ShouldEnterIncludeFile(preprocessor_, file, /*isImport=*/false,
                                        /*ModulesEnabled=*/false, nullptr, is_first)) {
      return;
    }
    const clang::FileID id = source_.sources.createFileID(file, where, clang::SrcMgr::C_User);
    preprocessor_.EnterSourceFile(id, nullptr, where, is_first);
  }

  clang::OptionalFileEntryRef FromMemory(const std::vector<std::string>& folders,
                                         std::string name) {
    std::ranges::replace(name, '\\', '/');
    for (const std::string& folder : folders) {
      const std::string path =
          folder.empty() || IsAbsolute(name) ? name : fmt::format("{}/{}", folder, name);
      if (const auto known = source_.shared.files->getOptionalFileRef(path)) return known;
      auto text = source_.input.read_include(path);
      if (!text || text->size() > kMaxSourceBytes) continue;
      ConvertUtf16(*text);
      const auto entry =
          source_.shared.files->getVirtualFileRef(path, static_cast<off_t>(text->size()), 0);
      source_.sources.overrideFileContents(entry,
                                           llvm::MemoryBuffer::getMemBufferCopy(*text, path));
      return entry;
    }
    return std::nullopt;
  }

  void SkipRestOfFile(clang::FileID file) {
    if (auto* lexer = static_cast<clang::Lexer*>(preprocessor_.getCurrentLexer())) {
      lexer->seek(source_.sources.getFileIDSize(file), /*IsAtStartOfLine=*/true);
    }
  }

  void AddDependency(const std::string& name) {
    auto& list = source_.dependencies;
    if (!name.empty() && std::ranges::find(list, name) == list.end()) list.push_back(name);
  }

  Source::State& source_;
  clang::Preprocessor& preprocessor_;
  clang::HeaderSearch& search_;
  llvm::StringSet<> warned_;  // the include names reported as not spelled as on disk
};

// ---- tokens

constexpr std::array<TokenKind, tok::NUM_TOKENS> MakeKinds() {
  std::array<TokenKind, tok::NUM_TOKENS> kinds{};
  kinds.fill(TokenKind::kUnknown);
  kinds[tok::eof] = TokenKind::kEnd;
  kinds[tok::annot_pragma_pack] = TokenKind::kPragmaPackMatrix;
#define PUNCTUATOR(kind, clang_kind, spelling) kinds[tok::clang_kind] = TokenKind::kind;
#include "frontend/lex/punctuators.def"
  return kinds;
}
constexpr std::array<TokenKind, tok::NUM_TOKENS> kKinds = MakeKinds();

void AddToken(const clang::Token& from, const clang::Preprocessor& preprocessor, Names& names,
              TokenWriter& writer) {
  Token token;
  token.kind = kKinds[from.getKind()];
  token.after_space = from.hasLeadingSpace() || from.isAtStartOfLine();
  token.location = from.getLocation().getRawEncoding();
  if (from.is(tok::identifier)) {  // every word
    clang::IdentifierInfo& identifier = *from.getIdentifierInfo();
    const std::string_view text(identifier.getNameStart(), identifier.getLength());
    token.value = NameOf(identifier, names).index;
    return writer.AddIdentifier(token, text);
  }
  if (token.kind == TokenKind::kPragmaPackMatrix) {
    token.value = from.getAnnotationValue() != nullptr;  // whether it is row_major
    return writer.AddPragma(token);
  }
  if (token.kind != TokenKind::kUnknown) return writer.AddPunctuator(token);
  if (from.is(tok::hash)) return writer.AddHash(token);
  if (!from.isLiteral()) return writer.AddPunctuator(token);

  llvm::SmallString<64> buffer;
  const llvm::StringRef spelling = preprocessor.getSpelling(from, buffer);
  const std::string_view text(spelling.data(), spelling.size());
  switch (from.getKind()) {
    case tok::numeric_constant: return writer.AddNumber(token, text);
    case tok::char_constant: return writer.AddCharacter(token, text);
    case tok::string_literal: return writer.AddString(token, text);
    default: return writer.AddPunctuator(token);  // L"", u8'' and the like: kUnknown
  }
}

}  // namespace

bool Source::State::EnterMainFile() {
  if (input.text) {
    main_text = *input.text;
  } else if (Result<std::string> text = ReadText(input.path)) {
    main_text = std::move(*text);
  } else {
    diagnostics->Report({}, diag::CannotReadFile, input.path, text.problem());
    return false;
  }
  const std::string name = input.path == "-"    ? "<stdin>"
                           : input.path.empty() ? "<memory>"
                                                : input.path;
  if (!CanNameFile(name)) {
    diagnostics->Report({}, diag::CannotReadFile, input.path, "a folder has this name");
    return false;
  }
  main_file_read = true;
  // An entry for a name that is not on disk costs more: it makes the folders around it too.
  const auto on_disk = input.text ? std::nullopt : shared.files->getOptionalFileRef(name);
  const auto entry =
      on_disk ? *on_disk
              : shared.files->getVirtualFileRef(name, static_cast<off_t>(main_text.size()), 0);
  sources.overrideFileContents(entry, llvm::MemoryBuffer::getMemBuffer(main_text, name));
  sources.setMainFileID(sources.createFileID(entry, SourceLocation(), clang::SrcMgr::C_User));
  return true;
}

EnteredFile Source::State::Describe(clang::FileID file) const {
  EnteredFile described;
  described.id = file.getHashValue();
  described.included_at = sources.getIncludeLoc(file).getRawEncoding();
  if (auto entry = sources.getFileEntryRefForID(file)) {
    llvm::StringRef name = entry->getName();
    name.consume_front("./");
    described.identity = &entry->getFileEntry();
    described.name = name.str();
    described.folder = entry->getDir().getName().str();
  }
  return described;
}

namespace {

// Enters the main file and calls on_token(token, preprocessor) for each token, then for those of
// the bodies that are reached and the `}` after each. Returns the end of the main file; an end
// token without a place if it cannot be read.
template <typename OnToken>
clang::Token RunPreprocessor(Source::State& state, Diagnostics& diagnostics, OnToken&& on_token,
                             std::unique_ptr<clang::PPCallbacks> more = nullptr) {
  state.diagnostics = &diagnostics;
  clang::Token token;
  token.startToken();
  if (!state.EnterMainFile()) return token;
  FrontendContext::State& shared = state.shared;
  clang::HeaderSearch search(ForClang(shared.search_options), state.sources, state.engine,
                             shared.language, &shared.target);
  std::vector<clang::DirectoryLookup> folders;
  for (const std::string& folder : state.input.include_dirs) {
    if (auto entry = shared.files->getOptionalDirectoryRef(folder)) {
      folders.emplace_back(*entry, clang::SrcMgr::C_User, /*isFramework=*/false);
    }
  }
  search.SetSearchPaths(folders, 0, static_cast<unsigned>(folders.size()),
                        llvm::DenseMap<unsigned, unsigned>());

  clang::TrivialModuleLoader modules;
  clang::Preprocessor* preprocessor_for_macros = nullptr;
  const auto first_use = AddMacrosAndPragmasOnFirstUse(preprocessor_for_macros, diagnostics);
  clang::Preprocessor preprocessor(ForClang(shared.preprocessor_options), state.engine,
                                   shared.language, state.sources, search, modules,
                                   first_use.get());
  preprocessor_for_macros = &preprocessor;
  preprocessor.Initialize(shared.target);
  preprocessor.setPredefines(Predefines(state.input));
  preprocessor.addPPCallbacks(std::make_unique<Callbacks>(state, preprocessor, search));
  if (more) preprocessor.addPPCallbacks(std::move(more));
  if (state.bodies) state.bodies->Watch(preprocessor);

  if (state.input.record_macros)
    preprocessor.addPPCallbacks(RecordMacros(state.sources, state.macros_used));

  state.guard.SetLimits(state.input.max_bytes, state.input.max_tokens);
  state.guard.SetStackBase(static_cast<const char*>(__builtin_frame_address(0)));
  const GuardScope guarded(state.guard);
  const PasteScope pasting(state.input.pasted, state.guard, diagnostics);
  preprocessor.EnterMainSourceFile();
  const auto goes_on = [&] { return !state.guard.stopped() && !diagnostics.TooManyErrors(); };
  const auto read = [&] { guarded.Read(preprocessor, token); };
  LazyBodies* const bodies = state.bodies;
  std::optional<clang::Token> end;
  for (read(); goes_on(); read()) {
    if (token.isNot(tok::eof)) {
      on_token(token, preprocessor);
      if (!bodies || !bodies->IsEnd(token)) continue;
    } else if (!end) {
      end = token;
    }
    if (!bodies || !bodies->GoOn(token, preprocessor)) break;
  }
  return goes_on() ? *end : token;
}

// Lexes all of a source, or what `functions` reach. None where a body among these was read too
// late: the names of all that are reached are added to `functions`, so that the next time they are
// read in their places.
std::optional<Tokens> LexFrom(Source::State& state, Diagnostics& diagnostics,
                              std::vector<std::string>& functions) {
  Tokens tokens;
  std::optional<LazyBodies> bodies;
  if (!functions.empty()) state.bodies = &bodies.emplace(tokens, functions);
  TokenWriter writer(tokens, diagnostics, state.input.shader_model_major >= 6);
  std::optional<PlainText> plain;
  const clang::Token end = RunPreprocessor(
      state, diagnostics, [&](const clang::Token& token, clang::Preprocessor& preprocessor) {
        if (tokens.list.empty()) {
          tokens.list.reserve(state.main_text.size() / 3 + 64);  // untouched pages cost nothing
          plain.emplace(preprocessor, state.macro_names, tokens.names, writer);
        }
        AddToken(token, preprocessor, tokens.names, writer);
        if (bodies) bodies->After(token, preprocessor);
        if (bodies && bodies->asks_after(token)) return;
        // A `{` may begin a body to pass over, and a `}` may end the one that is being read.
        const bool is_reading = bodies && bodies->is_reading();
        state.guard.CountTokens(
            plain->AddAfter(token, {.open = !bodies || is_reading, .close = !is_reading}));
      });
  state.bodies = nullptr;
  if (bodies && !bodies->are_right()) {
    std::ranges::move(bodies->ReachedFunctions(), std::back_inserter(functions));
    return std::nullopt;
  }
  if (bodies) bodies->Merge();
  writer.AddEnd(end.getLocation().getRawEncoding());
  state.guard.Report(diagnostics);
  return tokens;
}

}  // namespace

Tokens Lex(Source& source, Diagnostics& diagnostics, std::string_view entry) {
  constexpr int kMostTries = 3;
  std::vector<std::string> functions;
  if (!entry.empty()) functions.emplace_back(entry);
  const Diagnostics before = diagnostics;
  for (int tries = 1;; ++tries) {
    if (auto tokens = LexFrom(source.state(), diagnostics, functions)) return *std::move(tokens);
    if (tries == kMostTries) functions.clear();
    diagnostics = before;
    source.Restart();
  }
}

// Whether the token is never a part of a longer one.
static bool EndsAlone(const clang::Token& token) {
  return token.isOneOf(tok::l_paren, tok::r_paren, tok::l_square, tok::r_square, tok::l_brace,
                       tok::r_brace, tok::semi, tok::comma, tok::tilde);
}

namespace {

// The text that -P writes, with the lines of the source.
class PreprocessedText {
 public:
  explicit PreprocessedText(const clang::SourceManager& sources) : sources_(sources) {}

  void Add(const clang::Token& token, clang::Preprocessor& preprocessor) {
    GoTo(token.getLocation());
    if (token.isAnnotation()) {
      return AddLine(fmt::format("#pragma pack_matrix({}_major)",
                                 token.getAnnotationValue() ? "row" : "column"));
    }
    // A space is also written where a macro has put two tokens side by side that must stay two.
    const bool is_of_macro = token.getLocation().isMacroID();
    const bool was_beside = !token.hasLeadingSpace() && !is_of_macro;
    const bool stays = !follows_macro_ || EndsAlone(token);
    if (!text_.empty() && text_.back() != '\n' && !(was_beside && stays)) text_ += ' ';
    follows_macro_ = is_of_macro && !EndsAlone(token);
    text_ += preprocessor.getSpelling(token, buffer_).str();
  }

  // Adds the directive at the location if it is a pragma for the compiler.
  void AddPragma(SourceLocation location) {
    llvm::StringRef line(sources_.getCharacterData(location));
    std::string joined;
    for (std::size_t i = 0; i < line.size() && line[i] != '\n' && line[i] != '\r'; ++i) {
      const bool goes_on = line.substr(i).starts_with("\\\n");
      joined += goes_on ? ' ' : line[i];
      i += goes_on ? 1 : 0;
    }
    llvm::StringRef rest = llvm::StringRef(joined).drop_front().ltrim();
    if (!rest.consume_front("pragma")) return;
    rest = rest.split("//").first.split("/*").first.trim();
    const llvm::StringRef name = rest.take_while([](char c) { return c >= 'a' && c <= 'z'; });
    if (name != "warning" && name != "def") return;
    GoTo(location);
    if (!text_.empty() && text_.back() != '\n') text_ += '\n';
    AddLine(fmt::format("#pragma {}", rest.str()));
  }

  std::string Take() && { return text_.empty() ? std::move(text_) : std::move(text_) + '\n'; }

 private:
  // Adds lines up to that of the location, or a directive that names it.
  void GoTo(SourceLocation location) {
    constexpr unsigned kFewLines = 8;
    const clang::PresumedLoc place = sources_.getPresumedLoc(location);
    const bool is_elsewhere =
        place.isValid() && (place.getFilename() != file_ || place.getLine() < line_ ||
                            place.getLine() > line_ + kFewLines);
    if (is_elsewhere) {
      file_ = place.getFilename();
      line_ = place.getLine();
      text_ += fmt::format("{}#line {} \"{}\"\n", text_.empty() ? "" : "\n", line_, file_);
    }
    for (; place.isValid() && line_ < place.getLine(); ++line_) text_ += '\n';
  }
  void AddLine(const std::string& line) {
    text_ += line + '\n';
    ++line_;
  }

  const clang::SourceManager& sources_;
  std::string text_, file_;
  unsigned line_ = 0;
  bool follows_macro_ = false;  // and might be one token with what follows
  llvm::SmallString<64> buffer_;
};

class PragmaCallbacks : public clang::PPCallbacks {
 public:
  explicit PragmaCallbacks(PreprocessedText& text) : text_(text) {}
  void PragmaDirective(SourceLocation location, clang::PragmaIntroducerKind kind) override {
    if (kind == clang::PIK_HashPragma) text_.AddPragma(location);
  }

 private:
  PreprocessedText& text_;
};

}  // namespace

std::string Preprocess(Source& source, Diagnostics& diagnostics) {
  Source::State& state = source.state();
  PreprocessedText text(state.sources);
  RunPreprocessor(
      state, diagnostics,
      [&](const clang::Token& token, clang::Preprocessor& preprocessor) {
        text.Add(token, preprocessor);
      },
      std::make_unique<PragmaCallbacks>(text));
  state.guard.Report(diagnostics);
  return std::move(text).Take();
}

FrontendContext::FrontendContext(Files files, const std::string& sandbox)
    : state_(std::make_unique<State>(files, sandbox)) {}
FrontendContext::~FrontendContext() = default;

Source::Source(FrontendContext& context, SourceInput input)
    : state_(std::make_unique<State>(context.state(), std::move(input))) {}
Source::~Source() = default;
void Source::Restart() {
  state_ = std::make_unique<State>(state_->shared, std::move(state_->input));
}

Place Source::Resolve(Span span) const { return clipc::Resolve(state_->Text(), span); }
std::vector<std::uint32_t> Source::PlaceInText(Span span) const {
  return clipc::PlaceInText(state_->Text(), span);
}
std::string Source::RenderText(const Diagnostics& diagnostics, bool colour) const {
  return clipc::RenderText(state_->Text(), diagnostics, colour);
}
std::vector<std::string> Source::Dependencies() const { return state_->dependencies; }
std::vector<Include> Source::Includes() const { return state_->includes; }
std::vector<std::string> Source::MacrosUsed() const {
  return {state_->macros_used.begin(), state_->macros_used.end()};
}
const TextLine& Source::LineOf(Span span) const {
  FindLine(state_->Text(), span, state_->line);
  return state_->line;
}
bool Source::main_file_read() const { return state_->main_file_read; }
const std::string& Source::MainText() const { return state_->main_text; }
std::optional<TextRange> Source::InMainText(Span span) const {
  return clipc::InMainText(state_->Text(), span);
}
std::optional<std::size_t> Source::AfterInMainText(Span span) const {
  return clipc::AfterInMainText(state_->Text(), span);
}

}  // namespace clipc
