#include <algorithm>
#include <string>
#include <string_view>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "mlab/base/counted.h"
#include "mlab/preflight/preflight.h"

namespace mlab::preflight {
namespace {

constexpr std::size_t kWidth = 79;
constexpr std::size_t kResultWidth = 10;  // of the column of results, with what stands before it
constexpr std::size_t kNameWidth = 19;    // of the column of names

std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

// Words of `text` behind `head`, broken at blanks; later lines begin below the first word.
void add_wrapped(std::string& out, std::string head, std::string_view text, std::size_t indent) {
  head.resize(std::max(head.size(), indent), ' ');
  std::size_t column = width_of(head);
  out += head;
  bool is_first = true;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!is_first && column + 1 + width_of(word) > kWidth) {
      out += '\n' + std::string(indent, ' ');
      column = indent;
    } else if (!is_first) {
      out += ' ';
      ++column;
    }
    out += word;
    column += width_of(word);
    is_first = false;
  }
  out += '\n';
}

void add_item(std::string& out, const Item& item) {
  const std::size_t indent = kResultWidth + kNameWidth;
  std::string head = fmt::format("  {:<8}{:<{}}", word_of(item.result), item.name, kNameWidth - 1);
  head += ' ';
  if (head.size() > indent) {
    out += head.substr(0, head.find_last_not_of(' ') + 1) + '\n';
    head.clear();
  }
  add_wrapped(out, head, item.is, indent);
  if (item.result == CheckResult::kPass || item.expected.empty()) return;
  add_wrapped(out, std::string(indent, ' ') + "expected: ", item.expected, indent);
}

std::string robots_of(const CheckedVehicle& vehicle) {
  return fmt::format("body of {} {}", vehicle.robots.size() == 1 ? "robot" : "robots",
                     fmt::join(vehicle.robots, ", "));
}

void add_items_of(std::string& out, const Checklist& checklist, const std::string& vehicle) {
  for (const Item& one : checklist.items) {
    if (one.vehicle == vehicle) add_item(out, one);
  }
}

}  // namespace

std::string_view word_of(CheckResult result) {
  constexpr std::string_view kWords[] = {"pass", "warn", "FAIL", "unknown"};
  return kWords[static_cast<std::size_t>(result)];
}

std::string text_of(const Checklist& checklist) {
  std::string out;
  add_wrapped(
      out, "",
      fmt::format("Pre-flight of the mission \"{}\" in the fleet `{}`", checklist.mission, checklist.fleet),
      0);
  out += "\nThe mission\n";
  add_items_of(out, checklist, "");
  for (const CheckedVehicle& one : checklist.vehicles) {
    out += fmt::format("\nThe vehicle {}, {}{}\n", one.name, robots_of(one),
                       one.is_simulated ? " (simulated)" : "");
    add_items_of(out, checklist, one.name);
  }
  const auto count = [&](CheckResult result) {
    return std::ranges::count(checklist.items, result, &Item::result);
  };
  out += fmt::format("\n{}: {} pass, {} warn, {} FAIL, {} unknown\n",
                     base::counted(checklist.items.size(), "item"), count(CheckResult::kPass),
                     count(CheckResult::kWarn), count(CheckResult::kFail), count(CheckResult::kUnknown));
  return out;
}

}  // namespace mlab::preflight
