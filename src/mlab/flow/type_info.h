#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace mlab::flow {

/// What a value looks like from outside (sliders, plots, reports, constants in networks).
enum class TypeKind : std::uint8_t {
  kBool,
  kInteger,
  kReal,
  kVector,
  kPoint,
  kPose,
  kText,
  kChoice,
  kMask,
  kList,
  kOther
};

/// A type of values that flow on wires. One per name in a process; values are trivially copyable and hold no
/// pointer, so that a frame may be copied byte by byte.
struct TypeInfo {
  std::string_view name;  ///< as CNL and CDL write it
  TypeKind kind = TypeKind::kOther;
  std::uint32_t size = 0;
  std::uint32_t alignment = 1;
  /// Reads a constant as CNL writes it (`0.5`, `{1, 2}`, `Column`, `true`), without quotes. False: it is none
  /// of this type, and `out` is unchanged. Null: the type has no constants.
  bool (*parse)(std::string_view text, void* out) = nullptr;
  /// The value for a person, and so that `parse` reads it back where there is a `parse`.
  std::string (*print)(const void* value) = nullptr;
  /// False where some number in it is NaN or infinite. Null: has no such number.
  bool (*is_finite)(const void* value) = nullptr;
  /// Of a truth or a choice: what its values are called, by their numbers; of a mask, by its bits.
  std::span<const std::string_view> words = {};
};

/// Specialise for a type to let it flow: `static const TypeInfo& info();`
template <class T>
struct PortTraits;

template <class T>
const TypeInfo& type_info() {
  static_assert(std::is_trivially_copyable_v<T>,
                "values on wires are copied byte by byte: no pointers, no containers");
  return PortTraits<T>::info();
}

/// Types from different shared libraries are the same when they have the same name and size.
inline bool same_type(const TypeInfo& a, const TypeInfo& b) {
  return &a == &b || (a.name == b.name && a.size == b.size);
}

}  // namespace mlab::flow
