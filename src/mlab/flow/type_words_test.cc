#include "mlab/flow/type_words.h"

#include <string>

#include <gtest/gtest.h>

#include "mlab/flow/port_types.h"

namespace mlab::flow {
namespace {

template <class T>
std::string said() {
  return noun_of(type_info<T>()) + ": " + expected_of(type_info<T>());
}

TEST(TypeWords, AreThoseOfUsers) {
  EXPECT_EQ(said<double>(), "number: a number");
  EXPECT_EQ(said<int>(), "whole number: a whole number");
  EXPECT_EQ(said<bool>(), "truth value: true or false");
  EXPECT_EQ(said<geom::Vector>(), "vector: two or three numbers, as {1, 2}");
  EXPECT_EQ(said<geom::Point>(), "place: two numbers, as {1, 2}");
  EXPECT_EQ(said<Text>(), "text that is short enough: a text of at most 63 bytes");
  EXPECT_EQ(said<percept::FormationReference>(), "formation reference: one of unit-center, leader, neighbor");
  EXPECT_TRUE(said<ObjectClasses>().starts_with("set of object classes: one or several of "));
}

// What is offered is taken.
template <class T>
void expect_takes_all_its_words() {
  for (const std::string_view word : type_info<T>().words) {
    T value{};
    EXPECT_TRUE(type_info<T>().parse(word, &value)) << word;
    EXPECT_NE(expected_of(type_info<T>()).find(word), std::string::npos) << word;
  }
}

TEST(TypeWords, OfferWhatIsTaken) {
  expect_takes_all_its_words<percept::Formation>();
  expect_takes_all_its_words<percept::FormationReference>();
  expect_takes_all_its_words<percept::Task>();
  expect_takes_all_its_words<ObjectClasses>();
  geom::Vector vector;
  EXPECT_TRUE(type_info<geom::Vector>().parse("{1, 2}", &vector));
  geom::Point point;
  EXPECT_TRUE(type_info<geom::Point>().parse("{1, 2}", &point));
}

}  // namespace
}  // namespace mlab::flow
