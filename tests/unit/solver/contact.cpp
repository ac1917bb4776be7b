/// Bodies that meet: conservation, bad input, what ends a run.

#include "deck_run.hpp"

namespace cleave::solver::test {
namespace {

double size(const Vector& v) {
  return std::sqrt(base::dot(v, v));
}

/// A cube of 3 x 3 x 3 elements and side 1, turned about z and then x, centre moved, with a velocity and a
/// turn rate about z.
std::string cube(int part, Vector centre, double about_z, double about_x, Vector velocity, double rate) {
  const int first = 1000 * part;
  std::string nodes = "*NODE\n", elements = "*ELEMENT_SOLID\n", initial = "*INITIAL_VELOCITY_NODE\n";
  const auto id = [&](int i, int j, int k) { return first + 16 * k + 4 * j + i; };
  const auto line = [](std::string& to, const char* format, auto... values) {
    char text[256];
    std::snprintf(text, sizeof text, format, values...);
    to += text;
  };
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i) {
        const double u = i / 3.0 - 0.5, v = j / 3.0 - 0.5, w = k / 3.0 - 0.5;
        const double x = std::cos(about_z) * u - std::sin(about_z) * v,
                     y0 = std::sin(about_z) * u + std::cos(about_z) * v;
        const double y = std::cos(about_x) * y0 - std::sin(about_x) * w,
                     z = std::sin(about_x) * y0 + std::cos(about_x) * w;
        line(nodes, "%d,%.17g,%.17g,%.17g\n", id(i, j, k), centre.x + x, centre.y + y, centre.z + z);
        line(initial, "%d,%.17g,%.17g,%.17g\n", id(i, j, k), velocity.x - rate * y, velocity.y + rate * x,
             velocity.z);
      }
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i)
        line(elements, "%d,%d,%d,%d,%d,%d,%d,%d,%d,%d\n", first + 9 * k + 3 * j + i, part, id(i, j, k),
             id(i + 1, j, k), id(i + 1, j + 1, k), id(i, j + 1, k), id(i, j, k + 1), id(i + 1, j, k + 1),
             id(i + 1, j + 1, k + 1), id(i, j + 1, k + 1));
  return nodes + elements + initial + "*PART\ncube\n" + std::to_string(part) + ",1,1,0,1\n";
}

std::string head(double end) {
  return "*KEYWORD\n*CONTROL_TERMINATION\n" + std::to_string(end) +
         "\n*CONTROL_ENERGY\n2,2,2,2\n*MAT_ELASTIC\n1,1.0,100.0,0.3\n*SECTION_SOLID\n1,1\n*HOURGLASS\n1,6,0."
         "1\n";
}

std::string contact(const std::string& kind, int soft, const std::string& second = "", double scale = 1.0) {
  return "*CONTACT_" + kind + "\n1,2,3,3\n" + (second.empty() ? "0,0" : second) + "\n" +
         std::to_string(scale) + "," + std::to_string(scale) + "\n" + std::to_string(soft) + ",0.1\n";
}

// Turning cubes meet with a corner, an edge, a face: momentum and angular momentum are kept, energy within 1
// %.
TEST(Contact, TurningCubesKeepMomentum) {
  const struct {
    const char* name;
    double about_z, about_x;
  } poses[] = {{"corner", 0.7853981633974483, 0.9553166181245093},
               {"edge", 0.7853981633974483, 0.0},
               {"face", 0.0, 0.0}};
  for (const auto& pose : poses)
    for (const int soft : {0, 1, 2}) {
      const std::string bodies =
          head(1.0) + cube(1, {0, 0, 0}, 0.3, 0.2, {0, 0, 0}, 0.4) +
          cube(2, {1.75, 0.13, 0.21}, pose.about_z, pose.about_x, {-1.0, 0.1, 0}, -0.5);
      const DeckRun start(bodies + contact("AUTOMATIC_SURFACE_TO_SURFACE", soft), 1);
      const DeckRun run(bodies + contact("AUTOMATIC_SURFACE_TO_SURFACE", soft));
      ASSERT_FALSE(run.diagnostics.failed()) << run.text();
      EXPECT_EQ(run.outcome.ending, Ending::end_time) << pose.name << soft << run.outcome.status.what;
      EXPECT_LT(size(run.momentum() - start.momentum()), 1e-13) << pose.name << soft;
      EXPECT_LT(size(run.spin() - start.spin()), 1e-7) << pose.name << soft;
      EXPECT_NEAR(run.state.energy.ratio(), 1.0, 0.01) << pose.name << soft;
      EXPECT_GT(std::abs(run.state.energy.internal) + std::abs(run.momentum().x - start.momentum().x), 1e-4)
          << "they never met: " << pose.name << soft;
    }
}

// With friction momentum is still exact, and friction only takes energy.
TEST(Contact, FrictionTakesEnergy) {
  for (const int soft : {0, 2}) {
    const std::string bodies = head(1.0) + cube(1, {0, 0, 0}, 0, 0, {0, 0, 0}, 0.0) +
                               cube(2, {1.05, 0.2, 0}, 0, 0, {-0.5, 0.5, 0}, 0.0);
    const DeckRun start(bodies + contact("AUTOMATIC_SURFACE_TO_SURFACE", soft, "0.3,0.3,0,0,10"), 1);
    const DeckRun run(bodies + contact("AUTOMATIC_SURFACE_TO_SURFACE", soft, "0.3,0.3,0,0,10"));
    ASSERT_FALSE(run.diagnostics.failed()) << run.text();
    EXPECT_LT(size(run.momentum() - start.momentum()), 1e-13);
    EXPECT_GT(run.state.energy.sliding, 1e-3);
    EXPECT_NEAR(run.state.energy.ratio(), 1.0, 0.01);
  }
}

// Friction never exceeds its coefficient times all that presses, damping included: in each step, and most of
// all when bodies part, where damping takes away from the pressure of the springs.
TEST(Contact, DampingIsPartOfWhatHoldsByFriction) {
  struct Worst final : Observer {
    double over = 0.0, shear = 0.0;
    void begin(const Frame&) override {}
    void after_step(const Frame& frame) override {
      const InterfaceForce& of = frame.interfaces[0];
      const double across = std::hypot(of.force[1], of.force[2]), along = std::abs(of.force[0]);
      shear = std::max(shear, across);
      over = std::max(over, across - 0.3 * along);
    }
    void finish(const Frame&, Ending, const discretisation::StepStatus&) override {}
  };
  for (const int soft : {0, 1, 2}) {
    Worst worst;
    const DeckRun run(head(1.0) + cube(1, {0, 0, 0}, 0, 0, {0, 0, 0}, 0.0) +
                          cube(2, {1.05, 0.2, 0}, 0, 0, {-0.5, 0.5, 0}, 0.0) +
                          contact("AUTOMATIC_SURFACE_TO_SURFACE", soft, "0.3,0.3,0,0,30"),
                      0, &worst);
    ASSERT_FALSE(run.diagnostics.failed()) << run.text();
    EXPECT_GT(worst.shear, 0.01) << soft;
    EXPECT_LT(worst.over, 0.05 * worst.shear) << soft;  // the faces tilt a little
  }
}

// Sharp bodies of few elements tumble over each other: no energy comes from it, and the angular momentum
// stays.
TEST(Contact, TumblingSharpBodiesMakeNoEnergy) {
  for (int pose = 0; pose < 8; ++pose) {
    const double turn = 0.4 + 0.55 * pose, tilt = 0.3 + 0.37 * pose;
    const std::string bodies =
        head(4.0) + cube(1, {0, 0, 0}, 0.9 * turn, 0.5 * tilt, {0.15, 0, 0}, 0.6) +
        cube(2, {1.75, 0.1 * (pose % 3), 0.07 * pose}, turn, tilt, {-0.15, 0, 0}, -0.6);
    const DeckRun start(bodies + contact("AUTOMATIC_SURFACE_TO_SURFACE", 2), 1);
    const DeckRun run(bodies + contact("AUTOMATIC_SURFACE_TO_SURFACE", 2));
    ASSERT_FALSE(run.diagnostics.failed()) << run.text();
    EXPECT_EQ(run.outcome.ending, Ending::end_time) << pose << run.outcome.status.what;
    EXPECT_GT(size(run.momentum() - start.momentum()) + std::abs(run.state.energy.internal), 1e-6) << pose;
    EXPECT_LT(size(run.spin() - start.spin()), 1e-7) << pose;
    EXPECT_NEAR(run.state.energy.ratio(), 1.0, 0.01) << pose;
    EXPECT_GT(run.state.energy.sliding, -0.02 * run.state.energy.kinetic) << pose;
  }
}

// Far too soft a contact lets a body through: the run stops and names the place.
TEST(Contact, TunnellingEndsTheRun) {
  const DeckRun run(head(1.0) + cube(1, {0, 0, 0}, 0, 0, {0, 0, 0}, 0.0) +
                    cube(2, {1.05, 0.1, 0.1}, 0, 0, {-1, 0, 0}, 0.0) +
                    contact("AUTOMATIC_SURFACE_TO_SURFACE", 0, "", 1e-6));
  EXPECT_EQ(run.outcome.ending, Ending::physics);
  EXPECT_NE(run.outcome.status.what.find("contact 1: node"), std::string::npos) << run.outcome.status.what;
  EXPECT_GT(run.outcome.status.element, 0);
}

// What overlaps at the start is said, gives no force, and is refused where it is deep.
TEST(Contact, InitialPenetration) {
  const auto two = [](double gap) {
    return head(0.2) + cube(1, {0, 0, 0}, 0, 0, {0, 0, 0}, 0.0) +
           cube(2, {1.0 + gap, 0, 0}, 0, 0, {0, 0, 0}, 0.0);
  };
  for (const int soft : {0, 1, 2}) {
    const DeckRun run(two(-0.02) + contact("AUTOMATIC_SURFACE_TO_SURFACE", soft));
    EXPECT_TRUE(run.says("penetrate at the start, by up to 0.02", deck::Severity::warning)) << run.text();
    EXPECT_LT(run.state.energy.kinetic, 1e-20);
  }
  EXPECT_FALSE(DeckRun(two(0.02) + contact("AUTOMATIC_SURFACE_TO_SURFACE", 0))
                   .says("penetrate", deck::Severity::warning));
  const DeckRun deep(two(-0.5) + contact("AUTOMATIC_SURFACE_TO_SURFACE", 0));
  EXPECT_TRUE(deep.says("lies deep in element", deck::Severity::error)) << deep.text();
}

// IGNORE 0 moves nodes to the surface; 1 and 2 leave them, and 2 lists them with a warning.
TEST(Contact, IgnoreSaysWhatIsDoneAboutPenetration) {
  const auto run = [](int ignore) {
    return DeckRun(head(0.05) + cube(1, {0, 0, 0}, 0, 0, {0, 0, 0}, 0.0) +
                   cube(2, {0.98, 0.15, 0.15}, 0, 0, {0, 0, 0}, 0.0) +
                   contact("AUTOMATIC_SURFACE_TO_SURFACE", 0) + "0.0\n0," + std::to_string(ignore) + "\n");
  };
  const auto deepest = [](const DeckRun& r) {
    double most = 0.0;  // of cube 1's nodes beyond its own face at 0.5, of cube 2's before 0.48
    for (std::size_t a = 0; a < r.model.mesh.nodes.count(); ++a) {
      const double x = r.model.mesh.nodes.position[3 * a];
      const bool first = r.model.mesh.nodes.id[a] < 2000;
      if (first ? x > 0.4 : x < 0.6) most = std::max(most, std::abs(x - (first ? 0.5 : 0.48)));
    }
    return most;
  };
  const DeckRun moved(run(0)), tracked(run(1)), listed(run(2));
  for (const DeckRun* one : {&moved, &tracked, &listed}) {
    ASSERT_FALSE(one->diagnostics.failed()) << one->text();
    EXPECT_LT(one->state.energy.kinetic, 1e-18);
  }
  EXPECT_NEAR(deepest(moved), 0.02, 1e-12);
  EXPECT_EQ(deepest(tracked), 0.0);
  EXPECT_EQ(deepest(listed), 0.0);
  EXPECT_TRUE(moved.says("penetrate at the start, by up to 0.02", deck::Severity::warning)) << moved.text();
  EXPECT_FALSE(tracked.says("penetrate", deck::Severity::warning));
  EXPECT_TRUE(tracked.says("penetrate at the start", deck::Severity::note)) << tracked.text();
  EXPECT_TRUE(listed.says("node (depth): ", deck::Severity::warning)) << listed.text();
  EXPECT_FALSE(listed.says("and others", deck::Severity::warning));
}

// Bodies that are far faster than the step allows go deep into springs that nobody pressed: the run stops and
// names the pair, with the last state kept.
TEST(Contact, EnergyFromNothingEndsTheRun) {
  const DeckRun run(head(1.0) + "*CONTROL_TIMESTEP\n0,0.9\n" + cube(1, {0, 0, 0}, 0, 0, {0, 0, 0}, 0.0) +
                    cube(2, {1.051, 0.1, 0.1}, 0, 0, {-3, 0, 0}, 0.0) +
                    contact("AUTOMATIC_SURFACE_TO_SURFACE", 0, "", 50.0));
  EXPECT_EQ(run.outcome.ending, Ending::physics);
  EXPECT_NE(run.outcome.status.what.find("contact 1: node"), std::string::npos) << run.outcome.status.what;
  EXPECT_NE(run.outcome.status.what.find("created more than a tenth"), std::string::npos)
      << run.outcome.status.what;
  EXPECT_GT(run.outcome.status.element, 0);
}

// Sharp corners and edges against each other, faces against faces: no node is shot away. Elastic bodies give
// back at most what they had, so that no node of an equal body may be faster than twice the closing speed; in
// a corner waves focus, which doubles it once more.
TEST(Contact, NoNodeShoots) {
  struct Fastest final : Observer {
    double speed = 0.0;
    void look(const Frame& frame) {
      for (std::size_t i = 0; i < frame.velocity.size(); i += 3)
        speed = std::max(speed, std::hypot(frame.velocity[i], frame.velocity[i + 1], frame.velocity[i + 2]));
    }
    void begin(const Frame&) override {}
    void after_step(const Frame& frame) override { look(frame); }
    void finish(const Frame&, Ending, const discretisation::StepStatus&) override {}
  };
  const double corner_z = 0.7853981633974483, corner_x = 0.9553166181245093;
  const struct {
    const char* name;
    double z1, x1, z2, x2, gap, across;
  } poses[] = {{"corner on face", 0.0, 0.0, corner_z, corner_x, 1.4, 0.13},
               {"corner on corner", corner_z, corner_x, corner_z, corner_x, 1.76, 0.02},
               {"edge across edge", corner_z, 0.0, 0.0, 0.0, 1.25, 0.4},
               {"edge on edge", corner_z, 0.0, corner_z, 0.0, 1.45, 0.05}};
  for (const auto& pose : poses) {
    Fastest fastest;
    const DeckRun run(head(1.5) + cube(1, {0, 0, 0}, pose.z1, pose.x1, {0, 0, 0}, 0.0) +
                          cube(2, {pose.gap, pose.across, 0.07}, pose.z2, pose.x2, {-1.0, 0, 0}, 0.0) +
                          contact("AUTOMATIC_SURFACE_TO_SURFACE", 2),
                      0, &fastest);
    ASSERT_FALSE(run.diagnostics.failed()) << run.text();
    EXPECT_EQ(run.outcome.ending, Ending::end_time) << pose.name << run.outcome.status.what;
    EXPECT_GT(run.state.energy.internal + std::abs(run.momentum().y), 1e-5)
        << "they never met: " << pose.name;
    EXPECT_LT(fastest.speed, 4.0) << pose.name;
    EXPECT_NEAR(run.state.energy.ratio(), 1.0, 0.01) << pose.name;
  }
}

// The gap between bodies that do not touch, and minus the depth where they do; pressure times area is the
// force.
TEST(Contact, GapAndPressure) {
  struct Last final : Observer {
    ContactFields fields;
    std::vector<double> force;
    InterfaceForce sum;
    void begin(const Frame&) override {}
    void after_step(const Frame&) override {}
    void finish(const Frame& frame, Ending, const discretisation::StepStatus&) override {
      fields = frame.contact->contact_fields();
      force.assign(frame.contact_force.begin(), frame.contact_force.end());
      sum = frame.interfaces[0];
    }
  };
  for (const int soft : {0, 2}) {
    const auto two = [&](double gap, double speed, int stop, Last& last) {
      const DeckRun run(head(1.0) + cube(1, {0, 0, 0}, 0, 0, {0, 0, 0}, 0.0) +
                            cube(2, {1.0 + gap, 0, 0}, 0, 0, {-speed, 0, 0}, 0.0) +
                            contact("AUTOMATIC_SURFACE_TO_SURFACE", soft),
                        stop, &last);
      ASSERT_FALSE(run.diagnostics.failed()) << run.text();
      double pressed = 0.0;
      for (std::size_t a = 0; a < run.model.mesh.nodes.count(); ++a) {
        const double x = run.model.mesh.nodes.position[3 * a];
        const bool first = run.model.mesh.nodes.id[a] < 2000;
        if (first ? x < 0.4 : x > 0.6 + gap) continue;
        if (first) {
          EXPECT_NEAR(std::max(last.fields.gap[a], 0.0), speed == 0.0 ? gap : 0.0, 1e-12);
          EXPECT_EQ(last.fields.gap[a]<0.0, speed> 0.0);
        }
        const bool j = std::abs(std::abs(run.model.mesh.nodes.position[3 * a + 1]) - 0.5) < 1e-9;
        const bool k = std::abs(std::abs(run.model.mesh.nodes.position[3 * a + 2]) - 0.5) < 1e-9;
        // Corners of the cube also carry faces of two other sides, along which there is no force.
        if (first && !j && !k) {
          EXPECT_NEAR(last.fields.pressure[a], last.force[3 * a] / -(1.0 / 9.0),
                      1e-6 + 0.02 * std::abs(last.fields.pressure[a]));
          pressed += last.fields.pressure[a];
        }
      }
      EXPECT_EQ(pressed > 0.0, speed > 0.0);
    };
    Last apart, pressed;
    two(0.02, 0.0, 1, apart);
    two(0.002, 0.2, 8, pressed);
    EXPECT_GT(pressed.sum.touches, 0U);
  }
}

TEST(Contact, BadInputIsNamed) {
  const std::string bodies =
      head(0.1) + cube(1, {0, 0, 0}, 0, 0, {0, 0, 0}, 0.0) + cube(2, {1.1, 0, 0}, 0, 0, {0, 0, 0}, 0.0);
  const auto error = [&](const std::string& text, std::string_view phrase) {
    const DeckRun run(bodies + text);
    EXPECT_TRUE(run.says(phrase, deck::Severity::error)) << run.text();
  };
  error("*CONTACT_SURFACE_TO_SURFACE\n1,2,3,3\n-0.1\n\n", "expected 0 or more");
  error("*CONTACT_SURFACE_TO_SURFACE\n1,3,3,3\n\n\n*PART\nempty\n3,1,1\n", "no surface");
  error("*CONTACT_SURFACE_TO_SURFACE\n9,2,2,3\n\n\n", "set 9");
  error("*CONTACT_SURFACE_TO_SURFACE\n5,2,4,3\n\n\n*SET_NODE_LIST\n5\n1000\n", "no faces");
  // A face that points into its solid: x = 0.5 of cube 1 has nodes 1003 1007 1023 1019 seen from outside.
  error("*SET_SEGMENT\n4\n1003,1019,1023,1007\n*CONTACT_SURFACE_TO_SURFACE\n4,2,0,3\n\n\n", "not consistent");
  error("*SET_SEGMENT\n4\n1003,1007,2023,2019\n*CONTACT_SURFACE_TO_SURFACE\n4,2,0,3\n\n\n",
        "no face of a solid");
  error("*CONTACT_TIED_SURFACE_TO_SURFACE\n1,2,3,3\n\n\n", "no node of tied contact");
  const DeckRun turned(
      bodies + "*SET_SEGMENT\n4\n1003,1019,1023,1007\n*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n4,2,0,3\n\n\n");
  EXPECT_FALSE(turned.diagnostics.failed()) << turned.text();
}

// Two cubes tied at unlike meshes, thrown and turning: they stay one, momentum is kept.
TEST(Contact, TiedCubesFlyAsOne) {
  for (const std::string kind :
       {"TIED_SURFACE_TO_SURFACE", "TIED_NODES_TO_SURFACE", "TIED_SURFACE_TO_SURFACE_OFFSET"}) {
    const std::string bodies = head(2.0) + cube(1, {0, 0, 0}, 0, 0, {0.3, 0, 0}, 0.5) +
                               cube(2, {1.0, 0.1, 0.2}, 0, 0, {0.3 - 0.5 * 0.1, 0.5, 0}, 0.5);
    const DeckRun start(bodies + "*CONTACT_" + kind + "\n1,2,3,3\n\n\n", 1),
        run(bodies + "*CONTACT_" + kind + "\n1,2,3,3\n\n\n");
    ASSERT_FALSE(run.diagnostics.failed()) << run.text();
    EXPECT_EQ(run.outcome.ending, Ending::end_time);
    EXPECT_LT(size(run.momentum() - start.momentum()), 1e-12) << kind;
    EXPECT_LT(size(run.spin() - start.spin()), 1e-3) << kind;
    EXPECT_NEAR(run.state.energy.ratio(), 1.0, 0.01) << kind;
  }
}

}  // namespace
}  // namespace cleave::solver::test
