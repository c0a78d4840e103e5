// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/effect/captures.h"

#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/spelling.h"

namespace clipc {
namespace {

constexpr std::string_view kSkip = "$SKIP";

std::string_view Trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == text.npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
}

// A number at the end of the text or none, which is 0, and takes it off.
std::uint32_t TakeNumber(std::string_view& text) {
  const std::size_t begin = text.find_last_not_of("0123456789") + 1;
  std::uint32_t number = 0;
  std::from_chars(text.data() + begin, text.data() + text.size(), number);
  text = text.substr(0, begin);
  return number;
}

EffectCaptureFact ReadCapture(std::string_view text, std::uint32_t stream) {
  EffectCaptureFact fact{.stream = stream};
  if (const std::size_t colon = text.find(':'); colon != text.npos) {
    std::string_view slot = Trimmed(text.substr(0, colon));
    fact.slot = TakeNumber(slot);
    text = Trimmed(text.substr(colon + 1));
  }
  if (const std::size_t point = text.find('.'); point != text.npos) {
    fact.components = Trimmed(text.substr(point + 1));
    text = Trimmed(text.substr(0, point));
  }
  fact.index = TakeNumber(text);
  fact.semantic = text;
  return fact;
}

// The outputs of the last stage before the pixels; null if no stage is described.
const std::vector<VariableFact>* OutputsOf(const Facts* facts) {
  if (!facts) return nullptr;
  const auto draws = [](const StageFacts& stage) { return !stage.draws_pixels; };
  const auto last = std::find_if(facts->stages.rbegin(), facts->stages.rend(), draws);
  return last == facts->stages.rend() ? nullptr : &last->outputs;
}

std::string TextOf(const EffectCaptureFact& capture) {
  return fmt::format("{}{}", capture.semantic,
                     capture.index == 0 ? "" : std::to_string(capture.index));
}

}  // namespace

std::vector<EffectCaptureFact> ReadCaptures(const std::vector<std::string>& streams,
                                            const Facts* facts) {
  const std::vector<VariableFact>* const outputs = OutputsOf(facts);
  std::vector<EffectCaptureFact> captures;
  for (std::size_t stream = 0; stream < streams.size(); ++stream) {
    std::string_view left = streams[stream];
    while (!left.empty()) {
      const std::string_view part = left.substr(0, left.find(';'));
      left.remove_prefix(std::min(part.size() + 1, left.size()));
      if (Trimmed(part).empty()) continue;
      EffectCaptureFact capture = ReadCapture(Trimmed(part), static_cast<std::uint32_t>(stream));
      const auto is_it = [&](const VariableFact& output) {
        return EqualIgnoringCase(output.semantic, capture.semantic) &&
               output.index == capture.index && output.stream.value_or(stream) == stream;
      };
      if (outputs) {
        const auto output = std::ranges::find_if(*outputs, is_it);
        if (output != outputs->end()) capture.name = output->name;
      }
      captures.push_back(std::move(capture));
    }
  }
  return captures;
}

void CheckCaptures(const EffectFacts& effect, bool for_header, Diagnostics& diagnostics) {
  for (const EffectTechniqueFact& technique : effect.techniques) {
    for (const EffectPassFact& pass : technique.passes) {
      const Span span = pass.text.geometry.span;
      for (const EffectProgramFact& program : pass.programs) {
        if (!program.captures.empty() && (for_header || effect.is_for_vulkan))
          diagnostics.Report(span, diag::EffectCaptureNotWritten, pass.text.name,
                             for_header ? "the header of -Fh begins no capture"
                                        : "shaders for Vulkan have no decorations for that");
        for (const EffectCaptureFact& capture : program.captures) {
          if (program.code && capture.name.empty() && capture.semantic != kSkip)
            diagnostics.Report(span, diag::EffectCaptureUnknown, TextOf(capture));
        }
      }
    }
  }
}

}  // namespace clipc
