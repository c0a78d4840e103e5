// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/describe_entry.h"

#include <algorithm>
#include <string_view>

#include "base/invariant.h"
#include "base/overloaded.h"
#include "base/spelling.h"
#include "frontend/check/function.h"
#include "frontend/check/text.h"
#include "frontend/parse/attributes.h"
#include "frontend/parse/qualifiers.h"

namespace clipc::check {
namespace {

// The qualifiers that change what a value is, or how it passes to the next stage.
std::string QualifierText(ast::Qualifiers qualifiers) {
  constexpr ast::Qualifiers kOfFunctions =
      ast::kExport | ast::kExtern | ast::kInline | ast::kStatic | ast::kShared;
  std::string text;
  for (const std::string_view word : ast::SpellingsOf(qualifiers & ~kOfFunctions)) {
    text += word;
    text += ' ';
  }
  return text;
}

std::string AttributeText(const Context& context, const ast::Attr& attr) {
  const std::string_view name = context[attr.name];
  std::string arguments;
  for (const ast::ExprId argument : context[attr.arguments])
    arguments += (arguments.empty() ? "" : ", ") + TextOf(context, argument);
  if (attr.has_parens) arguments = "(" + arguments + ")";
  const bool is_doubled = name.find("::") != std::string_view::npos;
  return fmt::format("{}{}{}{}", is_doubled ? "[[" : "[", name, arguments, is_doubled ? "]]" : "]");
}

std::string SemanticText(const Context& context, const ast::Semantic& semantic) {
  return semantic.name ? fmt::format(" : {}", context[semantic.name]) : "";
}

std::string RegisterText(const Context& context, const ast::VarDecl& var) {
  std::string text;
  for (const ast::RegisterBinding& binding : context[var.registers]) {
    const std::string profile =
        binding.profile ? fmt::format("{}, ", context[binding.profile]) : "";
    const std::string sub =
        binding.subcomponent ? fmt::format("[{}]", TextOf(context, binding.subcomponent)) : "";
    if (!binding.letter) {
      text += fmt::format(" : register({}space{})", profile, binding.space);
    } else {
      text += fmt::format(" : register({}{}{}{}{})", profile, binding.letter, binding.number, sub,
                          binding.space ? fmt::format(", space{}", binding.space) : "");
    }
  }
  return text;
}

EntryParameterText ParameterText(const Context& context, const ast::VarDecl& var) {
  EntryParameterText text;
  for (const ast::Attr& attr : context[var.attributes])
    text.before += AttributeText(context, attr) + " ";
  text.before += QualifierText(var.qualifiers) + TypeText(context, var.type) + " ";
  text.name = context[var.name];
  text.after = DimensionText(context, var.dimensions) + SemanticText(context, var.semantic) +
               RegisterText(context, var);
  text.is_out = (var.qualifiers & ast::kOut) != 0;
  text.is_in = !text.is_out || (var.qualifiers & ast::kIn) != 0;
  return text;
}

void AddFirstNames(const Context& context, ast::ExprId id, std::vector<std::string>& names) {
  Visit(Overloaded{
            [&](const ast::NameExpr& e) {
              const auto scopes = context[e.name.scopes];
              names.emplace_back(context[scopes.empty() ? e.name.name : scopes.front()]);
            },
            [&](const ast::MemberExpr& e) { AddFirstNames(context, e.base, names); },
            [&](const ast::IndexExpr& e) {
              AddFirstNames(context, e.base, names);
              AddFirstNames(context, e.index, names);
            },
            [&](const ast::UnaryExpr& e) { AddFirstNames(context, e.operand, names); },
            [&](const ast::BinaryExpr& e) {
              AddFirstNames(context, e.left, names);
              AddFirstNames(context, e.right, names);
            },
            [&](const ast::CallExpr& e) {
              for (const ast::ExprId argument : context[e.arguments])
                AddFirstNames(context, argument, names);
            },
            [](const auto&) {},
        },
        context[id].node);
}

std::string FreePrefix(const ast::File& file) {
  for (int number = 1;; ++number) {
    std::string prefix = number == 1 ? "clipc_" : fmt::format("clipc{}_", number);
    bool is_free = true;
    for (std::uint32_t i = 0; i < file.names.size() && is_free; ++i)
      is_free = !file.names[Name{i}].starts_with(prefix);
    if (is_free) return prefix;
  }
}

// Fills what the function's own attributes and those of its prototypes say.
void DescribeAttributes(const Context& context, const AttributeLists& lists, EntryPoint& entry) {
  for (const std::span<const ast::Attr>& list : lists) {
    const bool is_definition = &list == &lists.front();
    for (const ast::Attr& attr : list) {
      const std::string_view name = context[attr.name];
      if (MeaningOfAttribute(name) == AttributeMeaning::kClipPlanes) {
        const auto shares = [&](const ast::Attr& other) {
          return &other != &attr && other.span.begin == attr.span.begin;
        };
        entry.clip_planes.push_back(std::ranges::any_of(list, shares) ? Span() : attr.span);
        entry.clip_plane_words.emplace_back(name);
        if (!entry.planes.empty()) continue;
        for (const ast::ExprId operand : context[attr.arguments]) {
          entry.planes.push_back(TextOf(context, operand));
          AddFirstNames(context, operand, entry.not_hidden);
        }
      } else {
        if (EqualIgnoringCase(name, "shader")) entry.shader_kinds.push_back(attr.span);
        if (is_definition) entry.attributes += AttributeText(context, attr) + "\n";
      }
    }
  }
}

// The functions of the entry's name and parameters: its definition and prototypes.
void DescribeNames(const Context& context, FunctionInfoId function, EntryPoint& entry) {
  const FunctionInfo& info = context[function];
  for (SymbolId id = context.names.NewestIn(info.scope, DeclOf(context, info).name); id;
       id = context[id].older) {
    if (context[id].kind != SymbolKind::kFunction) continue;
    const bool is_own = context[id].decl == info.decl;
    const FunctionInfoId other = is_own ? function : context.functions.Known(id, {});
    if (is_own || (other && SameParameters(context, info, context[other]))) {
      entry.names.push_back(DeclOf(context, id).name_span);
      entry.declarations.push_back(context[context[id].decl].span);
    }
  }
}

}  // namespace

EntryPoint Describe(const Context& context, FunctionInfoId function,
                    const AttributeLists& attributes) {
  const FunctionInfo& info = context[function];
  const ast::FunctionDecl& decl = DeclOf(context, info);
  EntryPoint entry;
  entry.name = context[decl.name];
  entry.not_hidden = {entry.name};
  for (ScopeId scope = info.scope; scope != context.names.global(); scope = context[scope].parent)
    entry.scope = fmt::format("{}::{}", context[context[scope].name], entry.scope);
  entry.prefix = FreePrefix(context.file);
  entry.definition = context[info.decl].span;
  const auto note_unnamed = [&](ast::TypeId type, std::string_view what) {
    if (!context[type].name.name) entry.unnamed_type = what;
  };
  note_unnamed(decl.return_type, "the result");
  // A result is no less a value for being const, and the wrapper's is assigned to.
  const ast::Qualifiers qualifiers = decl.qualifiers & ~ast::kConst;
  const std::string type = TypeText(context, decl.return_type);
  entry.return_type = QualifierText(qualifiers) + type;
  // DXC refuses `noperspective` and the like on a local variable.
  entry.result_type =
      QualifierText(qualifiers & ~ast::WithoutEffectAt(ast::QualifierOwner::kLocal, qualifiers)) +
      type;
  entry.return_semantic = SemanticText(context, decl.return_semantic);
  if (decl.return_dimensions.size > 0) entry.unnamed_type = "the result";
  entry.not_hidden.emplace_back(context[context[decl.return_type].name.name]);
  const auto parameters = context[info.parameters];
  for (const ast::DeclId id : context[decl.parameters]) {
    const auto& var = context.Get<ast::VarDecl>(id);
    const ast::DeclId with_default = parameters[entry.parameters.size()].with_default;
    EntryParameterText& text = entry.parameters.emplace_back(ParameterText(context, var));
    if (with_default)
      text.initial = " = " + TextOf(context, context.Get<ast::VarDecl>(with_default).init);
    note_unnamed(var.type, fmt::format("`{}`", context[var.name]));
  }
  DescribeAttributes(context, attributes, entry);
  DescribeNames(context, function, entry);
  return entry;
}

}  // namespace clipc::check

namespace clipc {

EntryAccess AccessOf(const EntryPoint& entry, const ir::IoVar& io) {
  const ir::Program& program = entry.program;
  const ir::Function& function = program.functions[program.entry];
  const std::size_t root_end = std::min(io.path.find_first_of(".["), io.path.size());
  const std::string_view root = std::string_view(io.path).substr(0, root_end);
  EntryAccess access{entry.parameters.size(), {}, function.return_type};
  const bool is_input =
      std::ranges::find(program.inputs, io.var, &ir::IoVar::var) != program.inputs.end();
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    const ir::Var& parameter = program.vars[function.parameters[i]];
    const bool fits = is_input ? entry.parameters[i].is_in : entry.parameters[i].is_out;
    if (parameter.name == root && fits) access = {i, {}, parameter.type};
  }
  // The path has all elements at its end, also those of arrays of structs in the middle.
  const std::size_t elements_at = std::min(io.path.find('['), io.path.size());
  std::string_view fields = std::string_view(io.path).substr(root_end, elements_at - root_end);
  std::string_view elements = std::string_view(io.path).substr(elements_at);
  for (;;) {
    const ir::Type& type = program.types[access.type];
    std::string_view& rest = type.kind == ir::TypeKind::kArray ? elements : fields;
    if (rest.empty() || type.IsNumeric()) return access;
    const std::size_t end = std::min(rest.find_first_of(".[", 1), rest.size());
    const std::string_view step = rest.substr(0, end);
    rest.remove_prefix(end);
    access.path += step;
    if (type.kind != ir::TypeKind::kStruct) {
      access.type = type.element;
      continue;
    }
    const auto& list = program.types[type.structure].fields;
    const auto field = std::ranges::find(list, step.substr(1), &ir::Field::name);
    CLIPC_CHECK(field != list.end());
    access.type = field->type;
  }
}

bool MayHaveClipPlanes(const ast::File& file, const std::string& entry) {
  const std::string_view name = std::string_view(entry).substr(entry.rfind(':') + 1);
  bool is_known = false, is_anywhere = false, is_here = false;
  for (const ast::DeclId id : file.decls.ids()) {
    const auto* function = std::get_if<ast::FunctionDecl>(&file.decls[id].node);
    if (!function) continue;
    const bool is_named = file.names[function->name] == name;
    is_known |= is_named;
    for (const ast::Attr& attr : file.attrs[function->attributes]) {
      const AttributeMeaning meaning = MeaningOfAttribute(file.names[attr.name]);
      const bool is_planes =
          meaning == AttributeMeaning::kClipPlanes || meaning == AttributeMeaning::kLikeClipPlanes;
      is_anywhere |= is_planes;
      is_here |= is_planes && is_named;
    }
  }
  return is_here || (is_anywhere && !is_known);
}

}  // namespace clipc
