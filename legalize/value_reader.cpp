// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "legalize/value_reader.h"

#include <cstddef>

#include "base/invariant.h"
#include "ir/packing.h"
#include "ir/std_layout.h"
#include "legalize/formula.h"
#include "legalize/shape.h"

namespace clipc::legalize {

using namespace ir;

namespace {

// Arrays of this many elements and more are filled by a loop, shorter ones by a constructor.
constexpr std::uint32_t kLongArray = 17;

// Ends the function with an array that a loop fills with element(index).
void FillArray(HelperBody& body, TypeId array,
               const std::function<ExprId(const Local& index)>& element) {
  Formula f(body);
  const VarId result = body.b.Local("result", array);
  body.Add(body.b.Stmt(Declare{result, {}}));
  f.CountUp(static_cast<int>(body.program.types[array].count), 1, [&](const Local& i) {
    const ExprId target = body.b.At(body.b.Ref(result), body.b.Ref(i.var));
    body.Do(body.b.AssignTo(target, element(i)));
  });
  body.Return(body.b.Ref(result));
}

}  // namespace

void ReturnArray(HelperBody& body, TypeId array, const Needs& needs,
                 const std::function<ExprId(ExprId index)>& element) {
  if (!needs.array_fields)
    return FillArray(body, array, [&](const Local& i) { return element(body.b.Ref(i.var)); });
  std::vector<ExprId> elements;
  for (std::uint32_t i = 0; i < body.program.types[array].count; ++i)
    elements.push_back(element(body.b.Int(static_cast<std::int32_t>(i))));
  body.Return(body.b.ConstructOf(array, elements));
}

ExprId NumberAt(HelperBody& body, const WordPlace& place, std::uint32_t constant) {
  ExprId sum;
  for (const auto& [stride, index] : place.steps) {
    const ExprId number = body.b.Ref(index);
    const ExprId step =
        stride == 1 ? number
                    : body.b.BinaryOf(BinaryOp::kMul, body.b.Int(static_cast<int>(stride)), number);
    sum = sum ? body.b.BinaryOf(BinaryOp::kAdd, sum, step) : step;
  }
  if (sum && constant == 0) return sum;
  const ExprId last = body.b.Int(static_cast<std::int32_t>(constant));
  return sum ? body.b.BinaryOf(BinaryOp::kAdd, sum, last) : last;
}

ExprId ValueReader::Read(HelperBody& body, TypeId id, bool row_major, const WordPlace& place) {
  const Type type = program_.types[id];
  switch (type.kind) {
    case TypeKind::kScalar: return Vector(body, type.scalar, 1, place);
    case TypeKind::kVector: {
      const ExprId value = Vector(body, type.scalar, type.columns, place);
      return type.columns == 1 ? body.b.ConstructOf(id, {value}) : value;
    }
    case TypeKind::kMatrix: return Matrix(body, id, row_major, place);
    case TypeKind::kArray:
      return type.count < kLongArray || needs_.array_fields ? Array(body, id, row_major, place)
                                                            : LongArray(body, id, row_major, place);
    case TypeKind::kStruct: return Structure(body, id, place);
    default: CLIPC_CHECK(!"a type that a buffer can hold");
  }
  return {};
}

// `count` words that lie side by side; in rows, within one row.
ExprId ValueReader::Words(HelperBody& body, const WordPlace& place, std::uint32_t count) {
  const std::uint32_t word = place.offset / kWordBytes;
  if (memory_.is_rows) {
    const ExprId row = memory_.at(body, NumberAt(body, place, word / 4));
    return count < 4 ? body.b.SwizzledRun(row, word % 4, count) : row;
  }
  std::vector<ExprId> words;
  for (std::uint32_t i = 0; i < count; ++i)
    words.push_back(memory_.at(body, NumberAt(body, place, word + i)));
  const TypeId type = program_.types.Vector(Scalar::kUint, static_cast<int>(count));
  return count == 1 ? words[0] : body.b.ConstructOf(type, words);
}

ExprId ValueReader::FromWords(HelperBody& body, Scalar kind, ExprId words) {
  const TypeId type = body.b.TypeOf(words);
  if (BaseOf(kind) == Scalar::kFloat && !memory_.is_float) {
    const TypeId floats = program_.types.WithScalar(type, Scalar::kFloat);
    words = body.b.IntrinsicOf(CommonIntrinsic::kAsFloat, floats, {words});
  }
  if (kind != Scalar::kBool) return body.b.ConvertTo(kind, words);
  return body.b.BinaryOf(BinaryOp::kNotEqual, words, body.b.SplatTo(type, body.b.Uint(0)));
}

// A component of 64 bits, of which the low word comes first.
ExprId ValueReader::Wide(HelperBody& body, Scalar kind, const WordPlace& place) {
  const ExprId low = Words(body, place, 1), high = Words(body, place.Plus(kWordBytes), 1);
  if (kind == Scalar::kDouble)
    return body.b.IntrinsicOf(CommonIntrinsic::kAsDouble, program_.types.Make(kind), {low, high});
  // Mesa's GLSL takes no shift by 64 bits.
  const ExprId upper = body.b.BinaryOf(BinaryOp::kShiftLeft,
                                       body.b.ConvertTo(Scalar::kUint64, high), body.b.Uint(32));
  return body.b.ConvertTo(
      kind, body.b.BinaryOf(BinaryOp::kBitOr, body.b.ConvertTo(Scalar::kUint64, low), upper));
}

ExprId ValueReader::Vector(HelperBody& body, Scalar kind, std::uint32_t count,
                           const WordPlace& place) {
  if (!IsWide(kind)) return FromWords(body, kind, Words(body, place, count));
  std::vector<ExprId> components;
  for (std::uint32_t i = 0; i < count; ++i)
    components.push_back(Wide(body, kind, place.Plus(std::uint64_t{i} * ByteSize(kind))));
  const TypeId type = program_.types.Vector(kind, static_cast<int>(count));
  return count == 1 ? components[0] : body.b.ConstructOf(type, components);
}

ExprId ValueReader::Matrix(HelperBody& body, TypeId id, bool row_major, const WordPlace& place) {
  const Type type = program_.types[id];
  const Shape shape = ShapeOf(type, needs_);
  const std::uint32_t registers = row_major ? type.rows : type.columns;
  const std::uint32_t length = row_major ? type.columns : type.rows;
  const std::uint32_t component = ByteSize(type.scalar);
  const std::uint32_t tight = length * component;
  const std::uint64_t stride = memory_.is_rows ? RoundUp(tight, kRowBytes) : tight;
  std::vector<ExprId> parts;
  if (!shape.HasRows() || row_major) {
    for (std::uint32_t i = 0; i < registers; ++i)
      parts.push_back(Vector(body, type.scalar, length, place.Plus(i * stride)));
    return body.b.ConstructOf(id, parts);
  }
  if (shape.kind == Shape::kMatrix && !needs_.square_matrices) {
    for (std::uint32_t i = 0; i < registers; ++i)
      parts.push_back(Vector(body, type.scalar, length, place.Plus(i * stride)));
    const TypeId turned = program_.types.Matrix(type.scalar, type.columns, type.rows);
    return body.b.IntrinsicOf(CommonIntrinsic::kTranspose, id, {body.b.ConstructOf(turned, parts)});
  }
  const TypeId row = program_.types.Vector(type.scalar, type.columns);
  for (std::uint32_t r = 0; r < type.rows; ++r) {
    std::vector<ExprId> components;
    for (std::uint32_t c = 0; c < registers; ++c)
      components.push_back(
          Vector(body, type.scalar, 1, place.Plus(c * stride + std::uint64_t{r} * component)));
    parts.push_back(body.b.ConstructOf(row, components));
  }
  return body.b.ConstructOf(id, parts);
}

std::uint32_t ValueReader::StrideOf(TypeId array, bool row_major) const {
  const TypeTable& types = program_.types;
  return memory_.is_rows ? ArrayStride(types, array, row_major)
                         : Structured(types, types[array].element).size;
}

ExprId ValueReader::Array(HelperBody& body, TypeId id, bool row_major, const WordPlace& place) {
  const Type type = program_.types[id];
  const std::uint64_t stride = StrideOf(id, row_major);
  std::vector<ExprId> elements;
  for (std::uint32_t i = 0; i < type.count; ++i)
    elements.push_back(Read(body, type.element, row_major, place.Plus(i * stride)));
  return body.b.ConstructOf(id, elements);
}

ExprId ValueReader::LongArray(HelperBody& body, TypeId id, bool row_major, const WordPlace& place) {
  const std::uint32_t unit = memory_.is_rows ? kRowBytes : kWordBytes;
  const std::uint32_t rest = place.offset % unit;
  FunctionId function = fillers_[{id, row_major, rest}];
  if (!function) {
    const Type type = program_.types[id];
    std::vector<Parameter> parameters = memory_.parameters;
    parameters.push_back({"at", program_.types.Make(Scalar::kInt)});
    function = AddHelper(program_, "load_" + memory_.name, parameters, id, [&](HelperBody& inner) {
      const VarId at = inner.parameters.back();
      FillArray(inner, id, [&](const Local& i) {
        const WordPlace element{{{1, at}, {StrideOf(id, row_major) / unit, i.var}}, rest};
        return Read(inner, type.element, row_major, element);
      });
    });
    program_.functions[function].is_accessor = true;
    fillers_[{id, row_major, rest}] = function;
  }
  std::vector<ExprId> arguments;
  for (std::size_t i = 0; i < memory_.parameters.size(); ++i) arguments.push_back(body[i]);
  arguments.push_back(NumberAt(body, place, place.offset / unit));
  return body.b.CallOf(function, arguments);
}

ExprId ValueReader::Structure(HelperBody& body, TypeId id, const WordPlace& place) {
  const std::vector<Field> fields = program_.types.StructOf(id).fields;
  std::uint32_t end = 0;
  std::vector<ExprId> values;
  for (const Field& field : fields) {
    const TypeTable& types = program_.types;
    const StructuredExtent words = Structured(types, field.type);
    const auto offset = memory_.is_rows ? FieldPlace(types, field, end)
                                        : static_cast<std::uint32_t>(RoundUp(end, words.alignment));
    end = offset +
          (memory_.is_rows ? PackedExtent(types, field.type, field.row_major).size : words.size);
    values.push_back(Read(body, field.type, field.row_major, place.Plus(offset)));
  }
  return body.b.ConstructOf(id, values);
}

}  // namespace clipc::legalize
