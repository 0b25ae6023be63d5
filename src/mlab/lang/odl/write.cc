#include "mlab/lang/odl/write.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

#include <fmt/core.h>

#include "mlab/lang/odl/grammar.h"

namespace mlab::odl {
namespace {

bool stands(text::Span span) {
  return span.end > span.begin;
}

bool is_plain_word(std::string_view name) {
  return !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) != 0 &&
         std::ranges::all_of(name, [](char c) {
           return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
         });
}

Keyword keyword_of(overlay::ObjectStyle style) {
  return style == overlay::ObjectStyle::kFixed     ? Keyword::kFixed
         : style == overlay::ObjectStyle::kMovable ? Keyword::kMovable
                                                   : Keyword::kContainer;
}

class Writer {
 public:
  Writer(const Statement& statement, const Tree& tree) : statement_(statement), tree_(tree) {}

  std::vector<text::Word> words() && {
    const Form form = rule_of(statement_.keyword).form;
    add(statement_.keyword);
    switch (form) {
      case Form::kHallway:
        add(statement_.name);
        add(Keyword::kCenterline);
        add(statement_.centerline);
        add(Keyword::kWidth);
        add_numbers();
        add(Keyword::kExtents);
        add(statement_.points);
        break;
      case Form::kObject:
        add(statement_.points);
        add_numbers();
        add(keyword_of(statement_.style));
        add(statement_.name);
        add_route();
        break;
      case Form::kMoving:
        add(statement_.points);
        add_numbers();
        add_route();
        break;
      case Form::kSet:
        add(Keyword::kZoomFactor);
        add_numbers();
        break;
      case Form::kValues:
        add(statement_.points);
        add_numbers();
        break;
      case Form::kName:
      case Form::kFile:
      case Form::kNamed:
        add(statement_.name);
        add(statement_.points);
        add_numbers();
        break;
    }
    return std::move(out_);
  }

 private:
  void add(text::Span span, std::string text) {
    out_.push_back(stands(span) ? text::Word{"", span} : text::Word{std::move(text), std::nullopt});
  }
  void add(Keyword keyword) {
    const auto begin = tree_.tokens.begin() + statement_.first_token;
    const auto end = tree_.tokens.begin() + statement_.end_token;
    const auto found = std::find_if(begin, end, [&](const Token& one) { return one.keyword == keyword; });
    add(found == end ? text::Span{} : found->span, std::string(spelling(keyword)));
  }
  void add(const NameSyntax& name) {
    add(name.span, written_name(name.has_star ? name.text + '*' : name.text));
  }
  void add(const NumberSyntax& number) { add(number.span, written(number.value)); }
  void add_numbers() {
    for (const NumberSyntax& number : statement_.numbers) add(number);
  }
  void add_route() {
    if (statement_.route.empty()) return;
    add(Keyword::kRoute);
    add(statement_.route);
    add(Keyword::kSpeed);
    add(statement_.speed.value_or(NumberSyntax{}));
  }
  void add(const std::vector<PointSyntax>& points) {
    for (const PointSyntax& point : points) {
      if (point.form != PointForm::kMetres) {
        for (std::uint32_t i = 0; i < token_count(point.form); ++i)
          add(tree_.tokens[point.first_token + i].span, "");
        continue;
      }
      add(point.x);
      add(point.y);
    }
  }

  const Statement& statement_;
  const Tree& tree_;
  std::vector<text::Word> out_;
};

}  // namespace

std::string written(double value) {
  if (value != 0.0 && std::abs(value) < 0.005) return fmt::format("{:.2g}", value);
  std::string out = fmt::format("{:.2f}", value);
  out.erase(out.find_last_not_of('0') + 1);
  if (out.ends_with('.')) out.pop_back();
  return out == "-0" ? "0" : out;
}

std::string written_name(const std::string& name) {
  const std::string_view bare = std::string_view(name).substr(0, name.size() - (name.ends_with('*') ? 1 : 0));
  if (is_plain_word(bare)) return name;
  return name.find_first_of("\"\n\r") == std::string::npos ? '"' + name + '"' : "";
}

std::vector<text::Word> words_of(const Statement& statement, const Tree& tree) {
  return Writer(statement, tree).words();
}

std::string print(const Statement& statement) {
  std::string out;
  for (const text::Word& word : words_of(statement, Tree{})) out += (out.empty() ? "" : " ") + word.text;
  return out;
}

}  // namespace mlab::odl
