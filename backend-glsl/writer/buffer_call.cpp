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

namespace clipc::glsl {

using namespace ir;

namespace {

// Whether std430 lays the elements out as Direct3D does; else the buffer is one of words.
bool HasElements(const Code& code, VarId buffer) {
  return Std430(code.types, ObjectTypeOf(code, buffer).element, code[buffer].row_major).has_value();
}

std::uint32_t WordsOf(const Code& code, VarId buffer) {
  return Structured(code.types, ObjectTypeOf(code, buffer).element).size / 4;
}

// "buffer_load3": a function that does `op` for this many words.
std::string NameFor(const std::string& buffer, const char* op, int words) {
  return Concat(buffer, op, words > 1 ? std::to_string(words) : "");
}

}  // namespace

Text StructuredLoad(Code& code, const ObjectCall& node) {
  const auto arguments = code[node.arguments];
  const VarId buffer = RootOf(code.program, arguments[0]);
  const std::string& name = code.NameOf(buffer);
  if (HasElements(code, buffer)) {
    return {Concat(name, "[", IndexValue(code, arguments[1]), "]")};
  }
  // The elements lie tighter than std430 can say: they are put together from words.
  const std::string index = IntIndex(code, arguments[1]);
  const std::string helper = Helper(code, name + "_at", "", [&](const std::string& function) {
    const TypeId element = ObjectTypeOf(code, buffer).element;
    const std::string i = Fresh(code, "i"), type = TypeName(code, element);
    return fmt::format("{} {}(int {}) {{\n    return {};\n}}\n", type, function, i,
                       Load(code, {name, false, false}, element, code[buffer].row_major,
                            {Scaled(WordsOf(code, buffer), i)}));
  });
  return Called(helper, {index});
}

// Load, Load2, Load3, Load4 of a ByteAddressBuffer.
Text ByteLoad(Code& code, TypeId type, const ObjectCall& node) {
  const auto arguments = code[node.arguments];
  const std::string& name = code.NameOf(RootOf(code.program, arguments[0]));
  const Shape shape = ShapeOf(code[type]);
  const std::string helper =
      Helper(code, NameFor(name, "_load", shape.size), "", [&](const std::string& function) {
        const std::string address = Fresh(code, "address"), i = Fresh(code, "i");
        const std::string words = ListOf(int{shape.size}, [&](int k) {
          return k == 0 ? fmt::format("{}[{}]", name, i) : fmt::format("{}[{} + {}u]", name, i, k);
        });
        const std::string result = TypeName(code, shape);
        return fmt::format("{} {}(uint {}) {{\n    uint {} = {} / 4u;\n    return {};\n}}\n",
                           result, function, address, i, address,
                           shape.IsScalar() ? words : Called(result, {words}).text);
      });
  return Called(helper, {Argument(code, arguments[1])});
}

Text BufferStore(Code& code, const ObjectCall& node) {
  const auto arguments = code[node.arguments];
  const std::string name = ObjectName(code, arguments[0]);
  const std::string value = Argument(code, arguments[2]);
  if (IsStructured(ObjectTypeOf(code, RootOf(code.program, arguments[0])).object)) {
    return {Concat(name, "[", IndexValue(code, arguments[1]), "] = ", value), Binding::kAssignment};
  }
  const Shape shape = code.ShapeAt(arguments[2]);
  const std::string helper =
      Helper(code, NameFor(name, "_store", shape.size), "", [&](const std::string& function) {
        const std::string address = Fresh(code, "address"), stored = Fresh(code, "value");
        std::string text = fmt::format("void {}(uint {}, {} {}) {{\n", function, address,
                                       TypeName(code, shape), stored);
        for (std::size_t i = 0; i < shape.size; ++i) {
          text += fmt::format(
              "    {}[{} / 4u{}] = {}{};\n", name, address, i > 0 ? fmt::format(" + {}u", i) : "",
              stored, shape.IsScalar() ? "" : Concat(".", std::string_view("xyzw").substr(i, 1)));
        }
        return text + "}\n";
      });
  return Called(helper, {Argument(code, arguments[1]), value});
}

Text BufferSize(Code& code, VarId buffer) {
  const std::string length = code.NameOf(buffer) + ".length()";
  if (IsByteAddress(ObjectTypeOf(code, buffer).object)) return {length + " * 4", Binding::kProduct};
  const std::uint32_t words = HasElements(code, buffer) ? 1 : WordsOf(code, buffer);
  if (words <= 1) return {length};
  return {fmt::format("{} / {}", length, words), Binding::kProduct};
}

}  // namespace clipc::glsl
