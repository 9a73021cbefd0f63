"""The Python module, against closed forms: one argon atom has a radius of 1.88 A, the probe 1.4 A."""

import ast
import pathlib
import subprocess
import sys
import threading
import unittest

import moltact
import numpy as np

SOURCE = pathlib.Path(__file__).resolve().parents[2]
CONTACT_A = 1.88 + 1.4


def argon():
    return moltact.load(SOURCE / "molecules" / "argon.pdb")


class Molecules(unittest.TestCase):
    def test_a_molecule_of_a_file_has_its_atoms_as_arrays_of_one_row_each(self):
        molecule = moltact.load(SOURCE / "molecules" / "1ubq.pdb")
        self.assertEqual((len(molecule), molecule.id), (602, "1UBQ"))
        self.assertEqual(molecule.spheres.shape, (602, 4))
        np.testing.assert_array_equal(molecule.spheres[:, :3], molecule.positions)
        np.testing.assert_array_equal(molecule.spheres[:, 3], molecule.radii)
        self.assertEqual((molecule.elements[0], molecule.names[1], molecule.residues[0]), ("N", "CA", "MET"))
        self.assertEqual((molecule.atomic_numbers[0], molecule.residue_numbers[-1]), (7, 76))
        self.assertEqual(molecule.describe(-1), molecule.describe(601))
        self.assertGreater(len(moltact.load(SOURCE / "molecules" / "1ubq.pdb", waters=True)), 602)

    def test_the_table_of_radii_gives_carbon_1_70_or_1_77_angstrom(self):
        self.assertEqual(moltact.radius_tables()[0], "bondi")
        for table, carbon in (("bondi", 1.70), ("alvarez", 1.77)):
            molecule = moltact.load(SOURCE / "molecules" / "1ubq.pdb", radii=table)
            self.assertEqual(molecule.radii[molecule.elements.index("C")], carbon)
        with self.assertRaisesRegex(ValueError, "radii must be"):
            moltact.load(SOURCE / "molecules" / "argon.pdb", radii="none")

    def test_a_file_that_is_absent_or_of_no_format_raises_with_its_name_and_a_remedy(self):
        with self.assertRaisesRegex(moltact.MoleculeError, "absent.pdb: there is no such file; check the name"):
            moltact.load("absent.pdb")
        with self.assertRaisesRegex(ValueError, "README.md"):
            moltact.load(SOURCE / "README.md")
        with self.assertRaisesRegex(ValueError, "model must be"):
            moltact.load(SOURCE / "molecules" / "argon.pdb", model=0)
        with self.assertRaisesRegex(IndexError, "no atom 1 among 1"):
            argon().describe(1)


class Probes(unittest.TestCase):
    def test_a_probe_on_one_atom_stays_at_the_sum_of_the_radii_and_is_pushed_out_by_its_depth(self):
        hand = np.linspace([0.0, 0.0, 6.0], [0.0, 0.0, 1.0], 101)
        felt = moltact.Tracker(argon(), stiffness_N_per_A=2.0).feel(hand)
        depth = np.maximum(0.0, CONTACT_A - hand[:, 2])
        self.assertEqual(len(felt), 101)
        np.testing.assert_array_equal(felt.touching, depth > 0.0)
        np.testing.assert_allclose(felt.positions[:, 2], np.maximum(hand[:, 2], CONTACT_A), atol=1e-12)
        np.testing.assert_allclose(felt.forces, np.outer(2.0 * depth, [0.0, 0.0, 1.0]), atol=1e-12)
        np.testing.assert_allclose(felt.energies, depth**2, atol=1e-12)
        np.testing.assert_array_equal(felt.contacts[:, 0], np.where(felt.touching, 0, -1))
        self.assertTrue((felt.contacts[:, 1:] == -1).all() and (felt.torques == 0.0).all() and felt.at_rest.all())

    def test_every_method_feels_a_path_over_a_protein_and_is_the_same_in_parts_as_in_one(self):
        molecule = moltact.load(SOURCE / "molecules" / "1ubq.pdb")
        middle = molecule.positions.mean(axis=0)
        hand = np.linspace(middle + [40.0, 0.0, 0.0], middle + [8.0, 6.0, 0.0], 400)
        for method in moltact.methods():
            with self.subTest(method):
                whole = moltact.Tracker(molecule, method).feel(hand)
                parts = moltact.Tracker(molecule, method)
                first, second = parts.feel(hand[:150]), parts.feel(hand[150:])
                self.assertGreater(whole.touching.sum(), 20)
                np.testing.assert_array_equal(whole.forces, np.vstack([first.forces, second.forces]))

    def test_a_hand_that_starts_inside_gets_no_force_until_it_has_been_outside_once(self):
        probe = moltact.Tracker(argon())
        inside, outside = [0.0, 0.0, 1.0], [0.0, 0.0, 6.0]
        felt = probe.feel([inside, inside, outside, inside])
        np.testing.assert_array_equal(felt.started_inside, [True, True, False, False])
        np.testing.assert_array_equal(felt.touching, [False, False, False, True])
        probe.reset()
        self.assertTrue(probe.feel([inside]).started_inside[0])

    def test_an_atom_that_is_untouchable_is_not_felt_and_spheres_of_an_array_are(self):
        spheres = [[0.0, 0.0, 0.0, 1.0], [0.0, 0.0, 4.0, 1.0]]
        hand = [[0.0, 0.0, 9.0], [0.0, 0.0, 4.5], [0.0, 0.0, 1.5]]
        felt = moltact.Tracker(spheres, probe_A=1.0, untouchable=[1]).feel(hand)
        np.testing.assert_array_equal(felt.contacts[:, 0], [-1, -1, 0])
        np.testing.assert_allclose(felt.positions[:, 2], [9.0, 4.5, 2.0], atol=1e-12)
        self.assertEqual(moltact.Tracker(spheres, probe_A=1.0, untouchable=[0, 1]).feel(hand).touching.sum(), 0)


class Bodies(unittest.TestCase):
    def test_springs_of_a_body_beside_a_wall_push_and_turn_it_by_the_atom_that_touches(self):
        # Two atoms 6 A apart; the one at x = 3 meets an atom of radius 2 A, the other nothing.
        body = moltact.HeldBody([[3.0, 0.0, 0.0, 2.0]], spheres=[[3.0, 0, 0, 1.0], [-3.0, 0, 0, 1.0]],
                                interaction="springs")
        hand = np.linspace([0.0, 0.0, 6.0], [0.0, 0.0, 2.5], 36)
        felt = body.feel(hand)
        self.assertEqual((felt.forces.shape, felt.orientations.shape), ((36, 3), (36, 4)))
        np.testing.assert_array_equal(felt.touching, hand[:, 2] < 3.0 - 1e-9)
        np.testing.assert_allclose(felt.forces[-1], [0.0, 0.0, 0.5], atol=1e-9)
        np.testing.assert_allclose(felt.torques[-1], [0.0, -1.5, 0.0], atol=1e-9)
        # Turned by a quarter round x, it touches at the same height.
        turned = np.hstack([hand, np.tile([1.0, 1.0, 0.0, 0.0], (36, 1))])
        body.reset()
        np.testing.assert_allclose(body.feel(turned).forces, felt.forces, atol=1e-9)

    def test_atoms_of_a_molecule_are_held_by_index_and_feel_the_rest_of_it(self):
        molecule = moltact.load(SOURCE / "molecules" / "1hpv.pdb")
        drug = [k for k, residue in enumerate(molecule.residues) if residue == "478"]
        for interaction in moltact.interactions():
            with self.subTest(interaction):
                body = moltact.HeldBody(molecule, drug, interaction=interaction)
                self.assertEqual((body.interaction, body.spheres.shape), (interaction, (35, 4)))
                np.testing.assert_allclose(body.middle, molecule.positions[drug].mean(axis=0), atol=1e-9)
                far = body.middle + [80.0, 0.0, 0.0]
                felt = body.feel(np.linspace(far, body.middle + [20.0, 0.0, 0.0], 600))
                self.assertTrue(felt.touching.any())
                self.assertGreater(felt.forces[felt.touching][-1, 0], 0.0)
                self.assertFalse(set(felt.contacts[felt.contacts >= 0]) & set(drug))


class Forces(unittest.TestCase):
    def test_a_charged_probe_is_drawn_to_opposite_charges_and_rests_where_coupling_and_field_are_in_balance(self):
        molecule = moltact.load(SOURCE / "molecules" / "1ubq.pdb")
        carboxylate = molecule.names.index("OE1", molecule.residues.index("GLU"))
        # From outside, along the line from the molecule's middle through the oxygen.
        at = molecule.positions[carboxylate]
        out = (at - molecule.positions.mean(axis=0)) / np.linalg.norm(at - molecule.positions.mean(axis=0))
        energies = []
        for charge in (1.0, -1.0):
            probe = moltact.Tracker(molecule, forces="electrostatic", dielectric="distance", probe_charge_e=charge)
            way = np.linspace(at + 20.0 * out, at + 4.5 * out, 2000)
            felt = probe.feel(np.vstack([way, np.repeat(way[-1:], 500, axis=0)]))
            np.testing.assert_array_equal(felt.van_der_waals, 0.0)
            self.assertEqual(felt.electrostatic[0], 0.0)
            energies.append(felt.electrostatic[-1])
            # The force on the hand is that of the coupling, of the stiffness given.
            np.testing.assert_allclose(felt.forces[-1], felt.positions[-1] - way[-1], atol=1e-9)
        self.assertLess(energies[0], -1.0)
        self.assertGreater(energies[1], 1.0)

    def test_a_weak_gain_of_4_makes_a_pull_of_an_energy_above_a_hundredth_of_a_kcal_4_times_as_strong(self):
        molecule = moltact.load(SOURCE / "molecules" / "1ubq.pdb")
        carboxylate = molecule.names.index("OE1", molecule.residues.index("GLU"))
        at = molecule.positions[carboxylate]
        out = (at - molecule.positions.mean(axis=0)) / np.linalg.norm(at - molecule.positions.mean(axis=0))
        way = np.linspace(at + 20.0 * out, at + 4.5 * out, 4000)
        # A stiff coupling: the atom stays where the hand is.
        arguments = {"forces": "electrostatic", "dielectric": "distance", "probe_charge_e": 1.0, "coupling_N_per_mm": 1.0}
        usual, strong = (moltact.Tracker(molecule, **arguments, weak_gain=gain).feel(way) for gain in (1.0, 4.0))
        weak = (usual.electrostatic < -0.001) & (usual.electrostatic > -0.01)
        self.assertGreater(weak.sum(), 10)
        ratio = np.linalg.norm(strong.forces[weak], axis=1) / np.linalg.norm(usual.forces[weak], axis=1)
        np.testing.assert_allclose(ratio, 4.0, rtol=0.01)
        # The energy is that of the atoms, without the gain, at nearly the same place.
        np.testing.assert_allclose(strong.electrostatic[weak], usual.electrostatic[weak], rtol=0.01)

    def test_without_forces_the_energies_are_0_and_the_answers_are_those_of_contact(self):
        molecule = moltact.load(SOURCE / "molecules" / "1ubq.pdb")
        way = np.linspace([80.0, 30.0, 30.0], molecule.positions.mean(axis=0), 500)
        felt = moltact.Tracker(molecule, forces="none").feel(way)
        np.testing.assert_array_equal(felt.van_der_waals + felt.electrostatic, 0.0)
        np.testing.assert_array_equal(felt.forces, moltact.Tracker(molecule).feel(way).forces)

    def test_invalid_forces_are_refused_with_what_may_be_given(self):
        molecule = moltact.load(SOURCE / "molecules" / "1ubq.pdb")
        for arguments, message in (
            ({"forces": "gravity"}, "'van-der-waals'"),
            ({"forces": "all", "dielectric": "oil"}, "'vacuum'"),
            ({"probe_charge_e": float("nan")}, "-2 to 2"),
            ({"coupling_N_per_mm": -1.0}, "coupling_N_per_mm"),
            ({"weak_gain": 0.5}, "weak_gain must be a number from 1 to 8"),
            ({"weak_gain": float("nan")}, "weak_gain"),
        ):
            with self.subTest(arguments), self.assertRaisesRegex(ValueError, message):
                moltact.Tracker(molecule, **arguments)
        with self.assertRaisesRegex(ValueError, "need a Molecule"):
            moltact.Tracker(molecule.spheres, forces="all")


class Charges(unittest.TestCase):
    def test_the_chemistry_of_a_molecule_has_an_entry_per_atom_and_the_formal_charges_of_ubiquitin_sum_to_0(self):
        molecule = moltact.load(SOURCE / "molecules" / "1ubq.pdb")
        bare, formal = molecule.chemistry(), molecule.chemistry("formal")
        self.assertIsNone(bare.charges_e)
        self.assertEqual((len(bare), bare.types[0], formal.charges_e.shape), (602, "MET N", (602,)))
        np.testing.assert_array_equal(bare.atomic_numbers, molecule.atomic_numbers)
        # 11 Asp and Glu, 11 Lys and Arg.
        self.assertAlmostEqual(float(formal.charges_e.sum()), 0.0, places=5)
        self.assertEqual(float(np.abs(formal.charges_e).sum()), 22.0)

    def test_chemistry_of_arrays_gives_them_back_and_is_accepted_by_a_probe_and_a_body_of_as_many_atoms(self):
        spheres = [[0.0, 0.0, 0.0, 1.5], [0.0, 0.0, 4.0, 1.5]]
        chemistry = moltact.Chemistry([8, 0], charges_e=[-0.5, 0.25])
        self.assertEqual(chemistry.types, ["O", "?"])
        np.testing.assert_array_equal(chemistry.charges_e, [-0.5, 0.25])
        named = moltact.Chemistry(np.array([8, 7]), types=["ASP OD1", "LYS NZ"])
        self.assertEqual(named.types, ["ASP OD1", "LYS NZ"])
        hand = [[0.0, 0.0, 9.0], [0.0, 0.0, 6.0]]
        bare = moltact.Tracker(spheres).feel(hand).forces
        np.testing.assert_array_equal(moltact.Tracker(spheres, chemistry=chemistry).feel(hand).forces, bare)
        self.assertEqual(moltact.HeldBody(spheres, [1], chemistry=named).interaction, moltact.interactions()[0])
        self.assertEqual(moltact.Tracker(spheres).interaction, moltact.interactions(body=False)[0])


class Calls(unittest.TestCase):
    def test_bad_input_raises_with_the_place_and_what_is_wanted(self):
        probe = moltact.Tracker(argon())
        for error, words, call in [
            (ValueError, r"shape \(n, 3\) or \(n, 7\), not \(1, 2\)", lambda: probe.feel([[0.0, 0.0]])),
            (ValueError, r"poses\[1\] is not finite", lambda: probe.feel([[0, 0, 9], [0, np.nan, 0]])),
            (ValueError, r"poses\[0\] is farther than 1e9", lambda: probe.feel([[0, 0, 1e10]])),
            (ValueError, "quaternion of length zero", lambda: probe.feel([[0, 0, 9, 0, 0, 0, 0]])),
            (TypeError, "array of numbers", lambda: probe.feel("nowhere")),
            (ValueError, "no method 'exakt'; choose from 'exact'", lambda: moltact.Tracker(argon(), "exakt")),
            (ValueError, "probe_A must be", lambda: moltact.Tracker(argon(), probe_A=-1.0)),
            (ValueError, "stiffness_N_per_A must be", lambda: moltact.Tracker(argon(), stiffness_N_per_A=0.0)),
            (ValueError, r"spheres\[0\] has a negative radius", lambda: moltact.Tracker([[0, 0, 0, -1]])),
            (ValueError, r"shape \(n, 4\)", lambda: moltact.Tracker([[0, 0, 0]])),
            (IndexError, "no atom 7 among 1", lambda: moltact.HeldBody(argon(), [7])),
            (TypeError, "whole numbers", lambda: moltact.HeldBody(argon(), [0.5])),
            (ValueError, "1 to 5000 atoms", lambda: moltact.HeldBody(argon(), [])),
            (ValueError, "either atoms or spheres", lambda: moltact.HeldBody(argon())),
            (ValueError, r"atomic_numbers must have the shape \(n,\)", lambda: moltact.Chemistry([[6]])),
            (ValueError, r"atomic_numbers\[1\] is not a whole", lambda: moltact.Chemistry([6, 6.5])),
            (ValueError, r"charges_e\[0\] is not a number", lambda: moltact.Chemistry([6], charges_e=[np.inf])),
            (ValueError, "each of the 2 atoms, not 1", lambda: moltact.Chemistry([6, 6], charges_e=[0.0])),
            (ValueError, "each of the 1 atoms, not 2", lambda: moltact.Chemistry([6], types=["C", "C"])),
            (ValueError, "chemistry must have one entry for each of the 1 atoms, not 2",
             lambda: moltact.Tracker(argon(), chemistry=moltact.Chemistry([6, 6]))),
            (ValueError, "no charges; choose 'none'", lambda: argon().chemistry("file")),
            (ValueError, "no source of charges 'am1'; choose from 'none'", lambda: argon().chemistry("am1")),
            (ValueError, "no interaction 'springs'", lambda: moltact.Tracker(argon(), interaction="springs")),
            (ValueError, "no interaction 'probe'", lambda: moltact.HeldBody(argon(), [0], interaction="probe")),
        ]:
            with self.subTest(words), self.assertRaisesRegex(error, words):
                call()
        # Nothing of it moved the probe.
        self.assertFalse(probe.feel([[0.0, 0.0, 6.0]]).started_inside[0])

    def test_threads_feel_at_the_same_time_and_each_what_it_would_alone(self):
        hand = np.linspace([0.0, 0.0, 6.0], [0.0, 0.5, 1.0], 20000)
        alone = moltact.Tracker(argon()).feel(hand).forces
        found = [None] * 4

        def work(k):
            found[k] = moltact.Tracker(argon()).feel(hand).forces

        threads = [threading.Thread(target=work, args=(k,)) for k in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for forces in found:
            np.testing.assert_array_equal(forces, alone)


class Documents(unittest.TestCase):
    def test_the_stubs_list_what_the_module_offers_and_everything_has_a_docstring(self):
        stubs = ast.parse((pathlib.Path(moltact.__file__).parent / "__init__.pyi").read_text())
        typed = {node.name: node for node in stubs.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
        self.assertEqual(set(typed) - {"_Feeler"}, set(moltact.__all__))
        for name in moltact.__all__:
            self.assertTrue(getattr(moltact, name).__doc__, name)
        for name in ("Chemistry", "Molecule", "Felt", "Tracker", "HeldBody"):
            offered = {k for k, value in vars(getattr(moltact, name)).items() if not k.startswith("_")}
            stubbed = {node.name for node in typed[name].body if isinstance(node, ast.FunctionDef)}
            self.assertEqual({k for k in stubbed if not k.startswith("_")}, offered, name)
            for member in offered:
                self.assertTrue(getattr(moltact, name).__dict__[member].__doc__, f"{name}.{member}")

    def test_the_example_runs_and_finds_the_grooves_of_dna(self):
        try:
            import matplotlib  # noqa: F401
        except ImportError:
            self.skipTest("matplotlib is not installed (Debian: python3-matplotlib)")
        example = SOURCE / "docs" / "samples" / "feel_a_groove.py"
        run = subprocess.run([sys.executable, example, "--save", ""], capture_output=True, text=True, check=True)
        minor, major = (float(line.split()[-2]) for line in run.stdout.splitlines()[-2:])
        self.assertLess(minor, major)


if __name__ == "__main__":
    unittest.main(verbosity=1)
