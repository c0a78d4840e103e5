// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/buffers.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

#include "ir/scalar.h"
#include "tools/draw/images.h"
#include "tools/draw/memory.h"
#include "tools/draw/textures.h"

namespace clipc::draw {
namespace {

using namespace ir;

// The sizes of random buffers: more than the numbers of vertices and random indices, which stay
// small.
constexpr std::uint32_t kLeastElements = 192, kMoreElements = 9, kLeastBytes = 4096;
// The counter of a buffer: far from both ends.
constexpr std::uint32_t kCounter = kLeastElements / 2;

void Write(Buffer& buffer, std::uint32_t byte, std::uint64_t bits, std::uint32_t size) {
  std::memcpy(&buffer.at(byte + size - 1) - (size - 1), &bits, size);
}

std::uint64_t ReadBits(const Buffer& buffer, std::uint32_t byte, std::uint32_t size) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &buffer.at(byte + size - 1) - (size - 1), size);
  return bits;
}

Buffer Typed(Scalar kind, RandomValues& values) {
  Buffer buffer(16 * std::size_t{kLeastElements + values.Below(kMoreElements)});
  for (std::uint32_t byte = 0; byte < buffer.size(); byte += 4)
    Write(buffer, byte, values.Next(kind), 4);
  return buffer;
}

Buffer Structured(const Program& program, const Type& type, bool row_major, RandomValues& values) {
  const std::uint32_t stride = StructuredSizeOf(program.types, type.element).size;
  const std::uint32_t count = kLeastElements + values.Below(kMoreElements);
  Buffer buffer(std::size_t{stride} * count);
  for (std::uint32_t i = 0; i < count; ++i) {
    ForEachComponent(
        program.types, type.element, row_major, i * stride,
        [&](Scalar kind, std::uint32_t byte) {
          Write(buffer, byte, values.Next(kind), ByteSize(kind));
        },
        Packing::kStructured);
  }
  return buffer;
}

// Makes a buffer of words of which half are small numbers and the others floats, since the program
// does not declare their types.
Buffer ByteAddress(RandomValues& values) {
  Buffer buffer(kLeastBytes + 4 * values.Below(16));
  for (std::uint32_t byte = 0; byte < buffer.size(); byte += 4) {
    Write(buffer, byte, values.Next(values.Below(2) == 0 ? Scalar::kUint : Scalar::kFloat), 4);
  }
  return buffer;
}

bool IsBuffer(ObjectKind kind) { return kind == ObjectKind::kBuffer || IsStorageBuffer(kind); }

// An access to a buffer, which carries out a request and puts the answer into `result`.
class Access {
 public:
  Access(const Program& program, Buffer& buffer, const ObjectRequest& request, double undefined,
         std::span<std::uint64_t> result)
      : program_(program),
        type_(ObjectTypeOf(program, request.object)),
        buffer_(buffer),
        request_(request),
        undefined_(undefined),
        result_(result) {}

  void Do() {
    if (IsAtomic(request_.op)) return Change();
    switch (request_.op) {
      case ObjectOp::kBufferLoad: return Load();
      case ObjectOp::kStructuredLoad: return LoadStructured();
      case ObjectOp::kByteLoad: return LoadWords();
      case ObjectOp::kBufferSize: result_[0] = buffer_.size() / Stride(); return;
      case ObjectOp::kStore: return IsByteAddress(type_.object) ? StoreWords() : StoreStructured();
      default: throw DrawError("the evaluator asks a buffer for what it does not have");
    }
  }

 private:
  std::uint32_t Stride() const {
    if (IsByteAddress(type_.object)) return 1;
    return IsStructured(type_.object)
               ? std::max(StructuredSizeOf(program_.types, type_.element).size, 1u)
               : 16;
  }

  std::uint64_t Component(std::uint64_t byte, Scalar kind, std::size_t component) const {
    const std::uint32_t size = ByteSize(kind);
    if (byte % 4 != 0 || byte + size > buffer_.size())
      return UndefinedBits(request_, undefined_, kind, component);
    const std::uint64_t bits = ReadBits(buffer_, static_cast<std::uint32_t>(byte), size);
    return BaseOf(kind) == Scalar::kBool ? bits != 0 : bits;
  }

  void Load() {
    const std::uint64_t first = Place() * 16;
    const Scalar kind = ElementKind(program_, request_.object);
    for (std::size_t i = 0; i < result_.size(); ++i) result_[i] = Component(first + 4 * i, kind, i);
  }

  std::uint64_t Place() const { return UintOf(request_.Of(OperandKind::kPlace)[0]); }

  // Calls on_component(kind, byte in the buffer) for the element in the request's place.
  template <typename OnComponent>
  void ForEachInElement(OnComponent&& on_component) {
    const std::uint64_t first = Place() * Stride();
    ForEachComponent(
        program_.types, type_.element, program_.vars[request_.object].row_major, 0,
        [&](Scalar kind, std::uint32_t byte) { on_component(kind, first + byte); },
        Packing::kStructured);
  }

  void LoadStructured() {
    std::size_t next = 0;
    ForEachInElement([&](Scalar kind, std::uint64_t byte) {
      result_[next] = Component(byte, kind, next);
      ++next;
    });
  }

  void LoadWords() {
    const std::uint64_t first = Place();
    for (std::size_t i = 0; i < result_.size(); ++i)
      result_[i] = Component(first + 4 * i, Scalar::kUint, i);
  }

  void Store(std::uint64_t byte, Scalar kind, std::uint64_t bits) {
    const std::uint32_t size = ByteSize(kind);
    if (byte % 4 == 0 && byte + size <= buffer_.size())
      Write(buffer_, static_cast<std::uint32_t>(byte), bits, size);
  }

  void StoreStructured() {
    const std::size_t first = request_.part.value_or(0);
    const auto values = request_.Of(OperandKind::kValue);
    std::size_t component = 0;
    ForEachInElement([&](Scalar kind, std::uint64_t byte) {
      const std::size_t i = component++ - first;
      if (i < values.size()) Store(byte, kind, values[i]);
    });
  }

  void StoreWords() {
    std::uint64_t byte = Place();
    for (const std::uint64_t word : request_.Of(OperandKind::kValue)) {
      Store(byte, Scalar::kUint, word);
      byte += 4;
    }
  }

  void Change() {
    Scalar kind =
        IsByteAddress(type_.object) ? request_.kind : ElementKind(program_, request_.object);
    std::uint64_t byte = Place() * Stride();
    if (request_.part) {
      std::uint32_t next = 0;
      ForEachInElement([&](Scalar each, std::uint64_t at) {
        if (next++ == *request_.part) byte = at, kind = each;
      });
    }
    const auto old = static_cast<std::uint32_t>(Component(byte, kind, 0));
    if (!result_.empty()) result_[0] = old;
    Store(byte, kind, Combined(request_, kind, old));
  }

  const Program& program_;
  const Type& type_;
  Buffer& buffer_;
  const ObjectRequest& request_;
  const double undefined_;
  std::span<std::uint64_t> result_;
};

}  // namespace

std::uint32_t Combined(const ObjectRequest& request, Scalar kind, std::uint32_t old) {
  const std::uint32_t value = UintOf(request.Of(OperandKind::kValue)[0]);
  const bool is_less = BaseOf(kind) == Scalar::kInt
                           ? static_cast<std::int32_t>(value) < static_cast<std::int32_t>(old)
                           : value < old;
  switch (request.op) {
    case ObjectOp::kAtomicAdd: return old + value;
    case ObjectOp::kAtomicAnd: return old & value;
    case ObjectOp::kAtomicOr: return old | value;
    case ObjectOp::kAtomicXor: return old ^ value;
    case ObjectOp::kAtomicMin: return is_less ? value : old;
    case ObjectOp::kAtomicMax: return is_less ? old : value;
    case ObjectOp::kAtomicCompareExchange:
      return old == UintOf(request.Of(OperandKind::kComparand)[0]) ? value : old;
    default: return value;
  }
}

Buffers MakeBuffers(const Program& program, RandomValues& values) {
  Buffers buffers;
  for (const Resource& resource : program.resources) {
    const Type& type = ObjectTypeOf(program, resource.var);
    const bool is_image = IsImage(type.object);
    if (!IsBuffer(type.object) && !is_image) continue;
    for (std::size_t i = 0; i < ElementIndices(program, resource.var).size(); ++i) {
      buffers[resource.var.index].push_back(
          is_image                     ? MakeImage(program, resource.var, values)
          : IsByteAddress(type.object) ? ByteAddress(values)
          : IsStructured(type.object)
              ? Structured(program, type, program.vars[resource.var].row_major, values)
              : Typed(ElementKind(program, resource.var), values));
      if (resource.counter_of) Write(buffers[resource.var.index].back(), 0, kCounter, 4);
    }
  }
  return buffers;
}

void UseBuffer(const Program& program, Buffers& buffers, const ObjectRequest& request,
               double undefined, std::span<std::uint64_t> result) {
  std::vector<Buffer>& elements = buffers.at(request.object.index);
  Buffer nothing;
  const bool exists = request.object_element < elements.size();
  Buffer& element = exists ? elements[request.object_element] : nothing;
  if (IsImage(ObjectTypeOf(program, request.object).object))
    return UseImage(program, element, request, undefined, result);
  Access(program, element, request, undefined, result).Do();
}

void GiveBuffers(const Program& program, const GlslInfo& info, const Buffers& buffers,
                 Inputs& inputs) {
  for (const GlslInfo::Object& object : info.objects) {
    const auto found = object.texture ? buffers.find(object.texture.index) : buffers.end();
    if (found == buffers.end()) continue;
    const Type& type = ObjectTypeOf(program, object.texture);
    const std::vector<std::string> indices = ElementIndices(program, object.texture);
    for (std::size_t i = 0; i < indices.size(); ++i) {
      const Buffer& bytes = found->second[i];
      if (IsStorageBuffer(type.object)) {
        inputs.storage.push_back({object.name + indices[i],
                                  object.binding.value() + static_cast<std::uint32_t>(i), bytes});
        continue;
      }
      if (IsImage(type.object)) {
        const auto resource = std::ranges::find(program.resources, object.texture, &Resource::var);
        inputs.textures.push_back(UploadedImage(program, *resource, bytes));
        inputs.textures.back().name = object.name + indices[i];
        continue;
      }
      Inputs::Texture upload;
      upload.name = object.name + indices[i];
      upload.target = GL_TEXTURE_BUFFER;
      upload.kind = KindOfTexels(ElementKind(program, object.texture));
      upload.levels.emplace_back().words = WordsOf(bytes);
      inputs.textures.push_back(std::move(upload));
    }
  }
}

}  // namespace clipc::draw
