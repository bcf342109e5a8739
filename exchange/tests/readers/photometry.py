"""Prints what other readers (pip install photompy==0.3.1 eulumdat-py==1.0.0) find in photometric files:
the name, the full angles in degrees of 50 % and 10 % of the largest intensity, and that in candela."""

import sys
from pathlib import Path

from photompy import IESFile
from pyldt import LdtReader


def read(path):
    # Vertical angles in degrees, planes, and the factor that makes these candela.
    if path.suffix == ".ies":
        file = IESFile.read(path)
        return file.photometry.thetas, file.photometry.values, file.header.ballast_factor
    file = LdtReader.read(path)
    factor = file.header.conv_factor * file.header.lamp_flux[0] / 1000
    return file.header.g_angles, file.intensities, factor


for path in map(Path, sys.argv[1:]):
    angles, planes, factor = read(path)
    curve = [(angle, factor * sum(plane) / len(plane)) for angle, plane in zip(angles, zip(*planes))]
    peak = max(candela for _, candela in curve)
    shown = [path.name]
    for level in (peak / 2, peak / 10):
        crossed = [(a, x, b, y) for (a, x), (b, y) in zip(curve, curve[1:]) if x >= level > y]
        a, x, b, y = crossed[-1] if crossed else (angles[-1], 1, angles[-1], 0)
        shown.append(f"{2 * (a + (b - a) * (x - level) / (x - y)):.4f}")
    print(*shown, f"{peak:.4f}")
