#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "mlab/percept/action.h"
#include "mlab/sim/bodies.h"
#include "mlab/sim/point_grid.h"
#include "mlab/sim/world.h"

namespace mlab::sim {

/// The objects of the world, and what robots do with them.
class Objects {
 public:
  /// @param travels  of some of them
  Objects(std::vector<Object> objects, std::span<const Travel> travels);

  std::span<const Object> list() const { return list_; }
  /// Carries out the requests of one body that concern objects. Who asks first gets the object.
  void carry_out(const percept::Action& action, Bodies& bodies, std::uint32_t body);
  /// Puts down what the body carries, where it stands.
  void drop(Bodies& bodies, std::uint32_t body);
  /// Carried objects go where their carriers went.
  void follow(const Bodies& bodies);
  /// Those that have a course are where they are at that time, with what lies in them.
  void travel(double time);
  /// Other objects than before; `were` holds the id that each had up to now, 0 for a new one. What stays
  /// keeps its place, carrier and basket; what somebody took up travels no more.
  void replace(std::vector<Object> objects, std::span<const Travel> travels,
               std::span<const base::ObjectId> were, Bodies& bodies);
  std::uint32_t count_in(base::ObjectId container) const;

  /// Sorts those that can be seen into the grid; to be called before visit_visible.
  void refresh();
  /// Until then it takes up no memory for them.
  void forget_grid();
  /// Calls visit(index, object) for all visible objects with their centre in the box, and some others.
  template <class Visit>
  void visit_visible(const Box& box, Visit&& visit) const {
    grid_.visit(box, [&](const PointGrid::Item& item) { visit(item.id, list_[item.id]); });
  }

 private:
  void pick_up(const percept::Request& request, Bodies& bodies, std::uint32_t body);
  void mark(const percept::Request& request, const Bodies& bodies, std::uint32_t body);
  void drop_in_basket(const percept::Request& request, Bodies& bodies, std::uint32_t body);
  Object* find(base::ObjectId id);
  void send_off(std::span<const Travel> travels);

  struct Traveller {
    std::uint32_t object = 0;  ///< index
    std::shared_ptr<const overlay::Course> course;
  };

  std::vector<Object> list_;
  std::vector<Traveller> travellers_;  ///< those that nobody took up
  std::vector<base::ObjectId> taken_;  ///< those that travelled before
  PointGrid grid_;
  std::vector<PointGrid::Item> visible_;  ///< while the grid is built
  bool is_stale_ = true;
};

/// From the surface of a body to that of an object [m]; less than 0 where they overlap.
double edge_distance(const Bodies& bodies, std::uint32_t body, const Object& object);

}  // namespace mlab::sim
