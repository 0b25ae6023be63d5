#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mlab::flow {

class Program;
struct Port;

/// What a person makes one robot's program do against what it computes: outputs of nodes are held at values,
/// sequences go to states. Belongs to the program's frame, and is handed over with it, byte by byte.
///
/// A node whose output is held fires as ever, and goes on from what it computed itself; who reads its output
/// sees the held value. A sequence that is made to go to a state asks none of its triggers in that cycle.
class Interventions {
 public:
  static constexpr std::size_t kMostHeld = 16;
  static constexpr std::size_t kMostForced = 8;
  static constexpr std::size_t kLargest = 64;  ///< value that can be held [bytes]

  /// Why the port can't be held at any value, as a sentence; nothing: it can.
  static std::optional<std::string> why_never_held(const Program& program, const Port& port);

  struct Held {
    std::uint32_t port = 0;  ///< index in Program::ports
    std::uint32_t offset = 0;
    std::uint32_t size = 0;
    alignas(8) std::array<std::byte, kLargest> value{};
    alignas(8) std::array<std::byte, kLargest> computed{};  ///< by the node when it fired last
  };
  struct Forced {
    std::uint32_t sequence = 0;
    std::uint32_t state = 0;
    bool was_done = false;  ///< the sequence ran in that cycle
  };

  /// In the coming cycle the sequence goes to the state; to the one in which it is: restarts it.
  /// @errors  a sentence that says why not; nothing has changed
  std::optional<std::string> force(const Program& program, const std::byte* frame, std::string_view sequence,
                                   std::string_view state);
  /// From the coming cycle on, who reads the output sees the value; instead of that before, where it is held.
  /// @param value  as a person writes it, in the port's edge_unit
  /// @errors  a sentence that says why not: as `why_never_held`, it is no such value; nothing has changed
  std::optional<std::string> hold(const Program& program, const std::byte* frame, std::string_view port,
                                  std::string_view value);
  /// The output is again what its node computes, at once what it has computed last.
  /// @param port  empty: all
  /// @errors  a sentence: it is not held
  std::optional<std::string> release(const Program& program, std::byte* frame, std::string_view port);

  std::span<const Held> held() const { return {held_.data(), held_count_}; }
  /// In the cycle that ran last.
  std::span<const Forced> forced() const { return {last_.data(), last_count_}; }
  bool is_empty() const { return held_count_ + coming_count_ + last_count_ == 0; }

  /// A cycle is over: what was to be forced has been.
  void finish();
  /// The frame is another one of the same program; nothing is to be forced any more.
  void begin_anew(const std::byte* frame);
  /// Something that is left out where the program is exchanged.
  struct Lost {
    std::string path;  ///< of the port or sequence
    std::string why;   ///< behind the path: `is not held any more: ...`
  };
  /// What a frame is without them: outputs are what their nodes have computed.
  void let_go(std::byte* frame) const;
  /// These of a robot whose program is exchanged, for the program after; what that has no place for is left
  /// out.
  /// @param before_frame   of the program before, with held values; null: it is not to be trusted
  /// @param frame          that goes on, made from what `let_go` left
  /// @param has_same_code  as flow::carry_over
  std::vector<Lost> carry_over(const Program& before, const std::byte* before_frame, const Program& after,
                               std::byte* frame, bool has_same_code);
  /// Whether these bytes, from wherever, are interventions of the program; else they must not be used.
  bool are_of(const Program& program) const;
  /// What a process that is not trusted has noted of its cycle. These went to it.
  void take_notes_of(const Interventions& other);

  // ---- for Program::step

  /// Null: it is not.
  Held* held_at(std::uint32_t offset) {
    for (std::uint32_t i = 0; i < held_count_; ++i) {
      if (held_[i].offset == offset) return &held_[i];
    }
    return nullptr;
  }
  /// Where the sequence has to go in the coming cycle; null: where it wants.
  Forced* coming(std::uint32_t sequence) {
    for (std::uint32_t i = 0; i < coming_count_; ++i) {
      if (coming_[i].sequence == sequence) return &coming_[i];
    }
    return nullptr;
  }
  const Forced* coming(std::uint32_t sequence) const {
    return const_cast<Interventions*>(this)->coming(sequence);
  }

 private:
  std::optional<std::string> why_not_held(const Port* mine, const Port& theirs, const Held& held,
                                          const Program& after, bool has_same_code);

  std::uint32_t held_count_ = 0;
  std::uint32_t coming_count_ = 0;
  std::uint32_t last_count_ = 0;
  std::array<Held, kMostHeld> held_;
  std::array<Forced, kMostForced> coming_;
  std::array<Forced, kMostForced> last_;
};

}  // namespace mlab::flow
