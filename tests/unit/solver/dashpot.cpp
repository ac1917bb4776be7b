/// Damping and absorbing faces against closed forms.

#include <gtest/gtest.h>

#include "deck/deck.hpp"
#include "model/material/law.hpp"
#include "rig.hpp"

namespace cleave::solver::test {
namespace {

// v = v0 exp(-D t) per axis; what is lost is in the damping energy.
TEST(Dashpot, GlobalDampingDecays) {
  double error[2];
  for (const int level : {0, 1}) {
    Rig rig;
    const Index a = rig.particle(2.0, {0, 0, 0}, {1, 1, 1});
    model::GlobalDamping damping;
    damping.value = 1.5;
    damping.factor[1] = 0.0;
    damping.factor[2] = 2.0;
    rig.model.global_damping.push_back(damping);
    rig.fixed_step(level == 0 ? 0.02 : 0.01);
    Vector v{};
    rig.run(1.0, [&](const Frame& frame) { v = {frame.velocity[0], frame.velocity[1], frame.velocity[2]}; });
    error[level] = std::abs(v.x - std::exp(-1.5)) + std::abs(v.z - std::exp(-3.0));
    EXPECT_EQ(v.y, 1.0);
    EXPECT_NEAR(rig.x(a, 0), (1.0 - std::exp(-1.5)) / 1.5, 1e-4);
    EXPECT_NEAR(rig.state.energy.ratio(), 1.0, 1e-12);
    EXPECT_NEAR(rig.state.energy.damping, 3.0 - (v.x * v.x + 1.0 + v.z * v.z), 1e-12);
  }
  EXPECT_NEAR(std::log2(error[0] / error[1]), 2.0, 0.1);
}

// A node between a damped part and one without is damped by the share of mass.
TEST(Dashpot, PartDampingWithACurve) {
  Rig rig;
  const Index a = rig.node(0), b = rig.node(1), c = rig.node(2);
  rig.model.parts.resize(2);
  rig.model.parts[1].mass_damping = 2.0;
  rig.model.parts[1].mass_damping_curve = rig.curve({0, 10}, {0, 10});
  rig.springs({{{a, b}, 1e-12, 3.0}}, 0, 1);
  rig.springs({{{b, c}, 1e-12, 1.0}}, 1, 2);
  for (const Index node : {a, b, c}) rig.velocity(node, {0, 1, 0});
  rig.fixed_step(1e-3);
  rig.run(1.0);
  EXPECT_NEAR(rig.v(a, 1), 1.0, 1e-9);
  EXPECT_NEAR(rig.v(b, 1), std::exp(-0.25), 1e-3);  // integral of 2 t / 4
  EXPECT_NEAR(rig.v(c, 1), std::exp(-1.0), 1e-3);
}

/// Young's modulus 4, Poisson's ratio 0: longitudinal modulus 4, shear modulus 2.
std::shared_ptr<const model::Law> elastic() {
  static const std::vector<model::Curve> curves;
  static const std::vector<model::Table> tables;
  deck::Diagnostics diagnostics;
  const auto deck =
      deck::Deck::read_text("*KEYWORD\n*MAT_ELASTIC\n1,1.0,4.0,0.0\n*END\n", "law.k", {}, diagnostics);
  for (const auto& block : deck.blocks())
    if (const auto* entry = model::find_law(block.keyword))
      return entry->build(deck.cards(block, diagnostics).at(0),
                          model::LawContext{curves, tables, nullptr, diagnostics});
  return nullptr;
}

/// Rod of unit cross-section along x: four chains of springs, and one hexahedron at its end that says what
/// the absorbing face belongs to. Waves along x have speed c, transverse ones do not exist in this rod.
struct Rod : Rig {
  static constexpr int count = 60;
  std::vector<Index> corner[4];
  explicit Rod(double courant) {
    const double h = 1.0 / count, modulus = 4.0, density = 1.0;  // c = 2
    const double y[4] = {0, 1, 1, 0}, z[4] = {0, 0, 1, 1};
    std::vector<Springs::Spring> list;
    for (int k = 0; k < 4; ++k)
      for (int a = 0; a <= count; ++a) {
        corner[k].push_back(node(a * h, y[k], z[k]));
        if (a > 0)
          list.push_back({{corner[k][static_cast<std::size_t>(a - 1)], corner[k].back()},
                          0.25 * modulus / h,
                          0.25 * density * h});
      }
    springs(std::move(list));
    model.parts[0].density = density;
    model.parts[0].law = elastic();
    model::Elements hex;
    hex.id = {1};
    hex.part = {0};
    for (const int a : {count - 1, count})
      for (int k = 0; k < 4; ++k) hex.node.push_back(corner[k][static_cast<std::size_t>(a)]);
    model.mesh.solids.push_back(hex);
    model::AbsorbingFaces faces;
    faces.segments.push_back({{hex.node[4], hex.node[5], hex.node[6], hex.node[7]}});
    model.absorbing.push_back(faces);
    model.control.step.safety = courant;
    // A smooth pulse that starts in the middle; half of it goes each way.
    for (int k = 0; k < 4; ++k)
      for (int a = 0; a <= count; ++a) {
        const double s = (a * h - 0.5) / 0.1;
        velocity(corner[k][static_cast<std::size_t>(a)], {1e-3 * std::exp(-s * s), 0, 0});
      }
  }
};

// The pulse to the right leaves; the one to the left comes back from the free end and leaves too. What stays
// is what the face reflected: under one percent in amplitude, 1e-4 in energy.
TEST(Dashpot, AbsorbingFaceLetsWavesLeave) {
  for (const double courant : {1.0, 0.9, 0.5}) {
    Rod rig(courant);
    rig.run(1.2);
    EXPECT_FALSE(rig.diagnostics.failed());
    const double left = rig.state.energy.kinetic + rig.state.energy.internal;
    EXPECT_LT(left, 1e-4 * rig.state.energy.initial) << courant;
    EXPECT_NEAR(rig.state.energy.external, -rig.state.energy.initial, 1e-3 * rig.state.energy.initial);
  }
}

TEST(Dashpot, TransverseMotionFeelsTheShearImpedance) {
  // One free hexahedron face moving along z: m dv/dt = -rho c_s A v.
  Rod rig(0.9);
  rig.model.absorbing[0].dilatational = false;
  rig.fixed_step(1e-4);
  for (auto& v : rig.model.initial_velocity) v = 0.0;
  for (int k = 0; k < 4; ++k) rig.velocity(rig.corner[k].back(), {0, 0, 1e-9});
  rig.run(0.01);
  const double mass = 4.0 * rig.state.mass[static_cast<std::size_t>(rig.corner[0].back())];
  for (int k = 0; k < 4; ++k)
    EXPECT_NEAR(rig.v(rig.corner[k].back(), 2) / 1e-9,
                std::exp(-std::sqrt(2.0) / mass * (rig.state.time - 0.5e-4)), 1e-3);
}

TEST(Dashpot, AFaceWithoutAnElementIsAnError) {
  Rod rig(0.9);
  rig.model.absorbing[0].segments[0].node[0] = 0;
  rig.run(0.001);
  EXPECT_TRUE(rig.diagnostics.failed());
}

}  // namespace
}  // namespace cleave::solver::test
