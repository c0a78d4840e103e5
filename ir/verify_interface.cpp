// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/verify_interface.h"

#include <bitset>
#include <set>

#include "clip-table/vocabulary.h"
#include "ir/packing.h"

namespace clipc::ir {
namespace {

constexpr std::uint32_t kMaxClipDistances = 8;

class InterfaceVerifier {
 public:
  explicit InterfaceVerifier(const Program& program) : program_(program) {}

  std::optional<std::string> Run() {
    CheckEntryPoints();
    CheckVars();
    CheckIo(program_.inputs, Storage::kInput, "input");
    CheckIo(program_.outputs, Storage::kOutput, "output");
    for (CbufferId id : program_.cbuffers.ids()) CheckCbuffer(id);
    for (const Resource& resource : program_.resources) {
      if (Known(resource.var, "a resource") &&
          program_.vars[resource.var].storage != Storage::kResource) {
        Fail("resource " + program_.vars[resource.var].name + " is not of resource storage");
      }
    }
    CheckClipPlanes();
    return problem_;
  }

 private:
  void Fail(std::string what) {
    if (!problem_) problem_ = std::move(what);
  }
  bool Known(VarId var, const std::string& what) {
    if (var.index < program_.vars.size()) return true;
    Fail(what + " is not a variable of this program");
    return false;
  }

  void CheckEntryPoints() {
    if (program_.main.index >= program_.functions.size()) return Fail("the program has no main");
    if (program_.entry.index >= program_.functions.size()) return Fail("the program has no entry");
    const Function& main = program_.functions[program_.main];
    if (!main.parameters.empty() || main.return_type != program_.types.Void()) {
      Fail("main is void and has no parameters");
    }
  }

  void CheckVars() {
    for (VarId id : program_.vars.ids()) {
      const Var& var = program_.vars[id];
      if (!var.type || program_.types[var.type].kind == TypeKind::kError)
        Fail("variable " + var.name + " has no type");
      if (var.storage == Storage::kUniform && var.cbuffer.index >= program_.cbuffers.size()) {
        Fail("uniform " + var.name + " is not in a cbuffer");
      }
    }
  }

  // ---- inputs and outputs

  void CheckIo(const IoVars& list, Storage storage, const std::string& direction) {
    std::set<VarId> seen;
    std::bitset<64> builtins;
    const IoVar* last = nullptr;  // the one before that is not built in
    for (const IoVar& io : list) {
      if (!Known(io.var, "an " + direction)) return;
      const Var& var = program_.vars[io.var];
      std::string what = direction;
      what += " " + var.name;
      if (var.storage != storage) Fail(what + " is not of this storage");
      if (!seen.insert(io.var).second) Fail(what + " is listed twice");
      if (io.builtin == Builtin::kNone) {
        const Type& type = program_.types[var.type];
        if (!type.IsScalarOrVector() || type.scalar == Scalar::kBool)
          Fail(what + " is a scalar or vector of numbers");
        // Two colors of one render target differ in the index by which the blender knows them.
        const bool rises = !last || io.location > last->location ||
                           (io.location == last->location && io.blend_index != last->blend_index);
        if (!rises) Fail(what + " has a location that is taken or out of order");
        last = &io;
        continue;
      }
      const auto bit = static_cast<std::size_t>(io.builtin);
      if (builtins[bit] && io.builtin != Builtin::kUntranslated)
        Fail(what + " gives its builtin a second time");
      builtins[bit] = true;
      if (!FitsBuiltin(io.builtin, var.type, storage))
        Fail(what + " does not have the direction and type of its builtin");
    }
  }

  bool FitsBuiltin(Builtin builtin, TypeId id, Storage storage) const {
    if (builtin == Builtin::kNone) return true;
    const Type& type = program_.types[id];
    const BuiltinInfo& info = InfoOf(builtin);
    if (storage != info.storage) return false;
    if (builtin == Builtin::kUntranslated) return type.IsScalarOrVector();
    if (info.components == 0) {
      return type.kind == TypeKind::kArray && type.count >= 1 && type.count <= kMaxClipDistances &&
             program_.types.Name(type.element) == "float";
    }
    const Scalar base = BaseOf(type.scalar);
    return type.kind == (info.components == 1 ? TypeKind::kScalar : TypeKind::kVector) &&
           type.columns == info.components &&
           (IsInteger(info.scalar) ? IsInteger(base) : base == info.scalar);
  }

  // ---- cbuffers

  void CheckCbuffer(CbufferId id) {
    const Cbuffer& buffer = program_.cbuffers[id];
    const std::string what = "cbuffer " + buffer.name;
    if (buffer.size % 16 != 0) Fail(what + " has a size that is not a multiple of 16");
    if (buffer.count == 0 && buffer.kind != CbufferKind::kConstantBuffer)
      Fail(what + " is an array without elements");
    if (buffer.kind == CbufferKind::kConstantBuffer && buffer.members.size() != 1) {
      Fail(what + " is a ConstantBuffer without exactly one member");
    }
    for (const CbufferMember& member : buffer.members) {
      if (!Known(member.var, "a member of " + what)) return;
      const Var& var = program_.vars[member.var];
      if (var.storage != Storage::kUniform || var.cbuffer != id)
        Fail(what + " has a member that is not its own");
      if (member.offset % 4 != 0) Fail(what + " has a member between two components: " + var.name);
      if (buffer.kind != CbufferKind::kConstantBuffer &&
          PackedOffset(program_.types, var.type, var.row_major, member.offset) != member.offset)
        Fail(what + " has a member across registers: " + var.name);
      if (std::uint64_t{member.offset} + member.size > buffer.size)
        Fail(what + " ends before its member " + var.name);
    }
  }

  // ---- clip planes

  void CheckClipPlanes() {
    if (program_.clip_planes.size() > kMaxClipPlanes) Fail("there are more than six clip planes");
    for (const ClipPlane& plane : program_.clip_planes) {
      const std::string what = "clip plane `" + plane.text + "`";
      if (program_.form <= Form::kResolved && !plane.value)
        Fail(what + " has no value before its lowering");
      if (program_.form > Form::kResolved && plane.value)
        Fail(what + " has a value after its lowering");
      if (!plane.whole_register) continue;
      if (plane.cbuffer.index >= program_.cbuffers.size()) {
        Fail(what + " is a whole register without a cbuffer");
        continue;
      }
      const Cbuffer& buffer = program_.cbuffers[plane.cbuffer];
      if (plane.offset % 16 != 0 || std::uint64_t{plane.offset} + 16 > buffer.size) {
        Fail(what + " is not a register of its cbuffer");
      }
      if (buffer.count != 0 && plane.element >= buffer.count)
        Fail(what + " is in a buffer past the end of the array");
    }
  }

  const Program& program_;
  std::optional<std::string> problem_;
};

}  // namespace

std::optional<std::string> CheckInterface(const Program& program) {
  return InterfaceVerifier(program).Run();
}

}  // namespace clipc::ir
