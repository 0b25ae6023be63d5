#pragma once

#include <functional>
#include <type_traits>

namespace mlab::console {

/// What rows of a table of messages are made of. Such a table is a `switch` over the cases of a oneof,
/// without `default:`: a message that nobody takes does not compile.
///
/// @tparam Core     has the parts that take messages
/// @tparam Sender   who sent the message
/// @tparam Message  has the oneof
/// @tparam Reply    what it is answered
/// @tparam Outcome  what taking a message comes to; where a function says nothing of it, `Outcome{}`
template <class Core, class Sender, class Message, class Reply, class Outcome>
struct OrderTable {
  using Take = Outcome (*)(Core& core, const Sender& sender, const Message& message, Reply& reply);

  /// A part of the core takes what the message holds.
  /// @tparam kTake     function of the part, of any of the sender, what the message holds, and the reply, in
  ///                   this order
  /// @tparam kContent  of the message: what it holds
  template <auto kTake, auto kContent, auto kPart>
  static Outcome taken(Core& core, const Sender& sender, const Message& message, Reply& reply) {
    return handed(core.*kPart, kTake, sender, (message.*kContent)(), reply);
  }

  /// The core itself does.
  template <auto kTake, auto kContent>
  static Outcome taken_whole(Core& core, const Sender& sender, const Message& message, Reply& reply) {
    return handed(core, kTake, sender, (message.*kContent)(), reply);
  }

  /// The message has done what it is for before it is looked up.
  static Outcome taken_before(Core& /*core*/, const Sender& /*anybody*/, const Message& /*no more is said*/,
                              Reply& /*says nothing*/) {
    return Outcome{};
  }

 private:
  template <class Part, class Function, class Content>
  static Outcome handed(Part& part, Function take, const Sender& sender, const Content& content,
                        Reply& reply) {
    const auto call = [&](auto&... what) -> Outcome {
      if constexpr (std::is_void_v<std::invoke_result_t<Function, Part&, decltype(what)...>>) {
        std::invoke(take, part, what...);
        return Outcome{};
      } else {
        return std::invoke(take, part, what...);
      }
    };
    if constexpr (std::is_invocable_v<Function, Part&, const Sender&, const Content&, Reply&>)
      return call(sender, content, reply);
    else if constexpr (std::is_invocable_v<Function, Part&, const Content&, Reply&>)
      return call(content, reply);
    else if constexpr (std::is_invocable_v<Function, Part&, const Sender&, const Content&>)
      return call(sender, content);
    else if constexpr (std::is_invocable_v<Function, Part&, const Content&>)
      return call(content);
    else if constexpr (std::is_invocable_v<Function, Part&, const Sender&>)
      return call(sender);
    else
      return call(reply);
  }
};

}  // namespace mlab::console
