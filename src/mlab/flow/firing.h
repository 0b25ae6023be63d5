#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "mlab/flow/behavior.h"

/// What the code that the CNL compiler makes stands on: inputs out of the frame, state in the frame.

namespace mlab::flow {

/// A procedure's view of a value of type T (see `view`).
template <class T>
using ViewOf =
    std::remove_cvref_t<decltype(view(std::declval<const T&>(), std::declval<const percept::Percepts&>()))>;

/// A list input as procedures see it: by position, in the order of the links; readings as views of this
/// cycle.
template <class T>
class InputList {
 public:
  InputList(ListInput<T> values, const percept::Percepts& percepts) : values_(values), percepts_(&percepts) {}
  std::size_t size() const { return values_.size(); }
  bool empty() const { return size() == 0; }
  decltype(auto) operator[](std::size_t i) const { return view(values_[i], *percepts_); }

  class Iterator {
   public:
    Iterator(const InputList* list, std::size_t at) : list_(list), at_(at) {}
    decltype(auto) operator*() const { return (*list_)[at_]; }
    Iterator& operator++() { return ++at_, *this; }
    friend bool operator==(Iterator, Iterator) = default;

   private:
    const InputList* list_;
    std::size_t at_;
  };
  Iterator begin() const { return {this, 0}; }
  Iterator end() const { return {this, size()}; }

 private:
  ListInput<T> values_;
  const percept::Percepts* percepts_;
};

/// The next input of a call; `next` walks along `Call::inputs`.
template <class T>
decltype(auto) take(const Call& call, const std::uint32_t*& next) {
  return view(call.at<const T>(*next++), *call.cycle->percepts);
}
template <class T>
InputList<T> take_list(const Call& call, const std::uint32_t*& next) {
  const std::uint32_t count = *next++;
  const std::uint32_t* offsets = next;
  next += count;
  return {ListInput<T>(call.frame, offsets, count), *call.cycle->percepts};
}

/// What a function returns.
template <class R, class... A>
R result_of(R(A...));
template <class Function>
using Result = decltype(result_of(std::declval<Function&>()));

/// References to everything it is called with; gives the types of what a `once` section keeps.
struct Tie {
  template <class... T>
  std::tuple<T&...> operator()(T&... values) const {
    return {values...};
  }
};
inline constexpr Tie tie{};

/// True for types of ours and of the standard library that copy well and still point at something of this
/// cycle.
template <class T>
inline constexpr bool is_view = false;
template <class T>
inline constexpr bool is_view<ListView<T>> = true;
template <class T>
inline constexpr bool is_view<InputList<T>> = true;
template <class T, std::size_t kExtent>
inline constexpr bool is_view<std::span<T, kExtent>> = true;
template <class T>
inline constexpr bool is_view<std::basic_string_view<T>> = true;
template <>
inline constexpr bool is_view<percept::Percepts> = true;
template <>
inline constexpr bool is_view<percept::Order> = true;

/// True for what may be state: it copies byte by byte, and it is neither a pointer, nor a reference, nor a
/// view.
template <class T>
inline constexpr bool is_state =
    std::is_trivially_copyable_v<std::remove_all_extents_t<T>> &&
    !std::is_pointer_v<std::remove_all_extents_t<T>> && !std::is_reference_v<T> &&
    !is_view<std::remove_cv_t<std::remove_all_extents_t<T>>>;

/// Room in a node's state for a value that is made when the node first fires or restarts.
template <class T>
struct Slot {
  alignas(T) std::byte bytes[sizeof(T)];

  void put(const T& value) { ::new (static_cast<void*>(bytes)) T(value); }
  T& get() { return *std::launder(reinterpret_cast<T*>(bytes)); }
};

template <class T>
void write_initial(void* out) {
  ::new (out) T{};
}

}  // namespace mlab::flow
