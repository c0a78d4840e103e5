// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The operands of `##`. fxc expands a macro in them first, whether it comes from an argument or
// stands in the definition itself: DXC's issues 1005, 1089 and 2158. C and dxc do not.
#include <algorithm>
#include <utility>
#include <vector>

#include <clang/Basic/IdentifierTable.h>
#include <clang/Lex/MacroArgs.h>
#include <clang/Lex/MacroInfo.h>
#include <clang/Lex/Preprocessor.h>

#include "frontend/lex/clang_bridge.h"

namespace clipc {
namespace {

namespace tok = clang::tok;
using clang::MacroArgs;
using clang::MacroInfo;
using clang::Preprocessor;

thread_local PasteScope* current_scope = nullptr;

}  // namespace

#define CLIPC_ENTER_MACRO                                                                  \
  "_ZN5clang12Preprocessor10EnterMacroERNS_5TokenENS_14SourceLocationEPNS_9MacroInfoEPNS_" \
  "9MacroArgsE"
#define CLIPC_END_OF_MACRO "_ZN5clang12Preprocessor21HandleEndOfTokenLexerERNS_5TokenE"

// The functions of Clang that the linker's names stand for, and those that it calls instead.
extern "C" {
void RealEnterMacro(Preprocessor*, clang::Token&, clang::SourceLocation, MacroInfo*,
                    MacroArgs*) __asm__("__real_" CLIPC_ENTER_MACRO) __attribute__((weak));
void WrapEnterMacro(Preprocessor*, clang::Token&, clang::SourceLocation, MacroInfo*,
                    MacroArgs*) __asm__("__wrap_" CLIPC_ENTER_MACRO);
bool RealEndOfMacro(Preprocessor*, clang::Token&) __asm__("__real_" CLIPC_END_OF_MACRO)
    __attribute__((weak));
bool WrapEndOfMacro(Preprocessor*, clang::Token&) __asm__("__wrap_" CLIPC_END_OF_MACRO);
MacroInfo* AllocateMacroInfo(Preprocessor*, clang::SourceLocation) __asm__(
    "_ZN5clang12Preprocessor17AllocateMacroInfoENS_14SourceLocationE");
}

namespace {

// The macro that an operand names and that has no parameters; nullptr if there is none.
const MacroInfo* MacroWithoutParameters(const clang::Token& operand,
                                        const Preprocessor& preprocessor) {
  clang::IdentifierInfo* const name = operand.getIdentifierInfo();
  const MacroInfo* const macro =
      name && name->hasMacroDefinition() ? preprocessor.getMacroInfo(name) : nullptr;
  return macro && macro->isObjectLike() && macro->isEnabled() ? macro : nullptr;
}

// Whether the expansion of a macro without parameters is another text than its name.
bool ChangesText(const clang::Token& operand, const Preprocessor& preprocessor) {
  const MacroInfo* const macro = MacroWithoutParameters(operand, preprocessor);
  return macro &&
         !(macro->getNumTokens() == 1 &&
           macro->getReplacementToken(0).getIdentifierInfo() == operand.getIdentifierInfo());
}

bool IsOperand(llvm::ArrayRef<clang::Token> tokens, std::size_t at) {
  return (at > 0 && tokens[at - 1].is(tok::hashhash)) ||
         (at + 1 < tokens.size() && tokens[at + 1].is(tok::hashhash));
}

std::vector<clang::Token> Expand(const clang::Token& operand, Preprocessor& preprocessor) {
  std::vector<clang::Token> tokens{operand, operand};
  tokens[1].startToken();
  tokens[1].setKind(tok::eof);
  tokens[1].setLocation(operand.getLocation());
  preprocessor.EnterTokenStream(tokens, /*DisableMacroExpansion=*/false, /*IsReinject=*/false);
  std::vector<clang::Token> expanded(1);
  for (; preprocessor.Lex(expanded.back()), expanded.back().isNot(tok::eof);)
    expanded.emplace_back();
  preprocessor.RemoveTopOfLexerStack();
  expanded.pop_back();
  return expanded;
}

// One use of a macro that has `##` in its definition.
class Use {
 public:
  Use(Preprocessor& preprocessor, const clang::Token& name, MacroInfo& macro, MacroArgs* arguments)
      : preprocessor_(preprocessor),
        name_(name.getIdentifierInfo()),
        macro_(macro),
        arguments_(arguments),
        tokens_(macro.tokens_begin(), macro.tokens_end()) {}

  // The bytes that pasting writes, at the most: all operands once more for each `##`.
  std::size_t Bytes() const {
    std::size_t operands = 0, pastes = 0;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      pastes += tokens_[i].is(tok::hashhash);
      if (!IsOperand(tokens_, i)) continue;
      const int parameter = ParameterAt(i);
      if (parameter < 0) operands += tokens_[i].getLength();
      for (const clang::Token& token : ArgumentTokens(parameter)) operands += token.getLength();
    }
    return operands * pastes;
  }

  // The first operand that fxc and C read in different ways.
  const clang::Token* Difference() const {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (!IsOperand(tokens_, i)) continue;
      const int parameter = ParameterAt(i);
      const bool is_own = tokens_[i].getIdentifierInfo() == name_;
      if (parameter < 0 && !is_own && ChangesText(tokens_[i], preprocessor_)) return &tokens_[i];
      for (const clang::Token& token : ArgumentTokens(parameter))
        if (ChangesText(token, preprocessor_)) return &token;
    }
    return nullptr;
  }

  // Expands the arguments that stand beside `##`.
  void ExpandArguments() {
    if (!arguments_) return;
    std::vector<bool> is_pasted(macro_.getNumParams());
    for (std::size_t i = 0; i < tokens_.size(); ++i)
      if (const int parameter = ParameterAt(i); parameter >= 0 && IsOperand(tokens_, i))
        is_pasted[static_cast<std::size_t>(parameter)] = true;
    std::vector<clang::Token> all;
    for (unsigned i = 0; i < macro_.getNumParams(); ++i) {
      const clang::Token* const written = arguments_->getUnexpArgument(i);
      if (is_pasted[i] && arguments_->ArgNeedsPreexpansion(written, preprocessor_)) {
        const std::vector<clang::Token>& expanded = arguments_->getPreExpArgument(i, preprocessor_);
        all.insert(all.end(), expanded.begin(), expanded.end());
      } else {
        all.insert(all.end(), written, written + MacroArgs::getArgLength(written) + 1);
      }
    }
    MacroArgs* const replaced =
        MacroArgs::create(&macro_, all, arguments_->isVarargsElidedUse(), preprocessor_);
    arguments_->destroy(preprocessor_);
    arguments_ = replaced;
  }
  MacroArgs* arguments() const { return arguments_; }

  // A macro like this one whose operands are expanded, or this one if that changes nothing. What
  // is neither a name nor a literal cannot be pasted to anything, and such operands are kept.
  MacroInfo* ExpandDefinition() {
    std::vector<clang::Token> all;
    bool is_other = false;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      const bool is_named = ParameterAt(i) < 0 && IsOperand(tokens_, i) &&
                            tokens_[i].getIdentifierInfo() != name_ &&
                            MacroWithoutParameters(tokens_[i], preprocessor_);
      const std::vector<clang::Token> expanded =
          is_named ? Expand(tokens_[i], preprocessor_) : std::vector<clang::Token>{};
      const bool fits =
          !expanded.empty() && std::ranges::all_of(expanded, [](const clang::Token& token) {
            return token.getIdentifierInfo() || token.isLiteral();
          });
      if (!fits) all.push_back(tokens_[i]);
      for (std::size_t k = 0; fits && k < expanded.size(); ++k) {
        all.push_back(expanded[k]);
        all.back().setLocation(tokens_[i].getLocation());  // Clang wants a place in the definition
        if (k == 0) {
          all.back().setFlagValue(clang::Token::LeadingSpace, tokens_[i].hasLeadingSpace());
          all.back().setFlagValue(clang::Token::StartOfLine, tokens_[i].isAtStartOfLine());
        }
      }
      is_other |= fits;
    }
    return is_other ? Like(all) : &macro_;
  }

 private:
  int ParameterAt(std::size_t at) const {
    const clang::IdentifierInfo* const name = tokens_[at].getIdentifierInfo();
    return name && arguments_ ? macro_.getParameterNum(name) : -1;
  }

  llvm::ArrayRef<clang::Token> ArgumentTokens(int parameter) const {
    if (parameter < 0) return {};
    const clang::Token* const first =
        arguments_->getUnexpArgument(static_cast<unsigned>(parameter));
    return {first, MacroArgs::getArgLength(first)};
  }

  MacroInfo* Like(llvm::ArrayRef<clang::Token> tokens) {
    MacroInfo* const other = AllocateMacroInfo(&preprocessor_, macro_.getDefinitionLoc());
    llvm::BumpPtrAllocator& memory = preprocessor_.getPreprocessorAllocator();
    std::vector<clang::IdentifierInfo*> parameters;
    for (const clang::IdentifierInfo* parameter : macro_.params())
      parameters.push_back(const_cast<clang::IdentifierInfo*>(parameter));
    other->setDefinitionEndLoc(macro_.getDefinitionEndLoc());
    other->setParameterList(parameters, memory);
    if (macro_.isFunctionLike()) other->setIsFunctionLike();
    if (macro_.isC99Varargs()) other->setIsC99Varargs();
    if (macro_.isGNUVarargs()) other->setIsGNUVarargs();
    if (macro_.hasCommaPasting()) other->setHasCommaPasting();
    other->setTokens(tokens, memory);
    return other;
  }

  Preprocessor& preprocessor_;
  const clang::IdentifierInfo* name_;
  MacroInfo& macro_;
  MacroArgs* arguments_;
  llvm::ArrayRef<clang::Token> tokens_;
};

}  // namespace

// The macros that are not expanded again while the one that took their place is: Clang knows that
// of the latter only.
struct PasteScope::State {
  std::vector<std::pair<MacroInfo*, MacroInfo*>> replaced;  // the macro, and what took its place
};

PasteScope::PasteScope(PastedOperands how, PreprocessGuard& guard, Diagnostics& diagnostics)
    : state_(std::make_unique<State>()),
      how_(how),
      guard_(guard),
      diagnostics_(diagnostics),
      outer_(std::exchange(current_scope, this)) {}
PasteScope::~PasteScope() { current_scope = outer_; }

void PasteScope::Enter(Preprocessor& preprocessor, clang::Token& name, clang::SourceLocation end,
                       MacroInfo* macro, MacroArgs* arguments) {
  const auto enter = [&](MacroInfo* which, MacroArgs* with) {
    RealEnterMacro(&preprocessor, name, end, which, with);
  };
  const bool pastes = std::ranges::any_of(
      macro->tokens(), [](const clang::Token& token) { return token.is(tok::hashhash); });
  if (!pastes || guard_.stopped()) return enter(macro, arguments);
  Use use(preprocessor, name, *macro, arguments);
  if (how_ == PastedOperands::kExpanded) {
    use.ExpandArguments();
  } else if (const clang::Token* operand = use.Difference()) {
    diagnostics_.Report(SpanAt(name.getLocation()), diag::PastedMacro,
                        operand->getIdentifierInfo()->getName().str());
  }
  MacroInfo* const other = how_ == PastedOperands::kExpanded ? use.ExpandDefinition() : macro;
  guard_.CountPasting(name.getLocation().getRawEncoding(), use.Bytes());
  if (other != macro && macro->isEnabled()) {
    macro->DisableMacro();
    state_->replaced.emplace_back(macro, other);
  }
  enter(other, use.arguments());
}

void PasteScope::EnableReplaced() {
  std::erase_if(state_->replaced, [](const auto& pair) {
    const auto& [macro, other] = pair;
    if (other->isEnabled() && !macro->isEnabled()) macro->EnableMacro();
    return other->isEnabled();
  });
}

// Is called at each use of a macro.
void WrapEnterMacro(Preprocessor* preprocessor, clang::Token& name, clang::SourceLocation end,
                    MacroInfo* macro, MacroArgs* arguments) {
  current_scope->Enter(*preprocessor, name, end, macro, arguments);
}

// Is called at the end of what a macro became.
bool WrapEndOfMacro(Preprocessor* preprocessor, clang::Token& token) {
  current_scope->EnableReplaced();
  return RealEndOfMacro(preprocessor, token);
}

}  // namespace clipc
