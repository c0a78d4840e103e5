// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/packing.h"

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace clipc::ir {
namespace {

// Expected numbers are those that fxc and DXC list for the same declarations, or follow from the
// HLSL language specification, "Constant Buffer Layout", where a comment says so.
class Packing : public testing::Test {
 protected:
  struct NewMember {
    TypeId type;
    bool row_major = false;
    int packoffset = -1;
  };

  TypeId S(Scalar kind) { return types.Make(kind); }
  TypeId F(int components = 0) {
    return components == 0 ? types.Make(Scalar::kFloat) : types.Vector(Scalar::kFloat, components);
  }
  TypeId D(int components = 0) {
    return components == 0 ? types.Make(Scalar::kDouble)
                           : types.Vector(Scalar::kDouble, components);
  }
  TypeId M(int rows, int columns, Scalar kind = Scalar::kFloat) {
    return types.Matrix(kind, rows, columns);
  }
  TypeId A(TypeId element, std::uint32_t count) { return types.Array(element, count); }
  TypeId StructOf(const std::vector<NewMember>& members) {
    Struct structure;
    for (const NewMember& member : members) {
      Field field;
      field.name = "f" + std::to_string(structure.fields.size());
      field.type = member.type;
      field.row_major = member.row_major;
      structure.fields.push_back(std::move(field));
    }
    return types.Of(types.AddStruct(std::move(structure)));
  }
  Cbuffer Buffer(const std::vector<NewMember>& members, CbufferKind kind = CbufferKind::kCbuffer,
                 bool whole_registers = false) {
    Cbuffer buffer;
    buffer.kind = kind;
    for (const NewMember& member : members) {
      Var var;
      var.type = member.type;
      var.row_major = member.row_major;
      CbufferMember entry;
      entry.var = vars.Add(std::move(var));
      entry.has_packoffset = member.packoffset >= 0;
      if (entry.has_packoffset) entry.offset = static_cast<std::uint32_t>(member.packoffset);
      buffer.members.push_back(entry);
    }
    LayOut(types, vars, buffer, whole_registers);
    return buffer;
  }
  std::vector<std::uint32_t> Offsets(const std::vector<NewMember>& members) {
    std::vector<std::uint32_t> offsets;
    for (const CbufferMember& member : Buffer(members).members) offsets.push_back(member.offset);
    return offsets;
  }
  std::uint32_t Size(TypeId type, bool row_major = false) {
    return PackedExtent(types, type, row_major).size;
  }

  TypeTable types;
  Arena<Var> vars;
};

using Numbers = std::vector<std::uint32_t>;

// The eight examples of "Packing rules for constant variables".
TEST_F(Packing, DocumentedExamples) {
  EXPECT_EQ(Offsets({{F(4)}, {F(2)}, {F(2)}}), (Numbers{0, 16, 24}));
  EXPECT_EQ(Offsets({{F(2)}, {F(4)}, {F(2)}}), (Numbers{0, 16, 32}));
  EXPECT_EQ(Offsets({{F(1)}, {F(1)}, {F(2)}}), (Numbers{0, 4, 8}));
  EXPECT_EQ(Offsets({{F(1)}, {F(2)}, {F(1)}}), (Numbers{0, 4, 12}));
  EXPECT_EQ(Offsets({{F(1)}, {F(1)}, {F(1)}, {F(2)}}), (Numbers{0, 4, 8, 16}));
  EXPECT_EQ(Offsets({{F(3)}, {F(1)}}), (Numbers{0, 12}));
  EXPECT_EQ(Offsets({{F(1)}, {F(3)}}), (Numbers{0, 4}));
  EXPECT_EQ(Offsets({{F(1)}, {F(1)}, {F(3)}}), (Numbers{0, 4, 16}));
  const TypeId inner = StructOf({{F(4)}, {F(1)}});
  EXPECT_EQ(Offsets({{F(1)}, {inner}}), (Numbers{0, 16}));
  EXPECT_EQ(Buffer({{F(1)}, {inner}}).size, 48u);
}

TEST_F(Packing, BufferSizeIsWholeRows) {
  EXPECT_EQ(Buffer({{F()}}).size, 16u);
  EXPECT_EQ(Buffer({{F(4)}, {F()}}).size, 32u);
  EXPECT_EQ(Buffer({}).size, 0u);
}

TEST_F(Packing, ScalarFollowsInsideTheLastRowOfAnArray) {
  EXPECT_EQ(Offsets({{A(F(), 3)}, {F()}}), (Numbers{0, 36}));
  EXPECT_EQ(Offsets({{F(3)}, {A(S(Scalar::kInt), 3)}, {F(3)}}), (Numbers{0, 16, 52}));
  EXPECT_EQ(Offsets({{A(F(2), 2)}, {F(3)}}), (Numbers{0, 32}));
  EXPECT_EQ(Offsets({{F()}, {A(F(), 1)}, {F()}}), (Numbers{0, 16, 20}));
  EXPECT_EQ(Offsets({{A(A(F(3), 2), 2)}, {F()}}), (Numbers{0, 60}));
}

TEST_F(Packing, WholeRegistersAreNotShared) {
  const std::vector<NewMember> members = {{A(F(3), 2), false, 16}, {F()}, {F()}};
  const auto later = Buffer(members, CbufferKind::kGlobals).members;
  EXPECT_EQ(later[1].offset, 44u);
  const auto direct3d9 = Buffer(members, CbufferKind::kGlobals, true).members;
  EXPECT_EQ(direct3d9[1].offset, 48u);
  EXPECT_EQ(direct3d9[2].offset, 52u);
}

TEST_F(Packing, ScalarFollowsInsideTheLastRowOfAStruct) {
  EXPECT_EQ(Offsets({{StructOf({{F(3)}})}, {F()}}), (Numbers{0, 12}));
  EXPECT_EQ(Offsets({{StructOf({{F(4)}, {F()}})}, {F(3)}, {F()}}), (Numbers{0, 20, 32}));
  // DXC lists uint2x2, struct { uint }[1], uint at 0, 32, 36.
  const TypeId value = StructOf({{S(Scalar::kUint)}});
  EXPECT_EQ(Offsets({{M(2, 2, Scalar::kUint)}, {A(value, 1)}, {S(Scalar::kUint)}}),
            (Numbers{0, 32, 36}));
}

TEST_F(Packing, ArrayOfStructsHasPaddingBetweenElementsOnly) {
  const TypeId light = StructOf({{F(3)}, {F(3)}});
  EXPECT_EQ(Size(light), 28u);
  EXPECT_EQ(ArrayStride(types, A(light, 4), false), 32u);
  EXPECT_EQ(Size(A(light, 4)), 3 * 32 + 28u);
  EXPECT_EQ(Offsets({{A(light, 4)}, {F()}}), (Numbers{0, 124}));
}

TEST_F(Packing, Matrices) {
  EXPECT_EQ(Size(M(4, 4)), 64u);
  EXPECT_EQ(Size(M(3, 2), false), 28u);  // two columns of three
  EXPECT_EQ(Size(M(3, 2), true), 40u);   // three rows of two
  EXPECT_EQ(Size(M(4, 3), false), 48u);
  EXPECT_EQ(Size(M(4, 3), true), 60u);
  EXPECT_EQ(Size(M(3, 4), false), 60u);
  EXPECT_EQ(Size(M(3, 4), true), 48u);
  EXPECT_EQ(Offsets({{M(4, 3), true}, {F()}}), (Numbers{0, 60}));
  EXPECT_EQ(Offsets({{M(3, 3)}, {F()}, {F()}}), (Numbers{0, 44, 48}));
  EXPECT_EQ(Offsets({{F()}, {M(2, 2)}}), (Numbers{0, 16}));
}

TEST_F(Packing, MatrixOfOneRegisterIsPlacedLikeAVector) {
  EXPECT_EQ(Offsets({{F()}, {M(3, 1), false}}), (Numbers{0, 4}));
  EXPECT_EQ(Offsets({{F()}, {M(1, 3), true}}), (Numbers{0, 4}));
  EXPECT_EQ(Offsets({{F(2)}, {M(3, 1), false}}), (Numbers{0, 16}));
  // fxc lists float, float1x2, float at 0, 16, 36: two columns of one.
  EXPECT_EQ(Offsets({{F()}, {M(1, 2), false}, {F()}}), (Numbers{0, 16, 36}));
  EXPECT_EQ(Offsets({{F()}, {M(2, 1), true}, {F()}}), (Numbers{0, 16, 36}));
  EXPECT_EQ(Offsets({{F()}, {M(1, 1)}}), (Numbers{0, 4}));
}

TEST_F(Packing, DoublesAreAlignedToEightBytes) {
  EXPECT_EQ(Offsets({{F()}, {D()}}), (Numbers{0, 8}));
  EXPECT_EQ(Offsets({{F(3)}, {D()}}), (Numbers{0, 16}));
  EXPECT_EQ(Offsets({{F()}, {D(2)}}), (Numbers{0, 16}));
  EXPECT_EQ(Offsets({{D(3)}, {D()}, {F()}}), (Numbers{0, 24, 32}));
  EXPECT_EQ(Offsets({{D(3)}, {F()}, {F(2)}}), (Numbers{0, 24, 32}));
  EXPECT_EQ(Size(D(4)), 32u);
  EXPECT_EQ(ArrayStride(types, A(D(3), 2), false), 32u);
  EXPECT_EQ(Size(A(D(), 2)), 24u);
  EXPECT_EQ(Size(M(3, 4, Scalar::kDouble)), 120u);
  EXPECT_EQ(Size(M(2, 2, Scalar::kDouble)), 32u);
  EXPECT_EQ(Offsets({{F()}, {S(Scalar::kInt64)}, {S(Scalar::kUint64)}}), (Numbers{0, 8, 16}));
}

// Sizes and offsets that DXC's reflection gives for a buffer of mixed members.
TEST_F(Packing, NestedStructOfMixedMembers) {
  const TypeId mixed = StructOf({{S(Scalar::kInt)},
                                 {M(3, 2)},
                                 {M(3, 4, Scalar::kDouble)},
                                 {M(2, 1, Scalar::kInt)},
                                 {A(M(3, 2), 3), true}});
  const StructId structure = types[mixed].structure;
  Numbers fields;
  for (std::uint32_t i = 0; i < 5; ++i) fields.push_back(FieldOffset(types, structure, i));
  EXPECT_EQ(fields, (Numbers{0, 16, 48, 168, 176}));
  EXPECT_EQ(Size(mixed), 312u);
  EXPECT_EQ(Size(A(mixed, 5)), 1592u);
  const Cbuffer buffer = Buffer({{F(2)},
                                 {F(4)},
                                 {D()},
                                 {M(3, 2)},
                                 {M(3, 2), true},
                                 {M(3, 4, Scalar::kDouble)},
                                 {mixed},
                                 {A(mixed, 5)}});
  Numbers offsets;
  for (const CbufferMember& member : buffer.members) offsets.push_back(member.offset);
  EXPECT_EQ(offsets, (Numbers{0, 16, 32, 48, 80, 128, 256, 576}));
  EXPECT_EQ(buffer.size, 2176u);
}

TEST_F(Packing, BoolAndMinimumPrecisionTakeFourBytes) {
  EXPECT_EQ(Offsets({{S(Scalar::kBool)}, {types.Vector(Scalar::kBool, 3)}, {S(Scalar::kHalf)}}),
            (Numbers{0, 4, 16}));
  EXPECT_EQ(Size(types.Vector(Scalar::kMin16Float, 3)), 12u);
}

TEST_F(Packing, PackoffsetIsKept) {
  const Cbuffer buffer = Buffer({{F(4), false, 32}, {F(), false, 4}, {F(2), false, 8}});
  EXPECT_EQ(buffer.members[0].offset, 32u);
  EXPECT_EQ(buffer.members[1].offset, 4u);
  EXPECT_EQ(buffer.members[2].offset, 8u);
  EXPECT_EQ(buffer.members[2].size, 8u);
  EXPECT_EQ(buffer.size, 48u);
}

TEST_F(Packing, GlobalsWithoutRegisterFollowTheLastOneWith) {
  EXPECT_EQ(Offsets({{F(), false, 160}, {F()}, {F(), false, 16}}), (Numbers{160, 20, 16}));
  EXPECT_EQ(Offsets({{S(Scalar::kInt)}, {F(), false, 16}}), (Numbers{20, 16}));
  EXPECT_EQ(Offsets({{F(4), false, 32}, {A(F(4), 2)}, {F(), false, 0}}), (Numbers{32, 48, 0}));
}

TEST_F(Packing, ArrayOfConstantBuffersIsSizedAsOne) {
  const TypeId frame = StructOf({{M(4, 4)}, {F(3)}});
  const Cbuffer buffer = Buffer({{A(frame, 4)}}, CbufferKind::kConstantBuffer);
  EXPECT_EQ(buffer.members[0].size, 76u);
  EXPECT_EQ(buffer.size, 80u);
}

TEST_F(Packing, EmptyAndObjectFieldsTakeNoRoom) {
  EXPECT_EQ(Size(StructOf({})), 0u);
  EXPECT_EQ(Size(StructOf({{types.Object(ObjectKind::kTexture2D, F(4))}, {F()}})), 4u);
  EXPECT_EQ(Offsets({{F(2)}, {types.Object(ObjectKind::kSampler)}, {F()}}), (Numbers{0, 8, 8}));
}

TEST_F(Packing, HugeArraysStopAtTheLargestSize) {
  const TypeId huge = A(A(M(4, 4), 0x10000), 0x10000);
  EXPECT_EQ(Size(huge), 0xfffffff0u);
  EXPECT_EQ(Buffer({{huge}, {F(4)}}).size, 0xfffffff0u);
}

}  // namespace
}  // namespace clipc::ir
