// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/message.h"

#include <cctype>
#include <cstddef>
#include <iterator>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/path.h"
#include "clip-table/vocabulary.h"
#include "compiler/compile/explain.h"

namespace clipc {
namespace {

using Json = nlohmann::ordered_json;

// The user's text may be any bytes; a JSON document is UTF-8.
std::string Dump(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

const char* NameOf(Severity severity) {
  static constexpr Named<Severity> kNames[] = {
      {Severity::kNote, "note"}, {Severity::kWarning, "warning"}, {Severity::kError, "error"}};
  return NameIn<kNames>(severity);
}

void AppendMsvcLine(const Message& message, std::string& out) {
  const Place& place = message.place;
  auto end = std::back_inserter(out);
  if (place.file.empty()) {
    fmt::format_to(end, "clipc");
  } else if (place.end_line == place.line && place.end_column > place.column + 1) {
    fmt::format_to(end, "{}({},{}-{})", place.file, place.line, place.column, place.end_column - 1);
  } else {
    fmt::format_to(end, "{}({},{})", place.file, place.line, place.column);
  }
  // Programs that read build logs look for a severity and a code before the text.
  if (message.severity == Severity::kNote) {
    fmt::format_to(end, ": note: {}\n", message.text);
  } else if (message.code.empty()) {
    fmt::format_to(end, ": {} {}: {}\n", NameOf(message.severity), message.name, message.text);
  } else {
    fmt::format_to(end, ": {} {}: {} [{}]\n", NameOf(message.severity), message.code, message.text,
                   message.name);
  }
  for (const Message& note : message.notes) AppendMsvcLine(note, out);
}

void AddPlace(const Place& place, Json& to) {
  if (place.file.empty()) return;
  to["file"] = place.file;
  to["line"] = place.line;
  to["column"] = place.column;
  to["endLine"] = place.end_line;
  to["endColumn"] = place.end_column;
}

Json ToJson(const Message& message) {
  Json json = {{"severity", NameOf(message.severity)}, {"name", message.name}};
  if (!message.code.empty()) json["code"] = message.code;
  json["message"] = message.text;
  AddPlace(message.place, json);
  for (const Message::Fix& fix : message.fixes) {
    Json entry;
    AddPlace(fix.place, entry);
    entry["text"] = fix.text;
    json["fixes"].push_back(std::move(entry));
  }
  for (const Message& note : message.notes) json["notes"].push_back(ToJson(note));
  return json;
}

// A file's path as a URI reference.
std::string Uri(std::string_view path) {
  std::string uri = HasDrive(path) ? "file:///" : path.starts_with('/') ? "file://" : "";
  for (std::size_t i = 0; i < path.size(); ++i) {
    const char c = kHasDrives && path[i] == '\\' ? '/' : path[i];
    const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) ||
                          std::string_view("/._-~+,@").find(c) != std::string_view::npos ||
                          (i == 1 && HasDrive(path));
    uri += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri;
}

Json SarifRegion(const Place& place) {
  return {{"startLine", place.line},
          {"startColumn", std::max(place.character, 1U)},
          {"endLine", place.end_line},
          {"endColumn", std::max(place.end_character, 1U)}};
}

Json SarifLocation(const Place& place) {
  return {{"physicalLocation",
           {{"artifactLocation", {{"uri", Uri(place.file)}}}, {"region", SarifRegion(place)}}}};
}

Json SarifFix(const Message::Fix& fix) {
  const Json replacement = {{"deletedRegion", SarifRegion(fix.place)},
                            {"insertedContent", {{"text", fix.text}}}};
  const Json change = {{"artifactLocation", {{"uri", Uri(fix.place.file)}}},
                       {"replacements", Json::array({replacement})}};
  return {{"artifactChanges", Json::array({change})}};
}

Json SarifResult(const Message& message, std::size_t rule) {
  Json result = {{"ruleId", message.name},
                 {"ruleIndex", rule},
                 {"level", NameOf(message.severity)},
                 {"message", {{"text", message.text}}}};
  result["locations"] = Json::array();
  if (!message.place.file.empty()) result["locations"].push_back(SarifLocation(message.place));
  for (const Message& note : message.notes) {
    if (note.place.file.empty()) continue;
    Json location = SarifLocation(note.place);
    location["message"] = {{"text", note.text}};
    result["relatedLocations"].push_back(std::move(location));
  }
  for (const Message::Fix& fix : message.fixes) result["fixes"].push_back(SarifFix(fix));
  return result;
}

}  // namespace

Message UsageMessage(std::string_view what) {
  Message message;
  message.name = "command-line";
  message.text = what;
  return message;
}

Message ToMessage(const Diagnostic& diagnostic, const Source& source) {
  Message message;
  message.severity = diagnostic.severity;
  message.name = PrintedName(diagnostic.id);
  message.code = std::string(InfoOf(diagnostic.id).fxc_code);
  message.text = diagnostic.message;
  message.place = source.Resolve(diagnostic.span);
  for (const FixIt& fix : diagnostic.fix_its) {
    Place place = source.Resolve(fix.span);
    if (fix.insert) {
      place.end_line = place.line;
      place.end_column = place.column;
      place.end_character = place.character;
    }
    message.fixes.push_back({std::move(place), fix.text});
  }
  for (const Diagnostic& note : diagnostic.notes) message.notes.push_back(ToMessage(note, source));
  return message;
}

std::string RenderMsvc(const std::vector<Message>& messages) {
  std::string out;
  for (const Message& message : messages) AppendMsvcLine(message, out);
  return out;
}

std::string RenderJson(const std::vector<Message>& messages) {
  Json list = Json::array();
  for (const Message& message : messages) list.push_back(ToJson(message));
  return Dump({{"version", 1}, {"diagnostics", std::move(list)}});
}

std::string RenderSarif(const std::vector<Message>& messages) {
  Json rules = Json::array(), results = Json::array();
  std::map<std::string, std::size_t> rule_of;
  for (const Message& message : messages) {
    const auto [rule, is_new] = rule_of.emplace(message.name, rules.size());
    if (is_new) {
      Json entry = {{"id", message.name}};
      if (!message.code.empty()) entry["shortDescription"] = {{"text", "fxc " + message.code}};
      if (std::string help = Explain(message.name); !help.empty())
        entry["help"] = {{"text", std::move(help)}};
      rules.push_back(std::move(entry));
    }
    results.push_back(SarifResult(message, rule->second));
  }
  const Json driver = {{"name", "clipc"}, {"version", CLIPC_VERSION}, {"rules", std::move(rules)}};
  const Json run = {{"tool", {{"driver", driver}}},
                    {"columnKind", "unicodeCodePoints"},
                    {"results", std::move(results)}};
  return Dump({{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
               {"version", "2.1.0"},
               {"runs", Json::array({run})}});
}

}  // namespace clipc
