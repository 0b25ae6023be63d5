#include "killer.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <utility>

#include "mlab/base/random.h"

namespace mlab::network {
namespace {

double in_seconds(Duration duration) {
  return std::chrono::duration<double>(duration).count();
}

Duration between(Duration low, Duration high, double share) {
  return low + std::chrono::duration_cast<Duration>(share * (high - low));
}

}  // namespace

std::vector<Strike> planned_strikes(const KillerSetup& setup, std::size_t victims) {
  std::vector<Strike> out;
  if (victims == 0 || (!setup.kills && !setup.stops)) return out;
  for (std::size_t i = 0; i < setup.strikes; ++i) {
    auto random = base::Random::of(setup.seed, base::hash_text("killer"), i, 0);
    Strike strike;
    strike.at = between(Duration(0), setup.span, random.uniform());
    strike.victim = random.below(victims);
    strike.is_stop = setup.stops && (!setup.kills || random.uniform() < 0.5);
    if (strike.is_stop)
      strike.stopped_for = between(setup.shortest_stop, setup.longest_stop, random.uniform());
    out.push_back(strike);
  }
  std::ranges::sort(out, {}, &Strike::at);
  return out;
}

Killer::Killer(const KillerSetup& setup, std::vector<Victim> victims)
    : setup_(setup),
      victims_(std::move(victims)),
      strikes_(planned_strikes(setup, victims_.size())),
      begin_(Clock::now()),
      thread_([this] { work(); }) {}

Killer::~Killer() {
  {
    const std::scoped_lock lock(mutex_);
    is_over_ = true;
  }
  changed_.notify_all();
  wait();
}

void Killer::wait() {
  if (thread_.joinable()) thread_.join();
}

std::vector<std::string> Killer::done() const {
  const std::scoped_lock lock(mutex_);
  return done_;
}

bool Killer::sleep_until(Time moment) {
  std::unique_lock lock(mutex_);
  return !changed_.wait_until(lock, moment, [this] { return is_over_; });
}

void Killer::say(const std::string& text) {
  const std::string line = fmt::format("{:.3f} s: {}", in_seconds(Clock::now() - begin_), text);
  fmt::print("[killer] seed {}, {}\n", setup_.seed, line);
  std::fflush(stdout);
  const std::scoped_lock lock(mutex_);
  done_.push_back(line);
}

void Killer::work() {
  /// One that is to go on.
  struct Stopped {
    Time until;
    std::size_t victim;
  };
  std::vector<Stopped> stopped;
  const auto let_go_on = [&](bool all) {
    for (auto next = std::ranges::min_element(stopped, {}, &Stopped::until);
         next != stopped.end() && (all || next->until <= Clock::now());
         next = std::ranges::min_element(stopped, {}, &Stopped::until)) {
      victims_[next->victim].signal(SIGCONT);
      say("SIGCONT to " + victims_[next->victim].name());
      stopped.erase(next);
    }
  };
  bool is_over = false;
  for (std::size_t i = 0; !is_over && (i < strikes_.size() || !stopped.empty());) {
    Time next = i < strikes_.size() ? begin_ + strikes_[i].at : Time::max();
    for (const Stopped& one : stopped) next = std::min(next, one.until);
    is_over = !sleep_until(next);
    let_go_on(is_over);
    if (is_over || i == strikes_.size() || begin_ + strikes_[i].at > Clock::now()) continue;
    const Strike& strike = strikes_[i++];
    const Victim& victim = victims_[strike.victim];
    const bool is_struck = victim.signal(strike.is_stop ? SIGSTOP : SIGKILL);
    say(fmt::format("{} to {} (process {}){}{}", strike.is_stop ? "SIGSTOP" : "SIGKILL", victim.name(),
                    victim.id(),
                    strike.is_stop ? fmt::format(" for {:.3f} s", in_seconds(strike.stopped_for)) : "",
                    is_struck ? "" : ", which has ended already"));
    if (is_struck && strike.is_stop) stopped.push_back({Clock::now() + strike.stopped_for, strike.victim});
  }
}

}  // namespace mlab::network
