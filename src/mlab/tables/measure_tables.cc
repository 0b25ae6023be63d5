#include "mlab/tables/measure_tables.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "mlab/lang/odl/token.h"
#include "mlab/overlay/measure_kinds.h"

namespace mlab::tables {
namespace {

using overlay::kMeasures;
using overlay::MeasureInfo;

constexpr std::size_t kManyDrawn = 10'000;  // a number of points that nobody reaches

std::string upper(std::string_view word) {
  std::string out(word);
  std::ranges::transform(out, out.begin(),
                         [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
  return out;
}

std::string first_small(std::string_view words) {
  std::string out(words);
  if (!out.empty() && out[0] >= 'A' && out[0] <= 'Z') out[0] = static_cast<char>(out[0] + 32);
  return out;
}

// Measures whose statements are alike stand together.
std::string arguments(const MeasureInfo& one) {
  if (one.shape == overlay::MeasureShape::kHallway)
    return R"(name "CENTERLINE" pts "WIDTH" NUMBER "EXTENTS" pts)";
  std::string out = "name";
  const bool is_any_number = one.max_points == overlay::kAnyNumber;
  for (std::size_t i = 0; i < (is_any_number ? one.min_points - 1 : one.max_points); ++i) out += " pt";
  if (is_any_number) out += " pts";
  if (one.size != overlay::MeasureSize::kNone) out += " [ NUMBER ]";
  return out;
}

std::vector<std::string> keywords_of_measures() {
  std::vector<std::string> out;
  for (const MeasureInfo& one : kMeasures) {
    out.emplace_back(one.keyword);
    if (!one.also.empty()) out.emplace_back(one.also);
  }
  return out;
}

std::vector<std::string> keywords_of_features() {
  std::vector<std::string> out = keywords_of_measures();
  for (const odl::Word& one : odl::words()) {
    const bool is_thing = odl::is_feature(one.keyword) && !odl::measure_of(one.keyword);
    if (is_thing && one.keyword != odl::Keyword::kWaypointFile) out.emplace_back(one.spelling);
  }
  return out;
}

std::string number_of(const MeasureInfo& one) {
  if (one.size == overlay::MeasureSize::kNone) return "none";
  if (one.shape == overlay::MeasureShape::kHallway)
    return fmt::format("`{}`, above 0", upper(name(one.size)));
  return fmt::format("{} ({:g})", name(one.size), one.default_size);
}

std::string points_of(const MeasureInfo& one) {
  if (one.max_points == 1) return "1";
  return one.max_points == overlay::kAnyNumber ? fmt::format("{} or more", one.min_points)
                                               : fmt::format("{}", one.max_points);
}

}  // namespace

std::string measure_enum() {
  std::vector<const MeasureInfo*> in_order;
  for (const MeasureInfo& one : kMeasures) in_order.push_back(&one);
  std::ranges::sort(in_order, {}, &MeasureInfo::kind);
  std::string out;
  for (const MeasureInfo* one : in_order)
    out += fmt::format("    {} = {};\n", upper(one->id), static_cast<int>(one->kind));
  return out;
}

std::string measure_rows() {
  std::string out;
  for (const MeasureInfo& one : kMeasures) {
    out += "  {\n";
    const auto text = [&](std::string_view key, std::string_view value) {
      out += fmt::format("    {}: \"{}\",\n", key, value);
    };
    const auto number = [&](std::string_view key, auto value) {
      out += fmt::format("    {}: {},\n", key, value);
    };
    text("kind", one.id);
    number("wire", static_cast<int>(one.kind));
    text("keyword", one.keyword);
    text("label", one.label);
    text("purpose", one.purpose);
    text("group", name(one.group));
    text("shape", name(one.shape));
    number("minPoints", one.min_drawn);
    number("maxPoints", std::min(one.max_drawn, kManyDrawn));
    text("sizeLabel", name(one.size));
    number("defaultSize", one.default_size);
    number("isLine", one.is_line);
    text("sign", name(one.sign));
    text("color", one.color);
    text("icon", one.icon);
    number("isHatched", one.is_hatched);
    text("said", one.said);
    text("code", one.code);
    number("layer", one.layer);
    number("weight", one.weight);
    out += "  },\n";
  }
  return out;
}

std::string measure_documentation() {
  std::string out =
      "| feature | is | points | number (default) | FOLLOW takes it | what it is for "
      "|\n|---|---|---|---|---|---|\n";
  for (const MeasureInfo& one : kMeasures) {
    out += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", one.keyword, first_small(one.label),
                       points_of(one), number_of(one), one.is_line ? "yes" : "", first_small(one.purpose));
  }
  return out;
}

std::string measure_grammar() {
  std::vector<std::pair<std::string, std::vector<std::string>>> groups;
  for (const MeasureInfo& one : kMeasures) {
    const std::string form = arguments(one);
    auto group = std::ranges::find(groups, form, [](const auto& each) { return each.first; });
    if (group == groups.end()) group = groups.insert(groups.end(), {form, {}});
    group->second.push_back(fmt::format("\"{}\"", one.keyword));
  }
  std::string out = "```ebnf\n";
  for (const auto& [form, words] : groups) {
    const std::string choice = fmt::format("{}", fmt::join(words, " | "));
    out += fmt::format("{} {} {}\n", out.ends_with("ebnf\n") ? "measure   =" : "          |",
                       words.size() > 1 ? "( " + choice + " )" : choice, form);
  }
  out.pop_back();
  return out + " ;\n```\n";
}

std::string odl_named_words() {
  return fmt::format("{}", fmt::join(keywords_of_measures(), "|"));
}

std::string odl_feature_words() {
  return fmt::format("{}", fmt::join(keywords_of_features(), "|"));
}

std::string odl_feature_string() {
  return fmt::format("  \"{}\",\n", fmt::join(keywords_of_features(), " "));
}

std::string odl_dictionary() {
  std::string out;
  for (const odl::Word& one : odl::words()) {
    out += fmt::format("\"{}\"\n", one.spelling);
    if (!one.also.empty()) out += fmt::format("\"{}\"\n", one.also);
  }
  return out;
}

}  // namespace mlab::tables
