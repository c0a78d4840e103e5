// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/reference-compiler/module.h"

#include <algorithm>

#include <spirv_cross/spirv_cross.hpp>

#include "base/spelling.h"
#include "tools/draw/vulkan/reflect.h"

namespace clipc::draw::reference_compiler {
namespace {

using spirv_cross::Compiler;
using spirv_cross::Resource;
using spirv_cross::SPIRType;

// Collects the bytes of a value's components.
class Walker {
 public:
  explicit Walker(const Compiler& compiler) : compiler_(compiler) {}

  Offsets Walk(const SPIRType& structure, std::uint32_t member) {
    bytes_.clear();
    Member(structure, member, 0);
    return bytes_;
  }

  // The offsets of an element of the array that is the structure's first member.
  Offsets WalkElement(const SPIRType& structure) {
    bytes_.clear();
    Value(compiler_.get_type(structure.member_types[0]).parent_type, MatrixOf(structure, 0), 0);
    return bytes_;
  }

 private:
  struct Matrix {
    std::uint32_t stride = 0;
    bool row_major = false;
  };

  Matrix MatrixOf(const SPIRType& structure, std::uint32_t index) const {
    const bool has_stride =
        compiler_.has_member_decoration(structure.self, index, spv::DecorationMatrixStride);
    return {has_stride ? compiler_.type_struct_member_matrix_stride(structure, index) : 0,
            compiler_.has_member_decoration(structure.self, index, spv::DecorationRowMajor)};
  }

  void Member(const SPIRType& structure, std::uint32_t index, std::uint32_t base) {
    const std::uint32_t offset =
        compiler_.get_member_decoration(structure.self, index, spv::DecorationOffset);
    Value(structure.member_types[index], MatrixOf(structure, index), base + offset);
  }

  void Value(spirv_cross::TypeID id, const Matrix& matrix, std::uint32_t base) {
    const SPIRType& type = compiler_.get_type(id);
    if (!type.array.empty()) {
      const std::uint32_t stride = compiler_.get_decoration(id, spv::DecorationArrayStride);
      for (std::uint32_t i = 0; i < type.array.back(); ++i)
        Value(type.parent_type, matrix, base + i * stride);
    } else if (type.basetype == SPIRType::Struct) {
      for (std::uint32_t i = 0; i < type.member_types.size(); ++i) Member(type, i, base);
    } else {
      // A matrix is the transpose of HLSL's: its columns are HLSL's rows.
      for (std::uint32_t row = 0; row < type.columns; ++row) {
        for (std::uint32_t column = 0; column < type.vecsize; ++column) {
          bytes_.push_back(base + (matrix.row_major ? column * matrix.stride + 4 * row
                                                    : row * matrix.stride + 4 * column));
        }
      }
    }
  }

  const Compiler& compiler_;
  Offsets bytes_;
};

ReferenceBlock BlockOf(const Compiler& compiler, const Resource& resource, bool is_storage) {
  const SPIRType& type = compiler.get_type(resource.base_type_id);
  ReferenceBlock block;
  const std::string& variable = compiler.get_name(resource.id);
  block.name = variable.empty() ? compiler.get_name(resource.base_type_id) : variable;
  block.is_storage = is_storage;
  Walker walker(compiler);
  for (std::uint32_t i = 0; i < type.member_types.size(); ++i) {
    Offsets& bytes = block.members[compiler.get_member_name(type.self, i)];
    bytes = walker.Walk(type, i);
    for (const std::uint32_t byte : bytes)
      block.size = std::max(block.size, (byte + 4 + 15) / 16 * 16);
  }
  return block;
}

// Whether a storage buffer is a structured buffer, which holds one array of a name with `@`;
// tbuffers have the names of their members.
bool IsStructured(const Compiler& compiler, const Resource& resource) {
  const SPIRType& type = compiler.get_type(resource.base_type_id);
  return !type.member_types.empty() && compiler.get_member_name(type.self, 0).starts_with('@');
}

// "input.lights[1].color[0]" => "input.lights.color"
std::string WithoutIndices(const std::string& path) {
  std::string plain;
  for (std::size_t at = 0; at < path.size(); ++at) {
    if (path[at] == '[')
      at = path.find(']', at);
    else
      plain += path[at];
  }
  return plain;
}

struct Variable {
  std::string name, semantic;
  std::uint32_t location, locations;
};

std::vector<Vector> Count(const std::vector<Variable>& variables) {
  std::map<std::string, std::uint32_t>
      used;  // vectors of that variable so far: arrays come in parts
  std::vector<Vector> all;
  for (const auto& [path, semantic, location, locations] : variables) {
    const std::size_t digits = semantic.find_last_not_of("0123456789") + 1;
    const std::uint32_t first = digits < semantic.size() ? std::stoul(semantic.substr(digits)) : 0;
    std::uint32_t& next = used[WithoutIndices(path)];
    for (std::uint32_t i = 0; i < locations; ++i) {
      all.push_back({semantic.empty() ? "" : KeyOf(semantic.substr(0, digits), first + next++),
                     location + i});
    }
  }
  return all;
}

}  // namespace

std::string KeyOf(const std::string& semantic, std::uint32_t index) {
  return ToUpper(semantic + std::to_string(index));
}

std::vector<ReferenceBlock> BlocksOf(const Spirv& spirv) {
  return vulkan::Reflected(spirv, [](const Compiler& compiler) {
    const spirv_cross::ShaderResources resources = compiler.get_shader_resources();
    std::vector<ReferenceBlock> blocks;
    for (const Resource& resource : resources.uniform_buffers)
      blocks.push_back(BlockOf(compiler, resource, false));
    for (const Resource& resource : resources.storage_buffers) {
      if (!IsStructured(compiler, resource)) blocks.push_back(BlockOf(compiler, resource, true));
    }
    return blocks;
  });
}

std::vector<ReferenceElements> ElementsOf(const Spirv& spirv) {
  return vulkan::Reflected(spirv, [](const Compiler& compiler) {
    std::vector<ReferenceElements> all;
    for (const Resource& resource : compiler.get_shader_resources().storage_buffers) {
      if (!IsStructured(compiler, resource)) continue;
      const SPIRType& type = compiler.get_type(resource.base_type_id);
      const spirv_cross::TypeID array = type.member_types[0];
      all.push_back({compiler.get_name(resource.id),
                     compiler.get_decoration(array, spv::DecorationArrayStride),
                     Walker(compiler).WalkElement(type)});
    }
    return all;
  });
}

std::vector<Vector> InputsOf(const Spirv& declared) {
  std::vector<Variable> variables;
  for (const Reads::Attribute& read : vulkan::ReadsOf(declared).attributes) {
    variables.push_back({read.name, read.semantic, read.location, read.locations});
  }
  return Count(variables);
}

std::vector<Vector> OutputsOf(const Spirv& declared) {
  std::vector<Variable> variables;
  for (const Output& output : vulkan::OutputsOf(declared)) {
    if (!output.location) continue;
    variables.push_back({output.name, output.semantic, *output.location,
                         static_cast<std::uint32_t>(output.count * output.layout.columns)});
  }
  return Count(variables);
}

}  // namespace clipc::draw::reference_compiler
