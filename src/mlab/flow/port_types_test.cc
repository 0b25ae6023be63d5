#include "mlab/flow/port_types.h"

#include <gtest/gtest.h>

#include "mlab/flow/library.h"

namespace mlab::flow {
namespace {

template <class T>
bool parses(std::string_view text, T& out) {
  return type_info<T>().parse(text, &out);
}

TEST(PortTypes, ReadConstantsAsNetworksWriteThem) {
  double d = 0.0;
  EXPECT_TRUE(parses("(.5)", d));
  EXPECT_DOUBLE_EQ(d, 0.5);
  EXPECT_TRUE(parses("{5.0}", d));
  EXPECT_DOUBLE_EQ(d, 5.0);
  EXPECT_FALSE(parses("5 m", d));
  EXPECT_FALSE(parses("inf", d));
  EXPECT_FALSE(parses("", d));
  bool b = false;
  EXPECT_TRUE(parses("TRUE", b));
  EXPECT_TRUE(b);
  int i = 0;
  EXPECT_TRUE(parses("-3", i));
  EXPECT_EQ(i, -3);
  EXPECT_FALSE(parses("2.5", i));
  geom::Vector v;
  EXPECT_TRUE(parses("{1, 2}", v));
  EXPECT_EQ(v, (geom::Vector{1, 2, 0}));
  EXPECT_FALSE(parses("{1, 2, 3, 4}", v));
}

TEST(PortTypes, ReadChoicesAndMasksByTheirWords) {
  percept::Formation f{};
  EXPECT_TRUE(parses("column", f));
  EXPECT_EQ(f, percept::Formation::kColumn);
  ObjectClasses c;
  EXPECT_TRUE(parses("Flag | Basket", c));
  EXPECT_EQ(c.bits, 0b1100U);
  EXPECT_TRUE(c.has(percept::ObjectClass::kBasket));
  EXPECT_FALSE(parses("Flag|Banana", c));
  EXPECT_EQ(type_info<ObjectClasses>().print(&c), "Flag|Basket");
  percept::FormationReference r{};
  EXPECT_TRUE(parses("leader", r));
  EXPECT_EQ(r, percept::FormationReference::kLeader);
}

TEST(PortTypes, ListsAreShownByHowMuchIsInThem) {
  Obstacles list;
  EXPECT_EQ(type_info<Obstacles>().print(&list), "0 readings");
  list.count = 1;
  EXPECT_EQ(type_info<Obstacles>().print(&list), "1 reading");
}

TEST(PortTypes, ATextThatIsTooLongIsRefusedNotCut) {
  Text t;
  EXPECT_TRUE(t.assign("short"));
  EXPECT_FALSE(t.assign(std::string(64, 'x')));
  EXPECT_EQ(t.view(), "short");
}

TEST(Library, KnowsHistoricTypeNames) {
  const Library library;
  EXPECT_EQ(library.find_type("obs_array"), library.find_type("Obstacles"));
  EXPECT_EQ(library.find_type("boolean"), library.find_type("bool"));
  EXPECT_EQ(library.find_type("nonsense"), nullptr);
}

}  // namespace
}  // namespace mlab::flow
