#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "mlab/flow/interventions.h"
#include "mlab/percept/percepts.h"
#include "mlab/robot/wire/mapping.h"
#include "mlab/robot/wire/shared_cycle.h"

namespace mlab::robot_host {

/// The run's side of the memory that it shares with a robot program (robot/wire/shared_cycle.h). It outlives
/// the program's process: one that takes its place goes on with it.
class SharedMemory {
 public:
  /// @param frame_size  of the program [bytes]
  /// @errors  what the system says
  static std::expected<SharedMemory, std::string> make(std::size_t frame_size);

  SharedMemory(SharedMemory&& other) noexcept;
  SharedMemory& operator=(SharedMemory&&) = delete;
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;
  ~SharedMemory();

  /// What the program gets: the second can't be written through.
  int frames_file() const { return frames_file_; }
  int percepts_file() const { return percepts_for_reading_; }

  /// For a process that is to begin with the cycle after this one: whatever another one left there is
  /// forgotten.
  void begin_anew(std::uint32_t cycle);
  robot_wire::Control& control() { return *reinterpret_cast<robot_wire::Control*>(frames_.begin()); }

  /// Makes room for so many robots. False: the machine has none; what was there stays.
  bool make_room(std::size_t places);
  robot_wire::PlaceHeader& header(std::size_t place);
  std::byte* frame(std::size_t place) { return reinterpret_cast<std::byte*>(&header(place) + 1); }
  std::size_t frame_size() const { return frame_size_; }
  /// Behind the frame.
  flow::Interventions& interventions(std::size_t place) {
    return *robot_wire::interventions_of(frame(place), frame_size_);
  }

  /// Forgets all percepts.
  void clear_percepts();
  /// Copies percepts to where the program reads them. May be called from several threads.
  /// @return  for PlaceHeader::percepts
  std::uint64_t add_percepts(const percept::Percepts& percepts);
  /// Whether the program can read all that were added; `finish_percepts` sees to it.
  bool has_all_percepts() const { return !has_overflow_.load(std::memory_order_acquire); }
  /// Before the program is asked for the last. False: the machine has no room for all percepts.
  bool finish_percepts();

 private:
  SharedMemory() = default;

  std::size_t frame_size_ = 0;
  int frames_file_ = -1;
  int percepts_file_ = -1;
  int percepts_for_reading_ = -1;
  robot_wire::Mapping frames_;
  robot_wire::Mapping percepts_;
  std::atomic<std::uint64_t> next_ = 0;  // free byte of the percepts
  std::mutex overflow_mutex_;
  std::atomic<bool> has_overflow_ = false;
  std::map<std::uint64_t, std::vector<std::byte>> overflow_;  // what lies behind the end until it is moved
};

}  // namespace mlab::robot_host
