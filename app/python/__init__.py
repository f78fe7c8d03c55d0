"""Ripstop without a window: fabric that flies, from Python.

    import ripstop
    scene = ripstop.Scene.build("delta_kite", span=2.8)
    run = ripstop.Simulation(scene)
    run.run_until(10.0)
    print(run.probes["line angle"], run.positions.shape, run.hash)
"""
from ._engine import (Checkpoint, Error, Recording, Scene, Simulation, Study, __version__, rollout)

__all__ = ["Checkpoint", "Environment", "Error", "Recording", "Scene", "Simulation", "Study",
           "__version__", "rollout"]


class Environment:
    """A simulation in the shape that reinforcement learning knows.

    An action is one number for each of `controls`, between `low` and `high` (m or rad); an
    observation is one number for each of `probes`. `reset()` returns to the same bits each time.

        env = Environment(scene, controls=["hand"], probes=["line angle"], steps=24, seconds=20)
        observation, info = env.reset()
        observation, reward, terminated, truncated, info = env.step([0.5])

    `reward` is a function of the dictionary of all probes; without one each step is worth 0. An
    episode is terminated when something tears or the simulation cannot go on, and truncated after
    `seconds`.
    """

    def __init__(self, scene, controls, probes, steps=24, seconds=30.0, low=-1.0, high=1.0,
                 reward=None):
        self.controls, self.probes = list(controls), list(probes)
        self.steps, self.seconds = steps, seconds
        self.action_space = {"shape": (len(self.controls),), "low": low, "high": high}
        self.observation_space = {"shape": (len(self.probes),), "names": self.probes}
        self._reward = reward or (lambda probes: 0.0)
        self._run = Simulation(scene)
        self._start = self._run.checkpoint()
        missing = [name for name in self.probes if name not in self._run.probes]
        if missing:
            raise Error(f"The scene has no probe {missing[0]!r}; it has: "
                        + ", ".join(self._run.probes))

    def reset(self, seed=None):
        """Back to the start. The seeds of gusts are properties of the scene; `seed` is not used."""
        self._run.restore(self._start)
        return self._observe(), {"time": self._run.time}

    def step(self, action):
        space = self.action_space
        if len(action) != len(self.controls):
            raise Error(f"An action has {len(self.controls)} numbers, not {len(action)}.")
        for name, value in zip(self.controls, action):
            self._run.command(name, min(space["high"], max(space["low"], float(value))))
        terminated, info = False, {}
        try:
            self._run.step(self.steps)
        except Error as stopped:
            terminated, info["stopped"] = True, str(stopped)
        info["time"] = self._run.time
        terminated = terminated or self._run.tears > 0
        return (self._observe(), self._reward(self._run.probes), terminated,
                self._run.time >= self.seconds, info)

    def _observe(self):
        values = self._run.probes
        return [values[name] for name in self.probes]
