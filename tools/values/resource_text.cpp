// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <stdexcept>

#include "tools/values/resource.h"

namespace clipc::values {
namespace {

// Of equal beginnings the longer name is first.
constexpr Format kFormats[] = {
    {"r32g32b32a32-float", GL_RGBA32F, GL_RGBA, GL_FLOAT, 4},
    {"r32g32b32a32-sint", GL_RGBA32I, GL_RGBA_INTEGER, GL_INT, 4},
    {"r32g32b32a32-uint", GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT, 4},
    {"r32g32-float", GL_RG32F, GL_RG, GL_FLOAT, 2},
    {"r32g32-sint", GL_RG32I, GL_RG_INTEGER, GL_INT, 2},
    {"r32g32-uint", GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT, 2},
    {"r32-float-shadow", GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, 1},
    {"r32-float", GL_R32F, GL_RED, GL_FLOAT, 1},
    {"r32-sint", GL_R32I, GL_RED_INTEGER, GL_INT, 1},
    {"r32-uint", GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, 1},
    {"r32-typeless", GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, 1},
    {"unknown", GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, 1},
};

struct DimensionName {
  std::string_view name;
  Dimension dimension;
};
constexpr DimensionName kDimensions[] = {
    {"buffer", Dimension::kBuffer},
    {"raw_buffer", Dimension::kBuffer},
    {"counter_buffer", Dimension::kBuffer},
    {"2d", Dimension::k2d},
    {"2dms", Dimension::k2d},
    {"2darray", Dimension::k2dArray},
    {"3d", Dimension::k3d},
    {"cube", Dimension::kCube},
};

[[noreturn]] void Refuse(const char* what, const Scanner& line) {
  throw std::runtime_error(std::string("unknown ") + what + " `" + std::string(line.rest()) + "`");
}

// "(2d, 2, 2)"
void TakeSize(Scanner& line, ResourceText& resource) {
  line.ExpectMark('(');
  const std::size_t comma = std::min(line.rest().find(','), line.rest().size());
  std::string name(line.rest().substr(0, comma));
  while (name.ends_with(' ')) name.pop_back();
  const auto* found = std::ranges::find(kDimensions, name, &DimensionName::name);
  if (found == std::end(kDimensions)) Refuse("size", line);
  for (std::size_t i = 0; i < comma; ++i) line.TakeMark(line.rest().front());
  std::vector<std::uint32_t> numbers;
  while (line.TakeMark(',')) numbers.push_back(line.TakeCount());
  line.ExpectMark(')');
  resource.dimension = found->dimension;
  resource.is_raw = name == "raw_buffer";
  resource.is_counter = name == "counter_buffer";
  if (resource.is_counter) resource.stride = 4;
  if (name == "2dms") {
    resource.samples = numbers.at(0);
    numbers.erase(numbers.begin());
  }
  resource.width = numbers.at(0);
  resource.height = found->dimension == Dimension::kCube ? resource.width
                    : numbers.size() > 1                 ? numbers[1]
                                                         : 1;
  resource.depth = found->dimension == Dimension::kCube ? 6 : numbers.size() > 2 ? numbers[2] : 1;
}

GLenum TakeWrap(Scanner& line) {
  if (line.Take("border")) return GL_CLAMP_TO_BORDER;
  if (line.Take("clamp")) return GL_CLAMP_TO_EDGE;
  if (line.Take("mirror_once")) return GL_MIRROR_CLAMP_TO_EDGE;
  if (line.Take("mirror")) return GL_MIRRORED_REPEAT;
  if (line.Take("wrap")) return GL_REPEAT;
  Refuse("address mode", line);
}

bool TakeIsLinear(Scanner& line) {
  if (line.Take("linear")) return true;
  if (line.Take("point")) return false;
  Refuse("filter", line);
}

}  // namespace

const Format& FloatFormat() { return kFormats[0]; }

const Format& TakeFormat(Scanner& line) {
  for (const Format& format : kFormats) {
    if (line.Take(format.name)) return format;
  }
  Refuse("format", line);
}

ResourceText TakeReference(Scanner& line) {
  ResourceText resource;
  resource.format = FloatFormat();
  if (line.Take("dsv")) {
    resource.role = Role::kDepth;
    resource.format = {"d32-float", GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, 1};
    return resource;
  }
  if (line.Take("srv")) {
    resource.role = Role::kTexture;
  } else if (line.Take("uav")) {
    resource.role = Role::kStorage;
  } else if (line.Take("rtv")) {
    resource.role = Role::kTarget;
  } else if (line.Take("vb")) {
    resource.role = Role::kVertices;
    resource.dimension = Dimension::kBuffer;
  } else {
    Refuse("resource", line);
  }
  resource.slot = line.TakeCount();
  return resource;
}

ResourceText ReadResource(const Section& section) {
  Scanner header(section.header.text);
  ResourceText resource = TakeReference(header);
  for (const Line& each : section.lines) {
    Scanner line(each.text);
    if (line.Take("format")) {
      resource.format = TakeFormat(line);
    } else if (line.Take("stride")) {
      resource.stride = line.TakeCount();
    } else if (line.Take("size")) {
      TakeSize(line, resource);
    } else if (line.Take("levels")) {
      resource.levels = line.TakeCount();
    } else {
      while (const auto word = line.TakeWord()) resource.words.push_back(*word);
    }
  }
  if (resource.role == Role::kVertices)
    resource.width = static_cast<std::uint32_t>(4 * resource.words.size());
  return resource;
}

SamplerText ReadSampler(const Section& section) {
  SamplerText sampler;
  for (const Line& each : section.lines) {
    Scanner line(each.text);
    if (line.Take("address")) {
      for (GLenum& wrap : sampler.wraps) wrap = TakeWrap(line);
    } else if (line.Take("filter")) {
      const bool minifies = TakeIsLinear(line), magnifies = TakeIsLinear(line);
      const bool mixes_levels = TakeIsLinear(line);
      sampler.least = mixes_levels
                          ? (minifies ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_LINEAR)
                          : (minifies ? GL_LINEAR_MIPMAP_NEAREST : GL_NEAREST_MIPMAP_NEAREST);
      sampler.greatest = magnifies ? GL_LINEAR : GL_NEAREST;
    } else if (line.Take("comparison")) {
      sampler.comparison = TakeComparison(line);
    } else if (!line.at_end()) {
      Refuse("line of a sampler", line);
    }
  }
  return sampler;
}

GLenum TakeComparison(Scanner& line) {
  struct Comparison {
    std::string_view name;
    GLenum function;
  };
  // Of equal beginnings the longer name is first.
  constexpr Comparison kComparisons[] = {
      {"less equal", GL_LEQUAL}, {"not equal", GL_NOTEQUAL}, {"greater equal", GL_GEQUAL},
      {"never", GL_NEVER},       {"less", GL_LESS},          {"equal", GL_EQUAL},
      {"greater", GL_GREATER},   {"always", GL_ALWAYS},
  };
  for (const Comparison& comparison : kComparisons) {
    if (line.Take(comparison.name)) return comparison.function;
  }
  Refuse("comparison", line);
}

}  // namespace clipc::values
