#pragma once

#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mlab/flow/program.h"
#include "mlab/training/column.h"

namespace mlab::training {

/// The columns that steer robots of one program: parameters and constants, or outputs of nodes that are held.
/// A number or a truth (0 or 1) is one column, a point two: `PORT.x`, `PORT.y`, a vector also has `PORT.z`.
class ActionColumns {
 public:
  /// Some columns that are one value.
  struct Value {
    const flow::Port* port = nullptr;
    std::size_t first = 0;  ///< column
    std::size_t count = 1;
  };

  /// @param takes_outputs  outputs can be held
  /// @errors  a sentence: there is no such port, or no number sets it
  static std::expected<ActionColumns, std::string> of(const flow::Program& program,
                                                      std::span<const std::string> wanted,
                                                      bool takes_outputs);

  const std::vector<Column>& columns() const { return columns_; }
  std::size_t count() const { return columns_.size(); }
  std::span<const Value> values() const { return values_; }

  /// The first column whose port does not take what stands there: out of range, no number, no whole one.
  /// Nothing: all do.
  std::optional<std::size_t> refused(const double* row) const;
  /// What is wrong with it, as a sentence.
  std::string why_refused(std::size_t column, double value) const;
  /// Sets them, where they are parameters and constants. None of the row may be refused.
  void write(std::byte* frame, const double* row) const;
  /// As a person writes it, in the port's edge_unit.
  static std::string text_of(const Value& value, const double* row);

 private:
  std::vector<Column> columns_;
  std::vector<Value> values_;
  std::vector<std::uint8_t> is_whole_;  // by column
};

}  // namespace mlab::training
