#pragma once
/// One place where two sides meet, and who finds such places.

#include <algorithm>
#include <array>
#include <cmath>

#include "solver/contact/surface.hpp"
#include "solver/interaction.hpp"

namespace cleave::solver {

/// The force acts on the nodes a by the weights wa and, with the other sign, on the nodes b by wb; each set
/// of weights sums to 1. The pressure between two faces has a part for each corner.
struct Touch {
  std::int64_t key[2];  ///< who touches whom, to find again what was remembered
  Index a[4], b[4];     ///< unused ones have weight 0
  double wa[4], wb[4];
  Vector normal;             ///< unit, from b to a
  double depth = 0.0;        ///< how deep a is in b [length]
  double stiffness = 0.0;    ///< [force/length]
  double area = 0.0;         ///< [length^2]
  std::int32_t face = -1;    ///< of side b, for messages
  bool reverse = false;      ///< a is on side B of the card
  bool faces = false;        ///< two faces: what follows was set by the finder
  double offset = 0.0;       ///< depth that counts as none; `out_of_reach`: the pair does not push [length]
  double penetration = 0.0;  ///< as depth, but square to what lies there [length]
  double push = 0.0;         ///< the pressure along the normal [force]
  double energy = 0.0;       ///< whose gradient the parts of the pressure are [energy]
  Vector on_a[4], on_b[4];   ///< its parts [force]
  Vector pressure{0, 0, 0}, friction{0, 0, 0}, viscous{0, 0, 0};  ///< forces on a, filled in later [force]
};

/// An offset deeper than anything.
inline constexpr double out_of_reach = 1e300;

/// What acts on a corner of side a, and of side b [force].
inline Vector force_on_a(const Touch& touch, int k) {
  if (!touch.faces) return touch.wa[k] * (touch.pressure + touch.friction + touch.viscous);
  return touch.on_a[k] + touch.wa[k] * (touch.friction + touch.viscous);
}
inline Vector force_on_b(const Touch& touch, int k) {
  if (!touch.faces) return -touch.wb[k] * (touch.pressure + touch.friction + touch.viscous);
  return touch.on_b[k] - touch.wb[k] * (touch.friction + touch.viscous);
}

/// Velocity of a relative to b [length/time].
inline Vector relative(const Touch& touch, std::span<const double> velocity) {
  Vector v{0, 0, 0};
  for (int i = 0; i < 4; ++i) {
    if (touch.wa[i] != 0.0) v = v + touch.wa[i] * vector_at(velocity, touch.a[i]);
    if (touch.wb[i] != 0.0) v = v - touch.wb[i] * vector_at(velocity, touch.b[i]);
  }
  return v;
}

/// Sum of the parts of the pressure times a field of the nodes, as velocity.
inline double pressure_dot(const Touch& touch, std::span<const double> field) {
  if (!touch.faces) return base::dot(touch.pressure, relative(touch, field));
  double sum = 0.0;
  for (int k = 0; k < 4; ++k)
    sum += base::dot(touch.on_a[k], vector_at(field, touch.a[k])) +
           base::dot(touch.on_b[k], vector_at(field, touch.b[k]));
  return sum;
}

/// Half the sums of the rows of a matrix that bounds the second derivative of the energy of a touch, for the
/// corners of a and then those of b [force/length]. The stiffness along the normal acts by the weights.
/// Between faces the force tells the rest: where an energy U grows with the power p of a motion, its second
/// derivative along the force F is 2 (p - 1) / p times F^2 / (2 U); p is 2 for a spring, and 4 for a corner
/// whose area grows as it goes in.
inline std::array<double, 8> half_rows(const Touch& touch) {
  constexpr double bent = 1.5;  // p = 4
  std::array<double, 8> rows, force{};
  double all = 0.0;
  if (touch.faces && touch.energy > 0.0) {
    for (std::size_t k = 0; k < 4; ++k) {
      force[k] = norm(touch.on_a[k]);
      force[4 + k] = norm(touch.on_b[k]);
      all += force[k] + force[4 + k];
    }
    all *= 0.25 * bent / touch.energy;
  }
  for (std::size_t k = 0; k < 4; ++k) {
    rows[k] = std::max(touch.stiffness * std::abs(touch.wa[k]), force[k] * all);
    rows[4 + k] = std::max(touch.stiffness * std::abs(touch.wb[k]), force[4 + k] * all);
  }
  return rows;
}

/// What an interface remembers of a touch.
struct Remembered {
  double key[2];
  double friction[3];   ///< last friction force on a [force]
  double offset;        ///< as Touch::offset [length]
  double depth;         ///< as Touch::depth [length]
  double unused = 0.0;  ///< room, so that the width is even
};

/// The touches of the step before, sorted by key.
class Past {
 public:
  explicit Past(std::span<const double> values)
      : list_(reinterpret_cast<const Remembered*>(values.data()), values.size() / (sizeof(Remembered) / 8)) {}
  const Remembered* find(const std::int64_t key[2]) const {
    const auto before = [&](const Remembered& r, const std::int64_t* k) {
      return r.key[0] != static_cast<double>(k[0]) ? r.key[0] < static_cast<double>(k[0])
                                                   : r.key[1] < static_cast<double>(k[1]);
    };
    const auto at = std::lower_bound(list_.begin(), list_.end(), key, before);
    if (at == list_.end() || at->key[0] != static_cast<double>(key[0]) ||
        at->key[1] != static_cast<double>(key[1]))
      return nullptr;
    return &*at;
  }
  /// Those whose first key is the given one.
  std::span<const Remembered> of(std::int64_t first) const {
    const auto key = static_cast<double>(first);
    const auto from = std::lower_bound(list_.begin(), list_.end(), key,
                                       [](const Remembered& r, double k) { return r.key[0] < k; });
    auto to = from;
    while (to != list_.end() && to->key[0] == key) ++to;
    return {from, to};
  }

 private:
  std::span<const Remembered> list_;
};

/// The depth beyond which a touch lets go (PENMAX) [length].
inline double release_depth(const model::Contact& contact, double thickness) {
  if (contact.release == 0.0) return 1e300;
  return contact.release * (contact.automatic ? thickness : 1.0);
}

/// Finds the touches of one pair of sides.
class Finder {
 public:
  virtual ~Finder() = default;
  virtual void start(const discretisation::State& state) = 0;
  virtual void erode(std::span<const model::Id> eroded) = 0;
  /// Appends the touches at t_n in the order of their keys; the same for any number of threads.
  virtual void find(const Moment& now, const Past& past, std::vector<Touch>& out) = 0;
  virtual const Face& face(std::int32_t number) const = 0;  ///< of side b
  /// The face on side a, or one around the node there; null where there is none.
  virtual const Face* face_of_a(const Touch& touch) const = 0;
};

/// A finder that also tells how far apart sides are.
class Gauge : public Finder {
 public:
  /// Lowers the gap of each node that looks at a face near it [node] [length].
  virtual void gaps(const Moment& now, std::span<double> gap) = 0;
  /// Adds the area of the faces around the nodes it looks from [node] [length^2].
  virtual void add_areas(const Moment& now, std::span<Vector> area) const = 0;
};

}  // namespace cleave::solver
