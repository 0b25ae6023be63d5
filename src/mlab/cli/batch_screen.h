#pragma once

#include <string>

#include "mlab/study/batch.h"
#include "mlab/study/summary.h"

namespace mlab::cli {

/// One line on a terminal that says how far a batch is, and for how long it will go on. Nothing in a pipe.
class BatchProgress {
 public:
  explicit BatchProgress(bool is_quiet);
  void show(const study::Progress& progress);
  void clear() const;

 private:
  bool is_shown_;
  double began_;
  double last_ = 0.0;
};

/// What came out, as a table for a person.
/// @param seconds  that it took
void print_summary(const study::Summary& summary, const study::Definition& definition,
                   const study::Plan& plan, const std::string& mission, double seconds);
/// Which requirements are met.
void print_verdicts(const study::Summary& summary);

}  // namespace mlab::cli
