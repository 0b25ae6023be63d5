#include "mlab/flow/type_words.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "mlab/flow/value_types.h"

namespace mlab::flow {
namespace {

// `FormationReference` as `formation reference`.
std::string small_words(std::string_view name) {
  std::string out;
  for (const char c : name) {
    if (std::isupper(static_cast<unsigned char>(c)) != 0 && !out.empty()) out += ' ';
    out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return out;
}

std::string with_article(std::string_view name) {
  const bool is_vowel =
      !name.empty() && std::string_view("AEIOaeio").find(name.front()) != std::string_view::npos;
  return fmt::format("{} {}", is_vowel ? "an" : "a", name);
}

}  // namespace

std::string noun_of(const TypeInfo& type) {
  switch (type.kind) {
    case TypeKind::kBool:
      return "truth value";
    case TypeKind::kInteger:
      return "whole number";
    case TypeKind::kReal:
      return "number";
    case TypeKind::kVector:
      return "vector";
    case TypeKind::kPoint:
      return "place";
    case TypeKind::kText:
      return "text that is short enough";
    case TypeKind::kMask:
      return "set of " + small_words(type.name);
    default:
      return small_words(type.name);
  }
}

std::string value_of(const TypeInfo& type) {
  switch (type.kind) {
    case TypeKind::kVector:
    case TypeKind::kPoint:
    case TypeKind::kPose:
    case TypeKind::kOther:
      return with_article(type.name);
    case TypeKind::kText:
      return "a text";
    case TypeKind::kList:
      return "a list of " + small_words(type.name);
    default:
      return with_article(noun_of(type));
  }
}

std::string value_of(const TypeInfo& type, std::string_view unit) {
  std::string out = value_of(type);
  if (unit.empty()) return out;
  const auto* const quantity = std::ranges::find_if(kQuantities, [&](const QuantityInfo& one) {
    return one.unit == unit || (unit == "deg" && one.unit == "rad");
  });
  if (type.kind == TypeKind::kReal && quantity != kQuantities.end()) out = with_article(quantity->name);
  return fmt::format("{} [{}]", out, unit);
}

std::string why_not_written(std::string_view port, const TypeInfo& type) {
  return fmt::format("`{}` is {}, which can't be written down, so it can't be set or held", port,
                     value_of(type));
}

std::string expected_of(const TypeInfo& type) {
  switch (type.kind) {
    case TypeKind::kBool:
      return "true or false";
    case TypeKind::kVector:
      return "two or three numbers, as {1, 2}";
    case TypeKind::kPoint:
      return "two numbers, as {1, 2}";
    case TypeKind::kText:
      return fmt::format("a text of at most {} bytes", type.size - 1);
    case TypeKind::kChoice:
      return fmt::format("one of {}", fmt::join(type.words, ", "));
    case TypeKind::kMask:
      return fmt::format("one or several of {}, with | between them", fmt::join(type.words, ", "));
    default:
      return "a " + noun_of(type);
  }
}

}  // namespace mlab::flow
