"""What `cmake --install` puts into a virtual environment is found by its Python."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import venv

build = pathlib.Path(os.environ["RIPSTOP_CLI"]).parents[1]


class Installed(unittest.TestCase):
    def test_a_virtual_environment_finds_it(self):
        with tempfile.TemporaryDirectory() as place:
            venv.create(place, system_site_packages=True, symlinks=True)  # numpy is Debian's
            surroundings = {name: value for name, value in os.environ.items()
                            if name != "PYTHONPATH"}
            surroundings["VIRTUAL_ENV"] = place
            subprocess.run(["cmake", "--install", build, "--component", "python"], check=True,
                           env=surroundings, stdout=subprocess.DEVNULL)
            python = pathlib.Path(place, "bin", pathlib.Path(sys.executable).name)
            told = subprocess.run(
                [python, "-c", "import ripstop; print(ripstop.__file__);"
                 " print(ripstop.Simulation(ripstop.Scene.build('delta_kite')).hash)"],
                check=True, text=True, cwd="/", env=surroundings, stdout=subprocess.PIPE).stdout
            self.assertTrue(told.startswith(os.path.realpath(place)) or told.startswith(place))
            self.assertEqual(len(told.split()), 2)


if __name__ == "__main__":
    unittest.main()
