#include "mlab/flow/type_words.h"

#include <cctype>

#include <fmt/format.h>
#include <fmt/ranges.h>

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
