/// Faces against faces that slide: pairs that come from the side take over the pressure of those before.

#include "body_run.hpp"

namespace cleave::solver::test {
namespace {

/// Rigid hexahedra of length dx in a row, one element high and deep, of one part.
struct Row {
  int part, first;  ///< number of its first element
  int count;
  double x, dx, y, dy, z, dz;
  int node, begin = 0;  ///< number of its first node; of the four that it begins with, if they are another's
};

std::string mesh(const std::vector<Row>& rows) {
  std::string nodes = "*NODE\n", elements = "*ELEMENT_SOLID\n";
  const auto line = [](std::string& to, const char* format, auto... values) {
    char text[256];
    std::snprintf(text, sizeof text, format, values...);
    to += text;
  };
  for (const Row& row : rows) {
    for (int i = row.begin > 0 ? 1 : 0; i <= row.count; ++i)
      for (int k = 0; k < 4; ++k)
        line(nodes, "%d,%.17g,%.17g,%.17g\n", row.node + 4 * i + k, row.x + i * row.dx,
             row.y + (k % 2) * row.dy, row.z + (k / 2) * row.dz);
    for (int i = 0; i < row.count; ++i) {
      const int a = i == 0 && row.begin > 0 ? row.begin : row.node + 4 * i, b = row.node + 4 * (i + 1);
      line(elements, "%d,%d,%d,%d,%d,%d,%d,%d,%d,%d\n", row.first + i, row.part, a, b, b + 1, a + 1, a + 2,
           b + 2, b + 3, a + 3);
    }
  }
  return nodes + elements;
}

constexpr double young = 10.0, poisson = 0.25, depth = 0.3, way = 3.3;

/// From rest at its depth on, and while it slides.
struct Pressed {
  double first_force = 0.0;
  double least_force = 1e300, most_force = 0.0, least_area = 1e300, most_area = 0.0;
};

/// A rigid slider (part 2) of two faces is pressed 0.3 deep onto a rigid track (part 1), and then drawn along
/// it over three of its faces, in steps of a sixtieth of the depth. The nodes of one half of the track are
/// numbered below those of the slider, those of the other above.
/// @param forwards  from the first half to the second
Pressed slide(const std::string& contact, bool forwards) {
  const double from = forwards ? 1.1 : 6.9 - 1.6, to = forwards ? way : -way;
  char text[512];
  std::snprintf(
      text, sizeof text,
      "*DEFINE_CURVE\n1\n0,0\n0.2,%g\n2,%g\n*DEFINE_CURVE\n2\n0,0\n0.25,0\n1.25,%g\n2,%g\n"
      "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n2,3,2,1,1.0\n2,1,2,2,1.0\n*DEFINE_CURVE\n3\n0,1.5e-3\n2,1.5e-3\n",
      -depth - 0.01, -depth - 0.01, to, to);
  Pressed pressed;
  const BodyRun run(
      "*KEYWORD\n*CONTROL_TERMINATION\n1.25\n*CONTROL_TIMESTEP\n0,0.9,0,0,0,3\n*MAT_RIGID\n1,1.0,10.0,0.25\n"
      "1,7,7\n\n*MAT_RIGID\n2,1.0,10.0,0.25\n1,2,7\n\n*SECTION_SOLID\n1,1\n*PART\ntrack\n1,1,1\n"
      "*PART\nslider\n"
      "2,1,2\n" +
          mesh({{1, 1, 4, 0.0, 1.0, 0.0, 1.0, -1.0, 1.0, 101},
                {2, 11, 2, from, 0.8, 0.05, 0.9, 0.01, 1.0, 201},
                {1, 21, 4, 4.0, 1.0, 0.0, 1.0, -1.0, 1.0, 301, 117}}) +
          text + contact,
      0, [&](const Frame& frame) {
        if (frame.state.time < 0.22) return;
        const InterfaceForce& now = frame.interfaces[0];
        if (pressed.first_force == 0.0) pressed.first_force = std::abs(now.force[2]);
        pressed.least_force = std::min(pressed.least_force, std::abs(now.force[2]));
        pressed.most_force = std::max(pressed.most_force, std::abs(now.force[2]));
        pressed.least_area = std::min(pressed.least_area, now.area);
        pressed.most_area = std::max(pressed.most_area, now.area);
      });
  EXPECT_FALSE(run.diagnostics.failed()) << run.text();
  EXPECT_EQ(run.outcome.ending, Ending::end_time) << run.outcome.status.what;
  return pressed;
}

// It covers 1.44 all the way, and the force stays what it was before it slid: at least e g on that area, with
// e = 4 SLSFAC K / t. Whichever side is named first, and in a single surface, where pairs are kept by the
// lower number of their faces.
TEST(ContactHandingOn, PressureStaysWhileFacesChange) {
  const double bulk = young / (3.0 * (1.0 - 2.0 * poisson));
  const double area = 2 * 0.8 * 0.9;
  for (const std::string contact : {"*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n2,1,3,3\n0\n\n2,0.1\n",
                                    "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,2,3,3\n0\n\n2,0.1\n",
                                    "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,0,5\n0\n\n2,0.1\n"})
    for (const bool forwards : {true, false}) {
      const Pressed pressed = slide(contact, forwards);
      EXPECT_NEAR(pressed.least_area, area, 0.01 * area) << contact << forwards;
      EXPECT_NEAR(pressed.most_area, area, 0.01 * area) << contact << forwards;
      if (contact.find("SINGLE") != std::string::npos) continue;  // its forces add up to none
      EXPECT_GT(pressed.first_force, 4.0 * 0.1 * bulk * depth * area) << contact << forwards;
      EXPECT_NEAR(pressed.least_force / pressed.first_force, 1.0, 1e-9) << contact << forwards;
      EXPECT_NEAR(pressed.most_force / pressed.first_force, 1.0, 1e-9) << contact << forwards;
    }
}

// A slider comes past the end of the track and down below its top within one step: nobody hands it anything,
// yet it is no deeper than it came. From then on it pushes on the top, of which it covers 0.4 in the end, and
// against the end as well, 0.05 of which it covers: it came by the corner.
TEST(ContactHandingOn, FromTheSideAndFromAboveAtOnce) {
  double force = 0.0, area = 0.0;
  const BodyRun run(
      "*KEYWORD\n*CONTROL_TERMINATION\n0.2\n*CONTROL_TIMESTEP\n0,0.9,0,0,0,3\n*MAT_RIGID\n1,1.0,10.0,0.25\n"
      "1,7,7\n\n*MAT_RIGID\n2,1.0,10.0,0.25\n1,2,7\n\n*SECTION_SOLID\n1,1\n*PART\ntrack\n1,1,1\n"
      "*PART\nslider\n2,1,2\n" +
          mesh({{1, 1, 4, 0.0, 1.0, 0.0, 1.0, -1.0, 1.0, 101},
                {2, 11, 2, 4.01, 0.8, 0.05, 0.9, 0.01, 1.0, 201}}) +
          "*DEFINE_CURVE\n1\n0,0\n0.1,0\n0.106,-0.06\n9,-0.06\n*DEFINE_CURVE\n2\n0,0\n0.1,0\n0.141,-0.41\n9,-"
          "0.41\n"
          "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n2,3,2,1,1.0\n2,1,2,2,1.0\n*DEFINE_CURVE\n3\n0,1.5e-3\n2,1.5e-"
          "3\n"
          "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n2,1,3,3\n0\n\n2,0.1\n",
      0, [&](const Frame& frame) {
        force = std::abs(frame.interfaces[0].force[2]), area = frame.interfaces[0].area;
      });
  ASSERT_FALSE(run.diagnostics.failed()) << run.text();
  EXPECT_EQ(run.outcome.ending, Ending::end_time) << run.outcome.status.what;
  const double bulk = young / (3.0 * (1.0 - 2.0 * poisson));
  EXPECT_NEAR(area, (0.4 + 0.05) * 0.9, 1e-12);
  EXPECT_GT(force, 4.0 * 0.1 * bulk * 0.05 * 0.4 * 0.9);
}

}  // namespace
}  // namespace cleave::solver::test
