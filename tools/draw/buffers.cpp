// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/buffers.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>
#include <variant>

#include "ir/scalar.h"
#include "tools/draw/textures.h"

namespace clipc::draw {
namespace {

using ir::ObjectKind;
using ir::ObjectOp;

// More than the numbers of vertices and random indices, which stay small.
constexpr std::uint32_t kLeastElements = 192, kMoreElements = 9, kLeastBytes = 4096;

std::uint32_t SizeOf(ir::Scalar kind) {
  const ir::Scalar base = ir::BaseOf(kind);
  return base == ir::Scalar::kDouble || base == ir::Scalar::kInt64 || base == ir::Scalar::kUint64
             ? 8
             : 4;
}

std::uint32_t RoundUp(std::uint32_t value, std::uint32_t multiple) {
  return (value + multiple - 1) / multiple * multiple;
}

void Write(Buffer& buffer, std::uint32_t byte, std::uint64_t bits, std::uint32_t size) {
  std::memcpy(&buffer.at(byte + size - 1) - (size - 1), &bits, size);
}

std::uint64_t ReadBits(const Buffer& buffer, std::uint32_t byte, std::uint32_t size) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &buffer.at(byte + size - 1) - (size - 1), size);
  return bits;
}

Buffer Typed(const ir::Program& program, const ir::Type& type, RandomValues& values) {
  Buffer buffer(16 * std::size_t{kLeastElements + values.Below(kMoreElements)});
  const ir::Scalar kind = type.element ? program.types[type.element].scalar : ir::Scalar::kFloat;
  for (std::uint32_t byte = 0; byte < buffer.size(); byte += 4)
    Write(buffer, byte, values.Next(kind), 4);
  return buffer;
}

Buffer Structured(const ir::Program& program, const ir::Type& type, bool row_major,
                  RandomValues& values) {
  const std::uint32_t stride = StructuredSizeOf(program.types, type.element).size;
  const std::uint32_t count = kLeastElements + values.Below(kMoreElements);
  Buffer buffer(std::size_t{stride} * count);
  for (std::uint32_t i = 0; i < count; ++i) {
    ForEachStructured(program.types, type.element, row_major, i * stride,
                      [&](ir::Scalar kind, std::uint32_t byte) {
                        Write(buffer, byte, values.Next(kind), SizeOf(kind));
                      });
  }
  return buffer;
}

// Half of the words are small numbers, the others floats: nothing says what they are for.
Buffer Bytes(RandomValues& values) {
  Buffer buffer(kLeastBytes + 4 * values.Below(16));
  for (std::uint32_t byte = 0; byte < buffer.size(); byte += 4) {
    Write(buffer, byte, values.Next(values.Below(2) == 0 ? ir::Scalar::kUint : ir::Scalar::kFloat),
          4);
  }
  return buffer;
}

bool IsBuffer(ObjectKind kind) { return kind == ObjectKind::kBuffer || ir::IsStorageBuffer(kind); }

void RefuseStores(const ir::Program& program) {
  for (const ir::ExprId id : program.exprs.ids()) {
    const auto* call = std::get_if<ir::ObjectCall>(&program.exprs[id].node);
    if (!call || call->op != ObjectOp::kStore) continue;
    throw DrawError("the shader writes to a texture or buffer, which no test draws with");
  }
  for (const ir::Resource& resource : program.resources) {
    if (!ir::IsImage(ObjectTypeOf(program, resource.var).object)) continue;
    throw DrawError("the shader reads the image `" + program.vars[resource.var].name +
                    "`, which no test draws with");
  }
}

// Puts the answer to a request into `result`.
class Reader {
 public:
  Reader(const ir::Program& program, const Buffer& buffer, const ir::ObjectRequest& request,
         double undefined, std::span<std::uint64_t> result)
      : program_(program),
        type_(ObjectTypeOf(program, request.object)),
        buffer_(buffer),
        request_(request),
        undefined_(undefined),
        result_(result) {}

  void Read() {
    switch (request_.op) {
      case ObjectOp::kBufferLoad: return Load();
      case ObjectOp::kStructuredLoad: return LoadStructured();
      case ObjectOp::kByteLoad: return LoadWords();
      case ObjectOp::kBufferSize: result_[0] = buffer_.size() / Stride(); return;
      default: throw DrawError("the evaluator asks a buffer for what it does not have");
    }
  }

 private:
  std::uint32_t Stride() const {
    if (ir::IsByteAddress(type_.object)) return 1;
    return ir::IsStructured(type_.object)
               ? std::max(StructuredSizeOf(program_.types, type_.element).size, 1u)
               : 16;
  }

  std::uint64_t Component(std::uint64_t byte, ir::Scalar kind, std::size_t component) const {
    const std::uint32_t size = SizeOf(kind);
    if (byte % 4 != 0 || byte + size > buffer_.size())
      return UndefinedBits(request_, undefined_, kind, component);
    const std::uint64_t bits = ReadBits(buffer_, static_cast<std::uint32_t>(byte), size);
    return ir::BaseOf(kind) == ir::Scalar::kBool ? bits != 0 : bits;
  }

  void Load() {
    const std::uint64_t first = std::uint64_t{ir::UintOf(request_.arguments[0])} * 16;
    const ir::Scalar kind =
        type_.element ? program_.types[type_.element].scalar : ir::Scalar::kFloat;
    for (std::size_t i = 0; i < result_.size(); ++i) result_[i] = Component(first + 4 * i, kind, i);
  }

  void LoadStructured() {
    const std::uint64_t first = std::uint64_t{ir::UintOf(request_.arguments[0])} * Stride();
    std::size_t next = 0;
    ForEachStructured(program_.types, type_.element, program_.vars[request_.object].row_major, 0,
                      [&](ir::Scalar kind, std::uint32_t byte) {
                        result_[next] = Component(first + byte, kind, next);
                        ++next;
                      });
  }

  void LoadWords() {
    const std::uint64_t first = ir::UintOf(request_.arguments[0]);
    for (std::size_t i = 0; i < result_.size(); ++i)
      result_[i] = Component(first + 4 * i, ir::Scalar::kUint, i);
  }

  const ir::Program& program_;
  const ir::Type& type_;
  const Buffer& buffer_;
  const ir::ObjectRequest& request_;
  const double undefined_;
  std::span<std::uint64_t> result_;
};

}  // namespace

StructuredSize StructuredSizeOf(const ir::TypeTable& types, ir::TypeId id) {
  const ir::Type& type = types[id];
  if (type.kind == ir::TypeKind::kArray) {
    const StructuredSize element = StructuredSizeOf(types, type.element);
    return {element.size * type.count, element.alignment};
  }
  if (type.kind != ir::TypeKind::kStruct)
    return {SizeOf(type.scalar) * type.Components(), SizeOf(type.scalar)};
  StructuredSize all;
  for (const ir::Field& field : types[type.structure].fields) {
    const StructuredSize place = StructuredSizeOf(types, field.type);
    all.size = RoundUp(all.size, place.alignment) + place.size;
    all.alignment = std::max(all.alignment, place.alignment);
  }
  all.size = RoundUp(all.size, all.alignment);
  return all;
}

void ForEachStructured(const ir::TypeTable& types, ir::TypeId id, bool row_major,
                       std::uint32_t offset,
                       const std::function<void(ir::Scalar kind, std::uint32_t byte)>& visit) {
  const ir::Type type = types[id];
  if (type.kind == ir::TypeKind::kArray) {
    const std::uint32_t stride = StructuredSizeOf(types, type.element).size;
    for (std::uint32_t i = 0; i < type.count; ++i)
      ForEachStructured(types, type.element, row_major, offset + i * stride, visit);
    return;
  }
  if (type.kind == ir::TypeKind::kStruct) {
    for (const ir::Field& field : types[type.structure].fields) {
      const StructuredSize place = StructuredSizeOf(types, field.type);
      offset = RoundUp(offset, place.alignment);
      ForEachStructured(types, field.type, field.row_major, offset, visit);
      offset += place.size;
    }
    return;
  }
  const std::uint32_t size = SizeOf(type.scalar);
  for (std::uint32_t row = 0; row < type.rows; ++row) {
    for (std::uint32_t column = 0; column < type.columns; ++column) {
      const bool by_row = type.kind != ir::TypeKind::kMatrix || row_major;
      visit(type.scalar,
            offset + size * (by_row ? row * type.columns + column : column * type.rows + row));
    }
  }
}

Buffers MakeBuffers(const ir::Program& program, RandomValues& values) {
  RefuseStores(program);
  Buffers buffers;
  for (const ir::Resource& resource : program.resources) {
    const ir::Type& type = ObjectTypeOf(program, resource.var);
    if (!IsBuffer(type.object)) continue;
    for (std::size_t i = 0; i < ElementIndices(program, resource.var).size(); ++i) {
      buffers[resource.var.index].push_back(
          ir::IsByteAddress(type.object) ? Bytes(values)
          : ir::IsStructured(type.object)
              ? Structured(program, type, program.vars[resource.var].row_major, values)
              : Typed(program, type, values));
    }
  }
  return buffers;
}

void ReadBuffer(const ir::Program& program, const Buffers& buffers,
                const ir::ObjectRequest& request, double undefined,
                std::span<std::uint64_t> result) {
  const std::vector<Buffer>& elements = buffers.at(request.object.index);
  static const Buffer kNothing;
  const bool exists = request.object_element < elements.size();
  Reader(program, exists ? elements[request.object_element] : kNothing, request, undefined, result)
      .Read();
}

void GiveBuffers(const ir::Program& program, const glsl::GlslInfo& info, const Buffers& buffers,
                 Inputs& inputs) {
  for (const glsl::GlslInfo::Object& object : info.objects) {
    const auto found = object.texture ? buffers.find(object.texture.index) : buffers.end();
    if (found == buffers.end()) continue;
    const ir::Type& type = ObjectTypeOf(program, object.texture);
    const std::vector<std::string> indices = ElementIndices(program, object.texture);
    for (std::size_t i = 0; i < indices.size(); ++i) {
      const Buffer& bytes = found->second[i];
      if (ir::IsStorageBuffer(type.object)) {
        inputs.storage.push_back({object.name + indices[i],
                                  object.binding.value() + static_cast<std::uint32_t>(i), bytes});
        continue;
      }
      Inputs::Texture upload;
      upload.name = object.name + indices[i];
      upload.target = GL_TEXTURE_BUFFER;
      const ir::Scalar kind =
          type.element ? ir::BaseOf(program.types[type.element].scalar) : ir::Scalar::kFloat;
      upload.kind = KindOfTexels(kind);
      auto& level = upload.levels.emplace_back();
      level.words.resize(bytes.size() / 4);
      std::memcpy(level.words.data(), bytes.data(), bytes.size());
      inputs.textures.push_back(std::move(upload));
    }
  }
}

}  // namespace clipc::draw
