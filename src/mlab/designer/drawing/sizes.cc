#include "mlab/designer/drawing/sizes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/core.h>

namespace mlab::designer {
namespace {

constexpr double kRowHeight = 24.0;
constexpr double kHeadHeight = 40.0;
constexpr double kSmallHeight = 32.0;
constexpr double kFoot = 6.0;
constexpr double kMinWidth = 148.0;
constexpr double kMaxWidth = 300.0;
constexpr double kSymbolWidth = 44.0;
constexpr double kIconWidth = 34.0;
constexpr double kMargin = 30.0;
constexpr double kEnterWidth = 18.0;  // the button that looks inside
constexpr double kStateHeight = 64.0;

/// What a shape has besides its texts.
struct ShapeLook {
  Node::Shape shape;
  bool is_box;
  bool has_symbol;
  bool can_be_small;  ///< without inputs
  const char* kind;
};
constexpr std::array<ShapeLook, 23> kLooks = {{
    {Node::BEHAVIOR, true, false, false, "motor schema"},
    {Node::PERCEPTION, true, false, false, "perception"},
    {Node::ASSEMBLAGE, true, false, false, "assemblage"},
    {Node::BINDING, true, false, false, "binding point"},
    {Node::COOPERATION, false, true, false, "cooperation"},
    {Node::COMPETITION, false, true, false, "competition"},
    {Node::SEQUENCE, false, true, false, "sequence"},
    {Node::COORDINATION, false, true, false, "coordination"},
    {Node::FUSION, false, true, false, "fusion"},
    {Node::SELECTION, false, true, false, "selection"},
    {Node::LOGIC, false, false, true, "logic"},
    {Node::DELAY, true, true, false, "delay"},
    {Node::PARAMETER, false, false, true, "parameter"},
    {Node::UNKNOWN, true, false, false, "unknown"},
    {Node::ACTUATOR, false, false, false, "actuator"},
    {Node::DECLARATION, true, false, false, "declaration"},
    {Node::ROBOT, true, false, false, "robot"},
    {Node::TEAM, true, false, false, "team"},
    {Node::CASTE, false, false, false, "caste"},
    {Node::SOCIETY, false, false, false, "society"},
    {Node::FORMULA, true, false, false, "formula"},
    {Node::BODY, true, false, false, "part of the body"},
    {Node::SENSOR, true, false, false, "sensor"},
}};

const ShapeLook& look_of(Node::Shape shape) {
  const auto found = std::ranges::find(kLooks, shape, &ShapeLook::shape);
  return found == kLooks.end() ? kLooks[13] : *found;
}

double even(double value) {
  return std::ceil(value / 8.0) * 8.0;
}

bool is_wired(const Drawing& drawing, const Node& node, const Port& port) {
  return std::ranges::any_of(drawing.wires(), [&](const Wire& wire) {
    return wire.to() == node.name() && wire.port() == port.name() && wire.has_index() == port.has_index() &&
           wire.index() == port.index();
  });
}

std::string label_of(const Port& port) {
  if (!port.label().empty()) return port.label();
  if (port.is_member()) return fmt::format("member {}", port.index() + 1);
  std::string name = port.name();
  std::ranges::replace(name, '_', ' ');
  return port.has_index() ? fmt::format("{} {}", name, port.index() + 1) : name;
}

std::string value_with_unit(const std::string& value, const std::string& unit) {
  const bool is_number = value.find_first_not_of("+-.0123456789eE") == std::string::npos;
  return is_number && !value.empty() && !unit.empty() ? value + " " + unit : value;
}

std::string shown_value(const Port& port, bool has_wire) {
  const bool takes_more = port.is_list() && !port.has_index() && port.value().empty();
  if (takes_more && !has_wire) return "";
  if (port.is_exposed()) return port.value().empty() ? port.name() : port.value();
  if (has_wire) return "";
  return value_with_unit(port.value().empty() ? port.initial() : port.value(), port.unit());
}

double row_width(const Port& port, bool has_wire) {
  const std::string value = shown_value(port, has_wire);
  const double right = value.empty() ? 8.0 : 20.0 + std::min(110.0, text_width(value, 12));
  return 30.0 + text_width(label_of(port), 12) + right + (port.is_member() ? 46.0 : 0.0);
}

std::string subtitle_of(const Node& node, const std::string& title, const char* kind) {
  if (!node.component().empty() && node.component() != title)
    return node.count() > 1 ? fmt::format("{} x {}", node.count(), node.component()) : node.component();
  return node.count() > 1 ? fmt::format("{} robots", node.count()) : kind;
}

}  // namespace

double text_width(std::string_view text, double size, bool is_bold) {
  constexpr std::string_view kNarrow = "ilj.,:;'|!()[]";
  constexpr std::string_view kWide = "mwMW@";
  double width = 0.0;
  for (const char letter : text) {
    const auto byte = static_cast<unsigned char>(letter);
    if ((byte & 0xc0U) == 0x80U) continue;  // goes on with the letter before
    const bool is_broad = (letter >= 'A' && letter <= 'Z') || letter == '_';
    if (kNarrow.find(letter) != std::string_view::npos)
      width += 0.3;
    else if (kWide.find(letter) != std::string_view::npos)
      width += 0.85;
    else
      width += is_broad ? 0.65 : 0.54;
  }
  return width * size * (is_bold ? 1.06 : 1.0);
}

DrawnSize size_of(const Node& node, const Drawing& drawing) {
  const ShapeLook& look = look_of(node.shape());
  const std::string& title = node.title().empty() ? node.name() : node.title();
  const double beside = kIconWidth + kMargin + (node.has_inner() ? kEnterWidth : 0.0);
  double wanted = std::max({kMinWidth, beside + text_width(title, 13, true),
                            beside + text_width(subtitle_of(node, title, look.kind), 11)});
  for (const Port& port : node.inputs())
    wanted = std::max(wanted, row_width(port, is_wired(drawing, node, port)));
  wanted += (look.has_symbol ? kSymbolWidth : 0.0) + (look.is_box ? 0.0 : 14.0);
  const bool is_small = look.can_be_small && node.inputs().empty();
  const double rows = node.inputs_size() * kRowHeight + (node.inputs().empty() ? 0.0 : kFoot);
  return {even(std::min(kMaxWidth, wanted)), (is_small ? kSmallHeight : kHeadHeight) + rows};
}

DrawnSize size_of(const State& state) {
  const std::string& below = state.title().empty() ? state.member() : state.title();
  const double wanted = std::max(
      {text_width(state.name(), 14, true) + 56.0, std::min(220.0, text_width(below, 11)) + 48.0, 128.0});
  return {even(std::min(wanted, 268.0)), kStateHeight};
}

}  // namespace mlab::designer
