// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/dispatch.h"

#include <cstring>
#include <optional>

#include "ir/scalar.h"
#include "tools/draw/memory.h"
#include "tools/draw/textures.h"

namespace clipc::draw {
namespace {

using namespace ir;

// How the evaluator runs the dispatch.
struct DispatchRun {
  double undefined = 0;
  bool in_double = false;
  bool is_reversed = false;  // the last thread of the last group runs first
  std::uint32_t first_group = 0;
};

// Number `index` of the groups.
std::array<std::uint32_t, 3> GroupAt(std::uint32_t index) {
  return {index % kGroups[0], index / kGroups[0] % kGroups[1], index / (kGroups[0] * kGroups[1])};
}

// The buffers after the dispatch. Throws DrawError where the evaluator stops.
Buffers RunDispatch(const Program& program, const RandomInputs& inputs, const DispatchRun& run) {
  Buffers buffers = inputs.buffers;
  EvalInputs of_thread;
  of_thread.cbuffers = inputs.cbuffers;
  of_thread.read_object = [&](const ObjectRequest& request, std::span<std::uint64_t> result) {
    inputs.UseObject(program, buffers, request, run.undefined, result);
  };
  of_thread.remember = [&] { return [&buffers, old = buffers] { buffers = old; }; };
  const std::uint32_t count = kGroups[0] * kGroups[1] * kGroups[2];
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t group = (run.is_reversed ? count - 1 - i : i) + run.first_group;
    const GroupResult result =
        RunGroup(program, of_thread, {GroupAt(group % count), run.is_reversed, inputs.lanes},
                 {.in_double = run.in_double, .undefined = run.undefined});
    if (!result) throw DrawError("the reference evaluator stops: " + result.error);
  }
  return buffers;
}

// Marks what is another value in a run; everything if that run does not end.
void MarkOpen(const Shader& shader, const RandomInputs& inputs, const DispatchRun& run,
              const std::vector<MemoryPart>& parts, std::vector<Expected>& all) {
  std::optional<Buffers> other;
  try {
    other = RunDispatch(shader.typed, inputs, run);
  } catch (const DrawError&) {
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Words words =
        other ? WordsIn(other->at(parts[i].var.index)[parts[i].element], parts[i]) : Words();
    for (std::size_t k = 0; k < all[i].words.size(); ++k) {
      if (!other || words[k] != all[i].words[k]) all[i].open[k] = true;
    }
  }
}

}  // namespace

std::vector<MemoryPart> WrittenParts(const Shader& shader, const RandomInputs& inputs) {
  const Program& program = shader.typed;
  std::vector<MemoryPart> parts;
  for (const GlslInfo::Object& object : shader.info.objects) {
    if (!object.texture || !inputs.buffers.contains(object.texture.index)) continue;
    const Type& type = ObjectTypeOf(program, object.texture);
    if (!IsWritable(type.object)) continue;
    const std::vector<std::string> indices = ElementIndices(program, object.texture);
    for (std::size_t i = 0; i < indices.size(); ++i) {
      MemoryPart part;
      part.object = object.name + indices[i];
      part.var = object.texture, part.element = i;
      const auto add = [&](Scalar kind, std::uint32_t first) {
        if (IsWide(kind)) throw DrawError("a buffer of 64 bits, which no test dispatches with");
        part.kind = BaseOf(kind), part.first = first;
        part.name = part.object + "." + std::to_string(first / 4);
        parts.push_back(part);
      };
      part.is_image = IsImage(type.object);
      if (part.is_image) {
        part.stride = 16;
        const std::uint32_t count = type.element ? program.types[type.element].Components() : 4;
        for (std::uint32_t c = 0; c < count; ++c) add(ElementKind(program, object.texture), 4 * c);
      } else if (IsByteAddress(type.object)) {
        add(Scalar::kUint, 0);
      } else {
        part.stride = StructuredSizeOf(program.types, type.element).size;
        ForEachComponent(program.types, type.element, program.vars[object.texture].row_major, 0,
                         add, Packing::kStructured);
      }
    }
  }
  return parts;
}

Words WordsIn(const Bytes& buffer, const MemoryPart& part) {
  Words words;
  for (std::size_t at = part.first; at + 4 <= buffer.size(); at += part.stride) {
    std::uint32_t& word = words.emplace_back();
    std::memcpy(&word, &buffer[at], sizeof word);
    if (part.kind == Scalar::kBool) word = word != 0 ? 1 : 0;
  }
  return words;
}

Bytes MemoryOfTexels(const Inputs::Texture& image, std::span<const std::uint32_t> words) {
  constexpr std::size_t kTexelWords = 4;
  const auto components = static_cast<std::size_t>(image.components);
  Bytes bytes(4 * kTexelWords * (words.size() / components));
  for (std::size_t i = 0; i < words.size(); ++i)
    std::memcpy(&bytes[4 * (i / components * kTexelWords + i % components)], &words[i], 4);
  return bytes;
}

std::vector<Captured> CapturedMemory(const Shader& shader, const RandomInputs& inputs,
                                     const std::map<std::string, Bytes>& memory) {
  std::vector<Captured> captured;
  for (const MemoryPart& part : WrittenParts(shader, inputs)) {
    const auto found = memory.find(part.object);
    if (found == memory.end()) continue;
    const WordKind kind = part.kind == Scalar::kFloat ? WordKind::kFloat
                          : part.kind == Scalar::kInt ? WordKind::kInt
                                                      : WordKind::kUint;
    captured.push_back({part.name, {kind, 1, 1}, 1, WordsIn(found->second, part)});
  }
  return captured;
}

std::vector<Expected> ExpectedOfDispatch(const Shader& shader, const RandomInputs& inputs) {
  const std::vector<MemoryPart> parts = WrittenParts(shader, inputs);
  const Buffers in_float = RunDispatch(shader.typed, inputs, {});
  const Buffers in_double = RunDispatch(shader.typed, inputs, {.in_double = true});
  std::vector<Expected> all;
  for (const MemoryPart& part : parts) {
    const Scalar kind = part.kind == Scalar::kBool ? Scalar::kUint : part.kind;
    Expected expected{part.name, kind, 1, {}, {}, {}};
    expected.words = WordsIn(in_float.at(part.var.index)[part.element], part);
    for (const std::uint32_t word : WordsIn(in_double.at(part.var.index)[part.element], part))
      expected.numbers.push_back(NumberOf(word, kind));
    expected.open.resize(expected.words.size());
    all.push_back(std::move(expected));
  }
  for (const double undefined : {1.0, 3.0, -2.5, 0.125, 5.0, -7.5})
    MarkOpen(shader, inputs, {.undefined = undefined}, parts, all);
  MarkOpen(shader, inputs, {.is_reversed = true}, parts, all);
  // The middle of a list that threads append to is the same from both ends.
  MarkOpen(shader, inputs, {.first_group = 1}, parts, all);
  return all;
}

}  // namespace clipc::draw
