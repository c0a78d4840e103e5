// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <charconv>
#include <string_view>

#include <clang/Basic/Version.inc>
#include <fmt/format.h>
#include <llvm/ADT/ArrayRef.h>
#include <llvm/Option/Arg.h>
#include <llvm/Option/ArgList.h>
#include <llvm/Option/OptTable.h>
#include <llvm/Option/Option.h>
#include <llvm/Support/raw_ostream.h>
#include <sys/stat.h>

#include "base/spelling.h"
#include "compiler/options.h"
#include "compiler/suggest.h"

namespace clipc {
namespace {

using llvm::opt::Option;
using llvm::opt::OptTable;

enum Opt : unsigned short {
  kOptNone,
  kOptInput,
  kOptUnknown,
#define OPTION(Enumerator, ...) kOpt##Enumerator,
#include "compiler/options.def"
#undef OPTION
};

// ---- LLVM's table, whose shape changed with 20

#if CLANG_VERSION_MAJOR >= 20
// Every string of the table behind one another, as llvm::StringTable wants them: first "", then the
// dashes.
constexpr char kStrings[] = "\0-\0--\0"
#define OPTION(Enumerator, Dashes, Name, ...) Name "\0"
#include "compiler/options.def"
#undef OPTION
    ;
constexpr llvm::StringTable kStringTable(kStrings);
// A list of prefixes is its length and its strings: none, "-", "--".
constexpr llvm::StringTable::Offset kPrefixes[] = {0, 1, 1, 1, 3};
[[maybe_unused]] constexpr unsigned kPrefixNone = 0;
constexpr unsigned kPrefixOne = 1, kPrefixTwo = 3;
#else
constexpr llvm::StringLiteral kDash[] = {"-"};
constexpr llvm::StringLiteral kDashes[] = {"--"};
[[maybe_unused]] constexpr llvm::ArrayRef<llvm::StringLiteral> kPrefixNone;
constexpr llvm::ArrayRef<llvm::StringLiteral> kPrefixOne(kDash), kPrefixTwo(kDashes);
#endif

OptTable::Info Row(unsigned id, unsigned char kind, unsigned short alias, const char* metavar,
                   const char* help) {
#if CLANG_VERSION_MAJOR >= 20
  OptTable::Info info{};
#else
  OptTable::Info info{{}, "", nullptr, {}, nullptr, 0, 0, 0, 0, 0, 0, 0, nullptr, nullptr};
#endif
  info.HelpText = help;
  info.MetaVar = metavar;
  info.ID = id;
  info.Kind = kind;
  info.Visibility = llvm::opt::DefaultVis;
  info.AliasID = alias;
  return info;
}

std::vector<OptTable::Info> Rows() {
  std::vector<OptTable::Info> rows = {Row(kOptInput, Option::InputClass, 0, nullptr, nullptr),
                                      Row(kOptUnknown, Option::UnknownClass, 0, nullptr, nullptr)};
#if CLANG_VERSION_MAJOR >= 20
  unsigned name = sizeof("\0-\0--\0") - 1;
#define SET_NAME(Dashes, Name)                  \
  rows.back().PrefixesOffset = kPrefix##Dashes; \
  rows.back().PrefixedNameOffset = name;        \
  name += sizeof(Name);
#else
  rows[0].PrefixedName = "<input>";
  rows[1].PrefixedName = "<unknown>";
#define SET_NAME(Dashes, Name)            \
  rows.back().Prefixes = kPrefix##Dashes; \
  rows.back().PrefixedName = Name;
#endif
#define OPTION(Enumerator, Dashes, Name, Kind, Alias, Metavar, Help)                      \
  rows.push_back(Row(kOpt##Enumerator, Option::Kind##Class, kOpt##Alias, Metavar, Help)); \
  SET_NAME(Dashes, Name)
#include "compiler/options.def"
#undef OPTION
#undef SET_NAME
  return rows;
}

class Table : public llvm::opt::GenericOptTable {
 public:
#if CLANG_VERSION_MAJOR >= 20
  explicit Table(const std::vector<OptTable::Info>& rows)
      : GenericOptTable(kStringTable, kPrefixes, rows) {}
#else
  explicit Table(const std::vector<OptTable::Info>& rows) : GenericOptTable(rows) {}
#endif
};

// ---- arguments

// Whether an argument that starts with a slash is a path: it exists, or something could be made
// there.
bool LooksLikePath(const std::string& argument) {
  struct stat status{};
  if (stat(argument.c_str(), &status) == 0) return true;
  const std::size_t slash = argument.rfind('/');
  return slash > 0 && stat(argument.substr(0, slash).c_str(), &status) == 0 &&
         S_ISDIR(status.st_mode);
}

// "did you mean" for an option that is none.
std::string NearOption(const Table& table, llvm::StringRef argument) {
  std::string nearest;
  const unsigned distance = table.findNearest(argument, nearest, llvm::opt::Visibility(), 2);
  return distance <= 1 + argument.size() / 4 ? fmt::format("; did you mean `{}`?", nearest)
                                             : std::string();
}

// One of a few words, which stand in the order of the enumerators; reports what it may be.
template <typename Enum, std::size_t kCount>
bool ReadChoice(std::string_view option, std::string_view value, const char* const (&names)[kCount],
                Enum& to, std::string& error) {
  if (const auto choice = EnumeratorOf<Enum>(value, names)) {
    to = *choice;
    return true;
  }
  const std::vector<std::string_view> views(std::begin(names), std::end(names));
  error = fmt::format("unknown value `{}` of {}{}", value, option, Suggest(value, views));
  return false;
}

constexpr const char* kDepthRanges[] = {"zero-to-one", "negative-one-to-one"};
constexpr const char* kFormats[] = {"text", "msvc", "json", "sarif"};
constexpr const char* kStages[] = {"tokens", "ast", "ir", "glsl", "table"};

// -Wno-clip-plane-twice, -Werror, -Werror=..., -Wno-error=...
bool ReadWarning(std::string_view name, WarningOptions& warnings, std::string& error) {
  if (name == "error") return warnings.warnings_are_errors = true;
  if (name == "no-error") return !(warnings.warnings_are_errors = false);
  if (name == "all" || name == "extra") return true;  // every warning is on anyway
  const auto take = [&](std::string_view prefix) {
    const bool has = name.starts_with(prefix);
    if (has) name.remove_prefix(prefix.size());
    return has;
  };
  const bool is_off = take("no-");
  const bool is_error = take("error=");
  const std::optional<DiagId> id = DiagIdOf(name);
  if (!id || InfoOf(*id).severity != Severity::kWarning) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < kDiagCount; ++i) {
      const auto other = static_cast<DiagId>(i);
      if (InfoOf(other).severity == Severity::kWarning) names.push_back(PrintedName(other));
    }
    const std::vector<std::string_view> views(names.begin(), names.end());
    error = fmt::format("unknown warning `{}`{}", name,
                        NearNames(name, views).empty() ? "" : Suggest(name, views));
    return false;
  }
  const auto index = static_cast<std::size_t>(*id);
  if (is_error) {
    warnings.as_error[index] = !is_off;
  } else {
    warnings.off[index] = is_off;
  }
  return true;
}

// A number from `least` to `most`.
template <typename T>
bool ReadNumber(std::string_view option, const std::string& value, T least, T most, T& to,
                std::string& error) {
  const auto [end, problem] = std::from_chars(value.data(), value.data() + value.size(), to);
  const bool is_number = problem == std::errc() && end == value.data() + value.size();
  if (is_number && to >= least && to <= most) return true;
  error = fmt::format("`{}{}`: it must be a number from {} to {}", option, value, least, most);
  return false;
}

// The options that say what to compile, and how.
bool ReadRequestOption(const llvm::opt::Arg& argument, CompileRequest& request,
                       std::string& error) {
  const auto value = [&] { return std::string(argument.getValue()); };
  switch (argument.getOption().getID()) {
    case kOptDefine: request.defines.push_back(value()); return true;
    case kOptInclude: request.include_dirs.push_back(value()); return true;
    case kOptProfile: request.profile = value(); return true;
    case kOptEntry: request.entry = value(); return true;
    case kOptTargetIs: request.target = value(); return true;
    case kOptPackRows: request.packing = MatrixPacking::kRowMajor; return true;
    case kOptPackColumns: request.packing = MatrixPacking::kColumnMajor; return true;
    case kOptFlipY: request.clip_space.flip_y = true; return true;
    case kOptSeparable: request.separable = true; return true;
    case kOptVariants: request.variants = true; return true;
    case kOptVariantsUpTo:
      request.variants = true;
      return ReadNumber<std::size_t>("--variants=", value(), 0, kMaxClipPlanes,
                                     request.variant_planes, error);
    case kOptVerify: request.debug.verify = true; return true;
    case kOptDumpAfterIs: request.debug.dump_after.push_back(value()); return true;
    case kOptStopAfterIs: request.debug.stop_after = value(); return true;
    case kOptNoWarnings: request.warnings.no_warnings = true; return true;
    case kOptWarningsAreErrors: request.warnings.warnings_are_errors = true; return true;
    case kOptWarning: return ReadWarning(value(), request.warnings, error);
    case kOptLowerIs:
      return ReadChoice("--lower", value(), kLoweringNames, request.lowering.emplace(), error);
    case kOptPlaneSpaceIs:
      return ReadChoice("--plane-space", value(), kPlaneSpaceNames, request.plane_space, error);
    case kOptPositionInputIs: request.position_input = value(); return true;
    case kOptDumpIs:
      return ReadChoice("--dump", value(), kStages, request.debug.dump.emplace(), error);
    case kOptDepthRangeIs:
      return ReadChoice("--depth-range", value(), kDepthRanges,
                        request.clip_space.negative_one_to_one, error);
    default: return true;
  }
}

// The others, which say what to do with the result. `validate` is what the user asked for.
bool ReadDriverOption(const llvm::opt::Arg& argument, CommandLine& command,
                      std::optional<bool>& validate, std::string& error) {
  const auto value = [&] { return std::string(argument.getValue()); };
  switch (argument.getOption().getID()) {
    case kOptInput: command.inputs.push_back(value()); return true;
    case kOptOutput: command.output = value(); return true;
    case kOptTableIs: command.table = value(); return true;
    case kOptReflectIs: command.reflection = value(); return true;
    case kOptFragmentIs: command.fragment = value(); return true;
    case kOptDependencyFile: command.dependency_file = value(); [[fallthrough]];
    case kOptDependencies: command.write_dependencies = true; return true;
    case kOptDependencyTarget: command.dependency_target = value(); return true;
    case kOptJobs: return ReadNumber("-j", value(), 1u, 256u, command.jobs, error);
    case kOptHelp: command.action = CommandLine::Action::kHelp; return true;
    case kOptVersion: command.action = CommandLine::Action::kVersion; return true;
    case kOptValidate: validate = true; return true;
    case kOptNoValidate: validate = false; return true;
    case kOptDiagnosticsAre:
      return ReadChoice("--diagnostics", value(), kFormats, command.format, error);
    default: return true;
  }
}

}  // namespace

ParsedCommandLine ParseCommandLine(std::span<const char* const> arguments) {
  const std::vector<OptTable::Info> rows = Rows();
  const Table table(rows);
  llvm::opt::InputArgList list(arguments.data(), arguments.data() + arguments.size());
  ParsedCommandLine parsed;
  std::optional<bool> validate;
  for (unsigned index = 0; index < arguments.size();) {
    const std::string text = list.getArgString(index);
    const unsigned at = index;
    if (text.size() > 1 && text[0] == '/' && !LooksLikePath(text)) {
      list.replaceArgString(index, "-" + text.substr(1));
      std::unique_ptr<llvm::opt::Arg> trial = table.ParseOneArg(list, index);
      const bool is_option = trial && !trial->getOption().matches(kOptUnknown);
      index = at;
      if (!is_option) list.replaceArgString(index, text);
    }
    const std::unique_ptr<llvm::opt::Arg> argument = table.ParseOneArg(list, index);
    if (!argument) {
      parsed.error = fmt::format("{} needs a value", text);
      return parsed;
    }
    if (argument->getOption().matches(kOptUnknown)) {
      parsed.error = fmt::format("unknown option `{}`{}", text, NearOption(table, text));
      return parsed;
    }
    if (!ReadRequestOption(*argument, parsed.command.request, parsed.error) ||
        !ReadDriverOption(*argument, parsed.command, validate, parsed.error)) {
      return parsed;
    }
  }
  // glslang's tables cost tens of milliseconds once: much for one shader, little for many.
  parsed.command.request.validate = validate.value_or(parsed.command.inputs.size() > 1);
  return parsed;
}

std::string HelpText() {
  const std::vector<OptTable::Info> rows = Rows();
  const Table table(rows);
  std::string text;
  llvm::raw_string_ostream out(text);
  table.printHelp(out, "clipc [options] FILE...",
                  "HLSL vertex shaders with [clipplanes] to GLSL and a Direct3D 9 clip table");
  out.flush();
  return text;
}

}  // namespace clipc
