#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>

namespace mlab::base {

/// Whether a value of an enumeration has a name.
template <auto kValue>
consteval bool is_enumerator() {
  // Compilers write `kValue = mlab::Kind::kName` where there is a name, and `kValue = (mlab::Kind)16` where
  // not.
  const std::string_view text = __PRETTY_FUNCTION__;
  return text[text.find("kValue = ") + std::string_view("kValue = ").size()] != '(';
}

/// Whether a table has exactly one row for each enumerator: what a static_assert beside every descriptor
/// table says, so that a forgotten row does not compile. Enumerators are numbered from 0 without holes.
///
/// @tparam kRows  a constexpr array
/// @tparam kKey   the member of a row that holds its enumerator
template <const auto& kRows, auto kKey>
consteval bool has_a_row_for_each() {
  using Row = std::remove_cvref_t<decltype(kRows[0])>;
  using Kind = std::remove_cvref_t<decltype(kRows[0].*kKey)>;
  constexpr std::size_t kCount = std::size(kRows);
  std::array<int, kCount> rows_of{};
  for (const Row& row : kRows) {
    if (static_cast<std::size_t>(row.*kKey) >= kCount) return false;
    ++rows_of[static_cast<std::size_t>(row.*kKey)];
  }
  for (const int rows : rows_of) {
    if (rows != 1) return false;
  }
  return !is_enumerator<static_cast<Kind>(kCount)>();
}

/// The row of an enumerator, in a table that has one for each.
template <class Rows, class Kind, class Row>
constexpr const Row& row_of(const Rows& rows, Kind Row::* key, Kind kind) {
  for (const Row& row : rows) {
    if (row.*key == kind) return row;
  }
  return rows[0];  // only for a number that is no enumerator
}

}  // namespace mlab::base
