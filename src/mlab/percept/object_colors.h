#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "mlab/percept/percepts.h"

namespace mlab::percept {

/// The colour that marks a class of objects, in small letters: `orange`, `dark sea green`.
std::string_view color_of(ObjectClass object_class);

/// The class that a colour marks: letter case, blanks, `-` and `_` aside. None where no class has it.
std::optional<ObjectClass> object_class_of_color(std::string_view color);

/// All of them, for people: `orange, red, ...`.
std::string colors_of_classes();

}  // namespace mlab::percept
