// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/print.h"

#include <string_view>

#include "base/overloaded.h"
#include "ir/printer.h"

namespace clipc::ir {
namespace {

const char* NameOf(Builtin builtin) {
  switch (builtin) {
    case Builtin::kNone: return "none";
    case Builtin::kPosition: return "position";
    case Builtin::kClipVertex: return "clip_vertex";
    case Builtin::kClipDistance: return "clip_distance";
    case Builtin::kCullDistance: return "cull_distance";
    case Builtin::kPointSize: return "point_size";
    case Builtin::kVertexId: return "vertex_id";
    case Builtin::kInstanceId: return "instance_id";
    case Builtin::kBaseVertex: return "base_vertex";
    case Builtin::kBaseInstance: return "base_instance";
    case Builtin::kDrawIndex: return "draw_index";
    case Builtin::kViewId: return "view_id";
    case Builtin::kVertexIndex: return "vertex_index";
    case Builtin::kInstanceIndex: return "instance_index";
    case Builtin::kShadingRate: return "shading_rate";
    case Builtin::kLayer: return "layer";
    case Builtin::kViewportIndex: return "viewport_index";
  }
  return "?";
}

const char* NameOf(Form form) {
  switch (form) {
    case Form::kTyped: return "typed";
    case Form::kNoClipPlanes: return "no-clip-planes";
    case Form::kTargetClipSpace: return "target-clip-space";
    case Form::kInlined: return "inlined";
    case Form::kLegalized: return "legalized";
  }
  return "?";
}

const char* NameOf(CbufferKind kind) {
  switch (kind) {
    case CbufferKind::kCbuffer: return "cbuffer";
    case CbufferKind::kTbuffer: return "tbuffer";
    case CbufferKind::kGlobals: return "globals";
    case CbufferKind::kParams: return "params";
    case CbufferKind::kConstantBuffer: return "constant_buffer";
  }
  return "?";
}

const char* NameOf(Interpolation interpolation) {
  switch (interpolation) {
    case Interpolation::kDefault: return "";
    case Interpolation::kLinear: return " linear";
    case Interpolation::kNoInterpolation: return " nointerpolation";
    case Interpolation::kNoPerspective: return " noperspective";
  }
  return "";
}

std::string PrintedRegister(const Register& reg) {
  std::string text = " : " + std::string(1, reg.letter) + std::to_string(reg.number);
  if (reg.space != 0) text += ", space" + std::to_string(reg.space);
  return text + (reg.is_explicit ? " explicit" : "");
}

// The parts of a program around its functions.
class ProgramPrinter {
 public:
  explicit ProgramPrinter(const Program& program) : program_(program), printer_(program) {}

  std::string Print() {
    Line("program " + program_.profile.name + " form " + NameOf(program_.form));
    for (Id<Struct> id : program_.types.structs().ids()) PrintStruct(program_.types[id]);
    for (CbufferId id : program_.cbuffers.ids()) PrintCbuffer(program_.cbuffers[id]);
    for (const Resource& resource : program_.resources) {
      Line("resource " + printer_.Declaration(resource.var) + PrintedRegister(resource.reg));
    }
    for (const IoVar& input : program_.inputs) PrintIo("input ", input);
    for (const IoVar& output : program_.outputs) PrintIo("output ", output);
    for (std::size_t i = 0; i < program_.clip_planes.size(); ++i) PrintClipPlane(i);
    for (VarId global : program_.globals) PrintGlobal(global);
    for (FunctionId id : program_.functions.ids()) {
      const bool is_helper = program_.functions[id].is_helper;
      std::string_view role = id == program_.main    ? "main "
                              : id == program_.entry ? "entry "
                              : is_helper            ? "helper "
                                                     : "";
      printer_.PrintFunction(id, role);
    }
    return printer_.Take();
  }

 private:
  void Line(const std::string& text) { printer_.Line(text); }

  void PrintStruct(const Struct& structure) {
    Line("struct " + (structure.name.empty() ? "<unnamed struct>" : structure.name) + " {");
    for (const Field& field : structure.fields) {
      std::string line = "  ";
      if (field.row_major) line += "row_major ";
      if (field.precise) line += "precise ";
      line += printer_.Declarator(field.type, field.name);
      if (!field.semantic.empty()) line += " : " + field.semantic;
      Line(line + NameOf(field.interpolation) + (field.centroid ? " centroid" : "") +
           (field.sample ? " sample" : ""));
    }
    Line("}");
  }

  void PrintCbuffer(const Cbuffer& buffer) {
    std::string line =
        std::string(NameOf(buffer.kind)) + " " + buffer.name + PrintedRegister(buffer.reg);
    line += ", " + std::to_string(buffer.size) + " bytes";
    if (buffer.count != 1) line += " x " + std::to_string(buffer.count);
    Line(line + " {");
    for (const CbufferMember& member : buffer.members) {
      Line("  " + printer_.Declaration(member.var) + " at " + std::to_string(member.offset) + ", " +
           std::to_string(member.size) + " bytes" + (member.has_packoffset ? " explicit" : ""));
    }
    Line("}");
  }

  void PrintIo(const char* direction, const IoVar& io) {
    std::string line = direction + printer_.Declaration(io.var);
    if (!io.semantic.empty()) line += " : " + io.semantic + std::to_string(io.index);
    line += io.builtin == Builtin::kNone ? " location " + std::to_string(io.location)
                                         : std::string(" builtin ") + NameOf(io.builtin);
    Line(line + NameOf(io.interpolation) + (io.centroid ? " centroid" : "") +
         (io.sample ? " sample" : ""));
  }

  void PrintClipPlane(std::size_t index) {
    const ClipPlane& plane = program_.clip_planes[index];
    std::string line = "clip_plane " + std::to_string(index) + " `" + plane.text + "`";
    if (plane.value) line += " = " + printer_.ExprText(plane.value);
    if (plane.whole_register && plane.cbuffer) {
      line += " at " + program_.cbuffers[plane.cbuffer].name;
      if (program_.cbuffers[plane.cbuffer].count != 1)
        line += "[" + std::to_string(plane.element) + "]";
      line += "+" + std::to_string(plane.offset);
    }
    Line(line);
  }

  void PrintGlobal(VarId var) {
    const ExprId init = program_.vars[var].init;
    Line(printer_.Declaration(var) + (init ? " = " + printer_.ExprText(init) : ""));
  }

  const Program& program_;
  Printer printer_;
};

}  // namespace

std::string Print(const Program& program) { return ProgramPrinter(program).Print(); }

std::string PrintExpr(const Program& program, ExprId expr) {
  Printer printer(program);
  return printer.ExprText(expr);
}

}  // namespace clipc::ir
