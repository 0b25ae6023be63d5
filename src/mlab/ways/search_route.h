#pragma once

#include <algorithm>
#include <cstdint>
#include <list>
#include <optional>
#include <span>
#include <vector>

#include "mlab/ways/bending_planner.h"
#include "mlab/ways/lane_shares.h"
#include "mlab/ways/search_grid.h"

/// For sources of this module only.
namespace mlab::ways {

/// Ways from stop to stop, planned in between, one for each share, while they are made to see more, or
/// shortened. What they see is counted in the grid. Each has two stops at least, but for an only one.
class SearchRoute {
 public:
  /// @param grid, planner  outlive this
  /// @param shares  one at least
  /// @param most_effort  after so much it is improved no more, and leads as it does then
  SearchRoute(SearchGrid& grid, BendingPlanner& planner, std::span<const LaneShare> shares,
              std::uint64_t most_effort);

  /// Leaves stops out, as long as no more than `most_unseen` cells are unseen, where each metre saved costs
  /// at most a share `price` of what a metre sees at best.
  void shorten(double price, std::size_t most_unseen);
  /// Adds stops until no more than `most_unseen` cells are unseen, those first that see most for each metre.
  void complete(std::size_t most_unseen);

  /// Stops, and what planned ways were looked for by, that were looked at so far.
  std::uint64_t effort() const { return effort_ + kStopsOfAnEffort * planner_.effort(); }

  double length() const;  ///< of all ways together [m]
  /// Stops without those that lie on the straight way from the one before to the next; by stop the corners of
  /// the way to the next one, none after a share's last; and by share the number of its first stop.
  struct Waypoints {
    std::vector<geom::Point> stops;
    std::vector<std::vector<geom::Point>> corners;
    std::vector<std::size_t> shares;
  };
  Waypoints waypoints() const;

 private:
  /// A planned way.
  struct Leg {
    std::vector<geom::Point> corners;
    double length = 0.0;
    /// What is seen from it, once that was asked for; only where walls hide something, since that takes long.
    mutable std::vector<SearchGrid::Run> seen = {};
  };
  struct Stop {
    geom::Point at;
    Leg onward;                        // to the next one; of a share's last one: empty
    bool is_last = true;               // of its share
    std::optional<Leg> shortcut = {};  // from the one before to the next, once that was planned
    double refused = kNotYet;          // the highest price at which nothing could be saved here

    static constexpr double kNotYet = -1.0;
  };
  using Place = std::list<Stop>::iterator;
  /// What may be given for a metre, and how many cells may be unseen then.
  struct Bargain {
    double price;
    std::size_t most_unseen;
  };
  /// Unseen cells that hang together.
  using Patch = std::vector<std::size_t>;
  /// Where a stop may be added, between two others or at an end of a share, and what that costs at least.
  struct Slot {
    Place before;  // in front of that
    bool has_leg_to;
    bool has_leg_from;
    double extra;  // [m]
  };
  /// A stop that may be added, and the legs to it and on from it.
  struct Detour {
    geom::Point at;
    Place before;
    std::optional<Leg> to, from;
    double extra = 0.0;    // [m]
    std::size_t gain = 0;  // cells

    double worth() const { return static_cast<double>(gain) / (std::max(extra, 0.0) + 1e-3); }
  };

  int column_of(std::size_t cell) const {
    return static_cast<int>(cell % static_cast<std::size_t>(grid_.columns()));
  }
  int row_of(std::size_t cell) const {
    return static_cast<int>(cell / static_cast<std::size_t>(grid_.columns()));
  }
  std::optional<Leg> leg(geom::Point a, geom::Point b);
  void see(const Leg& leg, int by);
  void see(const Detour& detour, int by);
  bool is_first(Place stop) const { return stop == stops_.begin() || std::prev(stop)->is_last; }
  void see_only_stop(int by);
  void end_share();
  void append(geom::Point at);
  void append(const LanePiece& piece);
  bool exchange(std::span<const Leg* const> old, std::span<const Leg* const> instead, const Bargain& bargain);
  const Leg* shortcut(Place stop);
  void has_changed(Place stop);
  bool leave_out(Place stop, const Bargain& bargain);
  bool leave_end_out(Place stop, const Bargain& bargain);
  bool draw_in(Place stop, const Bargain& bargain);
  std::vector<Patch> unseen_patches(std::size_t left_out) const;
  Patch unseen_round(int column, int row, std::vector<std::uint8_t>& was_met) const;
  void add_for(std::vector<Patch>& patches, std::size_t most_unseen);
  std::vector<geom::Point> candidates(const Patch& cells) const;
  std::optional<Detour> best_detour(const Patch& cells);
  std::optional<Detour> detour(geom::Point at);
  std::optional<Detour> detour(geom::Point at, const Slot& slot);
  void count_gain(Detour& detour);
  void insert(Detour& detour);
  geom::Point nearest(geom::Point p) const;
  void file_stops();
  void file(Place stop);
  std::size_t box_of(geom::Point p) const;
  template <class Visit>
  void each_stop_near(geom::Point p, const Visit& visit) const;
  bool is_tired() const { return effort() > most_effort_; }

  /// What the planner counts as one takes as long as so many stops.
  static constexpr std::uint64_t kStopsOfAnEffort = 10;
  SearchGrid& grid_;
  BendingPlanner& planner_;
  std::list<Stop> stops_;
  bool is_new_share_ = true;  // what is appended next begins one
  /// Stops by where they are, in square boxes; as they were when detours began to be added, and those added
  /// since.
  std::vector<std::vector<Place>> boxes_;
  int boxes_along_ = 0;
  int boxes_across_ = 0;
  std::uint64_t effort_ = 0;
  std::uint64_t most_effort_;
};

}  // namespace mlab::ways
