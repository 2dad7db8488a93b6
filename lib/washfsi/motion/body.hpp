// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "washfsi/motion/images.hpp"
#include "washfsi/motion/motion.hpp"
#include "washfsi/shapes/shape.hpp"

namespace washfsi {

/// How bodies constrain the water: by the mask (4.2-6) with the plain projection (4.2-12) or with the variable one
/// (4.2-9); by velocities extrapolated through the wall (Yokoi); by the mask with viscous stencils that end at the
/// walls; by forces of markers on the walls.
enum class BodyMethod { mapping, mapping_variable, ghost, cut_stencil, direct_forcing };
const ChoiceNames<BodyMethod>& names_of(BodyMethod);

/// The edge of the solid's mask.
enum class MaskEdge { sharp, smooth };
const ChoiceNames<MaskEdge>& names_of(MaskEdge);

/// -body_method and -body_mask.
struct BodyTreatment {
  BodyMethod method = BodyMethod::direct_forcing;
  MaskEdge edge = MaskEdge::sharp;  ///< smooth: the mapping methods only
  double marker_spacing = 1.0;      ///< direct forcing: width of a patch [cells]
  double slip_tolerance = 0.005;    ///< direct forcing: rms slip left at each body over the largest speed
  bool limits_advection = true;     ///< direct forcing: whether advection becomes upwind beside edges
  bool inner_water_slides = false;  ///< direct forcing: whether water slides behind walls with a law of friction

  /// Errors: InputError.
  static BodyTreatment from_options(Options& options);
};

template <int Dim>
class PosedBody;

/// A named solid: a shape that moves rigidly.
template <int Dim>
struct Body {
  std::string name;
  ShapePtr<Dim> shape;
  RigidMotion<Dim> motion;
  Repeats<Dim> repeats = {};  ///< images along periodic axes, see `repeat_bodies`

  /// The body at one moment. The body must outlive it.
  PosedBody<Dim> at(double time) const { return {*this, time}; }
  /// Signed distance Phi from the nearest image [m]: negative in the solid.
  double distance(const Point<Dim>& place, double time) const { return at(time).distance(place); }

  /// `sample_spacing` [m] is the default for shapes sampled on a lattice. Errors: InputError. Collective.
  static Body from_options(Options& options, const std::string& name, double sample_spacing);
};

/// The motion of each body at one moment.
template <int Dim>
std::vector<typename RigidMotion<Dim>::State> motions_at(const std::vector<Body<Dim>>& bodies, double time) {
  std::vector<typename RigidMotion<Dim>::State> states;
  for (const auto& body : bodies) states.push_back(body.motion.state(time));
  return states;
}

/// A body at one moment, for many places. Where it repeats itself, places are taken beside the image that is nearest.
template <int Dim>
class PosedBody {
 public:
  using State = typename RigidMotion<Dim>::State;

  PosedBody(const Body<Dim>& body, double time)
      : shape_(body.shape.get()),
        motion_(body.motion.state(time)),
        pose_(Pose<Dim>::at(motion_.center, motion_.angle)),
        images_(body.repeats, pose_) {}

  const State& motion() const { return motion_; }
  const Pose<Dim>& pose() const { return pose_; }
  /// Signed distance [m]: negative in the solid.
  double distance(const Point<Dim>& place) const { return nearest(place).distance; }
  /// Which image is nearest: how many periods from the body itself.
  Index<Dim> image(const Point<Dim>& place) const { return images_.any() ? nearest(place).image : Index<Dim>{}; }
  /// Approximate distance to its next image [m]; infinite without one.
  double gap() const { return images_.gap(); }
  /// The place in the body itself that corresponds to a place in its nearest image.
  Point<Dim> beside(const Point<Dim>& place) const {
    return images_.any() ? Point<Dim>(place - images_.shift(nearest(place).image)) : place;
  }
  /// The arm from the centre of the nearest image to a place [m].
  Point<Dim> arm(const Point<Dim>& place) const { return beside(place) - motion_.center; }
  /// Velocity and acceleration of the body's material at a place [m/s, m/s2].
  Point<Dim> velocity(const Point<Dim>& place) const { return motion_.velocity_at(turns() ? beside(place) : place); }
  Point<Dim> acceleration(const Point<Dim>& place) const {
    return motion_.acceleration_at(turns() ? beside(place) : place);
  }

 private:
  typename Images<Dim>::Nearest nearest(const Point<Dim>& place) const {
    return images_.nearest(place,
                           [&](const Point<Dim>& beside) { return shape_->distance(pose_.in_body_frame(beside)); });
  }
  bool turns() const { return motion_.angular_velocity != 0 || motion_.angular_acceleration != 0; }

  const Shape<Dim>* shape_;
  State motion_;
  Pose<Dim> pose_;
  Images<Dim> images_;
};

/// All bodies at one moment, for many places.
template <int Dim>
class PosedBodies {
 public:
  /// The bodies must outlive it.
  PosedBodies(const std::vector<Body<Dim>>& bodies, double time) {
    for (const auto& body : bodies) bodies_.push_back(body.at(time));
  }
  std::size_t size() const { return bodies_.size(); }
  const PosedBody<Dim>& operator[](std::size_t body) const { return bodies_[body]; }
  const typename RigidMotion<Dim>::State& motion(std::size_t body) const { return bodies_[body].motion(); }
  /// Signed distance of one body [m]: negative in the solid.
  double distance(std::size_t body, const Point<Dim>& place) const { return bodies_[body].distance(place); }
  Point<Dim> in_space(std::size_t body, const Point<Dim>& arm) const { return bodies_[body].pose().in_space(arm); }
  Point<Dim> in_body_frame(std::size_t body, const Point<Dim>& place) const {
    return bodies_[body].pose().in_body_frame(place);
  }
  /// Unit vector out of a body: the direction in which its distance grows, over differences of `step` [m].
  Point<Dim> normal(std::size_t body, const Point<Dim>& place, double step) const {
    Point<Dim> slope;
    for (int d = 0; d < Dim; ++d) {
      const Point<Dim> aside = step * Point<Dim>::Unit(d);
      slope[d] = distance(body, place + aside) - distance(body, place - aside);
    }
    return slope.normalized();
  }
  /// The first body that a place is in; `size()` if it is in none.
  std::size_t holder(const Point<Dim>& place) const {
    std::size_t body = 0;
    while (body < size() && distance(body, place) > 0) ++body;
    return body;
  }

 private:
  std::vector<PosedBody<Dim>> bodies_;
};

/// All bodies named by -bodies, in a grid whose smallest cell is `cell` wide [m]. Errors: InputError. Collective.
template <int Dim>
std::vector<Body<Dim>> bodies_from_options(Options& options, double cell);

/// Refuses steps of at most `time_step` [s] that cannot resolve a motion: InputError.
template <int Dim>
void refuse_unseen_motion(const std::vector<Body<Dim>>& bodies, double time_step);
/// The longest step that resolves all motions [s]; infinite if they are steady.
template <int Dim>
double longest_step_of_motion(const std::vector<Body<Dim>>& bodies);

/// Distance to the nearest body [m]; very large without bodies.
template <int Dim>
double nearest_distance(const std::vector<Body<Dim>>& bodies, const Point<Dim>& place, double time);

}  // namespace washfsi
