#include "mlab/console/run/series_recorder.h"

#include <algorithm>

#include "mlab/console/run/measure_series.h"

namespace mlab::console {

SeriesRecorder::Key SeriesRecorder::key_of(const Series& series) {
  const bool has_port = series.quantity() == Series::PORT;
  return {series.quantity(), series.robot(), series.robot() != 0 ? "" : series.unit(),
          has_port ? series.port() : ""};
}

void SeriesRecorder::watch(const std::vector<Series>& wanted, double wall) {
  for (auto& [key, track] : tracks_) {
    if (track.unwatched_at < 0.0) track.unwatched_at = wall;
  }
  for (const Series& series : wanted) {
    Track& track = tracks_[key_of(series)];
    track.series = series;
    track.unwatched_at = -1.0;
  }
  std::erase_if(tracks_, [&](const auto& entry) {
    return entry.second.unwatched_at >= 0.0 && wall - entry.second.unwatched_at > kKept;
  });
}

void SeriesRecorder::look(const run::MissionRun& run) {
  for (auto& [key, track] : tracks_) {
    if (track.cycles++ % track.stride != 0) continue;
    const std::optional<double> value = measure(run, track.series);
    if (!value) continue;
    track.samples.push_back({run.time(), *value});
    if (track.samples.size() < kMost) continue;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < track.samples.size(); i += 2) track.samples[kept++] = track.samples[i];
    track.samples.resize(kept);
    track.stride *= 2;
  }
}

void SeriesRecorder::clear() {
  for (auto& [key, track] : tracks_) {
    track.samples.clear();
    track.stride = 1;
    track.cycles = 0;
  }
}

void SeriesRecorder::encode_since(const Series& series, double time, std::string& samples) const {
  const auto at = tracks_.find(key_of(series));
  if (at == tracks_.end()) return;
  const std::vector<Sample>& all = at->second.samples;
  const auto first = std::ranges::upper_bound(all, time, {}, &Sample::time);
  samples.append(reinterpret_cast<const char*>(all.data() + (first - all.begin())),
                 static_cast<std::size_t>(all.end() - first) * sizeof(Sample));
}

double SeriesRecorder::last_time(const Series& series, double otherwise) const {
  const auto at = tracks_.find(key_of(series));
  return at == tracks_.end() || at->second.samples.empty() ? otherwise : at->second.samples.back().time;
}

}  // namespace mlab::console
