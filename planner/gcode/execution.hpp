#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "planner/gcode/action_list.hpp"
#include "planner/gcode/arc_geometry.hpp"
#include "planner/gcode/block.hpp"
#include "planner/gcode/context.hpp"
#include "planner/gcode/fault.hpp"
#include "planner/gcode/options.hpp"
#include "planner/gcode/spline_store.hpp"

namespace cnc::gcode {

/// Computes the effect of one block. It performs the steps of RS274/NGC table 8 in order, checks
/// each of them, and records its actions and changes. Nothing outside this object except the list
/// of actions changes before commit(). So if a step refuses the line, no earlier step has had an
/// effect.
///
/// Where RS274/NGC and Grbl 1.1 differ in the order of checks or in the numbers of errors, this
/// class follows Grbl (gnea/grbl, gcode.c, steps 2 and 3).
class Execution {
 public:
  /// Makes the execution of `block`. All arguments must outlive it. @pre `actions` is empty
  Execution(const Options& options,
            Context& context,
            StoredPlaces& places,
            SplineStore& store,
            Block& block,
            ActionList& actions)
      : options_{options},
        context_{context},
        places_{places},
        store_{store},
        block_{block},
        actions_{actions},
        next_{context} {}

  [[nodiscard]] Refusal run();

  /// Applies the recorded changes. @pre run() has not refused the block
  void commit();
  /// Returns whether the changes include a stored position.
  [[nodiscard]] bool stores_place() const { return stored_value_.has_value(); }

  /// Performs the block as a jog: its modes hold for this line only.
  [[nodiscard]] Refusal run_jog();
  /// Applies the only change of a jog, which is the position. Returns N of the line, or 0 if it has
  /// none.
  std::uint32_t commit_jog();

 private:
  using Step = Refusal (Execution::*)();

  [[nodiscard]] Refusal take_steps(std::span<const Step> steps);
  /// Changes of the open NURBS that a line makes when it is committed.
  struct NurbsLine {
    bool begins = false;
    std::size_t order = 0;  ///< New order of the NURBS; 0 leaves it unchanged.
    std::optional<float> first_weight{};
    std::optional<ControlPoint> point{};
  };

  // The steps are in execution.cpp, except for these: G64 in execution_path.cpp, G41.1 in
  // execution_compensation.cpp, offsets in execution_offsets.cpp, motion in execution_motion.cpp,
  // arcs in execution_arc.cpp, splines in execution_spline.cpp and execution_nurbs.cpp, jogs in
  // execution_jog.cpp.
  void set_modes();
  [[nodiscard]] Refusal check_signs();
  [[nodiscard]] Refusal number_line();
  [[nodiscard]] Refusal set_feed();
  [[nodiscard]] Refusal set_spindle_speed();
  [[nodiscard]] Refusal set_powers();
  [[nodiscard]] Refusal check_powers();
  [[nodiscard]] Refusal select_tool();
  [[nodiscard]] Refusal set_output();
  [[nodiscard]] Refusal set_spindle();
  [[nodiscard]] Refusal set_coolant();
  [[nodiscard]] Refusal dwell();
  [[nodiscard]] Refusal set_compensation();
  [[nodiscard]] Refusal read_compensation(CutterCompensation& wanted);
  [[nodiscard]] Refusal read_cut_width(float& width_mm);
  [[nodiscard]] Refusal read_tool_width(float& width_mm);
  [[nodiscard]] Refusal look_up_kerf(float& width_mm) const;
  [[nodiscard]] Refusal set_material();
  [[nodiscard]] bool keeps_kerf() const;
  [[nodiscard]] Refusal check_compensated_words();
  [[nodiscard]] Refusal check_tool_change_words() const;
  [[nodiscard]] Refusal set_path_control();
  [[nodiscard]] Refusal take_tolerance(char letter, std::optional<float>& tolerance_mm);
  [[nodiscard]] Refusal set_tool_length();
  [[nodiscard]] Refusal read_tool_length(ToolLength word, Coordinate& length);
  [[nodiscard]] Refusal switch_tool_centre(bool on);
  [[nodiscard]] Refusal check_words_at_tool_centre() const;
  [[nodiscard]] Refusal set_offsets();
  [[nodiscard]] Refusal go_to_stored_place();
  [[nodiscard]] Refusal move();
  [[nodiscard]] Refusal change_tool();
  [[nodiscard]] Refusal stop();
  [[nodiscard]] Refusal check_jog_words() const;

  [[nodiscard]] Refusal set_digital_output(Output output);
  [[nodiscard]] Refusal set_analog_output(Output output);
  void end_program();

  [[nodiscard]] Refusal set_system();
  [[nodiscard]] Refusal set_tool_radius();
  [[nodiscard]] Refusal read_origin(bool from_present_place, Position& origin);
  [[nodiscard]] Refusal set_g92();
  void switch_g92(NonModal word);
  void store(Position& place, const Position& value);

  [[nodiscard]] bool only_sets_mode() const;
  [[nodiscard]] bool moves() const;
  [[nodiscard]] bool has_centre_word() const;
  [[nodiscard]] Refusal check_feed() const;
  [[nodiscard]] Refusal check_duration(float length_mm, float speed_mm_s) const;
  [[nodiscard]] Refusal go_straight(Action& action, const Position& target);
  [[nodiscard]] Refusal read_target(Position& target);
  [[nodiscard]] Refusal move_straight();
  [[nodiscard]] Refusal probe();
  [[nodiscard]] float straight_speed(const Position& target) const;

  [[nodiscard]] Refusal move_along_arc();
  [[nodiscard]] Refusal read_turns(std::uint16_t& turns);
  [[nodiscard]] Refusal find_centre(PlaneVector end, PlaneVector& centre);
  [[nodiscard]] Refusal read_centre(PlaneVector& centre);
  [[nodiscard]] Refusal centre_from_radius(PlaneVector end, PlaneVector& centre);
  [[nodiscard]] Refusal check_centre_in_range(PlaneVector centre) const;
  [[nodiscard]] Refusal check_sides(PlaneVector centre, float radius_mm) const;
  [[nodiscard]] float arc_length(const Action& arc, float sweep, float radius_mm) const;
  [[nodiscard]] Refusal check_end_on_circle(PlaneVector end, PlaneVector centre) const;
  [[nodiscard]] PlaneVector from_here(const Position& target) const;

  [[nodiscard]] Refusal move_along_spline(MotionMode mode);
  [[nodiscard]] Refusal move_along_cubic();
  [[nodiscard]] Refusal move_along_quadratic();
  [[nodiscard]] Refusal read_spline_end(Position& target);
  [[nodiscard]] Refusal read_first_arm(PlanePlace& arm);
  [[nodiscard]] PlanePlace take_arm(char first, char second);
  [[nodiscard]] Refusal check_control_point(const PlanePlace& place, char letter) const;
  [[nodiscard]] Refusal append_spline(const Position& end);
  [[nodiscard]] float spline_speed() const;
  [[nodiscard]] Fault missing_in_motion(char letter) const;

  [[nodiscard]] bool nurbs_is_open() const { return context_.modal.motion == MotionMode::kNurbs; }
  [[nodiscard]] Refusal check_open_nurbs();
  [[nodiscard]] Refusal take_control_point();
  [[nodiscard]] Refusal weigh_first_point(NurbsLine& line);
  [[nodiscard]] Refusal read_control_point(NurbsLine& line);
  [[nodiscard]] Refusal take_order(std::size_t& order);
  [[nodiscard]] Refusal take_weight(float& weight);
  [[nodiscard]] Refusal end_nurbs();
  void commit_nurbs();

  /// Reads a whole number in 0…highest from a letter that the word of `group` requires.
  [[nodiscard]] Refusal take_index(char letter,
                                   ModalGroup group,
                                   std::uint32_t highest,
                                   FaultDetail when_higher,
                                   std::uint32_t& index);
  [[nodiscard]] Coordinate to_length(const Decimal& number) const;
  [[nodiscard]] Coordinate to_axis_value(std::size_t axis, const Decimal& number) const;
  [[nodiscard]] Refusal check_range(FaultDetail detail, std::size_t axis, Coordinate place) const;
  [[nodiscard]] bool within_reach(std::size_t axis, Coordinate place) const {
    return place >= -options_.reach[axis] && place <= options_.reach[axis];
  }
  /// Completes the fault of a word that leads to the position `place`, which is out of the axis'
  /// reach.
  [[nodiscard]] Fault out_of_reach(Fault word, std::size_t axis, Coordinate place) const;
  [[nodiscard]] Fault missing(char letter, ModalGroup for_group) const;
  [[nodiscard]] Fault blame_motion(FaultDetail detail) const;
  [[nodiscard]] Fault blame_centre(FaultDetail detail, float value_mm, float limit_mm) const;

  const Options& options_;
  Context& context_;
  StoredPlaces& places_;
  SplineStore& store_;
  Block& block_;
  ActionList& actions_;

  Context next_;               ///< State after the line.
  float inverse_time_ = 0.0F;  ///< F of this line in G93, 1/min.
  /// True while several values of S wait for the motion that uses them.
  bool powers_wait_ = false;
  std::optional<NurbsLine> nurbs_line_;
  bool offsets_changed_ = false;
  /// The stored position that commit() overwrites with stored_value_, if there is a value.
  Position* stored_ = nullptr;
  std::optional<Position> stored_value_;
};

}  // namespace cnc::gcode
