#pragma once
/// Laws from deck text, and points to drive them.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "base/array.hpp"
#include "base/tensor.hpp"
#include "deck/deck.hpp"
#include "model/material/eos.hpp"
#include "model/material/erosion.hpp"
#include "model/material/law.hpp"

namespace cleave::model::testing {

using base::lane_count;
using Sym = base::Sym3<double>;
using Mat = base::Mat3<double>;

/// A law and all it was built from. Null where an error was reported.
struct Material {
  deck::Diagnostics diagnostics;
  std::vector<Curve> curves;
  std::vector<Table> tables;
  std::unique_ptr<PressureLaw> pressure;
  std::unique_ptr<Law> law;

  /// The deck holds one *MAT_, and *EOS_, *MAT_ADD_EROSION, *DEFINE_CURVE, *DEFINE_TABLE_2D as needed.
  explicit Material(const std::string& text) {
    const auto deck = deck::Deck::read_text("*KEYWORD\n" + text + "*END\n", "test.k", {}, diagnostics);
    std::vector<deck::Card> materials, states, erosions, tables_read;
    for (const auto& block : deck.blocks())
      for (const auto& card : deck.cards(block, diagnostics)) {
        const std::string& word = card.keyword();
        if (word == "MAT_ADD_EROSION")
          erosions.push_back(card);
        else if (word.starts_with("MAT_"))
          materials.push_back(card);
        else if (word.starts_with("EOS_"))
          states.push_back(card);
        else if (word == "DEFINE_TABLE_2D")
          tables_read.push_back(card);
        else if (word == "DEFINE_CURVE")
          read_curve(card);
      }
    for (const auto& card : tables_read) read_table(card);
    const LawEntry* entry = find_law(materials.at(0).keyword());
    if (!states.empty()) {
      pressure = find_pressure_law(states[0].keyword())->build(states[0], materials[0]["RO"], diagnostics);
      if (!pressure) return;
    }
    const LawContext context{
        .curves = curves, .tables = tables, .pressure = pressure.get(), .diagnostics = diagnostics};
    law = entry->build(materials[0], context);
    if (!erosions.empty() && law) law = add_erosion(std::move(law), erosions[0], context);
    EXPECT_EQ(law == nullptr, diagnostics.failed())
        << deck::Diagnostics(diagnostics).render(deck.sources(), false);
  }

 private:
  void read_curve(const deck::Card& card) {
    Curve c;
    c.id = card.integer("LCID");
    for (std::size_t i = 0; i < card.row_count("A1"); ++i) {
      c.x.push_back(card.real("A1", i));
      c.y.push_back(card.real("O1", i));
    }
    curves.push_back(c);
  }
  void read_table(const deck::Card& card) {
    Table t;
    t.id = card.integer("TBID");
    for (std::size_t i = 0; i < card.row_count("VALUE"); ++i) {
      t.value.push_back(card.real("VALUE", i));
      for (std::size_t c = 0; c < curves.size(); ++c)
        if (curves[c].id == card.integer("LCID", i)) t.curve.push_back(static_cast<Index>(c));
    }
    tables.push_back(t);
  }
};

/// Points of one law in batches of eight; point i is lane i % 8 of batch i / 8.
class Points {
 public:
  explicit Points(const Law& law, int batch_count = 1)
      : dt(1e-6),
        law_(law),
        batches_(batch_count),
        size_(8 + law.state_size()),
        record_(batch_count * size_ * lane_count, 0.0),
        strain_(batch_count * 6 * lane_count, 0.0),
        F_(batch_count * 9 * lane_count, 0.0),
        volume_(batch_count * lane_count, 1.0),
        volume_before_(volume_),
        q_(batch_count * lane_count, 0.0),
        length_(batch_count * lane_count, 1.0),
        modulus_(batch_count * lane_count, 0.0),
        failed_(batch_count * lane_count, 0.0) {
    std::vector<double> start(law.state_size(), 0.0);
    law.initialise(start);
    for (int i = 0; i < point_count(); ++i) {
      for (int k = 0; k < law.state_size(); ++k) state(i, k) = start[k];
      set_F(i, Mat::identity());
    }
  }

  double dt, time = 0.0;

  int point_count() const { return batches_ * lane_count; }
  double& state(int point, int k) { return record_[at(point, size_, 6 + k)]; }
  double& energy(int point) { return record_[at(point, size_, size_ - 1)]; }
  double& volume(int point) { return volume_[at(point, 1, 0)]; }
  double& volume_before(int point) { return volume_before_[at(point, 1, 0)]; }
  double& viscosity(int point) { return q_[at(point, 1, 0)]; }
  double& length(int point) { return length_[at(point, 1, 0)]; }
  double modulus(int point) { return modulus_[at(point, 1, 0)]; }
  double failed(int point) { return failed_[at(point, 1, 0)]; }
  double plastic_strain(int point) { return state(point, law_.plastic_strain()); }

  Sym stress(int point) { return tensor(record_, size_, 0, point); }
  void set_stress(int point, const Sym& s) { put(record_, size_, 0, point, s); }
  Sym state_tensor(int point, int first) { return tensor(record_, size_, 6 + first, point); }
  void set_state_tensor(int point, int first, const Sym& s) { put(record_, size_, 6 + first, point, s); }
  /// Strain increment of the next step; the volume ratio follows its trace.
  void set_strain(int point, const Sym& e) {
    put(strain_, 6, 0, point, e);
    volume_before(point) = volume(point);
    volume(point) = volume_before(point) * std::exp(trace(e));
  }
  /// Deformation gradient at the end of the next step; the volume ratio follows.
  void set_F(int point, const Mat& F) {
    for (int i = 0; i < 9; ++i) F_[at(point, 9, i)] = F.m[i / 3][i % 3];
    volume_before(point) = volume(point);
    volume(point) = determinant(F);
  }
  Mat F(int point) {
    Mat F;
    for (int i = 0; i < 9; ++i) F.m[i / 3][i % 3] = F_[at(point, 9, i)];
    return F;
  }

  Tile tile() {
    Tile t;
    t.batch_count = batches_;
    t.dt = dt;
    t.time = time;
    t.strain_increment = strain_.data();
    t.deformation_gradient = F_.data();
    t.volume_ratio = volume_.data();
    t.volume_ratio_before = volume_before_.data();
    t.bulk_viscosity = q_.data();
    t.length = length_.data();
    t.stress = record_.data();
    t.state = record_.data() + 6 * lane_count;
    t.energy = record_.data() + (size_ - 1) * lane_count;
    t.modulus = modulus_.data();
    t.failed = failed_.data();
    t.record_stride = size_ * lane_count;
    return t;
  }
  void update() {
    time += dt;
    law_.update(tile());
  }
  void update_scalar() {
    time += dt;
    law_.update_scalar(tile());
  }
  /// All points take the strain increment e.
  void step(const Sym& e) {
    for (int i = 0; i < point_count(); ++i) set_strain(i, e);
    update();
  }
  std::vector<double> tangent() {
    std::vector<double> out(batches_ * 6 * (law_.needs_F() ? 9 : 6) * lane_count);
    law_.tangent(tile(), out);
    return out;
  }
  const base::Array<double>& record() const { return record_; }

 private:
  std::size_t at(int point, int size, int k) const {
    return ((point / lane_count) * static_cast<std::size_t>(size) + k) * lane_count + point % lane_count;
  }
  Sym tensor(const base::Array<double>& a, int size, int k, int p) const {
    return {a[at(p, size, k)],     a[at(p, size, k + 1)], a[at(p, size, k + 2)],
            a[at(p, size, k + 3)], a[at(p, size, k + 4)], a[at(p, size, k + 5)]};
  }
  void put(base::Array<double>& a, int size, int k, int p, const Sym& s) {
    const double v[6] = {s.xx, s.yy, s.zz, s.xy, s.yz, s.zx};
    for (int i = 0; i < 6; ++i) a[at(p, size, k + i)] = v[i];
  }

  const Law& law_;
  int batches_, size_;
  base::Array<double> record_, strain_, F_, volume_, volume_before_, q_, length_, modulus_, failed_;
};

inline std::array<double, 6> components(const Sym& s) {
  return {s.xx, s.yy, s.zz, s.xy, s.yz, s.zx};
}
inline Sym symmetric(const std::array<double, 6>& c) {
  return {c[0], c[1], c[2], c[3], c[4], c[5]};
}
inline double mises(const Sym& s) {
  return base::von_mises(s);
}
inline double norm(const Sym& s) {
  return std::sqrt(dot(s, s));
}

/// Drives point 0 (and all others) with strain increments of axial part `axial` such that the lateral stress
/// stays zero: uniaxial stress along x. Newton on the lateral strain with the law's own tangent.
inline Sym step_uniaxial(const Law& law, Points& points, double axial) {
  double lateral = -0.4 * axial;
  for (int i = 0; i < 30; ++i) {
    Points trial = points;
    const Sym e{axial, lateral, lateral, 0, 0, 0};
    for (int p = 0; p < trial.point_count(); ++p) trial.set_strain(p, e);
    const auto c = trial.tangent();
    trial.update();
    const double slope = c[(1 * 6 + 1) * lane_count] + c[(1 * 6 + 2) * lane_count];
    const double residual = trial.stress(0).yy;
    lateral -= residual / slope;
    if (std::abs(residual) < 1e-13 * law.longitudinal_modulus()) break;
  }
  points.step({axial, lateral, lateral, 0, 0, 0});
  return points.stress(0);
}

/// A seeded generator: the same numbers everywhere.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double operator()(double scale) {
    return scale * (2.0 * static_cast<double>(engine_() >> 11) / 9007199254740992.0 - 1.0);
  }
  Sym tensor(double scale) {
    Sym s{};
    s.xx = (*this)(scale), s.yy = (*this)(scale), s.zz = (*this)(scale);
    s.xy = (*this)(scale), s.yz = (*this)(scale), s.zx = (*this)(scale);
    return s;
  }
  /// A rotation, from a random quaternion.
  Mat rotation() {
    double q[4];
    double size = 0.0;
    for (double& c : q) {
      c = (*this)(1.0);
      size += c * c;
    }
    for (double& c : q) c /= std::sqrt(size);
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    Mat r;
    const double v[9] = {1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),
                         2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
                         2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y)};
    for (int i = 0; i < 9; ++i) r.m[i / 3][i % 3] = v[i];
    return r;
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace cleave::model::testing
