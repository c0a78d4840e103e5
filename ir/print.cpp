// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/print.h"

#include <iterator>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "clip-table/vocabulary.h"
#include "ir/printer.h"

namespace clipc::ir {
namespace {

constexpr Named<Form> kForms[] = {{Form::kTyped, "typed"},
                                  {Form::kResolved, "resolved"},
                                  {Form::kNoClipPlanes, "no-clip-planes"},
                                  {Form::kTargetClipSpace, "target-clip-space"},
                                  {Form::kInlined, "inlined"},
                                  {Form::kLegalized, "legalized"},
                                  {Form::kAddressed, "addressed"}};
constexpr Named<CbufferKind> kCbufferKinds[] = {{CbufferKind::kCbuffer, "cbuffer"},
                                                {CbufferKind::kTbuffer, "tbuffer"},
                                                {CbufferKind::kGlobals, "globals"},
                                                {CbufferKind::kParams, "params"},
                                                {CbufferKind::kConstantBuffer, "constant_buffer"}};
constexpr Named<Interpolation> kInterpolations[] = {
    {Interpolation::kDefault, ""},
    {Interpolation::kLinear, " linear"},
    {Interpolation::kNoInterpolation, " nointerpolation"},
    {Interpolation::kNoPerspective, " noperspective"}};

// " linear centroid sample", as far as a field or an input or output has them.
template <typename Interpolated>
std::string InterpolationText(const Interpolated& value) {
  return std::string(NameIn<kInterpolations>(value.interpolation)) +
         (value.centroid ? " centroid" : "") + (value.sample ? " sample" : "");
}

std::string PrintedRegister(const Register& reg) {
  return fmt::format(" : {}{}{}{}", reg.letter, reg.number,
                     reg.space != 0 ? fmt::format(", space{}", reg.space) : "",
                     reg.is_explicit ? " explicit" : "");
}

// The parts of a program around its functions.
class ProgramPrinter {
 public:
  explicit ProgramPrinter(const Program& program) : program_(program), printer_(program) {}

  std::string Print() {
    Line("program {} form {}", program_.profile.name, NameIn<kForms>(program_.form));
    for (Id<Struct> id : program_.types.structs().ids()) PrintStruct(program_.types[id]);
    for (CbufferId id : program_.cbuffers.ids()) PrintCbuffer(program_.cbuffers[id]);
    for (const Resource& resource : program_.resources) {
      Line("resource {}{}", printer_.Declaration(resource.var), PrintedRegister(resource.reg));
    }
    if (const auto& [x, y, z] = program_.group_size; x > 0) Line("group {} {} {}", x, y, z);
    if (const Emission& emission = program_.emission; !emission.streams.empty())
      Line("emission {} -> {}, {} vertices, {} instances", InfoOf(emission.input).name,
           InfoOf(emission.output).name, emission.max_vertices, emission.instances);
    if (const Tessellation& patch = program_.tessellation; patch.domain)
      Line("patch {}, {} -> {} points", InfoOf(*patch.domain).name, patch.input_points,
           patch.output_points);
    for (const IoVar& input : program_.inputs) PrintIo("input ", input);
    for (const IoVar& output : program_.outputs) PrintIo("output ", output);
    for (std::size_t i = 0; i < program_.clip_planes.size(); ++i) PrintClipPlane(i);
    for (VarId var : program_.globals)
      printer_.Line(printer_.Declaration(var, program_.vars[var].init));
    for (FunctionId id : program_.functions.ids()) {
      const bool is_helper = program_.functions[id].is_helper;
      const std::string_view role = id == program_.main    ? "main "
                                    : id == program_.entry ? "entry "
                                    : is_helper            ? "helper "
                                                           : "";
      printer_.PrintFunction(id, role);
    }
    return printer_.Take();
  }

 private:
  template <typename... Parts>
  void Line(fmt::format_string<Parts...> form, Parts&&... parts) {
    printer_.Line(fmt::format(form, std::forward<Parts>(parts)...));
  }

  void PrintStruct(const Struct& structure) {
    Line("struct {} {{", structure.name.empty() ? "<unnamed struct>" : structure.name);
    for (const Field& field : structure.fields) {
      Line("  {}{}{}{}{}{}", field.row_major ? "row_major " : "", field.precise ? "precise " : "",
           printer_.Declarator(field.type, field.name), field.semantic.empty() ? "" : " : ",
           field.semantic, InterpolationText(field));
    }
    Line("}}");
  }

  void PrintCbuffer(const Cbuffer& buffer) {
    Line("{} {}{}, {} bytes{} {{", NameIn<kCbufferKinds>(buffer.kind), buffer.name,
         PrintedRegister(buffer.reg), buffer.size,
         buffer.count != 1 ? fmt::format(" x {}", buffer.count) : "");
    for (const CbufferMember& member : buffer.members) {
      Line("  {} at {}, {} bytes{}", printer_.Declaration(member.var), member.offset, member.size,
           member.has_packoffset ? " explicit" : "");
    }
    Line("}}");
  }

  void PrintIo(const char* direction, const IoVar& io) {
    const std::string semantic =
        io.semantic.empty() ? "" : fmt::format(" : {}{}", io.semantic, io.index);
    const std::string place = io.builtin == Builtin::kNone
                                  ? fmt::format("location {}", io.location)
                                  : fmt::format("builtin {}", InfoOf(io.builtin).name);
    Line("{}{}{}{} {}{}", direction, io.is_of_patch ? "patch " : "", printer_.Declaration(io.var),
         semantic, place, InterpolationText(io));
  }

  void PrintClipPlane(std::size_t index) {
    const ClipPlane& plane = program_.clip_planes[index];
    std::string line = fmt::format("clip_plane {} `{}`", index, plane.text);
    if (plane.value) line += " = " + printer_.ExprText(plane.value);
    if (plane.whole_register && plane.cbuffer) {
      const Cbuffer& buffer = program_.cbuffers[plane.cbuffer];
      line += " at " + buffer.name;
      if (buffer.count != 1) line += fmt::format("[{}]", plane.element);
      line += fmt::format("+{}", plane.offset);
    }
    printer_.Line(line);
  }

  const Program& program_;
  Printer printer_;
};

}  // namespace

std::string Print(const Program& program) { return ProgramPrinter(program).Print(); }

std::string PrintExpr(const Program& program, ExprId expr) {
  return Printer(program).ExprText(expr);
}

}  // namespace clipc::ir
