#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mlab/lang/cdl/lower/lower.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cdl {

/// Says what is wrong, each thing once: an assemblage that is used twice is wrong once, and a name that is
/// unknown in several places of one declaration is one slip.
class Findings {
 public:
  Findings(text::Diagnostics& sink, EarlierFindings& said) : sink_(sink), said_(said) {}

  text::Diagnostic& error(std::string kind, const text::Place& place, std::string message);
  /// @param about  the name that is wrong: it is so once, wherever it is used
  text::Diagnostic& error_about(const std::string& about, std::string kind, const text::Place& place,
                                std::string message);
  text::Diagnostic& warning(std::string kind, const text::Place& place, std::string message);
  static void hint_nearest(text::Diagnostic& d, std::string_view name,
                           const std::vector<std::string>& candidates);
  /// Whether it was said that the assemblage itself lacks that name.
  bool misses_name(const Assemblage& assemblage, const std::string& name) const;
  std::size_t error_count() const { return sink_.error_count(); }

  /// As long as it lives, the names of that assemblage are being read.
  class Inside {
   public:
    Inside(Findings& findings, const Assemblage& assemblage)
        : findings_(findings), outer_(std::exchange(findings.inside_, &assemblage)) {}
    ~Inside() { findings_.inside_ = outer_; }
    Inside(const Inside&) = delete;
    Inside& operator=(const Inside&) = delete;

   private:
    Findings& findings_;
    const Assemblage* const outer_;
  };

 private:
  text::Diagnostic& report(text::Severity severity, std::string kind, const text::Place& place,
                           std::string message, const std::string& about = {});

  text::Diagnostics& sink_;
  EarlierFindings& said_;
  text::Diagnostic muted_;              // takes what is said of something that was said before
  const Assemblage* inside_ = nullptr;  // whose names are being read; null: the robot's
};

}  // namespace mlab::cdl
