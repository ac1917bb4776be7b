"""Decks of other projects (tests/regression/decks/SOURCES.md says where each comes from and what it must do).

Each is read by `cleave check`: it is accepted, or refused for the reasons stated here and no crash. Physics that is
not computed is refused by name.
"""
import unittest

from support import Case, ROOT, rows

DECKS = ROOT / "tests/regression/decks"
ACCEPTED, REFUSED = 0, 3
PYDYNA = "ansys__pydyna/tests/testfiles/"
PARAMETERS = PYDYNA + "keywords/expand_parameters/"
NO_END = "*CONTROL_TERMINATION ENDTIM: the deck gives no end time"  # a fragment's only fault

# deck: (status, what must be said, how many errors); a number of None is not asserted.
EXPECTED = {
    "K1-ZR__practice-lsdyna/lsdyna-input-gallery/one-element-loadcontrol.k":
        (ACCEPTED, ["*BOUNDARY_SPC_NODE DOFX: no direction is fixed"], 0),
    "cxh-1123__LS-DYNA-ablation/test.k": (ACCEPTED, [], 0),
    # joints are refused by name
    "WillemJR__dynakw/test/full_files/joint_revolute.k":
        (REFUSED, [f"*{name}: not computed here" for name in
                   ("CONSTRAINED_JOINT_REVOLUTE", "CONSTRAINED_JOINT_STIFFNESS_GENERALIZED")] +
         ["belongs to rigid body 2 and is held by itself"], 3),
    "WillemJR__dynakw/test/full_files/mat.k": (REFUSED, [NO_END], 1),
    "WillemJR__dynakw/test/full_files/parameter.k": (REFUSED, ["parameter.k:13:1: error: unknown keyword '*MAT_FOO'"], 1),
    "WillemJR__dynakw/test/full_files/section.k": (REFUSED, [NO_END], 1),
    "WillemJR__dynakw/test/full_files/sample.k":
        (REFUSED, ["sample.k:27:1: error: *ELEMENT_SOLID N1: the nodes of element 1 make no solid",
                   "*BOUNDARY_PRESCRIBED_MOTION_RIGID PID: part 1 is not defined",
                   "sample.k:32:4: error: *ELEMENT_SOLID PID: part 7 is not defined"], None),
    "WillemJR__dynakw/test/full_files/thick.k":
        (REFUSED, ["*SET_SEGMENT N1: node 80 is not defined", "*PART PID: rigid body 2 has no elements and so no mass"],
         None),
    # meshes without parts
    "ansys__example-data/ls-dyna/Bar_Impact/bar_impact_mesh.k":
        (REFUSED, ["*ELEMENT_SOLID PID: part 1 is not defined", "*ELEMENT_SHELL: not computed here"], None),
    "ansys__example-data/ls-dyna/John_Reid_Pendulum/nodes.k":
        (REFUSED, ["*ELEMENT_BEAM: not computed here", "*ELEMENT_SHELL: not computed here"], 2),
    "ansys__example-data/ls-dyna/Taylor_Bar/taylor_bar_mesh.k":
        (REFUSED, ["*ELEMENT_SOLID PID: part 1 is not defined"], None),
    "ansys__example-data/ls-dyna/yaris_stat_shock_absorber_loading/000_yaris_stat_shock_absorber_loading_01.k":
        (REFUSED, ["*INCLUDE_TRANSFORM FILENAME: the file 'YarisD_V2g", "*CONTROL_IMPLICIT_GENERAL: not computed here"],
         None),
    "ansys__example-data/ls-dyna/yaris_stat_shock_absorber_loading/implicit_control_cards_R9.k":
        (REFUSED, ["*CONTROL_IMPLICIT_GENERAL: not computed here"], None),
    # parameters and their scopes
    PYDYNA + "keywords/encoding_sample.k":
        (REFUSED, ["encoding_sample.k:11:43: error: *DEFINE_CURVE OFFA", "no parameter 'PAB_TTF' is defined here"], 1),
    PARAMETERS + "collision/main.k": (REFUSED, [NO_END], None),
    PARAMETERS + "collision/main_with_consumer.k": (REFUSED, [NO_END], None),
    PARAMETERS + "collision/module_a.k": (REFUSED, [NO_END], 1),
    PARAMETERS + "collision/module_b.k": (REFUSED, [NO_END], 1),
    PARAMETERS + "collision/module_c_consumer.k":
        (REFUSED, ["module_c_consumer.k:8:11: error: *SECTION_SOLID ELFORM: no parameter 'scale' is defined here"], 1),
    PARAMETERS + "collision_local/main.k": (REFUSED, [NO_END], 1),
    PARAMETERS + "collision_local/module_a_local.k": (REFUSED, [NO_END], 1),
    PARAMETERS + "collision_local/module_b_local.k": (REFUSED, [NO_END], 1),
    PARAMETERS + "local/include_with_local.k":
        (REFUSED, ["include_with_local.k:13:11: error: *SECTION_SOLID ELFORM: no parameter 'gbl'"], 1),
    PARAMETERS + "local/sibling_a.k": (REFUSED, ["sibling_a.k:13:11: error: *SECTION_SOLID ELFORM: no parameter 'shr'"], 1),
    PARAMETERS + "local/sibling_b.k": (REFUSED, ["sibling_b.k:6:11: error: *SECTION_SOLID ELFORM: no parameter 'aloc'"], None),
    PARAMETERS + "local/sibling_test_top.k":
        (REFUSED, ["sibling_b.k:6:11: error: *SECTION_SOLID ELFORM: no parameter 'aloc'"], 1),
    PARAMETERS + "local/top.k": (REFUSED, ["top.k:15:11: error: *SECTION_SOLID ELFORM: no parameter 'loc'"], 1),
    PARAMETERS + "nonlocal/one.k":
        (REFUSED, ["two.k:6:11: error: *SECTION_SOLID ELFORM: no parameter 'pm_main'"], 1),
    PARAMETERS + "nonlocal/top.k": (REFUSED, [NO_END], 1),
    PARAMETERS + "nonlocal/two.k": (REFUSED, ["two.k:6:11: error: *SECTION_SOLID ELFORM: no parameter 'pm_main'"], 1),
    PARAMETERS + "sibling/contact.k": (REFUSED, ["contact.k:7:1: error: *SECTION_SOLID SECID: no parameter 'ssid'"], None),
    PARAMETERS + "sibling/main.k": (REFUSED, [NO_END], 1),
    PARAMETERS + "sibling/params.k": (REFUSED, [NO_END], 1),
    PYDYNA + "keywords/expand_test/bird_B.k":
        (REFUSED, ["control_cards.k:38:1: error: *INCLUDE FILENAME: the file 'mesh.k' is not found",
                   "*CONSTRAINED_LAGRANGE_IN_SOLID: not computed here"], None),
    PYDYNA + "keywords/expand_test/control_cards.k":
        (REFUSED, ["control_cards.k:38:1: error: *INCLUDE FILENAME: the file 'mesh.k' is not found"], None),
    PYDYNA + "keywords/expand_test/fol/mesh.k": (REFUSED, ["*ELEMENT_SOLID PID: part 4 is not defined"], None),
    # one mistake each: file, line, column and field are named
    PYDYNA + "keywords/parameter_error_location/test_comments.k":
        (REFUSED, ["test_comments.k:8:3: error: *SET_NODE_LIST NODES: no parameter 'undef' is defined here"], 1),
    PYDYNA + "keywords/parameter_error_location/test_multiple.k":
        (REFUSED, ["test_multiple.k:10:3: error: *SET_NODE_LIST NODES: no parameter 'undef' is defined here"], None),
    PYDYNA + "keywords/parameter_error_location/test_node_param.k":
        (REFUSED, ["test_node_param.k:5:9: error: *NODE X: no parameter 'x_coord' is defined here"], 1),
    PYDYNA + "keywords/parameter_error_location/test_param_format_error.k":
        (REFUSED, ["test_param_format_error.k:5:1: error: *NODE NID"], 1),
    PYDYNA + "keywords/parameter_error_location/test_undefined_param.k":
        (REFUSED, ["test_undefined_param.k:6:3: error: *SET_NODE_LIST NODES: no parameter 'undef' is defined here"], 1),
    PYDYNA + "keywords/test_multiline_comment.k":
        (REFUSED, ["test_multiline_comment.k:7:1: error: *CONTACT_AUTOMATIC_SINGLE_SURFACE SURFA: the contact is given no part",
                   "test_multiline_comment.k:30:1: error: *SET_SEGMENT N1: node 2842 is not defined"], 6),
    PYDYNA + "standard/mech.k":
        (REFUSED, ["*CONTACT_NODES_TO_SURFACE SURFA: part 3 is not defined", "*AIRBAG_SIMPLE_AIRBAG_MODEL: not computed here",
                   "*PART MID: part 1 needs material 0, which is not defined"], None),
    PYDYNA + "standard/thermal_stress.k":
        (REFUSED, ["*CONTROL_SOLUTION SOLN: thermal or coupled analysis",
                   "*MAT_ELASTIC_PLASTIC_THERMAL: this law is not computed, and part 1 uses it"], 5),
    PYDYNA + "standard/nvh/frf_solid.k":
        (REFUSED, ["*CONTROL_IMPLICIT_EIGENVALUE: not computed here", "warning: unknown keyword '*FREQUENCY_DOMAIN_FRF'"],
         3),
    # an elastic box falls on a plate of shells that is held at every node
    "jrycw__open-radioss-github-actions-linode/box_drop_openrs.k":
        (ACCEPTED, ["every node of the shells of part 1 is held: it is a surface that does not deform"], 0),
    "jrycw__open-radioss-github-actions-linode/main.k": (ACCEPTED, [], 0),
    # main files without their meshes
    "mlp6__fem/examples/compress_cube/CompressElasticCubeExplicit.dyn":
        (REFUSED, ["CompressElasticCubeExplicit.dyn:31:1: error: *INCLUDE FILENAME: the file './nodes.dyn' is not found",
                   "the file './topload.dyn' is not found"], None),
    "mlp6__fem/examples/compress_cube/CompressElasticCubeImplicit.dyn":
        (REFUSED, ["*CONTROL_IMPLICIT_GENERAL: not computed here"], None),
    "mlp6__fem/examples/gauss_qsym_pml/gauss_qsym_pml.dyn":
        (REFUSED, ["the file './nodes.dyn' is not found"], None),
    "mlp6__fem/examples/thermal/thermal.dyn":
        (REFUSED, ["*CONTROL_SOLUTION SOLN: thermal or coupled analysis"], None),
    "mlp6__fem/tests/elems.dyn": (REFUSED, ["*ELEMENT_SOLID PID: part 1 is not defined"], None),
    "mlp6__fem/tests/nodes.dyn": (REFUSED, [NO_END], 1),
    # an encrypted block, unknown keywords
    "qd-cae__qd-cae-python/test/keyfile.key":
        (REFUSED, ["keyfile_include2.key:5:1: error: this part of the deck is encrypted and cannot be read",
                   "*ELEMENT_SHELL: not computed here"], None),
    "qd-cae__qd-cae-python/test/keyfile_include1.key": (REFUSED, [NO_END], None),
    "qd-cae__qd-cae-python/test/keyfile_include2.key":
        (REFUSED, ["keyfile_include2.key:5:1: error: this part of the deck is encrypted and cannot be read"], None),
    "qd-cae__qd-cae-python/test/keyfile_include_dir/keyfile_include3.key":
        (REFUSED, ["keyfile_include3.key:4:1: error: unknown keyword '*BLABLA'"], 1),
}


class RealDecks(Case):
    def test_every_deck_is_listed(self):
        found = {str(p.relative_to(DECKS)) for p in DECKS.rglob("*") if p.suffix in (".k", ".key", ".dyn")}
        self.assertEqual(found, set(EXPECTED))

    def test_check_says_what_is_expected(self):
        for name, (status, texts, errors) in EXPECTED.items():
            with self.subTest(name):
                _, err = self.cleave("check", DECKS / name, status=status)
                for text in texts:
                    self.assertIn(text, err)
                if errors is not None:
                    self.assertEqual(err.count(" error: ") + err.startswith("error: ") + err.count("\nerror: "), errors)

    def test_a_search_path_finds_the_include(self):
        folder = DECKS / PYDYNA / "keywords/expand_test"
        _, err = self.cleave("check", folder / "bird_B.k", "-I", folder / "fol", status=REFUSED)
        self.assertNotIn("is not found", err)

    def test_a_body_at_rest_stays_at_rest(self):
        self.cleave("run", DECKS / "cxh-1123__LS-DYNA-ablation/test.k", "-q", "-o", "rest")
        history = rows(self.folder / "rest/glstat.csv")
        self.assertGreater(len(history), 1)
        for row in history:
            for name in ("kinetic_energy", "internal_energy", "external_work", "total_energy"):
                self.assertEqual(row[name], 0.0)


class RoundTrip(Case):
    """`cleave convert` writes a deck that is the same model: it is written the same again and runs to the same bits."""

    def both_ways(self, deck, *options, cycles=20):
        self.cleave("convert", deck, "-o", "once.k", *options)
        self.cleave("convert", "once.k", "-o", "twice.k")
        self.assertEqual((self.folder / "once.k").read_bytes(), (self.folder / "twice.k").read_bytes())
        for name, source, more in (("original", deck, options), ("converted", "once.k", ())):
            self.cleave("run", source, "-o", name, "-q", "-j", 2, "--stop-at-cycle", cycles, *more)
        names = sorted(p.name for p in (self.folder / "original").glob("*.csv"))
        self.assertTrue(names)
        self.assertEqual(names, sorted(p.name for p in (self.folder / "converted").glob("*.csv")))
        names += sorted(f"result/{p.name}" for p in (self.folder / "original/result").glob("*.vtu"))
        for name in names:
            same = (self.folder / "original" / name).read_bytes() == (self.folder / "converted" / name).read_bytes()
            self.assertTrue(same, f"{deck}: {name} differs after conversion")

    def test_every_deck_that_builds(self):
        decks = [DECKS / name for name, (status, _, _) in EXPECTED.items() if status == ACCEPTED]
        decks += sorted((ROOT / "examples").glob("*/*.k"))
        decks += [p for kind in ("verification", "validation", "regression")
                  for p in sorted((ROOT / "tests" / kind).glob("*.k")) if "$@ expect-fail" not in p.read_text("latin-1")]
        self.assertGreater(len(decks), 10)
        for deck in decks:
            with self.subTest(deck.name):
                self.both_ways(deck, *(["--allow-unsupported"] if "--allow-unsupported" in deck.read_text("latin-1") else []))


if __name__ == "__main__":
    unittest.main()
