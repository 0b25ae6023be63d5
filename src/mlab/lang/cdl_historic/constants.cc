#include "mlab/lang/cdl_historic/constants.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <system_error>
#include <utility>
#include <vector>

#include "mlab/percept/object_classes.h"

namespace mlab::cdl_historic {
namespace {

constexpr int kMaxParentheses = 50;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\n\f\v";
  const std::size_t begin = text.find_first_not_of(kBlank);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlank) - begin + 1);
}

bool is_word_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// Sums and products of numbers.
class Arithmetic {
 public:
  explicit Arithmetic(std::string_view text) : rest_(trimmed(text)) {}

  std::optional<double> value() {
    const double out = sum(0);
    if (failed_ || !rest_.empty() || !std::isfinite(out)) return std::nullopt;
    return out;
  }

 private:
  bool take(char c) {
    if (!rest_.starts_with(c)) return false;
    rest_ = trimmed(rest_.substr(1));
    return true;
  }

  double sum(int depth) {
    double out = product(depth);
    while (!failed_) {
      if (take('+')) {
        out += product(depth);
      } else if (take('-')) {
        out -= product(depth);
      } else {
        break;
      }
    }
    return out;
  }

  double product(int depth) {
    double out = factor(depth);
    while (!failed_) {
      if (take('*')) {
        out *= factor(depth);
      } else if (take('/')) {
        out /= factor(depth);
      } else {
        break;
      }
    }
    return out;
  }

  double factor(int depth) {
    if (depth > kMaxParentheses) return fail();
    if (take('-')) return -factor(depth + 1);
    if (take('+')) return factor(depth + 1);
    if (take('(')) {
      const double out = sum(depth + 1);
      return take(')') ? out : fail();
    }
    return leaf();
  }

  double leaf() {
    double out = 0.0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), out);
    if (error == std::errc{}) {
      rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
      if (rest_.starts_with('f') || rest_.starts_with('F') || rest_.starts_with('L')) rest_.remove_prefix(1);
      if (!rest_.empty() && is_word_character(rest_.front())) return fail();
      rest_ = trimmed(rest_);
      return out;
    }
    constexpr double kPi = 3.14159265358979323846;
    for (const auto& [word, value] :
         {std::pair{std::string_view("M_PI_2"), kPi / 2}, {"M_PI", kPi}, {"PI", kPi}}) {
      if (!rest_.starts_with(word)) continue;
      rest_ = trimmed(rest_.substr(word.size()));
      return value;
    }
    return fail();
  }

  double fail() {
    failed_ = true;
    return 0.0;
  }

  std::string_view rest_;
  bool failed_ = false;
};

struct ClassName {
  std::string_view historic;
  std::string_view ours;
};
// In small letters, without a plural `s` and without `_`.
constexpr ClassName kClassNames[] = {{"mine", "Mine"},
                                     {"biohazard", "Mine"},
                                     {"victim", "Mine"},
                                     {"enemie", "EnemyRobot"},
                                     {"enemy", "EnemyRobot"},
                                     {"enemyrobot", "EnemyRobot"},
                                     {"flag", "Flag"},
                                     {"eodarea", "Basket"},
                                     {"basket", "Basket"},
                                     {"rock", "Rock"},
                                     {"tree", "Tree"},
                                     {"treesandshrub", "Tree"},
                                     {"homebase", "HomeBase"},
                                     {"unknown", "Unknown"},
                                     {"unknownobject", "Unknown"},
                                     {"possiblebiohazard", "Unknown"},
                                     {"hidingplace", "HidingPlace"},
                                     {"radioactive", "HidingPlace"},
                                     {"yellow", "YellowMarker"},
                                     {"yellowmarker", "YellowMarker"},
                                     {"friendlyrobot", "FriendlyRobot"},
                                     {"anyobject", "AnyObject"}};

std::string folded(std::string_view word) {
  std::string out;
  for (const char c : word) {
    if (c == '_') continue;
    out += c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  }
  if (out.ends_with('s')) out.pop_back();
  return out;
}

// `Mines | Flags`, or the mask as a number. In our language `"Mine|Flag"`, or the word alone.
Draft classes(std::string_view text, const text::Place& place) {
  if (const std::optional<double> mask = evaluate(text)) {
    if (*mask == -1.0) return name("AnyObject", place);
    if (*mask < 0.0 || *mask >= 4294967296.0 || *mask != std::floor(*mask)) return nullptr;
    std::string out;
    for (std::size_t i = 0; i < percept::kObjectClasses.size(); ++i) {
      if ((static_cast<std::uint32_t>(*mask) >> i & 1U) != 0)
        out += (out.empty() ? "" : "|") + std::string(percept::kObjectClasses[i].name);
    }
    if (out.empty()) return quoted("0", place);
    return out.find('|') == std::string::npos ? name(out, place) : quoted(out, place);
  }
  std::vector<std::string_view> words;
  for (std::string_view rest = text;;) {
    const std::size_t bar = rest.find('|');
    const std::string_view word = object_class(trimmed(rest.substr(0, bar)));
    if (word.empty()) return nullptr;
    if (std::ranges::find(words, word) == words.end()) words.push_back(word);
    if (bar == std::string_view::npos) break;
    rest.remove_prefix(bar + 1);
  }
  if (words.size() == 1) return name(std::string(words[0]), place);
  std::string out;
  for (const std::string_view word : words) out += (out.empty() ? "" : "|") + std::string(word);
  return quoted(out, place);
}

// `71, 30`; a third number is a height or a turn.
Draft coordinates(std::string_view text, std::size_t most, const text::Place& place) {
  cdl::List list;
  while (true) {
    const std::size_t comma = text.find(',');
    const std::optional<double> value = evaluate(text.substr(0, comma));
    if (!value) return nullptr;
    list.items.push_back(number(*value, "", place));
    if (comma == std::string_view::npos) break;
    text.remove_prefix(comma + 1);
  }
  if (list.items.size() < 2 || list.items.size() > 3) return nullptr;
  if (list.items.size() > most) list.items.resize(most);
  return draft(std::move(list), place);
}

std::optional<bool> truth(std::string_view text) {
  const std::string word = folded(text);
  if (word == "true" || word == "ye" || word == "on" || word == "1") return true;  // `yes` without its s
  if (word == "enterunmarkedonly" || word == "detectunmarkedonly") return true;
  if (word.starts_with("enter") || word.starts_with("detect")) return false;  // marked doors as well
  if (word == "checkwoncnptask") return true;
  if (word == "checkspecificcnptask") return false;
  if (word == "false" || word == "no" || word == "off" || word == "0") return false;
  return std::nullopt;
}

// Words that stood for whole numbers, and characters.
std::optional<double> whole(std::string_view text) {
  struct NamedNumber {
    std::string_view word;
    double value;
  };
  static constexpr NamedNumber kNumbers[] = {{"right", 0},
                                             {"left", 1},
                                             {"both", 2},
                                             {"bothleftandright", 2},
                                             {"facing", 3},
                                             {"opposite", 4},
                                             {"danger", 'd'},
                                             {"safe", 's'},
                                             {"abort", 'a'},
                                             {"true", 1},
                                             {"false", 0},
                                             {"commrecovery", 0},
                                             {"commpreserve", 1},
                                             {"commpreservation", 1},
                                             {"internalizedplan", 2},
                                             {"average", 3},
                                             {"greedy", 4}};
  if (text.size() == 3 && text.front() == '\'' && text.back() == '\'') return static_cast<double>(text[1]);
  // A number in quotes was a text that a node turned into a number.
  if (const std::optional<std::string> quoted = unquoted(text); quoted && !unquoted(*quoted))
    return whole(*quoted);
  const std::string word = folded(text);
  for (const NamedNumber& named : kNumbers) {
    if (named.word == word) return named.value;
  }
  const std::optional<double> value = evaluate(text);
  if (!value || std::abs(*value) > 2147483647.0) return std::nullopt;
  return std::trunc(*value);  // as C++ did
}

}  // namespace

std::optional<double> evaluate(std::string_view text) {
  return Arithmetic(text).value();
}

std::string with_named_values(std::string_view text,
                              const std::map<std::string, std::string, std::less<>>& named) {
  std::string out;
  bool in_quotes = false;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t n = 1;
    if (text[i] == '"') in_quotes = !in_quotes;
    if (is_word_character(text[i]) && !in_quotes) {
      while (i + n < text.size() && is_word_character(text[i + n])) ++n;
      if (const auto it = named.find(text.substr(i, n)); it != named.end()) {
        out += it->second;
        i += n;
        continue;
      }
    }
    out += text.substr(i, n);
    i += n;
  }
  return out;
}

std::optional<std::string> unquoted(std::string_view text) {
  const std::size_t begin = text.find('"');
  const std::size_t end = text.rfind('"');
  if (begin == std::string_view::npos || begin == end) return std::nullopt;
  std::string out;
  for (std::size_t i = begin + 1; i < end; ++i) {
    if (text[i] == '\\' && i + 1 < end) {
      ++i;
      out += text[i] == 'n' ? '\n' : text[i];
    } else {
      out += text[i];
    }
  }
  return out;
}

std::string_view object_class(std::string_view historic) {
  const std::string word = folded(historic);
  for (const ClassName& known : kClassNames) {
    if (known.historic == word) return known.ours;
  }
  for (const percept::ObjectClassInfo& ours : percept::kObjectClasses) {
    if (folded(ours.name) == word) return ours.name;
  }
  return {};
}

Draft constant(const Word& text, std::string_view type, const std::string& unit) {
  const std::string_view said = trimmed(text.text);
  if (type == "bool") {
    const std::optional<bool> value = truth(said);
    return value ? name(*value ? "true" : "false", text.place) : nullptr;
  }
  if (type == "int") {
    const std::optional<double> value = whole(said);
    return value ? number(*value, unit, text.place) : nullptr;
  }
  if (type == "double") {
    const std::optional<double> value = evaluate(said);
    return value ? number(*value, unit, text.place) : nullptr;
  }
  if (type == "Point") return coordinates(said, 2, text.place);
  if (type == "Vector") return coordinates(said, 3, text.place);
  if (type == "ObjectClasses") return classes(said, text.place);
  // Colours of objects were macros: `OrangeObject`.
  if (type == "Text" && said.ends_with("Object") && !unquoted(said)) {
    return quoted(std::string(said.substr(0, said.size() - 6)), text.place);
  }
  if (type == "Text") return quoted(unquoted(said).value_or(std::string(said)), text.place);
  if (type == "Formation" || type == "FormationReference" || type == "Task") {
    return quoted(unquoted(said).value_or(std::string(said)), text.place);
  }
  return nullptr;
}

std::string_view type_of_constant(std::string_view text) {
  const std::string_view said = trimmed(text);
  if (evaluate(said)) return "double";
  if (unquoted(said)) return "Text";
  if (coordinates(said, 3, {}) != nullptr) return "Point";
  if (const std::string word = folded(said); word == "true" || word == "false") return "bool";
  return "Text";
}

}  // namespace mlab::cdl_historic
