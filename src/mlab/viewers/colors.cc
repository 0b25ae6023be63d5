#include "mlab/viewers/colors.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

namespace mlab::viewers {
namespace {

struct Named {
  std::string_view name;
  std::uint32_t rgb;
};

constexpr auto kColors = std::to_array<Named>({
    {"beige", 0xf5f5dc},      {"black", 0x000000},        {"blue", 0x0000ff},      {"brown", 0xa52a2a},
    {"chocolate", 0xd2691e},  {"coral", 0xff7f50},        {"cyan", 0x00ffff},      {"darkblue", 0x00008b},
    {"darkgray", 0xa9a9a9},   {"darkgreen", 0x006400},    {"darkgrey", 0xa9a9a9},  {"darkorange", 0xff8c00},
    {"darkred", 0x8b0000},    {"darkseagreen", 0x8fbc8f}, {"deeppink", 0xff1493},  {"dodgerblue", 0x1e90ff},
    {"firebrick", 0xb22222},  {"forestgreen", 0x228b22},  {"gold", 0xffd700},      {"gray", 0xbebebe},
    {"green", 0x00ff00},      {"grey", 0xbebebe},         {"khaki", 0xf0e68c},     {"lightblue", 0xadd8e6},
    {"lightgreen", 0x90ee90}, {"limegreen", 0x32cd32},    {"magenta", 0xff00ff},   {"maroon", 0xb03060},
    {"navy", 0x000080},       {"olivedrab", 0x6b8e23},    {"orange", 0xffa500},    {"orangered", 0xff4500},
    {"orchid", 0xda70d6},     {"pink", 0xffc0cb},         {"plum", 0xdda0dd},      {"purple", 0xa020f0},
    {"red", 0xff0000},        {"royalblue", 0x4169e1},    {"salmon", 0xfa8072},    {"seagreen", 0x2e8b57},
    {"sienna", 0xa0522d},     {"skyblue", 0x87ceeb},      {"slateblue", 0x6a5acd}, {"steelblue", 0x4682b4},
    {"tan", 0xd2b48c},        {"tomato", 0xff6347},       {"turquoise", 0x40e0d0}, {"violet", 0xee82ee},
    {"wheat", 0xf5deb3},      {"white", 0xffffff},        {"yellow", 0xffff00},    {"yellowgreen", 0x9acd32},
});
constexpr std::uint32_t kUnknown = 0x7f7f7f;

}  // namespace

foxglove::Color color_named(std::string_view name, double alpha) {
  std::string plain;
  for (const char c : name) {
    if (c != ' ' && c != '_' && c != '-')
      plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  const auto found = std::ranges::find(kColors, plain, &Named::name);
  const std::uint32_t rgb = found == kColors.end() ? kUnknown : found->rgb;
  foxglove::Color out;
  out.set_r(static_cast<double>(rgb >> 16U & 0xffU) / 255.0);
  out.set_g(static_cast<double>(rgb >> 8U & 0xffU) / 255.0);
  out.set_b(static_cast<double>(rgb & 0xffU) / 255.0);
  out.set_a(alpha);
  return out;
}

}  // namespace mlab::viewers
