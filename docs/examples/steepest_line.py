"""Where does the tow point of a delta have to be for the steepest line at the least pull?

    PYTHONPATH=build/python/python /usr/bin/python3 docs/examples/steepest_line.py
"""
import math

import ripstop


def flown(tow):
    """Line angle, degrees, and pull, N, in the last two of 20 s."""
    run = ripstop.Simulation(ripstop.Scene.build("delta_kite", tow=tow))
    angles, pulls = [], []
    while run.time < 20.0:
        run.step(24)
        if run.time > 18.0:
            angles.append(run.probes["line angle"])
            pulls.append(run.probes["line tension"])
    return sum(angles) / len(angles), sum(pulls) / len(pulls)


def cost(tow):
    angle, pull = flown(tow)
    print(f"tow {tow:.4f}: {angle:6.2f} degrees, {pull:6.2f} N")
    return -angle + 0.5 * pull  # a newton is worth half a degree


def golden(function, low, high, tolerance):
    ratio = (math.sqrt(5.0) - 1.0) / 2.0
    a, b = high - ratio * (high - low), low + ratio * (high - low)
    at_a, at_b = function(a), function(b)
    while high - low > tolerance:
        if at_a < at_b:
            high, b, at_b = b, a, at_a
            a = high - ratio * (high - low)
            at_a = function(a)
        else:
            low, a, at_a = a, b, at_b
            b = low + ratio * (high - low)
            at_b = function(b)
    return (low + high) / 2.0


if __name__ == "__main__":
    best = golden(cost, 0.45, 0.75, 0.005)
    print(f"the best tow point is at {best:.3f} of the chord")
