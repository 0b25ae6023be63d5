#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mlab/metrics/histogram.h"

namespace mlab::metrics {

/// The series of one family beyond which no more are told: who watches pays for each.
inline constexpr std::size_t kMostSeries = 100;

/// What a monitoring system is answered. Values of labels may be any text, names are the caller's to choose
/// well.
class Exposition {
 public:
  using Labels = std::vector<std::pair<std::string, std::string>>;
  /// One value, and what tells it from the others of its family.
  struct Series {
    Labels labels;
    double value = 0.0;
  };

  Exposition();
  ~Exposition();
  Exposition(const Exposition&) = delete;
  Exposition& operator=(const Exposition&) = delete;

  /// What goes up and down.
  void gauge(std::string_view name, std::string_view help, double value);
  /// At most the first kMostSeries of them; a family without any is not told.
  void gauge(std::string_view name, std::string_view help, const std::vector<Series>& series);
  /// What only grows, or begins anew at 0.
  void counter(std::string_view name, std::string_view help, double value);
  void counter(std::string_view name, std::string_view help, const std::vector<Series>& series);
  void histogram(std::string_view name, std::string_view help, const Histogram& values);

  /// All that another one tells, which has other names.
  void append(const Exposition& other);
  std::string text() const;
  /// Of the text.
  static constexpr std::string_view kContentType = "text/plain; version=0.0.4; charset=utf-8";

 private:
  struct Families;
  std::unique_ptr<Families> families_;
};

}  // namespace mlab::metrics
