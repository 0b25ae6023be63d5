// Laws over generated configurations: flattening changes no value, the canonical layout changes nothing but
// layout, and a program made in memory equals the one made by way of CNL text, bit for bit.

#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mlab/lang/cdl/emit_cnl.h"
#include "mlab/lang/cdl/print/format.h"
#include "mlab/lang/cdl/print/print.h"
#include "mlab/lang/cdl/syntax/parser.h"
#include "mlab/lang/cnl/elaborate.h"
#include "mlab/lang/cnl/parser.h"
#include "mlab/robot/program/configuration_file.h"

namespace mlab::robot {
namespace {

/// Makes up configurations. The same movement is written twice: with calls of assemblages, and with their
/// bodies in the place of the calls.
class Author {
 public:
  explicit Author(std::uint64_t seed) : state_(seed * 2 + 1) {}

  struct TextPair {
    std::string with_calls;
    std::string inlined;
  };

  /// Both texts of one configuration.
  TextPair configuration() {
    TextPair out;
    const std::string head =
        "class Cart {\n  sensor bumper: DetectObstacles() binds sense_obstacles;\n"
        "  actuator wheels: Drive(max_velocity = 2 m/s) binds movement;\n}\n";
    const int count = 1 + pick(4);
    std::string declarations;
    for (int i = 0; i < count; ++i) {
      // What an assemblage does is written with its parameters' names, and filled in where it is inlined.
      const TextPair body = movement(3, {"vigor", "reach"}, true);
      declarations += fmt::format("assemblage A{}(vigor: gain, reach: length = 3 m) {{\n  {}\n}}\n", i,
                                  block(body.with_calls));
      bodies_.push_back(body.inlined);
    }
    const TextPair drive = movement(3, {"0.75", "2.5 m"}, true);
    const std::string tail =
        "robot R is Cart {{\n  let seen = sense_obstacles(range = 4 m);\n  movement = {};\n}}\n";
    out.with_calls = head + declarations + fmt::format(fmt::runtime(tail), drive.with_calls);
    out.inlined = head + fmt::format(fmt::runtime(tail), drive.inlined);
    return out;
  }

 private:
  struct Names {
    std::string strength;
    std::string reach;
  };

  int pick(int below) {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<int>((state_ >> 33U) % static_cast<std::uint64_t>(below));
  }
  std::string number() { return fmt::format("{}.{}", pick(3), pick(100)); }
  std::string strength(const Names& names) { return pick(2) == 0 ? names.strength : number(); }
  std::string reach(const Names& names) {
    return pick(2) == 0 ? names.reach : number() + (pick(2) == 0 ? " m" : "0 m");
  }

  static std::string block(const std::string& text) { return text.ends_with('}') ? text : text + ";"; }

  static std::string replaced(std::string text, const std::string& name, const std::string& value) {
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + value.size()))
      text.replace(at, name.size(), value);
    return text;
  }

  TextPair primitive(const Names& names) {
    const std::string sphere = reach(names);
    std::string text;
    switch (pick(4)) {
      case 0:
        text = fmt::format("Noise(persistence = {} s)", number());
        break;
      case 1:
        text = fmt::format("AvoidStaticObstacles(sense_obstacles(range = {}), sphere = {})", reach(names),
                           sphere);
        break;
      case 2:
        text = fmt::format("MoveForward(amount = {})", strength(names));
        break;
      default:
        text = fmt::format("delay(SwirlObstacles(sense_obstacles(), sphere = {}))", sphere);
    }
    return {text, text};
  }

  // `is_named`: where it stands, it is called by something else than its own name.
  TextPair call(const Names& names, bool is_named) {
    const int which = pick(static_cast<int>(bodies_.size()));
    const std::string strong = strength(names);
    const std::string far = reach(names);
    TextPair out;
    out.with_calls = fmt::format("A{}({}, reach = {})", which, strong, far);
    out.inlined =
        replaced(replaced(bodies_[static_cast<std::size_t>(which)], "vigor", "\x01"), "reach", "\x02");
    out.inlined = replaced(replaced(out.inlined, "\x01", strong), "\x02", far);
    if (!is_named) out.inlined = fmt::format("({}) as A{}", out.inlined, which);
    return out;
  }

  std::string trigger() {
    switch (pick(5)) {
      case 0:
        return fmt::format("Wait(delay = {} s)", number());
      case 1:
        return "IsHalted()";
      case 2:
        return fmt::format("not Detect(Flag, range = {} m)", number());
      case 3:
        return fmt::format("MovedDistance(distance = {} m) and not IsHalted()", number());
      default:
        return fmt::format("(IsHalted() or Wait(delay = {} s))", number());
    }
  }

  TextPair members(const char* head, bool has_weights, int depth, const Names& names) {
    TextPair out{std::string(head) + " {", std::string(head) + " {"};
    const int count = 1 + pick(3);
    for (int i = 0; i < count; ++i) {
      const std::string weight = has_weights && pick(3) > 0 ? strength(names) + ": " : "";
      const TextPair member = movement(depth - 1, names);
      out.with_calls += " " + weight + member.with_calls + ";";
      out.inlined += " " + weight + member.inlined + ";";
    }
    out.with_calls += " }";
    out.inlined += " }";
    return out;
  }

  TextPair sequence(int depth, const Names& names) {
    TextPair out{"sequence {", "sequence {"};
    const int count = 1 + pick(3);
    for (int i = 0; i < count; ++i) {
      const TextPair member = movement(depth - 1, names, true);
      const std::string head = fmt::format(" {}S{}: ", i == 0 ? "start " : "", i);
      const std::string tail =
          fmt::format("; when {} goto S{}{};", trigger(), (i + 1) % count, pick(2) == 0 ? "" : " restart");
      out.with_calls += head + member.with_calls + tail;
      out.inlined += head + member.inlined + tail;
    }
    out.with_calls += " }";
    out.inlined += " }";
    return out;
  }

  TextPair select(int depth, const Names& names) {
    const TextPair one = movement(depth - 1, names, true);
    const TextPair other = movement(depth - 1, names, true);
    const auto text = [](const std::string& a, const std::string& b) {
      return fmt::format("select by GetOrderTask() {{ case MoveTo, Follow: {}; otherwise: {}; }}", a, b);
    };
    return {text(one.with_calls, other.with_calls), text(one.inlined, other.inlined)};
  }

  TextPair movement(int depth, const Names& names, bool is_named = false) {
    if (depth <= 0) return primitive(names);
    switch (pick(bodies_.empty() ? 6 : 9)) {
      case 0:
        return members("cooperate", true, depth, names);
      case 1:
        return members("compete by priority", false, depth, names);
      case 2:
        return members("compete by strength", true, depth, names);
      case 3:
        return sequence(depth, names);
      case 4:
        return select(depth, names);
      case 5:
        return primitive(names);
      default:
        return call(names, is_named);
    }
  }

  std::uint64_t state_;
  std::vector<std::string> bodies_;
};

text::SourcePtr source(const std::string& text) {
  return std::make_shared<const text::Source>("a.cdl", text);
}

std::optional<ConfiguredRobot> configured(const std::string& text) {
  text::Diagnostics sink;
  auto robot = configure(source(text), "", "R", {}, {}, sink);
  if (!robot) ADD_FAILURE() << text::render(sink) << text;
  return robot;
}

/// A world that changes from cycle to cycle.
std::vector<std::byte> run(const flow::Program& program, std::uint64_t seed) {
  flow::Frame frame = program.make_frame();
  percept::Percepts percepts;
  percept::Action action;
  for (int cycle = 0; cycle < 60; ++cycle) {
    const double phase = 0.1 * cycle;
    const percept::Obstacle obstacles[] = {{{1.0 + phase, 0.5, 0.0}, 0.2}, {{-2.0, phase, 0.0}, 0.4}};
    percepts.time = phase;
    percepts.pose.position = {phase, 0.5 * phase};
    percepts.obstacles = std::span(obstacles).first(static_cast<std::size_t>(cycle % 3));
    percepts.order.halted = cycle % 7 > 4;
    percepts.order.task = cycle % 20 > 10 ? percept::Task::kMoveTo : percept::Task::kNone;
    action = {};
    program.step(frame.data(), percepts, action, seed, 1);
  }
  return {frame.data(), frame.data() + program.frame_size()};
}

RC_GTEST_PROP(GeneratedConfigurations, MeanTheSameWhenTheirAssemblagesAreWrittenOut, (std::uint64_t seed)) {
  const Author::TextPair written = Author(seed).configuration();
  const auto with_calls = configured(written.with_calls);
  const auto inlined = configured(written.inlined);
  RC_ASSERT(with_calls && inlined);
  RC_ASSERT(cdl::cnl_text(with_calls->lowered.network) == cdl::cnl_text(inlined->lowered.network));
  RC_ASSERT(run(*with_calls->built.program, seed) == run(*inlined->built.program, seed));
}

RC_GTEST_PROP(GeneratedConfigurations, GiveTheSameValuesInMemoryAndByWayOfCnl, (std::uint64_t seed)) {
  const auto robot = configured(Author(seed).configuration().with_calls);
  RC_ASSERT(robot.has_value());
  const std::string cnl = cdl::cnl_text(robot->lowered.network);
  text::Diagnostics sink;
  const flow::Network network = cnl::elaborate(cnl::parse(source(cnl), sink), sink);
  const auto program = flow::build_program(network, component_library(), sink);
  RC_ASSERT(program != nullptr);
  RC_ASSERT(!sink.has_errors());
  RC_ASSERT(network.name == robot->lowered.network.name);
  RC_ASSERT(cdl::cnl_text(network) == cnl);
  RC_ASSERT(run(*program, seed) == run(*robot->built.program, seed));
}

RC_GTEST_PROP(GeneratedConfigurations, SurviveTheCanonicalLayoutAndThePrinter, (std::uint64_t seed)) {
  const std::string text = Author(seed).configuration().with_calls;
  text::Diagnostics sink;
  const std::string printed = cdl::print(cdl::parse(source(text), sink));
  const std::string laid_out = cdl::laid_out(text);
  RC_ASSERT(cdl::laid_out(laid_out) == laid_out);
  RC_ASSERT(cdl::laid_out(printed) == printed);
  RC_ASSERT(cdl::print(cdl::parse(source(laid_out), sink)) == printed);
  RC_ASSERT(cdl::print(cdl::parse(source(printed), sink)) == printed);
  RC_ASSERT(!sink.has_errors());
}

}  // namespace
}  // namespace mlab::robot
