#pragma once
/// One place where two sides meet, and who finds such places.

#include "solver/contact/surface.hpp"
#include "solver/interaction.hpp"

namespace cleave::solver {

/// The force acts on the nodes a by the weights wa and, with the other sign, on the nodes b by wb; each set
/// of weights sums to 1.
struct Touch {
  std::int64_t key[2];  ///< who touches whom, to find again what was remembered
  Index a[4], b[4];     ///< unused ones have weight 0
  double wa[4], wb[4];
  Vector normal;           ///< unit, from b to a
  double depth = 0.0;      ///< how deep a is in b [length]
  double hardening = 0.0;  ///< the force is stiffness depth (1 + hardening depth^2) [1/length^2]
  double stiffness = 0.0;  ///< [force/length]
  // Faces: the stiffness is multiplied by fade (1 + pokes (cover - 1)).
  double cover = 1.0;      ///< area of the shared polygon over that of its part behind
  double pokes = 0.0;      ///< 0 where the faces are parallel, 1 where a corner or an edge pokes
  double fade = 1.0;       ///< 0 where they hardly look at each other
  double area = 0.0;       ///< [length^2]
  std::int32_t face = -1;  ///< of side b, for messages
  bool reverse = false;    ///< a is on side B of the card
  Vector pressure{0, 0, 0}, friction{0, 0, 0}, viscous{0, 0, 0};  ///< forces on a, filled in later [force]
};

/// Velocity of a relative to b [length/time].
inline Vector relative(const Touch& touch, std::span<const double> velocity) {
  Vector v{0, 0, 0};
  for (int i = 0; i < 4; ++i) {
    if (touch.wa[i] != 0.0) v = v + touch.wa[i] * vector_at(velocity, touch.a[i]);
    if (touch.wb[i] != 0.0) v = v - touch.wb[i] * vector_at(velocity, touch.b[i]);
  }
  return v;
}

/// What an interface remembers of a touch.
struct Remembered {
  double key[2];
  double friction[3];  ///< last friction force on a [force]
  double offset;       ///< depth that counts as none; 1e300: the pair does not push [length]
  double depth;        ///< of the last step [length]
  double pokes, fade;  ///< the largest while it was pressed
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
  std::span<const Remembered> all() const { return list_; }

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
