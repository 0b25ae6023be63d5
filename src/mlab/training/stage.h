#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mlab/base/id.h"
#include "mlab/training/column.h"

namespace mlab::training {

/// Robots of one program that somebody trains a policy on: put back to their beginning, stepped by an array
/// with a row for each, seen through another one. Belongs to one thread at a time.
///
/// In a cycle robots sense, their programs act with what the array gave, and time goes by. What is seen
/// afterwards of programs is what they have computed in that cycle; of bodies, how they stand after it.
class Stage {
 public:
  Stage() = default;
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;
  virtual ~Stage() = default;

  /// By row of the arrays.
  virtual const std::vector<base::RobotId>& robots() const = 0;
  virtual const std::vector<Column>& seen() const = 0;
  virtual const std::vector<Column>& acted() const = 0;

  /// Everything begins anew.
  /// @errors  a sentence: it can't be made
  virtual std::optional<std::string> reset(std::uint64_t seed) = 0;
  /// One cycle.
  /// @param actions      rows of `acted()`, robots() of them
  /// @param is_given_up  asked again and again while a robot's own process is waited for
  /// @param seen         as of `observe`, after the cycle; empty: nobody looks
  /// @errors  a sentence about the first number that is not taken; nothing has happened
  virtual std::optional<std::string> step(std::span<const double> actions,
                                          const std::function<bool()>& is_given_up,
                                          std::span<double> seen) = 0;
  /// @param out  rows of `seen()`, robots() of them
  virtual void observe(std::span<double> out) = 0;

  /// Nothing more happens.
  virtual bool is_over() const = 0;
  /// By row: this robot does nothing more; 1 or 0.
  virtual void ended(std::span<std::uint8_t> out) const = 0;
  virtual double time() const = 0;  ///< since the last reset [s]
  virtual std::uint64_t cycle() const = 0;
  virtual double cycle_duration() const = 0;  ///< [s]
};

}  // namespace mlab::training
