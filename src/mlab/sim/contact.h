#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "mlab/binding/slide.h"
#include "mlab/binding/workers.h"
#include "mlab/sim/bodies.h"
#include "mlab/sim/clear_place.h"
#include "mlab/sim/point_grid.h"
#include "mlab/sim/statics.h"

namespace mlab::sim {

using binding::Blocker;
using binding::Blockers;
using binding::Workers;

/// Moves bodies as far as what is in their way allows.
///
/// A cycle has a few rounds. In each, a body that touches something slides: its motion loses what goes
/// against the thing. Then all motions run at the same time, straight, until something is met (a body that is
/// met by another head on stops, too). What is left of a motion is for the next round. Every round begins and
/// ends without overlap, so a round can be the last.
///
/// Roamers stop for nobody: a body stops where it would drive into one, and is run over where one comes to
/// it. It stays where it is, and may go on in any direction but deeper into it.
class ContactSolver {
 public:
  /// A roamer and its way in this cycle, which is straight.
  struct Passing {
    geom::Point from;
    geom::Offset step;
    double radius;

    geom::Point at(double share) const { return from + step * share; }
  };
  /// What the bodies move among, and when.
  struct Surroundings {
    const Statics& statics;
    const PointGrid& grid;  ///< of the bodies, where they stand at the beginning
    Box area;               ///< that bodies which are `held` stay in; others stay in kWholeWorld
    double time;            ///< at the end of the cycle [s]
    double dt;              ///< [s]
    std::span<const Passing> roamers = {};
    std::span<const Apart> apart = {};  ///< by body; empty: nobody has looked
  };

  /// Makes room for so many bodies.
  void resize(std::size_t count);
  /// Where the motion of each body goes before move() [m]; of absent bodies zero.
  std::span<geom::Offset> motions() { return motion_; }
  /// Moves the bodies by their motions; counts contacts, adds up distances, mends momenta.
  void move(Bodies& bodies, const Surroundings& surroundings, Workers& workers);

 private:
  static constexpr std::size_t kNear = 12;
  static constexpr std::uint8_t kTooMany = 255;
  /// Bodies that this one might meet in this cycle. Where there are more, they are looked up in the grid each
  /// time.
  struct NearList {
    std::array<std::uint32_t, kNear> body;
  };
  /// A body that goes far in this cycle, and where it stood at its beginning.
  struct Fast {
    std::uint32_t body;
    double x, y;
  };
  /// A body that something may be in the way of.
  struct Busy {
    std::uint32_t body = 0;
    geom::Point start;    ///< of the cycle
    geom::Offset wanted;  ///< in this round [m]
    geom::Offset slid;    ///< what becomes of it; goes to motion_ when all are done
    double until = 1.0;   ///< goes to until_ when all are done
    Thing stopped_by = kNoThing;
    double gone = 0.0;      ///< share of the cycle that is over
    bool is_moving = true;  ///< in this round
    bool touches_bodies = false;
    std::array<Thing, 6> met{};  ///< in this cycle
    std::uint8_t met_count = 0;

    void meet(Thing thing);
  };

  void sort_by_speed(const Bodies& bodies);
  void collect_busy(Bodies& bodies, const Surroundings& s, Workers& workers);
  bool is_apart(const Bodies& bodies, const Surroundings& s, std::uint32_t body) const;
  bool has_company(const Bodies& bodies, const Surroundings& s, std::uint32_t body);
  bool may_meet_standing(const Bodies& bodies, const Surroundings& s, std::uint32_t body);
  /// Calls visit(other) for all bodies that this one might meet in this cycle, by where all stood at its
  /// beginning.
  template <class Visit>
  void search_near(const Bodies& bodies, const Surroundings& s, std::uint32_t body, geom::Point start,
                   Visit&& visit) const;
  /// The same from the list where there is one.
  template <class Visit>
  void for_each_near(const Bodies& bodies, const Surroundings& s, const Busy& busy, Visit&& visit) const;

  void move_busy(Bodies& bodies, const Surroundings& s, Workers& workers);
  bool run_round(Bodies& bodies, const Surroundings& s, Workers& workers);
  void slide_all(const Bodies& bodies, const Surroundings& s, Workers& workers);
  void slide_one(const Bodies& bodies, const Surroundings& s, Busy& busy, bool is_first);
  void stop_at_statics(const Bodies& bodies, const Surroundings& s, Busy& busy);
  void stop_at_bodies(const Bodies& bodies, const Surroundings& s, Workers& workers);
  void stop_one(const Bodies& bodies, const Surroundings& s, Busy& busy, bool gives_up) const;
  bool advance(Bodies& bodies, const Surroundings& s, Busy& busy);
  void note_run_over(const Surroundings& s, std::uint32_t body, double radius, geom::Point from,
                     geom::Offset motion, double gone, double until);
  void count_contacts(Bodies& bodies, const Surroundings& s);
  void count_run_over(Bodies& bodies, const Surroundings& s);

  std::vector<geom::Offset> motion_;  ///< by body; in the present round [m]
  std::vector<double> way_;           ///< by body; length of the whole cycle's motion [m]
  std::vector<double> until_;         ///< by body; share of the motion that it may go, 0 .. 1
  std::vector<std::uint8_t> near_count_;
  std::vector<std::uint8_t> is_busy_;
  std::vector<std::uint8_t> changed_;  ///< by body: until_ fell in the last pass
  std::vector<NearList> near_;
  std::vector<ClearPlace> clear_;  ///< by body
  std::vector<Busy> busy_;
  std::vector<std::pair<std::uint32_t, Thing>> run_over_;  ///< body and roamer, in this cycle
  std::vector<Fast> fast_;                                 ///< ascending
  double slow_limit_ = 0.0;                                ///< who goes farther is fast [m]
  double slow_way_ = 0.0;                                  ///< longest way of those that are not fast [m]
  double longest_way_ = 0.0;                               ///< of all [m]
};

}  // namespace mlab::sim
