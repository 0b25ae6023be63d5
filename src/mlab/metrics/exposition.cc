#include "mlab/metrics/exposition.h"

#include <cstdint>
#include <span>

#include <prometheus/metric_family.h>
#include <prometheus/text_serializer.h>

namespace mlab::metrics {
namespace {

using prometheus::ClientMetric;
using prometheus::MetricFamily;
using prometheus::MetricType;

ClientMetric metric_of(const Exposition::Series& series, MetricType type) {
  ClientMetric out;
  for (const auto& [name, value] : series.labels) out.label.push_back({name, value});
  if (type == MetricType::Counter)
    out.counter.value = series.value;
  else
    out.gauge.value = series.value;
  return out;
}

MetricFamily family_of(std::string_view name, std::string_view help, MetricType type,
                       std::span<const Exposition::Series> series) {
  MetricFamily out{std::string(name), std::string(help), type, {}};
  for (const Exposition::Series& one : series.first(std::min(series.size(), kMostSeries)))
    out.metric.push_back(metric_of(one, type));
  return out;
}

}  // namespace

struct Exposition::Families {
  std::vector<MetricFamily> all;

  void add(MetricFamily family) {
    if (!family.metric.empty()) all.push_back(std::move(family));
  }
};

Exposition::Exposition() : families_(std::make_unique<Families>()) {}
Exposition::~Exposition() = default;

void Exposition::gauge(std::string_view name, std::string_view help, double value) {
  gauge(name, help, std::vector<Series>{{{}, value}});
}

void Exposition::gauge(std::string_view name, std::string_view help, const std::vector<Series>& series) {
  families_->add(family_of(name, help, MetricType::Gauge, series));
}

void Exposition::counter(std::string_view name, std::string_view help, double value) {
  counter(name, help, std::vector<Series>{{{}, value}});
}

void Exposition::counter(std::string_view name, std::string_view help, const std::vector<Series>& series) {
  families_->add(family_of(name, help, MetricType::Counter, series));
}

void Exposition::histogram(std::string_view name, std::string_view help, const Histogram& values) {
  ClientMetric metric;
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < values.counts().size(); ++i) {
    count += values.counts()[i];
    if (i < Histogram::kBounds.size()) metric.histogram.bucket.push_back({count, Histogram::kBounds[i]});
  }
  metric.histogram.sample_count = count;
  metric.histogram.sample_sum = values.sum();
  families_->add({std::string(name), std::string(help), MetricType::Histogram, {std::move(metric)}});
}

void Exposition::append(const Exposition& other) {
  families_->all.insert(families_->all.end(), other.families_->all.begin(), other.families_->all.end());
}

std::string Exposition::text() const {
  return prometheus::TextSerializer().Serialize(families_->all);
}

}  // namespace mlab::metrics
