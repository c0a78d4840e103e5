// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <limits>

#include "clip-table/read.h"
#include "clip-table/write.h"

// Formats: the custom-data block as write.h says; DXBC containers and token streams as
// d3d12TokenizedProgramFormat.hpp ("Version Token", "Instruction Length", "Custom-Data Block
// Format") says.
namespace clipc::clip_table {
namespace {

constexpr std::uint32_t kCustomData = 0x35;  // D3D10_SB_OPCODE_CUSTOMDATA
constexpr std::uint32_t kClipPlaneMappings = 5;
constexpr std::uint32_t kBlockToken = kCustomData | kClipPlaneMappings << 11;
constexpr std::uint32_t kHeaderDwords = 3;
constexpr std::uint32_t kRecordDwords = 2;

constexpr std::uint32_t FourCc(const char (&text)[5]) {
  std::uint32_t code = 0;
  for (int i = 3; i >= 0; --i) code = code << 8 | static_cast<unsigned char>(text[i]);
  return code;
}

// DWORDs of a file; the numbers in messages are byte offsets in that file.
class Dwords {
 public:
  Dwords(std::string_view bytes, std::size_t file_offset) : bytes_(bytes), offset_(file_offset) {}

  std::size_t size() const { return bytes_.size() / 4; }
  std::uint32_t operator[](std::size_t index) const {
    std::uint32_t value = 0;
    for (int i = 3; i >= 0; --i)
      value = value << 8 | static_cast<unsigned char>(bytes_[4 * index + i]);
    return value;
  }
  Dwords From(std::size_t index) const { return {bytes_.substr(4 * index), offset_ + 4 * index}; }
  Dwords First(std::size_t count) const { return {bytes_.substr(0, 4 * count), offset_}; }
  std::string Where(std::size_t index) const {
    return " at byte " + std::to_string(offset_ + 4 * index);
  }

 private:
  std::string_view bytes_;
  std::size_t offset_;
};

void Put(std::string& bytes, std::uint32_t value, int count) {
  for (int i = 0; i < count; ++i) bytes.push_back(static_cast<char>(value >> 8 * i));
}

// Reads the clip plane block that fills `block`: its length was checked against the bytes that are
// there.
Result<ClipTable> ReadBlock(Dwords block) {
  const std::uint32_t count = block[2];
  if (count > kMaxClipPlanes || block.size() != kHeaderDwords + kRecordDwords * count) {
    return Problem{"a block of " + std::to_string(block.size()) + " DWORDs" + block.Where(1) +
                   " claims to hold " + std::to_string(count) + " clip planes"};
  }
  ClipTable table;
  table.lowering = Lowering::kLevel9;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::size_t at = kHeaderDwords + kRecordDwords * i;
    const std::uint32_t first = block[at] >> 16;
    const std::uint32_t registers = block[at + 1] & 0xffff;
    if (registers == 0 || table.planes.size() + registers > kMaxClipPlanes) {
      return Problem{"record " + std::to_string(i) + block.Where(at) + " maps " +
                     std::to_string(registers) + " registers; all records together map at most " +
                     std::to_string(kMaxClipPlanes) + ", each at least one"};
    }
    if (block[at + 1] >> 16 != 0) {
      return Problem{"record " + std::to_string(i) + block.Where(at) +
                     " has a reserved WORD that is not 0"};
    }
    for (std::uint32_t k = 0; k < registers; ++k) {
      Constant constant;
      constant.register_number = block[at] & 0xffff;
      constant.float4_register = first + k;
      constant.byte_offset = 16 * constant.float4_register;
      const auto index = static_cast<std::uint32_t>(table.planes.size());
      table.planes.push_back({index, "", std::move(constant)});
    }
  }
  table.enable_mask = EnableMask(table.lowering, table.planes.size());
  return table;
}

// Walks the instructions of a shader model 4 or 5 program to the clip plane block.
Result<ClipTable> ReadProgram(Dwords program) {
  if (program.size() < 2 || program[1] < 2 || program[1] > program.size()) {
    return Problem{"the shader's length" + program.Where(1) + " does not fit its chunk"};
  }
  program = program.First(program[1]);
  for (std::size_t at = 2; at < program.size();) {
    const std::uint32_t token = program[at];
    const bool is_custom_data = (token & 0x7ff) == kCustomData;
    std::uint32_t length = is_custom_data ? 0 : token >> 24 & 0x7f;
    if (length == 0 && at + 1 < program.size()) length = program[at + 1];
    if (length < (is_custom_data ? 2u : 1u) || length > program.size() - at) {
      return Problem{"the instruction" + program.Where(at) +
                     " is longer than the shader, or empty"};
    }
    if (token == kBlockToken) {
      if (length < kHeaderDwords)
        return Problem{"the clip plane block" + program.Where(at) + " is cut off"};
      return ReadBlock(program.From(at).First(length));
    }
    at += length;
  }
  return Problem{
      "the shader has no clip plane block: it was compiled without [clipplanes], or not for a 9_x "
      "profile"};
}

Result<ClipTable> ReadContainer(std::string_view bytes) {
  // "DXBC", 16 bytes of hash, version 1, total size, number of chunks, then the offset of each.
  constexpr std::size_t kSize = 6, kChunks = 7, kOffsets = 8;
  const Dwords file(bytes, 0);
  if (file.size() < kOffsets || file[kSize] != bytes.size()) {
    return Problem{"the DXBC container is cut off, or its size" + file.Where(kSize) + " is wrong"};
  }
  if (file[kChunks] > file.size() - kOffsets) {
    return Problem{"the DXBC container claims " + std::to_string(file[kChunks]) + " chunks" +
                   file.Where(kChunks)};
  }
  for (std::size_t i = 0; i < file[kChunks]; ++i) {
    const std::size_t offset = file[kOffsets + i];
    if (offset % 4 != 0 || offset / 4 + 2 > file.size() ||
        file[offset / 4 + 1] > bytes.size() - offset - 8) {
      return Problem{"chunk " + std::to_string(i) +
                     " of the DXBC container does not lie inside it"};
    }
    const std::uint32_t code = file[offset / 4];
    if (code == FourCc("SHDR") || code == FourCc("SHEX")) {
      return ReadProgram({bytes.substr(offset + 8, file[offset / 4 + 1]), offset + 8});
    }
  }
  return Problem{"the DXBC container has neither an SHDR nor an SHEX chunk"};
}

}  // namespace

ClipTable Direct3DPart(const ClipTable& table) {
  ClipTable part;
  part.lowering = Lowering::kLevel9;
  for (const Plane& plane : table.planes) {
    Plane& kept = part.planes.emplace_back();
    kept.index = plane.index;
    if (!plane.constant) continue;
    kept.constant.emplace();
    kept.constant->register_number = plane.constant->register_number;
    kept.constant->float4_register = plane.constant->float4_register;
    kept.constant->byte_offset = plane.constant->byte_offset;
  }
  part.enable_mask = EnableMask(part.lowering, part.planes.size());
  return part;
}

Result<std::string> WriteBinary(const ClipTable& table) {
  std::string problem = ProblemOf(table);
  if (problem.empty()) problem = ProblemOf(Direct3DPart(table));
  if (problem.empty() && table.plane_space != PlaneSpace::kClip) {
    problem = std::string("the binary form holds planes in clip space only; these are in space ") +
              NameOf(table.plane_space);
  }
  if (!problem.empty()) return Problem{std::move(problem)};

  const auto count = static_cast<std::uint32_t>(table.planes.size());
  std::string bytes;
  Put(bytes, kBlockToken, 4);
  Put(bytes, kHeaderDwords + kRecordDwords * count, 4);
  Put(bytes, count, 4);
  for (const Plane& plane : table.planes) {
    constexpr std::uint32_t kMaxWord = std::numeric_limits<std::uint16_t>::max();
    const Constant& constant = *plane.constant;
    if (constant.register_space != 0 || constant.register_number > kMaxWord ||
        constant.float4_register > kMaxWord) {
      return Problem{"plane " + std::to_string(plane.index) +
                     " lies in a register that the binary form cannot name; it has no "
                     "register spaces, and 16 bits for a number"};
    }
    Put(bytes, constant.register_number, 2);
    Put(bytes, constant.float4_register, 2);
    Put(bytes, 1, 2);
    Put(bytes, 0, 2);
  }
  return bytes;
}

Result<ClipTable> ReadBinary(std::string_view bytes) {
  if (bytes.starts_with("DXBC")) return ReadContainer(bytes);
  const Dwords block(bytes, 0);
  if (bytes.size() % 4 != 0 || block.size() < kHeaderDwords || block[0] != kBlockToken) {
    return Problem{
        "no clip plane block: it starts with the DWORD 0x2835 and has at least three DWORDs"};
  }
  if (block[1] != block.size()) {
    return Problem{"the clip plane block says that it has " + std::to_string(block[1]) +
                   " DWORDs; the file has " + std::to_string(block.size())};
  }
  return ReadBlock(block);
}

}  // namespace clipc::clip_table
