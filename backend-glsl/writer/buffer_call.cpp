// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/buffer_call.h"

#include <fmt/format.h>

#include "backend-glsl/block_layout.h"
#include "backend-glsl/writer/expr.h"
#include "backend-glsl/writer/helper.h"
#include "backend-glsl/writer/memory.h"
#include "backend-glsl/writer/object_call.h"
#include "backend-glsl/writer/objects.h"
#include "backend-glsl/writer/types.h"
#include "ir/scalar.h"

namespace clipc::glsl {

using namespace ir;

namespace {

// Whether std430 lays the elements out as Direct3D does; otherwise the buffer is an array of words.
bool HasElements(const Code& code, VarId buffer) {
  return Std430(code.types, ObjectTypeOf(code, buffer).element, code[buffer].row_major).has_value();
}

std::uint32_t WordsOf(const Code& code, VarId buffer) {
  return Structured(code.types, ObjectTypeOf(code, buffer).element).size / 4;
}

// The elements of a buffer, which may be one of an array of buffers.
std::string ElementsOf(Code& code, ExprId object) {
  return Concat(code.NameOf(RootOf(code.program, object)), IndexPath(code, object),
                code.As<Index>(object) ? ".elements" : "");
}

// The names of a buffer in a helper function, to which the buffer's place in its array is passed.
struct BufferInHelper {
  std::string name;                 // beginning of the function's name
  std::string elements;             // "lists[which].elements"
  std::string parameter, argument;  // "int which, ", "int(i), "; empty where there is no array
};

BufferInHelper InHelper(Code& code, ExprId object) {
  const std::string& name = code.NameOf(RootOf(code.program, object));
  const auto* element = code.As<Index>(object);
  if (!element) return {name, name, "", ""};
  const auto* marked = code.As<IntrinsicCall>(element->index);
  const std::string which = Fresh(code, "which");
  BufferInHelper buffer{Concat(name, marked ? "_any" : ""), "", Concat("int ", which, ", "), ""};
  if (marked) code.Require("GL_EXT_nonuniform_qualifier");
  buffer.elements =
      Concat(name, marked ? "[nonuniformEXT(" : "[", which, marked ? ")].elements" : "].elements");
  buffer.argument =
      Concat(IntIndex(code, marked ? code[marked->arguments][0] : element->index), ", ");
  return buffer;
}

// The path ".lists[1].x" to a component of a value, whose components are numbered through structs
// and arrays.
std::string PathTo(const Code& code, TypeId id, std::uint32_t component) {
  const Type& type = code[id];
  const auto count = [&](TypeId part) {
    return static_cast<std::uint32_t>(KindsOf(code.types, part).size());
  };
  if (type.kind == TypeKind::kVector && type.columns > 1)
    return Concat(".", std::string_view("xyzw").substr(component, 1));
  if (type.kind == TypeKind::kArray) {
    const std::uint32_t each = count(type.element);
    return Concat("[", std::to_string(component / each), "]",
                  PathTo(code, type.element, component % each));
  }
  if (type.kind != TypeKind::kStruct) return "";
  const auto& fields = code.types.StructOf(id).fields;
  std::size_t field = 0;
  for (; component >= count(fields[field].type); ++field) component -= count(fields[field].type);
  return Concat(".", code.names.fields[type.structure.index][field],
                PathTo(code, fields[field].type, component));
}

// The path ".lists[i].xy" that steps lead to in an element of a structured buffer; `count` is the
// number of components of what is there.
std::string PathAlong(Code& code, TypeId id, std::span<const ExprId> steps, std::size_t count) {
  std::string path;
  bool is_row = false;  // whether the last step was one to a row of a matrix
  for (const ExprId step : steps) {
    const Type& type = code[id];
    const auto* number = code.As<Literal>(step);
    if (type.kind == TypeKind::kStruct) {
      const std::uint32_t field = UintOf(number->bits);
      Append(path, ".", code.names.fields[type.structure.index][field]);
      id = code.types.StructOf(id).fields[field].type;
      continue;
    }
    const bool is_array = type.kind == TypeKind::kArray;
    const bool is_matrix = type.kind == TypeKind::kMatrix && !is_row;
    const bool has_rows = type.rows > 1 && type.columns > 1;
    if (is_array || (is_matrix && has_rows) || (!number && type.Components() > 1) ||
        (is_row && has_rows && count == 1)) {
      Append(path, "[", IndexValue(code, step), "]");
    } else if (const std::size_t all = is_matrix ? type.rows : type.columns;
               all > 1 && count < all) {
      Append(path, ".", std::string_view("xyzw").substr(UintOf(number->bits), count));
    }
    if (is_array) id = type.element;
    is_row = is_matrix;
  }
  return path;
}

// The number of the word that steps lead to in an element: what literals say of it, and the text
// "4 * i + k" of the other steps.
struct WordAlong {
  std::uint32_t known = 0;
  std::string rest;
};
WordAlong WordTo(Code& code, TypeId id, std::span<const ExprId> steps) {
  WordAlong word;
  const auto count = [&](TypeId part) {
    return static_cast<std::uint32_t>(KindsOf(code.types, part).size());
  };
  for (const ExprId step : steps) {
    const Type& type = code[id];
    const auto* number = code.As<Literal>(step);
    if (type.kind == TypeKind::kStruct) {
      const auto& fields = code.types.StructOf(id).fields;
      const std::uint32_t field = UintOf(number->bits);
      for (std::uint32_t i = 0; i < field; ++i) word.known += count(fields[i].type);
      id = fields[field].type;
      continue;
    }
    const std::uint32_t each = type.kind == TypeKind::kArray ? count(type.element) : 1;
    if (number)
      word.known += each * UintOf(number->bits);
    else
      Append(word.rest, word.rest.empty() ? "" : " + ",
             Scaled(each, code.TypeOf(step).scalar == Scalar::kInt
                              ? ExprText(code, step).At(Binding::kProduct)
                              : IntIndex(code, step)));
    id = type.element;
  }
  return word;
}

// The word that holds a component.
std::string WordOf(Code& code, Scalar kind, const std::string& value) {
  switch (BaseOf(kind)) {
    case Scalar::kFloat: code.Require(Feature::kBitCasts); return "floatBitsToUint(" + value + ")";
    case Scalar::kUint: return value;
    default: return "uint(" + value + ")";
  }
}

// Stores an element that lies tighter than std430 can say, or a part of one, word by word.
Text StoreWords(Code& code, const ObjectCall& node, const std::string& value) {
  const ExprId object = code.Operand(node, OperandKind::kObject);
  const ExprId place = code.Operand(node, OperandKind::kPlace);
  const ExprId stored_value = code.Operand(node, OperandKind::kValue);
  const VarId buffer = RootOf(code.program, object);
  const BufferInHelper named = InHelper(code, object);
  const TypeId stored_type = code.program.exprs[stored_value].type;
  const auto steps = code[OperandsOf(node, OperandKind::kStep)];
  const WordAlong part = WordTo(code, ObjectTypeOf(code, buffer).element, steps);
  const bool moves = !part.rest.empty();
  const std::string name = Concat(named.name, "_store",
                                  moves           ? "_part"
                                  : steps.empty() ? ""
                                                  : std::to_string(part.known),
                                  "_at");
  const std::string key = steps.empty() ? "" : TypeName(code, stored_type);
  const std::string helper = Helper(code, name, key, [&](const std::string& function) {
    const std::string i = Fresh(code, "i"), stored = Fresh(code, "value");
    const std::string from = moves ? Fresh(code, "word") : "";
    std::string text =
        fmt::format("void {}({}int {}, {}{} {}) {{\n", function, named.parameter, i,
                    moves ? Concat("int ", from, ", ") : "", TypeName(code, stored_type), stored);
    std::uint32_t component = 0;
    const std::string first =
        Concat(Scaled(WordsOf(code, buffer), i), moves ? Concat(" + ", from) : "");
    for (const Scalar kind : KindsOf(code.types, stored_type)) {
      const std::uint32_t word = (moves ? 0 : part.known) + component;
      const std::string path = PathTo(code, stored_type, component);
      text += fmt::format("    {}[{}{}] = {};\n", named.elements, first,
                          word > 0 ? fmt::format(" + {}", word) : "",
                          WordOf(code, kind, stored + path));
      ++component;
    }
    return text + "}\n";
  });
  const std::string index = IntIndex(code, place);
  const std::string known = part.known > 0 ? Concat(" + ", std::to_string(part.known)) : "";
  const std::string from = moves ? Concat(part.rest, known, ", ") : "";
  return Called(helper, {named.argument + index, from + value});
}

}  // namespace

Text StructuredLoad(Code& code, const ObjectCall& node) {
  const ExprId object = code.Operand(node, OperandKind::kObject);
  const ExprId place = code.Operand(node, OperandKind::kPlace);
  const VarId buffer = RootOf(code.program, object);
  if (HasElements(code, buffer)) {
    return {Concat(ElementsOf(code, object), "[", IndexValue(code, place), "]")};
  }
  // Elements that lie tighter than std430 can say are put together from words.
  const BufferInHelper named = InHelper(code, object);
  const std::string index = IntIndex(code, place);
  const std::string helper = Helper(code, named.name + "_at", "", [&](const std::string& function) {
    const TypeId element = ObjectTypeOf(code, buffer).element;
    const std::string i = Fresh(code, "i"), type = TypeName(code, element);
    return fmt::format("{} {}({}int {}) {{\n    return {};\n}}\n", type, function, named.parameter,
                       i,
                       Load(code, {named.elements, false, false}, element, code[buffer].row_major,
                            {Scaled(WordsOf(code, buffer), i)}));
  });
  return Called(helper, {named.argument + index});
}

Text BufferStore(Code& code, const ObjectCall& node) {
  const VarId buffer = RootOf(code.program, code.Operand(node, OperandKind::kObject));
  const std::string value = Argument(code, code.Operand(node, OperandKind::kValue));
  if (!HasElements(code, buffer)) return StoreWords(code, node, value);
  return {Concat(BufferWord(code, node), " = ", value), Binding::kAssignment};
}

std::string BufferWord(Code& code, const ObjectCall& node) {
  const ExprId object = code.Operand(node, OperandKind::kObject);
  const ExprId place = code.Operand(node, OperandKind::kPlace);
  const ExprId value = code.Operand(node, OperandKind::kValue);
  const std::string element = Concat(ElementsOf(code, object), "[", IndexValue(code, place), "]");
  const auto steps = code[OperandsOf(node, OperandKind::kStep)];
  if (steps.empty()) return element;
  const std::size_t count = code.TypeOf(value).Components();
  return element +
         PathAlong(code, ObjectTypeOf(code, RootOf(code.program, object)).element, steps, count);
}

Text BufferSize(Code& code, ExprId object) {
  const VarId buffer = RootOf(code.program, object);
  const std::string length = ElementsOf(code, object) + ".length()";
  const std::uint32_t words = HasElements(code, buffer) ? 1 : WordsOf(code, buffer);
  if (words <= 1) return {length};
  return {fmt::format("{} / {}", length, words), Binding::kProduct};
}

}  // namespace clipc::glsl
