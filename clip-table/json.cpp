// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "clip-table/json.h"

#include <limits>
#include <set>
#include <vector>

#include <nlohmann/json.hpp>

#include "clip-table/read.h"
#include "clip-table/write.h"

namespace clipc::clip_table {
namespace {

using Json = nlohmann::json;
using OrderedJson = nlohmann::ordered_json;  // as the schema lists the keys; linear look-up

constexpr std::string_view kSchema = "clipc.clip-table";
constexpr std::uint32_t kVersion = 1;

OrderedJson ToJson(const std::optional<Constant>& constant) {
  OrderedJson json;  // null
  if (constant)
    ForEachMember(*constant, [&](const char* key, const auto& value) { json[key] = value; });
  return json;
}

OrderedJson ToJson(const ClipTable& table) {
  OrderedJson planes = OrderedJson::array();
  for (const Plane& plane : table.planes) {
    planes.push_back(
        {{"index", plane.index}, {"text", plane.text}, {"constant", ToJson(plane.constant)}});
  }
  return OrderedJson{{"schema", kSchema},
                     {"version", kVersion},
                     {"entry", table.entry},
                     {"profile", table.profile},
                     {"lowering", NameOf(table.lowering)},
                     {"position_space", TableNameOf(table.plane_space)},
                     {"plane_scale", PlaneScaleOf(table.lowering)},
                     {"enable_mask", table.enable_mask},
                     {"planes", std::move(planes)}};
}

// Reads members of one JSON object; keeps the first mistake.
class ObjectReader {
 public:
  ObjectReader(const Json& json, std::string where, std::string& error)
      : json_(json), where_(std::move(where)), error_(error) {
    if (!json_.is_object()) Fail("", "is not an object");
  }

  void Read(const char* key, std::string& to) {
    const Json* value = Find(key);
    if (value && !value->is_string()) Fail(key, "is not a string");
    if (error_.empty()) to = value->get<std::string>();
  }

  void Read(const char* key, std::uint32_t& to) {
    const Json* value = Find(key);
    if (value && !(value->is_number_unsigned() &&
                   value->get<std::uint64_t>() <= std::numeric_limits<std::uint32_t>::max())) {
      Fail(key, "is not an integer from 0 to 4294967295");
    }
    if (error_.empty()) to = value->get<std::uint32_t>();
  }

  std::string Text(const char* key) {
    std::string text;
    Read(key, text);
    return text;
  }

  template <typename Enum>
  Enum Name(const char* key, std::optional<Enum> (*parse)(std::string_view)) {
    const std::string text = Text(key);
    const std::optional<Enum> value = parse(text);
    if (error_.empty() && !value) Fail(key, "is \"" + text + "\", which this clipc does not know");
    return value.value_or(Enum{});
  }

  const Json* Find(const char* key) {
    if (!error_.empty()) return nullptr;
    const auto found = json_.find(key);
    if (found == json_.end()) {
      Fail(key, "is missing");
      return nullptr;
    }
    ++known_;
    return &*found;
  }

  // Reports a key that is not known. Call it after every known key was read.
  void NothingElse() {
    if (error_.empty() && known_ != json_.size())
      Fail("", "has a key that this clipc does not know");
  }

  void Fail(const std::string& key, const std::string& what) {
    if (!error_.empty()) return;
    const std::string dot = where_.empty() || key.empty() ? "" : ".";
    const std::string path = where_ + dot + key;
    error_ = (path.empty() ? "the table" : "`" + path + "`") + " " + what;
  }

 private:
  const Json& json_;
  std::string where_;
  std::string& error_;
  std::size_t known_ = 0;
};

Constant ConstantFrom(const Json& json, const std::string& where, std::string& error) {
  ObjectReader object(json, where, error);
  Constant constant;
  ForEachMember(constant, [&](const char* key, auto& member) { object.Read(key, member); });
  object.NothingElse();
  return constant;
}

Plane PlaneFrom(const Json& json, const std::string& where, std::string& error) {
  ObjectReader object(json, where, error);
  Plane plane;
  object.Read("index", plane.index);
  object.Read("text", plane.text);
  if (const Json* constant = object.Find("constant"); constant && !constant->is_null()) {
    plane.constant = ConstantFrom(*constant, where + ".constant", error);
  }
  object.NothingElse();
  return plane;
}

void CheckVersion(ObjectReader& object) {
  const std::string schema = object.Text("schema");
  if (schema != kSchema) object.Fail("schema", "is \"" + schema + "\"; this is not a clip table");
  std::uint32_t version = 0;
  object.Read("version", version);
  if (version != kVersion) {
    object.Fail("version", "is " + std::to_string(version) + "; this clipc reads version " +
                               std::to_string(kVersion));
  }
}

ClipTable TableFrom(const Json& json, std::string& error) {
  ObjectReader object(json, "", error);
  CheckVersion(object);
  ClipTable table;
  object.Read("entry", table.entry);
  object.Read("profile", table.profile);
  table.lowering = object.Name("lowering", ParseLowering);
  table.plane_space = object.Name("position_space", ParseTableSpace);
  const std::string scale = object.Text("plane_scale");
  const std::string_view right = PlaneScaleOf(table.lowering);
  if (scale != right)
    object.Fail("plane_scale",
                "is \"" + scale + "\"; with this lowering it is \"" + std::string(right) + "\"");
  object.Read("enable_mask", table.enable_mask);
  const Json* planes = object.Find("planes");
  object.NothingElse();
  if (planes && !planes->is_array()) object.Fail("planes", "is not an array");
  for (std::size_t i = 0; error.empty() && i < planes->size(); ++i) {
    table.planes.push_back(PlaneFrom((*planes)[i], "planes[" + std::to_string(i) + "]", error));
  }
  return table;
}

// Parses JSON as nlohmann's parser does, which keeps the last of equal keys, and sets `repeats_key`
// if there are any, because such a table is damaged. Throws nlohmann's parse_error.
Json Parse(std::string_view text, bool& repeats_key) {
  std::vector<std::set<std::string>> open;
  const auto watch = [&](int, Json::parse_event_t event, Json& parsed) {
    if (event == Json::parse_event_t::object_start) open.emplace_back();
    if (event == Json::parse_event_t::object_end) open.pop_back();
    if (event == Json::parse_event_t::key) {
      repeats_key |= !open.back().insert(parsed.get<std::string>()).second;
    }
    return true;
  };
  return Json::parse(text, watch);
}

}  // namespace

std::string JsonText(const ClipTable& table, bool one_line) {
  const OrderedJson json = ToJson(table);
  const auto replace = OrderedJson::error_handler_t::replace;
  return one_line ? json.dump(-1, ' ', true, replace) : json.dump(2, ' ', true, replace) + "\n";
}

Result<std::string> WriteJson(const ClipTable& table) {
  if (std::string problem = ProblemOf(table); !problem.empty()) {
    return Problem{std::move(problem)};
  }
  return JsonText(table, false);
}

Result<ClipTable> ReadJson(std::string_view text) {
  Json json;
  bool repeats_key = false;
  try {
    json = Parse(text, repeats_key);
  } catch (const Json::parse_error& error) {
    if (text.empty()) return Problem{"there is no JSON: the text is empty"};
    if (error.byte > text.size())
      return Problem{"the JSON is cut off: it ends after " + std::to_string(text.size()) +
                     " bytes"};
    return Problem{"no JSON: byte " + std::to_string(error.byte) + " cannot stand there"};
  }
  std::string error;
  ClipTable table = TableFrom(json, error);
  if (error.empty()) error = ProblemOf(table);
  if (error.empty() && repeats_key) error = "a key occurs twice in one object";
  if (!error.empty()) return Problem{std::move(error)};
  return table;
}

}  // namespace clipc::clip_table
