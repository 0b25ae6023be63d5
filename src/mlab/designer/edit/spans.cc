#include "mlab/designer/edit/spans.h"

#include <algorithm>

namespace mlab::designer {
namespace {

// Of the declaration of that name; empty where the item is another.
text::Span span_of(const cdl::Item& item, std::string_view name) {
  return std::visit(
      [&](const auto& one) -> text::Span {
        if constexpr (requires { one.name.text, one.whole; }) {
          if (one.name.text == name) return one.whole;
        }
        return {};
      },
      item);
}

}  // namespace

std::size_t TokenMap::at(std::uint32_t byte) const {
  const auto found =
      std::ranges::lower_bound(lexed_.tokens, byte, {}, [](const cdl::Token& t) { return t.span.begin; });
  return static_cast<std::size_t>(std::min(found, lexed_.tokens.end() - 1) - lexed_.tokens.begin());
}

std::uint32_t TokenMap::help_begin(std::uint32_t statement) const {
  const std::size_t token = at(statement);
  const std::uint32_t last = lexed_.tokens[token].comments;
  const std::uint32_t first = token == 0 ? 0 : lexed_.tokens[token - 1].comments;
  const std::uint32_t behind = token == 0 ? 0 : lexed_.tokens[token - 1].span.end;
  std::uint32_t out = statement;
  for (std::uint32_t i = last; i-- > first;) {
    const text::Span span = lexed_.comments[i].span;
    const std::string_view words = text_.substr(span.begin, span.end - span.begin);
    const std::string_view between = text_.substr(behind, span.begin - behind);
    const bool is_own_line = behind == 0 || between.find('\n') != std::string_view::npos;
    const std::string_view gap = text_.substr(span.end, out - span.end);
    if (!words.starts_with("///") || words.starts_with("///<") || !is_own_line ||
        std::ranges::count(gap, '\n') > 1)
      break;
    out = span.begin;
  }
  return out;
}

text::Span declaration_span(const Model& model, std::string_view name) {
  for (const cdl::Item& item : model.tree().items) {
    const text::Span whole = span_of(item, name);
    if (whole.begin != whole.end) return {TokenMap(model.text()).help_begin(whole.begin), whole.end};
  }
  return {};
}

std::string declaration_text(const Model& model, std::string_view name) {
  const text::Span span = declaration_span(model, name);
  return std::string(model.text().substr(span.begin, span.end - span.begin));
}

}  // namespace mlab::designer
