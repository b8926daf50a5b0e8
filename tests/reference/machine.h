// Runs steps and evaluates nodes over many lanes at once, under a mask of active lanes.
#pragma once

#include <string>
#include <vector>

#include "tests/reference/node.h"
#include "tests/reference/textures.h"

namespace reference {

class Machine {
 public:
  explicit Machine(int lanes, const Textures* textures = nullptr)
      : lanes_(lanes), textures_(textures), active_(static_cast<std::size_t>(lanes), true) {}

  Value evaluate(const Node& node);
  Wide integer_of(const Node& node);  ///< of a uniform integer
  void run(const Step& step);
  /// Only where the lanes of `enabled` are not 0, and those alone stay enabled until the end of the call.
  void run_where(const Step& step, const std::vector<bool>& enabled);
  void assign_everywhere(Variable& variable, const Value& value) const;

  /// What illuminate and solar read and set.
  struct Light {
    Variable *position, *ray, *distance, *direction;
    Variable* colors[3];
  };
  void use(const Light& light) { light_ = light; }
  int lanes() const { return lanes_; }

 private:
  enum class Flow { Next, Break, Continue };
  struct Loop {
    std::vector<bool> broken, skipped;  ///< lanes that a masked break or continue has taken out
  };
  struct Place {
    Variable* variable = nullptr;
    int first = 0, count = 1;
  };

  Flow flow(const Step& step);
  Flow flow_if(const Step& step);
  Flow flow_loop(const Step& step);
  void leave(std::vector<bool>& out);
  void restrict_to_staying(const std::vector<bool>& saved);
  void illuminate(const Step& step);
  void solar(const Step& step);
  std::vector<bool> inside_cone(const Step& step);
  void blacken_outside(const Value& axis, const Value& angle);

  Place place(const Node& node);
  void store(const Place& place, const Value& value);
  bool truth(const Node& node);

  Value evaluate_unary(const Node& node);
  Value evaluate_binary(const Node& node);
  Value evaluate_compare(const Node& node);
  Value evaluate_logic(const Node& node);
  Value evaluate_shift(const Node& node);
  Value evaluate_array(const Node& node);
  Value evaluate_index(const Node& node);
  Value evaluate_conditional(const Node& node);
  Value evaluate_convert(const Node& node);
  Value evaluate_assignment(const Node& node);
  Value evaluate_call(const Node& node);
  Value evaluate_builtin(const Node& node);
  Value look_up(const Node& node, const std::vector<Value>& arguments) const;

  int lanes_;
  const Textures* textures_;
  std::vector<bool> active_;
  std::vector<Loop> loops_;
  Light light_{};
};

}  // namespace reference
