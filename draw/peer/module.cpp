// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "draw/peer/module.h"

#include <algorithm>
#include <cctype>
#include <spirv_cross/spirv_cross.hpp>

#include "draw/gl.h"

namespace clipc::draw::peer {
namespace {

using spirv_cross::SPIRType;

// Collects the bytes of a value's components.
class Walker {
 public:
  explicit Walker(const spirv_cross::Compiler& compiler) : compiler_(compiler) {}

  std::vector<std::uint32_t> Walk(const SPIRType& structure, std::uint32_t member) {
    bytes_.clear();
    Member(structure, member, 0);
    return bytes_;
  }

 private:
  struct Matrix {
    std::uint32_t stride = 0;
    bool row_major = false;
  };

  void Member(const SPIRType& structure, std::uint32_t index, std::uint32_t base) {
    const spirv_cross::TypeID self = structure.self;
    const bool has_stride = compiler_.has_member_decoration(self, index, spv::DecorationMatrixStride);
    const Matrix matrix{has_stride ? compiler_.type_struct_member_matrix_stride(structure, index) : 0,
                        compiler_.has_member_decoration(self, index, spv::DecorationRowMajor)};
    Value(structure.member_types[index], matrix, base + compiler_.get_member_decoration(self, index, spv::DecorationOffset));
  }

  void Value(spirv_cross::TypeID id, const Matrix& matrix, std::uint32_t base) {
    const SPIRType& type = compiler_.get_type(id);
    if (!type.array.empty()) {
      const std::uint32_t stride = compiler_.get_decoration(id, spv::DecorationArrayStride);
      for (std::uint32_t i = 0; i < type.array.back(); ++i) Value(type.parent_type, matrix, base + i * stride);
    } else if (type.basetype == SPIRType::Struct) {
      for (std::uint32_t i = 0; i < type.member_types.size(); ++i) Member(type, i, base);
    } else {
      // A matrix is the transposed one of HLSL's: its columns are HLSL's rows.
      for (std::uint32_t row = 0; row < type.columns; ++row) {
        for (std::uint32_t column = 0; column < type.vecsize; ++column) {
          bytes_.push_back(base + (matrix.row_major ? column * matrix.stride + 4 * row : row * matrix.stride + 4 * column));
        }
      }
    }
  }

  const spirv_cross::Compiler& compiler_;
  std::vector<std::uint32_t> bytes_;
};

Block BlockOf(const spirv_cross::Compiler& compiler, const spirv_cross::Resource& resource, bool is_storage) {
  const SPIRType& type = compiler.get_type(resource.base_type_id);
  Block block;
  const std::string variable = compiler.get_name(resource.id);
  block.name = variable.empty() ? compiler.get_name(resource.base_type_id) : variable;
  block.is_storage = is_storage;
  Walker walker(compiler);
  for (std::uint32_t i = 0; i < type.member_types.size(); ++i) {
    std::vector<std::uint32_t>& bytes = block.members[compiler.get_member_name(type.self, i)];
    bytes = walker.Walk(type, i);
    for (const std::uint32_t byte : bytes) block.size = std::max(block.size, (byte + 4 + 15) / 16 * 16);
  }
  return block;
}

bool IsTextureBuffer(const spirv_cross::Compiler& compiler, const spirv_cross::Resource& resource) {
  const SPIRType& type = compiler.get_type(resource.base_type_id);
  return !type.member_types.empty() && compiler.get_member_name(type.self, 0) != "@data" &&
         compiler.get_member_name(type.self, 0) != "@count";
}

template <typename Variables>
std::vector<Vector> Count(const Variables& variables) {
  std::map<std::string, std::uint32_t> used;  // vectors with that semantic so far: arrays come in parts
  std::vector<Vector> all;
  for (const auto& [semantic, location, locations] : variables) {
    std::string name = semantic;
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    const std::size_t digits = name.find_last_not_of("0123456789") + 1;
    const std::uint32_t first = digits < name.size() ? static_cast<std::uint32_t>(std::stoul(name.substr(digits))) : 0;
    std::uint32_t& next = used[name];
    for (std::uint32_t i = 0; i < locations; ++i) {
      all.push_back({name.substr(0, digits) + std::to_string(first + next++), location + i});
    }
  }
  return all;
}

struct Variable {
  std::string semantic;
  std::uint32_t location, locations;
};

}  // namespace

std::vector<Block> BlocksOf(const vulkan::Spirv& spirv) {
  try {
    const spirv_cross::Compiler compiler(spirv);
    const spirv_cross::ShaderResources resources = compiler.get_shader_resources();
    std::vector<Block> blocks;
    for (const spirv_cross::Resource& resource : resources.uniform_buffers) blocks.push_back(BlockOf(compiler, resource, false));
    for (const spirv_cross::Resource& resource : resources.storage_buffers) {
      if (IsTextureBuffer(compiler, resource)) blocks.push_back(BlockOf(compiler, resource, true));
    }
    return blocks;
  } catch (const spirv_cross::CompilerError& error) {
    throw DrawError(std::string("SPIRV-Cross cannot read the shader: ") + error.what());
  }
}

std::vector<Vector> InputsOf(const vulkan::Spirv& declared) {
  std::vector<Variable> variables;
  for (const vulkan::Reads::Attribute& read : vulkan::ReadsOf(declared).attributes) {
    variables.push_back({read.semantic, read.location, read.locations});
  }
  return Count(variables);
}

std::vector<Vector> OutputsOf(const vulkan::Spirv& declared) {
  std::vector<Variable> variables;
  for (const vulkan::Output& output : vulkan::OutputsOf(declared)) {
    if (!output.location) continue;
    variables.push_back({output.semantic, *output.location, static_cast<std::uint32_t>(output.count * output.shape.columns)});
  }
  return Count(variables);
}

}  // namespace clipc::draw::peer
