#include "mlab/flow/port_types.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/base/counted.h"
#include "mlab/base/table.h"
#include "mlab/flow/library.h"
#include "mlab/percept/formation_names.h"
#include "mlab/percept/object_classes.h"

namespace mlab::flow {
namespace {

using percept::Formation;
using percept::FormationReference;
using percept::kObjectClasses;
using percept::ObjectClass;
using percept::ObjectReading;
using percept::Task;

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t' || text.front() == '\n'))
    text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\n'))
    text.remove_suffix(1);
  return text;
}

// Numbers may stand in parentheses or braces of their own: `(.5)`, `{0.5}`.
std::string_view without_brackets(std::string_view text) {
  text = trimmed(text);
  while (text.size() >= 2 &&
         ((text.front() == '(' && text.back() == ')') || (text.front() == '{' && text.back() == '}'))) {
    text = trimmed(text.substr(1, text.size() - 2));
  }
  return text;
}

bool same_word(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  const auto fold = [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c == '_' ? '-' : c;
  };
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (fold(a[i]) != fold(b[i])) return false;
  }
  return true;
}

std::optional<double> number(std::string_view text) {
  text = without_brackets(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

// `{1, 2}` as numbers; empty where anything else stands there.
std::vector<double> numbers(std::string_view text) {
  std::vector<double> out;
  text = without_brackets(text);
  while (true) {
    const std::size_t comma = text.find(',');
    const std::optional<double> value = number(text.substr(0, comma));
    if (!value) return {};
    out.push_back(*value);
    if (comma == std::string_view::npos) return out;
    text.remove_prefix(comma + 1);
  }
}

template <class T>
const T& as(const void* value) {
  return *static_cast<const T*>(value);
}

bool parse_bool(std::string_view text, void* out) {
  text = without_brackets(text);
  for (const std::string_view yes : {"true", "yes", "on", "1"}) {
    if (same_word(text, yes)) return *static_cast<bool*>(out) = true, true;
  }
  for (const std::string_view no : {"false", "no", "off", "0"}) {
    if (same_word(text, no)) return *static_cast<bool*>(out) = false, true;
  }
  return false;
}

bool parse_int(std::string_view text, void* out) {
  const std::optional<double> value = number(text);
  if (!value || *value != std::floor(*value) || std::abs(*value) > 2147483647.0) return false;
  *static_cast<int*>(out) = static_cast<int>(*value);
  return true;
}

bool parse_double(std::string_view text, void* out) {
  const std::optional<double> value = number(text);
  if (value) *static_cast<double*>(out) = *value;
  return value.has_value();
}

bool parse_vector(std::string_view text, void* out) {
  const std::vector<double> v = numbers(text);
  if (v.size() != 2 && v.size() != 3) return false;
  *static_cast<geom::Vector*>(out) = {v[0], v[1], v.size() == 3 ? v[2] : 0.0};
  return true;
}

bool parse_point(std::string_view text, void* out) {
  const std::vector<double> v = numbers(text);
  if (v.size() != 2 && !(v.size() == 3 && v[2] == 0.0)) return false;
  *static_cast<geom::Point*>(out) = {v[0], v[1]};
  return true;
}

bool parse_text(std::string_view text, void* out) {
  return static_cast<Text*>(out)->assign(text);
}

// The words of values in the order of their numbers.
constexpr std::array<std::string_view, 2> kTruths = {"false", "true"};
constexpr std::array<std::string_view, 3> kReferences = {"unit-center", "leader", "neighbor"};
static_assert(!base::is_enumerator<static_cast<FormationReference>(kReferences.size())>());
constexpr std::array<std::string_view, 11> kTasks = {"none",    "start",  "moveto", "teleoperate",
                                                     "sweepto", "follow", "occupy", "stop",
                                                     "visit",   "search", "patrol"};
static_assert(!base::is_enumerator<static_cast<Task>(kTasks.size())>());

template <const auto& kRows>
consteval auto names_of() {
  std::array<std::string_view, std::size(kRows)> out;
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = kRows[i].name;
  return out;
}
constexpr auto kClassNames = names_of<kObjectClasses>();
constexpr auto kFormationNames = names_of<percept::kFormations>();

// Other words for a class than its name and its colour: what historic configurations call it.
constexpr struct {
  std::string_view word;
  ObjectClass object_class;
} kOtherClassWords[] = {{"Mines", ObjectClass::kMine},
                        {"Biohazard", ObjectClass::kMine},
                        {"Victim", ObjectClass::kMine},
                        {"Attractor", ObjectClass::kMine},
                        {"Enemy", ObjectClass::kEnemyRobot},
                        {"Enemies", ObjectClass::kEnemyRobot},
                        {"Enemy_Robot", ObjectClass::kEnemyRobot},
                        {"Enemy_Robots", ObjectClass::kEnemyRobot},
                        {"Flags", ObjectClass::kFlag},
                        {"EOD_Area", ObjectClass::kBasket},
                        {"EOD_Areas", ObjectClass::kBasket},
                        {"Baskets", ObjectClass::kBasket},
                        {"Rocks", ObjectClass::kRock},
                        {"Trees", ObjectClass::kTree},
                        {"Home_Base", ObjectClass::kHomeBase},
                        {"Possible_Biohazard", ObjectClass::kUnknown},
                        {"Unknowns", ObjectClass::kUnknown},
                        {"Hiding_Place", ObjectClass::kHidingPlace},
                        {"Hiding_Places", ObjectClass::kHidingPlace},
                        {"Radioactive", ObjectClass::kHidingPlace},
                        {"Yellow_Marker", ObjectClass::kYellowMarker},
                        {"Friendly_Robot", ObjectClass::kFriendlyRobot},
                        {"Friendly_Robots", ObjectClass::kFriendlyRobot}};

// The bit of a class; none for a word that is none.
std::optional<std::size_t> class_index(std::string_view word) {
  for (std::size_t i = 0; i < kObjectClasses.size(); ++i) {
    if (same_word(kObjectClasses[i].name, word) || same_word(kObjectClasses[i].color_word, word)) return i;
  }
  for (const auto& other : kOtherClassWords) {
    if (same_word(other.word, word)) return static_cast<std::size_t>(other.object_class);
  }
  return std::nullopt;
}

std::optional<std::size_t> word_index(std::span<const std::string_view> words, std::string_view text) {
  text = without_brackets(text);
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (same_word(words[i], text)) return i;
  }
  const std::optional<double> value = number(text);
  if (value && *value >= 0 && *value < static_cast<double>(words.size()) && *value == std::floor(*value)) {
    return static_cast<std::size_t>(*value);
  }
  return std::nullopt;
}

template <class T, const auto& kWords>
bool parse_choice(std::string_view text, void* out) {
  const std::optional<std::size_t> i = word_index(kWords, text);
  if (i) *static_cast<T*>(out) = static_cast<T>(*i);
  return i.has_value();
}

template <class T, const auto& kWords>
std::string print_choice(const void* value) {
  const auto i = static_cast<std::size_t>(as<T>(value));
  return i < std::size(kWords) ? std::string(kWords[i]) : fmt::format("{}", i);
}

bool parse_formation(std::string_view text, void* out) {
  const std::optional<Formation> formation = percept::formation_named(without_brackets(text));
  if (formation) *static_cast<Formation*>(out) = *formation;
  return formation.has_value();
}

// `Flag|Basket`, `AnyObject`, or the mask as a number.
bool parse_classes(std::string_view text, void* out) {
  text = without_brackets(text);
  ObjectClasses mask;
  if (same_word(text, "AnyObject")) {
    mask.bits = (1U << kObjectClasses.size()) - 1U;
  } else if (const std::optional<double> value = number(text)) {
    if (*value < -1.0 || *value > 4294967295.0 || *value != std::floor(*value)) return false;
    mask.bits = *value < 0 ? (1U << kObjectClasses.size()) - 1U : static_cast<std::uint32_t>(*value);
  } else {
    while (true) {
      const std::size_t bar = text.find('|');
      const std::string_view word = trimmed(text.substr(0, bar));
      const std::optional<std::size_t> index = class_index(word);
      if (!index) return false;
      mask.bits |= 1U << *index;
      if (bar == std::string_view::npos) break;
      text.remove_prefix(bar + 1);
    }
  }
  *static_cast<ObjectClasses*>(out) = mask;
  return true;
}

std::string print_classes(const void* value) {
  std::string out;
  for (std::size_t i = 0; i < kObjectClasses.size(); ++i) {
    if ((as<ObjectClasses>(value).bits >> i & 1U) != 0)
      out += (out.empty() ? "" : "|") + std::string(kObjectClasses[i].name);
  }
  return out.empty() ? "0" : out;
}

// How values of a type are read and shown.
struct Form {
  bool (*parse)(std::string_view text, void* out) = nullptr;
  std::string (*print)(const void* value) = nullptr;
  bool (*is_finite)(const void* value) = nullptr;
  std::span<const std::string_view> words = {};
};

template <class T>
struct Of {};

constexpr Form form(Of<bool> /*type*/) {
  return {.parse = parse_bool,
          .print = [](const void* v) { return std::string(kTruths[as<std::uint8_t>(v) != 0 ? 1 : 0]); },
          .words = kTruths};
}
constexpr Form form(Of<int> /*type*/) {
  return {.parse = parse_int, .print = [](const void* v) { return fmt::format("{}", as<int>(v)); }};
}
constexpr Form form(Of<double> /*type*/) {
  return {parse_double, [](const void* v) { return fmt::format("{}", as<double>(v)); },
          [](const void* v) { return std::isfinite(as<double>(v)); }};
}
constexpr Form form(Of<geom::Vector> /*type*/) {
  return {parse_vector,
          [](const void* v) {
            const auto& a = as<geom::Vector>(v);
            return fmt::format("{{{}, {}, {}}}", a.x, a.y, a.z);
          },
          [](const void* v) {
            const auto& a = as<geom::Vector>(v);
            return std::isfinite(a.x + a.y + a.z);
          }};
}
constexpr Form form(Of<geom::Point> /*type*/) {
  return {parse_point,
          [](const void* v) { return fmt::format("{{{}, {}}}", as<geom::Point>(v).x, as<geom::Point>(v).y); },
          [](const void* v) { return std::isfinite(as<geom::Point>(v).x + as<geom::Point>(v).y); }};
}
constexpr Form form(Of<geom::Pose> /*type*/) {
  return {nullptr,
          [](const void* v) {
            const auto& p = as<geom::Pose>(v);
            return fmt::format("{{{}, {}, {} rad}}", p.position.x, p.position.y, p.heading);
          },
          [](const void* v) {
            const auto& p = as<geom::Pose>(v);
            return std::isfinite(p.position.x + p.position.y + p.heading);
          }};
}
template <class Reading>
constexpr Form form(Of<IndexList<Reading>> /*type*/) {
  return {.print = [](const void* v) { return base::counted(as<IndexList<Reading>>(v).count, "reading"); }};
}
constexpr Form form(Of<Ranges> /*type*/) {
  return {.print = [](const void* v) { return base::counted(as<Ranges>(v).count, "reading"); }};
}
constexpr Form form(Of<ObjectReading> /*type*/) {
  return {.print = [](const void* v) {
    const auto& o = as<ObjectReading>(v);
    return o.id.value == 0 ? std::string("none")
                           : fmt::format("object {} at {{{}, {}}}", o.id.value, o.center.x, o.center.y);
  }};
}
constexpr Form form(Of<ObjectClasses> /*type*/) {
  return {.parse = parse_classes, .print = print_classes, .words = kClassNames};
}
constexpr Form form(Of<Formation> /*type*/) {
  return {.parse = parse_formation,
          .print = [](const void* v) { return std::string(percept::name(as<Formation>(v))); },
          .words = kFormationNames};
}
constexpr Form form(Of<FormationReference> /*type*/) {
  return {.parse = parse_choice<FormationReference, kReferences>,
          .print = print_choice<FormationReference, kReferences>,
          .words = kReferences};
}
constexpr Form form(Of<Task> /*type*/) {
  return {.parse = parse_choice<Task, kTasks>, .print = print_choice<Task, kTasks>, .words = kTasks};
}
constexpr Form form(Of<ways::PlannedWay> /*type*/) {
  return {nullptr,
          [](const void* v) {
            const auto& way = as<ways::PlannedWay>(v);
            if (way.count == 0) return std::string("none");
            std::string out;
            for (const geom::Point corner : way.points())
              out += fmt::format("{}{{{}, {}}}", out.empty() ? "" : " ", corner.x, corner.y);
            constexpr std::array<std::string_view, 5> kEnds = {"", "", ", beside the goal",
                                                               ", no way leads farther", ", and farther"};
            const auto end = static_cast<std::size_t>(way.end);
            return out + std::string(end < kEnds.size() ? kEnds[end] : "");
          },
          [](const void* v) {
            return std::ranges::all_of(as<ways::PlannedWay>(v).points(),
                                       [](geom::Point corner) { return std::isfinite(corner.x + corner.y); });
          }};
}
constexpr Form form(Of<Text> /*type*/) {
  return {.parse = parse_text, .print = [](const void* v) { return std::string(as<Text>(v).view()); }};
}

template <class T>
constexpr TypeInfo info_of(const ValueTypeInfo& row) {
  const Form its = form(Of<T>{});
  return {row.name, row.kind, sizeof(T), alignof(T), its.parse, its.print, its.is_finite, its.words};
}

template <std::size_t... kNumbers>
constexpr std::array<TypeInfo, sizeof...(kNumbers)> infos(std::index_sequence<kNumbers...> /*numbers*/) {
  return {info_of<std::tuple_element_t<kNumbers, ValueTypes>>(info(static_cast<ValueType>(kNumbers)))...};
}

constexpr std::array kInfos = infos(std::make_index_sequence<kValueTypes.size()>());

}  // namespace

const TypeInfo& type_info(ValueType type) {
  return kInfos.at(static_cast<std::size_t>(type));
}

void add_port_types(Library& library) {
  for (const ValueTypeInfo& row : kValueTypes) {
    const TypeInfo& type = type_info(row.type);
    library.add_type(type);
    if (!row.historic.empty()) library.add_type(type, row.historic);
  }
}

}  // namespace mlab::flow
