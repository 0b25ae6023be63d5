#include "mlab/lang/mdl/words.h"

#include <string>
#include <utility>

namespace mlab::mdl {
namespace {

text::Word word(text::Span span, std::string text) {
  return span.end > span.begin ? text::Word{"", span} : text::Word{std::move(text), std::nullopt};
}

text::Word word(const Number& number) {
  return word(number.span, number.text);
}

text::Word word(const Name& name) {
  return word(name.span, name.quoted ? '"' + name.text + '"' : name.text);
}

}  // namespace

std::vector<text::Word> words_of(const statement::StartPlace& start, text::Span keyword) {
  return {word(keyword, "SP"), word(start.name), word(start.x), word(start.y)};
}

std::vector<text::Word> words_of(const statement::Obstacle& obstacle, text::Span keyword) {
  return {word(keyword, "OBSTACLE"), word(obstacle.x), word(obstacle.y), word(obstacle.radius)};
}

std::vector<text::Word> words_of(const statement::MissionArea& area, text::Span keyword) {
  return {word(keyword, "MISSION-AREA"), word(area.width), word(area.height)};
}

}  // namespace mlab::mdl
