// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "link/match_inputs.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/spelling.h"
#include "ir/access.h"
#include "link/names.h"

namespace clipc::link {
namespace {

using Output = Matches::Output;

// The names that tools give an output, in GLSL's spelling.
struct OutputNames {
  std::string semantic;  // "TEXCOORD0"
  std::string bare;      // "TEXCOORD" when the index is 0, which tools may leave out
  std::string member;    // "weights_1_" of "result.weights[1]"
  std::string array;     // "weights" of "result.weights[0]", and of a matrix's first row
  bool is_row = false;   // the output is a row of a matrix
};

bool IsUpper(char c) { return c >= 'A' && c <= 'Z'; }

// Returns twice the number of letters of `name` if `text` is `name` or ends with it where a word
// begins, as "i_uv" and "fragUV" end with "uv", and one more if the case is the same; otherwise 0.
std::size_t Ending(std::string_view text, std::string_view name) {
  if (name.empty() || name.size() > text.size()) return 0;
  const std::size_t start = text.size() - name.size();
  const std::string_view ending = text.substr(start);
  const bool is_word =
      start == 0 || text[start - 1] == '_' || (IsUpper(ending[0]) && !IsUpper(text[start - 1]));
  if (!is_word || !EqualIgnoringCase(ending, name)) return 0;
  return 2 * name.size() + (ending == name ? 1 : 0);
}

// Each of these rules returns how much of an input's name speaks for the output, as Ending does; 0:
// nothing.

// The rule for names that a tool makes of the semantic and of nothing else: DXC's, also after
// SPIRV-Cross, and HLSLcc's, which are clipc's own.
std::size_t ByToolName(const Input& input, const OutputNames& output) {
  for (const std::string_view prefix : {"in_var_", "vs_", "out_var_"}) {
    std::string_view name = input.name;
    // HLSLcc has the columns of a matrix, and the outputs are its rows.
    if (!name.starts_with(prefix) || (output.is_row && input.type.columns == 1)) continue;
    name.remove_prefix(prefix.size());
    if (EqualIgnoringCase(name, output.semantic) || EqualIgnoringCase(name, output.bare))
      return 2 * input.name.size();
  }
  return 0;
}
std::size_t ByMemberName(const Input& input, const OutputNames& output) {
  const std::size_t member = Ending(input.name, output.member);
  return member > 0 || input.type.Elements() == 1 ? member : Ending(input.name, output.array);
}
std::size_t BySemanticName(const Input& input, const OutputNames& output) {
  return std::max(Ending(input.name, output.semantic), Ending(input.name, output.bare));
}

class InputMatcher {
 public:
  InputMatcher(const ir::Program& program, const Interface& pixel, const MatchOptions& options,
               Diagnostics& diagnostics)
      : program_(program),
        pixel_(pixel),
        options_(options),
        diagnostics_(diagnostics),
        outputs_(program.outputs.size()),
        is_matched_(pixel.inputs.size()) {
    for (std::size_t i = 0; i < program.outputs.size(); ++i) names_.push_back(NamesOf(i));
  }

  Matches Run() {
    for (std::size_t i = 0; i < pixel_.inputs.size(); ++i) BySemantic(i);
    for (const auto rule : {ByToolName, ByMemberName, BySemanticName}) ByName(rule);
    for (std::size_t i = 0; i < pixel_.inputs.size(); ++i) ByLocation(i);
    ByOrder();
    for (std::size_t i = 0; i < pixel_.inputs.size(); ++i) Check(i);
    return {std::move(outputs_), std::move(zeros_), {}};
  }

 private:
  OutputNames NamesOf(std::size_t number) const {
    const ir::IoVar& output = program_.outputs[number];
    OutputNames names;
    if (output.builtin != ir::Builtin::kNone) return names;
    names.semantic = output.semantic + std::to_string(output.index);
    if (output.index == 0) names.bare = output.semantic;
    // The path after the parameter or the function; a parameter that is not a struct is its own
    // name.
    const std::string path = output.path.substr(output.path.find('.') + 1);
    const auto first = std::ranges::find(program_.outputs, output.path, &ir::IoVar::path);
    const bool is_matrix = std::ranges::count(program_.outputs, output.path, &ir::IoVar::path) > 1;
    names.is_row = is_matrix;
    if (!is_matrix) names.member = GlslNameOf(path);
    if (is_matrix && &*first == &output) names.array = GlslNameOf(path);
    constexpr std::string_view kFirst = "[0]";
    if (path.ends_with(kFirst))
      names.array = GlslNameOf(path.substr(0, path.size() - kFirst.size()));
    return names;
  }

  // ---- the rules

  void BySemantic(std::size_t number) {
    const Input& input = pixel_.inputs[number];
    if (input.semantic.empty()) return;
    // Indices count on through a matrix, so another variable may begin with one of its indices.
    for (const bool begins : {true, false}) {
      for (std::size_t i = 0; i < program_.outputs.size(); ++i) {
        const ir::IoVar& output = program_.outputs[i];
        const bool is_same = EqualIgnoringCase(output.semantic, input.semantic) &&
                             output.index == input.index &&
                             begins == (i == 0 || VariableOf(i) != VariableOf(i - 1));
        if (is_same && TryMatch(number, i)) return;
      }
    }
  }

  // Matches inputs by a rule, those first that it says most of: "i_light_uv" is of `light_uv`
  // rather than of `uv`, and `uv` matches "i_uv" rather than "i_light_uv".
  void ByName(std::size_t (*rule)(const Input&, const OutputNames&)) {
    struct Candidate {
      std::size_t score, letters, input, output;
    };
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < is_matched_.size(); ++i) {
      const Input& input = pixel_.inputs[i];
      if (is_matched_[i] || !input.semantic.empty()) continue;
      for (std::size_t k = 0; k < outputs_.size(); ++k) {
        const std::size_t score = IsFree(k) ? rule(input, names_[k]) : 0;
        if (score > 0) candidates.push_back({score, input.name.size(), i, k});
      }
    }
    std::ranges::stable_sort(candidates, [](const Candidate& a, const Candidate& b) {
      return std::pair(b.score, a.letters) < std::pair(a.score, b.letters);
    });
    for (const Candidate& candidate : candidates) {
      if (!is_matched_[candidate.input]) TryMatch(candidate.input, candidate.output);
    }
  }

  void ByLocation(std::size_t number) {
    const Input& input = pixel_.inputs[number];
    if (is_matched_[number] || !input.location) return;
    // Semantics say more than locations that are counted.
    if (!input.semantic.empty() && !input.is_placed) return;
    for (std::size_t i = 0; i < outputs_.size(); ++i) {
      const ir::IoVar& output = program_.outputs[i];
      // A place proves little where the types differ.
      const bool is_there = IsFree(i) && output.location == *input.location &&
                            (input.semantic.empty() || output.is_placed) &&
                            GlslTypeAt(i) == ElementType(input);
      if (is_there && TryMatch(number, i)) return;
    }
  }

  // Matches the inputs and outputs that are left after names and places in their order, if they are
  // as many and of the same types.
  void ByOrder() {
    std::vector<std::size_t> inputs, outputs;
    for (std::size_t i = 0; i < is_matched_.size(); ++i) {
      const Input& input = pixel_.inputs[i];
      if (!is_matched_[i] && input.semantic.empty() && !input.location) inputs.push_back(i);
    }
    for (std::size_t i = 0; i < outputs_.size(); ++i) {
      if (IsFree(i)) outputs.push_back(i);
    }
    const bool fit =
        std::ranges::equal(inputs, outputs, [&](std::size_t input, std::size_t output) {
          return pixel_.inputs[input].type == GlslTypeAt(output);
        });
    for (std::size_t i = 0; fit && i < inputs.size(); ++i) TryMatch(inputs[i], outputs[i]);
  }

  // ---- matching

  // An output that no path writes matches nothing: the pixel shader would read what is undefined.
  // Neither does one of a stream after the first, which alone is drawn.
  bool IsFree(std::size_t output) const {
    const ir::IoVar& io = program_.outputs[output];
    return io.builtin == ir::Builtin::kNone && !io.is_unwritten && !outputs_[output].input &&
           StreamOf(program_, io.var) == 0;
  }
  GlslType GlslTypeAt(std::size_t output) const {
    return link::GlslTypeOf(program_.types, program_.vars[program_.outputs[output].var].type)
        .value_or(GlslType{});
  }

  static GlslType ElementType(const Input& input) {
    GlslType type = input.type;
    type.columns = 1;
    type.dimensions.clear();
    return type;
  }

  // The output that is `element` elements after the first in one matrix or array; if there is none,
  // the output of the same semantic whose index is `element` higher; otherwise none.
  std::optional<std::size_t> ElementAfter(std::size_t first, std::uint32_t element) const {
    const ir::IoVar& start = program_.outputs[first];
    const std::size_t next = first + element;
    if (next < outputs_.size() && IsFree(next) && VariableOf(next) == VariableOf(first))
      return next;
    for (std::size_t i = 0; i < outputs_.size(); ++i) {
      const ir::IoVar& output = program_.outputs[i];
      if (IsFree(i) && output.index == start.index + element &&
          EqualIgnoringCase(output.semantic, start.semantic)) {
        return i;
      }
    }
    return std::nullopt;
  }

  // The variable that an output is a part of: "o.uv" of "o.uv[1]".
  std::string_view VariableOf(std::size_t output) const {
    const std::string_view path = program_.outputs[output].path;
    return path.substr(0, path.find('['));
  }

  // Matches an input with the outputs from `first` on, one for each element of an array or a
  // matrix; matches nothing and returns false if one is missing.
  bool TryMatch(std::size_t number, std::size_t first) {
    if (!IsFree(first) || program_.outputs[first].is_of_patch != pixel_.inputs[number].is_of_patch)
      return false;
    std::vector<std::size_t> elements{first};
    for (std::uint32_t i = 1; i < pixel_.inputs[number].type.Elements(); ++i) {
      const auto next = ElementAfter(first, i);
      if (!next) return false;
      elements.push_back(*next);
    }
    for (std::uint32_t i = 0; i < elements.size(); ++i) outputs_[elements[i]] = {number, i};
    is_matched_[number] = true;
    return true;
  }

  // ---- inputs without an output that fits

  void Check(std::size_t number) {
    const Input& input = pixel_.inputs[number];
    // The members of a group are all declared, written or not.
    const bool is_needed = input.is_read || (options_.is_vulkan && !input.group);
    if (!is_matched_[number]) {
      if (!is_needed) return;
      if (options_.zero_unwritten || !input.is_read) zeros_.push_back(number);
      if (!input.is_read) return;
      const auto& kind =
          options_.zero_unwritten ? diag::PixelInputIsZero : diag::PixelInputUnwritten;
      NoteHere(diagnostics_.Report(EntrySpan(), kind, InfoOf(program_.stage).name, ReaderName(),
                                   NameOf(input)),
               input);
      return;
    }
    for (std::size_t i = 0; i < outputs_.size(); ++i) {
      if (outputs_[i].input != number) continue;
      if (is_needed) {
        CheckType(input, i);
      } else {
        outputs_[i].input.reset();
      }
    }
  }

  void CheckType(const Input& input, std::size_t number) {
    const ir::IoVar& output = program_.outputs[number];
    const Span span = program_.vars[output.var].span;
    const GlslType type = GlslTypeAt(number);
    const bool is_float = type.scalar == ir::Scalar::kFloat || type.scalar == ir::Scalar::kDouble;
    const bool fits =
        is_float ? type.scalar == input.type.scalar : ir::IsInteger(input.type.scalar);
    const bool lacks_components =
        input.is_read &&
        (input.components_read & ((1u << input.type.components) - 1)) >> type.components;
    if (fits && !lacks_components) return;
    const auto& kind = fits ? diag::PixelComponentsUnwritten : diag::PixelInputType;
    NoteHere(diagnostics_.Report(span, kind, names_[number].semantic, NameOf(type), ReaderName(),
                                 NameOf(input.type)),
             input);
  }

  void NoteHere(Diagnostic& report, const Input& input) const {
    report.Note({}, diag::PixelInputHere, input.where, ReaderName(), NameOf(input),
                NameOf(input.type));
  }

  std::string_view ReaderName() const { return InfoOf(pixel_.stage).name; }
  Span EntrySpan() const { return program_.functions[program_.entry].span; }
  std::string NameOf(const Input& input) const {
    if (!input.semantic.empty()) return input.semantic + std::to_string(input.index);
    const bool has_instance = input.group && !pixel_.groups[*input.group].instance.empty();
    return has_instance ? pixel_.groups[*input.group].instance + "." + input.name : input.name;
  }
  static std::string NameOf(const GlslType& type) { return link::NameOf(type); }

  const ir::Program& program_;
  const Interface& pixel_;
  const MatchOptions& options_;
  Diagnostics& diagnostics_;
  std::vector<OutputNames> names_;  // beside program.outputs
  std::vector<Output> outputs_;
  std::vector<bool> is_matched_;  // beside pixel.inputs
  std::vector<std::size_t> zeros_;
};

}  // namespace

Matches MatchInputs(const ir::Program& program, const Interface& pixel, const MatchOptions& options,
                    Diagnostics& diagnostics) {
  return InputMatcher(program, pixel, options, diagnostics).Run();
}

}  // namespace clipc::link
