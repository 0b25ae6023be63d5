#pragma once

#include <expected>
#include <string>

#include "mlab/preflight/preflight.h"

namespace mlab::preflight {

/// Where signed checklists are kept: a folder of the user's, a file for each mission as it was signed.
class Store {
 public:
  /// @param folder  it may be missing; empty: nothing can be kept
  explicit Store(std::string folder) : folder_(std::move(folder)) {}

  /// Takes the place of what was signed before for the same texts; removes what holds no longer for a day.
  /// @return  why it could not be written, as a sentence; empty: it was
  std::string keep(const SignedChecklist& checklist) const;

  /// What was signed for what is now, and holds.
  /// @param at  wall clock, as Signature::at
  /// @errors  a sentence: nobody has signed one, or why what was signed for this mission last does not hold;
  /// a file
  ///          that can't be read is named
  std::expected<SignedChecklist, std::string> find(const Checklist& now, double at) const;

  const std::string& folder() const { return folder_; }

 private:
  std::string folder_;
};

}  // namespace mlab::preflight
