#pragma once
/// Everything that was asked for, with every id resolved and every default filled in. Const after build.

#include <string>
#include <vector>

#include "deck/deck.hpp"
#include "model/contact.hpp"
#include "model/control.hpp"
#include "model/curve.hpp"
#include "model/load.hpp"
#include "model/mesh.hpp"
#include "model/part.hpp"
#include "model/request.hpp"
#include "model/rigid.hpp"

namespace cleave::model {

/// A set of the deck after evaluation, kept so that the model can be written back and queried by tests.
template <class Member>
struct Set {
  Id id = 0;
  std::string title;
  std::vector<Member> members;
};

struct Model {
  std::string title;
  Mesh mesh;
  std::vector<Part> parts;
  std::vector<MaterialCard> materials;  ///< every *MAT_ and *EOS_ of the deck, in reading order
  std::vector<Curve> curves;
  std::vector<Table> tables;
  std::vector<Set<Index>> node_sets, part_sets;
  std::vector<Set<Id>> solid_sets, shell_sets, beam_sets;  ///< element ids
  std::vector<Set<Segment>> segment_sets;

  std::vector<FixedNodes> fixed;
  std::vector<PrescribedMotion> motions;
  std::vector<NodeLoad> node_loads;
  std::vector<SegmentLoad> segment_loads;
  std::vector<BodyLoad> body_loads;
  std::vector<RigidWall> walls;
  std::vector<Contact> contacts;
  std::vector<RigidBody> rigid_bodies;
  std::vector<RigidMotion> rigid_motions;
  std::vector<RigidLoad> rigid_loads;
  std::vector<AbsorbingFaces> absorbing;
  std::vector<Precrack> precracks;
  std::vector<IncidentWave> incident_waves;
  std::vector<InitialStress> initial_stress;  ///< ascending elements, each once
  std::vector<PointMass> point_masses;
  std::vector<GlobalDamping> global_damping;
  std::vector<double> initial_velocity;  ///< [node][3] [length/time]

  Control control;
  Requests requests;

  Index part_of(Id id) const;  ///< -1 when absent
  Index curve_of(Id id) const;
};

/// How each keyword of the deck was taken; the table at the end of every run.
struct Account {
  enum class Policy { honoured, in_part, output_only, refused, unknown };
  struct Entry {
    std::string keyword;
    Policy policy = Policy::honoured;
    std::size_t cards = 0;                    ///< data sets read
    std::size_t defaulted = 0;                ///< fields left to their default
    std::vector<std::string> ignored_fields;  ///< given but not honoured, by name
    std::string remark;
  };
  std::vector<Entry> entries;  ///< in order of first appearance
};

struct BuildOptions {
  bool allow_unsupported = false;  ///< refused physics becomes a warning that is repeated at the end
  double end_time = 0.0;           ///< in place of the deck's, if above 0 [time]
  bool needs_end_time = true;      ///< a deck without one is an error
};

/// Cards to Model. Errors and refusals are diagnostics; the Model is usable only if none is an error.
Model build(const deck::Deck& deck, const BuildOptions& options, deck::Diagnostics& diagnostics,
            Account& account);

/// The model as a deck (full precision): build(read(write(m))) gives the same model.
std::string write(const Model& model);

}  // namespace cleave::model
