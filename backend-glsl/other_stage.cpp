// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/other_stage.h"

#include <algorithm>
#include <set>
#include <utility>

namespace clipc::glsl {

using namespace ir;

namespace {

// Whether two types of two programs are the same in all that a shader sees.
class TypeComparer {
 public:
  TypeComparer(const TypeTable& ours, const TypeTable& theirs) : ours_(ours), theirs_(theirs) {}

  bool IsSame(TypeId our_id, TypeId their_id) {
    if (!our_id || !their_id) return !our_id && !their_id;
    const Type& ours = ours_[our_id];
    const Type& theirs = theirs_[their_id];
    if (ours.kind != theirs.kind) return false;
    switch (ours.kind) {
      case TypeKind::kScalar:
      case TypeKind::kVector:
      case TypeKind::kMatrix:
        return ours.scalar == theirs.scalar && ours.rows == theirs.rows &&
               ours.columns == theirs.columns;
      case TypeKind::kArray:
        return ours.count == theirs.count && IsSame(ours.element, theirs.element);
      case TypeKind::kStruct:
        return !compared_.emplace(our_id, their_id).second ||
               IsSame(ours_.StructOf(our_id), theirs_.StructOf(their_id));
      default: return ours.object == theirs.object && IsSame(ours.element, theirs.element);
    }
  }

 private:
  bool IsSame(const Struct& ours, const Struct& theirs) {
    return ours.name == theirs.name &&
           std::ranges::equal(ours.fields, theirs.fields, [&](const Field& a, const Field& b) {
             return a.name == b.name && a.row_major == b.row_major && IsSame(a.type, b.type);
           });
  }

  const TypeTable& ours_;
  const TypeTable& theirs_;
  // The structs that are compared already, or are being compared: each pair is entered once,
  // however often other structs have it. A difference ends the comparison of everything that has
  // the pair.
  std::set<std::pair<TypeId, TypeId>> compared_;
};

bool IsSamePlace(const Register& ours, const Register& theirs) {
  const auto& our_place = ours.descriptor;
  const auto& their_place = theirs.descriptor;
  if (our_place && their_place)
    return our_place->binding == their_place->binding && our_place->set == their_place->set;
  return !ours.is_explicit || !theirs.is_explicit ||
         (ours.letter == theirs.letter && ours.number == theirs.number &&
          ours.space == theirs.space);
}

class StageComparer {
 public:
  StageComparer(const ReachedStage& ours, const ReachedStage& theirs)
      : ours_(ours.program),
        theirs_(theirs.program),
        our_reached_(ours.reached),
        their_reached_(theirs.reached) {}

  OtherStage Run() {
    const Reached& ours = our_reached_;
    const Reached& theirs = their_reached_;
    OtherStage other;
    other.cbuffers.resize(ours_.cbuffers.size());
    other.vars.resize(ours_.vars.size());
    other.is_read.resize(ours_.vars.size());
    for (const CbufferId id : ours_.cbuffers.ids()) {
      for (const CbufferId candidate : theirs_.cbuffers.ids()) {
        if (ours.Has(id) && theirs.Has(candidate) &&
            IsSame(ours_.cbuffers[id], theirs_.cbuffers[candidate]))
          other.cbuffers[id.index] = candidate;
      }
      if (other.cbuffers[id.index]) Members(id, theirs, other);
    }
    for (const Resource& resource : ours_.resources) {
      for (const Resource& candidate : theirs_.resources) {
        if (ours.Has(resource.var) && theirs.Has(candidate.var) && IsSame(resource, candidate))
          other.vars[resource.var.index] = candidate.var;
      }
    }
    return other;
  }

 private:
  void Members(CbufferId id, const Reached& theirs, OtherStage& other) const {
    const auto& members = ours_.cbuffers[id].members;
    const auto& their_members = theirs_.cbuffers[other.cbuffers[id.index]].members;
    for (std::size_t i = 0; i < members.size(); ++i) {
      other.vars[members[i].var.index] = their_members[i].var;
      other.is_read[members[i].var.index] = theirs.Has(their_members[i].var);
    }
  }

  bool IsSame(VarId ours, VarId theirs) const {
    const Var& our_var = ours_.vars[ours];
    const Var& their_var = theirs_.vars[theirs];
    return our_var.name == their_var.name && our_var.row_major == their_var.row_major &&
           TypeComparer(ours_.types, theirs_.types).IsSame(our_var.type, their_var.type);
  }
  bool IsSame(const Resource& ours, const Resource& theirs) const {
    return ours.format == theirs.format && IsSamePlace(ours.reg, theirs.reg) &&
           IsSame(ours.var, theirs.var) && CountSame(ours, theirs) &&
           TypeComparer(ours_.types, theirs_.types)
               .IsSame(ours.declared_type, theirs.declared_type);
  }
  // Whether two hidden counters are those of one buffer; true of two that are not counters.
  bool CountSame(const Resource& ours, const Resource& theirs) const {
    if (!ours.counter_of || !theirs.counter_of) return !ours.counter_of && !theirs.counter_of;
    const auto of = [](const Program& program, const Resource& counter) -> const Resource& {
      return *std::ranges::find(program.resources, counter.counter_of, &Resource::var);
    };
    return IsSame(of(ours_, ours), of(theirs_, theirs));
  }
  bool IsSame(const Cbuffer& ours, const Cbuffer& theirs) const {
    // $Params are the parameters of one entry function.
    return ours.kind == theirs.kind && ours.kind != CbufferKind::kParams &&
           ours.name == theirs.name && ours.size == theirs.size && ours.count == theirs.count &&
           ours.is_push_constant == theirs.is_push_constant && IsSamePlace(ours.reg, theirs.reg) &&
           std::ranges::equal(ours.members, theirs.members,
                              [&](const CbufferMember& a, const CbufferMember& b) {
                                return a.offset == b.offset && IsSame(a.var, b.var);
                              });
  }

  const Program& ours_;
  const Program& theirs_;
  const Reached& our_reached_;
  const Reached& their_reached_;
};

bool HasDistances(const Program& program) {
  const auto is_distance = [](const IoVar& io) {
    return io.builtin == Builtin::kClipDistance || io.builtin == Builtin::kCullDistance ||
           io.builtin == Builtin::kClipDistanceInput || io.builtin == Builtin::kCullDistanceInput;
  };
  return std::ranges::any_of(program.inputs, is_distance) ||
         std::ranges::any_of(program.outputs, is_distance);
}

// Whether the vertices of one stage are an array in the other, or in a stage between the two.
bool SharesVertices(const Program& program, const Program& other) {
  const StageInfo& a = InfoOf(program.stage);
  const StageInfo& b = InfoOf(other.stage);
  return !a.draws_pixels && !b.draws_pixels && (a.reads_vertices || b.reads_vertices);
}

}  // namespace

OtherStage CompareStages(const ReachedStage& stage, const ReachedStage& other) {
  OtherStage compared = StageComparer(stage, other).Run();
  compared.has_distances =
      SharesVertices(stage.program, other.program) && HasDistances(other.program);
  return compared;
}

}  // namespace clipc::glsl
