// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "link/match.h"

#include <algorithm>
#include <utility>

#include "base/invariant.h"
#include "ir/access.h"
#include "ir/builder.h"
#include "link/match_inputs.h"
#include "link/members.h"
#include "link/names.h"

namespace clipc::link {
namespace {

using namespace ir;

class Applier {
 public:
  Applier(Program& program, const Interface& pixel, const Matches& matches,
          const MatchOptions& options)
      : program_(program), pixel_(pixel), matches_(matches), options_(options) {
    group_ends_.resize(pixel.groups.size());
    std::uint32_t place = 0;
    for (const Input& input : pixel.inputs) {
      places_.push_back(input.location.value_or(place));
      place += input.type.Elements();
      if (!input.group) continue;
      std::uint32_t& end = group_ends_[*input.group];
      end = std::max(end, places_.back() + input.type.Elements());
    }
  }

  void Run() {
    IoVars outputs;
    std::uint32_t end = 0;  // after the last location that the pixel shader has
    for (std::size_t i = 0; i < matches_.outputs.size(); ++i) {
      IoVar output = program_.outputs[i];
      if (const auto input = matches_.outputs[i].input) {
        Output(output, pixel_.inputs[*input], *input, matches_.outputs[i].element);
        end = std::max(end, EndOf(pixel_.inputs[*input], output.location));
      } else if (output.builtin == Builtin::kNone && !options_.keep_outputs &&
                 StreamOf(program_, output.var) == 0 && !IsReadBack(output.var)) {
        RemoveWrites(output.var);
        continue;
      }
      outputs.push_back(std::move(output));
    }
    for (const std::size_t input : matches_.zeros) AddZeros(pixel_.inputs[input], input, outputs);
    for (IoVar& output : outputs) {
      if (output.builtin == Builtin::kNone && !output.reader) output.location = end++;
    }
    SortByLocation(outputs);
    program_.outputs = std::move(outputs);
    Groups();
    for (const CbufferId id : program_.cbuffers.ids()) {
      const Matches::Buffer& match = matches_.buffers[id.index];
      if (match.block) Buffer(program_.cbuffers[id], pixel_.blocks[*match.block]);
      if (match.is_loose) Loose(program_.cbuffers[id], match);
    }
  }

 private:
  void Output(IoVar& output, const Input& input, std::size_t number, std::uint32_t element) {
    Reader& reader = output.reader.emplace();
    reader.stage = pixel_.stage;
    reader.name = NameOf(input);
    reader.group = input.group;
    reader.member = static_cast<std::size_t>(std::ranges::count(
        pixel_.inputs.begin(), pixel_.inputs.begin() + static_cast<std::ptrdiff_t>(number),
        input.group, &Input::group));
    reader.has_location = input.location.has_value();
    reader.columns = input.type.columns;
    reader.dimensions = input.type.dimensions;
    reader.element = element;
    output.location = places_[number] + element;
    output.interpolation = input.interpolation;
    output.centroid = input.centroid;
    output.sample = input.sample;
    SetType(output.var, input.type);
  }

  // Adds outputs that are 0 for an input that nothing writes.
  void AddZeros(const Input& input, std::size_t number, IoVars& outputs) {
    const Span span = program_.functions[program_.entry].span;
    const TypeId type = TypeOfElement(input.type);
    Builder builder(program_, span);
    std::vector<StmtId> body;
    for (std::uint32_t i = 0; i < input.type.Elements(); ++i) {
      IoVar output;
      output.var = program_.vars.Add(
          {.name = input.name, .type = type, .storage = Storage::kOutput, .span = span});
      output.semantic = input.semantic.empty() ? input.name : input.semantic;
      output.index = input.index + i;
      output.is_of_patch = input.is_of_patch;
      Output(output, input, number, i);
      body.push_back(builder.Eval(builder.AssignTo(builder.Ref(output.var), builder.ZeroOf(type))));
      outputs.push_back(std::move(output));
    }
    AppendToOutputs(program_, body);
  }

  // The location after the output's, or after the group's that it is in.
  std::uint32_t EndOf(const Input& input, std::uint32_t location) const {
    return std::max(location + 1, input.group ? group_ends_[*input.group] : 0);
  }

  // Declares the groups that outputs match; for Vulkan all groups, since every input has its output
  // there.
  void Groups() {
    std::vector<std::optional<std::size_t>> numbers(pixel_.groups.size());
    for (std::size_t i = 0; i < pixel_.groups.size(); ++i) {
      const bool is_written =
          std::ranges::any_of(matches_.outputs,
                              [&](const auto& output) { return GroupOf(output.input) == i; }) ||
          std::ranges::any_of(matches_.zeros, [&](auto input) { return GroupOf(input) == i; });
      if (!is_written && !options_.is_vulkan) continue;
      numbers[i] = program_.output_groups.size();
      const Group& group = pixel_.groups[i];
      program_.output_groups.push_back(
          {group.is_block, group.type, group.instance, group.location, MembersOfGroup(i)});
    }
    for (IoVar& output : program_.outputs) {
      if (output.reader && output.reader->group)
        output.reader->group = numbers[*output.reader->group];
    }
  }

  std::optional<std::size_t> GroupOf(std::optional<std::size_t> input) const {
    return input ? pixel_.inputs[*input].group : std::nullopt;
  }

  std::vector<OutputGroup::GroupMember> MembersOfGroup(std::size_t group) const {
    std::vector<OutputGroup::GroupMember> members;
    for (const Input& input : pixel_.inputs) {
      if (input.group != group) continue;
      members.push_back({input.name, input.type.scalar, input.type.components, input.type.columns,
                         input.type.dimensions, input.interpolation, input.centroid, input.sample,
                         input.has_own_location ? input.location : std::nullopt});
    }
    return members;
  }

  // The name of an input in a linked program.
  std::string NameOf(const Input& input) const {
    if (!input.group) return input.name;
    const Group& group = pixel_.groups[*input.group];
    if (group.instance.empty()) return input.name;
    return (group.is_block ? group.type : group.instance) + "." + input.name;
  }

  TypeId TypeOfElement(const GlslType& type) {
    const Scalar kind = type.scalar == Scalar::kBool ? Scalar::kUint : type.scalar;
    return type.components == 1 ? program_.types.Make(kind)
                                : program_.types.Vector(kind, type.components);
  }

  // Gives the output the type of one element of the input, and makes its value fit.
  void SetType(VarId var, const GlslType& wanted) {
    const TypeId type = TypeOfElement(wanted);
    const Scalar kind = program_.types[type].scalar;
    if (program_.vars[var].type == type) return;
    program_.vars[var].type = type;
    for (const StmtId block : OutputBlocks()) {
      for (const StmtId id : StmtsOf(block)) {
        const ExprId evaluated = WriteOf(id, var);
        if (!evaluated) continue;
        Assign assign = *As<Assign>(program_, evaluated);
        program_.exprs[assign.target].type = type;
        assign.value = Fitted(assign.value, type, kind, wanted.components);
        program_.exprs[evaluated].node = assign;
        program_.exprs[evaluated].type = type;
      }
    }
  }

  // The blocks whose statements write outputs: a hull shader writes the constants of the patch in
  // one of their own.
  std::vector<StmtId> OutputBlocks() const {
    std::vector<StmtId> blocks{program_.functions[OutputFunction(program_)].body};
    if (const StmtId patch = PatchBlock(program_)) blocks.push_back(patch);
    return blocks;
  }

  std::vector<StmtId> StmtsOf(StmtId block) const {
    const auto stmts = program_.stmt_lists[As<Block>(program_, block)->body];
    return {stmts.begin(), stmts.end()};
  }

  // Whether a hull shader reads the output of its control points itself.
  bool IsReadBack(VarId output) const {
    const StmtId patch = PatchBlock(program_);
    return patch && AnyExpr(program_, patch, [&](ExprId id) {
             const auto* call = As<IntrinsicCall>(program_, id);
             return call && call->op == CommonIntrinsic::kOutputOfPoint &&
                    RootOf(program_, program_.expr_lists[call->arguments][0]) == output;
           });
  }

  ExprId Fitted(ExprId value, TypeId type, Scalar kind, std::uint32_t components) {
    Builder builder(program_, program_.exprs[value].span);
    value = builder.ConvertTo(kind, value);
    const Type from = program_.types[builder.TypeOf(value)];
    const std::uint32_t size = from.Components();
    if (size == components && from.kind == program_.types[type].kind) return value;
    if (size >= components) return builder.SwizzledRun(value, 0, components);
    std::vector<ExprId> parts{value};
    for (std::uint32_t i = size; i < components; ++i) parts.push_back(builder.LiteralOf(kind, 0));
    return builder.ConstructOf(type, parts);
  }

  // The assignment of the statement if it writes the output; otherwise none.
  ExprId WriteOf(StmtId id, VarId output) const {
    const auto* evaluate = As<Evaluate>(program_, id);
    const auto* assign = evaluate ? As<Assign>(program_, evaluate->expr) : nullptr;
    const auto* target = assign ? As<VarRef>(program_, assign->target) : nullptr;
    return target && target->var == output ? evaluate->expr : ExprId{};
  }

  void RemoveWrites(VarId output) {
    for (const StmtId block : OutputBlocks()) {
      std::vector<StmtId> body = StmtsOf(block);
      std::erase_if(body, [&](StmtId id) { return bool{WriteOf(id, output)}; });
      program_.stmts[block].node = Block{program_.stmt_lists.Add(std::span<const StmtId>(body))};
    }
  }

  static void Loose(Cbuffer& cbuffer, const Matches::Buffer& match) {
    BlockDeclaration& declared = cbuffer.declared.emplace();
    declared.is_loose = true;
    for (const Precision precision : match.precisions)
      declared.members.push_back({.name = {}, .precision = precision});
  }

  void Buffer(Cbuffer& cbuffer, const UniformBlock& block) const {
    BlockDeclaration& declared = cbuffer.declared.emplace();
    declared.name = block.name;
    declared.has_instance = block.has_instance;
    // Instances of two stages have names of their own; `_45` is not a name to read.
    const bool is_readable = !block.instance.empty() && !block.instance.starts_with('_');
    declared.instance = is_readable ? block.instance : GlslNameOf(cbuffer.name);
    if (declared.instance == declared.name) {
      char& first = declared.instance[0];
      if (first >= 'A' && first <= 'Z') first = static_cast<char>(first - 'A' + 'a');
    }
    declared.rows_on_block = block.rows_on_block;
    declared.set = block.set;
    declared.binding = block.binding;
    const std::vector<UniformMember> ours = MembersOf(program_, cbuffer);
    for (std::size_t i = 0; i < ours.size(); ++i) {
      const UniformMember& member = block.members[i];
      const bool is_bool = ours[i].type && ours[i].type->scalar == Scalar::kBool;
      declared.members.push_back(
          {member.name, is_bool && member.type != ours[i].type, member.precision});
    }
  }

  Program& program_;
  const Interface& pixel_;
  const Matches& matches_;
  const MatchOptions& options_;
  // The location of each input, counted where the pixel shader gives none, and for each group the
  // location after its last member's.
  std::vector<std::uint32_t> places_, group_ends_;
};

}  // namespace

Matches Match(const Program& program, const Interface& pixel, const MatchOptions& options,
              Diagnostics& diagnostics) {
  Matches matches = MatchInputs(program, pixel, options, diagnostics);
  matches.buffers = MatchBlocks(program, pixel, options, diagnostics);
  return matches;
}

void Apply(Program& program, const Interface& pixel, const Matches& matches,
           const MatchOptions& options) {
  CLIPC_CHECK(program.form == Form::kResolved);
  Applier(program, pixel, matches, options).Run();
}

}  // namespace clipc::link
