#include "mlab/ways/lane_shares.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "mlab/base/random.h"

namespace mlab::ways {
namespace {

constexpr double kLeastShare = 4.0;       // its length [swaths]
constexpr double kLongestInAShare = 8.0;  // so many of the longest pieces are as long as a mean share
constexpr double kLeastPiece = 1.5;       // that is cut off a longer one [swaths]
// What a share costs beside its length, in units of it, if it has the mean length: with the sixth power of
// the length, so that none is much longer.
constexpr double kFairness = 0.5;
// Of more they are as evenly cut as can be, and neighbours would take too long to find.
constexpr std::size_t kMostPieces = 1500;
constexpr std::size_t kMostMovedOver = 6;  // pieces at once
constexpr std::size_t kMostBeside = 10;    // ends that one may be joined with: the nearest ones
constexpr std::uint64_t kSeed = 19951128;  // any
// Changes that are tried: for each piece, and in all, some tenths of a second.
constexpr std::uint64_t kTriesOfAPiece = 6000;
constexpr std::uint64_t kMostTries = 1'000'000;
constexpr std::uint64_t kMostShareEffort = 12'000'000;  // of the planner: some seconds
// Of the mean length: what a change may cost in the beginning, and in the end.
constexpr double kHot = 0.15;
constexpr double kCold = 0.0005;

double length_of(const LanePiece& piece) {
  return distance(piece.a, piece.b);
}

constexpr PieceEnd kNone = std::numeric_limits<PieceEnd>::max();

/// What one robot follows, and how long that is.
struct Share {
  std::vector<PieceEnd> order;
  std::vector<double> begins;  // by piece: of the way from the robot to its beginning [m]
  double length = 0.0;         // with the way there [m]
  std::optional<geom::Point> from;

  std::size_t size() const { return order.size(); }
  PieceEnd into(std::size_t i) const { return i < order.size() ? order[i] : kNone; }
  PieceEnd out_of(std::size_t i) const { return i > 0 ? order[i - 1] ^ 1U : kNone; }  ///< of what is before i
};

class LaneShares {
 public:
  LaneShares(std::span<const LanePiece> in_order, BendingPlanner& planner,
             std::span<const geom::Point> robots, double swath)
      : ends_(planner), random_(kSeed) {
    double total = 0.0;
    for (const LanePiece& piece : in_order) total += length_of(piece);
    const double most = std::max(1.0, std::floor(total / (kLeastShare * swath)));
    const auto count = std::min(std::max<std::size_t>(robots.size(), 1), static_cast<std::size_t>(most));
    const double longest =
        count == 1 ? std::numeric_limits<double>::infinity()
                   : std::max(total / (kLongestInAShare * static_cast<double>(count)), kLeastPiece * swath);
    for (const LanePiece& piece : in_order) add(piece, longest);
    cut_order(count);
    if (count == 1) return;
    assign(robots);
    if (ends_.count() > kMostPieces) return;
    find_neighbours();
    improve();
  }

  std::vector<LaneShare> shares() const {
    std::vector<LaneShare> out;
    for (const Share& share : shares_) {
      LaneShare pieces;
      for (const PieceEnd end : share.order) pieces.push_back(ends_.piece(end));
      if (!pieces.empty() || out.empty()) out.push_back(std::move(pieces));
    }
    return out;
  }

 private:
  struct Spot {
    std::size_t share = 0;
    std::size_t i = 0;
  };

  /// Where it is longer, as parts of one length.
  void add(const LanePiece& piece, double longest) {
    const int parts = std::max(1, static_cast<int>(std::ceil(length_of(piece) / longest - 1e-9)));
    geom::Point from = piece.a;
    for (int i = 1; i < parts; ++i) {
      const geom::Point to = piece.a + (piece.b - piece.a) * (static_cast<double>(i) / parts);
      ends_.add({std::exchange(from, to), to});
    }
    ends_.add({from, piece.b});
  }

  /// Into shares of one length.
  void cut_order(std::size_t count) {
    const auto all = static_cast<PieceEnd>(ends_.count());
    const auto gap = [&](PieceEnd i) { return i == 0 ? 0.0 : ends_.straight(2 * i - 1, 2 * i); };
    double total = 0.0;
    for (PieceEnd i = 0; i < all; ++i) total += gap(i) + ends_.length(2 * i);
    mean_ = std::max(total / static_cast<double>(count), 1e-6);
    shares_.resize(count);
    double passed = 0.0;
    for (PieceEnd i = 0; i < all; ++i) {
      const double middle = passed + gap(i) + 0.5 * ends_.length(2 * i);
      passed += gap(i) + ends_.length(2 * i);
      const auto share = std::min(static_cast<std::size_t>(middle / mean_), count - 1);
      shares_[share].order.push_back(2 * i);
    }
  }

  /// The nearest robot and share first.
  void assign(std::span<const geom::Point> robots) {
    std::vector<geom::Point> left(robots.begin(), robots.end());
    for (std::size_t i = 0; i < shares_.size(); ++i) {
      Share* best = nullptr;
      std::size_t who = 0;
      double least = std::numeric_limits<double>::infinity();
      for (Share& share : shares_) {
        if (share.from) continue;
        for (std::size_t k = 0; k < left.size(); ++k) {
          const double away =
              share.order.empty() ? 1e300 : distance(left[k], ends_.place(share.order.front()));
          if (away >= least) continue;
          least = away;
          best = &share;
          who = k;
        }
      }
      best->from = left[who];
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(who));
    }
    spots_.resize(ends_.count());
    double total = 0.0;
    for (std::size_t share = 0; share < shares_.size(); ++share) {
      has_changed(share);
      total += shares_[share].length;
    }
    mean_ = std::max(total / static_cast<double>(shares_.size()), 1e-6);
  }

  void has_changed(std::size_t number) {
    Share& share = shares_[number];
    share.begins.clear();
    share.length = 0.0;
    for (std::size_t i = 0; i < share.size(); ++i) {
      share.length += joint(share, share.out_of(i), share.order[i]);
      share.begins.push_back(share.length);
      share.length += ends_.length(share.order[i]);
      spots_[share.order[i] / 2] = {number, i};
    }
  }

  void find_neighbours() {
    const std::size_t ends = 2 * ends_.count();
    neighbours_.resize(ends);
    std::vector<std::pair<double, PieceEnd>> all;
    for (PieceEnd a = 0; a < ends; ++a) {
      all.clear();
      for (PieceEnd b = 0; b < ends; ++b) {
        if (a / 2 != b / 2) all.emplace_back(distance(ends_.place(a), ends_.place(b)), b);
      }
      const std::size_t count = std::min(kMostBeside, all.size());
      std::ranges::partial_sort(all, all.begin() + static_cast<std::ptrdiff_t>(count));
      for (std::size_t i = 0; i < count; ++i) neighbours_[a].push_back(all[i].second);
    }
  }

  /// Of the way between two ends, or from where a share's robot is to one; nothing leads on from the last one
  /// [m].
  double joint(const Share& share, PieceEnd a, PieceEnd b) {
    if (b == kNone) return 0.0;
    return a != kNone ? ends_.way(a, b) : distance(*share.from, ends_.place(b));
  }
  double straight(const Share& share, PieceEnd a, PieceEnd b) const {
    if (b == kNone) return 0.0;
    return distance(a != kNone ? ends_.place(a) : *share.from, ends_.place(b));
  }

  double cost(double length) const {
    const double square = length * length / (mean_ * mean_);
    return length * (1.0 + kFairness * square * square * square);
  }
  double cost() const {
    double out = 0.0;
    for (const Share& share : shares_) out += cost(share.length);
    return out;
  }

  /// Simulated annealing.
  void improve() {
    const std::uint64_t tries = std::min(kMostTries, kTriesOfAPiece * ends_.count());
    const std::uint64_t most_effort = ends_.effort() + kMostShareEffort;
    const double hot = kHot * mean_ * (1.0 + kFairness);
    std::vector<Share> best = shares_;
    double now = cost();
    double least = now;
    for (std::uint64_t i = 0; i < tries && ends_.effort() < most_effort; ++i) {
      const double done = static_cast<double>(i) / static_cast<double>(tries);
      // It may cost as much.
      most_ = -hot * std::pow(kCold / kHot, done) * std::log(1.0 - random_.uniform());
      change();
      now += std::exchange(gained_, 0.0);
      if (now >= least - 1e-6) continue;
      least = now;
      best = shares_;
    }
    shares_ = std::move(best);
  }

  std::size_t any(std::size_t count) { return random_.below(count); }

  void change() {
    const double kind = random_.uniform();
    const auto a = static_cast<PieceEnd>(any(2 * ends_.count()));
    if (kind < 0.02) {
      swap_robots(any(shares_.size()), any(shares_.size()));
    } else if (kind < 0.1) {
      turn_beginning(spots_[a / 2]);
    } else {
      const auto& beside = neighbours_[a];
      if (beside.empty()) return;
      const PieceEnd b = beside[any(beside.size())];
      if (kind < 0.55)
        move_to(a, b, 1 + any(kMostMovedOver));
      else
        join(a, b);
    }
  }

  /// Whether two shares, which may be the same, are to get these lengths.
  bool is_wanted(const Share& one, const Share& other, double one_length, double other_length) const {
    if (&one == &other) return cost(one_length) - cost(one.length) <= most_;
    return cost(one_length) + cost(other_length) - cost(one.length) - cost(other.length) <= most_;
  }
  void gain(std::size_t one, std::size_t other) {
    const double before = cost(shares_[one].length) + (one == other ? 0.0 : cost(shares_[other].length));
    has_changed(one);
    if (one != other) has_changed(other);
    gained_ = cost(shares_[one].length) + (one == other ? 0.0 : cost(shares_[other].length)) - before;
  }

  void swap_robots(std::size_t one, std::size_t other) {
    Share& a = shares_[one];
    Share& b = shares_[other];
    if (one == other || a.order.empty() || b.order.empty()) return;
    const double now_a = a.length - a.begins[0] + distance(*b.from, ends_.place(a.order[0]));
    const double now_b = b.length - b.begins[0] + distance(*a.from, ends_.place(b.order[0]));
    if (!is_wanted(a, b, now_a, now_b)) return;
    std::swap(a.from, b.from);
    gain(one, other);
  }

  void turn_beginning(Spot spot) { turn(spot.share, 0, spot.i + 1); }

  /// [first, end) of a share.
  void turn(std::size_t number, std::size_t first, std::size_t end) {
    Share& share = shares_[number];
    const PieceEnd a = share.out_of(first);
    const PieceEnd b = share.order[first];
    const PieceEnd c = share.out_of(end);
    const PieceEnd d = share.into(end);
    const double rest = share.length - joint(share, a, b) - joint(share, c, d);
    if (!is_wanted(share, share, rest + straight(share, a, c) + straight(share, b, d), 0.0)) return;
    if (!is_wanted(share, share, rest + joint(share, a, c) + joint(share, b, d), 0.0)) return;
    turn_part(share.order, first, end);
    gain(number, number);
  }

  /// The piece of b, and some that follow or precede it, to where a is, so that b is beside a.
  void move_to(PieceEnd a, PieceEnd b, std::size_t count) {
    const Spot target = spots_[a / 2];
    const Spot spot = spots_[b / 2];
    Share& to = shares_[target.share];
    Share& from = shares_[spot.share];
    const bool leaves_by_a = to.order[target.i] != a;
    const bool enters_by_b = from.order[spot.i] == b;
    count = std::min(count, enters_by_b ? from.size() - spot.i : spot.i + 1);
    const std::size_t first = enters_by_b ? spot.i : spot.i + 1 - count;
    const std::size_t end = first + count;
    const std::size_t at = leaves_by_a ? target.i + 1 : target.i;  // it comes in front of that
    if (target.share == spot.share && at >= first && at <= end) return;
    const bool is_turned = leaves_by_a != enters_by_b;
    const PieceEnd begin = is_turned ? from.out_of(end) : from.order[first];
    const PieceEnd stop = is_turned ? from.order[first] : from.out_of(end);
    const double part = from.begins[end - 1] + ends_.length(from.order[end - 1]) - from.begins[first];
    const PieceEnd before = from.out_of(first);
    const PieceEnd after = from.into(end);
    const PieceEnd p = to.out_of(at);
    const PieceEnd q = to.into(at);
    const double cut_out =
        joint(from, before, from.order[first]) + joint(from, from.out_of(end), after) + part;
    const double gap = joint(to, p, q);
    const auto fits = [&](double closed, double into, double out_of) {
      const double less = closed - cut_out;
      const double more = into + part + out_of - gap;
      return &from == &to ? is_wanted(to, to, to.length + less + more, 0.0)
                          : is_wanted(from, to, from.length + less, to.length + more);
    };
    if (!fits(straight(from, before, after), straight(to, p, begin), straight(to, stop, q))) return;
    if (!fits(joint(from, before, after), joint(to, p, begin), joint(to, stop, q))) return;
    if (is_turned) turn_part(from.order, first, end);
    const auto place_of = [&](std::size_t k) { return from.order.begin() + static_cast<std::ptrdiff_t>(k); };
    if (&from != &to) {
      to.order.insert(to.order.begin() + static_cast<std::ptrdiff_t>(at), place_of(first), place_of(end));
      from.order.erase(place_of(first), place_of(end));
    } else if (at < first) {
      std::rotate(place_of(at), place_of(first), place_of(end));
    } else {
      std::rotate(place_of(first), place_of(end), place_of(at));
    }
    gain(spot.share, target.share);
  }

  /// So that a way leads from a straight to b, by changing what follows them: with what the other share has
  /// there, or, in one share, by turning round what is between.
  void join(PieceEnd a, PieceEnd b) {
    const Spot one = spots_[a / 2];
    const Spot other = spots_[b / 2];
    const bool leaves_by_a = shares_[one.share].order[one.i] != a;
    const bool enters_by_b = shares_[other.share].order[other.i] == b;
    if (one.share == other.share) {
      const auto [low, high] = std::minmax(one.i, other.i);
      if (leaves_by_a && !enters_by_b) turn(one.share, low + 1, high + 1);
      if (!leaves_by_a && enters_by_b) turn(one.share, low, high);
      return;
    }
    if (leaves_by_a && enters_by_b) change_tails(one.share, one.i + 1, other.share, other.i);
    if (!leaves_by_a && !enters_by_b) change_tails(other.share, other.i + 1, one.share, one.i);
  }

  /// Each goes on with what the other one had from there on.
  void change_tails(std::size_t one, std::size_t i, std::size_t other, std::size_t k) {
    Share& x = shares_[one];
    Share& y = shares_[other];
    const PieceEnd a = x.out_of(i);
    const PieceEnd b = x.into(i);
    const PieceEnd c = y.out_of(k);
    const PieceEnd d = y.into(k);
    const double head_x = i == 0 ? 0.0 : x.begins[i - 1] + ends_.length(x.order[i - 1]);
    const double head_y = k == 0 ? 0.0 : y.begins[k - 1] + ends_.length(y.order[k - 1]);
    const double tail_x = x.length - head_x - joint(x, a, b);
    const double tail_y = y.length - head_y - joint(y, c, d);
    if (!is_wanted(x, y, head_x + straight(x, a, d) + tail_y, head_y + straight(y, c, b) + tail_x)) return;
    if (!is_wanted(x, y, head_x + joint(x, a, d) + tail_y, head_y + joint(y, c, b) + tail_x)) return;
    std::vector<PieceEnd> tail(x.order.begin() + static_cast<std::ptrdiff_t>(i), x.order.end());
    x.order.resize(i);
    x.order.insert(x.order.end(), y.order.begin() + static_cast<std::ptrdiff_t>(k), y.order.end());
    y.order.resize(k);
    y.order.insert(y.order.end(), tail.begin(), tail.end());
    gain(one, other);
  }

  LaneEnds ends_;
  base::Random random_;
  double most_ = 0.0;    // that a change may cost
  double gained_ = 0.0;  // by the last change, of cost
  double mean_ = 1.0;    // length of a share [m]
  std::vector<Share> shares_;
  std::vector<Spot> spots_;                        // by piece
  std::vector<std::vector<PieceEnd>> neighbours_;  // by end, the nearest ends first
};

}  // namespace

std::vector<LaneShare> shared_out(std::span<const LanePiece> in_order, BendingPlanner& planner,
                                  std::span<const geom::Point> robots, double swath) {
  return LaneShares(in_order, planner, robots, swath).shares();
}

}  // namespace mlab::ways
