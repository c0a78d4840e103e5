// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/writer/stmt.h"

#include <span>
#include <string_view>
#include <utility>

#include "backend-glsl/writer/expr.h"
#include "backend-glsl/writer/helper.h"
#include "backend-glsl/writer/interface.h"
#include "backend-glsl/writer/intrinsic_call.h"
#include "backend-glsl/writer/outputs.h"
#include "backend-glsl/writer/types.h"
#include "base/overloaded.h"

namespace clipc::glsl {

using namespace ir;

namespace {

void WriteStmt(Code& code, StmtId id);

void WriteStmts(Code& code, std::span<const StmtId> list) {
  for (const StmtId id : list) WriteStmt(code, id);
}

// Writes the statements of a block, or the one statement; the caller writes the braces around it.
void WriteBody(Code& code, StmtId id) {
  ++code.indent;
  code.namer.OpenScope();
  if (const auto* block = code.As<Block>(id)) {
    WriteStmts(code, code[block->body]);
  } else {
    WriteStmt(code, id);
  }
  code.namer.CloseScope();
  --code.indent;
}

// Declares a local variable; without the type if others come before it: `int i = 0, j = 1`.
void WriteDeclare(Code& code, const Declare& node, bool is_first = true) {
  const Var& var = code[node.var];
  const ExprId init = node.init ? node.init : var.init;
  const std::size_t begin = code.out->size();
  // The variable is in scope after its initialiser only, in GLSL as in HLSL.
  if (init) {
    code.Put(" = ");
    WriteAt(code, init, Binding::kAssignment);
  }
  code.NameLocal(node.var, "value");
  const std::string& name = code.NameOf(node.var);
  if (!is_first) return code.PutBefore(begin, Declarator(code, var.type, name));
  std::string declaration(code.constants.Has(node.var) ? "const " : "");
  declaration += PreciseText(code, var.precise);
  declaration += PrecisionText(code, var.type);
  AppendDeclaration(code, declaration, var.type, name);
  code.PutBefore(begin, declaration);
}

// The attribute for Vulkan's drivers that corresponds to the statement's attribute in HLSL, and a
// space; empty if there is none.
std::string_view HintText(Code& code, StmtId id) {
  const Hint hint = code.program.stmts[id].hint;
  if (hint == Hint::kNone || !code.target.IsVulkan()) return "";
  code.Require("GL_EXT_control_flow_attributes");
  switch (hint) {
    case Hint::kNone: break;
    case Hint::kUnroll: return "[[unroll]] ";
    case Hint::kLoop: return "[[dont_unroll]] ";
    case Hint::kBranch: return "[[dont_flatten]] ";
    case Hint::kFlatten: return "[[flatten]] ";
  }
  return "";
}

// Writes the expression between two texts.
void WriteBetween(Code& code, std::string_view open, ExprId expr, std::string_view close) {
  code.Put(open);
  WriteExpr(code, expr);
  code.Put(close);
}

void WriteIf(Code& code, StmtId id, const If& node, std::string_view lead) {
  code.Indent();
  code.Put(lead, HintText(code, id));
  WriteBetween(code, "if (", node.condition, ") {\n");
  WriteBody(code, node.then);
  if (!node.otherwise) return code.Line("}");
  if (const auto* next = code.As<If>(node.otherwise))
    return WriteIf(code, node.otherwise, *next, "} else ");
  code.Line("} else {");
  WriteBody(code, node.otherwise);
  code.Line("}");
}

void WriteFor(Code& code, StmtId id, const For& node) {
  code.namer.OpenScope();
  code.Indent();
  code.Put(HintText(code, id), "for (");
  bool is_first = true;
  for (const StmtId each : code[node.init]) {
    if (!is_first) code.Put(", ");
    if (const auto* declare = code.As<Declare>(each))
      WriteDeclare(code, *declare, is_first);
    else
      WriteExpr(code, code.As<Evaluate>(each)->expr);
    is_first = false;
  }
  code.Put(";");
  if (node.condition) WriteBetween(code, " ", node.condition, "");
  code.Put(";");
  if (node.step) WriteBetween(code, " ", node.step, "");
  code.Put(") {\n");
  WriteBody(code, node.body);
  code.Line("}");
  code.namer.CloseScope();
}

void WriteSwitch(Code& code, StmtId id, const Switch& node) {
  code.Indent();
  code.Put(HintText(code, id));
  WriteBetween(code, "switch (", node.value, ") {\n");
  code.namer.OpenScope();
  const auto cases = code.program.switch_cases[node.cases];
  for (const SwitchCase& arm : cases) {
    for (const ExprId label : code[arm.labels]) {
      code.Indent();
      WriteBetween(code, "case ", label, ":\n");
    }
    if (arm.is_default) code.Line("default:");
    ++code.indent;
    WriteStmts(code, code[arm.body]);
    // GLSL requires a statement after the last label.
    if (arm.body.empty() && &arm == &cases.back()) code.Line("break;");
    --code.indent;
  }
  code.namer.CloseScope();
  code.Line("}");
}

// Writes the comment that the options give for a statement's place in the source, unless it is
// empty or the same as the last one.
void WriteComment(Code& code, Span span) {
  if (!code.comment_of) return;
  std::string comment = code.comment_of(span);
  if (comment.empty() || comment == code.comment) return;
  code.comment = std::move(comment);
  code.Line("// ", code.comment);
}

void WriteStmt(Code& code, StmtId id) {
  if (!code.As<Block>(id)) WriteComment(code, code.program.stmts[id].span);
  Visit(Overloaded{
            [&](const Block&) {
              code.Line("{");
              WriteBody(code, id);
              code.Line("}");
            },
            [&](const Declare& node) {
              code.Indent();
              WriteDeclare(code, node);
              code.Put(";\n");
            },
            [&](const Evaluate& node) {
              const auto* call = code.As<IntrinsicCall>(node.expr);
              if (call && WaitsForGroup(call->op)) {
                code.Line(MemoryBarrierOf(call->op), "();");
                return code.Line("barrier();");
              }
              code.Indent();
              WriteBetween(code, "", node.expr, ";\n");
            },
            [&](const If& node) { WriteIf(code, id, node, ""); },
            [&](const For& node) { WriteFor(code, id, node); },
            [&](const While& node) {
              code.Indent();
              code.Put(HintText(code, id));
              WriteBetween(code, "while (", node.condition, ") {\n");
              WriteBody(code, node.body);
              code.Line("}");
            },
            [&](const DoWhile& node) {
              code.Line(HintText(code, id), "do {");
              WriteBody(code, node.body);
              code.Indent();
              WriteBetween(code, "} while (", node.condition, ");\n");
            },
            [&](const Switch& node) { WriteSwitch(code, id, node); },
            [&](const Return& node) {
              if (!node.value) return code.Line("return;");
              code.Indent();
              WriteBetween(code, "return ", node.value, ";\n");
            },
            [&](const Break&) { code.Line("break;"); },
            [&](const Continue&) { code.Line("continue;"); },
            [&](const Discard&) { code.Line("discard;"); },
        },
        code.program.stmts[id].node);
}

void WriteSignature(Code& code, FunctionId id, std::string_view name) {
  const Function& function = code[id];
  code.Indent();
  code.Put(PrecisionText(code, function.return_type), TypeName(code, function.return_type), " ",
           name, "(");
  std::string_view separator;
  for (const VarId parameter : function.parameters) {
    const Storage storage = code[parameter].storage;
    code.NameLocal(parameter, "unused");
    code.Put(std::exchange(separator, ", "), PreciseText(code, code[parameter].precise),
             storage == Storage::kOut     ? "out "
             : storage == Storage::kInOut ? "inout "
                                          : "",
             PrecisionText(code, code[parameter].type));
    AppendDeclaration(code, *code.out, code[parameter].type, code.NameOf(parameter));
  }
  code.Put(") {");
  if (function.offset) code.Put("  // offset ", *function.offset);
  code.Put("\n");
}

// Whether `main` chooses a component of the color by an index that is not constant. OpenGL ES lets
// it, but glslang and ANGLE's ParseContext.cpp refuse such an index of an output of a fragment
// shader, and with ANGLE the browsers.
bool IsIndexed(const Code& code, VarId color) {
  return code.target.IsEs() && AnyExpr(code.program, code[code.program.main].body, [&](ExprId of) {
           const auto* index = code.As<Index>(of);
           return index && !code.As<Literal>(index->index) && RootOf(code.program, of) == color;
         });
}

// An output that has a variable of its own until its function ends.
struct KeptOutput {
  std::string name, value;
};

// Declares the variables of the outputs that are uint in HLSL and int in GLSL, which are converted
// at the end. So is gl_FragData, which OpenGL ES keeps in less than 32 bits, and a color that an
// index chooses a component of.
std::vector<KeptOutput> KeepOutputs(Code& code) {
  std::vector<KeptOutput> last;
  for (const IoVar& output : code.program.outputs) {
    const bool is_int = IsIntOutput(output.builtin);
    const bool is_color =
        output.builtin == Builtin::kNone && !InfoOf(code.program.stage).has_stage_after;
    const bool is_kept = is_color && (!code.Has(Feature::kInAndOut) || IsIndexed(code, output.var));
    if (!is_int && !is_kept) continue;
    const std::string name = code.NameOf(output.var);
    const std::string& local = code.names.vars[output.var.index] = code.namer.Local(
        is_int ? code[output.var].name : Concat("SV_Target", std::to_string(output.location)));
    code.Line(PrecisionText(code, output), Declaration(code, code[output.var].type, local), ";");
    last.push_back({name, is_int ? Concat("int(", local, ")") : local});
  }
  return last;
}

void WriteKept(Code& code, std::span<const KeptOutput> kept) {
  for (const auto& [name, value] : kept) code.Line(name, " = ", value, ";");
}

// Writes the statements of a function that is not `main`. One that emits a vertex gives the outputs
// their values before.
void WriteBody(Code& code, FunctionId id) {
  const std::span<const StmtId> body = BodyOf(code.program, id);
  if (body.empty() || !EmitsVertex(code.program, body.back())) return WriteStmts(code, body);
  const std::vector<KeptOutput> kept = KeepOutputs(code);
  WriteStmts(code, body.first(body.size() - 1));
  WriteKept(code, kept);
  WriteStmts(code, body.last(1));
}

void WriteFunction(Code& code, FunctionId id, std::string_view name) {
  code.namer.OpenScope();
  WriteSignature(code, id, name);
  ++code.indent;
  WriteBody(code, id);
  if (const std::string_view remark = code[id].remark; !remark.empty()) {
    code.out->pop_back();
    code.Put("  // ", remark, "\n");
  }
  --code.indent;
  code.Line("}");
  code.namer.CloseScope();
}

void WriteMain(Code& code, std::span<const LateGlobal> late) {
  code.namer.OpenScope();
  code.Line("void main() {");
  ++code.indent;
  for (const auto& [name, value] : late) code.Line(name, " = ", value, ";");
  std::vector<KeptOutput> kept;
  if (OutputFunction(code.program) == code.program.main) kept = KeepOutputs(code);
  // A path that does not write the depth has that of the primitive: GLSL has none there at all.
  for (const IoVar& output : code.program.outputs)
    if (output.may_be_unwritten && !output.is_unwritten && IsDepth(output.builtin))
      code.Line(code.NameOf(output.var), " = gl_FragCoord.z;");
  if (code.has_order) code.Line("beginInvocationInterlockARB();");
  WriteStmts(code, MainBody(code.program));
  if (code.has_order) code.Line("endInvocationInterlockARB();");
  WriteKept(code, kept);
  --code.indent;
  code.Line("}");
  code.namer.CloseScope();
}

}  // namespace

std::string WriteFunctions(Code& code, std::span<const LateGlobal> late) {
  std::string text;
  text.reserve(2048);
  code.out = &text;
  for (const FunctionId id : code.reached.functions) {
    if (id == code.program.main) {
      WriteMain(code, late);
    } else {
      WriteFunction(code, id, code.names.functions[id.index]);
      text += '\n';
    }
  }
  return text;
}

void WriteReader(Code& code, FunctionId id, const std::string& name) {
  const Function& function = code[id];
  code.names.functions[id.index] = name;
  const bool is_macro = !function.parameters.empty() && InfoOf(code.program.stage).draws_pixels &&
                        !code.Has(Feature::kFreeIndices);
  const std::string text = code.Apart([&] {
    if (!is_macro) return WriteFunction(code, id, name);
    code.namer.OpenScope();
    const VarId index = function.parameters[0];
    code.NameLocal(index, "i");
    std::string& parameter = code.names.vars[index.index];
    code.Line("// offset ", *function.offset);
    code.Put("#define ", name, "(", parameter, ") (");
    parameter = Concat("(", parameter, ")");
    WriteExpr(code, code.As<Return>(BodyOf(code.program, id)[0])->value);
    code.Put(")\n");
    code.namer.CloseScope();
  });
  Append(code.helpers, text, "\n");
}

// Functions whose parameter types differ in HLSL only, as half and float do, are one function here:
// the first of them. Accessors of one name and such parameters are as many functions.
const std::string& HelperFunction(Code& code, FunctionId id) {
  std::string& known = code.names.functions[id.index];
  if (!known.empty()) return known;
  const bool is_accessor = code[id].is_accessor;
  const auto define = [&](const std::string& name) {
    const std::size_t indent = std::exchange(code.indent, 0);
    const bool in_helper = std::exchange(code.in_helper, !is_accessor);
    std::string text = code.Apart([&] { WriteFunction(code, id, name); });
    code.in_helper = in_helper;
    code.indent = indent;
    return text;
  };
  std::string key = ParameterTypes(code, id);
  if (is_accessor && HasHelper(code, code[id].name, key)) {
    std::string name = code.namer.Global(code[id].name, "helper");
    const std::string definition = define(name);
    Append(code.helpers, definition, "\n");
    return known = std::move(name);
  }
  std::string name = Helper(code, code[id].name, key, define);
  return known = std::move(name);
}

}  // namespace clipc::glsl
