#pragma once

#include <set>
#include <string>
#include <vector>

#include "mlab/lang/cdl_historic/converter.h"

namespace mlab::cdl_historic {

/// Finds the robots of a historic file and says them in our language.
class Robots {
 public:
  explicit Robots(Converter& converter, std::string file_stem)
      : converter_(converter), file_stem_(std::move(file_stem)) {}

  /// Everything in the configuration, which is the last expression of the file.
  void add_configuration(const Expr& root);
  /// A robot that stands outside of the configuration, or a binding point without a robot.
  void add(const Expr& expr, const Spot& spot);

  std::vector<cdl::RobotClass>& classes() { return classes_; }
  std::vector<cdl::Robot>& robots() { return robots_; }
  std::vector<cdl::Society>& societies() { return societies_; }
  /// What the configuration holds besides robots.
  const std::vector<const Expr*>& others() const { return others_; }

 private:
  /// What an actuator of a robot is driven by.
  struct Driven {
    std::string binding;
    const Expr* point = nullptr;
    const Expr* device = nullptr;  ///< null: not bound
  };

  cdl::SocietyMember members(const Expr& expr, const Spot& spot, int depth);
  std::string add_robot(const Expr& robot, const Spot& spot);
  void collect_driven(const Expr& expr, std::vector<Driven>& into, int depth);
  void drive(const Driven& driven, cdl::Robot& robot);
  void choose_class(const Expr& robot, const std::vector<Driven>& driven, cdl::Robot& into);
  void set_parameters(const Expr& device, const cdl::RobotClass& known, cdl::Robot& into);
  const Expr* resolved(const Expr& expr) const;
  bool is_robot(const Expr& expr) const;

  Converter& converter_;
  std::string file_stem_;
  std::vector<cdl::RobotClass> classes_;
  std::vector<cdl::Robot> robots_;
  std::vector<cdl::Society> societies_;
  std::vector<const Expr*> others_;
  std::vector<Node> nodes_;
};

}  // namespace mlab::cdl_historic
