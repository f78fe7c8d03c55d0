"""The Python module: the same bits as the command line, views without copies, exact resets."""
import json
import math
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy
import ripstop

root = pathlib.Path(__file__).resolve().parents[2]
scenes = root / "scenes"
cli = os.environ["RIPSTOP_CLI"]


def told(*arguments):
    return json.loads(subprocess.run([cli, *map(str, arguments)], check=True, text=True,
                                     stdout=subprocess.PIPE).stdout)


def sample(name):
    return ripstop.Scene.load(str(scenes / f"{name}.ripstop.json"))


class Scenes(unittest.TestCase):
    def test_values_by_path(self):
        scene = sample("kite_in_gusts")
        self.assertEqual(scene["settings.gravity"], (0.0, -9.80665, 0.0))
        scene["line.axialStiffness"] = 7000
        self.assertEqual(scene["line.axialStiffness"], 7000.0)
        scene["settings.gravity"] = (0, -1.62, 0)
        self.assertEqual(scene["settings.gravity"][1], -1.62)
        copy = ripstop.Scene(scene)
        copy["line.axialStiffness"] = 1.0
        self.assertEqual(scene["line.axialStiffness"], 7000.0)

    def test_built_is_what_the_command_line_builds(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "k.ripstop.json"
            subprocess.run([cli, "build", "delta_kite", "span=2.8", "cloth=ripstop_050", "-o", file],
                           check=True)
            ours = pathlib.Path(folder) / "ours.ripstop.json"
            ripstop.Scene.build("delta_kite", span=2.8, cloth="ripstop_050").save(str(ours))
            self.assertEqual(ours.read_bytes(), file.read_bytes())

    def test_what_is_wrong_is_said(self):
        scene = sample("pendulum")
        for wrong, words in [(lambda: scene["settings.gravty"], "gravity"),
                             (lambda: scene.__setitem__("settings.timeStep", -1), "timeStep"),
                             (lambda: ripstop.Scene.build("delta_kit"), "delta_kite"),
                             (lambda: ripstop.Scene.build("delta_kite", spam=1), "spam"),
                             (lambda: ripstop.Scene.load("none.json"), "none.json")]:
            with self.assertRaises(ripstop.Error) as caught:
                wrong()
            self.assertIn(words, str(caught.exception))


class Simulations(unittest.TestCase):
    def test_hash_is_that_of_the_command_line(self):
        for name in ("pendulum", "kite_in_gusts", "parachute"):
            run = ripstop.Simulation(sample(name))
            run.run_until(0.5)
            self.assertEqual(run.hash, told("run", scenes / f"{name}.ripstop.json", "--seconds",
                                            "0.5", "--json")["hash"])

    # The period of a pendulum of 1 m at small swings is 2 pi sqrt(l / g).
    def test_pendulum(self):
        scene = ripstop.Scene.build("rope", segments=1, length=1.0, density=0, end_mass=1, angle=3)
        scene["settings.airDensity"] = 0
        run = ripstop.Simulation(scene)
        crossings, before = [], None
        while run.time < 5.0:
            run.step()
            x = run.positions[-1, :]
            side = x[0] if abs(x[0]) > 1e-12 else x[2]
            if before is not None and (side > 0) != (before > 0):
                crossings.append(run.time)
            before = side
        half = numpy.diff(crossings).mean()
        self.assertAlmostEqual(2 * half, 2 * math.pi * math.sqrt(1 / 9.80665), delta=0.01)

    def test_views_are_of_one_instant_and_cannot_be_written(self):
        run = ripstop.Simulation(sample("pendulum"))
        before = run.positions
        kept = before.copy()
        with self.assertRaises(ValueError):
            before[0, 0] = 1.0
        self.assertFalse(before.flags.owndata)
        run.step(50)
        self.assertTrue((before == kept).all())
        self.assertFalse((run.positions == kept).all())
        del run
        self.assertTrue((before == kept).all())

    def test_checkpoints_are_exact(self):
        run = ripstop.Simulation(sample("kite_in_gusts"))
        run.step(100)
        start, hash_then = run.checkpoint(), run.hash
        run.step(200)
        end = run.hash
        run.restore(start)
        self.assertEqual(run.hash, hash_then)
        run.step(200)
        self.assertEqual(run.hash, end)

    def test_rollout_is_many_simulations(self):
        scene = sample("kite_in_gusts")
        rng = numpy.random.default_rng(1)
        commands = rng.uniform(-0.2, 0.2, (4, 5, 1))
        read = ripstop.rollout(scene, ["hand"], commands, steps=20, jobs=2)
        self.assertEqual(read.shape[:2], (4, 5))
        for i in range(4):
            run = ripstop.Simulation(scene)
            for row in range(5):
                run.command("hand", commands[i, row, 0])
                run.step(20)
                self.assertEqual(list(read[i, row]), list(run.probes.values()))
        with self.assertRaises(ripstop.Error):
            ripstop.rollout(scene, ["hand"], commands[:, :, 0:0], steps=20)

    def test_environment_resets_exactly(self):
        env = ripstop.Environment(sample("kite_in_gusts"), ["hand"], ["line angle", "line tension"],
                                  seconds=1.0, low=-0.5, high=0.5,
                                  reward=lambda probes: probes["line angle"])

        def episode():
            seen = [env.reset()[0]]
            for i in range(20):
                observation, reward, terminated, truncated, _ = env.step([0.02 * i])
                seen.append(observation)
                self.assertEqual(reward, observation[0])
                if terminated or truncated:
                    break
            return seen
        first = episode()
        self.assertGreater(len(first), 5)
        self.assertEqual(episode(), first)


class Files(unittest.TestCase):
    def test_recording(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "a.ripstop-run"
            told("run", scenes / "pendulum.ripstop.json", "--seconds", "0.5", "--record", file,
                 "--json")
            recording = ripstop.Recording.load(str(file))
            self.assertGreater(len(recording), 10)
            run = ripstop.Simulation(recording.scene)
            run.run_until(recording.time(len(recording) - 1))
            apart = abs(run.positions - recording.positions(len(recording) - 1)).max()
            self.assertLess(apart, 1e-5)  # m; frames are kept with single precision

    def test_study(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "s.ripstop-study.json"
            file.write_text(json.dumps({
                "format": "ripstop-study", "version": 1, "seconds": 0.2,
                "scene": str(scenes / "pendulum.ripstop.json"),
                "variables": [{"name": "mass", "paths": ["#4.mass"], "values": [1, 2, 4]}],
                "measures": [{"probe": "tension", "reduction": "max"}],
                "plan": {"kind": "grid"}}))
            study = ripstop.Study(str(file))
            self.assertEqual(len(study), 3)
            self.assertTrue(numpy.isnan(study.table()["tension max (N)"]).all())
            self.assertEqual(study.run(jobs=2), 3)
            self.assertEqual(study.run(), 0)
            pull = study.table()["tension max (N)"]
            # a pendulum pulls in proportion to its mass
            self.assertAlmostEqual(pull[1] / pull[0], 2.0, delta=0.01)
            self.assertAlmostEqual(pull[2] / pull[0], 4.0, delta=0.02)


if __name__ == "__main__":
    unittest.main()
